//! Similarity transformations of a block, and the one that takes positions onto others.

use super::state::State;
use crate::camera::{Pose, orthonormal, product};
use crate::math::{dot3, minus};
use nalgebra::{Matrix3, Matrix4, Vector3};

/// Least width of the observed positions across the line through them, as a share of their length.
pub(super) const LEAST_WIDTH: f64 = 1e-3;

/// A similarity transformation: X becomes `to` + scale · R (X - `from`).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Similarity {
    pub scale: f64,
    /// Rows of R.
    pub rotation: [[f64; 3]; 3],
    pub from: [f64; 3],
    pub to: [f64; 3],
}

impl Similarity {
    /// The one that takes positions onto others with the least squares of what is left. `None` without extent.
    ///
    /// # Source
    /// Horn 1987, Closed-form solution of absolute orientation using unit quaternions.
    pub fn between(pairs: &[([f64; 3], [f64; 3])]) -> Option<Self> {
        let from = middle(pairs.iter().map(|pair| pair.0));
        let to = middle(pairs.iter().map(|pair| pair.1));
        let mut s = [[0.0; 3]; 3];
        let mut square = 0.0;
        for (a, b) in pairs {
            let (a, b) = (minus(a, &from), minus(b, &to));
            (0..9).for_each(|k| s[k / 3][k % 3] += a[k / 3] * b[k % 3]);
            square += dot3(&a, &a);
        }
        let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = s;
        #[rustfmt::skip]
        let matrix = Matrix4::new(
            xx + yy + zz, yz - zy, zx - xz, xy - yx,
            yz - zy, xx - yy - zz, xy + yx, zx + xz,
            zx - xz, xy + yx, yy - xx - zz, yz + zy,
            xy - yx, zx + xz, yz + zy, zz - xx - yy,
        );
        let eigen = matrix.symmetric_eigen();
        let quaternion = eigen.eigenvectors.column(eigen.eigenvalues.imax());
        let [w, x, y, z] = [0, 1, 2, 3].map(|k| quaternion[k]);
        let rotation = orthonormal([
            [w * w + x * x - y * y - z * z, 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
            [2.0 * (x * y + w * z), w * w - x * x + y * y - z * z, 2.0 * (y * z - w * x)],
            [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), w * w - x * x - y * y + z * z],
        ]);
        let along: f64 = pairs.iter().map(|(a, b)| dot3(&turned(&rotation, &minus(a, &from)), &minus(b, &to))).sum();
        let scale = along / square;
        (scale.is_finite() && scale > 0.0).then_some(Self { scale, rotation, from, to })
    }

    /// Where it takes a point.
    pub fn point(&self, point: &[f64; 3]) -> [f64; 3] {
        let turned = turned(&self.rotation, &minus(point, &self.from));
        [0, 1, 2].map(|k| self.to[k] + self.scale * turned[k])
    }

    /// The whole block, moved: every ray keeps its residual.
    pub(super) fn state(&self, state: &State) -> State {
        let r = &self.rotation;
        let back = [0, 1, 2].map(|i| [0, 1, 2].map(|j| r[j][i]));
        let image = |pose: &Pose| Pose { rotation: orthonormal(product(&pose.rotation, &back)), position: self.point(&pose.position) };
        State {
            cameras: state.cameras.clone(),
            images: state.images.iter().map(image).collect(),
            points: state.points.iter().map(|p| self.point(p)).collect(),
            systematic: state.systematic.clone(),
        }
    }
}

fn turned(rotation: &[[f64; 3]; 3], vector: &[f64; 3]) -> [f64; 3] {
    rotation.map(|row| dot3(&row, vector))
}

/// Width of the observed positions across their longest axis by the length along it.
pub(crate) fn relative_width(positions: &[[f64; 3]]) -> f64 {
    let centre = middle(positions.iter().copied());
    let scatter = scatter(positions.iter().copied(), &centre);
    let mut values: Vec<f64> = scatter.symmetric_eigenvalues().iter().copied().collect();
    values.sort_by(f64::total_cmp);
    (values[1].max(0.0) / values[2]).sqrt()
}

/// The sum of the squares and products of what positions are off a centre.
pub(super) fn scatter(positions: impl Iterator<Item = [f64; 3]>, centre: &[f64; 3]) -> Matrix3<f64> {
    let of_one = |position: [f64; 3]| {
        let d = Vector3::from(minus(&position, centre));
        d * d.transpose()
    };
    positions.map(of_one).sum()
}

/// The mean of positions.
pub(super) fn middle(positions: impl Iterator<Item = [f64; 3]>) -> [f64; 3] {
    let (mut sum, mut number) = ([0.0; 3], 0.0);
    for position in positions {
        (0..3).for_each(|k| sum[k] += position[k]);
        number += 1.0;
    }
    sum.map(|s| s / number)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::camera::turn_of;

    #[test]
    fn a_similarity_is_found_again() {
        let wanted = Similarity { scale: 2.5, rotation: turn_of([1.2, -0.7, 2.0]), from: [0.0; 3], to: [100.0, -50.0, 7.0] };
        let places = [[1.0, 2.0, 3.0], [-4.0, 0.5, 1.0], [2.0, -3.0, 0.0], [0.0, 5.0, -2.0]];
        let pairs: Vec<_> = places.iter().map(|p| (*p, wanted.point(p))).collect();
        let found = Similarity::between(&pairs).unwrap();
        for p in [[10.0, -20.0, 5.0], [0.3, 0.2, 0.1]] {
            let (a, b) = (found.point(&p), wanted.point(&p));
            assert!((0..3).all(|k| (a[k] - b[k]).abs() < 1e-11), "{a:?} {b:?}");
        }
        assert!(Similarity::between(&[([1.0; 3], [2.0; 3]); 3]).is_none());
    }
}
