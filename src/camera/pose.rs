//! Exterior orientation: where an image was taken from, and how it is turned.

use super::rotation::angles_from_rotation;
use nalgebra::Matrix3;
use serde::{Deserialize, Serialize};

/// The exterior orientation of an image.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Pose {
    /// Rows of M, from object to photo, x right, y up, against the view: photo = M·(X - X₀).
    pub rotation: [[f64; 3]; 3],
    /// Projection centre X₀, in m where the object space has a scale.
    pub position: [f64; 3],
}

impl Pose {
    /// From the matrix M and the projection centre X₀.
    pub fn new(rotation: &Matrix3<f64>, position: [f64; 3]) -> Self {
        Self { rotation: [0, 1, 2].map(|r| [0, 1, 2].map(|c| rotation[(r, c)])), position }
    }

    /// M.
    pub fn matrix(&self) -> Matrix3<f64> {
        matrix(&self.rotation)
    }

    /// `[ω, φ, κ]` in radians: see [`angles_from_rotation`].
    pub fn angles(&self) -> [f64; 3] {
        angles_from_rotation(&self.matrix())
    }

    /// A point in the photo's system: (U, V, W).
    pub fn to_photo(&self, point: &[f64; 3]) -> [f64; 3] {
        let d = [point[0] - self.position[0], point[1] - self.position[1], point[2] - self.position[2]];
        self.rotation.map(|row| row[0] * d[0] + row[1] * d[1] + row[2] * d[2])
    }

    /// The direction in the object space of the ray that is seen at (x, y), as [`Camera::direction`](crate::Camera::direction) has it.
    pub(crate) fn ray(&self, [x, y]: [f64; 2]) -> [f64; 3] {
        let m = &self.rotation;
        [0, 1, 2].map(|k| m[0][k] * x - m[1][k] * y - m[2][k])
    }

    /// Turned by three small angles about the photo's axes and shifted.
    pub(crate) fn moved(&self, step: &[f64; 6]) -> Self {
        let turn = turn_of([step[0], step[1], step[2]]);
        let position = [0, 1, 2].map(|k| self.position[k] + step[3 + k]);
        Self { rotation: orthonormal(product(&turn, &self.rotation)), position }
    }
}

/// The matrix of these rows.
pub(crate) fn matrix(rows: &[[f64; 3]; 3]) -> Matrix3<f64> {
    Matrix3::from_fn(|i, j| rows[i][j])
}

/// The rotation about a vector by an angle of its length, to second order; exactly a rotation.
pub(crate) fn turn_of(vector: [f64; 3]) -> [[f64; 3]; 3] {
    let [x, y, z] = vector.map(|v| 0.5 * v);
    let scale = 2.0 / (1.0 + x * x + y * y + z * z);
    [
        [1.0 - scale * (y * y + z * z), scale * (x * y - z), scale * (x * z + y)],
        [scale * (x * y + z), 1.0 - scale * (x * x + z * z), scale * (y * z - x)],
        [scale * (x * z - y), scale * (y * z + x), 1.0 - scale * (x * x + y * y)],
    ]
}

/// The product of two matrices.
pub(crate) fn product(a: &[[f64; 3]; 3], b: &[[f64; 3]; 3]) -> [[f64; 3]; 3] {
    a.map(|row| [0, 1, 2].map(|k| row[0] * b[0][k] + row[1] * b[1][k] + row[2] * b[2][k]))
}

/// How far elements may be from those of the nearest rotation.
const ROTATION_TOLERANCE: f64 = 1e-6;

/// Whether rows are at right angles, of length 1, and right-handed.
pub(crate) fn is_rotation(m: &[[f64; 3]; 3]) -> bool {
    m.iter().flatten().zip(orthonormal(*m).iter().flatten()).all(|(a, b)| (a - b).abs() < ROTATION_TOLERANCE)
}

/// Rows made orthonormal again, so that rounding does not add up over many steps.
pub(crate) fn orthonormal([first, second, _]: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
    let dot = |a: &[f64; 3], b: &[f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let unit = |a: [f64; 3]| {
        let length = dot(&a, &a).sqrt();
        a.map(|v| v / length)
    };
    let first = unit(first);
    let along = dot(&first, &second);
    let second = unit([0, 1, 2].map(|k| second[k] - along * first[k]));
    let third = [
        first[1] * second[2] - first[2] * second[1],
        first[2] * second[0] - first[0] * second[2],
        first[0] * second[1] - first[1] * second[0],
    ];
    [first, second, third]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_turn_is_a_rotation_by_its_vector() {
        let turn = turn_of([0.02, -0.01, 0.03]);
        let back = product(&turn, &turn_of([-0.02, 0.01, -0.03]));
        for r in 0..3 {
            for c in 0..3 {
                assert!((back[r][c] - f64::from(u8::from(r == c))).abs() < 1e-15);
            }
        }
        // To first order I + [δ]×.
        assert!((turn[1][0] - 0.03).abs() < 5e-4 && (turn[0][2] + 0.01).abs() < 5e-4 && (turn[2][1] - 0.02).abs() < 5e-4);
        let same = orthonormal(turn);
        assert!(turn.iter().flatten().zip(same.iter().flatten()).all(|(a, b)| (a - b).abs() < 1e-15));
    }
}
