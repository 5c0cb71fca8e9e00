//! Refinement of matches: least squares matching from where they are.

use super::area::limits;
use super::rules::set_of;
use super::scaled::{Halvings, ScaledMatching};
use super::{MatchImage, MatchOptions, MatchSet, Refinement, Rule, Verdict};
use crate::LocalFrame;
use crate::math::median;

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
    let mut matching = ScaledMatching::new(options.template, [left.grey, right.grey]);
    let limits = limits(options);
    let mut verdicts = set.verdicts;
    let frames = |k: usize, verdict: &Verdict| left.frames.get(k).zip(verdict.best.and_then(|best| right.frames.get(best)));
    let of_pair = halvings_of_pair(verdicts.iter().enumerate().filter(|(_, v)| v.rule == Rule::Matched).filter_map(|(k, v)| frames(k, v)));
    for (k, (point, verdict)) in left.points.iter().zip(&mut verdicts).enumerate() {
        let Some(start) = verdict.matched().filter(|_| verdict.fit.is_none()) else { continue };
        let affine = frames(k, verdict).map_or(UNDEFORMED, |(left, right)| between(left, right));
        // The scales of single features scatter: images of one scale are compared as they are.
        let halvings = Halvings::of(affine).min(of_pair);
        let refined = matching.verdict([point.x, point.y], (start, affine), halvings, &limits, options);
        if refinement == Refinement::LeastSquares {
            verdict.rule = refined.rule;
        }
        if refined.rule == Rule::Matched {
            (verdict.position, verdict.fit) = (refined.position, refined.fit);
        }
    }
    set_of(left.points, verdicts)
}

/// What the median enlargement of the matched points asks for.
fn halvings_of_pair<'a>(frames: impl Iterator<Item = (&'a LocalFrame, &'a LocalFrame)>) -> Halvings {
    let growth = median(&mut frames.map(|(left, right)| right.scale_px / left.scale_px).collect::<Vec<f64>>()).unwrap_or(1.0);
    Halvings::of([[growth, 0.0], [0.0, growth]])
}

/// The rotation and enlargement that take the left frame to the right one.
fn between(left: &LocalFrame, right: &LocalFrame) -> [[f64; 2]; 2] {
    let turn = right.orientation_rad - left.orientation_rad;
    let growth = right.scale_px / left.scale_px;
    let (cos, sin) = (growth * libm::cos(turn), growth * libm::sin(turn));
    [[cos, -sin], [sin, cos]]
}
