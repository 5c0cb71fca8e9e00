//! Inner products of one template with many windows that lie in one strip, exact in whole numbers.

#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
#[path = "products_simd.rs"]
mod simd;

/// Templates are a whole number of times so long, filled up with zeros.
pub(super) const LANES: usize = 8;

/// `out[k]` becomes Σ template[i] · strip[k · step + i]: the windows follow each other at a distance of `step` values.
///
/// `template` is a multiple of [`LANES`] long. Values are grey values, 0..255, so that the sum over 63 x 63 of them fits 32 bits.
///
/// # Panics
/// Where the strip ends before the last window does.
pub(super) fn products(template: &[i16], strip: &[i16], step: usize, out: &mut [i32]) {
    assert!(template.len().is_multiple_of(LANES) && out.len().saturating_sub(1) * step + template.len() <= strip.len());
    #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
    simd::products(template, strip, step, out);
    #[cfg(not(all(target_arch = "wasm32", target_feature = "simd128")))]
    plain(template, strip, step, out);
}

/// What [`products`] is, one window after the other.
#[cfg_attr(all(target_arch = "wasm32", target_feature = "simd128"), cfg(test))]
fn plain(template: &[i16], strip: &[i16], step: usize, out: &mut [i32]) {
    for (k, sum) in out.iter_mut().enumerate() {
        let window = &strip[k * step..][..template.len()];
        *sum = template.iter().zip(window).map(|(a, b)| i32::from(*a) * i32::from(*b)).sum();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test;

    /// Natively this looks at the plain version, as WebAssembly at that of SIMD.
    #[cfg_attr(target_arch = "wasm32", wasm_bindgen_test)]
    #[cfg_attr(not(target_arch = "wasm32"), test)]
    fn agree_with_the_definition() {
        // The brightest template of the widest window comes nearest to an overflow.
        for (length, step, brightest) in [(16, 3, false), (448, 21, false), (3976, 63, true)] {
            let value = |k: usize| if brightest { 255 } else { ((k * k * 7 + k * 13) % 256) as i16 };
            let template: Vec<i16> = (0..length).map(value).collect();
            let strip: Vec<i16> = (0..length + 40 * step).map(|k| value(k + 5)).collect();
            for number in 0..=41 {
                let expected: Vec<i64> =
                    (0..number).map(|k| (0..length).map(|i| i64::from(template[i]) * i64::from(strip[k * step + i])).sum()).collect();
                let mut out = vec![-1; number];
                products(&template, &strip, step, &mut out);
                assert!(out.iter().map(|v| i64::from(*v)).eq(expected.iter().copied()), "{number} windows, {length} values");
                plain(&template, &strip, step, &mut out);
                assert!(out.iter().map(|v| i64::from(*v)).eq(expected), "{number} windows, {length} values, plain");
            }
        }
    }

    #[test]
    #[should_panic]
    fn a_strip_that_is_too_short_is_not_read() {
        products(&[1; 8], &[1; 10], 3, &mut [0; 2]);
    }
}
