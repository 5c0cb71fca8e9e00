//! Refinement of matches: least squares matching from where they are.

use super::area::{limits, located};
use super::least_squares::LeastSquares;
use super::rules::set_of;
use super::{MatchImage, MatchOptions, MatchSet, Refinement, Rule};
use crate::LocalFrame;

const UNDEFORMED: [[f64; 2]; 2] = [[1.0, 0.0], [0.0, 1.0]];

/// Moves the right position of each match to where least squares matching finds it; a match that it cannot confirm is refused, or stays
/// where it is.
///
/// Matches that least squares matching found keep what they have. Measures stay those of the strategy.
///
/// Where the points have scales and directions, the right window is that of the left one turned and enlarged as these tell.
pub(crate) fn refine(set: MatchSet, left: MatchImage<'_>, right: MatchImage<'_>, options: &MatchOptions) -> MatchSet {
    let refinement = options.refine();
    if refinement == Refinement::None {
        return set;
    }
    let mut matching = LeastSquares::new(options.template);
    let limits = limits(options);
    let mut verdicts = set.verdicts;
    for (k, (point, verdict)) in left.points.iter().zip(&mut verdicts).enumerate() {
        let Some(start) = verdict.matched().filter(|_| verdict.fit.is_none()) else { continue };
        let frames = left.frames.get(k).zip(verdict.best.and_then(|best| right.frames.get(best)));
        let affine = frames.map_or(UNDEFORMED, |(left, right)| between(left, right));
        let refined = located(matching.fit((left.grey, [point.x, point.y]), (right.grey, start), affine, &limits), options);
        if refinement == Refinement::LeastSquares {
            verdict.rule = refined.rule;
        }
        if refined.rule == Rule::Matched {
            (verdict.position, verdict.fit) = (refined.position, refined.fit);
        }
    }
    set_of(left.points, verdicts)
}

/// The rotation and enlargement that take the left frame to the right one.
fn between(left: &LocalFrame, right: &LocalFrame) -> [[f64; 2]; 2] {
    let turn = right.orientation_rad - left.orientation_rad;
    let growth = right.scale_px / left.scale_px;
    let (cos, sin) = (growth * libm::cos(turn), growth * libm::sin(turn));
    [[cos, -sin], [sin, cos]]
}
