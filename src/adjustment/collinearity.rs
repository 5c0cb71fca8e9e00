//! The collinearity equations with distortion, and their derivatives.
//!
//! Symbols: (U, V, W) = M·(X - X₀); x = -U/W, y = V/W, so that y goes down; see [`Camera`](crate::Camera) for the rest.

use crate::camera::{CAMERA_PARAMETERS, CameraValues, Pose, distorted, linearised_lens};

/// An image point with its derivatives: rows are column and row of the pixel.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Linearised {
    pub at: [f64; 2],
    /// By three small turns about the photo's axes (M becomes R(δ)·M) and the position X₀.
    pub by_image: [[f64; 6]; 2],
    pub by_point: [[f64; 3]; 2],
    pub by_camera: [[f64; CAMERA_PARAMETERS]; 2],
}

/// Where a point is seen in px. Not finite in the plane of the perspective centre; a point behind it is seen through it.
pub(crate) fn project(camera: &CameraValues, pose: &Pose, point: &[f64; 3]) -> [f64; 2] {
    let [u, v, w] = pose.to_photo(point);
    distorted(camera, -u / w, v / w)
}

/// As [`project`], with the derivatives.
pub(crate) fn linearise(camera: &CameraValues, pose: &Pose, point: &[f64; 3]) -> Linearised {
    let [u, v, w] = pose.to_photo(point);
    let inverse = -1.0 / w;
    let (x, y) = (u * inverse, -v * inverse);
    let lens = linearised_lens(camera, x, y);
    // By U, V, W.
    let by_photo = lens.by_direction.map(|[a, b]| [a * inverse, -b * inverse, (a * x + b * y) * inverse]);
    let by_turns = by_photo.map(|[a, b, c]| [c * v - b * w, a * w - c * u, b * u - a * v]);
    let m = &pose.rotation;
    let by_point = by_photo.map(|[a, b, c]| [0, 1, 2].map(|k| a * m[0][k] + b * m[1][k] + c * m[2][k]));
    let by_image = [0, 1].map(|row| {
        let (turn, shift) = (by_turns[row], by_point[row]);
        [turn[0], turn[1], turn[2], -shift[0], -shift[1], -shift[2]]
    });
    Linearised { at: lens.at, by_image, by_point, by_camera: lens.by_camera }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::camera::rotation_from_angles;

    fn scene() -> (CameraValues, Pose, [f64; 3]) {
        let m = rotation_from_angles(0.3, -0.2, 1.1);
        let pose = Pose::new(&m, [10.0, -20.0, 120.0]);
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
