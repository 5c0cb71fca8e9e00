//! Images that differ by a shift, a turn and a scale alone: one photograph twice, or parts of one image.

use super::frames::CommonFrame;
use super::no_orientation::NoOrientation;
use crate::Match;
use crate::math::median;

/// Matches of two halves of one scan lie within 0.7 px of a similarity, but for a tenth of them; those of two photographs of flat ground from one
/// height, whose lens is not free of distortion, within 1 px and more.
const MOST_OFF_PX: f64 = 0.8;
const SHARE: f64 = 0.9;
/// Fewer matches agree with a similarity by chance.
const LEAST_MATCHES: usize = 20;
/// Rounds in which matches that are this many medians off leave the fit.
const ROUNDS: usize = 5;
const MOST_MEDIANS: f64 = 4.0;
/// How far the frames of one photograph, saved again in another size or turned, lie apart, as a share of the diagonal.
const SAME_FRAME: f64 = 0.01;

/// What two images are of one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum OneImage {
    Twice,
    Parts,
}

impl OneImage {
    /// What the images of these sizes are of one by their matches; `None` where these ask for more than a similarity.
    pub(super) fn of(matches: &[Match], sizes: [(usize, usize); 2]) -> Option<Self> {
        let positions: Vec<[f64; 4]> = matches.iter().map(|m| [m.left_px[0], m.left_px[1], m.right_px[0], m.right_px[1]]).collect();
        if positions.len() < LEAST_MATCHES {
            return None;
        }
        let mut fit = CommonFrame::fitted(positions.iter())?;
        for _ in 0..ROUNDS {
            let middle = median(&mut positions.iter().map(|m| fit.distance_px(m)).collect::<Vec<_>>())?;
            let most = (MOST_MEDIANS * middle).max(MOST_OFF_PX);
            fit = CommonFrame::fitted(positions.iter().filter(|m| fit.distance_px(m) <= most))?;
        }
        let near = positions.iter().filter(|m| fit.distance_px(m) <= MOST_OFF_PX).count();
        (near as f64 >= SHARE * positions.len() as f64).then(|| if are_frames_equal(&fit, sizes) { Self::Twice } else { Self::Parts })
    }

    /// Why there is no orientation.
    pub(super) fn reason(self) -> NoOrientation {
        match self {
            Self::Twice => NoOrientation::OnePhoto,
            Self::Parts => NoOrientation::PartsOfOneImage,
        }
    }
}

/// Whether the frame of the left image is that of the right one.
fn are_frames_equal(fit: &CommonFrame, sizes: [(usize, usize); 2]) -> bool {
    let [left, right] = sizes.map(|(width, height)| [width as f64, height as f64]);
    let diagonal = |size: [f64; 2]| libm::hypot(size[0], size[1]);
    let [x, y] = fit.right_of(left.map(|side| 0.5 * side));
    let off = libm::hypot(x - 0.5 * right[0], y - 0.5 * right[1]) / diagonal(right);
    off <= SAME_FRAME && (fit.scale() * diagonal(left) / diagonal(right) - 1.0).abs() <= SAME_FRAME
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: (usize, usize) = (1600, 1200);

    /// Matches of points all over an image, which lie at `map` of them in the other one.
    fn matches(map: impl Fn([f64; 2]) -> [f64; 2]) -> Vec<Match> {
        let at = |k: usize| [(k * 389 % 1600) as f64, (k * 277 % 1200) as f64];
        let one = |k: usize| Match { left: k, right: Some(k), left_px: at(k), right_px: map(at(k)), measure: 0.0, fit: None };
        (0..200).map(one).collect()
    }

    #[test]
    fn one_photo_is_told_in_another_size_and_turned() {
        let noise = |[x, y]: [f64; 2]| 0.2 * libm::sin(37.0 * x + 11.0 * y);
        let saved_again = matches(|at| at.map(|v| v + noise(at)));
        let half = matches(|at| at.map(|v| 0.5 * v + noise(at)));
        let quarter_turn = matches(|[x, y]| [1200.0 - y, x]);
        for (right, size) in [(saved_again, SIZE), (half, (800, 600)), (quarter_turn, (1200, 1600))] {
            assert_eq!(OneImage::of(&right, [SIZE, size]), Some(OneImage::Twice), "{size:?}");
        }
    }

    #[test]
    fn parts_are_told_from_photographs() {
        let shifted = matches(|[x, y]| [x - 500.0, y + 1.0]);
        assert_eq!(OneImage::of(&shifted, [SIZE; 2]), Some(OneImage::Parts));
        // Some matches are wrong.
        let mut some_wrong = shifted.clone();
        some_wrong.iter_mut().take(10).for_each(|m| m.right_px[0] += 40.0);
        assert_eq!(OneImage::of(&some_wrong, [SIZE; 2]), Some(OneImage::Parts));
        // Relief, or a photo that was tilted, moves points by px.
        let relief = matches(|[x, y]| [x - 500.0 + 4.0 * libm::sin(0.01 * y), y]);
        let tilted = matches(|[x, y]| [x, y].map(|v| v / (1.0 + 2e-5 * x)));
        for photographs in [relief, tilted, shifted[..10].to_vec()] {
            assert_eq!(OneImage::of(&photographs, [SIZE; 2]), None);
        }
    }
}
