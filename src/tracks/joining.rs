//! Joining matches to multi-ray points: the most probable first, and none that would give a point two rays in one image.

use super::reliability::probabilities;
use super::sets::{Joined, RaySets};
use super::{BlockMatches, BlockOptions, Conflicts, FeatureObservation, ImageFeatures, MatchReliability, TiePoints};
use crate::Error;
use serde::{Deserialize, Serialize};

/// What became of the matches.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct JoinCounts {
    pub matches: usize,
    /// Too improbable to join anything.
    pub cut_as_improbable: usize,
    /// Cut because they would have given a point two rays in one image.
    pub cut_as_conflict: usize,
    /// Points of too few rays, and points in conflict where these are dropped.
    pub dropped_points: usize,
    pub dropped_rays: usize,
    pub reliability: MatchReliability,
}

/// A match with a lower probability of being right joins nothing.
const SURE: f32 = 0.95;

/// Joins matches to multi-ray points.
///
/// Each match is an edge between two features. How probable it is that an edge is right follows from the third images in which its features
/// have partners: the same partner supports it, different ones speak against it, and where one feature or both have none, it is judged by how
/// many wrong edges find as much. Edges are joined from the most probable to the least, and an edge between two sets of features that both hold
/// an image is cut: every set then holds an image once, and what is cut are its weakest edges. Joining ends where the expected share of
/// impure points reaches `impure`. Time grows with the matches times the images that see a point. `features` are those of the block's images,
/// in their order.
///
/// # Errors
/// [`Error::InvalidOption`]; [`Error::InvalidInput`] where `features` are not those that were matched.
///
/// # Source
/// The joining is Kruskal's 1956 algorithm with a side condition.
pub fn tie_points(
    matches: &BlockMatches,
    features: &[ImageFeatures<'_>],
    options: &BlockOptions,
) -> Result<(TiePoints, JoinCounts), Error> {
    options.check_ranges()?;
    matches.check_features(features)?;
    let (probability, reliability) = probabilities(matches, features, options.expected_right);
    let joined = join(matches, &probability, options);
    let mut counts = JoinCounts {
        matches: matches.len(),
        cut_as_improbable: joined.cut_as_improbable,
        cut_as_conflict: joined.cut_as_conflict,
        dropped_points: 0,
        dropped_rays: 0,
        reliability,
    };
    let points = points_of(matches, &joined, options.min_rays, &mut counts);
    Ok((points, counts))
}

/// Sets of nodes that belong together.
struct JoinedSets<'a> {
    sets: RaySets<'a>,
    /// Of each node the probability of its most probable edge in its set.
    confidence: Vec<f32>,
    /// Roots of sets in conflict, ascending, where these are dropped.
    dropped: Vec<u32>,
    cut_as_improbable: usize,
    cut_as_conflict: usize,
}

fn join<'a>(matches: &'a BlockMatches, probability: &[f32], options: &BlockOptions) -> JoinedSets<'a> {
    let mut sets = RaySets::new(matches);
    let mut confidence = vec![0.0_f32; matches.nodes()];
    let (mut in_conflict, mut cut_as_conflict, mut used) = (Vec::new(), 0, 0);
    let (mut points, mut doubt) = (0_usize, 0.0);
    for edge in by_probability(matches, probability) {
        let (nodes, p) = (matches.edges()[edge as usize].nodes, probability[edge as usize]);
        if doubt + 1.0 - f64::from(p) > options.impure * (points + 1) as f64 {
            break;
        }
        used += 1;
        let joined = sets.join(nodes, p, options.conflicts);
        match joined {
            Joined::New => points += 1,
            Joined::Merged => points -= 1,
            Joined::Added | Joined::Before => {}
            Joined::Conflict => match options.conflicts {
                Conflicts::Resolve => cut_as_conflict += 1,
                Conflicts::Drop => in_conflict.push(nodes[0]),
            },
        }
        if joined != Joined::Conflict {
            nodes.iter().for_each(|node| confidence[*node as usize] = confidence[*node as usize].max(p));
            if joined != Joined::Before {
                doubt += 1.0 - f64::from(p);
            }
        }
    }
    let mut dropped: Vec<u32> = in_conflict.into_iter().map(|node| sets.root(node)).collect();
    dropped.sort_unstable();
    dropped.dedup();
    JoinedSets { sets, confidence, dropped, cut_as_improbable: matches.len() - used, cut_as_conflict }
}

/// The edges that may join, the most probable first; equal ones by strength, then by their nodes.
fn by_probability(matches: &BlockMatches, probability: &[f32]) -> Vec<u32> {
    let mut order: Vec<u32> = (0..matches.len() as u32).filter(|edge| probability[*edge as usize] >= SURE).collect();
    order.sort_unstable_by(|a, b| {
        let [a, b] = [*a as usize, *b as usize];
        let [left, right] = [&matches.edges()[a], &matches.edges()[b]];
        probability[b].total_cmp(&probability[a]).then(right.strength.total_cmp(&left.strength)).then(left.nodes.cmp(&right.nodes))
    });
    order
}

fn points_of(matches: &BlockMatches, joined: &JoinedSets<'_>, min_rays: usize, counts: &mut JoinCounts) -> TiePoints {
    let mut points = TiePoints::default();
    joined.sets.each(|nodes| {
        let root = joined.sets.root_of(nodes[0]);
        if nodes.len() < min_rays || joined.dropped.binary_search(&root).is_ok() {
            counts.dropped_points += 1;
            counts.dropped_rays += nodes.len();
            return;
        }
        let ray = |node: &u32| FeatureObservation {
            image: matches.image_of(*node),
            feature: matches.feature_of(*node),
            confidence: joined.confidence[*node as usize],
        };
        points.push(nodes.iter().map(ray), (1.0 - joined.sets.doubt(root)).max(0.0) as f32);
    });
    points
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tracks::FeatureMatch;
    use crate::tracks::matches::apart;

    fn of(a: u32, b: u32, strength: f32) -> FeatureMatch {
        FeatureMatch { features: [a, b], strength }
    }

    fn rays(points: &TiePoints) -> Vec<Vec<(u32, u32)>> {
        points.iter().map(|rays| rays.iter().map(|ray| (ray.image, ray.feature)).collect()).collect()
    }

    /// Two complete points of four rays, joined by one wrong match between images 0 and 3.
    fn two_points() -> BlockMatches {
        let mut matches = BlockMatches::new(&[2; 4]).unwrap();
        for a in 0..4 {
            for b in a + 1..4 {
                let right = [of(0, 0, 1.0), of(1, 1, 1.0)];
                let list = if (a, b) == (0, 3) { vec![of(0, 1, 9.0)] } else { right.to_vec() };
                matches.add_pair([a, b], &list).unwrap();
            }
        }
        matches
    }

    #[test]
    fn a_match_between_two_points_is_improbable() {
        let options = BlockOptions { impure: 0.5, ..BlockOptions::default() };
        let (points, counts) = tie_points(&two_points(), &apart(4), &options).unwrap();
        let whole = |feature| (0..4).map(|image| (image, feature)).collect::<Vec<_>>();
        assert_eq!(rays(&points), [whole(0), whole(1)]);
        assert_eq!((counts.cut_as_improbable, counts.cut_as_conflict), (1, 0));
    }

    /// Four matches that go from one feature of image 0 around to another one.
    fn conflict() -> BlockMatches {
        let mut matches = BlockMatches::new(&[2; 4]).unwrap();
        for (images, m) in [([0, 1], of(0, 0, 1.0)), ([1, 2], of(0, 0, 2.0)), ([2, 3], of(0, 0, 2.0)), ([3, 0], of(0, 1, 0.5))] {
            matches.add_pair(images, &[m]).unwrap();
        }
        matches
    }

    #[test]
    fn a_conflict_is_cut_at_its_weakest_edge() {
        let options = BlockOptions { impure: 0.01, ..BlockOptions::default() };
        let (points, counts) = tie_points(&conflict(), &apart(4), &options).unwrap();
        assert_eq!(rays(&points), [[(0, 0), (1, 0), (2, 0), (3, 0)]]);
        assert_eq!(counts.cut_as_conflict, 1);
    }

    #[test]
    fn a_conflict_that_is_dropped_takes_all_its_rays_along() {
        let options = BlockOptions { conflicts: Conflicts::Drop, impure: 0.01, ..BlockOptions::default() };
        let (points, counts) = tie_points(&conflict(), &apart(4), &options).unwrap();
        assert!(points.is_empty());
        assert_eq!((counts.dropped_points, counts.dropped_rays), (1, 5));
    }

    #[test]
    fn the_order_of_the_pairs_does_not_matter() {
        let lists =
            [([0, 1], [of(0, 0, 1.0), of(1, 1, 1.0)]), ([2, 1], [of(0, 0, 1.0), of(1, 1, 0.5)]), ([0, 2], [of(0, 1, 1.0), of(1, 0, 2.0)])];
        let join = |order: [usize; 3]| {
            let mut matches = BlockMatches::new(&[2; 3]).unwrap();
            order.iter().for_each(|k| matches.add_pair(lists[*k].0, &lists[*k].1).unwrap());
            tie_points(&matches, &apart(3), &BlockOptions { impure: 0.5, ..BlockOptions::default() }).unwrap()
        };
        assert_eq!(join([0, 1, 2]), join([2, 0, 1]));
        assert_eq!(join([0, 1, 2]), join([1, 2, 0]));
    }

    #[test]
    fn points_of_too_few_rays_are_counted_and_left_out() {
        let mut matches = BlockMatches::new(&[1; 2]).unwrap();
        matches.add_pair([0, 1], &[of(0, 0, 1.0)]).unwrap();
        let (points, counts) = tie_points(&matches, &apart(2), &BlockOptions { min_rays: 3, ..BlockOptions::default() }).unwrap();
        assert!(points.is_empty() && counts.dropped_rays == 2);
        let (points, _) = tie_points(&matches, &apart(2), &BlockOptions::default()).unwrap();
        assert_eq!(rays(&points), [[(0, 0), (1, 0)]]);
        assert!((points.confidence(0) - 0.998).abs() < 1e-6 && points.rays(1).is_empty());
    }

    #[test]
    fn nothing_gives_nothing() {
        let (points, counts) = tie_points(&BlockMatches::new(&[]).unwrap(), &[], &BlockOptions::default()).unwrap();
        assert!(points.is_empty() && counts.matches == 0);
    }

    #[test]
    fn features_of_other_images_are_refused() {
        let matches = BlockMatches::new(&[2, 6]).unwrap();
        let refused = |features: &[ImageFeatures<'_>]| tie_points(&matches, features, &BlockOptions::default()).unwrap_err().to_string();
        assert!(refused(&apart(1)).contains("features of 1 images"), "{}", refused(&apart(1)));
        assert!(refused(&apart(2)).contains("feature 5 of image 1"), "{}", refused(&apart(2)));
    }

    #[test]
    fn options_outside_their_ranges_are_refused() {
        let matches = BlockMatches::new(&[]).unwrap();
        for (options, name) in [
            (BlockOptions { impure: f64::NAN, ..BlockOptions::default() }, "block.impure"),
            (BlockOptions { min_rays: 1, ..BlockOptions::default() }, "block.min_rays"),
            (BlockOptions { expected_right: 1.0, ..BlockOptions::default() }, "block.expected_right"),
        ] {
            assert!(matches!(tie_points(&matches, &[], &options), Err(Error::InvalidOption { field, .. }) if field == name));
        }
    }
}
