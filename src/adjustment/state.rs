//! The values of all unknowns, and how steps move them.

use super::block::{Block, BlockCamera};
use super::collinearity::{CAMERA_PARAMETERS, CameraValues};

/// Exterior orientation of an image.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Pose {
    /// Rows of M.
    pub rotation: [[f64; 3]; 3],
    pub position: [f64; 3],
}

impl Pose {
    /// Turned by three small angles about the photo's axes and shifted.
    pub fn moved(&self, step: &[f64; 6]) -> Self {
        let turn = turn_of([step[0], step[1], step[2]]);
        let position = [0, 1, 2].map(|k| self.position[k] + step[3 + k]);
        Self { rotation: orthonormal(product(&turn, &self.rotation)), position }
    }
}

/// The rotation about a vector by an angle of its length, to second order; exactly a rotation.
pub(super) fn turn_of(vector: [f64; 3]) -> [[f64; 3]; 3] {
    let [x, y, z] = vector.map(|v| 0.5 * v);
    let scale = 2.0 / (1.0 + x * x + y * y + z * z);
    [
        [1.0 - scale * (y * y + z * z), scale * (x * y - z), scale * (x * z + y)],
        [scale * (x * y + z), 1.0 - scale * (x * x + z * z), scale * (y * z - x)],
        [scale * (x * z - y), scale * (y * z + x), 1.0 - scale * (x * x + y * y)],
    ]
}

/// The product of two matrices.
pub(super) fn product(a: &[[f64; 3]; 3], b: &[[f64; 3]; 3]) -> [[f64; 3]; 3] {
    a.map(|row| [0, 1, 2].map(|k| row[0] * b[0][k] + row[1] * b[1][k] + row[2] * b[2][k]))
}

/// Rows made orthonormal again, so that rounding does not add up over many steps.
pub(super) fn orthonormal([first, second, _]: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
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

/// All unknowns of a block, those that are not estimated included.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct State {
    pub cameras: Vec<CameraValues>,
    pub images: Vec<Pose>,
    pub points: Vec<[f64; 3]>,
}

impl State {
    pub fn of(block: &Block) -> Self {
        Self {
            cameras: block.cameras.iter().map(values_of).collect(),
            images: block.images.iter().map(|i| Pose { rotation: orthonormal(i.rotation), position: i.position }).collect(),
            points: block.points.iter().map(|p| p.position).collect(),
        }
    }

    /// The block with these values.
    pub fn put_into(&self, mut block: Block) -> Block {
        for (camera, values) in block.cameras.iter_mut().zip(&self.cameras) {
            let [f, cx, cy, k1, k2, k3, p1, p2] = *values;
            *camera = BlockCamera { focal_px: f, principal_point_px: [cx, cy], radial: [k1, k2, k3], tangential: [p1, p2], ..*camera };
        }
        for (image, pose) in block.images.iter_mut().zip(&self.images) {
            (image.rotation, image.position) = (pose.rotation, pose.position);
        }
        for (point, position) in block.points.iter_mut().zip(&self.points) {
            point.position = *position;
        }
        block
    }
}

/// The parameters in the order of the unknowns.
pub(crate) fn values_of(camera: &BlockCamera) -> CameraValues {
    let ([cx, cy], [k1, k2, k3], [p1, p2]) = (camera.principal_point_px, camera.radial, camera.tangential);
    [camera.focal_px, cx, cy, k1, k2, k3, p1, p2]
}

/// Which parameters of a camera are to be estimated.
pub(crate) fn free_of(camera: &BlockCamera) -> [bool; CAMERA_PARAMETERS] {
    let free = camera.free;
    let radial = |k: usize| free.radial >= k;
    [free.focal, free.principal_point, free.principal_point, radial(1), radial(2), radial(3), free.tangential, free.tangential]
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
