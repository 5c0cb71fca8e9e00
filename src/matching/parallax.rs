//! The rule of y-parallax: neighbouring matches have nearly the same.

use super::neighbours::Neighbours;
use super::positions::check_positions;
use super::{MatchOptions, OffsetField, Rule, Verdict};
use crate::error::refuse;
use crate::math::median;
use crate::{Error, Input, InterestPoint, Refusal};
use serde::Serialize;

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
    let (positions, parallax) = placed(&pairs, offset);
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

/// How far the y-parallax of a point is from those of its nearest matches, and how far it may be, in px.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ParallaxDeviation {
    pub deviation_px: f64,
    /// The tolerance, or 3 times the scatter of the neighbours where that is larger.
    pub allowed_px: f64,
}

/// What the rule of y-parallax finds of one left point, matched or refused, beside the matches that stand in the end; none where it has no place or
/// nothing is near.
///
/// # Errors
/// [`Error::InvalidInput`] for an index beyond the points, for positions that are no numbers and for another number of verdicts;
/// [`Error::InvalidOption`].
pub fn parallax_deviation(
    index: usize,
    left: &[InterestPoint],
    verdicts: &[Verdict],
    offset: &OffsetField,
    options: &MatchOptions,
) -> Result<Option<ParallaxDeviation>, Error> {
    options.check_ranges()?;
    check_positions(Input::LeftPoints, left)?;
    if verdicts.len() != left.len() {
        return refuse(Refusal::Count { input: Input::VerdictsOfPair, got: verdicts.len(), wanted: left.len() });
    }
    let Some(verdict) = verdicts.get(index) else { return refuse(Refusal::LeftPoint { index, count: left.len() }) };
    let Some(own) = verdict.position else { return Ok(None) };
    let others = verdicts.iter().zip(left).enumerate().filter(|(k, _)| *k != index);
    let standing = others.filter_map(|(_, (verdict, point))| Some((*point, verdict.matched()?)));
    let all: Vec<(InterestPoint, [f64; 2])> = std::iter::once((left[index], own)).chain(standing).collect();
    let (positions, parallax) = placed(&all, offset);
    let mut nearest = Vec::new();
    Neighbours::new(&positions).nearest(0, options.parallax_neighbours, |_| true, &mut nearest);
    Ok(deviation(0, &nearest, &parallax, options.parallax_tolerance))
}

/// Where left points are, and the y-parallaxes of their places in the right image.
fn placed(pairs: &[(InterestPoint, [f64; 2])], offset: &OffsetField) -> (Vec<[f64; 2]>, Vec<f64>) {
    pairs.iter().map(|(left, [_, y])| ([left.x, left.y], y - left.y - offset.at(left.x, left.y)[1])).unzip()
}

/// Whether a parallax is too far from those of its neighbours; without any it is not.
fn deviates(index: usize, nearest: &[usize], parallax: &[f64], tolerance: f64) -> bool {
    deviation(index, nearest, parallax, tolerance).is_some_and(|found| found.deviation_px > found.allowed_px)
}

fn deviation(index: usize, nearest: &[usize], parallax: &[f64], tolerance: f64) -> Option<ParallaxDeviation> {
    let mut values: Vec<f64> = nearest.iter().map(|n| parallax[*n]).collect();
    let expected = median(&mut values)?;
    values.iter_mut().for_each(|v| *v = (*v - expected).abs());
    let scatter = SCATTER * SIGMA_OF_MAD * median(&mut values).unwrap_or(0.0);
    Some(ParallaxDeviation { deviation_px: (parallax[index] - expected).abs(), allowed_px: tolerance.max(scatter) })
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
    fn what_is_told_of_a_point_is_what_refused_it() {
        let (left, mut verdicts) = grid(|k| if k == 44 { 5.0 } else { 0.1 * (k % 3) as f64 });
        let options = MatchOptions::default();
        let offset = OffsetField::constant(0.0, 0.0);
        refuse_by_parallax(&left, &offset, &mut verdicts, &options);
        let told = |index: usize| parallax_deviation(index, &left, &verdicts, &offset, &options).unwrap().unwrap();
        for (k, verdict) in verdicts.iter().enumerate() {
            assert_eq!(told(k).deviation_px > told(k).allowed_px, verdict.rule == Rule::Parallax, "{k}");
        }
        assert!((told(44).deviation_px - 4.9).abs() < 0.11 && told(44).allowed_px == 1.0, "{:?}", told(44));
        assert!(parallax_deviation(100, &left, &verdicts, &offset, &options).is_err());
        assert!(parallax_deviation(0, &left, &verdicts[1..], &offset, &options).is_err());
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
