//! Measured positions freed of the lens's distortion, for formats that have no room for it.

use super::{ModelCamera, ModelRay};
use crate::camera::{MOST_STEPS, undistorted};
use crate::{Cause, Computation, Error};

/// The direction (x, y), y down, whose image by the camera's distortion is the ray: the inverse of the formula at [`ModelCamera`].
///
/// # Errors
/// [`Error::NotConverged`] where the distortion folds the image at that place, so that it has no inverse.
pub(super) fn direction(camera: &ModelCamera, ray: &ModelRay) -> Result<[f64; 2], Error> {
    ideal(camera, [ray.x_px, ray.y_px])
}

fn ideal(camera: &ModelCamera, [x_px, y_px]: [f64; 2]) -> Result<[f64; 2], Error> {
    let [cx, cy] = camera.principal_point_px;
    let measured = [(x_px - cx) / camera.focal_px, (y_px - cy) / camera.focal_px];
    undistorted(measured, camera.radial, camera.tangential).ok_or_else(|| Error::NotConverged {
        computation: Computation::DistortionCorrection,
        iterations: MOST_STEPS,
        cause: Cause::FoldedAt { x_px, y_px },
    })
}

impl ModelCamera {
    /// Where the camera would have seen, in px, what it has at a position if it had no distortion.
    ///
    /// # Errors
    /// [`Error::NotConverged`] where the distortion folds the image at that place, so that it has no inverse.
    pub fn ideal_px(&self, measured_px: [f64; 2]) -> Result<[f64; 2], Error> {
        if self.radial == [0.0; 3] && self.tangential == [0.0; 2] {
            return Ok(measured_px);
        }
        let [x, y] = ideal(self, measured_px)?;
        let [cx, cy] = self.principal_point_px;
        Ok([cx + self.focal_px * x, cy + self.focal_px * y])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corrected_positions_are_distorted_back_to_what_was_measured() {
        let camera = ModelCamera {
            width_px: 4000,
            height_px: 3000,
            focal_px: 3500.0,
            principal_point_px: [2010.0, 1490.0],
            radial: [-0.08, 0.02, -0.003],
            tangential: [0.0007, -0.0004],
            pixel_mm: None,
        };
        for (x_px, y_px) in [(10.0, 20.0), (2010.0, 1490.0), (3990.0, 2900.0)] {
            let [x, y] = direction(&camera, &ModelRay { image: 0, x_px, y_px, confidence: 1.0 }).unwrap();
            let r2 = x * x + y * y;
            let radial = 1.0 + r2 * (-0.08 + r2 * (0.02 - 0.003 * r2));
            let col = 2010.0 + 3500.0 * (x * radial + 2.0 * 0.0007 * x * y - 0.0004 * (r2 + 2.0 * x * x));
            let row = 1490.0 + 3500.0 * (y * radial + 0.0007 * (r2 + 2.0 * y * y) - 2.0 * 0.0004 * x * y);
            assert!((col - x_px).abs() < 1e-8 && (row - y_px).abs() < 1e-8, "{col} {row}");
        }
        assert_eq!(ModelCamera { radial: [0.0; 3], tangential: [0.0; 2], ..camera.clone() }.ideal_px([10.1, 20.7]).unwrap(), [10.1, 20.7]);
        let [x, y] = direction(&camera, &ModelRay { image: 0, x_px: 10.0, y_px: 20.0, confidence: 1.0 }).unwrap();
        assert_eq!(camera.ideal_px([10.0, 20.0]).unwrap(), [2010.0 + 3500.0 * x, 1490.0 + 3500.0 * y]);
        let folded = ModelCamera { radial: [-9.0, 0.0, 0.0], ..camera };
        let error = direction(&folded, &ModelRay { image: 0, x_px: 0.0, y_px: 0.0, confidence: 1.0 }).unwrap_err();
        assert_eq!(error.code(), "not-converged");
    }
}
