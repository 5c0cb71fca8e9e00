//! Least squares matching of images of different scale: the finer one is halved until it shows things about as large as the other.

use super::area::located;
use super::fit::LeastSquaresOptions;
use super::least_squares::LeastSquares;
use super::{Fit, MatchOptions, Verdict};
use crate::{GreyImage, GreyView, halve};

/// An image is not halved below so many windows a side.
const LEAST_WINDOWS: usize = 4;

/// Octaves by which a left image stays finer beside those that are not whole.
const KEPT: f64 = 0.25;

/// How often the left and the right image are halved before their windows are compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Halvings(pub [u32; 2]);

impl Halvings {
    /// What a deformation, which takes px of the left image to px of the right one, asks for.
    ///
    /// A finer right image is sampled at the px of the left one, which aliases what lies between. Of a finer left image the window covers few px
    /// of the right one, but a large window on the ground is less plane: on simulated towns at 1:2 half the error is left, and at 1:3 more
    /// windows fit, where the left image stays finer than the right one. An image is halved as far as it is finer along both axes: one
    /// that is foreshortened keeps its detail.
    pub fn of([[a, b], [c, d]]: [[f64; 2]; 2]) -> Self {
        // The singular values.
        let (middle, half) = (0.5 * libm::hypot(a + d, c - b), 0.5 * libm::hypot(a - d, c + b));
        let [least, most] = [(middle - half).abs(), middle + half].map(libm::log2);
        // What is no number asks for nothing.
        Self([libm::floor(-most - KEPT), libm::round(least)].map(|octaves| octaves.clamp(0.0, 16.0) as u32))
    }

    /// The less of both, for either image.
    pub fn min(self, other: Self) -> Self {
        Self([0, 1].map(|side| self.0[side].min(other.0[side])))
    }
}

/// Least squares matching of two images with all their halvings that are asked for.
pub(super) struct ScaledMatching<'a> {
    matching: LeastSquares,
    images: [Levels<'a>; 2],
}

impl<'a> ScaledMatching<'a> {
    /// `side` of the window: as for [`LeastSquares::new`].
    pub fn new(side: usize, [left, right]: [GreyView<'a>; 2]) -> Self {
        let levels = |whole| Levels { whole, halved: Vec::new(), least_side: LEAST_WINDOWS * side };
        Self { matching: LeastSquares::new(side), images: [levels(left), levels(right)] }
    }

    /// What least squares matching makes of a left position and where it starts in the right image, both with the deformation in px of the
    /// images as they are. Limits are those of the px of the images as they are halved, in which the verdict is reached.
    pub fn verdict(
        &mut self,
        left: [f64; 2],
        (start, affine): ([f64; 2], [[f64; 2]; 2]),
        halvings: Halvings,
        limits: &LeastSquaresOptions,
        options: &MatchOptions,
    ) -> Verdict {
        let [(own, own_px), (other, px)] = {
            let [left, right] = &mut self.images;
            [left.halved(halvings.0[0]), right.halved(halvings.0[1])]
        };
        let ratio = own_px / px;
        let fit = self.matching.fit(
            (own, left.map(|v| v / own_px)),
            (other, start.map(|v| v / px)),
            affine.map(|row| row.map(|v| v * ratio)),
            limits,
        );
        let found = located(fit, options);
        let whole = |fit: Fit| Fit { covariance: fit.covariance.map(|v| v * px * px), ..fit };
        Verdict { position: found.position.map(|at| at.map(|v| v * px)), fit: found.fit.map(whole), ..found }
    }
}

/// An image and its halvings, which are made when they are asked for.
struct Levels<'a> {
    whole: GreyView<'a>,
    halved: Vec<GreyImage>,
    least_side: usize,
}

impl Levels<'_> {
    /// The image halved so often, or as often as it can be, and how many px of the image one of its px has along a side.
    fn halved(&mut self, halvings: u32) -> (GreyView<'_>, f64) {
        while self.halved.len() < halvings as usize {
            let last = self.halved.last().map_or(self.whole, GreyImage::view);
            if last.width().min(last.height()) < 2 * self.least_side {
                break;
            }
            self.halved.push(halve(last));
        }
        let times = self.halved.len().min(halvings as usize);
        let view = if times == 0 { self.whole } else { self.halved[times - 1].view() };
        (view, f64::from(1u32 << times))
    }
}

#[cfg(test)]
mod tests {
    use super::super::Rule;
    use super::super::area::limits;
    use super::super::texture::Texture;
    use super::*;

    const SIZE: usize = 400;

    /// Directions of the sharp image, turned against the blurred one.
    const TURN: f64 = 0.3;

    /// An image, and the same ground with pixels so many times as large, which average detail that these cannot show.
    fn images(fine: usize) -> [GreyImage; 2] {
        let texture = Texture::new(21, 2.0, 40.0);
        let (sin, cos) = (libm::sin(TURN), libm::cos(TURN));
        let sharp = texture.image(3 * SIZE, |[x, y]| [cos * x - sin * y, sin * x + cos * y], [1.0, 0.0, 1.0], 5);
        let big = texture.image(SIZE * fine, |p| p, [1.0, 0.0, 0.0], 1);
        let view = big.view();
        let mean = |col: usize, row: usize| {
            let all = (0..fine * fine).map(|k| u32::from(view.at(col * fine + k % fine, row * fine + k / fine)));
            (all.sum::<u32>() as f64 / (fine * fine) as f64 + 0.5) as u8
        };
        [sharp, GreyImage::from_fn(SIZE, SIZE, mean).unwrap()]
    }

    /// Shares of windows that are matched and root mean square error in px of the coarser image, where the right image shows things
    /// `zoom` times as large as the left one, from starts that are off in place, scale and direction.
    fn matched([sharp, blurred]: &[GreyImage; 2], zoom: f64, halved: bool) -> (f64, f64) {
        let fine = zoom.max(1.0 / zoom);
        let (sin, cos) = (libm::sin(TURN), libm::cos(TURN));
        // `fine` px of the sharp image, turned, are one of the blurred one.
        let to_sharp = |[x, y]: [f64; 2]| [cos * x + sin * y, cos * y - sin * x].map(|v| fine * v);
        let places: Vec<[f64; 2]> = (0..200).map(|k| [150.5 + ((k * 37) % 150) as f64, 150.5 + ((k * 53) % 150) as f64]).collect();
        let (growth, off) = (1.15, 0.1);
        let linear = |s: f64, turn: f64| {
            let (sin, cos) = (s * libm::sin(turn), s * libm::cos(turn));
            [[cos, -sin], [sin, cos]]
        };
        let options = MatchOptions::default();
        let is_right_fine = zoom > 1.0;
        let images = if is_right_fine { [blurred.view(), sharp.view()] } else { [sharp.view(), blurred.view()] };
        let mut matching = ScaledMatching::new(options.template, images);
        let (mut squares, mut count) = (0.0, 0);
        for place in &places {
            let (left, truth) = if is_right_fine { (*place, to_sharp(*place)) } else { (to_sharp(*place), *place) };
            let affine = if is_right_fine { linear(growth * zoom, off - TURN) } else { linear(growth * zoom, off + TURN) };
            let unit = zoom.max(1.0);
            let start = [truth[0] + 0.6 * unit, truth[1] - 0.5 * unit];
            let halvings = if halved { Halvings::of(affine) } else { Halvings([0; 2]) };
            let found = matching.verdict(left, (start, affine), halvings, &limits(&options), &options);
            if found.rule == Rule::Matched {
                let [x, y] = found.matched().unwrap();
                squares += ((x - truth[0]) * (x - truth[0]) + (y - truth[1]) * (y - truth[1])) / (unit * unit);
                count += 1;
            }
        }
        (count as f64 / places.len() as f64, (squares / (2 * count.max(1)) as f64).sqrt())
    }

    #[test]
    fn images_of_one_and_two_and_one_and_three_are_matched_like_equal_ones() {
        for fine in [2, 3] {
            let images = images(fine);
            for zoom in [fine as f64, 1.0 / fine as f64] {
                let ((share, error), plain) = (matched(&images, zoom, true), matched(&images, zoom, false));
                assert!(share > 0.9 && error < 0.05, "{zoom}: {share} of them, {error} px; not halved {plain:?}");
                assert!(share >= plain.0, "{zoom}: {share}, not halved {plain:?}");
            }
        }
    }

    #[test]
    fn only_what_is_finer_along_both_axes_is_halved() {
        let of = |a, b, c, d| Halvings::of([[a, b], [c, d]]).0;
        assert_eq!((of(1.0, 0.0, 0.0, 1.0), of(1.3, 0.0, 0.0, 1.4), of(0.8, 0.1, -0.1, 0.72)), ([0, 0], [0, 0], [0, 0]));
        assert_eq!((of(0.0, -2.0, 2.0, 0.0), of(3.0, 0.0, 0.0, 3.0)), ([0, 1], [0, 2]));
        assert_eq!((of(0.0, -0.5, 0.5, 0.0), of(0.33, 0.0, 0.0, 0.33), of(0.2, 0.0, 0.0, 0.2)), ([0, 0], [1, 0], [2, 0]));
        assert_eq!((of(1.0, 0.0, 0.0, 0.3), of(3.0, 0.0, 0.0, 1.0)), ([0, 0], [0, 0]), "foreshortened");
        assert_eq!((of(f64::NAN, 0.0, 0.0, 1.0), of(0.0, 0.0, 0.0, 0.0), of(1e300, 0.0, 0.0, 1e300)), ([0, 0], [16, 0], [0, 16]));
        assert_eq!(Halvings([0, 2]).min(Halvings([3, 1])), Halvings([0, 1]));
    }

    #[test]
    fn small_images_are_halved_as_often_as_they_can_be() {
        let image = GreyImage::from_fn(200, 120, |col, row| (col ^ row) as u8).unwrap();
        let mut levels = Levels { whole: image.view(), halved: Vec::new(), least_side: 52 };
        let sizes = [0, 1, 5, 0].map(|halvings| {
            let (view, px) = levels.halved(halvings);
            (view.width(), px)
        });
        assert_eq!(sizes, [(200, 1.0), (100, 2.0), (100, 2.0), (200, 1.0)]);
    }
}
