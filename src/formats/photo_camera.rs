//! The camera of a pair from that of a block: another direction of the distortion, and millimetres.

use super::ModelCamera;
use crate::camera::{MOST_STEPS, undistorted};
use crate::{Camera, Cause, Computation, Error};
use nalgebra::{Matrix3, Vector3};

/// Side of a pixel where nobody knows it, mm.
const NOMINAL_PIXEL_MM: f64 = 0.001;
/// Radii at which the two directions of the distortion are compared.
const RADII: usize = 128;

impl ModelCamera {
    /// The camera as one photo has it: lengths in mm from the middle of the image, and the radial distortion as a correction of what was
    /// measured.
    ///
    /// The correction is the polynomial of three terms that comes nearest to the inverse of this camera's radial distortion, by least squares
    /// over all radii of the image; for lenses of aerial cameras it is within some hundredths of a pixel of it. A photo's camera has no
    /// tangential distortion: it is left out. A pixel is taken to be 0.001 mm where its side is not known.
    ///
    /// # Errors
    /// [`Error::NotConverged`] where the distortion folds the image, so that it has no inverse; [`Error::InvalidOption`] where the camera is
    /// none that a photo may have.
    pub fn photo_camera(&self) -> Result<Camera, Error> {
        let pixel_mm = self.pixel_mm.unwrap_or(NOMINAL_PIXEL_MM);
        let [cx, cy] = self.principal_point_px;
        let (width, height) = (f64::from(self.width_px), f64::from(self.height_px));
        let focal_mm = self.focal_px * pixel_mm;
        let camera = Camera {
            focal_mm,
            principal_point_mm: [(cx - 0.5 * width) * pixel_mm, (0.5 * height - cy) * pixel_mm],
            pixel_mm: Some(pixel_mm),
            radial_distortion: self.correction()?.map_or([0.0; 3], |[k1, k2, k3]| {
                let f2 = focal_mm * focal_mm;
                [k1 / f2, k2 / (f2 * f2), k3 / (f2 * f2 * f2)]
            }),
        };
        camera.check().map(|()| camera)
    }

    /// The terms of the correction in units of the focal length; absent where there is nothing to correct.
    fn correction(&self) -> Result<Option<[f64; 3]>, Error> {
        if self.radial == [0.0; 3] {
            return Ok(None);
        }
        let farthest = self.farthest_corner();
        let (mut normal, mut right) = (Matrix3::zeros(), Vector3::zeros());
        for k in 1..=RADII {
            // In units of the farthest radius the powers stay near each other.
            let t = k as f64 / RADII as f64;
            let measured = t * farthest;
            let [ideal, _] = undistorted([measured, 0.0], self.radial, [0.0; 2]).ok_or_else(|| Error::NotConverged {
                computation: Computation::DistortionCorrection,
                iterations: MOST_STEPS,
                cause: Cause::FoldedBeyond { radius_px: measured * self.focal_px },
            })?;
            let t2 = t * t;
            let row = Vector3::new(t2, t2 * t2, t2 * t2 * t2) * measured;
            normal += row * row.transpose();
            right += row * (ideal - measured);
        }
        let solved = normal.lu().solve(&right).filter(|terms| terms.iter().all(|term| term.is_finite()));
        let r2 = farthest * farthest;
        Ok(solved.map(|terms| [terms.x / r2, terms.y / (r2 * r2), terms.z / (r2 * r2 * r2)]))
    }

    /// Its distance from the principal point in units of the focal length.
    fn farthest_corner(&self) -> f64 {
        let [cx, cy] = self.principal_point_px;
        let reach = |at: f64, length: u32| at.abs().max((f64::from(length) - at).abs());
        let (x, y) = (reach(cx, self.width_px), reach(cy, self.height_px));
        (x * x + y * y).sqrt() / self.focal_px
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Interior;

    fn camera() -> ModelCamera {
        ModelCamera {
            width_px: 4000,
            height_px: 3000,
            focal_px: 3500.0,
            principal_point_px: [2010.0, 1490.0],
            radial: [-0.08, 0.02, -0.003],
            tangential: [0.0; 2],
            pixel_mm: Some(0.0024),
        }
    }

    #[test]
    fn a_photo_sees_the_same_rays_as_the_block() {
        for camera in [camera(), ModelCamera { radial: [0.0; 3], pixel_mm: None, ..camera() }] {
            let own = camera.photo_camera().unwrap();
            let interior = Interior::from_pixel_size(&own, 4000, 3000).unwrap();
            for (x, y) in [(0.0, 0.0), (4000.0, 3000.0), (2010.0, 1490.0), (1000.0, 2500.0), (3999.0, 10.0)] {
                let [x_mm, y_mm] = interior.photo_mm(x, y);
                let [u, v] = camera.ideal_px([x, y]).unwrap();
                let [dx, dy] = [x_mm / own.focal_mm - (u - 2010.0) / 3500.0, y_mm / own.focal_mm + (v - 1490.0) / 3500.0];
                assert!((dx * dx + dy * dy).sqrt() * 3500.0 < 0.02, "{dx} {dy} at {x}, {y}");
            }
        }
    }

    #[test]
    fn a_distortion_without_inverse_is_refused() {
        let folded = ModelCamera { radial: [-9.0, 0.0, 0.0], ..camera() };
        assert_eq!(folded.photo_camera().unwrap_err().code(), "not-converged");
        assert_eq!(ModelCamera { focal_px: f64::NAN, ..camera() }.photo_camera().unwrap_err().code(), "not-converged");
        assert_eq!(ModelCamera { focal_px: -5.0, radial: [0.0; 3], ..camera() }.photo_camera().unwrap_err().code(), "invalid-option");
    }
}
