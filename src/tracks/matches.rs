//! The pairwise matches of a whole block, kept small: twelve bytes a match.

use super::ImageFeatures;
use crate::error::refuse;
use crate::{Error, Input, Refusal};
use std::collections::BTreeMap;

/// A match of two features.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FeatureMatch {
    /// Indices of the features in the first and in the second image.
    pub features: [u32; 2],
    /// How good the match is, larger is better, in any unit that is the same for all matches of the block. It decides only between matches
    /// that are equally probable by the matches around them.
    pub strength: f32,
}

/// A match between nodes: the features of all images, numbered through.
#[derive(Debug, Clone, Copy)]
pub(super) struct Edge {
    pub nodes: [u32; 2],
    pub strength: f32,
}

/// The matches of all pairs of a block.
///
/// In whatever order the pairs are added, the same points come out.
#[derive(Debug, Clone, Default)]
pub struct BlockMatches {
    /// The first node of each image, and the number of all nodes.
    starts: Vec<u32>,
    image_of: Vec<u32>,
    edges: Vec<Edge>,
    /// Where the edges of a pair begin, by pair.
    pairs: BTreeMap<[u32; 2], usize>,
    /// The same, in the order in which the pairs were added.
    firsts: Vec<usize>,
}

impl BlockMatches {
    /// No matches yet, of images with these numbers of features.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] where these are more features than 32 bits count.
    pub fn new(feature_counts: &[u32]) -> Result<Self, Error> {
        let mut starts = Vec::with_capacity(feature_counts.len() + 1);
        let mut total: u64 = 0;
        for count in feature_counts {
            starts.push(total as u32);
            total += u64::from(*count);
            if total >= u64::from(u32::MAX) {
                return refuse(Refusal::ManyFeatures { features: total, most: u32::MAX - 1 });
            }
        }
        starts.push(total as u32);
        let mut image_of = vec![0; total as usize];
        for image in 0..feature_counts.len() {
            image_of[starts[image] as usize..starts[image + 1] as usize].fill(image as u32);
        }
        Ok(Self { starts, image_of, ..Self::default() })
    }

    /// Adds the matches of a pair of images.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for an image or a feature that does not exist, an image with itself, a pair that was added before, and a
    /// strength that is no number. Nothing is added then.
    pub fn add_pair(&mut self, images: [u32; 2], matches: &[FeatureMatch]) -> Result<(), Error> {
        let key = [images[0].min(images[1]), images[0].max(images[1])];
        if key[1] as usize >= self.images() || key[0] == key[1] {
            return refuse(Refusal::PairOfImages { images, count: self.images() });
        }
        if self.pairs.contains_key(&key) {
            return refuse(Refusal::PairAgain { images });
        }
        let counts = images.map(|image| self.features(image));
        for (index, m) in matches.iter().enumerate() {
            if m.features[0] >= counts[0] || m.features[1] >= counts[1] || m.strength.is_nan() {
                let (features, strength, [left, right]) = (m.features, m.strength.to_string(), counts);
                return refuse(Refusal::MatchedFeatures { features, strength, index, images, left, right });
            }
        }
        if self.edges.len() + matches.len() >= i32::MAX as usize {
            return refuse(Refusal::ManyMatches { most: i32::MAX });
        }
        self.pairs.insert(key, self.edges.len());
        self.firsts.push(self.edges.len());
        let starts = images.map(|image| self.starts[image as usize]);
        self.edges.extend(matches.iter().map(|m| {
            let nodes = [starts[0] + m.features[0], starts[1] + m.features[1]];
            Edge { nodes: [nodes[0].min(nodes[1]), nodes[0].max(nodes[1])], strength: m.strength }
        }));
        Ok(())
    }

    /// How many images there are.
    pub fn images(&self) -> usize {
        self.starts.len().saturating_sub(1)
    }

    /// How many matches there are.
    pub fn len(&self) -> usize {
        self.edges.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.edges.is_empty()
    }

    /// Refuses features that are not those of these images.
    pub(super) fn check_features(&self, features: &[ImageFeatures<'_>]) -> Result<(), Error> {
        if features.len() != self.images() {
            let (images, wanted) = (features.len(), self.images());
            return refuse(Refusal::FeaturesOfImages { input: Input::PointsOfBlock, images, wanted });
        }
        for (image, known) in (0_u32..).zip(features) {
            if known.positions.len() < self.features(image) as usize {
                return refuse(Refusal::LostFeature { feature: known.positions.len() as u32, image });
            }
        }
        Ok(())
    }

    fn features(&self, image: u32) -> u32 {
        self.starts[image as usize + 1] - self.starts[image as usize]
    }

    pub(super) fn edges(&self) -> &[Edge] {
        &self.edges
    }

    /// Ranges of the edges of each pair, in the order in which they were added.
    pub(super) fn pair_ranges(&self) -> impl Iterator<Item = std::ops::Range<usize>> {
        let ends = self.firsts.iter().skip(1).copied().chain([self.edges.len()]);
        self.firsts.iter().copied().zip(ends).map(|(first, end)| first..end)
    }

    /// The pairs that were added, by image.
    pub(super) fn pairs(&self) -> impl Iterator<Item = [u32; 2]> {
        self.pairs.keys().copied()
    }

    pub(super) fn nodes(&self) -> usize {
        self.image_of.len()
    }

    pub(super) fn nodes_of(&self, image: u32) -> std::ops::Range<u32> {
        self.starts[image as usize]..self.starts[image as usize + 1]
    }

    pub(super) fn image_of(&self, node: u32) -> u32 {
        self.image_of[node as usize]
    }

    pub(super) fn feature_of(&self, node: u32) -> u32 {
        node - self.starts[self.image_of(node) as usize]
    }
}

/// Places of the features of images that are asked how their matches are joined: far enough from each other to be different ones.
#[cfg(test)]
pub(super) fn apart(images: usize) -> Vec<ImageFeatures<'static>> {
    static POSITIONS: [[f32; 2]; 5] = [[50.0, 50.0], [350.0, 50.0], [200.0, 150.0], [50.0, 250.0], [350.0, 250.0]];
    vec![ImageFeatures { width_px: 400, height_px: 300, positions: &POSITIONS }; images]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(a: u32, b: u32) -> FeatureMatch {
        FeatureMatch { features: [a, b], strength: 1.0 }
    }

    #[test]
    fn what_does_not_exist_is_refused_and_nothing_is_added() {
        let mut matches = BlockMatches::new(&[3, 0, 2]).unwrap();
        let mut refused = |images, list: &[FeatureMatch]| {
            let error = matches.add_pair(images, list).unwrap_err();
            assert_eq!(error.code(), "invalid-input");
            assert!(matches.is_empty());
            error.to_string()
        };
        assert!(refused([0, 3], &[]).contains("two different images of 3"));
        assert!(refused([2, 2], &[]).contains("[2, 2]"));
        assert!(refused([0, 2], &[of(0, 0), of(3, 0)]).contains("match 1 of images [0, 2]"));
        assert!(refused([0, 1], &[of(0, 0)]).contains("below 3 and 0"));
        assert!(refused([0, 2], &[FeatureMatch { features: [0, 0], strength: f32::NAN }]).contains("NaN"));
        matches.add_pair([2, 0], &[of(1, 2)]).unwrap();
        assert!(matches.add_pair([0, 2], &[]).unwrap_err().to_string().contains("again"));
        assert_eq!((matches.edges()[0].nodes, matches.image_of(4), matches.feature_of(4)), ([2, 4], 2, 1));
    }

    #[test]
    fn more_features_than_can_be_counted_are_refused() {
        assert!(BlockMatches::new(&[u32::MAX, u32::MAX]).unwrap_err().to_string().contains("features of the block"));
    }
}
