//! What is salient: the response of each pixel of a level, normalised so that levels compare.

use super::blur::LANES;
use crate::math::Lanes;

/// Writes the determinants of the Hessian of one row of a level, times `sigma`⁴, in grey²: `out[x]` is that of column x + 1.
///
/// The second derivatives are differences of neighbouring pixels in the row, that above and that below.
///
/// # Source
/// Lindeberg 1998, Feature detection with automatic scale selection, section 5.
pub(super) fn determinants([above, here, below]: [&[f32]; 3], sigma: f64, out: &mut [f32]) {
    let variance = sigma * sigma;
    let (pure, mixed) = (Lanes::splat((variance * variance) as f32), Lanes::splat((variance * variance / 16.0) as f32));
    let windows = |row| <[f32]>::windows(row, LANES + 2).step_by(LANES);
    let rows = windows(above).zip(windows(here)).zip(windows(below));
    for (out, ((a, h), b)) in out.chunks_exact_mut(LANES).zip(rows) {
        let centre = Lanes::load(&h[1..]);
        let twice = centre + centre;
        let xx = Lanes::load(h) + Lanes::load(&h[2..]) - twice;
        let yy = Lanes::load(&a[1..]) + Lanes::load(&b[1..]) - twice;
        // That of the four corners is 4 times the mixed derivative.
        let xy = Lanes::load(a) + Lanes::load(&b[2..]) - (Lanes::load(&a[2..]) + Lanes::load(b));
        (xx * yy * pure - xy * xy * mixed).store(out);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test;

    /// Natively this looks at the plain version, as WebAssembly at that of SIMD: both are the definition, bit by bit.
    #[cfg_attr(target_arch = "wasm32", wasm_bindgen_test)]
    #[cfg_attr(not(target_arch = "wasm32"), test)]
    fn agree_with_the_definition() {
        let value = |k: usize| ((k * k * 7 + k * 13) % 251) as f32 / 3.0;
        let rows: [Vec<f32>; 3] = std::array::from_fn(|r| (0..26).map(|x| value(x + 40 * r)).collect());
        let [a, h, b] = &rows;
        let mut out = [0.0; 24];
        determinants([a, h, b], 1.5, &mut out);
        for (x, found) in out.iter().enumerate() {
            let xx = h[x] + h[x + 2] - (h[x + 1] + h[x + 1]);
            let yy = a[x + 1] + b[x + 1] - (h[x + 1] + h[x + 1]);
            let xy = a[x] + b[x + 2] - (a[x + 2] + b[x]);
            let expected = xx * yy * 5.0625 - xy * xy * (5.0625 / 16.0);
            assert_eq!(found.to_bits(), expected.to_bits(), "column {}", x + 1);
        }
    }
}
