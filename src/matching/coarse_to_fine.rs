//! Least-squares matching from a poor start: cross-correlation on a small image, then level by level down to the whole one.

use super::cross_correlation::CrossCorrelation;
use super::fit::{Fit, LeastSquaresOptions, Refusal};
use super::least_squares::LeastSquares;
use super::search_area::SearchArea;
use crate::GreyImage;

/// Px that the position may move on a level below the coarsest: what one pixel of the level above leaves open, and some more.
const REFINEMENT: f64 = 3.0;
/// Correlation that is asked for above the whole images, where relief and reduction cost some.
const LEAST_ON_REDUCED: f64 = 0.5;
/// Reach in px of a level at least: on smaller ones a window shows little texture and much relief.
const LEAST_REACH: f64 = 4.0;
const UNIT: [[f64; 2]; 2] = [[1.0, 0.0], [0.0, 1.0]];

/// Matching through two pyramids, with windows of one side on all levels; it keeps its tables from window to window.
pub(crate) struct CoarseToFine {
    correlation: CrossCorrelation,
    least_squares: LeastSquares,
}

impl CoarseToFine {
    /// `side` of the window is odd, 5..=63.
    ///
    /// # Panics
    /// Where it is not.
    pub fn new(side: usize) -> Self {
        Self { correlation: CrossCorrelation::new(side), least_squares: LeastSquares::new(side) }
    }

    /// Finds the window about a left position in the right image, from a start that is off by up to `reach_px`.
    ///
    /// `left` and `right` are the images from the whole one to the smallest, each half as large as the one before ([`crate::halve`]). The
    /// search begins on the smallest level of both on which `reach_px` is 4 px or more: there all whole-pixel positions
    /// are correlated. Where the windows leave the images of that level, or no peak lies inside the area, the next larger one is searched. On every level down to the whole image the position and the deformation of the level above
    /// are then improved; a level that refuses leaves them as they were. Only the whole images decide. `options.farthest_px` counts from
    /// the place that the levels above found.
    ///
    /// # Errors
    /// [`Refusal`], of the whole images; [`Refusal::LowCorrelation`] where the search has no peak inside its area.
    pub fn through_pyramid(
        &mut self,
        (left, left_position): (&[GreyImage], [f64; 2]),
        (right, start): (&[GreyImage], [f64; 2]),
        reach_px: f64,
        options: &LeastSquaresOptions,
    ) -> Result<Fit, Refusal> {
        if !left_position.iter().chain(&start).all(|v| v.is_finite()) || left.is_empty() || right.is_empty() {
            return Err(Refusal::LeftImage);
        }
        // As deep as the reach needs it: what is smaller shows less texture.
        let needed = (0..left.len().min(right.len())).rfind(|level| reach_px >= LEAST_REACH * scale(*level)).unwrap_or(0);
        let mut searched = false;
        let found = (0..=needed).rev().find_map(|level| {
            let peak = self.search(level, (left, left_position), (right, start), reach_px)?;
            searched = true;
            Some((level, peak?))
        });
        let Some((coarsest, mut position)) = found else {
            return Err(if searched { Refusal::LowCorrelation } else { Refusal::LeftImage });
        };
        let mut affine = UNIT;
        let lenient =
            LeastSquaresOptions { farthest_px: REFINEMENT, least_correlation: LEAST_ON_REDUCED.min(options.least_correlation), ..*options };
        for level in (1..=coarsest).rev() {
            let on_level = |p: [f64; 2]| p.map(|v| v / scale(level));
            let windows = ((left[level].view(), on_level(left_position)), (right[level].view(), on_level(position)));
            if let Ok(fit) = self.least_squares.fit(windows.0, windows.1, affine, &lenient) {
                (position, affine) = (fit.position.map(|v| v * scale(level)), fit.affine);
            }
        }
        self.least_squares.fit((left[0].view(), left_position), (right[0].view(), position), affine, options)
    }

    /// The right position in px of the whole image that correlates best on a level, where it lies inside the area that is searched; `None`
    /// where there is nothing to search.
    fn search(
        &mut self,
        level: usize,
        (left, left_position): (&[GreyImage], [f64; 2]),
        (right, start): (&[GreyImage], [f64; 2]),
        reach_px: f64,
    ) -> Option<Option<[f64; 2]>> {
        let on_level = |p: [f64; 2]| p.map(|v| v / scale(level));
        let (place, expected) = (on_level(left_position), on_level(start));
        if place.iter().any(|v| *v < 0.0) {
            return None;
        }
        let reach = (libm::ceil(reach_px / scale(level)) as usize).saturating_add(1);
        let area = SearchArea { centre: expected.map(|v| libm::floor(v) as i64), reach: [reach; 2], columns: None };
        let pixel = place.map(|v| v as usize);
        let surface = self.correlation.search(left[level].view(), pixel, right[level].view(), &area)?;
        let peak = surface.peak().filter(|peak| peak.on_edge == [false; 2]);
        // The window was that of the pixel in which the position lies.
        let between = [0, 1].map(|axis| place[axis] - pixel[axis] as f64 - 0.5);
        Some(peak.map(|peak| [0, 1].map(|axis| (peak.position[axis] + between[axis]) * scale(level))))
    }
}

/// Px of the whole image that make one px of a level.
fn scale(level: usize) -> f64 {
    (1u64 << level.min(60)) as f64
}

#[cfg(test)]
mod tests {
    use super::super::texture::Texture;
    use super::*;
    use crate::halve;

    fn pyramid(image: GreyImage, levels: usize) -> Vec<GreyImage> {
        std::iter::successors(Some(image), |image| Some(halve(image.view()))).take(levels).collect()
    }

    /// A right image that is turned and scaled a little, and shifted.
    fn pair(noise: f64) -> (Vec<GreyImage>, Vec<GreyImage>, impl Fn([f64; 2]) -> [f64; 2]) {
        let texture = Texture::new(21, 4.0, 60.0);
        let truth = |[x, y]: [f64; 2]| [6.3 + 0.98 * x + 0.04 * y, 2.7 - 0.03 * x + 1.01 * y];
        let back = |[x, y]: [f64; 2]| {
            let (x, y, determinant) = (x - 6.3, y - 2.7, 0.98 * 1.01 + 0.03 * 0.04);
            [(1.01 * x - 0.04 * y) / determinant, (0.98 * y + 0.03 * x) / determinant]
        };
        let (left, right) = (texture.plain(300, noise, 1), texture.image(300, back, [0.9, 7.0, noise], 2));
        (pyramid(left, 4), pyramid(right, 4), truth)
    }

    #[test]
    fn starts_that_are_off_by_many_pixels_are_corrected() {
        let (left, right, truth) = pair(2.0);
        let mut matching = CoarseToFine::new(21);
        let mut found = 0;
        for k in 0..100usize {
            let place = [60.5 + ((k * 37) % 170) as f64, 60.5 + ((k * 53) % 170) as f64];
            let expected = truth(place);
            let (sin, cos) = (libm::sin(k as f64), libm::cos(k as f64));
            let start = [expected[0] + 15.0 * cos, expected[1] + 15.0 * sin];
            let fit = matching.through_pyramid((&left, place), (&right, start), 16.0, &LeastSquaresOptions::default());
            if let Ok(fit) = fit {
                let error = [0, 1].map(|axis| fit.position[axis] - expected[axis]);
                assert!(error.iter().all(|e| e.abs() < 0.1), "{place:?}: {error:?} {fit:?}");
                found += 1;
            }
        }
        assert!(found >= 99, "{found} of 100");
    }

    #[test]
    fn one_level_is_a_pyramid_too() {
        let (left, right, truth) = pair(0.0);
        let (place, expected) = ([150.5, 140.5], truth([150.5, 140.5]));
        let start = expected.map(|v| v + 4.0);
        let fit =
            CoarseToFine::new(21).through_pyramid((&left[..1], place), (&right[..1], start), 6.0, &LeastSquaresOptions::default()).unwrap();
        assert!((0..2).all(|axis| (fit.position[axis] - expected[axis]).abs() < 0.02), "{fit:?} {expected:?}");
    }

    #[test]
    fn windows_outside_or_without_texture_are_refused() {
        let (left, right, _) = pair(0.0);
        let flat = pyramid(GreyImage::from_fn(300, 300, |_, _| 80).unwrap(), 4);
        let mut matching = CoarseToFine::new(21);
        let mut refused = |left: &[GreyImage], place: [f64; 2], right: &[GreyImage], start: [f64; 2]| {
            matching.through_pyramid((left, place), (right, start), 16.0, &LeastSquaresOptions::default()).unwrap_err()
        };
        let middle = [150.5, 150.5];
        for outside in [[f64::NAN, 150.5], [150.5, f64::INFINITY], [3.0, 150.5], [-1e300, 150.5], [150.5, 1e300]] {
            assert_eq!(refused(&left, outside, &right, middle), Refusal::LeftImage, "{outside:?}");
            if outside[0] != 3.0 {
                assert_eq!(refused(&left, middle, &right, outside), Refusal::LeftImage, "{outside:?}");
            }
        }
        assert_eq!(refused(&left, middle, &[], middle), Refusal::LeftImage);
        assert_eq!(refused(&left, middle, &flat, middle), Refusal::LowCorrelation);
        refused(&flat, middle, &right, middle);
    }
}
