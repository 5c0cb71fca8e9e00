//! Least-squares matching of one window: position and affine deformation, to hundredths of a pixel.

use super::fit::{Fit, LeastSquaresOptions, Refusal};
use super::spline::Spline;
use super::warp::Warp;
use super::window_model::{DEFORMATION, NoModel, WindowModel, total};
use crate::GreyView;
use crate::math::Lanes;
use nalgebra::Vector6;

/// Step of the shift, in px, at or below which the deformation joins it.
const SHIFTED: f64 = 0.25;
/// Iterations of the shift alone at most.
const SHIFTS: usize = 5;
/// Longest step in px: beyond it the grey values are no longer linear.
const LONGEST_STEP: f64 = 1.0;
/// The corners may still move so many times as far as the centre when the iteration ends.
const CORNERS: f64 = 4.0;
/// From this iteration on, fits whose steps shrink too slowly are given up. Two steps of the deformation can be compared then.
const JUDGED_FROM: usize = SHIFTS + 3;
/// If all steps shrink as the latest one did, the last may be so many times as long as is short enough.
const LEFT_OVER: f64 = 2.0;
/// Variance in grey² below which the right window is constant: that of rounding to whole numbers.
const LEAST_VARIANCE: f64 = 1.0 / 12.0;
/// Least and largest change of area from that of the start: what is larger ran away.
const AREA: [f64; 2] = [0.25, 4.0];

/// Sums over the window.
struct Sums {
    derivatives: Vector6<f64>,
    grey: f64,
    one: f64,
    square: f64,
}

/// Least-squares matching with windows of one side; it keeps its tables from window to window.
pub(crate) struct LeastSquares {
    side: usize,
    model: WindowModel,
    left: Spline,
    right: Spline,
}

impl LeastSquares {
    /// `side` of the window is odd, 5..=63.
    ///
    /// # Panics
    /// Where it is not.
    pub fn new(side: usize) -> Self {
        assert!(side % 2 == 1 && (5..=63).contains(&side), "a window of {side} px");
        Self { side, model: WindowModel::new(side), left: Spline::default(), right: Spline::default() }
    }

    /// Finds the window about a left position in the right image, from a start that is off by at most a px or two.
    ///
    /// The unknowns are the six of an affine deformation, gain and offset. They are taken as a change of the left window (inverse
    /// composition), so that derivatives and normal matrix are the same in all iterations; gain and offset are eliminated beforehand.
    ///
    /// # Errors
    /// [`Refusal`].
    ///
    /// # Source
    /// Förstner 1982, On the geometric precision of digital correlation; Grün 1985, Adaptive least squares correlation; inverse
    /// composition: Baker & Matthews 2004, Lucas-Kanade 20 years on.
    pub fn fit(
        &mut self,
        (left, left_position): (GreyView<'_>, [f64; 2]),
        (right, start): (GreyView<'_>, [f64; 2]),
        start_affine: [[f64; 2]; 2],
        options: &LeastSquaresOptions,
    ) -> Result<Fit, Refusal> {
        self.fit_part((left, left_position), (right, start), start_affine, options, &|_| true)
    }

    /// As [`fit`](Self::fit), by those pixels of the left window that take part: the others show something else in the right image.
    ///
    /// # Errors
    /// [`Refusal`]; [`Refusal::Degenerate`] where it is less than half of them.
    pub fn fit_part(
        &mut self,
        (left, left_position): (GreyView<'_>, [f64; 2]),
        (right, start): (GreyView<'_>, [f64; 2]),
        start_affine: [[f64; 2]; 2],
        options: &LeastSquaresOptions,
        takes_part: &dyn Fn([f64; 2]) -> bool,
    ) -> Result<Fit, Refusal> {
        self.model.take(left, left_position, &mut self.left, takes_part).map_err(|reason| match reason {
            NoModel::Outside => Refusal::LeftImage,
            NoModel::Degenerate => Refusal::Degenerate,
        })?;
        if options.affine && self.model.inverse.is_none() {
            return Err(Refusal::Degenerate);
        }
        self.right.clear();
        let mut warp = Warp { centre: start, matrix: start_affine };
        let area = warp.area();
        if !(area > 0.0 && area.is_finite()) {
            return Err(Refusal::NotConverged);
        }
        let mut with_affine = false;
        let mut longest_before = f64::INFINITY;
        for iteration in 1..=options.most_iterations {
            let sums = self.sums(right, &warp)?;
            if iteration > SHIFTS && self.correlation(&sums) < options.least_promising {
                return Err(Refusal::LowCorrelation);
            }
            let mut change = self.change(&sums, with_affine).ok_or(Refusal::LowCorrelation)?;
            if !with_affine && options.affine && (iteration > SHIFTS || length_of_shift(&change) <= SHIFTED) {
                with_affine = true;
                change = self.change(&sums, true).ok_or(Refusal::LowCorrelation)?;
            }
            let shift = length_of_shift(&change);
            if shift > LONGEST_STEP {
                change *= LONGEST_STEP / shift;
            }
            warp = warp.changed(&change).filter(|warp| (AREA[0]..=AREA[1]).contains(&(warp.area() / area))).ok_or(Refusal::NotConverged)?;
            let moved = [0, 1].map(|axis| warp.centre[axis] - start[axis]);
            if !(moved[0] * moved[0] + moved[1] * moved[1] <= options.farthest_px * options.farthest_px) {
                return Err(Refusal::MovedTooFar);
            }
            let reach = (self.side / 2) as f64;
            let longest = shift + reach * change.iter().skip(2).fold(0.0, |sum: f64, v| sum + v.abs());
            let short_enough = CORNERS * options.convergence_px;
            if shift <= options.convergence_px && longest <= short_enough && with_affine == options.affine {
                return self.result(&sums, &warp, options, iteration);
            }
            let remaining = (options.most_iterations - iteration) as f64;
            let last_step = longest * libm::pow((longest / longest_before).min(1.0), remaining);
            if with_affine && iteration >= JUDGED_FROM && last_step > LEFT_OVER * short_enough {
                return Err(Refusal::NotConverged);
            }
            longest_before = longest;
        }
        Err(Refusal::NotConverged)
    }

    /// Of the left window with the right one.
    fn correlation(&self, sums: &Sums) -> f64 {
        let square = sums.square - sums.one * sums.one / self.model.pixels;
        if square > 0.0 { (sums.grey / (square.sqrt() * self.model.square.sqrt())).min(1.0) } else { 0.0 }
    }

    /// The change of the left window that explains the right one best; `None` where they do not correlate.
    fn change(&self, sums: &Sums, with_affine: bool) -> Option<Vector6<f64>> {
        let gain = sums.grey / self.model.square;
        let pixels = self.model.pixels;
        if !(gain > 0.0 && sums.square - sums.one * sums.one / pixels > LEAST_VARIANCE * pixels) {
            return None;
        }
        let wanted = sums.derivatives / gain;
        Some(match self.model.inverse.filter(|_| with_affine) {
            Some(inverse) => inverse * wanted,
            None => {
                let shift = self.model.inverse_of_shift * wanted.fixed_rows::<2>(0);
                Vector6::new(shift[0], shift[1], 0.0, 0.0, 0.0, 0.0)
            }
        })
    }

    /// Resamples the right image and multiplies it with the derivatives, the grey values and 1.
    fn sums(&mut self, right: GreyView<'_>, warp: &Warp) -> Result<Sums, Refusal> {
        let reach = (self.side / 2) as f64;
        let [[xx, xy], [yx, yy]] = warp.matrix;
        let extent = [reach * (xx.abs() + xy.abs()), reach * (yx.abs() + yy.abs())];
        let low = [0, 1].map(|axis| warp.centre[axis] - extent[axis]);
        let high = [0, 1].map(|axis| warp.centre[axis] + extent[axis]);
        let model = &self.model;
        if !self.right.cover(right, low, high, model.mean as f32) {
            return Err(Refusal::LeftImage);
        }
        let first = self.right.first();
        let centre = [0, 1].map(|axis| Lanes::splat((warp.centre[axis] - first[axis]) as f32));
        let [xx, xy, yx, yy] = [xx, xy, yx, yy].map(|v| Lanes::splat(v as f32));
        let zero = Lanes::splat(0.0);
        let (mut derivatives, mut grey, mut one, mut square) = ([zero; DEFORMATION], zero, zero, zero);
        for k in (0..model.x.len()).step_by(4) {
            let (x, y) = (Lanes::load(&model.x[k..]), Lanes::load(&model.y[k..]));
            let value = self.right.sample(centre[0] + (xx * x + xy * y), centre[1] + (yx * x + yy * y)) * Lanes::load(&model.ones[k..]);
            for (sum, column) in derivatives.iter_mut().zip(&model.derivatives) {
                *sum = *sum + Lanes::load(&column[k..]) * value;
            }
            grey = grey + Lanes::load(&model.grey[k..]) * value;
            one = one + value;
            square = square + value * value;
        }
        Ok(Sums { derivatives: Vector6::from(derivatives.map(total)), grey: total(grey), one: total(one), square: total(square) })
    }

    fn result(&self, sums: &Sums, warp: &Warp, options: &LeastSquaresOptions, iterations: usize) -> Result<Fit, Refusal> {
        let model = &self.model;
        let pixels = model.pixels;
        let gain = sums.grey / model.square;
        let square = sums.square - sums.one * sums.one / pixels;
        let correlation = self.correlation(sums);
        if !(correlation >= options.least_correlation && gain > 0.0) {
            return Err(Refusal::LowCorrelation);
        }
        let unknowns = if options.affine { DEFORMATION + 2 } else { 4 } as f64;
        let variance = (square - gain * sums.grey).max(0.0) / (pixels - unknowns);
        let inverse =
            model.inverse.filter(|_| options.affine).map_or(model.inverse_of_shift, |all| all.fixed_view::<2, 2>(0, 0).into_owned());
        let [[a, b], [c, d]] = warp.matrix;
        let (xx, xy, yy) = (inverse[(0, 0)], inverse[(0, 1)], inverse[(1, 1)]);
        let of_right = [
            a * a * xx + 2.0 * a * b * xy + b * b * yy,
            a * c * xx + (a * d + b * c) * xy + b * d * yy,
            c * c * xx + 2.0 * c * d * xy + d * d * yy,
        ];
        Ok(Fit {
            position: warp.centre,
            affine: warp.matrix,
            gain,
            offset: sums.one / pixels + model.mean - gain * model.mean,
            correlation,
            covariance: of_right.map(|v| v * variance / (gain * gain)),
            iterations,
        })
    }
}

fn length_of_shift(change: &Vector6<f64>) -> f64 {
    (change[0] * change[0] + change[1] * change[1]).sqrt()
}

#[cfg(test)]
mod tests {
    use super::super::texture::Texture;
    use super::*;
    use crate::GreyImage;
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test;

    const UNIT: [[f64; 2]; 2] = [[1.0, 0.0], [0.0, 1.0]];
    const SIZE: usize = 150;
    const MIDDLE: f64 = 75.5;

    fn places() -> impl Iterator<Item = [f64; 2]> {
        (0..60).map(|p| [30.5 + ((p * 37) % 90) as f64, 30.5 + ((p * 53) % 90) as f64])
    }

    /// The right image of a texture that is deformed about the middle and then shifted, and the true right position of a left one.
    fn pair(matrix: [[f64; 2]; 2], shift: [f64; 2], light: [f64; 3], seed: u32) -> (GreyImage, GreyImage, impl Fn([f64; 2]) -> [f64; 2]) {
        let texture = Texture::new(7, 4.0, 40.0);
        let [[a, b], [c, d]] = matrix;
        let determinant = a * d - b * c;
        let back = move |p: [f64; 2]| {
            let [x, y] = [p[0] - MIDDLE - shift[0], p[1] - MIDDLE - shift[1]];
            [MIDDLE + (d * x - b * y) / determinant, MIDDLE + (a * y - c * x) / determinant]
        };
        let truth = move |p: [f64; 2]| {
            let [x, y] = [p[0] - MIDDLE, p[1] - MIDDLE];
            [MIDDLE + a * x + b * y + shift[0], MIDDLE + c * x + d * y + shift[1]]
        };
        (texture.plain(SIZE, light[2], 2 * seed), texture.image(SIZE, back, light, 2 * seed + 1), truth)
    }

    fn square_distance(a: [f64; 2], b: [f64; 2]) -> f64 {
        let [x, y] = [a[0] - b[0], a[1] - b[1]];
        x * x + y * y
    }

    /// Largest error of the positions in px, from starts that are off by 1 px.
    fn largest_error(matrix: [[f64; 2]; 2], shift: [f64; 2], light: [f64; 3], between_pixels: f64) -> f64 {
        let (left, right, truth) = pair(matrix, shift, light, 3);
        let mut matching = LeastSquares::new(21);
        let errors = places().enumerate().map(|(k, place)| {
            let place = place.map(|p| p + between_pixels);
            let expected = truth(place);
            let (sin, cos) = (libm::sin(k as f64), libm::cos(k as f64));
            let start = [expected[0] + cos, expected[1] + sin];
            let fit = matching.fit((left.view(), place), (right.view(), start), UNIT, &LeastSquaresOptions::default()).unwrap();
            assert!((0..2).all(|r| (0..2).all(|c| (fit.affine[r][c] - matrix[r][c]).abs() < 0.02)), "{fit:?}");
            assert!((fit.gain - light[0]).abs() < 0.05 && (fit.offset - light[1]).abs() < 8.0 && fit.iterations <= 15, "{fit:?}");
            square_distance(fit.position, expected).sqrt()
        });
        errors.fold(0.0, f64::max)
    }

    #[test]
    fn shifts_are_found_to_a_hundredth_of_a_pixel() {
        for shift in [[0.0, 0.0], [0.5, -0.5], [3.25, 1.4], [-2.13, 0.77]] {
            let error = largest_error(UNIT, shift, [1.0, 0.0, 0.0], 0.0);
            assert!(error < 0.01, "{shift:?}: {error}");
        }
        // Other light, and a left position between pixels.
        let errors = [largest_error(UNIT, [1.3, -0.6], [0.8, 12.0, 0.0], 0.0), largest_error(UNIT, [1.3, -0.6], [1.0, 0.0, 0.0], 0.37)];
        assert!(errors.iter().all(|e| *e < 0.01), "{errors:?}");
    }

    #[test]
    fn a_deformation_is_found() {
        let error = largest_error([[1.05, -0.06], [0.04, 0.96]], [0.6, -1.2], [0.8, 12.0, 0.0], 0.0);
        assert!(error < 0.015, "{error}");
    }

    #[test]
    fn a_fit_that_settles_late_is_not_given_up() {
        let (left, right, truth) = pair([[1.2, -0.12], [0.1, 0.85]], [0.4, 0.2], [1.0, 0.0, 0.0], 4);
        let mut matching = LeastSquares::new(21);
        // Fits of the usual kind settle before they are judged: these start further off, and end nearer.
        let options = LeastSquaresOptions { convergence_px: 1e-4, ..LeastSquaresOptions::default() };
        let mut fit = |place| matching.fit((left.view(), place), (right.view(), truth(place).map(|v| v + 1.5)), UNIT, &options);
        let fits: Vec<Result<Fit, Refusal>> = places().map(&mut fit).collect();
        let late = fits.iter().flatten().filter(|fit| fit.iterations > JUDGED_FROM).count();
        assert!(late > 30 && !fits.contains(&Err(Refusal::NotConverged)), "{late} of {}", fits.len());
    }

    #[test]
    fn noise_leaves_twentieths_of_a_pixel_and_the_covariance_tells_how_much() {
        let (mut squares, mut predicted, mut number) = (0.0, 0.0, 0.0);
        for (seed, shift) in [[0.0, 0.0], [0.5, 0.5], [0.27, -0.36], [-0.45, 0.1], [0.12, 0.8]].into_iter().enumerate() {
            let (left, right, truth) = pair(UNIT, shift, [0.9, 5.0, 3.0], seed as u32);
            let mut matching = LeastSquares::new(21);
            for place in places() {
                let expected = truth(place);
                let start = [expected[0] + 0.4, expected[1] - 0.3];
                let fit = matching.fit((left.view(), place), (right.view(), start), UNIT, &LeastSquaresOptions::default()).unwrap();
                squares += square_distance(fit.position, expected);
                predicted += fit.covariance[0] + fit.covariance[2];
                number += 2.0;
                let [xx, xy, yy] = fit.covariance;
                assert!(xx > 0.0 && yy > 0.0 && xx * yy > xy * xy, "{fit:?}");
            }
        }
        let (error, ratio) = ((squares / number).sqrt(), squares / predicted);
        assert!(error < 0.05 && (0.7..1.4).contains(&ratio), "{error} px, {ratio}");
    }

    #[test]
    fn what_takes_no_part_moves_nothing() {
        let (left, right, truth) = pair(UNIT, [0.6, -0.3], [1.0, 0.0, 0.0], 1);
        // On one side of each place the right image shows what lies 3 px farther, as behind a wall.
        let mut matching = LeastSquares::new(21);
        let (mut largest, mut largest_of_all) = (0.0, 0.0);
        for place in places() {
            let expected = truth(place);
            let is_hidden = |column: f64| column > place[0] + 4.0;
            let shown = |c: usize, r: usize| {
                let from = if is_hidden(c as f64 + 0.5 - 0.6) && c >= 3 { c - 3 } else { c };
                right.view().at(from, r)
            };
            let behind = GreyImage::from_fn(SIZE, SIZE, shown).unwrap();
            let mut error = |takes_part: &dyn Fn([f64; 2]) -> bool| {
                let options = LeastSquaresOptions { least_correlation: 0.0, least_promising: 0.0, ..LeastSquaresOptions::default() };
                let fit = matching.fit_part((left.view(), place), (behind.view(), expected), UNIT, &options, takes_part);
                fit.map(|fit| square_distance(fit.position, expected).sqrt())
            };
            largest = f64::max(largest, error(&|at| !is_hidden(at[0] + 2.0)).unwrap());
            largest_of_all = f64::max(largest_of_all, error(&|_| true).unwrap_or(0.0));
            assert_eq!(error(&|at| at[0] < place[0] - 1.0).unwrap_err(), Refusal::Degenerate, "less than half of it");
        }
        assert!(largest < 0.04 && largest_of_all > 1.0, "{largest} {largest_of_all}");
    }

    #[test]
    fn only_the_shift_can_be_unknown() {
        let (left, right, truth) = pair(UNIT, [0.6, -0.3], [1.0, 0.0, 0.0], 1);
        let options = LeastSquaresOptions { affine: false, ..LeastSquaresOptions::default() };
        let fit = LeastSquares::new(15).fit((left.view(), [70.5, 60.5]), (right.view(), [70.5, 60.5]), UNIT, &options).unwrap();
        let expected = truth([70.5, 60.5]);
        assert!((0..2).all(|axis| (fit.position[axis] - expected[axis]).abs() < 0.01) && fit.affine == UNIT, "{fit:?}");
    }

    /// The bits are the same natively and as WebAssembly.
    #[cfg_attr(target_arch = "wasm32", wasm_bindgen_test)]
    #[cfg_attr(not(target_arch = "wasm32"), test)]
    fn the_numbers_are_the_same_everywhere() {
        let (left, right, truth) = pair([[1.02, 0.03], [-0.01, 0.98]], [0.6, -0.3], [0.8, 12.0, 2.0], 1);
        let mut matching = LeastSquares::new(21);
        let mut digest = 0u64;
        for place in places().map(|p| p.map(|v| v + 0.25)) {
            let fit = matching.fit((left.view(), place), (right.view(), truth(place)), UNIT, &LeastSquaresOptions::default()).unwrap();
            for value in
                fit.position.into_iter().chain(fit.affine.into_iter().flatten()).chain(fit.covariance).chain([fit.gain, fit.offset])
            {
                digest = digest.rotate_left(5) ^ value.to_bits();
            }
        }
        assert_eq!(digest, DIGEST);
    }

    const DIGEST: u64 = 6_171_904_614_885_323_528;

    #[test]
    fn each_refusal_has_its_name() {
        let (left, right, truth) = pair(UNIT, [0.6, -0.3], [1.0, 0.0, 2.0], 1);
        let other = Texture::new(99, 4.0, 40.0).plain(SIZE, 2.0, 5);
        let options = LeastSquaresOptions::default();
        let mut matching = LeastSquares::new(21);
        let mut refused = |left: &GreyImage, place: [f64; 2], right: &GreyImage, start: [f64; 2], options: &LeastSquaresOptions| {
            matching.fit((left.view(), place), (right.view(), start), UNIT, options).unwrap_err()
        };
        let place = [70.5, 60.5];
        // Windows that leave an image; positions that are no numbers.
        for outside in [[10.5, 60.5], [70.5, 139.5], [-1e300, 60.5], [f64::NAN, 60.5], [70.5, f64::INFINITY], [10.7, 60.5]] {
            assert_eq!(refused(&left, outside, &right, place, &options), Refusal::LeftImage, "{outside:?}");
            assert_eq!(refused(&left, place, &right, outside, &options), Refusal::LeftImage, "{outside:?}");
        }
        let near = LeastSquaresOptions { farthest_px: 0.5, ..options };
        assert_eq!(refused(&left, place, &right, truth([70.5, 61.5]), &near), Refusal::MovedTooFar);
        let short = LeastSquaresOptions { most_iterations: 1, ..options };
        assert_eq!(refused(&left, place, &right, truth([71.0, 61.0]), &short), Refusal::NotConverged);
        let strict = LeastSquaresOptions { least_correlation: 0.9999, ..options };
        assert_eq!(refused(&left, place, &right, truth(place), &strict), Refusal::LowCorrelation);
        // Another place altogether is refused for one reason or another, never matched.
        for place in places() {
            refused(&left, place, &other, place, &options);
        }
        // No texture, or an edge, however steep.
        let flat = GreyImage::from_fn(SIZE, SIZE, |_, _| 90).unwrap();
        let edge = GreyImage::from_fn(SIZE, SIZE, |col, row| (40.0 + 20.0 * (col as f64 + 0.3 * row as f64 - 85.0).clamp(0.0, 7.0)) as u8)
            .unwrap();
        assert_eq!(refused(&flat, place, &right, place, &options), Refusal::Degenerate);
        assert_eq!(refused(&edge, place, &right, place, &options), Refusal::Degenerate);
        assert_eq!(refused(&left, place, &flat, place, &options), Refusal::LowCorrelation);
    }

    #[test]
    fn a_start_that_turns_the_window_over_is_refused() {
        let (left, right, _) = pair(UNIT, [0.0, 0.0], [1.0, 0.0, 0.0], 1);
        for affine in [[[f64::NAN, 0.0], [0.0, 1.0]], [[-1.0, 0.0], [0.0, 1.0]], [[1e200, 0.0], [0.0, 1.0]]] {
            assert!(
                LeastSquares::new(21)
                    .fit((left.view(), [70.5, 60.5]), (right.view(), [70.5, 60.5]), affine, &LeastSquaresOptions::default())
                    .is_err()
            );
        }
    }
}
