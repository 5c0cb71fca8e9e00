//! Observations in random order and as columns, and their distances from coplanarity with a matrix.

use super::coplanarity::Ray;
use crate::math::{BLOCK, Random};
use nalgebra::Matrix3;
use std::ops::Range;

/// The observations of a search for consensus.
#[derive(Debug)]
pub(crate) struct Field {
    pub rays: Vec<Ray>,
    columns: [Vec<f64>; 4],
}

impl Field {
    /// Takes the observations, in a random order that `seed` chooses.
    pub fn new(rays: &[Ray], seed: u32) -> Self {
        let mut order = rays.to_vec();
        Random::new(seed).shuffle(&mut order);
        Self { columns: std::array::from_fn(|k| order.iter().map(|ray| ray[k]).collect()), rays: order }
    }

    /// Squares of the distances of consecutive observations.
    pub fn squares(&self, matrix: &Matrix3<f64>, range: Range<usize>, squares: &mut [f64; BLOCK]) {
        let columns: [&[f64]; 4] = std::array::from_fn(|k| &self.columns[k][range.clone()]);
        for (k, square) in squares.iter_mut().enumerate().take(range.len()) {
            *square = square_distance(matrix, [columns[0][k], columns[1][k], columns[2][k], columns[3][k]]);
        }
    }

    /// The distances of the first `count` observations; the largest number where there is none.
    pub fn distances(&self, matrix: &Matrix3<f64>, count: usize) -> Vec<f64> {
        let count = count.min(self.rays.len());
        // By columns, of which compilers take several at once.
        let [a, b, c, d]: [&[f64]; 4] = std::array::from_fn(|k| &self.columns[k][..count]);
        let distance = |k: usize| square_distance(matrix, [a[k], b[k], c[k], d[k]]).sqrt();
        (0..count).map(distance).map(|d| if d.is_finite() { d } else { f64::MAX }).collect()
    }

    /// Those within a distance.
    pub fn within(&self, matrix: Matrix3<f64>, limit: f64) -> impl Iterator<Item = &Ray> {
        let limit = limit * limit;
        self.rays.iter().filter(move |ray| square_distance(&matrix, **ray) <= limit)
    }
}

/// Square of the distance of a point's coordinates from the condition of a matrix, to first order.
///
/// # Source
/// Sampson 1982, Fitting conic sections to very scattered data.
#[inline(always)]
pub(crate) fn square_distance(e: &Matrix3<f64>, [xl, yl, xr, yr]: Ray) -> f64 {
    let (line_x, line_y) = (e[(0, 0)] * xl + e[(0, 1)] * yl - e[(0, 2)], e[(1, 0)] * xl + e[(1, 1)] * yl - e[(1, 2)]);
    let line_z = e[(2, 0)] * xl + e[(2, 1)] * yl - e[(2, 2)];
    let (back_x, back_y) = (e[(0, 0)] * xr + e[(1, 0)] * yr - e[(2, 0)], e[(0, 1)] * xr + e[(1, 1)] * yr - e[(2, 1)]);
    let condition = xr * line_x + yr * line_y - line_z;
    condition * condition / (line_x * line_x + line_y * line_y + back_x * back_x + back_y * back_y)
}
