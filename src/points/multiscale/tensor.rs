//! The Förstner tensor around a point of a level: weight, roundness and position by least squares.

use super::level::{Level, UNITS};

/// The integration's standard deviation in those of the level's blur.
const INTEGRATION: f64 = 1.5;

/// A window's Gaussian weights for one level.
pub(super) struct TensorWindow {
    reach: usize,
    /// By distance from the centre; the weight of a pixel is the product of two of them.
    weights: Vec<f32>,
    /// Of Σ of the weights, of gradients over 2 px, of units; times the blur's variance: what makes levels comparable.
    norm: f64,
}

/// N = Σ w ∇g ∇gᵀ and what the positions of a corner and of a circle's centre need.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Tensor {
    pub xx: f64,
    pub xy: f64,
    pub yy: f64,
    /// Of the lines along the edges, which meet in a corner, and of those across them, which meet in the centre of a circle: Σ w a aᵀ p
    /// and Σ w (aᵀ p)² with a line's normal a and the pixel's place p from the window's centre.
    lines: [([f64; 2], f64); 2],
}

impl TensorWindow {
    /// `sigma` is the standard deviation of the level's blur in its pixels.
    pub fn new(sigma: f64) -> Self {
        let integration = INTEGRATION * sigma;
        let reach = libm::ceil(2.0 * integration) as usize;
        let weights: Vec<f32> = (0..=reach).map(|k| libm::exp(-((k * k) as f64) / (2.0 * integration * integration)) as f32).collect();
        let line: f64 = (-(reach as isize)..=reach as isize).map(|k| f64::from(weights[k.unsigned_abs()])).sum();
        let units = 2.0 * f64::from(UNITS);
        Self { reach, weights, norm: sigma * sigma / (line * line * units * units) }
    }

    /// The tensor around a pixel; beyond the border there is nothing.
    pub fn at(&self, level: &Level, col: usize, row: usize) -> Tensor {
        let (mut sums, mut along, mut across) = ([0f32; 3], [0f32; 3], [0f32; 3]);
        let (stride, data) = (level.stride(), level.data());
        let last = |length: usize, place: usize| (place + self.reach).min(length - 2);
        for r in row.saturating_sub(self.reach).max(1)..=last(level.height(), row) {
            let weight = self.weights[r.abs_diff(row)];
            let dy = r as f32 - row as f32;
            for c in col.saturating_sub(self.reach).max(1)..=last(level.width(), col) {
                let place = r * stride + c;
                let gx = f32::from(data[place + 1] - data[place - 1]);
                let gy = f32::from(data[place + stride] - data[place - stride]);
                let w = weight * self.weights[c.abs_diff(col)];
                let dx = c as f32 - col as f32;
                let (wx, wy) = (w * gx, w * gy);
                sums = [sums[0] + wx * gx, sums[1] + wx * gy, sums[2] + wy * gy];
                let (d, e) = (gx * dx + gy * dy, gx * dy - gy * dx);
                along = [along[0] + wx * d, along[1] + wy * d, along[2] + w * d * d];
                across = [across[0] - wy * e, across[1] + wx * e, across[2] + w * e * e];
            }
        }
        let scaled = |sum: f32| f64::from(sum) * self.norm;
        let [xx, xy, yy] = sums.map(scaled);
        let lines = [along, across].map(|sums| ([scaled(sums[0]), scaled(sums[1])], scaled(sums[2])));
        Tensor { xx, xy, yy, lines }
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

    /// The corner or the centre of a circle, whichever fits the window's edges better, from the window's centre in px; `None` where all
    /// edges run alike.
    ///
    /// # Source
    /// Förstner & Gülch 1987, section 3.
    pub fn least_squares(&self) -> Option<[f64; 2]> {
        let determinant = self.determinant();
        let [along, across] = self.lines;
        // The second matrix is the first of gradients turned by a right angle.
        let solved = |xx: f64, xy: f64, yy: f64, ([a, b], squares): ([f64; 2], f64)| {
            let p = [(yy * a - xy * b) / determinant, (xx * b - xy * a) / determinant];
            (p, squares - p[0] * a - p[1] * b)
        };
        let corner = solved(self.xx, self.xy, self.yy, along);
        let circle = solved(self.yy, -self.xy, self.xx, across);
        (self.roundness() > 0.0).then_some(if corner.1 < circle.1 { corner.0 } else { circle.0 })
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
        let [dx, dy] = TensorWindow::new(1.8).at(&corner, 16, 16).least_squares().unwrap();
        assert!((dx - 0.3).abs() < 0.4 && (dy + 0.4).abs() < 0.4, "{dx} {dy}");
        let circle = level(|x, y| {
            let r2 = (x - 16.4) * (x - 16.4) + (y - 15.8) * (y - 15.8);
            200.0 * libm::exp(-r2 / 10.0)
        });
        let [dx, dy] = TensorWindow::new(1.2).at(&circle, 16, 16).least_squares().unwrap();
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
