//! How many simulations a statistic takes, and how many cases of a kind: the tests take a fixed sample, `npm run bench -- calibration` takes them all.

use std::ops::Range;

/// The tests take one simulation in so many.
const EVERY: u64 = 6;

fn is_full() -> bool {
    std::env::var("TIEPOINT_STATISTICS").is_ok_and(|value| value == "full")
}

/// How many of `all` simulations are made.
pub fn runs(all: u64) -> u64 {
    if is_full() { all } else { all.div_ceil(EVERY) }
}

/// What a variance of 1 may be found as: `half` to either side by all simulations, as many standard deviations of it by fewer.
pub fn about_one(half: f64) -> Range<f64> {
    about(1.0, half, if is_full() { 1.0 } else { EVERY as f64 })
}

/// What a mean may be found as: `half` to either side by all simulations, as many standard deviations of it by one in so many.
pub fn about(mean: f64, half: f64, one_in: f64) -> Range<f64> {
    let half = half * one_in.sqrt();
    mean - half..mean + half
}

/// Of cases of one kind, the most telling first, the tests take so many.
pub fn cases<T>(all: &[T], few: usize) -> &[T] {
    if is_full() { all } else { &all[..few] }
}
