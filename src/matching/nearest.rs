//! Corresponding points by their descriptors: nearest neighbours, the ratio to the second nearest, the same from both sides.

use super::blocks::{DESCRIPTOR_BYTES, Top, nearest_in_blocks};
use crate::catalogue::options;
use crate::error::refuse;
use crate::{Error, Input, Refusal};
use std::ops::Range;

options! {
    /// Options of [`nearest_matches`].
    pub struct NearestOptions in "nearest" {
        section "Nearest descriptors";

        /// A match is rejected as ambiguous unless its distance is below this share of that of the second nearest descriptor: higher keeps more,
        /// less certain matches; 1 asks only that it is nearer.
        ratio: f64 = 0.8, "Ratio", 0..=1;

        /// A match stands only where each of its two descriptors is the nearest of the other.
        mutual: bool = true, "Mutual";

        /// The Euclidean distance of two descriptors beyond which they never match: more keeps more, less certain matches.
        largest_distance: Option<f64> = None, "Maximum distance", 0..=3000, absent "any distance";
    }
}

impl NearestOptions {
    /// Whether a nearest neighbour is near enough and alone enough.
    pub(super) fn accept(&self, square: u32, second_square: Option<u32>) -> bool {
        let square = f64::from(square);
        let alone = second_square.is_none_or(|second| square < self.ratio * self.ratio * f64::from(second));
        alone && self.largest_distance.is_none_or(|largest| square <= largest * largest)
    }
}

/// The nearest of the other side's descriptors.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Nearest {
    pub index: usize,
    /// Square of the distance.
    pub square: u32,
    /// That of the second nearest; absent where there is only one descriptor.
    pub second_square: Option<u32>,
}

/// The nearest descriptors of consecutive left ones, and of all right ones among these.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NearestTable {
    /// Which left descriptors these are.
    rows: Range<usize>,
    of_left: Vec<Option<Nearest>>,
    /// Left index and square.
    of_right: Vec<Option<(usize, u32)>>,
}

/// Two descriptors that belong together.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DescriptorMatch {
    pub left: usize,
    pub right: usize,
    /// Square of the distance.
    pub square: u32,
    /// That of the second nearest right one; absent where there was none to compare with.
    pub second_square: Option<u32>,
}

/// The nearest and the second nearest right descriptor of every left one, exactly, and the nearest left one of every right one.
///
/// Descriptors are [`DESCRIPTOR_BYTES`] bytes each, one after the other; the distance is the Euclidean one. Of equally near ones the first
/// is taken. Without right descriptors, no left one has a nearest.
///
/// # Errors
/// [`Error::InvalidInput`] where the bytes are not whole descriptors.
pub fn nearest(left: &[u8], right: &[u8]) -> Result<NearestTable, Error> {
    nearest_of(left, 0..left.len() / DESCRIPTOR_BYTES, right)
}

/// As [`nearest`], for the left descriptors `rows` alone: a piece of the work. [`NearestTable::join`] puts the pieces together; the result is
/// that of the whole, whatever the pieces.
///
/// # Errors
/// As [`nearest`]; [`Error::InvalidInput`] where there are no such rows.
pub fn nearest_of(left: &[u8], rows: Range<usize>, right: &[u8]) -> Result<NearestTable, Error> {
    let (left, right) = (descriptors(Input::LeftDescriptors, left)?, descriptors(Input::RightDescriptors, right)?);
    if rows.start > rows.end || rows.end > left.len() {
        return refuse(Refusal::LeftRows { first: rows.start, end: rows.end, left: left.len() });
    }
    let (of_left, of_right) = nearest_in_blocks(left, rows.clone(), right);
    let known = |value: i32| (value > Top::NONE.best).then_some(value.unsigned_abs());
    let of_left = of_left
        .iter()
        .map(|top| known(top.best).map(|square| Nearest { index: top.index as usize, square, second_square: known(top.second) }))
        .collect();
    let of_right = of_right.iter().map(|top| known(top.best).map(|square| (top.index as usize, square))).collect();
    Ok(NearestTable { rows, of_left, of_right })
}

impl NearestTable {
    /// Which left descriptors it is about.
    pub fn rows(&self) -> Range<usize> {
        self.rows.clone()
    }

    /// For each left descriptor of [`Self::rows`] the nearest right one.
    pub fn of_left(&self) -> &[Option<Nearest>] {
        &self.of_left
    }

    /// For each right descriptor the nearest left one and the square of its distance.
    pub fn of_right(&self) -> &[Option<(usize, u32)>] {
        &self.of_right
    }

    /// Of each left descriptor index, square and second square of the nearest right one, [`u32::MAX`] where there is none: a form that
    /// crosses between workers.
    pub fn left_numbers(&self) -> Vec<u32> {
        let row =
            |nearest: &Option<Nearest>| nearest.map_or([u32::MAX; 3], |n| [n.index as u32, n.square, n.second_square.unwrap_or(u32::MAX)]);
        self.of_left.iter().flat_map(row).collect()
    }

    /// Of each right descriptor index and square of the nearest left one; as [`Self::left_numbers`].
    pub fn right_numbers(&self) -> Vec<u32> {
        self.of_right.iter().flat_map(|of| of.map_or([u32::MAX; 2], |(index, square)| [index as u32, square])).collect()
    }

    /// The table whose numbers these are; `first` is the first left descriptor.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] where they are of no table.
    pub fn from_numbers(first: usize, left: &[u32], right: &[u32]) -> Result<Self, Error> {
        let ((of_left, left_rest), (of_right, right_rest)) = (left.as_chunks::<3>(), right.as_chunks::<2>());
        let rows = first..first.saturating_add(of_left.len());
        if !left_rest.is_empty() || !right_rest.is_empty() {
            return refuse(Refusal::PieceLengths { left: left.len(), right: right.len() });
        }
        let known = |value: u32| (value != u32::MAX).then_some(value);
        let stranger =
            of_left.iter().map(|row| (row[0], of_right.len())).find(|(index, end)| known(*index).is_some_and(|k| k as usize >= *end));
        let stranger = stranger.map(|(index, _)| index).or_else(|| {
            let stray = |row: &&[u32; 2]| known(row[0]).is_some_and(|k| !rows.contains(&(k as usize)));
            of_right.iter().find(stray).map(|row| row[0])
        });
        if let Some(index) = stranger {
            return refuse(Refusal::PieceDescriptor { index });
        }
        Ok(Self {
            of_left: of_left
                .iter()
                .map(|[index, square, second]| {
                    known(*index).map(|k| Nearest { index: k as usize, square: *square, second_square: known(*second) })
                })
                .collect(),
            of_right: of_right.iter().map(|[index, square]| known(*index).map(|k| (k as usize, *square))).collect(),
            rows,
        })
    }

    /// Appends the piece of the left descriptors that follow.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] where the piece does not follow, or is of other right descriptors.
    pub fn join(&mut self, next: Self) -> Result<(), Error> {
        if next.rows.start != self.rows.end || next.of_right.len() != self.of_right.len() {
            let (row, right) = (next.rows.start, next.of_right.len());
            return refuse(Refusal::NextPiece { row, right, next_row: self.rows.end, of_right: self.of_right.len() });
        }
        self.rows.end = next.rows.end;
        self.of_left.extend(next.of_left);
        for (own, other) in self.of_right.iter_mut().zip(next.of_right) {
            let nearer = other.is_some_and(|(_, square)| own.is_none_or(|(_, least)| square < least));
            if nearer {
                *own = other;
            }
        }
        Ok(())
    }

    /// The left descriptors whose nearest right one passes the tests of `options`, in ascending order.
    ///
    /// # Errors
    /// [`Error::InvalidOption`].
    ///
    /// # Source
    /// Lowe 2004, Distinctive image features from scale-invariant keypoints, IJCV 60(2) (the ratio).
    pub fn matches(&self, options: &NearestOptions) -> Result<Vec<DescriptorMatch>, Error> {
        options.check_ranges()?;
        let all = self.rows.clone().zip(&self.of_left).filter_map(|(left, nearest)| nearest.map(|nearest| (left, nearest)));
        let accepted = all.filter(|(left, nearest)| {
            let mutual = !options.mutual || self.of_right[nearest.index].is_some_and(|(back, _)| back == *left);
            mutual && options.accept(nearest.square, nearest.second_square)
        });
        let as_match =
            |(left, n): (usize, Nearest)| DescriptorMatch { left, right: n.index, square: n.square, second_square: n.second_square };
        Ok(accepted.map(as_match).collect())
    }
}

/// Matches descriptors: [`nearest`], then the tests of `options`.
///
/// # Errors
/// As [`nearest`]; [`Error::InvalidOption`].
pub fn nearest_matches(left: &[u8], right: &[u8], options: &NearestOptions) -> Result<Vec<DescriptorMatch>, Error> {
    options.check_ranges()?;
    nearest(left, right)?.matches(options)
}

/// The descriptors of a flat array.
pub(super) fn descriptors(input: Input, bytes: &[u8]) -> Result<&[[u8; DESCRIPTOR_BYTES]], Error> {
    let (whole, rest) = bytes.as_chunks::<DESCRIPTOR_BYTES>();
    if rest.is_empty() {
        return Ok(whole);
    }
    refuse(Refusal::Bytes { input, bytes: bytes.len(), each: DESCRIPTOR_BYTES })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Random;

    fn noise(count: usize, seed: u32) -> Vec<u8> {
        let mut random = Random::new(seed);
        (0..count * DESCRIPTOR_BYTES).map(|_| random.below(200) as u8).collect()
    }

    /// The right side: the left descriptors in reverse order, each byte changed by up to 3, then strangers.
    fn seen_again(left: &[u8], strangers: usize) -> Vec<u8> {
        let mut random = Random::new(77);
        let changed = left.chunks(DESCRIPTOR_BYTES).rev().flatten().map(|v| v + random.below(4) as u8).collect::<Vec<_>>();
        [changed, noise(strangers, 78)].concat()
    }

    #[test]
    fn what_is_seen_again_is_found() {
        let left = noise(50, 1);
        let found = nearest_matches(&left, &seen_again(&left, 30), &NearestOptions::default()).unwrap();
        assert_eq!(found.len(), 50);
        assert!(found.iter().enumerate().all(|(k, m)| m.left == k && m.right == 49 - k && m.square < 128 * 9));
    }

    #[test]
    fn strangers_fail_the_ratio_and_duplicates_are_ambiguous() {
        let left = noise(20, 1);
        assert!(nearest_matches(&left, &noise(200, 9), &NearestOptions::default()).unwrap().is_empty());
        let twice = [left.clone(), left.clone()].concat();
        assert!(nearest_matches(&left, &twice, &NearestOptions::default()).unwrap().is_empty());
        let any = NearestOptions { ratio: 1.0, mutual: false, largest_distance: None };
        assert!(nearest_matches(&left, &twice, &any).unwrap().is_empty(), "an equal distance is not nearer");
    }

    #[test]
    fn only_the_nearest_of_several_left_ones_keeps_a_right_one() {
        let right = noise(10, 3);
        let mut near = right[..DESCRIPTOR_BYTES].to_vec();
        near[5] ^= 8;
        let mut nearer = near.clone();
        nearer[5] ^= 12;
        let left = [near, nearer].concat();
        let with = |mutual| nearest_matches(&left, &right, &NearestOptions { mutual, ..NearestOptions::default() }).unwrap();
        assert_eq!(with(true).iter().map(|m| (m.left, m.right, m.square)).collect::<Vec<_>>(), [(1, 0, 16)]);
        assert_eq!(with(false).len(), 2);
        let within =
            |largest_distance| NearestOptions { mutual: false, largest_distance: Some(largest_distance), ..NearestOptions::default() };
        assert_eq!(nearest_matches(&left, &right, &within(5.0)).unwrap().len(), 1);
        assert_eq!(nearest_matches(&left, &right, &within(8.0)).unwrap().len(), 2);
    }

    #[test]
    fn pieces_join_to_the_whole() {
        let left = noise(45, 5);
        let right = [seen_again(&left, 3), left.clone()].concat();
        let whole = nearest(&left, &right).unwrap();
        for cuts in [vec![0, 45], vec![0, 7, 7, 30, 45], vec![0, 1, 2, 44, 45]] {
            let mut pieces = cuts.windows(2).map(|cut| nearest_of(&left, cut[0]..cut[1], &right).unwrap());
            let mut joined = pieces.next().unwrap();
            pieces.for_each(|piece| joined.join(piece).unwrap());
            assert_eq!(joined, whole);
        }
        assert!(whole.clone().join(whole.clone()).is_err());
        let piece = nearest_of(&left, 7..30, &right).unwrap();
        let again = |first| NearestTable::from_numbers(first, &piece.left_numbers(), &piece.right_numbers());
        assert_eq!(again(7).unwrap(), piece);
        assert!(again(3).is_err(), "its right descriptors know left ones beyond it");
        assert!(NearestTable::from_numbers(0, &[5, 1, 2], &[0, 1]).is_err() && NearestTable::from_numbers(0, &[0, 1], &[0, 1]).is_err());
        assert_eq!(nearest(&left, &[]).unwrap().left_numbers()[..3], [u32::MAX; 3]);
    }

    #[test]
    fn sides_without_descriptors_have_no_matches_and_halves_of_descriptors_are_refused() {
        let some = noise(3, 1);
        for (left, right) in [(&some[..], &[][..]), (&[], &some), (&[], &[])] {
            assert!(nearest_matches(left, right, &NearestOptions::default()).unwrap().is_empty());
        }
        assert_eq!(nearest_matches(&some[..128], &some[..128], &NearestOptions::default()).unwrap()[0].second_square, None);
        assert!(matches!(
            nearest(&some[1..], &some),
            Err(Error::InvalidInput { refusal: Refusal::Bytes { input: Input::LeftDescriptors, .. } })
        ));
        assert!(matches!(
            nearest(&some, &some[..130]),
            Err(Error::InvalidInput { refusal: Refusal::Bytes { input: Input::RightDescriptors, .. } })
        ));
        assert!(matches!(nearest_of(&some, 1..4, &some), Err(Error::InvalidInput { refusal: Refusal::LeftRows { .. } })));
        let wrong = NearestOptions { ratio: f64::NAN, ..NearestOptions::default() };
        assert!(matches!(nearest_matches(&some, &some, &wrong), Err(Error::InvalidOption { field: "nearest.ratio", .. })));
    }
}
