//! The window that least-squares matching looks for: its grey values, and how they change with shift, affine deformation, gain and offset.

use super::spline::Spline;
use crate::GreyView;
use crate::math::Lanes;
use nalgebra::{Matrix2, Matrix6};

/// Unknowns of the deformation: shift in x and y; then, of x and of y, the change by x and by y.
pub(super) const DEFORMATION: usize = 6;
/// Least mean square of the gradient in its weakest direction, grey²/px²: that of faint noise.
const LEAST_GRADIENT: f64 = 1.0;
/// Least roundness 4 det N / tr² N of the normal matrix of the shift, 0 (an edge) to 1: the weaker axis then still has 1/38 of the weight.
const LEAST_ROUNDNESS: f64 = 0.1;
/// Least part of an unknown's weight that the other unknowns leave it.
const LEAST_PIVOT: f64 = 1e-3;
/// The share of the pixels that takes part, at least.
const LEAST_PART: f64 = 0.5;

/// A window of the left image, with the derivatives from which gain and offset were eliminated.
pub(super) struct WindowModel {
    side: usize,
    /// Distance from the centre in px, and 1 for each pixel of the window that takes part; 0 in the places that fill up to a multiple of 4.
    pub x: Vec<f32>,
    pub y: Vec<f32>,
    pub ones: Vec<f32>,
    /// How many pixels take part.
    pub pixels: f64,
    /// Grey values less their mean.
    pub grey: Vec<f32>,
    /// Derivatives by the unknowns of the deformation, made orthogonal to 1 and to the grey values.
    pub derivatives: [Vec<f32>; DEFORMATION],
    /// The window with a frame of one pixel.
    framed: Vec<f32>,
    pub mean: f64,
    /// Σ of the squares of `grey`.
    pub square: f64,
    /// Inverse normal matrices of all unknowns of the deformation, where they are determined, and of the shift alone.
    pub inverse: Option<Matrix6<f64>>,
    pub inverse_of_shift: Matrix2<f64>,
}

/// Why there is no model.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum NoModel {
    Outside,
    Degenerate,
}

impl WindowModel {
    pub fn new(side: usize) -> Self {
        let (pixels, length) = (side * side, (side * side).next_multiple_of(4));
        let reach = (side / 2) as f32;
        let table = |of: &dyn Fn(usize) -> f32| (0..length).map(|k| if k < pixels { of(k) } else { 0.0 }).collect::<Vec<_>>();
        Self {
            side,
            x: table(&|k| (k % side) as f32 - reach),
            y: table(&|k| (k / side) as f32 - reach),
            ones: table(&|_| 1.0),
            pixels: pixels as f64,
            grey: vec![0.0; length],
            derivatives: std::array::from_fn(|_| vec![0.0; length]),
            framed: vec![0.0; ((side + 2) * (side + 2)).next_multiple_of(4)],
            mean: 0.0,
            square: 0.0,
            inverse: None,
            inverse_of_shift: Matrix2::zeros(),
        }
    }

    /// Takes the window centred on a position, between pixels by the spline: of its pixels those that take part.
    pub fn take(
        &mut self,
        image: GreyView<'_>,
        position: [f64; 2],
        spline: &mut Spline,
        takes_part: &dyn Fn([f64; 2]) -> bool,
    ) -> Result<(), NoModel> {
        self.frame(image, position, spline).ok_or(NoModel::Outside)?;
        let (side, stride) = (self.side, self.side + 2);
        for ((one, x), y) in self.ones.iter_mut().zip(&self.x).zip(&self.y).take(side * side) {
            *one = if takes_part([position[0] + f64::from(*x), position[1] + f64::from(*y)]) { 1.0 } else { 0.0 };
        }
        self.pixels = self.ones.iter().map(|one| f64::from(*one)).sum();
        if self.pixels < LEAST_PART * (side * side) as f64 {
            return Err(NoModel::Degenerate);
        }
        let of_row = |r: usize| {
            let (framed, ones) = (&self.framed[(r + 1) * stride + 1..][..side], &self.ones[r * side..][..side]);
            framed.iter().zip(ones).map(|(grey, one)| f64::from(*grey) * f64::from(*one)).sum::<f64>()
        };
        self.mean = (0..side).map(of_row).sum::<f64>() / self.pixels;
        let mean = self.mean as f32;
        for r in 0..side {
            for c in 0..side {
                let (k, place) = (r * side + c, (r + 1) * stride + c + 1);
                let along_x = 0.5 * (self.framed[place + 1] - self.framed[place - 1]);
                let along_y = 0.5 * (self.framed[place + stride] - self.framed[place - stride]);
                let (x, y, one) = (self.x[k], self.y[k], self.ones[k]);
                self.grey[k] = one * (self.framed[place] - mean);
                let derivatives = [along_x, along_y, along_x * x, along_x * y, along_y * x, along_y * y];
                self.derivatives.iter_mut().zip(derivatives).for_each(|(column, value)| column[k] = one * value);
            }
        }
        self.square = dot(&self.grey, &self.grey);
        if !(self.square > 0.0) {
            return Err(NoModel::Degenerate);
        }
        self.eliminate_gain_and_offset();
        self.invert()
    }

    fn frame(&mut self, image: GreyView<'_>, position: [f64; 2], spline: &mut Spline) -> Option<()> {
        let (reach, stride) = ((self.side / 2 + 1) as f64, self.side + 2);
        let corner = position.map(|p| p - 0.5 - reach);
        let size = [image.width(), image.height()];
        if !(0..2).all(|axis| corner[axis] >= 0.0 && corner[axis] + stride as f64 <= size[axis] as f64) {
            return None;
        }
        if corner.iter().all(|c| *c == libm::floor(*c)) {
            let [left, top] = corner.map(|c| c as usize);
            for (r, line) in self.framed.chunks_exact_mut(stride).enumerate() {
                line.iter_mut().zip(&image.row(top + r)[left..]).for_each(|(to, grey)| *to = f32::from(*grey));
            }
            return Some(());
        }
        spline.clear();
        if !spline.cover(image, position.map(|p| p - reach), position.map(|p| p + reach), 0.0) {
            return None;
        }
        let origin = [0, 1].map(|axis| corner[axis] + 0.5 - spline.first()[axis]);
        let last = stride - 1;
        let (mut col, mut row) = (0, 0);
        for four in self.framed.chunks_exact_mut(4) {
            let places = [0; 4].map(|_| {
                let place = [origin[0] + col as f64, origin[1] + row as f64].map(|v| v as f32);
                // Past the last pixel it is sampled again.
                (col, row) = match (col < last, row < last) {
                    (true, _) => (col + 1, row),
                    (false, true) => (0, row + 1),
                    (false, false) => (last, last),
                };
                place
            });
            let [x, y] = [0, 1].map(|axis| Lanes::new(places.map(|place| place[axis])));
            spline.sample(x, y).store(four);
        }
        Some(())
    }

    /// The part of each derivative that a change of gain and offset cannot explain.
    fn eliminate_gain_and_offset(&mut self) {
        for column in &mut self.derivatives {
            let mean = Lanes::splat((dot(column, &self.ones) / self.pixels) as f32);
            let share = Lanes::splat((dot(column, &self.grey) / self.square) as f32);
            for ((value, grey), one) in column.chunks_exact_mut(4).zip(self.grey.chunks_exact(4)).zip(self.ones.chunks_exact(4)) {
                let left = Lanes::load(value) - (mean * Lanes::load(one) + share * Lanes::load(grey));
                value.copy_from_slice(&left.to_array());
            }
        }
    }

    fn invert(&mut self) -> Result<(), NoModel> {
        let mut normal = Matrix6::zeros();
        for i in 0..DEFORMATION {
            for j in i..DEFORMATION {
                normal[(i, j)] = dot(&self.derivatives[i], &self.derivatives[j]);
                normal[(j, i)] = normal[(i, j)];
            }
        }
        let shift = Matrix2::new(normal[(0, 0)], normal[(0, 1)], normal[(1, 0)], normal[(1, 1)]);
        let (trace, determinant) = (shift[(0, 0)] + shift[(1, 1)], shift[(0, 0)] * shift[(1, 1)] - shift[(0, 1)] * shift[(1, 0)]);
        let weakest = 0.5 * (trace - (trace * trace - 4.0 * determinant).max(0.0).sqrt());
        let round = 4.0 * determinant >= LEAST_ROUNDNESS * trace * trace;
        if !(round && weakest >= LEAST_GRADIENT * self.pixels) {
            return Err(NoModel::Degenerate);
        }
        self.inverse_of_shift = Matrix2::new(shift[(1, 1)], -shift[(0, 1)], -shift[(1, 0)], shift[(0, 0)]) / determinant;
        // Scaled to unit weights, so that shifts and changes of scale compare.
        let scale: [f64; DEFORMATION] = std::array::from_fn(|k| 1.0 / normal[(k, k)].sqrt());
        let scaled = Matrix6::from_fn(|i, j| normal[(i, j)] * scale[i] * scale[j]);
        let factor = scaled.cholesky().filter(|f| (0..DEFORMATION).all(|k| f.l_dirty()[(k, k)] * f.l_dirty()[(k, k)] >= LEAST_PIVOT));
        self.inverse = factor.map(|f| {
            let inverse = f.inverse();
            Matrix6::from_fn(|i, j| inverse[(i, j)] * scale[i] * scale[j])
        });
        Ok(())
    }
}

/// Σab, four lanes side by side.
fn dot(a: &[f32], b: &[f32]) -> f64 {
    total(a.chunks_exact(4).zip(b.chunks_exact(4)).fold(Lanes::splat(0.0), |sum, (a, b)| sum + Lanes::load(a) * Lanes::load(b)))
}

/// The sum of the lanes.
pub(super) fn total(sum: Lanes) -> f64 {
    let [a, b, c, d] = sum.to_array().map(f64::from);
    (a + b) + (c + d)
}
