//! The significance by which one observation is tested.

/// ω φ κ by bz.
const UNKNOWNS: usize = 5;

/// With fewer degrees of freedom the loss of a good observation takes nearly all of v'Pv with it: 95 % at least with five, 85 % with seven, 72 % with
/// ten, at a significance of 0.001.
const ENOUGH_FREEDOM: usize = 8;

/// The significance of the test of one observation by a σ that it takes part in estimating, in an adjustment of so many degrees of freedom: α₀; of
/// few, α₀ by the number of tests, so that no more than the share α₀ of clean adjustments loses an observation. What is left of v'Pv then says
/// little of σ, and standard errors would be several times too small: a mistake costs more than an error that is not found, which σ₀ shows.
///
/// # Source
/// Bonferroni's bound, as Pope 1976 (The statistics of residuals and the detection of outliers) takes all residuals of an adjustment as one test.
pub(super) fn significance_of_test(alpha0: f64, freedom: usize) -> f64 {
    if freedom < ENOUGH_FREEDOM { alpha0 / (freedom + UNKNOWNS) as f64 } else { alpha0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::tau_limit;

    #[test]
    fn few_tests_share_a_significance_and_many_do_not() {
        assert_eq!(significance_of_test(0.001, 8), 0.001);
        assert_eq!(significance_of_test(0.001, 5), 0.0001);
        // The largest share of v'Pv that a good observation keeps.
        let share = |freedom: usize| tau_limit(0.001, freedom).powi(2) / freedom as f64;
        for (freedom, wanted) in [(5, 0.95), (7, 0.85), (10, 0.72)] {
            assert!((share(freedom) - wanted).abs() < 0.01, "{freedom}: {}", share(freedom));
        }
    }
}
