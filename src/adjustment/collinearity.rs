//! The collinearity equations with distortion, and their derivatives.
//!
//! Symbols: (U, V, W) = M·(X - X₀); x = -U/W, y = V/W, so that y goes down; see [`BlockCamera`](super::BlockCamera) for the rest.

use super::state::Pose;

/// Number of parameters of a camera: f, c_x, c_y, k₁, k₂, k₃, p₁, p₂.
pub(crate) const CAMERA_PARAMETERS: usize = 8;

/// Parameters of a camera in that order.
pub(crate) type CameraValues = [f64; CAMERA_PARAMETERS];

/// An image point with its derivatives: rows are column and row of the pixel.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Linearised {
    pub at: [f64; 2],
    /// By three small turns about the photo's axes (M becomes R(δ)·M) and the position X₀.
    pub by_image: [[f64; 6]; 2],
    pub by_point: [[f64; 3]; 2],
    pub by_camera: [[f64; CAMERA_PARAMETERS]; 2],
}

/// The direction of a point in the photo's system: (U, V, W).
pub(crate) fn in_photo(pose: &Pose, point: &[f64; 3]) -> [f64; 3] {
    let d = [point[0] - pose.position[0], point[1] - pose.position[1], point[2] - pose.position[2]];
    pose.rotation.map(|row| row[0] * d[0] + row[1] * d[1] + row[2] * d[2])
}

/// Where a point is seen in px. Not finite in the plane of the perspective centre; a point behind it is seen through it.
pub(crate) fn project(camera: &CameraValues, pose: &Pose, point: &[f64; 3]) -> [f64; 2] {
    let [u, v, w] = in_photo(pose, point);
    distorted(camera, -u / w, v / w)
}

/// The pixel of a direction.
pub(crate) fn distorted(camera: &CameraValues, x: f64, y: f64) -> [f64; 2] {
    let [f, cx, cy, k1, k2, k3, p1, p2] = *camera;
    let r2 = x * x + y * y;
    let radial = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3));
    let across = 2.0 * x * y;
    [cx + f * (x * radial + p1 * across + p2 * (r2 + 2.0 * x * x)), cy + f * (y * radial + p1 * (r2 + 2.0 * y * y) + p2 * across)]
}

/// As [`project`], with the derivatives.
pub(crate) fn linearise(camera: &CameraValues, pose: &Pose, point: &[f64; 3]) -> Linearised {
    let [u, v, w] = in_photo(pose, point);
    let inverse = -1.0 / w;
    let (x, y) = (u * inverse, -v * inverse);
    let [f, cx, cy, k1, k2, k3, p1, p2] = *camera;
    let r2 = x * x + y * y;
    let radial = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3));
    let slope = k1 + r2 * (2.0 * k2 + 3.0 * r2 * k3);
    let across = 2.0 * x * y;
    let (along_x, along_y) = (r2 + 2.0 * x * x, r2 + 2.0 * y * y);
    let xd = x * radial + p1 * across + p2 * along_x;
    let yd = y * radial + p1 * along_y + p2 * across;
    // Derivatives of the pixel by x and y, then by U, V, W.
    let mixed = f * (across * slope + 2.0 * (p1 * x + p2 * y));
    let xx = f * (radial + 2.0 * x * x * slope + 2.0 * p1 * y + 6.0 * p2 * x);
    let yy = f * (radial + 2.0 * y * y * slope + 6.0 * p1 * y + 2.0 * p2 * x);
    let by_photo = [[xx, mixed], [mixed, yy]].map(|[a, b]| [a * inverse, -b * inverse, (a * x + b * y) * inverse]);
    let by_turns = by_photo.map(|[a, b, c]| [c * v - b * w, a * w - c * u, b * u - a * v]);
    let m = &pose.rotation;
    let by_point = by_photo.map(|[a, b, c]| [0, 1, 2].map(|k| a * m[0][k] + b * m[1][k] + c * m[2][k]));
    let by_image = [0, 1].map(|row| {
        let (turn, shift) = (by_turns[row], by_point[row]);
        [turn[0], turn[1], turn[2], -shift[0], -shift[1], -shift[2]]
    });
    let powers = [r2, r2 * r2, r2 * r2 * r2].map(|power| f * power);
    let by_camera = [
        [xd, 1.0, 0.0, x * powers[0], x * powers[1], x * powers[2], f * across, f * along_x],
        [yd, 0.0, 1.0, y * powers[0], y * powers[1], y * powers[2], f * along_y, f * across],
    ];
    Linearised { at: [cx + f * xd, cy + f * yd], by_image, by_point, by_camera }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::camera::rotation_from_angles;

    fn scene() -> (CameraValues, Pose, [f64; 3]) {
        let m = rotation_from_angles(0.3, -0.2, 1.1);
        let rotation = [0, 1, 2].map(|r| [0, 1, 2].map(|c| m[(r, c)]));
        let pose = Pose { rotation, position: [10.0, -20.0, 120.0] };
        ([3000.0, 1500.0, 1010.0, -0.08, 0.03, -0.01, 0.002, -0.001], pose, [25.0, -35.0, 12.0])
    }

    #[test]
    fn derivatives_are_those_of_differences() {
        let (camera, pose, point) = scene();
        let line = linearise(&camera, &pose, &point);
        let at = project(&camera, &pose, &point);
        assert!((0..2).all(|row| (line.at[row] - at[row]).abs() < 1e-9));
        let numeric = |moved: &dyn Fn(f64) -> [f64; 2], h: f64| {
            let (a, b) = (moved(h), moved(-h));
            [0, 1].map(|row| (a[row] - b[row]) / (2.0 * h))
        };
        let agrees = |analytic: f64, numeric: f64, what: &str| {
            assert!((analytic - numeric).abs() < 1e-6 * analytic.abs().max(1.0), "{what}: {analytic} {numeric}");
        };
        for k in 0..6 {
            let moved = |h: f64| {
                let mut step = [0.0; 6];
                step[k] = h;
                project(&camera, &pose.moved(&step), &point)
            };
            let numeric = numeric(&moved, 1e-5);
            (0..2).for_each(|row| agrees(line.by_image[row][k], numeric[row], &format!("image {k}")));
        }
        for k in 0..3 {
            let moved = |h: f64| {
                let mut point = point;
                point[k] += h;
                project(&camera, &pose, &point)
            };
            let numeric = numeric(&moved, 1e-4);
            (0..2).for_each(|row| agrees(line.by_point[row][k], numeric[row], &format!("point {k}")));
        }
        for k in 0..CAMERA_PARAMETERS {
            let moved = |h: f64| {
                let mut camera = camera;
                camera[k] += h;
                project(&camera, &pose, &point)
            };
            let numeric = numeric(&moved, 1e-5);
            (0..2).for_each(|row| agrees(line.by_camera[row][k], numeric[row], &format!("camera {k}")));
        }
    }

    #[test]
    fn what_lies_to_the_right_and_up_is_seen_so() {
        let camera = [1000.0, 500.0, 400.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        let pose = Pose { rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], position: [0.0, 0.0, 100.0] };
        assert_eq!(project(&camera, &pose, &[10.0, 5.0, 0.0]), [600.0, 350.0]);
    }
}
