//! The seven inner constraints of a free network: they keep the orientations of all images in the middle of where they were.

use super::rotation::rotation;
use nalgebra::{Matrix3, SMatrix, SVector, Vector3};

/// What a change of a position by one mean distance of the points does to the observations of an image, in px, by its order of magnitude.
const STRENGTH: f64 = 2e4;

type Seven = SMatrix<f64, 7, 7>;

/// Constraints and motions of the whole block, each over all unknowns.
pub struct Inner {
    constraints: [Vec<f64>; 7],
    /// Motions that each change one constraint by 1 and the others by 0.
    motions: [Vec<f64>; 7],
}

impl Inner {
    /// `images` first, six unknowns each (ω φ κ, X₀); `first_point`: where those of the points begin, three each. `distance`: the mean one of the
    /// points.
    pub fn new(values: &[f64], images: usize, first_point: usize, distance: f64) -> Self {
        let position = |image: usize| Vector3::from_column_slice(&values[6 * image + 3..][..3]);
        let middle = (0..images).map(position).sum::<Vector3<f64>>() / images as f64;
        let mut constraints: [Vec<f64>; 7] = std::array::from_fn(|_| vec![0.0; values.len()]);
        let mut plain = constraints.clone();
        for image in 0..images {
            let (at, arm) = (6 * image, position(image) - middle);
            let angles: [f64; 3] = std::array::from_fn(|k| values[at + k]);
            let (m, by_angles) = (matrix(angles), turns_by_angles(angles));
            let to_angles = by_angles.try_inverse().unwrap();
            for axis in 0..3 {
                let along: Vector3<f64> = Vector3::ith(axis, 1.0);
                // Shifts, the scale, turns in arcs at the mean distance.
                constraints[axis][at + 3 + axis] = 1.0;
                plain[axis][at + 3 + axis] = 1.0;
                constraints[3][at + 3 + axis] = arm[axis] / distance;
                plain[3][at + 3 + axis] = arm[axis] / distance;
                let of_turn = -distance * (along.transpose() * m.transpose() * by_angles);
                let (by_position, moved) = (along.cross(&arm), along.cross(&arm) / distance);
                let turned = to_angles * (-(m * along)) / distance;
                for k in 0..3 {
                    constraints[4 + axis][at + k] = of_turn[k];
                    constraints[4 + axis][at + 3 + k] = by_position[k] / distance;
                    plain[4 + axis][at + k] = turned[k];
                    plain[4 + axis][at + 3 + k] = moved[k];
                }
            }
        }
        for at in (first_point..values.len()).step_by(3) {
            let arm = Vector3::from_column_slice(&values[at..][..3]) - middle;
            for axis in 0..3 {
                let turned = Vector3::ith(axis, 1.0).cross(&arm) / distance;
                plain[axis][at + axis] = 1.0;
                plain[3][at + axis] = arm[axis] / distance;
                (0..3).for_each(|k| plain[4 + axis][at + k] = turned[k]);
            }
        }
        // As heavy as the observations of an image: these hold motions of the block by what rounding leaves in their derivatives.
        constraints.iter_mut().flatten().for_each(|value| *value *= STRENGTH / distance);
        let met = Seven::from_fn(|row, column| dot(&constraints[row], &plain[column]));
        let inverse = met.try_inverse().unwrap();
        let motion = |k: usize| (0..values.len()).map(|at| (0..7).map(|l| plain[l][at] * inverse[(l, k)]).sum()).collect();
        Self { constraints, motions: std::array::from_fn(motion) }
    }

    /// The constraints as observations of zero.
    pub fn rows(&self) -> impl Iterator<Item = Vec<(usize, f64)>> {
        self.constraints.iter().map(|row| row.iter().copied().enumerate().filter(|(_, value)| *value != 0.0).collect())
    }

    /// Takes what moves the whole block from a change of the unknowns.
    pub fn take_motion(&self, change: &mut [f64]) {
        let sums = SVector::<f64, 7>::from_fn(|k, _| dot(&self.constraints[k], change));
        for (at, value) in change.iter_mut().enumerate() {
            *value -= (0..7).map(|k| self.motions[k][at] * sums[k]).sum::<f64>();
        }
    }

    /// From the diagonal of (N + CᵀC)⁻¹ to that of the cofactors in this datum.
    pub fn constrain(&self, cofactors: &mut [f64]) {
        for (at, cofactor) in cofactors.iter_mut().enumerate() {
            *cofactor -= self.motions.iter().map(|motion| motion[at] * motion[at]).sum::<f64>();
        }
    }
}

fn matrix(angles: [f64; 3]) -> Matrix3<f64> {
    let m = rotation(angles);
    Matrix3::from_fn(|row, column| m[row][column])
}

/// The small turns δ about the photo's axes, by which M becomes R(δ)·M, of small changes of ω, φ, κ; by differences.
fn turns_by_angles(angles: [f64; 3]) -> Matrix3<f64> {
    let m = matrix(angles);
    let of = |k: usize| {
        let moved = |step: f64| {
            let mut moved = angles;
            moved[k] += step;
            matrix(moved)
        };
        let skew = (moved(1e-5) - moved(-1e-5)) / 2e-5 * m.transpose();
        Vector3::new(skew[(2, 1)], skew[(0, 2)], skew[(1, 0)])
    };
    Matrix3::from_columns(&[of(0), of(1), of(2)])
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
