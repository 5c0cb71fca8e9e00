//! The camera of a block: lengths in px.

use super::distortion::{CAMERA_PARAMETERS, CameraValues, MOST_STEPS, distorted, undistorted};
use crate::catalogue::{FOCAL_PX, check_values};
use crate::error::refuse;
use crate::{Cause, Computation, Error, Input, Location, Refusal};
use serde::{Deserialize, Serialize};
use std::ops::RangeInclusive;

/// The camera of one or more images.
///
/// With x = -U/W, y = V/W of photo = (U, V, W) = M·(X - X₀), so that y goes down as rows do, and r² = x² + y²:
/// col = c_x + f (x (1 + k₁r² + k₂r⁴ + k₃r⁶) + 2p₁xy + p₂(r² + 2x²)), row = c_y + f (y (1 + k₁r² + k₂r⁴ + k₃r⁶) + p₁(r² + 2y²) + 2p₂xy).
///
/// # Source
/// Brown 1971, Close-range camera calibration, in the direction from object to image, as OpenCV and COLMAP write it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Camera {
    pub width_px: u32,
    pub height_px: u32,
    /// Principal distance f, 1 to 10,000,000; in mm it is this times the side of a pixel.
    pub focal_px: f64,
    /// Principal point `[c_x, c_y]`; the centre of the top-left pixel is (0.5, 0.5).
    pub principal_point_px: [f64; 2],
    /// `[k1, k2, k3]`, without unit.
    #[serde(default)]
    pub radial: [f64; 3],
    /// `[p1, p2]`, without unit.
    #[serde(default)]
    pub tangential: [f64; 2],
    /// Side of a pixel, which formats with photo coordinates need.
    #[serde(default)]
    pub pixel_mm: Option<f64>,
    /// What an adjustment estimates of it.
    #[serde(default)]
    pub free: FreeParameters,
}

/// The parameters of a camera that an adjustment estimates, where the block determines them; the others stay as they are given.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct FreeParameters {
    pub focal: bool,
    pub principal_point: bool,
    /// How many of k1, k2, k3, from the first on: 0 to 3.
    pub radial: usize,
    pub tangential: bool,
}

impl FreeParameters {
    /// All eight.
    pub const ALL: Self = Self { focal: true, principal_point: true, radial: 3, tangential: true };
    /// Focal length, principal point, k1, k2 and decentring: what most blocks determine. Of a lens with decentring that is left out the errors are in
    /// its focal length and in the heights.
    pub const USUAL: Self = Self { focal: true, principal_point: true, radial: 2, tangential: true };

    /// Of f, c_x, c_y, k₁, k₂, k₃, p₁, p₂ each.
    pub(crate) fn flags(self) -> [bool; CAMERA_PARAMETERS] {
        let radial = |k: usize| self.radial >= k;
        [self.focal, self.principal_point, self.principal_point, radial(1), radial(2), radial(3), self.tangential, self.tangential]
    }
}

impl Camera {
    /// A camera without distortion whose principal point is the middle of the image; nothing of it is estimated.
    pub fn without_distortion(width_px: u32, height_px: u32, focal_px: f64) -> Self {
        Self {
            width_px,
            height_px,
            focal_px,
            principal_point_px: [0.5 * f64::from(width_px), 0.5 * f64::from(height_px)],
            radial: [0.0; 3],
            tangential: [0.0; 2],
            pixel_mm: None,
            free: FreeParameters::default(),
        }
    }

    /// Where a direction (x, y) of the photo's system is seen: column and row in px.
    pub fn project(&self, x: f64, y: f64) -> [f64; 2] {
        distorted(&self.values(), x, y)
    }

    /// The direction (x, y) that is seen at a column and row in px: the inverse of [`Camera::project`].
    ///
    /// # Errors
    /// [`Error::NotConverged`] where the distortion folds the image at that place, so that it has no inverse.
    pub fn direction(&self, [x_px, y_px]: [f64; 2]) -> Result<[f64; 2], Error> {
        let [cx, cy] = self.principal_point_px;
        let measured = [(x_px - cx) / self.focal_px, (y_px - cy) / self.focal_px];
        undistorted(measured, self.radial, self.tangential).ok_or(Error::NotConverged {
            computation: Computation::DistortionCorrection,
            iterations: MOST_STEPS,
            cause: Cause::FoldedAt { x_px, y_px },
        })
    }

    /// Where the camera would have seen, in px, what it has at a position if it had no distortion.
    ///
    /// # Errors
    /// As [`Camera::direction`].
    pub fn undistorted_px(&self, measured_px: [f64; 2]) -> Result<[f64; 2], Error> {
        if self.radial == [0.0; 3] && self.tangential == [0.0; 2] {
            return Ok(measured_px);
        }
        let [x, y] = self.direction(measured_px)?;
        let [cx, cy] = self.principal_point_px;
        Ok([cx + self.focal_px * x, cy + self.focal_px * y])
    }

    /// Whether a position in px lies in its images.
    pub fn sees(&self, x_px: f64, y_px: f64) -> bool {
        (0.0..=f64::from(self.width_px)).contains(&x_px) && (0.0..=f64::from(self.height_px)).contains(&y_px)
    }

    /// Refuses what is no camera; `name` says which one it is.
    pub(crate) fn check(&self, name: impl Fn() -> Location) -> Result<(), Error> {
        let check = |input, field: &str, values: &[f64], allowed: RangeInclusive<f64>| {
            let (low, high) = (*allowed.start(), *allowed.end());
            match values.iter().find(|v| !allowed.contains(v)) {
                Some(&value) => refuse(Refusal::Parameter { input, value, field: field.into(), location: name(), low, high }),
                None => Ok(()),
            }
        };
        check_values(Input::ImageSize, &[f64::from(self.width_px), f64::from(self.height_px)], 1.0..=1e7, &name)?;
        check(Input::CameraFocalLength, "focal_px", &[self.focal_px], FOCAL_PX)?;
        check(Input::CameraPrincipalPoint, "principal_point_px", &self.principal_point_px, -1e7..=1e7)?;
        check(Input::CameraDistortion, "radial", &self.radial, -1e3..=1e3)?;
        check(Input::CameraDistortion, "tangential", &self.tangential, -1e3..=1e3)?;
        check(Input::PixelSide, "pixel_mm", self.pixel_mm.as_slice(), 1e-6..=10.0)?;
        check_values(Input::FreeRadial, &[self.free.radial as f64], 0.0..=3.0, &name)
    }

    /// The parameters in the order of the unknowns.
    pub(crate) fn values(&self) -> CameraValues {
        let ([cx, cy], [k1, k2, k3], [p1, p2]) = (self.principal_point_px, self.radial, self.tangential);
        [self.focal_px, cx, cy, k1, k2, k3, p1, p2]
    }

    /// The camera with other parameters.
    pub(crate) fn with_values(self, [f, cx, cy, k1, k2, k3, p1, p2]: CameraValues) -> Self {
        Self { focal_px: f, principal_point_px: [cx, cy], radial: [k1, k2, k3], tangential: [p1, p2], ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn undistorted_positions_are_distorted_back_to_what_was_measured() {
        let camera = Camera {
            principal_point_px: [2010.0, 1490.0],
            radial: [-0.08, 0.02, -0.003],
            tangential: [0.0007, -0.0004],
            ..Camera::without_distortion(4000, 3000, 3500.0)
        };
        for at in [[10.0, 20.0], [2010.0, 1490.0], [3990.0, 2900.0]] {
            let [x, y] = camera.direction(at).unwrap();
            let r2 = x * x + y * y;
            let radial = 1.0 + r2 * (-0.08 + r2 * (0.02 - 0.003 * r2));
            let col = 2010.0 + 3500.0 * (x * radial + 2.0 * 0.0007 * x * y - 0.0004 * (r2 + 2.0 * x * x));
            let row = 1490.0 + 3500.0 * (y * radial + 0.0007 * (r2 + 2.0 * y * y) - 2.0 * 0.0004 * x * y);
            assert!((col - at[0]).abs() < 1e-8 && (row - at[1]).abs() < 1e-8, "{col} {row}");
            assert_eq!(camera.undistorted_px(at).unwrap(), [2010.0 + 3500.0 * x, 1490.0 + 3500.0 * y]);
        }
        let straight = Camera { radial: [0.0; 3], tangential: [0.0; 2], ..camera };
        assert_eq!(straight.undistorted_px([10.1, 20.7]).unwrap(), [10.1, 20.7]);
        let folded = Camera { radial: [-9.0, 0.0, 0.0], ..camera };
        assert_eq!(folded.direction([0.0, 0.0]).unwrap_err().code(), "not-converged");
    }
}
