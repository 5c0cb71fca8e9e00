//! Order statistics, and the scale of normal errors from their median.

/// The `rank`-th smallest value (0 is the smallest); reorders `values`, which must hold more than `rank` of them.
pub(crate) fn smallest(values: &mut [f64], rank: usize) -> f64 {
    *values.select_nth_unstable_by(rank, f64::total_cmp).1
}

/// The median; the mean of the middle two where the number is even. `None` where there are none. Reorders `values`.
pub(crate) fn median(values: &mut [f64]) -> Option<f64> {
    if values.is_empty() {
        return None;
    }
    let half = values.len() / 2;
    let upper = smallest(values, half);
    if values.len() % 2 == 1 {
        return Some(upper);
    }
    let lower = values[..half].iter().copied().fold(f64::NEG_INFINITY, f64::max);
    Some(0.5 * (lower + upper))
}

/// The median magnitude of normal errors of standard deviation 1 of which those beyond `limit` were taken away.
///
/// Dividing a median magnitude by it makes the scale of a set that was cut at `limit` times that scale consistent: repeated cutting
/// neither shrinks nor swells a normal sample.
pub(crate) fn mad_within(limit: f64) -> f64 {
    // Half of the probability between -limit and limit: erf(m/√2) = erf(limit/√2) / 2, found by halving.
    let wanted = 0.5 * libm::erf(limit * std::f64::consts::FRAC_1_SQRT_2);
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if libm::erf(middle * std::f64::consts::FRAC_1_SQRT_2) < wanted {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn medians_of_odd_and_even_numbers() {
        assert_eq!(median(&mut []), None);
        assert_eq!(median(&mut [3.0, 1.0, 2.0]), Some(2.0));
        assert_eq!(median(&mut [4.0, 1.0, 3.0, 2.0]), Some(2.5));
        assert_eq!(smallest(&mut [4.0, 1.0, 3.0, 2.0], 1), 2.0);
    }

    #[test]
    fn uncut_errors_have_the_usual_median_magnitude() {
        assert!((mad_within(10.0) - 0.674_489_750_196).abs() < 1e-10);
        // Between -2 and 2 lie 95.45 %, half of them between -0.6390 and 0.6390.
        assert!((mad_within(2.0) - 0.6390).abs() < 2e-3);
    }
}
