//! Brown's distortion of a lens: forward, with its derivatives, and inverse.
//!
//! With r² = x² + y² a direction (x, y), y down, is seen at x (1 + k₁r² + k₂r⁴ + k₃r⁶) + 2p₁xy + p₂(r² + 2x²) and
//! y (1 + k₁r² + k₂r⁴ + k₃r⁶) + p₁(r² + 2y²) + 2p₂xy, in units of the focal length.
//!
//! # Source
//! Brown 1971, Close-range camera calibration, in the direction from object to image, as OpenCV and COLMAP write it.

use nalgebra::{Matrix3, Vector3};

/// Number of parameters of a camera: f, c_x, c_y, k₁, k₂, k₃, p₁, p₂.
pub(crate) const CAMERA_PARAMETERS: usize = 8;

/// Parameters of a camera in that order.
pub(crate) type CameraValues = [f64; CAMERA_PARAMETERS];

/// Steps of the inverse's iteration, and the change in units of the focal length at which it ends.
pub(super) const MOST_STEPS: usize = 100;
const SETTLED: f64 = 1e-14;

/// 1 + k₁r² + k₂r⁴ + k₃r⁶.
pub(crate) fn radial_factor([k1, k2, k3]: [f64; 3], r2: f64) -> f64 {
    1.0 + r2 * (k1 + r2 * (k2 + r2 * k3))
}

/// k₁, k₂, k₃ by which r (1 + k₁r² + k₂r⁴ + k₃r⁶) comes nearest to s, by least squares over pairs (r, s); `farthest` is the largest r.
pub(super) fn fitted_terms(pairs: impl Iterator<Item = (f64, f64)>, farthest: f64) -> [f64; 3] {
    let (mut normal, mut right) = (Matrix3::zeros(), Vector3::zeros());
    for (from, to) in pairs {
        // In units of the farthest radius the powers stay near each other.
        let t2 = (from / farthest) * (from / farthest);
        let row = Vector3::new(t2, t2 * t2, t2 * t2 * t2) * from;
        normal += row * row.transpose();
        right += row * (to - from);
    }
    let solved = normal.lu().solve(&right).filter(|terms| terms.iter().all(|term| term.is_finite()));
    let r2 = farthest * farthest;
    solved.map_or([0.0; 3], |terms| [terms.x / r2, terms.y / (r2 * r2), terms.z / (r2 * r2 * r2)])
}

/// By how much the tangential terms of a correction move a position (x, y) of the photo, y up: r²·P + 2 (P·x)·x.
pub(super) fn tangential_shift([p1, p2]: [f64; 2], [x, y]: [f64; 2]) -> [f64; 2] {
    let (r2, twice) = (x * x + y * y, 2.0 * (p1 * x + p2 * y));
    [r2 * p1 + twice * x, r2 * p2 + twice * y]
}

/// The pixel of a direction.
pub(crate) fn distorted(camera: &CameraValues, x: f64, y: f64) -> [f64; 2] {
    let [f, cx, cy, k1, k2, k3, p1, p2] = *camera;
    let r2 = x * x + y * y;
    let radial = radial_factor([k1, k2, k3], r2);
    let across = 2.0 * x * y;
    [cx + f * (x * radial + p1 * across + p2 * (r2 + 2.0 * x * x)), cy + f * (y * radial + p1 * (r2 + 2.0 * y * y) + p2 * across)]
}

/// The pixel of a direction with its derivatives: rows are column and row of the pixel.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LinearisedLens {
    pub at: [f64; 2],
    pub by_direction: [[f64; 2]; 2],
    pub by_camera: [CameraValues; 2],
}

/// As [`distorted`], with the derivatives.
pub(crate) fn linearised_lens(camera: &CameraValues, x: f64, y: f64) -> LinearisedLens {
    let [f, cx, cy, k1, k2, k3, p1, p2] = *camera;
    let r2 = x * x + y * y;
    let radial = radial_factor([k1, k2, k3], r2);
    let slope = k1 + r2 * (2.0 * k2 + 3.0 * r2 * k3);
    let across = 2.0 * x * y;
    let (along_x, along_y) = (r2 + 2.0 * x * x, r2 + 2.0 * y * y);
    let xd = x * radial + p1 * across + p2 * along_x;
    let yd = y * radial + p1 * along_y + p2 * across;
    let mixed = f * (across * slope + 2.0 * (p1 * x + p2 * y));
    let xx = f * (radial + 2.0 * x * x * slope + 2.0 * p1 * y + 6.0 * p2 * x);
    let yy = f * (radial + 2.0 * y * y * slope + 6.0 * p1 * y + 2.0 * p2 * x);
    let powers = [r2, r2 * r2, r2 * r2 * r2].map(|power| f * power);
    LinearisedLens {
        at: [cx + f * xd, cy + f * yd],
        by_direction: [[xx, mixed], [mixed, yy]],
        by_camera: [
            [xd, 1.0, 0.0, x * powers[0], x * powers[1], x * powers[2], f * across, f * along_x],
            [yd, 0.0, 1.0, y * powers[0], y * powers[1], y * powers[2], f * along_y, f * across],
        ],
    }
}

/// The direction (x, y), y down, that the distortion moves to `measured`, by fixed-point iteration. `None` where the distortion folds the
/// image at that place.
pub(crate) fn undistorted(measured: [f64; 2], radial: [f64; 3], [p1, p2]: [f64; 2]) -> Option<[f64; 2]> {
    let [mut x, mut y] = measured;
    if radial == [0.0; 3] && [p1, p2] == [0.0; 2] {
        return Some(measured);
    }
    for _ in 0..MOST_STEPS {
        let r2 = x * x + y * y;
        let factor = radial_factor(radial, r2);
        let shift = [2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x), p1 * (r2 + 2.0 * y * y) + 2.0 * p2 * x * y];
        let next = [(measured[0] - shift[0]) / factor, (measured[1] - shift[1]) / factor];
        let change = (next[0] - x).abs() + (next[1] - y).abs();
        [x, y] = next;
        if !change.is_finite() {
            return None;
        }
        if change < SETTLED {
            return Some([x, y]);
        }
    }
    None
}
