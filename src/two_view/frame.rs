//! Between pixel positions and the plane coordinates in which geometry is computed.
//!
//! A position X, Y in px (y down) is x = (X - cx)/u, y = -(Y - cy)/u, its direction (x, y, -1): in a calibrated view u is the focal length and
//! (cx, cy) the principal point. In homogeneous terms p = A q.

use crate::orientation::Ray;
use nalgebra::Matrix3;

/// Origin and unit of the coordinates of one image.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct View {
    /// Origin in px.
    pub centre: [f64; 2],
    /// One unit in px.
    pub unit: f64,
}

impl View {
    /// A: from coordinates to px.
    fn matrix(&self) -> Matrix3<f64> {
        let ([x, y], u) = (self.centre, self.unit);
        Matrix3::new(u, 0.0, -x, 0.0, -u, -y, 0.0, 0.0, -1.0)
    }

    /// A⁻¹: from px to coordinates.
    fn inverse(&self) -> Matrix3<f64> {
        let ([x, y], u) = (self.centre, self.unit);
        Matrix3::new(1.0 / u, 0.0, -x / u, 0.0, -1.0 / u, y / u, 0.0, 0.0, -1.0)
    }

    fn coordinates(&self, x: f64, y: f64) -> [f64; 2] {
        [(x - self.centre[0]) / self.unit, (self.centre[1] - y) / self.unit]
    }
}

/// Both views of a pair.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Frame {
    pub left: View,
    pub right: View,
}

impl Frame {
    /// About the mean positions, in units of their mean distance from these, so that products of coordinates are near 1.
    pub fn normalising(points: &[[f64; 4]]) -> Self {
        let n = points.len().max(1) as f64;
        let mean: [f64; 4] = std::array::from_fn(|k| points.iter().map(|p| p[k]).sum::<f64>() / n);
        let distance = |p: &[f64; 4], k: usize| {
            let (dx, dy) = (p[k] - mean[k], p[k + 1] - mean[k + 1]);
            (dx * dx + dy * dy).sqrt()
        };
        // One unit for both images: distances in either weigh the same.
        let mut unit = points.iter().map(|p| 0.5 * (distance(p, 0) + distance(p, 2))).sum::<f64>() / n;
        if !(unit > 1e-6) {
            unit = 1.0;
        }
        Self { left: View { centre: [mean[0], mean[1]], unit }, right: View { centre: [mean[2], mean[3]], unit } }
    }

    pub fn rays(&self, points: &[[f64; 4]]) -> Vec<Ray> {
        let ray = |&[xl, yl, xr, yr]: &[f64; 4]| {
            let ([a, b], [c, d]) = (self.left.coordinates(xl, yl), self.right.coordinates(xr, yr));
            [a, b, c, d]
        };
        points.iter().map(ray).collect()
    }

    /// Length of a unit in px, the geometric mean of both views.
    pub fn px(&self) -> f64 {
        (self.left.unit * self.right.unit).sqrt()
    }

    /// A fundamental matrix between px from one between coordinates, of norm 1.
    pub fn fundamental_px(&self, matrix: &Matrix3<f64>) -> Matrix3<f64> {
        of_norm_one(&(self.right.inverse().transpose() * matrix * self.left.inverse()))
    }

    /// A homography between px from one between coordinates, of norm 1.
    pub fn homography_px(&self, matrix: &Matrix3<f64>) -> Matrix3<f64> {
        of_norm_one(&(self.right.matrix() * matrix * self.left.inverse()))
    }

    /// A fundamental matrix between coordinates from one between px.
    pub fn fundamental_from_px(&self, matrix: &Matrix3<f64>) -> Matrix3<f64> {
        of_norm_one(&(self.right.matrix().transpose() * matrix * self.left.matrix()))
    }

    /// A homography between coordinates from one between px.
    pub fn homography_from_px(&self, matrix: &Matrix3<f64>) -> Matrix3<f64> {
        of_norm_one(&(self.right.inverse() * matrix * self.left.matrix()))
    }
}

/// The matrix divided by its norm, its largest entry positive: of homogeneous matrices one stands for all multiples.
fn of_norm_one(matrix: &Matrix3<f64>) -> Matrix3<f64> {
    let largest = matrix.iter().fold(0.0f64, |largest, v| if v.abs() > largest.abs() { *v } else { largest });
    matrix / if largest < 0.0 { -matrix.norm() } else { matrix.norm() }
}

/// The rows of a matrix.
pub(super) fn rows(matrix: &Matrix3<f64>) -> [[f64; 3]; 3] {
    std::array::from_fn(|i| std::array::from_fn(|j| matrix[(i, j)]))
}

/// The matrix of these rows.
pub(super) fn matrix(rows: &[[f64; 3]; 3]) -> Matrix3<f64> {
    Matrix3::from_fn(|i, j| rows[i][j])
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector3;

    #[test]
    fn conditions_hold_in_px_as_in_coordinates() {
        let points = [[10.0, 20.0, 35.0, 18.0], [700.0, 90.0, 610.0, 110.0], [320.0, 410.0, 300.0, 480.0]];
        let frame = Frame::normalising(&points);
        let matrix = Matrix3::new(0.1, -0.3, 0.2, 0.4, 0.9, -0.5, 0.3, 0.6, 0.7);
        let (fundamental, homography) = (frame.fundamental_px(&matrix), frame.homography_px(&matrix));
        let mut ratios = Vec::new();
        for ([xl, yl, xr, yr], [a, b, c, d]) in points.into_iter().zip(frame.rays(&points)) {
            let (p, q) = (Vector3::new(xl, yl, 1.0), Vector3::new(xr, yr, 1.0));
            let (left, right) = (Vector3::new(a, b, -1.0), Vector3::new(c, d, -1.0));
            ratios.push(q.dot(&(fundamental * p)) / right.dot(&(matrix * left)));
            let (seen, wanted) = (homography * p, matrix * left);
            let wanted = frame.right.matrix() * wanted;
            assert!((seen.x / seen.z - wanted.x / wanted.z).abs() < 1e-9 && (seen.y / seen.z - wanted.y / wanted.z).abs() < 1e-9);
            let back = frame.left.matrix() * left;
            assert!((back - p).amax() < 1e-9);
            assert!((frame.fundamental_from_px(&fundamental) - matrix / matrix.norm()).amax() < 1e-12);
            assert!((frame.homography_from_px(&homography) - matrix / matrix.norm()).amax() < 1e-12);
        }
        assert!(ratios.iter().all(|ratio| (ratio / ratios[0] - 1.0).abs() < 1e-9), "{ratios:?}");
    }
}
