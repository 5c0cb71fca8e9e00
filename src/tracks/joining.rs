//! Joining matches to multi-ray points: the most probable first, and none that would give a point two rays in one image.

use super::belonging::belonging;
use super::evidence::evidence;
use super::mixture::{probabilities, reliability};
use super::sets::{Joined, RaySets};
use super::{BlockMatches, BlockOptions, Conflicts, FeatureObservation, MatchReliability, TiePoints};
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
    /// Rays that too few of the other rays of their point confirm.
    pub cut_rays: usize,
    /// Points of too few rays, points beyond the allowed share of impure ones, and points in conflict where these are dropped.
    pub dropped_points: usize,
    pub dropped_rays: usize,
    pub reliability: MatchReliability,
}

/// A match that is right, and a ray that belongs to its point, with a lower probability is cut.
const SURE: f32 = 0.95;

/// How often the matches are judged: the second time, those that were found rather wrong say nothing about others.
const ROUNDS: usize = 2;

/// Joins matches to multi-ray points.
///
/// Each match is an edge between two features. How probable it is that an edge is right follows from the third images in which both its
/// features have partners: the same one supports it, different ones and missing ones speak against it; the shares of right edges and of
/// closing triangles are estimated from all of them. Edges are joined from the most probable to the least, and an edge between two sets of
/// features that both hold an image is cut: every set then holds an image once, and what is cut are its weakest edges. A ray is judged
/// again by how many of the other rays of its point it is matched with. Of the points the surest are kept, as many as leave the expected
/// share of impure ones below `impure`. Time grows with the matches times the images that see a point.
///
/// # Errors
/// [`Error::InvalidOption`].
///
/// # Source
/// The joining is Kruskal's 1956 algorithm with a side condition.
pub fn tie_points(matches: &BlockMatches, options: &BlockOptions) -> Result<(TiePoints, JoinCounts), Error> {
    options.check_ranges()?;
    let (probability, reliability) = judge(matches, options.expected_right);
    let order = by_probability(matches, &probability);
    let mut counts = JoinCounts {
        matches: matches.len(),
        cut_as_improbable: matches.len() - order.len(),
        cut_as_conflict: 0,
        cut_rays: 0,
        dropped_points: 0,
        dropped_rays: 0,
        reliability,
    };
    let mut sets = RaySets::new(matches);
    let mut in_conflict = Vec::new();
    for edge in &order {
        let nodes = matches.edges()[*edge as usize].nodes;
        if sets.join(nodes, probability[*edge as usize], options.conflicts) == Joined::Conflict {
            match options.conflicts {
                Conflicts::Resolve => counts.cut_as_conflict += 1,
                Conflicts::Drop => in_conflict.push(nodes[0]),
            }
        }
    }
    let mut dropped: Vec<u32> = in_conflict.into_iter().map(|node| sets.root(node)).collect();
    dropped.sort_unstable();
    dropped.dedup();
    let belonging = belonging(matches, &mut sets, &probability, &order, &dropped);
    let points = points_of(matches, &sets, &belonging, &dropped, options.min_rays, &mut counts);
    Ok((surest(points, options.impure, &mut counts), counts))
}

fn judge(matches: &BlockMatches, expected_right: f64) -> (Vec<f32>, MatchReliability) {
    let mut judged: Option<(Vec<f32>, MatchReliability)> = None;
    for _ in 0..ROUNDS {
        let (evidence, lone) = evidence(matches, |edge| judged.as_ref().is_none_or(|(p, _)| p[edge] >= 0.5));
        let shares = reliability(&evidence, lone, expected_right);
        judged = Some((probabilities(matches, &evidence, &shares), shares));
    }
    judged.unwrap_or_else(|| unreachable!("there are rounds"))
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

fn points_of(
    matches: &BlockMatches,
    sets: &RaySets<'_>,
    belonging: &[f32],
    dropped: &[u32],
    min_rays: usize,
    counts: &mut JoinCounts,
) -> TiePoints {
    let mut points = TiePoints::default();
    let mut kept = Vec::new();
    sets.each(|nodes| {
        let root = sets.root_of(nodes[0]);
        if dropped.binary_search(&root).is_ok() {
            counts.dropped_points += 1;
            counts.dropped_rays += nodes.len();
            return;
        }
        kept.clear();
        kept.extend(nodes.iter().copied().filter(|node| belonging[*node as usize] >= SURE));
        counts.cut_rays += nodes.len() - kept.len();
        if kept.len() < min_rays {
            counts.dropped_points += 1;
            counts.dropped_rays += kept.len();
            return;
        }
        let ray = |node: &u32| FeatureObservation {
            image: matches.image_of(*node),
            feature: matches.feature_of(*node),
            confidence: belonging[*node as usize],
        };
        let doubts = || kept.iter().map(|node| 1.0 - belonging[*node as usize]);
        // One ray needs nothing to hold it: the others are held to it.
        let impure = sets.bridges(root) + doubts().sum::<f32>() - doubts().fold(0.0, f32::max);
        points.push(kept.iter().map(ray), (1.0 - impure).max(0.0));
    });
    points
}

/// The surest points, as many as leave the expected share of impure ones within bounds.
fn surest(points: TiePoints, impure: f64, counts: &mut JoinCounts) -> TiePoints {
    let confidence = |point: u32| points.confidence(point as usize);
    let mut order: Vec<u32> = (0..points.len() as u32).collect();
    order.sort_unstable_by(|a, b| confidence(*b).total_cmp(&confidence(*a)).then(a.cmp(b)));
    let mut doubt = 0.0;
    let mut kept = 0;
    while kept < order.len() {
        doubt += 1.0 - f64::from(confidence(order[kept]));
        if doubt > impure * (kept + 1) as f64 {
            break;
        }
        kept += 1;
    }
    if kept == points.len() {
        return points;
    }
    order.truncate(kept);
    order.sort_unstable();
    let rays = |point: &u32| points.rays(*point as usize);
    let mut left = TiePoints::with_capacity(kept, order.iter().map(|point| rays(point).len()).sum());
    order.iter().for_each(|point| left.push(rays(point).iter().copied(), confidence(*point)));
    counts.dropped_points += points.len() - left.len();
    counts.dropped_rays += points.ray_count() - left.ray_count();
    left
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tracks::FeatureMatch;

    fn of(a: u32, b: u32, strength: f32) -> FeatureMatch {
        FeatureMatch { features: [a, b], strength }
    }

    fn rays(points: &TiePoints) -> Vec<Vec<(u32, u32)>> {
        points.iter().map(|rays| rays.iter().map(|ray| (ray.image, ray.feature)).collect()).collect()
    }

    /// Two complete points of four rays, joined by one wrong match between images 0 and 3.
    fn conflict() -> BlockMatches {
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
    fn a_conflict_is_cut_at_its_weakest_edge() {
        let options = BlockOptions { impure: 0.5, ..BlockOptions::default() };
        let (points, counts) = tie_points(&conflict(), &options).unwrap();
        let whole = |feature| (0..4).map(|image| (image, feature)).collect::<Vec<_>>();
        assert_eq!(rays(&points), [whole(0), whole(1)]);
        assert_eq!(counts.cut_as_conflict, 1);
    }

    #[test]
    fn a_conflict_that_is_dropped_takes_all_its_rays_along() {
        let options = BlockOptions { impure: 0.5, conflicts: Conflicts::Drop, ..BlockOptions::default() };
        let (points, counts) = tie_points(&conflict(), &options).unwrap();
        assert!(points.is_empty());
        assert_eq!((counts.dropped_points, counts.dropped_rays), (1, 8));
    }

    #[test]
    fn the_order_of_the_pairs_does_not_matter() {
        let lists =
            [([0, 1], [of(0, 0, 1.0), of(1, 1, 1.0)]), ([2, 1], [of(0, 0, 1.0), of(1, 1, 0.5)]), ([0, 2], [of(0, 1, 1.0), of(1, 0, 2.0)])];
        let join = |order: [usize; 3]| {
            let mut matches = BlockMatches::new(&[2; 3]).unwrap();
            order.iter().for_each(|k| matches.add_pair(lists[*k].0, &lists[*k].1).unwrap());
            tie_points(&matches, &BlockOptions { impure: 0.5, ..BlockOptions::default() }).unwrap()
        };
        assert_eq!(join([0, 1, 2]), join([2, 0, 1]));
        assert_eq!(join([0, 1, 2]), join([1, 2, 0]));
    }

    #[test]
    fn points_of_too_few_rays_are_counted_and_left_out() {
        let mut matches = BlockMatches::new(&[1; 2]).unwrap();
        matches.add_pair([0, 1], &[of(0, 0, 1.0)]).unwrap();
        let (points, counts) = tie_points(&matches, &BlockOptions { min_rays: 3, ..BlockOptions::default() }).unwrap();
        assert!(points.is_empty() && counts.dropped_rays == 2);
        let (points, _) = tie_points(&matches, &BlockOptions::default()).unwrap();
        assert_eq!(rays(&points), [[(0, 0), (1, 0)]]);
        assert!((points.confidence(0) - 0.998).abs() < 1e-6 && points.rays(1).is_empty());
    }

    #[test]
    fn nothing_gives_nothing() {
        let (points, counts) = tie_points(&BlockMatches::new(&[]).unwrap(), &BlockOptions::default()).unwrap();
        assert!(points.is_empty() && counts.matches == 0);
    }

    #[test]
    fn options_outside_their_ranges_are_refused() {
        let matches = BlockMatches::new(&[]).unwrap();
        for (options, name) in [
            (BlockOptions { impure: f64::NAN, ..BlockOptions::default() }, "block.impure"),
            (BlockOptions { min_rays: 1, ..BlockOptions::default() }, "block.min_rays"),
            (BlockOptions { expected_right: 1.0, ..BlockOptions::default() }, "block.expected_right"),
        ] {
            assert!(matches!(tie_points(&matches, &options), Err(Error::InvalidOption { field, .. }) if field == name));
        }
    }
}
