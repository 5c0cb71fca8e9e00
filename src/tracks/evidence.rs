//! What the matches around a match say about it: triangles that close, that stay open, and that miss a side.

use super::pairs::PairTable;
use super::{BlockMatches, ImageFeatures};

/// Counts beyond this say nothing new.
pub(super) const MOST: u8 = 31;

/// A place has several features, of several scales and directions, each a few pixels off: any of them is a right partner.
const ONE_PLACE_PX: f32 = 4.0;

/// For a match a–b: the third images that speak for or against it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default)]
pub(super) struct Evidence {
    /// Images in which a and b have the same partner, or partners at the same place.
    pub closed: u8,
    /// Images in which they have different ones.
    pub open: u8,
    /// Images in which only one has a partner, though the other's image was matched with that image, too.
    pub missing: u8,
}

impl Evidence {
    pub(super) fn is_none(self) -> bool {
        self == Self::default()
    }

    /// Images in which both have a partner.
    pub(super) fn told(self) -> u8 {
        self.closed + self.open
    }
}

/// What looks for evidence: the partners of all features, and which images were matched.
pub(super) struct Surroundings<'a> {
    matches: &'a BlockMatches,
    features: &'a [ImageFeatures<'a>],
    neighbours: Neighbours,
    pairs: PairTable,
}

impl<'a> Surroundings<'a> {
    pub(super) fn new(matches: &'a BlockMatches, features: &'a [ImageFeatures<'a>]) -> Self {
        Self { matches, features, neighbours: Neighbours::new(matches), pairs: PairTable::new(matches) }
    }

    /// The evidence of a match of two nodes, whether or not it was found.
    pub(super) fn evidence(&self, nodes: [u32; 2]) -> Evidence {
        self.compare(nodes.map(|node| self.neighbours.of(node)), nodes.map(|node| self.matches.image_of(node)))
    }

    /// Nodes by image are nodes in ascending order, so both lists are walked once.
    fn compare(&self, [a, b]: [&[u32]; 2], images: [u32; 2]) -> Evidence {
        let (mut i, mut j) = (0, 0);
        let mut found = Evidence::default();
        let count = |count: &mut u8| *count = (*count + 1).min(MOST);
        while i < a.len() || j < b.len() {
            let image_at = |list: &[u32], at: usize| list.get(at).map_or(u32::MAX, |node| self.matches.image_of(*node));
            let image = image_at(a, i).min(image_at(b, j));
            let in_image = |node: &&u32| self.matches.image_of(**node) == image;
            let end_a = i + a[i..].iter().take_while(in_image).count();
            let end_b = j + b[j..].iter().take_while(in_image).count();
            let (of_a, of_b) = (&a[i..end_a], &b[j..end_b]);
            (i, j) = (end_a, end_b);
            if image == images[0] || image == images[1] {
                continue;
            }
            if !of_a.is_empty() && !of_b.is_empty() {
                let common = of_a.iter().any(|a| of_b.iter().any(|b| self.are_at_one_place([*a, *b])));
                count(if common { &mut found.closed } else { &mut found.open });
            } else if self.pairs.has(image, images[usize::from(of_b.is_empty())]) {
                count(&mut found.missing);
            }
        }
        found
    }

    fn are_at_one_place(&self, nodes: [u32; 2]) -> bool {
        let place = |node: u32| self.features[self.matches.image_of(node) as usize].positions[self.matches.feature_of(node) as usize];
        let [[xa, ya], [xb, yb]] = nodes.map(place);
        nodes[0] == nodes[1] || (xa - xb).abs().max((ya - yb).abs()) <= ONE_PLACE_PX
    }
}

/// The partners of each node, ascending, in one array.
struct Neighbours {
    starts: Vec<u32>,
    nodes: Vec<u32>,
}

impl Neighbours {
    fn new(matches: &BlockMatches) -> Self {
        let mut starts = vec![0_u32; matches.nodes() + 1];
        let edges = || matches.edges().iter().map(|edge| edge.nodes);
        edges().flatten().for_each(|node| starts[node as usize + 1] += 1);
        for node in 0..matches.nodes() {
            starts[node + 1] += starts[node];
        }
        let mut places = starts.clone();
        let mut nodes = vec![0; starts[matches.nodes()] as usize];
        for [a, b] in edges() {
            for (from, to) in [(a, b), (b, a)] {
                let place = &mut places[from as usize];
                nodes[*place as usize] = to;
                *place += 1;
            }
        }
        for node in 0..matches.nodes() {
            nodes[starts[node] as usize..starts[node + 1] as usize].sort_unstable();
        }
        Self { starts, nodes }
    }

    fn of(&self, node: u32) -> &[u32] {
        &self.nodes[self.starts[node as usize] as usize..self.starts[node as usize + 1] as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tracks::FeatureMatch;
    use crate::tracks::matches::apart;

    fn evidence(matches: &BlockMatches) -> Vec<Evidence> {
        let features = apart(matches.images());
        let surroundings = Surroundings::new(matches, &features);
        matches.edges().iter().map(|edge| surroundings.evidence(edge.nodes)).collect()
    }

    #[test]
    fn triangles_close_stay_open_or_miss_a_side_by_image() {
        let mut matches = BlockMatches::new(&[2, 2, 2, 2, 1]).unwrap();
        let of = |a, b| FeatureMatch { features: [a, b], strength: 1.0 };
        matches.add_pair([0, 1], &[of(0, 0)]).unwrap();
        matches.add_pair([0, 2], &[of(0, 0)]).unwrap();
        matches.add_pair([1, 2], &[of(0, 0)]).unwrap();
        matches.add_pair([3, 0], &[of(0, 0)]).unwrap();
        matches.add_pair([1, 3], &[of(0, 1)]).unwrap();
        matches.add_pair([0, 4], &[of(0, 0)]).unwrap();
        let found: Vec<Evidence> = evidence(&matches);
        assert_eq!(
            found[0],
            Evidence { closed: 1, open: 1, missing: 0 },
            "image 2 agrees, image 3 does not, image 4 was not matched with 1"
        );
        assert_eq!(found[1], Evidence { closed: 1, open: 0, missing: 0 });
        assert_eq!(found[3], Evidence { closed: 0, open: 0, missing: 1 }, "the feature of image 3 has no partner in image 1");
        let one_place = [[50.0, 50.0], [53.0, 46.0]];
        let mut features = apart(5);
        features[3].positions = &one_place;
        let found = Surroundings::new(&matches, &features).evidence(matches.edges()[0].nodes);
        assert_eq!(found, Evidence { closed: 2, open: 0, missing: 0 }, "both features of image 3 are at one place");
        matches.add_pair([1, 4], &[]).unwrap();
        assert_eq!(evidence(&matches)[0], Evidence { closed: 1, open: 1, missing: 1 });
    }
}
