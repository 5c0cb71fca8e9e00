//! Images of one: a photograph twice, or an image and a part of it.

use super::no_orientation::NoOrientation;
use super::one_map::{Evidence, OneMap, length};

/// Up to this evidence for another map than a similarity, images may be of one: F of 14 and 100 degrees of freedom, those of 60 matches, is below 3.6 in
/// 9,999 of 10,000 cases, of many below 3.1, and narrow windows of copies reach 3.9.
const MOST_OF_PERHAPS: Evidence = Evidence { variance_ratio: 5.0, correlation: 0.3 };
/// And up to this they are refused: of two photographs of level ground a narrow strip may have as little.
const MOST_OF_ONE: Evidence = Evidence { variance_ratio: 3.0, correlation: 0.2 };
/// How far the frames of one photograph, saved again in another size or turned, lie apart, and how far that of a part reaches beyond the image, as a
/// share of the diagonal.
const SAME_FRAME: f64 = 0.01;
/// The frame of a part is filled with matches: of its cells this share, where the others may show sky or water.
const CELLS: usize = 4;
const LEAST_FILLED: f64 = 0.6;
/// A part has as many px as its place in the image, or fewer: a photograph from nearer by has more.
const MOST_FINER: f64 = 1.05;

/// What two images are of one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OneImage {
    /// One photo twice.
    Twice,
    /// One image lies in the other.
    Parts,
}

impl OneImage {
    /// What images of these sizes are of one by their matches `[x left, y left, x right, y right]`, px; `None` where these ask for more than a
    /// similarity, or are too few to tell, and where two photographs may have the same: see `may_be_one`.
    pub fn of(matches: &[[f64; 4]], sizes: [(usize, usize); 2]) -> Option<Self> {
        let map = OneMap::of(matches).filter(|map| map.evidence.is_within(MOST_OF_ONE))?;
        if are_one_frame(&map, sizes) {
            return Some(Self::Twice);
        }
        (0..2).any(|side| is_part(&map, side, sizes) && is_filled(&map, side, sizes)).then_some(Self::Parts)
    }

    /// Why there is no orientation.
    pub fn reason(self) -> NoOrientation {
        match self {
            Self::Twice => NoOrientation::OnePhoto,
            Self::Parts => NoOrientation::PartsOfOneImage,
        }
    }
}

/// Whether matches leave open that their images are parts of one, as those of level photographs of flat ground do.
pub(super) fn may_be_one(matches: &[[f64; 4]]) -> bool {
    OneMap::of(matches).is_some_and(|map| map.evidence.is_within(MOST_OF_PERHAPS))
}

impl Evidence {
    fn is_within(self, most: Self) -> bool {
        self.variance_ratio <= most.variance_ratio && self.correlation <= most.correlation
    }
}

/// Whether the map takes the frame of the left image to that of the right one.
fn are_one_frame(map: &OneMap, sizes: [(usize, usize); 2]) -> bool {
    let [left, right] = [0, 1].map(|side| map.reduced(side, sizes[side]));
    let [x, y] = map.place(0, left.map(|side| 0.5 * side));
    let off = length([x - 0.5 * right[0], y - 0.5 * right[1]]) / length(right);
    off <= SAME_FRAME && (length(left) / length(right) - 1.0).abs() <= SAME_FRAME
}

/// Whether an image (0 left, 1 right) lies in the other one, as a part that was cut out of it.
fn is_part(map: &OneMap, side: usize, sizes: [(usize, usize); 2]) -> bool {
    let ([width, height], other) = (map.reduced(side, sizes[side]), map.reduced(1 - side, sizes[1 - side]));
    let beyond = SAME_FRAME * length(other);
    let is_in = |at: [f64; 2]| {
        let place = map.place(side, at);
        (0..2).all(|k| (-beyond..=other[k] + beyond).contains(&place[k]))
    };
    let finer = if side == 0 { 1.0 / map.scale() } else { map.scale() };
    finer <= MOST_FINER && [[0.0, 0.0], [width, 0.0], [0.0, height], [width, height]].into_iter().all(is_in)
}

/// Whether matches lie all over an image.
fn is_filled(map: &OneMap, side: usize, sizes: [(usize, usize); 2]) -> bool {
    let size = map.reduced(side, sizes[side]);
    let mut filled = [[false; CELLS]; CELLS];
    for at in map.positions(side) {
        let [col, row] = [0, 1].map(|k| ((at[k] / size[k] * CELLS as f64).max(0.0) as usize).min(CELLS - 1));
        filled[row][col] = true;
    }
    filled.as_flattened().iter().filter(|is| **is).count() as f64 >= LEAST_FILLED * (CELLS * CELLS) as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Random;

    const SIZE: (usize, usize) = (1600, 1200);

    /// Matches of points all over a part of an image, which lie at `map` of them in the other one but for errors of this many px.
    fn matches_in(size: [f64; 2], noise_px: f64, map: impl Fn([f64; 2]) -> [f64; 2]) -> Vec<[f64; 4]> {
        let mut random = Random::new(7);
        let mut uniform = |most: f64| most * random.below(100_000) as f64 * 1e-5;
        (0..400)
            .map(|_| {
                let at = size.map(&mut uniform);
                let [x, y] = map(at).map(|v| v + uniform(2.0 * noise_px) - noise_px);
                [at[0], at[1], x, y]
            })
            .collect()
    }

    fn matches(noise_px: f64, map: impl Fn([f64; 2]) -> [f64; 2]) -> Vec<[f64; 4]> {
        matches_in([1600.0, 1200.0], noise_px, map)
    }

    /// The same with left and right exchanged.
    fn exchanged(matches: &[[f64; 4]]) -> Vec<[f64; 4]> {
        matches.iter().map(|[x, y, u, v]| [*u, *v, *x, *y]).collect()
    }

    #[test]
    fn one_photo_is_found_in_another_size_and_turned() {
        let exact = matches(0.0, |at| at);
        let saved_again = matches(0.5, |at| at);
        // Its sides are 801 x 600 px.
        let half = matches(0.1, |[x, y]| [801.0 / 1600.0 * x, 0.5 * y]);
        let quarter_turn = matches(0.1, |[x, y]| [1200.0 - y, x]);
        for (right, size) in [(exact, SIZE), (saved_again, SIZE), (half, (801, 600)), (quarter_turn, (1200, 1600))] {
            assert_eq!(OneImage::of(&right, [SIZE, size]), Some(OneImage::Twice), "{size:?}");
            assert_eq!(OneImage::of(&exchanged(&right), [size, SIZE]), Some(OneImage::Twice), "{size:?}, exchanged");
        }
        // Half of it is sky.
        let half_sky = matches_in([1600.0, 500.0], 0.2, |[x, y]| [x, y]);
        assert_eq!(OneImage::of(&half_sky, [SIZE; 2]), Some(OneImage::Twice));
    }

    #[test]
    fn a_part_is_found_whichever_image_it_is_of() {
        let [width, height] = [1000.0, 800.0];
        let part = matches_in([width, height], 0.2, |[x, y]| [x + 500.0, y + 300.0]);
        // Some matches are wrong.
        let mut some_wrong = part.clone();
        some_wrong.iter_mut().take(20).for_each(|m| m[2] += 40.0);
        let reduced: Vec<[f64; 4]> = part.iter().map(|m| [0.5 * m[0], 0.5 * m[1], m[2], m[3]]).collect();
        for (matches, size) in [(part, (1000, 800)), (some_wrong, (1000, 800)), (reduced, (500, 400))] {
            assert_eq!(OneImage::of(&matches, [size, SIZE]), Some(OneImage::Parts), "{size:?}");
            assert_eq!(OneImage::of(&exchanged(&matches), [SIZE, size]), Some(OneImage::Parts), "{size:?}, exchanged");
        }
    }

    #[test]
    fn what_two_photographs_may_have_is_no_proof() {
        let some = |matches: &[[f64; 4]], sizes| (OneImage::of(matches, sizes), may_be_one(matches));
        // Halves of one scan have a strip in common, as two level photos over flat ground may have.
        let strip =
            matches_in([80.0, 1200.0], 0.5, |[x, y]| [x, y]).into_iter().map(|[x, y, u, v]| [x + 1520.0, y, u, v]).collect::<Vec<_>>();
        assert_eq!(some(&strip, [SIZE; 2]), (None, true));
        // Matches in a corner do not fill the part.
        let corner = matches_in([400.0, 300.0], 0.2, |[x, y]| [x + 500.0, y + 300.0]);
        assert_eq!(some(&corner, [(1000, 800), SIZE]), (None, true));
        // A photo from nearer by has more px of the same ground than the image around it.
        let nearer = matches(0.2, |[x, y]| [0.5 * x + 300.0, 0.5 * y + 200.0]);
        assert_eq!(some(&nearer, [SIZE; 2]), (None, true));
    }

    #[test]
    fn photographs_are_told_from_parts() {
        // Relief, a tilt or the lens of another photo move neighbours together, by less than a pixel too.
        let relief = matches(0.2, |[x, y]| [x - 500.0 + 0.4 * libm::sin(0.01 * y), y]);
        let tilted = matches(0.2, |[x, y]| [x, y].map(|v| v / (1.0 + 2e-6 * x)));
        let lens = matches(0.2, |[x, y]| [x - 500.0 + 0.4 * libm::sin(0.005 * x), y]);
        let few = matches(0.2, |[x, y]| [x - 500.0, y])[..30].to_vec();
        for photographs in [relief, tilted, lens, few] {
            assert_eq!((OneImage::of(&photographs, [SIZE; 2]), may_be_one(&photographs)), (None, false));
        }
    }

    #[test]
    fn a_slow_change_that_neighbours_hardly_share_is_of_photographs() {
        // 0.1 px of a tilt under errors of 0.3 px: neighbours correlate by less than a fifth.
        let tilted = matches(0.5, |[x, y]| [x + 0.14 * (x / 800.0 - 1.0) * (x / 800.0 - 1.0), y]);
        let map = OneMap::of(&tilted).unwrap();
        assert!(map.evidence.correlation < MOST_OF_ONE.correlation, "{:?}", map.evidence);
        let strong = matches(0.5, |[x, y]| [x + 0.4 * (x / 800.0 - 1.0) * (x / 800.0 - 1.0), y]);
        let map = OneMap::of(&strong).unwrap();
        assert!(map.evidence.variance_ratio > MOST_OF_PERHAPS.variance_ratio, "{:?}", map.evidence);
        assert!(!may_be_one(&strong));
    }
}
