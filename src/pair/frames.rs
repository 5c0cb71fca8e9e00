//! What is equal in both frames: film border, fiducial marks, data strip. It matches by itself, and may outnumber what the pictures share.

use crate::math::Random;

/// Quarter turns by which scans of two frames may differ.
const TURNS: usize = 4;
/// How far the middle of one scan may lie from that of the other on the film, as a share of the longer side.
const LARGEST_SHIFT: f64 = 0.08;
/// How much one scan may be turned and enlarged against the other, beside the quarter turns.
const LARGEST_DISTORTION: f64 = 0.03;
/// Matches that agree lie this near to the same place of the frame, px.
const TOLERANCE_PX: f64 = 2.5;
/// The margin of a frame, as a share of the longer side; most of what is equal lies in it, in nearly all quarters of the image.
const MARGIN: f64 = 0.15;
/// And as a share of the shorter side at most: what a frame surrounds is as wide as its margins. A strip would be nothing but margin.
const MOST_MARGIN: f64 = 0.25;
const LEAST_IN_MARGIN: f64 = 0.8;
const LEAST_QUARTERS: usize = 3;
/// Fewest matches that agree.
const LEAST_MATCHES: usize = 8;
/// Of the matches in the middle, the share that may agree by chance, or as marks of a grid. If more do, the pictures themselves are equal.
const LARGEST_IN_MIDDLE: f64 = 0.1;
/// Samples of two matches.
const SAMPLES: usize = 300;

/// How the frame of the right image lies to that of the left one: a similarity, q = turn·p + shift in complex numbers, px.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct CommonFrame {
    turn: [f64; 2],
    shift: [f64; 2],
}

fn times([a, b]: [f64; 2], [c, d]: [f64; 2]) -> [f64; 2] {
    [a * c - b * d, a * d + b * c]
}

fn minus([a, b]: [f64; 2], [c, d]: [f64; 2]) -> [f64; 2] {
    [a - c, b - d]
}

fn length([a, b]: [f64; 2]) -> f64 {
    (a * a + b * b).sqrt()
}

impl CommonFrame {
    /// The frame that matches `[x left, y left, x right, y right]` in px of images of these sizes show, if there is one.
    pub(super) fn find(matches: &[[f64; 4]], sizes: [(usize, usize); 2], seed: u32) -> Option<Self> {
        (0..TURNS).filter_map(|turn| Self::turned(turn, matches, sizes, seed)).max_by_key(|frame| frame.agreeing(matches).count())
    }

    /// Whether a match lies at the same place of both frames.
    pub(super) fn holds(&self, m: &[f64; 4]) -> bool {
        let place = times(self.turn, [m[0], m[1]]);
        length(minus([m[2], m[3]], [place[0] + self.shift[0], place[1] + self.shift[1]])) <= TOLERANCE_PX
    }

    fn agreeing<'a>(&self, matches: &'a [[f64; 4]]) -> impl Iterator<Item = &'a [f64; 4]> + Clone + use<'a> {
        let frame = *self;
        matches.iter().filter(move |m| frame.holds(m))
    }

    fn turned(turn: usize, matches: &[[f64; 4]], sizes: [(usize, usize); 2], seed: u32) -> Option<Self> {
        let quarter = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]][turn];
        let [middle, other] = sizes.map(|(width, height)| [0.5 * width as f64, 0.5 * height as f64]);
        let side = sizes.iter().fold(0, |side, (width, height)| side.max(*width).max(*height)) as f64;
        let shift_of = |m: &[f64; 4]| minus(minus([m[2], m[3]], other), times(quarter, minus([m[0], m[1]], middle)));
        let near: Vec<[f64; 4]> = matches.iter().filter(|m| length(shift_of(m)) <= LARGEST_SHIFT * side).copied().collect();
        if near.len() < LEAST_MATCHES {
            return None;
        }
        let mut random = Random::new(seed);
        let mut sample = || {
            let [a, b] = [0, 1].map(|_| near[random.below(near.len())]);
            Self::through(&a, &b).filter(|frame| length(minus(frame.turn, quarter)) <= LARGEST_DISTORTION)
        };
        let best = (0..SAMPLES).filter_map(|_| sample()).max_by_key(|frame| frame.agreeing(&near).count())?;
        let frame = Self::fitted(best.agreeing(&near)).filter(|frame| frame.agreeing(&near).count() >= LEAST_MATCHES)?;
        frame.is_frame(matches, sizes[0], side).then_some(frame)
    }

    fn through(a: &[f64; 4], b: &[f64; 4]) -> Option<Self> {
        let (left, right) = (minus([b[0], b[1]], [a[0], a[1]]), minus([b[2], b[3]], [a[2], a[3]]));
        let square = left[0] * left[0] + left[1] * left[1];
        // Nearer ones do not tell the turn.
        (square >= 100.0 * 100.0).then(|| {
            let turn = times(right, [left[0], -left[1]]).map(|v| v / square);
            Self { turn, shift: minus([a[2], a[3]], times(turn, [a[0], a[1]])) }
        })
    }

    /// By least squares.
    fn fitted<'a>(matches: impl Iterator<Item = &'a [f64; 4]> + Clone) -> Option<Self> {
        let count = matches.clone().count() as f64;
        let mean = [0, 1, 2, 3].map(|k| matches.clone().map(|m| m[k]).sum::<f64>() / count);
        let (mut product, mut square) = ([0.0; 2], 0.0);
        for m in matches {
            let (left, right) = (minus([m[0], m[1]], [mean[0], mean[1]]), minus([m[2], m[3]], [mean[2], mean[3]]));
            let own = times(right, [left[0], -left[1]]);
            product = [product[0] + own[0], product[1] + own[1]];
            square += left[0] * left[0] + left[1] * left[1];
        }
        (square > 0.0).then(|| {
            let turn = product.map(|v| v / square);
            Self { turn, shift: minus([mean[2], mean[3]], times(turn, [mean[0], mean[1]])) }
        })
    }

    /// Whether what agrees surrounds the picture rather than being it.
    fn is_frame(&self, matches: &[[f64; 4]], (width, height): (usize, usize), side: f64) -> bool {
        let (width, height) = (width as f64, height as f64);
        let margin = (MARGIN * side).min(MOST_MARGIN * width.min(height));
        let is_marginal = |m: &&[f64; 4]| m[0].min(m[1]).min(width - m[0]).min(height - m[1]) < margin;
        let (marginal, inner): (Vec<_>, Vec<_>) = self.agreeing(matches).partition(is_marginal);
        let quarter = |m: &[f64; 4]| 2 * usize::from(2.0 * m[0] > width) + usize::from(2.0 * m[1] > height);
        let quarters = (0..4).filter(|k| marginal.iter().filter(|m| quarter(m) == *k).count() >= 2).count();
        let middle = matches.iter().filter(|m| !is_marginal(m)).count();
        marginal.len() as f64 >= LEAST_IN_MARGIN * (marginal.len() + inner.len()) as f64
            && quarters >= LEAST_QUARTERS
            && inner.len() as f64 <= LARGEST_IN_MIDDLE * middle as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZES: [(usize, usize); 2] = [(2000, 1900), (1960, 1920)];

    /// Matches of pictures that overlap by two thirds, over relief.
    fn pictures(random: &mut Random) -> Vec<[f64; 4]> {
        let mut uniform = |most: f64| most * random.below(100_000) as f64 * 1e-5;
        (0..400)
            .map(|_| {
                let (x, y) = (700.0 + uniform(1200.0), 100.0 + uniform(1700.0));
                [x, y, x - 600.0 + uniform(40.0), y + uniform(1.0)]
            })
            .collect()
    }

    /// Matches of a border: along all sides, the right scan turned by half a turn and a little more, and shifted.
    fn border(random: &mut Random, half_turn: bool) -> Vec<[f64; 4]> {
        let mut uniform = |most: f64| most * random.below(100_000) as f64 * 1e-5;
        (0..60)
            .map(|k| {
                let along = uniform(1800.0);
                let (x, y) = [(40.0, along), (1960.0, along), (along, 30.0), (along, 1870.0)][k % 4];
                let (u, v) = (x - 1000.0, y - 950.0);
                let (u, v) = if half_turn { (-u, -v) } else { (u, v) };
                [x, y, 980.0 + u - 0.004 * v + 35.0, 960.0 + v + 0.004 * u - 20.0]
            })
            .collect()
    }

    #[test]
    fn a_border_is_found_and_the_pictures_are_left() {
        let mut random = Random::new(3);
        for half_turn in [false, true] {
            let (pictures, border) = (pictures(&mut random), border(&mut random, half_turn));
            let frame = CommonFrame::find(&[pictures.clone(), border.clone()].concat(), SIZES, 1).unwrap();
            assert!(border.iter().all(|m| frame.holds(m)));
            assert!(pictures.iter().filter(|m| frame.holds(m)).count() < 4);
        }
    }

    #[test]
    fn equal_pictures_and_pictures_alone_have_no_frame() {
        let mut random = Random::new(4);
        let pictures = pictures(&mut random);
        assert_eq!(CommonFrame::find(&pictures, SIZES, 1), None);
        let itself: Vec<[f64; 4]> = pictures.iter().map(|m| [m[0], m[1], m[0], m[1]]).collect();
        assert_eq!(CommonFrame::find(&itself, SIZES, 1), None);
        let everywhere = [itself, border(&mut random, false)].concat();
        assert_eq!(CommonFrame::find(&everywhere, SIZES, 1), None);
        assert_eq!(CommonFrame::find(&[], SIZES, 1), None);
    }

    #[test]
    fn a_narrow_strip_is_not_all_frame() {
        let mut random = Random::new(6);
        let mut uniform = |most: f64| most * random.below(100_000) as f64 * 1e-5;
        let strip: Vec<[f64; 4]> = (0..800).map(|_| [uniform(40_000.0), uniform(60.0)]).map(|[x, y]| [x, y, x - 20.0, y]).collect();
        assert_eq!(CommonFrame::find(&strip, [(40_000, 60); 2], 1), None);
    }

    #[test]
    fn one_side_alone_is_no_frame() {
        let mut random = Random::new(5);
        let horizon: Vec<[f64; 4]> = (0..50).map(|k| [40.0 * k as f64, 30.0, 40.0 * k as f64 - 5.0, 31.0]).collect();
        assert_eq!(CommonFrame::find(&[pictures(&mut random), horizon].concat(), SIZES, 1), None);
    }
}
