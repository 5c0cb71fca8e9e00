//! The Förstner tensor around a point of a level: weight, roundness and position by least squares.

use super::level::{Level, UNITS};
use crate::math::Lanes;
use std::ops::Range;

/// The integration's standard deviation in those of the level's blur.
const INTEGRATION: f64 = 1.5;

/// Most pixels a side of a window.
const WIDEST: usize = 16;

/// A window's Gaussian weights for one level.
pub(super) struct TensorWindow {
    reach: usize,
    /// By distance from the centre; the weight of a pixel is the product of two of them.
    weights: Vec<f32>,
    /// Of Σ of the weights, of gradients over 2 px, of units; times the blur's variance: what makes levels comparable.
    norm: f64,
}

/// N = Σ w ∇g ∇gᵀ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Tensor {
    pub xx: f64,
    pub xy: f64,
    pub yy: f64,
}

impl TensorWindow {
    /// `sigma` is the standard deviation of the level's blur in its pixels.
    pub fn new(sigma: f64) -> Self {
        let integration = INTEGRATION * sigma;
        let reach = (libm::ceil(2.0 * integration) as usize).min((WIDEST - 1) / 2);
        let weights: Vec<f32> = (0..=reach).map(|k| libm::exp(-((k * k) as f64) / (2.0 * integration * integration)) as f32).collect();
        let line: f64 = (-(reach as isize)..=reach as isize).map(|k| f64::from(weights[k.unsigned_abs()])).sum();
        let units = 2.0 * f64::from(UNITS);
        Self { reach, weights, norm: sigma * sigma / (line * line * units * units) }
    }

    /// The tensor around a pixel; beyond the border there is nothing.
    pub fn at(&self, level: &Level, col: usize, row: usize) -> Tensor {
        let cols = self.span(col, level.width());
        // Columns that fill up the last four count nothing.
        let mut across = [0f32; WIDEST];
        across.iter_mut().zip(cols.clone()).for_each(|(weight, c)| *weight = self.weights[c.abs_diff(col)]);
        let across = &across[..cols.len().next_multiple_of(4)];
        let (stride, data) = (level.stride(), level.data());
        let zero = Lanes::splat(0.0);
        let mut sums = [zero; 3];
        for r in self.span(row, level.height()) {
            let place = r * stride + cols.start;
            let mut of_row = [zero; 3];
            for (weights, k) in across.chunks_exact(4).zip((place..).step_by(4)) {
                let four = |place: usize| Lanes::load_whole(&data[place..]);
                let (gx, gy) = (four(k + 1) - four(k - 1), four(k + stride) - four(k - stride));
                let weights = Lanes::load(weights);
                let (wx, wy) = (weights * gx, weights * gy);
                of_row = [of_row[0] + wx * gx, of_row[1] + wx * gy, of_row[2] + wy * gy];
            }
            let weight = Lanes::splat(self.weights[r.abs_diff(row)]);
            sums = std::array::from_fn(|k| sums[k] + of_row[k] * weight);
        }
        let [xx, xy, yy] = sums.map(|sum| sum.to_array().map(f64::from).iter().sum::<f64>() * self.norm);
        Tensor { xx, xy, yy }
    }

    /// The pixels of the window along a row or column that have gradients.
    fn span(&self, centre: usize, length: usize) -> Range<usize> {
        centre.saturating_sub(self.reach).max(1)..(centre + self.reach + 1).min(length - 1)
    }

    /// The corner or the centre of a circle, whichever fits the window's edges better, from the window's centre in px; `None` where all
    /// edges run alike. `tensor` is that of the window.
    ///
    /// # Source
    /// Förstner & Gülch 1987, section 3.
    pub fn least_squares(&self, tensor: &Tensor, level: &Level, col: usize, row: usize) -> Option<[f64; 2]> {
        let (stride, data) = (level.stride(), level.data());
        // Of the lines along the edges, which meet in a corner, and of those across them, which meet in the centre of a circle:
        // Σ w a aᵀ p and Σ w (aᵀ p)² with a line's normal a and the pixel's place p from the window's centre.
        let (mut along, mut across) = ([0f32; 3], [0f32; 3]);
        for r in self.span(row, level.height()) {
            let dy = r as f32 - row as f32;
            for c in self.span(col, level.width()) {
                let place = r * stride + c;
                let gx = f32::from(data[place + 1] - data[place - 1]);
                let gy = f32::from(data[place + stride] - data[place - stride]);
                let w = self.weights[r.abs_diff(row)] * self.weights[c.abs_diff(col)];
                let dx = c as f32 - col as f32;
                let (wx, wy) = (w * gx, w * gy);
                let (d, e) = (gx * dx + gy * dy, gx * dy - gy * dx);
                along = [along[0] + wx * d, along[1] + wy * d, along[2] + w * d * d];
                across = [across[0] - wy * e, across[1] + wx * e, across[2] + w * e * e];
            }
        }
        let [along, across] = [along, across].map(|sums| sums.map(|sum| f64::from(sum) * self.norm));
        let determinant = tensor.determinant();
        // The second matrix is the first of gradients turned by a right angle.
        let solved = |xx: f64, xy: f64, yy: f64, [a, b, squares]: [f64; 3]| {
            let p = [(yy * a - xy * b) / determinant, (xx * b - xy * a) / determinant];
            (p, squares - p[0] * a - p[1] * b)
        };
        let corner = solved(tensor.xx, tensor.xy, tensor.yy, along);
        let circle = solved(tensor.yy, -tensor.xy, tensor.xx, across);
        (tensor.roundness() > 0.0).then_some(if corner.1 < circle.1 { corner.0 } else { circle.0 })
    }
}

impl Tensor {
    fn determinant(&self) -> f64 {
        self.xx * self.yy - self.xy * self.xy
    }

    /// w = det N / tr N in grey².
    pub fn weight(&self) -> f64 {
        let trace = self.xx + self.yy;
        if trace > 0.0 { self.determinant() / trace } else { 0.0 }
    }

    /// q = 4 det N / tr² N.
    pub fn roundness(&self) -> f64 {
        let trace = self.xx + self.yy;
        if trace > 0.0 { 4.0 * self.determinant() / (trace * trace) } else { 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn level(grey: impl Fn(f64, f64) -> f64) -> Level {
        let mut level = Level::new(32, 32);
        (0..32).for_each(|row| {
            let line: Vec<f32> = (0..32).map(|col| grey(col as f64, row as f64) as f32).collect();
            level.set_row(row, &line);
        });
        level
    }

    #[test]
    fn an_edge_has_no_weight_and_a_spot_is_round() {
        let window = TensorWindow::new(1.5);
        let edge = window.at(&level(|x, _| if x < 16.0 { 20.0 } else { 200.0 }), 16, 16);
        assert!(edge.weight() < 1e-3 && edge.roundness() < 1e-6);
        let spot = window.at(&level(|x, y| 200.0 * libm::exp(-((x - 16.0) * (x - 16.0) + (y - 16.0) * (y - 16.0)) / 8.0)), 16, 16);
        assert!(spot.weight() > 10.0 && spot.roundness() > 0.99, "{spot:?}");
    }

    #[test]
    fn corners_and_circles_are_found() {
        // Two smooth edges that cross at (16.3, 15.6).
        let step = |d: f64| 1.0 / (1.0 + libm::exp(-d));
        let corner = level(|x, y| 30.0 + 180.0 * step(4.0 * (x - 16.3)) * step(4.0 * (y - 15.6)));
        let centre = |sigma: f64, level: &Level| {
            let window = TensorWindow::new(sigma);
            window.least_squares(&window.at(level, 16, 16), level, 16, 16).unwrap()
        };
        let [dx, dy] = centre(1.8, &corner);
        assert!((dx - 0.3).abs() < 0.4 && (dy + 0.4).abs() < 0.4, "{dx} {dy}");
        let circle = level(|x, y| {
            let r2 = (x - 16.4) * (x - 16.4) + (y - 15.8) * (y - 15.8);
            200.0 * libm::exp(-r2 / 10.0)
        });
        let [dx, dy] = centre(1.2, &circle);
        assert!((dx - 0.4).abs() < 0.02 && (dy + 0.2).abs() < 0.02, "{dx} {dy}");
    }

    #[test]
    fn the_weight_does_not_change_with_the_scale() {
        let at = |sigma: f64| {
            let spot = level(|x, y| {
                let r2 = (x - 16.0) * (x - 16.0) + (y - 16.0) * (y - 16.0);
                200.0 * libm::exp(-r2 / (4.0 * sigma * sigma))
            });
            TensorWindow::new(sigma).at(&spot, 16, 16).weight()
        };
        assert!((at(1.3) / at(2.1) - 1.0).abs() < 0.15, "{} {}", at(1.3), at(2.1));
    }
}
