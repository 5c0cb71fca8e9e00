//! Refinement of matches: least squares matching from where they are.

use super::area::{limits, located};
use super::least_squares::LeastSquares;
use super::rules::set_of;
use super::{MatchImage, MatchOptions, MatchSet, Refinement, Rule};
use crate::GreyView;

const UNDEFORMED: [[f64; 2]; 2] = [[1.0, 0.0], [0.0, 1.0]];

/// Moves the right position of each match to where least squares matching finds it; a match that it cannot confirm is refused.
///
/// Matches that least squares matching found keep what they have. Measures stay those of the strategy.
pub(super) fn refine(set: MatchSet, left: MatchImage<'_>, right: GreyView<'_>, options: &MatchOptions) -> MatchSet {
    if options.refine == Refinement::None {
        return set;
    }
    let mut matching = LeastSquares::new(options.template);
    let limits = limits(options);
    let mut verdicts = set.verdicts;
    for (point, verdict) in left.points.iter().zip(&mut verdicts) {
        let Some(start) = verdict.matched().filter(|_| verdict.fit.is_none()) else { continue };
        let refined = located(matching.fit((left.grey, [point.x, point.y]), (right, start), UNDEFORMED, &limits), options);
        verdict.rule = refined.rule;
        if refined.rule == Rule::Matched {
            (verdict.position, verdict.fit) = (refined.position, refined.fit);
        }
    }
    set_of(left.points, verdicts)
}
