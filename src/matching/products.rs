//! Inner products of one template with many windows that lie in one strip, exact in whole numbers.

use crate::math::{Pairs, Whole};

/// Templates are a whole number of times so long, filled up with zeros.
pub(super) const LANES: usize = 8;

/// Most windows at once, so that a part of the template is loaded once for all of them: with more, engines keep sums in memory instead of in registers.
const MOST: usize = 8;

/// `out[k]` becomes Σ template[i] · strip[k · step + i]: the windows follow each other at a distance of `step` values.
///
/// `template` is a multiple of [`LANES`] long. Values are grey values, 0..255, so that the sum over 63 x 63 of them fits 32 bits.
///
/// # Panics
/// Where the strip ends before the last window does.
pub(super) fn products(template: &[i16], strip: &[i16], step: usize, out: &mut [i32]) {
    assert!(template.len().is_multiple_of(LANES) && out.len().saturating_sub(1) * step + template.len() <= strip.len());
    // Blocks of nearly equal length: the last one then is no remainder of one or two windows.
    let blocks = out.len().div_ceil(MOST);
    let mut start = 0;
    for block in 0..blocks {
        let end = (block + 1) * out.len() / blocks;
        let (strip, sums) = (&strip[start * step..], &mut out[start..end]);
        match sums.len() {
            8 => of_block::<8>(template, strip, step, sums),
            7 => of_block::<7>(template, strip, step, sums),
            6 => of_block::<6>(template, strip, step, sums),
            5 => of_block::<5>(template, strip, step, sums),
            4 => of_block::<4>(template, strip, step, sums),
            3 => of_block::<3>(template, strip, step, sums),
            2 => of_block::<2>(template, strip, step, sums),
            _ => of_block::<1>(template, strip, step, sums),
        }
        start = end;
    }
}

/// The products of `N` windows; `out` is `N` long.
fn of_block<const N: usize>(template: &[i16], strip: &[i16], step: usize, out: &mut [i32]) {
    assert!(template.len() + (N - 1) * step <= strip.len() && out.len() == N);
    let mut sums = [Whole::splat(0); N];
    let mut window = strip.as_ptr();
    for part in template.as_chunks::<LANES>().0 {
        let part = Pairs::load(part);
        for (k, sum) in sums.iter_mut().enumerate() {
            // SAFETY: the assertion holds for every whole LANES values of each of the N windows.
            *sum = *sum + Pairs::load(unsafe { &*window.add(k * step).cast() }).dot(part);
        }
        // SAFETY: no further than to the end of the first window.
        window = unsafe { window.add(LANES) };
    }
    for (four, out) in sums.chunks(4).zip(out.chunks_mut(4)) {
        let total = Whole::lane_sums(std::array::from_fn(|k| four.get(k).copied().unwrap_or(Whole::splat(0)))).to_array();
        out.copy_from_slice(&total[..four.len()]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test;

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
                assert!(out.iter().map(|v| i64::from(*v)).eq(expected), "{number} windows, {length} values");
            }
        }
    }

    #[test]
    #[should_panic]
    fn a_strip_that_is_too_short_is_not_read() {
        products(&[1; 8], &[1; 10], 3, &mut [0; 2]);
    }
}
