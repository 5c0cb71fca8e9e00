//! Solves the reduced normal equations: a sparse factor of the images, bordered by the cameras and the systematic errors of positions.

use super::factor3::backward3;
use super::network::Columns;
use super::reduced::{Problem, Reduced};
use super::sparse::{DenseFactor, Factor, N, Pattern, Refused};
use super::state::State;
use crate::math::dot3;

/// Why the normal equations could not be solved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Singular {
    Image(Refused),
    /// The column of a camera parameter or of a systematic error.
    Column(usize),
}

/// The factor of the reduced normal equations.
pub(super) struct Factored {
    pub images: Factor,
    /// L⁻¹ of the border's columns.
    pub border: Vec<Vec<f64>>,
    /// Of the cameras, the images eliminated.
    pub cameras: DenseFactor,
}

impl Factored {
    /// Factors the equations; takes the matrix and the border out of them.
    pub fn new(pattern: &Pattern, reduced: &mut Reduced) -> Result<Self, Singular> {
        let matrix = std::mem::replace(&mut reduced.matrix, super::sparse::SparseMatrix { diagonal: Vec::new(), below: Vec::new() });
        let images = Factor::new(pattern, matrix, &reduced.scale).map_err(Singular::Image)?;
        let mut border = std::mem::take(&mut reduced.border);
        border.iter_mut().for_each(|column| images.forward(pattern, column));
        let q = border.len();
        let mut corner = reduced.corner.clone();
        for row in 0..q {
            for column in 0..=row {
                corner[row * q + column] -= dot(&border[row], &border[column]);
            }
        }
        let cameras = DenseFactor::new(corner, q, &reduced.corner_scale).map_err(Singular::Column)?;
        Ok(Self { images, border, cameras })
    }

    /// Solves for images (six numbers a place) and cameras.
    pub fn solve(&self, pattern: &Pattern, images: &mut [f64], cameras: &mut [f64]) {
        self.images.forward(pattern, images);
        for (column, value) in self.border.iter().zip(cameras.iter_mut()) {
            *value -= dot(column, images);
        }
        self.cameras.forward(cameras);
        self.cameras.backward(cameras);
        for (column, value) in self.border.iter().zip(cameras.iter()) {
            images.iter_mut().zip(column).for_each(|(x, t)| *x -= t * value);
        }
        self.images.backward(pattern, images);
    }
}

pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// A change of all unknowns.
#[derive(Debug, Clone)]
pub(super) struct Step {
    /// Turns and shift of each image.
    pub images: Vec<[f64; N]>,
    /// By columns.
    pub cameras: Vec<f64>,
    pub points: Vec<[f64; 3]>,
    /// δᵀb, which is δᵀNδ where nothing was damped.
    pub square: f64,
}

impl Step {
    /// The step that the equations give.
    pub fn new(problem: &Problem<'_>, reduced: &Reduced, factored: &Factored) -> Self {
        let (mut images, mut cameras) = (reduced.right.clone(), reduced.corner_right.clone());
        factored.solve(&problem.network.pattern, &mut images, &mut cameras);
        Self::of(problem, reduced, images, cameras)
    }

    /// The step of which images (six numbers a place) and cameras are known.
    pub fn of(problem: &Problem<'_>, reduced: &Reduced, images: Vec<f64>, cameras: Vec<f64>) -> Self {
        let pattern = &problem.network.pattern;
        let mut square = dot(&images, &reduced.right) + dot(&cameras, &reduced.corner_right);
        square += reduced.points.iter().map(|p| dot3(&p.right, &p.right)).sum::<f64>();
        let points = (0..problem.network.points())
            .map(|point| reduced.back_substitute(problem, point, reduced.points[point].right, &images, &cameras))
            .collect();
        let images = pattern.place.iter().map(|at| std::array::from_fn(|k| images[*at as usize * N + k])).collect();
        Self { images, cameras, points, square }
    }

    /// The values after the step.
    pub fn applied_to(&self, state: &State, columns: &Columns) -> State {
        let mut cameras = state.cameras.clone();
        for (&(camera, parameter), value) in columns.parameter.iter().zip(&self.cameras) {
            cameras[camera][parameter] += value;
        }
        let images = state.images.iter().zip(&self.images).map(|(pose, step)| pose.moved(step)).collect();
        let points = state.points.iter().zip(&self.points).map(|(p, step)| [0, 1, 2].map(|k| p[k] + step[k])).collect();
        let mut systematic = state.systematic.clone();
        for (&(error, axis), value) in columns.systematic.iter().zip(&self.cameras[columns.parameter.len()..]) {
            systematic[error][axis] += value;
        }
        State { cameras, images, points, systematic }
    }
}

impl Reduced {
    /// A point's part of a solution: L⁻ᵀ(`right` - Σ Zᵀδ), with `images` by places and `cameras` by columns.
    pub fn back_substitute(&self, problem: &Problem<'_>, point: usize, mut right: [f64; 3], images: &[f64], cameras: &[f64]) -> [f64; 3] {
        let network = problem.network;
        let factor = &self.points[point].factor;
        if factor[0] == 0.0 {
            return [0.0; 3];
        }
        for sight in network.point_start[point]..network.point_start[point + 1] {
            let at = network.pattern.place[network.sights[sight].image as usize] as usize;
            let (z, x) = (&self.shares[sight], &images[at * N..][..N]);
            (0..3).for_each(|c| right[c] -= (0..N).map(|r| z[c * N + r] * x[r]).sum::<f64>());
        }
        for (column, share) in &self.camera_shares[self.camera_start[point]..self.camera_start[point + 1]] {
            (0..3).for_each(|c| right[c] -= share[c] * cameras[*column as usize]);
        }
        backward3(factor, right)
    }
}
