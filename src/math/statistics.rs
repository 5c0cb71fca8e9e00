//! Order statistics.

/// The median length of a two-dimensional normal error, in standard errors of a coordinate: √(2 ln 2).
pub(crate) const MEDIAN_LENGTH: f64 = 1.177_41;

/// The median absolute value of a standard normal variable.
const NORMAL_MEDIAN: f64 = 0.6745;

/// The standard error of a median of many normal variables, in that of their mean.
pub(crate) const MEDIAN_BY_MEAN: f64 = 1.2533;

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

/// The standard deviation of normal errors of these sizes, by their median, which a few gross ones hardly change. `None` where there are none. Reorders
/// `sizes`.
pub(crate) fn scatter(sizes: &mut [f64]) -> Option<f64> {
    median(sizes).map(|middle| middle / NORMAL_MEDIAN)
}

/// The median of values that count by their weights: half of the weight lies at or below it. `None` without any weight. Reorders `values`,
/// which are pairs of value and weight.
pub(crate) fn weighted_median(values: &mut [(f64, f64)]) -> Option<f64> {
    values.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let half = 0.5 * values.iter().map(|(_, weight)| weight).sum::<f64>();
    let mut below = 0.0;
    values
        .iter()
        .find(|(_, weight)| {
            below += weight;
            *weight > 0.0 && below >= half
        })
        .map(|(value, _)| *value)
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
    fn weights_move_the_median() {
        assert_eq!(weighted_median(&mut []), None);
        assert_eq!(weighted_median(&mut [(1.0, 0.0), (2.0, 0.0)]), None);
        assert_eq!(weighted_median(&mut [(3.0, 1.0), (1.0, 1.0), (2.0, 1.0)]), Some(2.0));
        assert_eq!(weighted_median(&mut [(5.0, 0.6), (0.1, 0.0), (0.2, 1e-6), (6.0, 0.5), (4.0, 0.4)]), Some(5.0));
    }
}
