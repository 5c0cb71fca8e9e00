//! The inner products with WebAssembly's SIMD: several windows at once, so that a part of the template is loaded once for all of them.

use super::LANES;
use std::arch::wasm32::*;

/// Most windows at once: with more of them, engines keep sums in memory instead of in registers.
const MOST: usize = 8;

/// As [`super::products`], which has looked at the lengths.
pub(super) fn products(template: &[i16], strip: &[i16], step: usize, out: &mut [i32]) {
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
    let mut sums = [i32x4_splat(0); N];
    let (mut a, mut b) = (template.as_ptr(), strip.as_ptr());
    for _ in 0..template.len() / LANES {
        // SAFETY: the assertion holds for every whole LANES values of each of the N windows; the loads need no alignment.
        unsafe {
            let part = v128_load(a.cast());
            for (k, sum) in sums.iter_mut().enumerate() {
                *sum = i32x4_add(*sum, i32x4_dot_i16x8(v128_load(b.add(k * step).cast()), part));
            }
            (a, b) = (a.add(LANES), b.add(LANES));
        }
    }
    for (four, out) in sums.chunks(4).zip(out.chunks_mut(4)) {
        let total = lanes(lane_sums(std::array::from_fn(|k| four.get(k).copied().unwrap_or(i32x4_splat(0)))));
        out.copy_from_slice(&total[..four.len()]);
    }
}

/// The sum of the lanes of each vector, as the lanes of one.
fn lane_sums([a, b, c, d]: [v128; 4]) -> v128 {
    let pairs = |a, b| i32x4_add(i32x4_shuffle::<0, 4, 1, 5>(a, b), i32x4_shuffle::<2, 6, 3, 7>(a, b));
    let (ab, cd) = (pairs(a, b), pairs(c, d));
    i32x4_add(i32x4_shuffle::<0, 1, 4, 5>(ab, cd), i32x4_shuffle::<2, 3, 6, 7>(ab, cd))
}

fn lanes(v: v128) -> [i32; 4] {
    [i32x4_extract_lane::<0>(v), i32x4_extract_lane::<1>(v), i32x4_extract_lane::<2>(v), i32x4_extract_lane::<3>(v)]
}
