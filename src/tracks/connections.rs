//! Which images are connected, by how many matches, and why the others are not.

use super::PairRule;
use crate::Error;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// What came of matching a pair.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum PairOutcome {
    /// Chosen, but not matched yet.
    Waiting,
    /// Enough matches agree with one geometry of the pair.
    Connected { matches: u32 },
    /// Fewer matches than are needed.
    TooFewMatches { matches: u32, needed: u32 },
    /// The matches do not agree with one geometry.
    NotOriented { matches: u32, reason: String },
    /// Matching was refused or broken off.
    Failed { reason: String },
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

    /// Why two images are or are not connected, in words.
    ///
    /// # Errors
    /// As [`set`](Self::set).
    pub fn explain(&self, images: [u32; 2]) -> Result<String, Error> {
        let Some(connection) = self.connections.get(&self.key(images)?) else {
            return Ok("not tried: neither position, sequence nor likeness chose this pair".into());
        };
        let chosen = match connection.rule {
            PairRule::All => "all pairs are tried",
            PairRule::Near => "chosen as near each other",
            PairRule::Sequence => "chosen as following each other",
            PairRule::Alike => "chosen as alike",
        };
        let outcome = match &connection.outcome {
            PairOutcome::Waiting => "not matched yet".into(),
            PairOutcome::Connected { matches } => format!("connected by {matches} matches"),
            PairOutcome::TooFewMatches { matches, needed } => format!("not connected: {matches} matches, {needed} are needed"),
            // Without any that agree, the reason tells how many there were.
            PairOutcome::NotOriented { matches: 0, reason } => format!("not connected: no common geometry ({reason})"),
            PairOutcome::NotOriented { matches, reason } => format!("not connected: {matches} matches of no common geometry ({reason})"),
            PairOutcome::Failed { reason } => format!("not connected: {reason}"),
        };
        Ok(format!("{outcome}; {chosen}"))
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
            let allowed = format!("two different images of {}", self.images);
            return Err(Error::InvalidInput { what: "pair of images", got: format!("{:?}", [a, b]), allowed });
        }
        Ok([a.min(b), a.max(b)])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn why_two_images_are_not_connected_has_an_answer() {
        let mut graph = ConnectionGraph::new(5);
        graph.set([1, 0], PairRule::Near, PairOutcome::Connected { matches: 120 }).unwrap();
        graph.set([1, 2], PairRule::Sequence, PairOutcome::TooFewMatches { matches: 4, needed: 15 }).unwrap();
        graph.set([3, 2], PairRule::Alike, PairOutcome::NotOriented { matches: 30, reason: "9 inliers".into() }).unwrap();
        let answer = |a, b| graph.explain([a, b]).unwrap();
        assert_eq!(answer(0, 1), "connected by 120 matches; chosen as near each other");
        assert_eq!(answer(2, 1), "not connected: 4 matches, 15 are needed; chosen as following each other");
        assert_eq!(answer(2, 3), "not connected: 30 matches of no common geometry (9 inliers); chosen as alike");
        assert!(answer(0, 4).starts_with("not tried"));
        assert!(graph.explain([0, 0]).is_err() && graph.explain([0, 5]).is_err());
        graph.set([2, 3], PairRule::Alike, PairOutcome::NotOriented { matches: 0, reason: "9 given".into() }).unwrap();
        assert_eq!(graph.explain([2, 3]).unwrap(), "not connected: no common geometry (9 given); chosen as alike");
    }

    #[test]
    fn groups_are_what_connections_reach_the_largest_first() {
        let mut graph = ConnectionGraph::new(6);
        for images in [[4, 5], [5, 2], [0, 1]] {
            graph.set(images, PairRule::All, PairOutcome::Connected { matches: 20 }).unwrap();
        }
        graph.set([1, 2], PairRule::All, PairOutcome::Failed { reason: "cancelled".into() }).unwrap();
        assert_eq!(graph.groups(), [vec![2, 4, 5], vec![0, 1], vec![3]]);
        graph.set([1, 2], PairRule::All, PairOutcome::Connected { matches: 20 }).unwrap();
        assert_eq!(graph.groups(), [vec![0, 1, 2, 4, 5], vec![3]]);
    }
}
