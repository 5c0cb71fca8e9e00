//! Which pairs of images are worth matching: all, those near each other, those that follow each other, those that look alike.

use crate::catalogue::{Form, OptionValue};
use crate::error::refuse;
use crate::message::messages;
use crate::{Error, Refusal};
use serde::{Deserialize, Serialize};

messages! {
    /// Why a pair was chosen.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(rename_all = "lowercase")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum PairRule as "rule" {
        /// All pairs were chosen.
        All,
        /// One is among the nearest of the other.
        Near,
        /// One follows the other.
        Sequence,
        /// One is among the most similar to the other.
        Alike,
    }
}

impl OptionValue for PairRule {
    const FORM: Form = Form::Choice { values: RULES, labels: RULES };
}

/// The rules as they are written.
const RULES: &[&str] = &["all", "near", "sequence", "alike"];

/// A pair to be matched; its images are in ascending order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ChosenPair {
    pub images: [u32; 2],
    pub rule: PairRule,
}

/// All pairs of `images` images.
pub fn all_pairs(images: u32) -> Vec<ChosenPair> {
    (0..images).flat_map(|a| (a + 1..images).map(move |b| ChosenPair { images: [a, b], rule: PairRule::All })).collect()
}

/// Each image with the `reach` that follow it.
pub fn sequence_pairs(images: u32, reach: u32) -> Vec<ChosenPair> {
    let following = |a: u32| (a + 1..a.saturating_add(reach).saturating_add(1).min(images)).map(move |b| [a, b]);
    (0..images).flat_map(following).map(|images| ChosenPair { images, rule: PairRule::Sequence }).collect()
}

/// Each image with its `neighbours` nearest ones; a pair that either side chooses is chosen once.
///
/// `positions`: `[x, y, z]` in m in any system of equal scale in all directions; images without one are in no pair. Only x and y count:
/// what lies below the same place overlaps. Of two at the same distance the earlier one is nearer. Time grows with the images times the
/// neighbours where the images are spread evenly.
///
/// # Errors
/// [`Error::InvalidInput`] for a position that is not finite.
pub fn near_pairs(positions: &[Option<[f64; 3]>], neighbours: usize) -> Result<Vec<ChosenPair>, Error> {
    let known: Vec<(u32, [f64; 2])> = positions.iter().enumerate().filter_map(|(i, p)| p.map(|[x, y, _]| (i as u32, [x, y]))).collect();
    if let Some((image, at)) = known.iter().find(|(_, at)| !at.iter().all(|v| v.abs() <= 1e12)) {
        return refuse(Refusal::PlaceOfImage { position: format!("{at:?}"), image: *image });
    }
    if known.is_empty() || neighbours == 0 {
        return Ok(Vec::new());
    }
    let grid = Grid::new(&known);
    let chosen =
        known.iter().flat_map(|(image, at)| grid.nearest(&known, *image, *at, neighbours).into_iter().map(|other| [*image, other]));
    Ok(unique(chosen.collect(), PairRule::Near))
}

/// Each image with the `most` that are most similar to it; a pair that either side chooses is chosen once.
///
/// `similar`: for each image the images found similar to it, with a similarity that is larger for more similar ones. An image with itself
/// is passed over; of two equally similar ones the earlier is taken first.
///
/// # Errors
/// [`Error::InvalidInput`] for an image that does not exist and for a similarity that is no number.
pub fn alike_pairs(similar: &[Vec<(u32, f32)>], most: usize) -> Result<Vec<ChosenPair>, Error> {
    let mut chosen = Vec::new();
    for (image, list) in similar.iter().enumerate() {
        if let Some((other, value)) = list.iter().find(|(other, value)| *other as usize >= similar.len() || value.is_nan()) {
            return refuse(Refusal::SimilarImage { other: *other, similarity: value.to_string(), image, images: similar.len() });
        }
        let mut list: Vec<_> = list.iter().filter(|(other, _)| *other as usize != image).collect();
        list.sort_by(|a, b| b.1.total_cmp(&a.1).then(a.0.cmp(&b.0)));
        chosen.extend(list.iter().take(most).map(|(other, _)| [image as u32, *other]));
    }
    Ok(unique(chosen, PairRule::Alike))
}

/// The pairs of several choices, each once, with the rule of the first choice that has it.
pub fn merge_pairs(choices: &[Vec<ChosenPair>]) -> Vec<ChosenPair> {
    let mut merged: Vec<ChosenPair> = choices.concat();
    merged.sort_by_key(|pair| pair.images);
    merged.dedup_by_key(|pair| pair.images);
    merged
}

fn unique(mut pairs: Vec<[u32; 2]>, rule: PairRule) -> Vec<ChosenPair> {
    pairs.iter_mut().for_each(|pair| pair.sort_unstable());
    pairs.sort_unstable();
    pairs.dedup();
    pairs.into_iter().map(|images| ChosenPair { images, rule }).collect()
}

/// Squares of ground, of about two images each, with the images above them.
struct Grid {
    low: [f64; 2],
    side: f64,
    shape: [i64; 2],
    cells: Vec<Vec<u32>>,
}

impl Grid {
    fn new(known: &[(u32, [f64; 2])]) -> Self {
        let extreme = |axis: usize, pick: fn(f64, f64) -> f64| known.iter().map(|(_, at)| at[axis]).fold(known[0].1[axis], pick);
        let low = [extreme(0, f64::min), extreme(1, f64::min)];
        let span = [extreme(0, f64::max) - low[0], extreme(1, f64::max) - low[1]];
        // A line of images has no area: its length alone then gives the side.
        let per_cell = 2.0 / known.len() as f64;
        let side = (span[0] * span[1] * per_cell).sqrt().max(span[0].max(span[1]) * per_cell).max(1e-6);
        let shape = span.map(|length| (length / side) as i64 + 1);
        let mut grid = Self { low, side, shape, cells: vec![Vec::new(); (shape[0] * shape[1]) as usize] };
        for (index, (_, at)) in known.iter().enumerate() {
            let [col, row] = grid.cell_of(*at);
            grid.cells[(row * shape[0] + col) as usize].push(index as u32);
        }
        grid
    }

    fn cell_of(&self, at: [f64; 2]) -> [i64; 2] {
        [0, 1].map(|axis| (((at[axis] - self.low[axis]) / self.side) as i64).clamp(0, self.shape[axis] - 1))
    }

    /// Rings of cells are searched outwards until no nearer image can come.
    fn nearest(&self, known: &[(u32, [f64; 2])], image: u32, at: [f64; 2], most: usize) -> Vec<u32> {
        let centre = self.cell_of(at);
        let mut found: Vec<(f64, u32)> = Vec::new();
        for ring in 0..=self.shape[0].max(self.shape[1]) {
            for index in self.ring(centre, ring) {
                let (other, place) = known[index as usize];
                let [dx, dy] = [place[0] - at[0], place[1] - at[1]];
                if other != image {
                    found.push((dx * dx + dy * dy, other));
                }
            }
            found.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
            found.truncate(most);
            let reached = ring as f64 * self.side;
            if found.len() == most && found[most - 1].0 <= reached * reached {
                break;
            }
        }
        found.into_iter().map(|(_, other)| other).collect()
    }

    fn ring(&self, [col, row]: [i64; 2], ring: i64) -> impl Iterator<Item = u32> {
        let rows = (row - ring).max(0)..=(row + ring).min(self.shape[1] - 1);
        rows.flat_map(move |r| {
            let edge = (r - row).abs() == ring;
            let step = if edge || ring == 0 { 1 } else { 2 * ring };
            (col - ring..=col + ring).step_by(step as usize).filter(|c| (0..self.shape[0]).contains(c)).map(move |c| [c, r])
        })
        .flat_map(|[c, r]| self.cells[(r * self.shape[0] + c) as usize].iter().copied())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Random;

    fn images(pairs: &[ChosenPair]) -> Vec<[u32; 2]> {
        pairs.iter().map(|pair| pair.images).collect()
    }

    #[test]
    fn all_and_following_pairs_are_listed_in_order() {
        assert_eq!(images(&all_pairs(3)), [[0, 1], [0, 2], [1, 2]]);
        assert_eq!(images(&sequence_pairs(4, 2)), [[0, 1], [0, 2], [1, 2], [1, 3], [2, 3]]);
        assert!(all_pairs(1).is_empty() && sequence_pairs(5, 0).is_empty() && all_pairs(0).is_empty());
        assert_eq!(sequence_pairs(3, u32::MAX).len(), 3);
    }

    #[test]
    fn the_nearest_are_those_that_a_full_search_finds() {
        let mut random = Random::new(11);
        for (count, stretch) in [(200_usize, 1.0), (150, 0.0), (40, 1e-3)] {
            let mut at = || random.below(1_000_000) as f64 / 1000.0;
            let positions: Vec<_> = (0..count).map(|i| (i % 17 != 5).then(|| [at(), stretch * at(), at()])).collect();
            let mut wanted = Vec::new();
            for (a, from) in positions.iter().enumerate() {
                let Some(from) = from else { continue };
                let distance = |to: &[f64; 3]| (to[0] - from[0]) * (to[0] - from[0]) + (to[1] - from[1]) * (to[1] - from[1]);
                let mut list: Vec<_> = positions
                    .iter()
                    .enumerate()
                    .filter(|(b, _)| *b != a)
                    .filter_map(|(b, to)| Some((distance(&to.as_ref().copied()?), b)))
                    .collect();
                list.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
                wanted.extend(list.iter().take(6).map(|(_, b)| [a as u32, *b as u32]));
            }
            assert_eq!(near_pairs(&positions, 6).unwrap(), unique(wanted, PairRule::Near));
        }
    }

    #[test]
    fn images_at_one_place_or_without_position_are_no_trouble() {
        assert_eq!(images(&near_pairs(&[Some([1.0; 3]); 3], 1).unwrap()), [[0, 1], [0, 2]]);
        assert!(near_pairs(&[None, Some([0.0; 3])], 3).unwrap().is_empty());
        assert!(near_pairs(&[Some([f64::NAN, 0.0, 0.0])], 3).is_err());
        assert!(near_pairs(&[Some([0.0; 3]), Some([1.0; 3])], 0).unwrap().is_empty());
    }

    #[test]
    fn the_most_similar_are_taken_from_either_side() {
        let similar = vec![vec![(0, 9.0), (1, 0.5), (2, 0.5)], vec![], vec![(1, 0.1), (0, 0.9)]];
        assert_eq!(images(&alike_pairs(&similar, 1).unwrap()), [[0, 1], [0, 2]]);
        assert!(alike_pairs(&[vec![(1, 0.5)]], 1).is_err() && alike_pairs(&[vec![(0, f32::NAN)]], 1).is_err());
    }

    #[test]
    fn merged_choices_keep_the_first_rule() {
        let merged = merge_pairs(&[sequence_pairs(3, 1), all_pairs(3)]);
        assert_eq!(merged.iter().map(|pair| pair.rule).collect::<Vec<_>>(), [PairRule::Sequence, PairRule::All, PairRule::Sequence]);
    }
}
