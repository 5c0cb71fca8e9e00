//! Wrong matches made at random: what they find around them is what wrong matches of the block find.

use super::BlockMatches;
use super::places::{ImageFeatures, cell};
use crate::math::Random;
use std::ops::Range;

/// So many are made of each pair.
const OF_A_PAIR: usize = 200;

/// Cells a side of the grid by which the overlap of two images is known.
const SIDE: usize = 8;

/// Pairs of nodes without a match, for the pair of images whose edges these are.
///
/// They lie where the images overlap: in cells of a grid that hold a match of the pair. Features outside see other images, and would find
/// other matches around them.
pub(super) fn wrong_matches(matches: &BlockMatches, features: &[ImageFeatures<'_>], edges: Range<usize>) -> Vec<[u32; 2]> {
    let Some(first) = matches.edges()[edges.clone()].first() else { return Vec::new() };
    let images = first.nodes.map(|node| matches.image_of(node));
    let free = [0, 1].map(|side| {
        let mut taken: Vec<u32> = matches.edges()[edges.clone()].iter().map(|edge| edge.nodes[side]).collect();
        taken.sort_unstable();
        let image = &features[images[side] as usize];
        let cell_of = |node: u32| {
            let at = image.positions[matches.feature_of(node) as usize].map(f64::from);
            cell(at, [image.width_px, image.height_px], SIDE)
        };
        let mut overlaps = [false; SIDE * SIDE];
        taken.iter().for_each(|node| overlaps[cell_of(*node)] = true);
        let is_free = |node: &u32| overlaps[cell_of(*node)] && taken.binary_search(node).is_err();
        matches.nodes_of(images[side]).filter(is_free).collect::<Vec<u32>>()
    });
    if free.iter().any(Vec::is_empty) {
        return Vec::new();
    }
    // The same whatever the order in which the pairs were added.
    let mut random = Random::new(images[0].wrapping_mul(0x9E37_79B1) ^ images[1]);
    (0..OF_A_PAIR).map(|_| free.each_ref().map(|nodes| nodes[random.below(nodes.len())])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tracks::FeatureMatch;

    #[test]
    fn they_join_features_of_the_overlap_without_a_match_in_their_pair() {
        let mut matches = BlockMatches::new(&[5, 4, 3]).unwrap();
        let of = |a, b| FeatureMatch { features: [a, b], strength: 1.0 };
        matches.add_pair([1, 0], &[of(0, 4), of(3, 2)]).unwrap();
        matches.add_pair([1, 2], &[]).unwrap();
        matches.add_pair([0, 2], &[of(0, 0), of(1, 1), of(2, 2)]).unwrap();
        // Feature 3 of image 0 is elsewhere.
        let positions = [[5.0, 5.0], [6.0, 5.0], [5.0, 6.0], [795.0, 595.0], [6.0, 6.0]];
        let features: Vec<_> =
            [5, 4, 3].map(|count| ImageFeatures { width_px: 800, height_px: 600, positions: &positions[..count] }).to_vec();
        let made: Vec<_> = matches.pair_ranges().map(|edges| wrong_matches(&matches, &features, edges)).collect();
        assert_eq!(made[0].len(), OF_A_PAIR);
        assert!(made[0].iter().all(|[a, b]| [0, 1].contains(a) && [6, 7].contains(b)), "{:?}", made[0]);
        assert!(made[1].is_empty(), "no match");
        assert!(made[2].is_empty(), "no feature of image 2 is without a match");
    }
}
