//! The camera in mm, as certificates and the files of pairs have it, and from the camera of a block.

use super::distortion::{MOST_STEPS, fitted_terms, radial_factor, tangential_shift, undistorted};
use super::sensors::NOMINAL_PIXEL_MM;
use super::{Camera, CameraUncertainty, ExifCamera};
use crate::catalogue::refuse;
use crate::{Allowed, Cause, Computation, Error, Refusal};
use nalgebra::{Matrix2, Vector2};
use serde::{Deserialize, Serialize};

/// The constants of a camera.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct CameraMm {
    /// Principal distance in mm, above 0 and up to 100,000.
    pub focal_mm: f64,
    /// Principal point `[x, y]` in mm: in the system of the calibrated fiducials, or from the middle of the image, x right, y up.
    #[serde(default)]
    pub principal_point_mm: [f64; 2],
    /// Side of a pixel in mm, 0.000001 to 10; needed where there are no fiducials.
    #[serde(default)]
    pub pixel_mm: Option<f64>,
    /// `[k1, k2, k3]` in mm⁻², mm⁻⁴, mm⁻⁶. What was measured at x, y mm from the principal point, r mm away, is corrected to
    /// x · (1 + k1·r² + k2·r⁴ + k3·r⁶) + p1·(r² + 2x²) + 2·p2·x·y and y · (1 + k1·r² + k2·r⁴ + k3·r⁶) + p2·(r² + 2y²) + 2·p1·x·y: a positive k1
    /// moves points outwards, against a barrel distortion.
    #[serde(default)]
    pub radial_distortion: [f64; 3],
    /// `[p1, p2]` in mm⁻¹, of the same correction.
    #[serde(default)]
    pub tangential_distortion: [f64; 2],
    /// What is not known of these; absent: nothing where photos have fiducial marks, of digital ones [`CameraUncertainty::GIVEN`].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub uncertainty: Option<CameraUncertainty>,
}

impl CameraMm {
    /// A camera without distortion whose principal point is the middle of the image or of the fiducials.
    pub fn without_distortion(focal_mm: f64, pixel_mm: Option<f64>) -> Self {
        Self {
            focal_mm,
            principal_point_mm: [0.0; 2],
            pixel_mm,
            radial_distortion: [0.0; 3],
            tangential_distortion: [0.0; 2],
            uncertainty: None,
        }
    }

    /// The camera of which nothing but the focal length in px is known, with pixels of a thousandth of a mm.
    pub fn of_focal_px(focal_px: f64) -> Self {
        Self::without_distortion(focal_px * NOMINAL_PIXEL_MM, Some(NOMINAL_PIXEL_MM))
    }

    /// Whether the side of its pixels is taken to be a thousandth of a mm for want of the true one: its lengths in mm mean nothing then.
    pub(crate) fn is_nominal(&self) -> bool {
        self.pixel_mm == Some(NOMINAL_PIXEL_MM)
    }

    /// The camera that a file names, with what is not known of it: principal point in the middle of the image and no distortion, but where
    /// XMP says more. A photo with fewer pixels than it was taken with is taken to be resized, and may be cropped within its uncertainty.
    ///
    /// # Errors
    /// [`Error::InvalidOption`] where its focal length or pixel size is outside the range of a camera; [`Error::InvalidInput`] for a panorama.
    pub fn from_exif(exif: &ExifCamera) -> Result<Self, Error> {
        if exif.is_panorama() {
            return Err(Refusal::Panorama.into_error());
        }
        let camera = match &exif.lens {
            Some(lens) => lens.photo_camera()?,
            None => Self::without_distortion(exif.focal_mm, exif.pixel_mm),
        };
        let camera = Self { uncertainty: Some(exif.uncertainty()), ..camera };
        camera.check().map(|()| camera)
    }

    /// Refuses values outside their ranges.
    ///
    /// # Errors
    /// [`Error::InvalidOption`], naming the field and its range.
    pub fn check(&self) -> Result<(), Error> {
        if !(self.focal_mm > 0.0 && self.focal_mm <= 1e5) {
            return Err(refuse("camera.focal_mm", self.focal_mm, Allowed::AboveUpTo { above: 0.0, max: 1e5 }));
        }
        if !self.principal_point_mm.iter().all(|v| v.abs() <= 1e4) {
            return Err(refuse(
                "camera.principal_point_mm",
                format!("{:?}", self.principal_point_mm),
                Allowed::TwoNumbers { min: -1e4, max: 1e4, px: false },
            ));
        }
        if let Some(pixel) = self.pixel_mm
            && !(1e-6..=10.0).contains(&pixel)
        {
            return Err(refuse("camera.pixel_mm", pixel, Allowed::Real { min: 1e-6, max: 10.0 }));
        }
        if !self.radial_distortion.iter().all(|k| k.is_finite()) {
            return Err(refuse("camera.radial_distortion", format!("{:?}", self.radial_distortion), Allowed::Finite { numbers: 3 }));
        }
        if !self.tangential_distortion.iter().all(|p| p.is_finite()) {
            return Err(refuse(
                "camera.tangential_distortion",
                format!("{:?}", self.tangential_distortion),
                Allowed::Finite { numbers: 2 },
            ));
        }
        if let Some(uncertainty) = self.uncertainty {
            uncertainty.check()?;
        }
        Ok(())
    }
}

/// Radii at which the two directions of the distortion are compared, and positions along each side of the image.
const RADII: usize = 128;
const POSITIONS: usize = 16;

impl Camera {
    /// The camera as one photo has it: lengths in mm from the middle of the image, and the distortion as a correction of what was measured.
    ///
    /// The correction has the three radial terms that come nearest to the inverse of this camera's radial distortion, by least squares over
    /// all radii of the image, and the two tangential ones that come nearest to the rest; for lenses of aerial cameras it is within some
    /// hundredths of a pixel, with tangential terms of 1e-4 within a tenth, growing as they do. A pixel is taken to be 0.001 mm where its
    /// side is not known.
    ///
    /// # Errors
    /// [`Error::NotConverged`] where the distortion folds the image, so that it has no inverse; [`Error::InvalidOption`] where the camera is
    /// none that a photo may have.
    pub fn photo_camera(&self) -> Result<CameraMm, Error> {
        let pixel_mm = self.pixel_mm.unwrap_or(NOMINAL_PIXEL_MM);
        let [cx, cy] = self.principal_point_px;
        let (width, height) = (f64::from(self.width_px), f64::from(self.height_px));
        let focal_mm = self.focal_px * pixel_mm;
        let radial = self.radial_correction()?;
        let ([k1, k2, k3], f2) = (radial, focal_mm * focal_mm);
        let camera = CameraMm {
            principal_point_mm: [(cx - 0.5 * width) * pixel_mm, (0.5 * height - cy) * pixel_mm],
            radial_distortion: [k1 / f2, k2 / (f2 * f2), k3 / (f2 * f2 * f2)],
            tangential_distortion: self.tangential_correction(radial)?.map(|p| p / focal_mm),
            ..CameraMm::without_distortion(focal_mm, Some(pixel_mm))
        };
        camera.check().map(|()| camera)
    }

    /// The radial terms of the correction in units of the focal length.
    fn radial_correction(&self) -> Result<[f64; 3], Error> {
        if self.radial == [0.0; 3] {
            return Ok([0.0; 3]);
        }
        let farthest = self.farthest_corner();
        let rays = (1..=RADII).map(|k| {
            let measured = k as f64 / RADII as f64 * farthest;
            let [ideal, _] = undistorted([measured, 0.0], self.radial, [0.0; 2]).ok_or(Error::NotConverged {
                computation: Computation::DistortionCorrection,
                iterations: MOST_STEPS,
                cause: Cause::FoldedBeyond { radius_px: measured * self.focal_px },
            })?;
            Ok((measured, ideal))
        });
        Ok(fitted_terms(rays.collect::<Result<Vec<_>, Error>>()?.into_iter(), farthest))
    }

    /// The tangential terms beside the radial ones, in units of the focal length.
    fn tangential_correction(&self, radial: [f64; 3]) -> Result<[f64; 2], Error> {
        if self.tangential == [0.0; 2] {
            return Ok([0.0; 2]);
        }
        let at = |k: usize, length: u32| f64::from(length) * k as f64 / POSITIONS as f64;
        let (mut normal, mut right) = (Matrix2::zeros(), Vector2::zeros());
        for (column, row) in (0..=POSITIONS).flat_map(|column| (0..=POSITIONS).map(move |row| (column, row))) {
            let measured_px = [at(column, self.width_px), at(row, self.height_px)];
            let [x, down] = self.direction(measured_px)?;
            let [cx, cy] = self.principal_point_px;
            let measured = [(measured_px[0] - cx) / self.focal_px, (cy - measured_px[1]) / self.focal_px];
            let factor = radial_factor(radial, measured[0] * measured[0] + measured[1] * measured[1]);
            let rest = Vector2::new(x - measured[0] * factor, -down - measured[1] * factor);
            let terms = Matrix2::from_columns(&[[1.0, 0.0], [0.0, 1.0]].map(|p| Vector2::from(tangential_shift(p, measured))));
            normal += terms.transpose() * terms;
            right += terms.transpose() * rest;
        }
        Ok(normal.lu().solve(&right).filter(|p| p.iter().all(|p| p.is_finite())).map_or([0.0; 2], Into::into))
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

    fn camera() -> Camera {
        Camera {
            principal_point_px: [2010.0, 1490.0],
            radial: [-0.08, 0.02, -0.003],
            pixel_mm: Some(0.0024),
            ..Camera::without_distortion(4000, 3000, 3500.0)
        }
    }

    #[test]
    fn a_photo_sees_the_same_rays_as_the_block() {
        let bent = Camera { tangential: [1.5e-4, -1e-4], ..camera() };
        let straight = Camera { radial: [0.0; 3], pixel_mm: None, ..camera() };
        for (camera, within_px) in [(camera(), 0.02), (straight, 0.02), (bent, 0.1)] {
            let own = camera.photo_camera().unwrap();
            let interior = Interior::from_pixel_size(&own, 4000, 3000).unwrap();
            for (x, y) in [(0.0, 0.0), (4000.0, 3000.0), (2010.0, 1490.0), (1000.0, 2500.0), (3999.0, 10.0)] {
                let [x_mm, y_mm] = interior.photo_mm(x, y);
                let [u, v] = camera.undistorted_px([x, y]).unwrap();
                let [dx, dy] = [x_mm / own.focal_mm - (u - 2010.0) / 3500.0, y_mm / own.focal_mm + (v - 1490.0) / 3500.0];
                assert!((dx * dx + dy * dy).sqrt() * 3500.0 < within_px, "{dx} {dy} at {x}, {y}");
                let [back_x, back_y] = interior.undistorted_px(x, y);
                let [px, py] = interior.image_px(back_x, back_y).unwrap();
                assert!((px - x).abs() < 1e-6 && (py - y).abs() < 1e-6, "{px} {py} of {x}, {y}");
            }
        }
    }

    #[test]
    fn a_distortion_without_inverse_is_refused() {
        let folded = Camera { radial: [-9.0, 0.0, 0.0], ..camera() };
        assert_eq!(folded.photo_camera().unwrap_err().code(), "not-converged");
        assert_eq!(Camera { focal_px: f64::NAN, ..camera() }.photo_camera().unwrap_err().code(), "not-converged");
        assert_eq!(Camera { focal_px: -5.0, radial: [0.0; 3], ..camera() }.photo_camera().unwrap_err().code(), "invalid-option");
    }

    #[test]
    fn values_outside_their_ranges_are_refused_by_name() {
        let in_mm = camera().photo_camera().unwrap();
        let wrong = [
            (CameraMm { focal_mm: 0.0, ..in_mm }, "camera.focal_mm"),
            (CameraMm { focal_mm: f64::NAN, ..in_mm }, "camera.focal_mm"),
            (CameraMm { principal_point_mm: [0.0, f64::INFINITY], ..in_mm }, "camera.principal_point_mm"),
            (CameraMm { pixel_mm: Some(-0.1), ..in_mm }, "camera.pixel_mm"),
            (CameraMm { pixel_mm: None, ..in_mm }, "camera.pixel_mm"),
            (CameraMm { radial_distortion: [f64::NAN, 0.0, 0.0], ..in_mm }, "camera.radial_distortion"),
        ];
        for (camera, name) in wrong {
            match Interior::from_pixel_size(&camera, 100, 100) {
                Err(Error::InvalidOption { field, .. }) => assert_eq!(field, name),
                other => panic!("{name}: {other:?}"),
            }
        }
    }

    #[test]
    fn a_camera_without_focal_length_or_with_an_unknown_field_is_no_camera() {
        assert!(serde_json::from_str::<CameraMm>(r#"{"focal_mm": 24}"#).is_ok());
        assert!(serde_json::from_str::<CameraMm>(r#"{"pixel_mm": 0.01}"#).is_err());
        assert!(serde_json::from_str::<CameraMm>(r#"{"focal_mm": 24, "focus": 1}"#).is_err());
    }
}
