//! Which images are connected, by how many matches, and why the others are not.

use super::PairRule;
use crate::error::refuse;
use crate::message::{messages, written};
use crate::{Error, Failure, Message, NoGeometry, Refusal};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

messages! {
    /// What came of matching a pair.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum PairOutcome as "outcome" {
        /// Chosen, but not matched yet.
        Waiting,
        /// Enough matches agree with one geometry of the pair.
        Connected { matches: u32 },
        /// Fewer matches than are needed.
        TooFewMatches { matches: u32, needed: u32 },
        /// The matches do not agree with one geometry.
        NotOriented { no_geometry: NoGeometry },
        /// Matching was refused or broken off.
        Failed { failure: Failure },
    }
}

/// A pair that was chosen, and its outcome.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Connection {
    /// In ascending order.
    pub images: [u32; 2],
    pub rule: PairRule,
    pub outcome: PairOutcome,
}

written!(Connection);

impl Message for Connection {
    const FAMILY: &'static str = "connection";
    #[cfg(test)]
    const KINDS: &'static [(&'static str, &'static [&'static str])] = &[("", &["outcome", "rule"])];
}

/// The images of a block and the pairs among them that were chosen.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ConnectionGraph {
    images: u32,
    connections: BTreeMap<[u32; 2], Connection>,
}

impl ConnectionGraph {
    /// A graph of `images` images of which no pair is chosen.
    pub fn new(images: u32) -> Self {
        Self { images, connections: BTreeMap::new() }
    }

    /// Enters a pair, or replaces what was entered for it.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for images that are not two different ones of the block.
    pub fn set(&mut self, images: [u32; 2], rule: PairRule, outcome: PairOutcome) -> Result<(), Error> {
        let images = self.key(images)?;
        self.connections.insert(images, Connection { images, rule, outcome });
        Ok(())
    }

    /// The pair, where it was chosen.
    pub fn get(&self, [a, b]: [u32; 2]) -> Option<&Connection> {
        self.connections.get(&[a.min(b), a.max(b)])
    }

    /// All pairs that were chosen, in order.
    pub fn iter(&self) -> impl Iterator<Item = &Connection> {
        self.connections.values()
    }

    /// The images in groups within which a way of connections leads from each to each: the largest group first, then by the first image.
    pub fn groups(&self) -> Vec<Vec<u32>> {
        let mut group: Vec<u32> = (0..self.images).collect();
        let root = |group: &mut Vec<u32>, mut image: u32| {
            while group[image as usize] != image {
                group[image as usize] = group[group[image as usize] as usize];
                image = group[image as usize];
            }
            image
        };
        for connection in self.iter().filter(|c| matches!(c.outcome, PairOutcome::Connected { .. })) {
            let [a, b] = connection.images.map(|image| root(&mut group, image));
            group[a.max(b) as usize] = a.min(b);
        }
        let mut groups: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
        for image in 0..self.images {
            groups.entry(root(&mut group, image)).or_default().push(image);
        }
        let mut groups: Vec<Vec<u32>> = groups.into_values().collect();
        groups.sort_by_key(|images| std::cmp::Reverse(images.len()));
        groups
    }

    fn key(&self, [a, b]: [u32; 2]) -> Result<[u32; 2], Error> {
        if a == b || a.max(b) >= self.images {
            return refuse(Refusal::PairOfImages { images: [a, b], count: self.images as usize });
        }
        Ok([a.min(b), a.max(b)])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_connection_says_why_it_is_or_is_not_one() {
        let text = |rule, outcome| Connection { images: [0, 1], rule, outcome }.to_string();
        assert_eq!(
            text(PairRule::Near, PairOutcome::Connected { matches: 120 }),
            "connected by 120 matches; chosen because the images are near each other"
        );
        assert_eq!(
            text(PairRule::Sequence, PairOutcome::TooFewMatches { matches: 4, needed: 15 }),
            "not connected: 4 matches; at least 15 are needed; chosen because the images follow each other"
        );
        let no_geometry = NoGeometry::Chance { agreeing: 9, matches: 30 };
        assert_eq!(
            text(PairRule::Alike, PairOutcome::NotOriented { no_geometry }),
            "not connected: only 9 of 30 candidate matches agree on one geometry, no more than would by chance; none is kept; chosen because the images are similar"
        );
    }

    #[test]
    fn groups_are_what_connections_reach_the_largest_first() {
        let mut graph = ConnectionGraph::new(6);
        for images in [[4, 5], [5, 2], [0, 1]] {
            graph.set(images, PairRule::All, PairOutcome::Connected { matches: 20 }).unwrap();
        }
        graph.set([1, 2], PairRule::All, PairOutcome::Failed { failure: Failure::BrokeOff { message: "cancelled".into() } }).unwrap();
        assert_eq!(graph.groups(), [vec![2, 4, 5], vec![0, 1], vec![3]]);
        graph.set([1, 2], PairRule::All, PairOutcome::Connected { matches: 20 }).unwrap();
        assert_eq!(graph.groups(), [vec![0, 1, 2, 4, 5], vec![3]]);
    }
}
