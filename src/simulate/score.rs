//! Scores matches by the known answer of a simulated pair.

use crate::error::refuse;
use crate::{Error, Refusal};
use serde::{Deserialize, Serialize};
use std::collections::HashSet;

/// A match is right when its right point lies this near to where the surface is seen, in px.
pub const RIGHT_WITHIN_PX: f64 = 1.5;

/// The known answer: where each left pixel's surface is seen, as [`Sample`](super::Sample) gives it.
#[derive(Debug, Clone, Copy)]
pub struct DenseTruth<'a> {
    /// Row by row, `[x, y]` in px of the right image; NaN where it is hidden or outside.
    pub right_position: &'a [[f32; 2]],
    pub left_width: usize,
    pub left_height: usize,
    pub right_width: usize,
    pub right_height: usize,
}

/// How right a match is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Rightness {
    /// Nowhere near.
    Wrong,
    /// Within 1.5 px of where the surface at one of the 8 neighbours of the left pixel is seen: right at an edge, where the surface jumps.
    AtEdge,
    /// Within 1.5 px of where the surface at the left pixel is seen.
    Strict,
}

/// The score of matches.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MatchScore {
    /// One for each match.
    pub rightness: Vec<Rightness>,
    /// Matches that are strictly right.
    pub strict: usize,
    /// Matches that are right, strictly or at an edge.
    pub right: usize,
    /// Left points whose surface is seen in the right image, but that have no right match.
    pub missed: usize,
}

/// Scores matches `[x_left, y_left, x_right, y_right]` in px of left points `[x, y]`.
///
/// The left pixel is the one whose centre is nearest; where the point lies beside that centre, so does the place where it is expected.
///
/// # Errors
/// [`Error::InvalidInput`] for a truth that is not of the left image's size.
pub fn score_matches(matches: &[[f64; 4]], left_points: &[[f64; 2]], truth: &DenseTruth<'_>) -> Result<MatchScore, Error> {
    if truth.left_width.checked_mul(truth.left_height) != Some(truth.right_position.len()) || truth.right_position.is_empty() {
        let (positions, width, height) = (truth.right_position.len(), truth.left_width, truth.left_height);
        return refuse(Refusal::TruthSize { positions, width, height });
    }
    let rightness: Vec<Rightness> = matches.iter().map(|m| truth.rightness(m)).collect();
    let of = |wanted| rightness.iter().filter(|r| **r == wanted).count();
    let (strict, at_edge) = (of(Rightness::Strict), of(Rightness::AtEdge));
    let key = |[x, y]: [f64; 2]| [x.to_bits(), y.to_bits()];
    let found: HashSet<_> =
        matches.iter().zip(&rightness).filter(|(_, r)| **r != Rightness::Wrong).map(|(m, _)| key([m[0], m[1]])).collect();
    let missed = left_points.iter().filter(|point| truth.is_seen(**point) && !found.contains(&key(**point))).count();
    Ok(MatchScore { rightness, strict, right: strict + at_edge, missed })
}

impl DenseTruth<'_> {
    fn rightness(&self, &[xl, yl, xr, yr]: &[f64; 4]) -> Rightness {
        let Some([col, row]) = self.pixel([xl, yl]) else { return Rightness::Wrong };
        let beside = [xl - 0.5 - col as f64, yl - 0.5 - row as f64];
        let near = |dc: i64, dr: i64| {
            let [x, y] = self.at(col + dc, row + dr);
            let (dx, dy) = (x + beside[0] - xr, y + beside[1] - yr);
            // Not a number where it is hidden, and that is not near.
            (dx * dx + dy * dy).sqrt() <= RIGHT_WITHIN_PX
        };
        if near(0, 0) {
            return Rightness::Strict;
        }
        let around = (-1..=1).any(|dr| (-1..=1).any(|dc| near(dc, dr)));
        if around { Rightness::AtEdge } else { Rightness::Wrong }
    }

    /// Whether the surface at a left point is seen in the right image.
    fn is_seen(&self, point: [f64; 2]) -> bool {
        let Some([col, row]) = self.pixel(point) else { return false };
        let [x, y] = self.at(col, row);
        x >= 0.0 && y >= 0.0 && x < self.right_width as f64 && y < self.right_height as f64
    }

    /// The pixel whose centre is nearest to a position, halves to the even one; `None` far outside the image.
    fn pixel(&self, position: [f64; 2]) -> Option<[i64; 2]> {
        let [col, row] = position.map(|v| libm::rint(v - 0.5));
        let within = |v: f64, length: usize| v >= -1.0 && v <= length as f64;
        (within(col, self.left_width) && within(row, self.left_height)).then_some([col as i64, row as i64])
    }

    /// The truth at a pixel; at the border's where it lies outside.
    fn at(&self, col: i64, row: i64) -> [f64; 2] {
        let (col, row) = (col.clamp(0, self.left_width as i64 - 1) as usize, row.clamp(0, self.left_height as i64 - 1) as usize);
        self.right_position[row * self.left_width + col].map(f64::from)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A step: the left half is seen 2 px to the right, the right half 6 px; the last column is hidden.
    fn step() -> Vec<[f32; 2]> {
        let seen = |k: usize| {
            let (col, row) = ((k % 10) as f32, (k / 10) as f32);
            if k % 10 == 9 { [f32::NAN; 2] } else { [col + 0.5 + if col < 5.0 { 2.0 } else { 6.0 }, row + 0.5] }
        };
        (0..100).map(seen).collect()
    }

    fn score(matches: &[[f64; 4]], points: &[[f64; 2]]) -> MatchScore {
        let positions = step();
        let truth = DenseTruth { right_position: &positions, left_width: 10, left_height: 10, right_width: 14, right_height: 10 };
        score_matches(matches, points, &truth).unwrap()
    }

    #[test]
    fn matches_are_right_strictly_at_edges_or_not() {
        use Rightness::{AtEdge, Strict, Wrong};
        let of = |m: [f64; 4]| score(&[m], &[]).rightness[0];
        assert_eq!(of([2.5, 5.5, 4.5, 5.5]), Strict);
        assert_eq!(of([2.5, 5.5, 5.9, 5.5]), Strict);
        assert_eq!(of([2.5, 5.5, 5.5, 6.7]), AtEdge, "the neighbour's surface is a pixel further");
        assert_eq!(of([2.5, 5.5, 8.5, 5.5]), Wrong);
        assert_eq!(of([4.5, 5.5, 11.5, 5.5]), AtEdge, "the neighbour lies behind the step");
        assert_eq!(of([9.5, 5.5, 11.5, 5.5]), Wrong, "hidden, and the neighbour's place is 3 px away");
        assert_eq!(of([2.9, 5.2, 4.9, 5.2]), Strict);
        assert_eq!(of([f64::NAN, 5.5, 4.5, 5.5]), Wrong);
        assert_eq!(of([1e300, 5.5, 4.5, 5.5]), Wrong);
    }

    #[test]
    fn points_that_could_have_been_matched_are_missed() {
        let points = [[2.5, 5.5], [3.5, 5.5], [9.5, 5.5], [8.5, 2.5]];
        let score = score(&[[2.5, 5.5, 4.5, 5.5], [3.5, 5.5, 1.5, 1.5]], &points);
        // The second is matched wrongly, the third is hidden, the fourth lies outside the right image.
        assert_eq!((score.strict, score.right, score.missed), (1, 1, 1));
    }

    #[test]
    fn a_truth_of_another_size_is_refused() {
        let truth = DenseTruth { right_position: &[[0.0; 2]; 5], left_width: 2, left_height: 3, right_width: 2, right_height: 3 };
        assert_eq!(score_matches(&[], &[], &truth).unwrap_err().code(), "invalid-input");
    }
}
