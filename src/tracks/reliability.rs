//! How probable it is that a match is right, from the matches around it, beside what wrong matches find around them.

use super::chance::wrong_matches;
use super::evidence::Surroundings;
use super::two_groups::{Group, TwoGroups};
use super::{BlockMatches, ImageFeatures};
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// What the matches of a block say about their own reliability.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct MatchReliability {
    /// Share of right matches among those about which a third image says something.
    pub right: f64,
    /// The same among the others.
    pub right_alone: f64,
    /// Matches about which a third image says something.
    pub observed: usize,
}

/// The probability of each match, in their order.
pub(super) fn probabilities(matches: &BlockMatches, features: &[ImageFeatures<'_>], expected_right: f64) -> (Vec<f32>, MatchReliability) {
    let surroundings = Surroundings::new(matches, features);
    let group = |edges: Range<usize>| Group {
        found: matches.edges()[edges.clone()].iter().map(|edge| surroundings.evidence(edge.nodes)).collect(),
        wrong: wrong_matches(matches, features, edges).into_iter().map(|nodes| surroundings.evidence(nodes)).collect(),
    };
    let pairs: Vec<Group> = matches.pair_ranges().map(group).collect();
    let groups = TwoGroups::of(&pairs, expected_right);
    let p: Vec<f32> = pairs.iter().flat_map(|pair| groups.right_of(pair)).map(|p| p as f32).collect();
    let reliability = summary(&pairs, &p, expected_right);
    (p, reliability)
}

fn summary(pairs: &[Group], p: &[f32], expected_right: f64) -> MatchReliability {
    let (mut right, mut count) = ([0.0; 2], [0_usize; 2]);
    for (evidence, p) in pairs.iter().flat_map(|pair| &pair.found).zip(p) {
        let alone = usize::from(evidence.is_none());
        right[alone] += f64::from(*p);
        count[alone] += 1;
    }
    let share = |alone: usize| if count[alone] > 0 { right[alone] / count[alone] as f64 } else { expected_right };
    MatchReliability { right: share(0), right_alone: share(1), observed: count[0] }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tracks::FeatureMatch;

    #[test]
    fn without_triangles_the_expected_share_stands() {
        let mut matches = BlockMatches::new(&[100, 100]).unwrap();
        let list: Vec<_> = (0..60).map(|k| FeatureMatch { features: [k, k], strength: 1.0 }).collect();
        matches.add_pair([0, 1], &list).unwrap();
        let positions: Vec<_> = (0..100).map(|k| [k as f32, 50.0]).collect();
        let image = ImageFeatures { width_px: 100, height_px: 100, positions: &positions };
        let (p, reliability) = probabilities(&matches, &[image; 2], 0.95);
        assert!(p.iter().all(|p| (p - 0.95).abs() < 1e-6), "{p:?}");
        assert!((reliability.right_alone - 0.95).abs() < 1e-6 && reliability.observed == 0);
    }
}
