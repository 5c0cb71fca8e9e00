//! The way from a pixel to photo coordinates.

use super::distortion::{radial_factor, tangential_shift};
use super::{CameraMm, CameraUncertainty, FiducialOrientation};
use crate::catalogue::{refuse, refuse_absent};
use crate::{Allowed, Error};
use nalgebra::Matrix3;
use serde::{Deserialize, Serialize};

/// Steps of Newton's method after which a radius is not found.
const MOST_STEPS: usize = 30;

/// The interior orientation of one image: from its pixels to photo coordinates.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Interior {
    /// `[[a, b, tx], [d, e, ty]]`: x = a·col + b·row + tx, y = d·col + e·row + ty in mm, before the principal point is taken off;
    /// col and row of this image in px, the centre of its top-left pixel at (0.5, 0.5).
    pub parameters: [[f64; 3]; 2],
    /// Principal point `[x, y]` in mm, in the same system.
    pub principal_point_mm: [f64; 2],
    /// `[k1, k2, k3]` in mm⁻², mm⁻⁴, mm⁻⁶, of the correction that `CameraMm` says.
    pub radial_distortion: [f64; 3],
    /// `[p1, p2]` in mm⁻¹.
    #[serde(default)]
    pub tangential_distortion: [f64; 2],
    /// Covariance of the three parameters of a row, the same for both rows, which are independent; absent where it is not known.
    #[serde(default)]
    pub covariance: Option<[[f64; 3]; 3]>,
    /// Degrees of freedom of the σ₀ by which the covariance is; absent where that is known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub degrees_of_freedom: Option<usize>,
    /// What is not known of the camera; absent: nothing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub uncertainty: Option<CameraUncertainty>,
}

/// Distances from the principal point at which a distortion is looked at.
const STEPS: usize = 256;

impl Interior {
    /// From fiducial marks.
    ///
    /// `origin` is the place `[col, row]` of the image's top-left pixel in the scan whose fiducials were measured: a scan coordinate is the
    /// image coordinate plus `origin`. `[0, 0]` where the image is the whole scan.
    ///
    /// # Errors
    /// [`Error::InvalidOption`] for the camera or the origin.
    pub fn from_fiducials(camera: &CameraMm, marks: &FiducialOrientation, origin: [f64; 2]) -> Result<Self, Error> {
        camera.check()?;
        if !origin.iter().all(|v| v.abs() <= 1e7) {
            return Err(refuse("origin", format!("{origin:?}"), Allowed::TwoNumbers { min: -1e7, max: 1e7, px: true }));
        }
        let parameters = marks.parameters.map(|[by_col, by_row, shift]| [by_col, by_row, shift + by_col * origin[0] + by_row * origin[1]]);
        let covariance = marks.covariance.map(|covariance| moved_to(&covariance, origin));
        let degrees_of_freedom = covariance.map(|_| marks.degrees_of_freedom);
        Ok(Self { covariance, degrees_of_freedom, ..Self::new(camera, parameters) })
    }

    /// From the side of a pixel, for the whole image of a digital camera of `width` x `height` px:
    /// x = (col - width/2)·pixel - x0, y = (height/2 - row)·pixel - y0. A camera that does not say what is not known of it has
    /// [`CameraUncertainty::GIVEN`]: its constants are no metric camera's.
    ///
    /// # Errors
    /// [`Error::InvalidOption`] for the camera, also where it has no `pixel_mm`.
    pub fn from_pixel_size(camera: &CameraMm, width: usize, height: usize) -> Result<Self, Error> {
        camera.check()?;
        let pixel = camera.pixel_mm.ok_or_else(|| refuse_absent("camera.pixel_mm", Allowed::WithoutFiducials { min: 1e-6, max: 10.0 }))?;
        let (half_width, half_height) = (0.5 * width as f64, 0.5 * height as f64);
        let parameters = [[pixel, 0.0, -half_width * pixel], [0.0, -pixel, half_height * pixel]];
        Ok(Self { uncertainty: Some(camera.uncertainty.unwrap_or(CameraUncertainty::GIVEN)), ..Self::new(camera, parameters) })
    }

    fn new(camera: &CameraMm, parameters: [[f64; 3]; 2]) -> Self {
        let CameraMm { principal_point_mm, radial_distortion, tangential_distortion, uncertainty, .. } = *camera;
        Self {
            parameters,
            principal_point_mm,
            radial_distortion,
            tangential_distortion,
            covariance: None,
            degrees_of_freedom: None,
            uncertainty,
        }
    }

    /// Refuses a distortion that folds an image of this size: that takes a place farther out to one nearer in.
    ///
    /// # Errors
    /// [`Error::InvalidOption`], naming the distance from the principal point, in mm, up to which it must not.
    pub fn check_distortion(&self, width: usize, height: usize) -> Result<(), Error> {
        let reach_mm = self.reach_mm(width, height);
        let [k1, k2, k3] = self.radial_distortion;
        let grows = |step: usize| {
            let r = reach_mm * step as f64 / STEPS as f64;
            radial_factor([3.0 * k1, 5.0 * k2, 7.0 * k3], r * r) > 0.0
        };
        if (1..=STEPS).all(grows) {
            return Ok(());
        }
        Err(refuse("camera.radial_distortion", format!("{:?}", self.radial_distortion), Allowed::Unfolded { reach_mm }))
    }

    /// How far the corners of an image lie from the principal point, at most.
    fn reach_mm(&self, width: usize, height: usize) -> f64 {
        let [[a, b, tx], [d, e, ty]] = self.parameters;
        let [x0, y0] = self.principal_point_mm;
        let (width, height) = (width as f64, height as f64);
        let reach = |[x, y]: [f64; 2]| libm::hypot(a * x + b * y + tx - x0, d * x + e * y + ty - y0);
        [[0.0, 0.0], [width, 0.0], [0.0, height], [width, height]].map(reach).into_iter().fold(0.0, f64::max)
    }

    /// So many times as far from the principal point as it was measured its distortion takes the farthest corner of an image.
    pub(crate) fn corner_factor(&self, width: usize, height: usize) -> f64 {
        let reach_mm = self.reach_mm(width, height);
        radial_factor(self.radial_distortion, reach_mm * reach_mm)
    }

    /// Photo coordinates `[x, y]` in mm of an image position in px: the affine transformation, minus the principal point, times
    /// 1 + k1·r² + k2·r⁴ + k3·r⁶ with r the distance in mm from the principal point, plus p1 (r² + 2x²) + 2 p2 xy in x and
    /// p2 (r² + 2y²) + 2 p1 xy in y.
    ///
    /// This is a correction of what was measured: a positive k1 moves points outwards, against a barrel distortion.
    ///
    /// # Source
    /// Brown 1971, Close-range camera calibration, Photogrammetric Engineering 37(8), in the direction from image to object.
    pub fn photo_mm(&self, x_px: f64, y_px: f64) -> [f64; 2] {
        let [[a, b, tx], [d, e, ty]] = self.parameters;
        self.corrected_mm([a * x_px + b * y_px + tx, d * x_px + e * y_px + ty])
    }

    /// The same of a position on the film, in the system of the calibrated marks.
    pub(crate) fn corrected_mm(&self, [x_mm, y_mm]: [f64; 2]) -> [f64; 2] {
        let [x, y] = [x_mm - self.principal_point_mm[0], y_mm - self.principal_point_mm[1]];
        let factor = radial_factor(self.radial_distortion, x * x + y * y);
        if self.tangential_distortion == [0.0; 2] {
            return [x * factor, y * factor];
        }
        let [dx, dy] = tangential_shift(self.tangential_distortion, [x, y]);
        [x * factor + dx, y * factor + dy]
    }

    /// The same rays at a focal length `factor` times as long.
    pub fn scaled(&self, factor: f64) -> Self {
        let [k1, k2, k3] = self.radial_distortion;
        let f2 = factor * factor;
        Self {
            parameters: self.parameters.map(|row| row.map(|v| v * factor)),
            principal_point_mm: self.principal_point_mm.map(|v| v * factor),
            radial_distortion: [k1 / f2, k2 / (f2 * f2), k3 / (f2 * f2 * f2)],
            tangential_distortion: self.tangential_distortion.map(|p| p / factor),
            covariance: self.covariance.map(|rows| rows.map(|row| row.map(|v| v * f2))),
            ..*self
        }
    }

    /// The same for photo axes turned by 90° anticlockwise: the new x axis is the old y axis.
    pub fn turned(&self) -> Self {
        let quarter = |[x, y]: [f64; 2]| [y, -x];
        let [by_x, by_y] = self.parameters;
        let (principal_point_mm, tangential_distortion) = (quarter(self.principal_point_mm), quarter(self.tangential_distortion));
        Self { parameters: [by_y, by_x.map(|v| -v)], principal_point_mm, tangential_distortion, ..*self }
    }

    /// Position in px, as a camera without distortion whose rows lie along the x axis would see it: the principal point stays where it is.
    pub fn undistorted_px(&self, x_px: f64, y_px: f64) -> [f64; 2] {
        let ([x, y], pixel_mm, [x0, y0]) = (self.photo_mm(x_px, y_px), self.pixel_mm(), self.principal_point_px());
        [x0 + x / pixel_mm, y0 - y / pixel_mm]
    }

    /// The image position in px of a position in the camera without distortion: the inverse of [`Interior::undistorted_px`]. None where the
    /// distortion leads no image position there.
    pub fn image_px(&self, x_px: f64, y_px: f64) -> Option<[f64; 2]> {
        let (pixel_mm, [x0, y0]) = (self.pixel_mm(), self.principal_point_px());
        let [x, y] = self.measured_mm([(x_px - x0) * pixel_mm, (y0 - y_px) * pixel_mm])?;
        let [[a, b, tx], [d, e, ty]] = self.parameters;
        let [u, v] = [x + self.principal_point_mm[0] - tx, y + self.principal_point_mm[1] - ty];
        let determinant = a * e - b * d;
        Some([(e * u - b * v) / determinant, (a * v - d * u) / determinant])
    }

    /// The measured position, from the principal point, that the distortion corrects to this one.
    fn measured_mm(&self, corrected: [f64; 2]) -> Option<[f64; 2]> {
        let without_tangential = |[x, y]: [f64; 2]| {
            let wanted = (x * x + y * y).sqrt();
            let share = if wanted > 0.0 { self.measured_radius_mm(wanted)? / wanted } else { 1.0 };
            Some([share * x, share * y])
        };
        let mut at = without_tangential(corrected)?;
        if self.tangential_distortion == [0.0; 2] {
            return Some(at);
        }
        for _ in 0..MOST_STEPS {
            let [dx, dy] = tangential_shift(self.tangential_distortion, at);
            let next = without_tangential([corrected[0] - dx, corrected[1] - dy])?;
            let change = (next[0] - at[0]).abs() + (next[1] - at[1]).abs();
            at = next;
            if change <= 1e-12 * (at[0].abs() + at[1].abs()) {
                return Some(at);
            }
        }
        None
    }

    /// The measured distance from the principal point that the distortion corrects to this one, by Newton's method.
    fn measured_radius_mm(&self, corrected: f64) -> Option<f64> {
        let [k1, k2, k3] = self.radial_distortion;
        let mut r = corrected;
        for _ in 0..MOST_STEPS {
            let r2 = r * r;
            let slope = 1.0 + r2 * (3.0 * k1 + r2 * (5.0 * k2 + 7.0 * r2 * k3));
            let step = (r * radial_factor(self.radial_distortion, r2) - corrected) / slope;
            // Beyond the radius where the correction turns back, several measured ones have the same corrected one.
            if !(slope > 0.0 && step.is_finite()) {
                return None;
            }
            r -= step;
            if step.abs() <= 1e-12 * corrected {
                return Some(r);
            }
        }
        None
    }

    /// Where the principal point lies in the image, px.
    pub fn principal_point_px(&self) -> [f64; 2] {
        let [[a, b, tx], [d, e, ty]] = self.parameters;
        let [x, y] = [self.principal_point_mm[0] - tx, self.principal_point_mm[1] - ty];
        let determinant = a * e - b * d;
        [(e * x - b * y) / determinant, (a * y - d * x) / determinant]
    }

    /// Whether the image shows the photo mirrored: rows do not count against y where columns count along x.
    pub fn is_mirrored(&self) -> bool {
        let [[a, b, _], [d, e, _]] = self.parameters;
        a * e - b * d > 0.0
    }

    /// Side of a pixel in mm: the root of the area that the transformation gives a pixel.
    pub fn pixel_mm(&self) -> f64 {
        let [[a, b, _], [d, e, _]] = self.parameters;
        (a * e - b * d).abs().sqrt()
    }
}

/// The covariance of a, b and t + a·origin₀ + b·origin₁ from that of a, b and t.
fn moved_to(covariance: &[[f64; 3]; 3], [col, row]: [f64; 2]) -> [[f64; 3]; 3] {
    let jacobian = Matrix3::new(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, col, row, 1.0);
    let moved = jacobian * Matrix3::from_fn(|i, j| covariance[i][j]) * jacobian.transpose();
    std::array::from_fn(|i| std::array::from_fn(|j| moved[(i, j)]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::camera::FiducialModel;

    fn camera() -> CameraMm {
        CameraMm { principal_point_mm: [0.5, -0.25], ..CameraMm::without_distortion(153.38, Some(0.01)) }
    }

    #[test]
    fn the_middle_of_the_image_is_minus_the_principal_point() {
        let interior = Interior::from_pixel_size(&camera(), 4000, 3000).unwrap();
        assert_eq!(interior.photo_mm(2000.0, 1500.0), [-0.5, 0.25]);
        let [x, y] = interior.photo_mm(2001.0, 1501.0);
        assert!((x + 0.49).abs() < 1e-12 && (y - 0.24).abs() < 1e-12, "x goes right, y goes up: {x} {y}");
        assert!((interior.pixel_mm() - 0.01).abs() < 1e-15);
    }

    #[test]
    fn the_origin_is_added_to_image_coordinates() {
        let parameters = [[0.25, 0.01, -100.0], [0.02, -0.26, 90.0]];
        let marks = FiducialOrientation {
            model: FiducialModel::Affine,
            parameters,
            residuals_mm: vec![],
            covariance: None,
            sigma0_mm: None,
            degrees_of_freedom: 0,
            standard_errors: None,
            half_widths_95: None,
        };
        let whole = Interior::from_fiducials(&camera(), &marks, [0.0, 0.0]).unwrap();
        let patch = Interior::from_fiducials(&camera(), &marks, [410.0, 111.0]).unwrap();
        let (of_scan, of_patch) = (whole.photo_mm(510.5, 211.5), patch.photo_mm(100.5, 100.5));
        assert!((of_scan[0] - of_patch[0]).abs() < 1e-12 && (of_scan[1] - of_patch[1]).abs() < 1e-12);
        assert!((patch.pixel_mm() - (0.25_f64 * 0.26 + 0.01 * 0.02).sqrt()).abs() < 1e-15);
    }

    #[test]
    fn an_ideal_position_leads_back_to_the_image() {
        let camera = CameraMm { radial_distortion: [-3e-5, 2e-9, 0.0], ..camera() };
        // A scan that is turned by a right angle, of a photo whose axes go right and up.
        let parameters = [[0.01, 0.25, -100.0], [0.26, -0.02, -90.0]];
        let turned = Interior { parameters, ..Interior::from_pixel_size(&camera, 800, 600).unwrap() };
        for interior in [turned, Interior::from_pixel_size(&camera, 4000, 3000).unwrap()] {
            for [x, y] in [[0.0, 0.0], [400.0, 300.0], [790.5, 20.25], interior.principal_point_px()] {
                let [ideal_x, ideal_y] = interior.undistorted_px(x, y);
                let [back_x, back_y] = interior.image_px(ideal_x, ideal_y).unwrap();
                assert!((back_x - x).abs() < 1e-8 && (back_y - y).abs() < 1e-8, "{back_x}, {back_y} instead of {x}, {y}");
            }
        }
        let strong = Interior { radial_distortion: [-1.0, 0.0, 0.0], ..turned };
        assert_eq!(strong.image_px(1e4, 1e4), None, "the correction turns back before");
    }

    #[test]
    fn positive_k1_moves_points_outwards() {
        let camera = CameraMm { principal_point_mm: [0.0; 2], radial_distortion: [1e-4, 1e-7, 1e-10], ..camera() };
        let interior = Interior::from_pixel_size(&camera, 2000, 2000).unwrap();
        let [x, y] = interior.photo_mm(1300.0, 600.0);
        let factor = 1.0 + 25.0 * 1e-4 + 625.0 * 1e-7 + 15625.0 * 1e-10;
        assert!((x - 3.0 * factor).abs() < 1e-12 && (y - 4.0 * factor).abs() < 1e-12);
    }
}
