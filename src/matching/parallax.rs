//! The rule of y-parallax: neighbouring matches have nearly the same.

use super::neighbours::Neighbours;
use super::{MatchOptions, OffsetField, Rule, Verdict};
use crate::InterestPoint;
use crate::math::median;

/// Times the rule is applied: refusing one blunder uncovers another.
const ROUNDS: usize = 3;
/// Multiple of the scatter of the neighbours that is still accepted.
const SCATTER: f64 = 3.0;
/// The standard deviation of normally distributed values with a median absolute deviation of 1.
const SIGMA_OF_MAD: f64 = 1.4826;

/// Refuses the matches whose y-parallax differs from the median of their nearest matches by more than the tolerance, or 3 times
/// their scatter (1.4826 times the median absolute deviation) where that is larger.
///
/// The parallax is taken against the expected offset, so that a rotation between the images does not count as scatter.
///
/// # Source
/// Zahran 2007, section 4, made definite.
pub(super) fn refuse_by_parallax(left: &[InterestPoint], offset: &OffsetField, verdicts: &mut [Verdict], options: &MatchOptions) {
    let number = options.parallax_neighbours;
    if number == 0 {
        return;
    }
    let (points, pairs): (Vec<usize>, Vec<_>) =
        verdicts.iter().enumerate().filter_map(|(k, v)| v.matched().map(|right| (k, (left[k], right)))).unzip();
    let positions: Vec<[f64; 2]> = pairs.iter().map(|(l, _)| [l.x, l.y]).collect();
    let parallax: Vec<f64> = pairs.iter().map(|(l, [_, y])| y - l.y - offset.at(l.x, l.y)[1]).collect();
    let neighbours = Neighbours::new(&positions);
    let mut nearest: Vec<Vec<usize>> = vec![Vec::new(); points.len()];
    let mut stands = vec![true; points.len()];
    for round in 0..ROUNDS {
        // What lost no neighbour since the last round would be judged as before.
        let lost_some = |k: usize| round == 0 || nearest[k].iter().any(|n| !stands[*n]);
        let open: Vec<usize> = (0..points.len()).filter(|k| stands[*k] && lost_some(*k)).collect();
        open.iter().for_each(|k| neighbours.nearest(*k, number, |n| stands[n], &mut nearest[*k]));
        let refused: Vec<usize> = open.into_iter().filter(|k| deviates(*k, &nearest[*k], &parallax, options.parallax_tolerance)).collect();
        if refused.is_empty() {
            return;
        }
        for k in refused {
            stands[k] = false;
            verdicts[points[k]].rule = Rule::Parallax;
        }
    }
}

/// Whether a parallax is too far from those of its neighbours; without any it is not.
fn deviates(index: usize, nearest: &[usize], parallax: &[f64], tolerance: f64) -> bool {
    let mut values: Vec<f64> = nearest.iter().map(|n| parallax[*n]).collect();
    let Some(expected) = median(&mut values) else { return false };
    let deviation = (parallax[index] - expected).abs();
    if deviation <= tolerance {
        return false;
    }
    values.iter_mut().for_each(|v| *v = (*v - expected).abs());
    deviation > SCATTER * SIGMA_OF_MAD * median(&mut values).unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid(parallax: impl Fn(usize) -> f64) -> (Vec<InterestPoint>, Vec<Verdict>) {
        let left: Vec<_> = (0..100).map(|k| InterestPoint { x: (k % 10) as f64 * 20.0, y: (k / 10) as f64 * 20.0, value: 1.0 }).collect();
        let position = |(k, p): (usize, &InterestPoint)| [p.x, p.y + parallax(k)];
        let verdict = |at| Verdict { position: Some(at), measure: 1.0, ..Verdict::none(Rule::Matched) };
        let verdicts = left.iter().enumerate().map(position).map(verdict).collect();
        (left, verdicts)
    }

    fn refused(parallax: impl Fn(usize) -> f64, options: &MatchOptions) -> Vec<usize> {
        let (left, mut verdicts) = grid(parallax);
        refuse_by_parallax(&left, &OffsetField::constant(0.0, 0.0), &mut verdicts, options);
        (0..100).filter(|k| verdicts[*k].rule == Rule::Parallax).collect()
    }

    #[test]
    fn only_the_deviating_match_is_refused() {
        let options = MatchOptions::default();
        assert_eq!(refused(|k| if k == 44 { 5.0 } else { 0.0 }, &options), [44]);
        // A trend, as of a rotation, is no deviation.
        assert!(refused(|k| (k % 10) as f64 * 0.3, &options).is_empty());
        // Within the tolerance.
        assert!(refused(|k| if k == 44 { 1.0 } else { 0.0 }, &options).is_empty());
    }

    #[test]
    fn where_the_neighbours_scatter_more_is_accepted() {
        let scattered = |k: usize| if k == 44 { 5.0 } else { ((k * 7919) % 17) as f64 * 0.5 - 4.0 };
        assert!(!refused(scattered, &MatchOptions::default()).contains(&44));
        assert!(refused(|k| 0.25 * scattered(k) + if k == 44 { 5.0 } else { 0.0 }, &MatchOptions::default()).contains(&44));
    }

    #[test]
    fn zero_neighbours_switch_the_rule_off() {
        let off = MatchOptions { parallax_neighbours: 0, ..MatchOptions::default() };
        assert!(refused(|k| if k == 44 { 50.0 } else { 0.0 }, &off).is_empty());
    }

    #[test]
    fn a_single_match_has_no_neighbours_and_stays() {
        let (left, mut verdicts) = grid(|_| 3.0);
        verdicts.iter_mut().skip(1).for_each(|v| v.rule = Rule::Threshold);
        refuse_by_parallax(&left, &OffsetField::constant(0.0, 0.0), &mut verdicts, &MatchOptions::default());
        assert_eq!(verdicts[0].rule, Rule::Matched);
    }
}
