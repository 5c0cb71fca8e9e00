//! A ray in the normal equations: what it adds to those of its point and of its image. Symbols as in `reduced`.

use super::collinearity::{Linearised, linearise};
use super::loss::Robust;
use super::network::Sight;
use super::sparse::{Block6, N, subtract_product3};
use super::state::State;

/// A linearised ray with its weight.
pub(super) struct Line {
    pub at: Linearised,
    pub misclosure: [f64; 2],
    /// With the factor of the robust loss.
    pub weight: f64,
}

impl Line {
    pub fn new(sight: &Sight, state: &State, robust: Robust) -> Self {
        let at = linearise(&state.cameras[sight.camera as usize], &state.images[sight.image as usize], &state.points[sight.point as usize]);
        let misclosure = [sight.at[0] - at.at[0], sight.at[1] - at.at[1]];
        let square = sight.weight * (misclosure[0] * misclosure[0] + misclosure[1] * misclosure[1]);
        Self { at, misclosure, weight: sight.weight * robust.factor(square) }
    }

    pub fn by_point(&self) -> [[f64; 3]; 2] {
        self.at.by_point
    }

    pub fn add_to_point(&self, own: &mut [f64; 6], right: &mut [f64; 3]) {
        let ([b, c], w, [vx, vy]) = (&self.at.by_point, self.weight, self.misclosure);
        for (k, (i, j)) in [(0, 0), (1, 0), (1, 1), (2, 0), (2, 1), (2, 2)].into_iter().enumerate() {
            own[k] += w * (b[i] * b[j] + c[i] * c[j]);
        }
        (0..3).for_each(|k| right[k] += w * (b[k] * vx + c[k] * vy));
    }

    /// Z = w AᵀF.
    pub fn share(&self, f: &[[f64; 3]; 2]) -> [f64; 18] {
        let [a, b] = &self.at.by_image;
        let mut share = [0.0; 18];
        for (c, column) in share.as_chunks_mut::<N>().0.iter_mut().enumerate() {
            let (f0, f1) = (self.weight * f[0][c], self.weight * f[1][c]);
            (0..N).for_each(|r| column[r] = a[r] * f0 + b[r] * f1);
        }
        share
    }

    /// Adds w AᵀA - Z Zᵀ and w Aᵀv - Z y.
    pub fn add_to_image(&self, z: &[f64; 18], y: &[f64; 3], diagonal: &mut Block6, scale: &mut [f64; N], right: &mut [f64]) {
        let [a, b] = &self.at.by_image;
        for (c, column) in diagonal.as_chunks_mut::<N>().0.iter_mut().enumerate() {
            let (wa, wb) = (self.weight * a[c], self.weight * b[c]);
            (0..N).for_each(|r| column[r] += a[r] * wa + b[r] * wb);
        }
        subtract_product3(diagonal, z, z);
        let (vx, vy) = (self.weight * self.misclosure[0], self.weight * self.misclosure[1]);
        for r in 0..N {
            scale[r] += self.weight * (a[r] * a[r] + b[r] * b[r]);
            right[r] += a[r] * vx + b[r] * vy - (z[r] * y[0] + z[6 + r] * y[1] + z[12 + r] * y[2]);
        }
    }
}
