//! What relative orientation takes and gives.

use super::OrientationMethod;
use crate::Side;
use crate::camera::rotation_from_angles;
use crate::message::messages;
use nalgebra::{Matrix3, Vector3};
use serde::{Deserialize, Serialize};

/// Photo coordinates of one point in both photos, in mm, x to the right, y up, origin at the principal point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Observation {
    pub left: [f64; 2],
    pub right: [f64; 2],
    /// Above 0; the variance of each of its coordinates is σ₀² / weight.
    pub weight: f64,
}

impl Observation {
    /// An observation of weight 1.
    pub fn new(left: [f64; 2], right: [f64; 2]) -> Self {
        Self { left, right, weight: 1.0 }
    }
}

/// One number for each of the five unknowns.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct FiveParameters {
    pub omega_deg: f64,
    pub phi_deg: f64,
    pub kappa_deg: f64,
    pub by_mm: f64,
    pub bz_mm: f64,
}

/// What the adjustment says of one observation, accepted or rejected. Absent where its rays run along the base.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PointStatistics {
    /// Residual y-parallax in mm: how far the right point lies from the epipolar line of the left point, to the left of which it is
    /// positive.
    pub parallax_mm: f64,
    /// r, 0..1: the share of an error that shows in the residual. For a rejected one that of a new observation.
    pub redundancy: f64,
    /// Residual divided by its standard error: Baarda's w of a known σ₀, Pope's τ of an estimated one.
    pub w: f64,
    /// The smallest displacement of the right point across its epipolar line, in mm, that data snooping finds with the probability β₀;
    /// infinite where one degree of freedom estimates σ₀, by which nothing is found.
    #[serde(with = "crate::json::infinite")]
    pub detectable_mm: f64,
    /// External reliability: the largest change of an unknown, in its standard errors, by an undetected blunder of that size.
    #[serde(with = "crate::json::infinite")]
    pub influence: f64,
    /// Weight with which it took part: its own times that of the robust weighting, 0 where it was rejected.
    pub weight: f64,
    /// Place X, Y, Z in the left photo's system in mm, at photo scale (the base being b, by, bz); absent for parallel rays.
    pub model_mm: Option<[f64; 3]>,
}

/// The test whether σ₀ agrees with the one that was known before.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct GlobalTest {
    /// Degrees of freedom times σ₀² / σ₀² a priori: follows χ².
    pub statistic: f64,
    /// Between these it lies in 95 of 100 adjustments.
    pub lower: f64,
    pub upper: f64,
    pub passed: bool,
}

/// The standard error ellipse of two unknowns.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ErrorEllipse {
    pub semi_major: f64,
    pub semi_minor: f64,
    /// Of the long axis, from the first unknown's axis towards that of the second, -90 to 90.
    pub bearing_deg: f64,
}

impl ErrorEllipse {
    /// The ellipse of the same shape with axes `factor` times as long.
    pub fn scaled(self, factor: f64) -> Self {
        Self { semi_major: factor * self.semi_major, semi_minor: factor * self.semi_minor, ..self }
    }

    /// From the variances of two unknowns and their covariance.
    pub fn new(first: f64, covariance: f64, second: f64) -> Self {
        let (middle, half) = (0.5 * (first + second), 0.5 * (first - second));
        let root = (half * half + covariance * covariance).sqrt();
        Self {
            semi_major: (middle + root).max(0.0).sqrt(),
            semi_minor: (middle - root).max(0.0).sqrt(),
            bearing_deg: (0.5 * libm::atan2(covariance, half)).to_degrees(),
        }
    }
}

/// A camera that is not known without error: prior information, and where its pair tells more, matches with it, in the millimetres of its photo
/// coordinates.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct EstimatedCamera {
    pub focal_mm: f64,
    pub focal_standard_error_mm: f64,
    pub principal_point_mm: [f64; 2],
    pub principal_point_standard_errors_mm: [f64; 2],
    /// The first term of the radial distortion, as [`Interior::photo_mm`](crate::Interior::photo_mm) has it, in mm⁻².
    pub k1_per_mm2: f64,
    pub k1_standard_error_per_mm2: f64,
}

messages! {
    /// What makes an orientation weak although it could be computed.
    #[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum Warning as "warning" {
        /// All points lie in a plane within what the observations can tell: a second pose fits nearly as well. `ratio`: its σ₀ by that of this
        /// one; from `least` on it would be excluded.
        Plane { ratio: f64, least: f64 },
        /// The points cover a small part of the photos: their root mean square distance from their middle, in focal lengths.
        Clustered { coverage: f64, least: f64 },
        /// The photos hardly differ but by a rotation, which leaves this median parallax: the base is too short to be told from noise and
        /// distortion.
        Rotation { parallax_deg: f64, least_deg: f64 },
        /// The unknowns can hardly be told apart, as over a critical cylinder.
        IllConditioned { #[serde(with = "crate::json::infinite")] condition: f64, most: f64 },
        /// So few observations that they hardly check each other: a gross error in one of them is not found unless it is very large, nor does it show in the
        /// standard errors.
        Unchecked { observations: usize },
        /// Observations that are the same as others to the last digit: each counts once. `rejected`: how many of the copies are rejected.
        Identical { copies: usize, #[serde(default)] rejected: usize },
        /// Points whose rays meet behind a camera are left out.
        Behind { points: usize },
        /// The residuals contradict the σ₀ that was given: standard errors and tests use the estimated one.
        Sigma { estimated_um: f64, given_um: f64 },
        /// The residuals ask for another focal length, which would move unknowns out of their intervals; `w`: in standard errors.
        FocalLength { change_percent: f64, w: f64 },
        /// Half the focal length fits nearly as well, as in a narrow view of level ground: nothing checks the given one. `ratio`: its σ₀ by that of the
        /// given one; from `least` on it would be excluded.
        UncheckedFocal { ratio: f64, least: f64 },
        /// The base that was given is so many times as long as that at photo scale, of which up to `most` are plausible.
        DoubtfulBase { base_mm: f64, times: f64, most: f64 },
        /// The matches that took part lie in few places of the photo; those of one place share errors, as a wrong pattern does.
        FewPlaces { places: usize, least: usize },
        /// Few matches took part, or few of the points were matched: as many agree on the geometry of a repeated pattern.
        FewMatches { matches: usize, least: usize },
        /// Many matches do not agree with the orientation.
        FewAgree { accepted: usize, matches: usize },
        /// The right photo shows the ground mirrored.
        Mirrored,
        /// The fiducial marks lie mirrored in the scan.
        MirroredMarks { side: Side },
        /// The focal length is hardly known: it was estimated with the orientation, which determines it poorly.
        UnknownCamera,
        /// The focal length that was given for a photo is another than what its file says.
        ContradictedFocal { side: Side, given_px: f64, file_px: f64 },
        /// The focal length of a photo is hardly one of its camera: in longer sides of the image, of which `least` to `most` are usual.
        DoubtfulFocal { side: Side, sides: f64, least: f64, most: f64 },
        /// The principal point of a photo lies so many longer sides of its image from its middle, of which up to `most` are usual.
        FarPrincipalPoint { side: Side, sides: f64, most: f64 },
        /// The distortion of a photo takes the farthest corner of its image to `factor` times its distance from the principal point, where `least` to
        /// `most` are usual.
        DoubtfulDistortion { side: Side, factor: f64, least: f64, most: f64 },
        /// The file of a photo has fewer pixels than its EXIF says: whether it was resized or cropped is not known.
        ResizedOrCropped { side: Side, taken_width_px: u32, taken_height_px: u32, width_px: u32, height_px: u32 },
        /// The file of a photo has another format than its EXIF says: it was cropped, and nobody knows where its principal point lies.
        Cropped { side: Side, taken_width_px: u32, taken_height_px: u32, width_px: u32, height_px: u32 },
        /// The pixels of a photo are not those of its sensor: it was resized or cropped.
        OtherPixels { side: Side, pixel_um: f64, expected_um: f64 },
        /// The side of a pixel that was given with the camera is another than the fiducial marks of scans give, and not used.
        UnusedPixel { pixel_mm: f64, marks_mm: f64 },
        /// The matches ask for a similarity alone, as those of parts of one image do, and of level photos over flat ground.
        SimilarityAlone,
        /// The matches agree better than those of two photographs ever do.
        Exact { sigma0_px: f64, least_px: f64 },
        /// The points reach farther from the axis than those of perspective cameras do: their root mean square distance from their middle, in
        /// focal lengths.
        WideAngle { coverage: f64, most: f64 },
        /// The rotation is known within a wide interval of 95 % only.
        Uncertain { #[serde(with = "crate::json::infinite")] half_width_deg: f64, most_deg: f64 },
        /// The direction of the base is.
        UncertainBase { #[serde(with = "crate::json::infinite")] half_width_deg: f64, most_deg: f64 },
        /// The standard error of a photo coordinate is larger than matching leaves it.
        Imprecise { sigma0_px: f64, most_px: f64 },
        /// The standard error of a coordinate that somebody measured is larger than measuring leaves it.
        Coarse { sigma0_um: f64, most_um: f64 },
    }
}

impl Warning {
    /// Whether the image of a photo may be a part of it.
    pub(crate) fn is_of_part(&self) -> bool {
        matches!(self, Self::ResizedOrCropped { .. } | Self::Cropped { .. } | Self::OtherPixels { .. })
    }

    /// Whether the orientation may be wrong or of little use. The other warnings tell what was done about the observations, or what the
    /// intervals hold already.
    pub fn is_weakness(&self) -> bool {
        match self {
            Self::Identical { .. }
            | Self::Behind { .. }
            | Self::Sigma { .. }
            | Self::IllConditioned { .. }
            | Self::UnusedPixel { .. }
            | Self::DoubtfulBase { .. } => false,
            Self::Plane { .. }
            | Self::Clustered { .. }
            | Self::Rotation { .. }
            | Self::FocalLength { .. }
            | Self::UncheckedFocal { .. }
            | Self::Unchecked { .. }
            | Self::FewPlaces { .. }
            | Self::FewMatches { .. }
            | Self::FewAgree { .. }
            | Self::Mirrored
            | Self::MirroredMarks { .. }
            | Self::UnknownCamera
            | Self::ContradictedFocal { .. }
            | Self::DoubtfulFocal { .. }
            | Self::FarPrincipalPoint { .. }
            | Self::DoubtfulDistortion { .. }
            | Self::ResizedOrCropped { .. }
            | Self::Cropped { .. }
            | Self::OtherPixels { .. }
            | Self::SimilarityAlone
            | Self::Exact { .. }
            | Self::WideAngle { .. }
            | Self::UncertainBase { .. }
            | Self::Uncertain { .. }
            | Self::Imprecise { .. }
            | Self::Coarse { .. } => true,
        }
    }
}

/// The dependent relative orientation of the right photo, with its precision.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct RelativeOrientation {
    #[serde(flatten)]
    pub parameters: FiveParameters,
    /// The angle by which the photo axes of ω φ κ by bz, the base and the points in the model are turned anticlockwise from those of the
    /// photo coordinates: 0, or 90 where [`orient_matches`](crate::orient_matches) met a base across the x axis.
    pub turn_deg: f64,
    /// The base component b that was fixed.
    pub base_mm: f64,
    pub focal_mm: f64,
    pub method: OrientationMethod,
    /// With σ₀ a priori where that is given and the global test does not contradict it; else with the estimated σ₀, and absent without redundancy.
    pub standard_errors: Option<FiveParameters>,
    /// The same with what makes observations depend on each other: the errors of cameras and interior orientations, and what matches
    /// share. They are no less than the others; absent where neither is known.
    pub total_standard_errors: Option<FiveParameters>,
    /// Half-widths of the intervals in which the unknowns lie with a probability of 95 %: the total standard errors, or the others where these are
    /// absent, times the limit of Student's distribution: for the degrees of freedom of σ₀, and of the σ₀ of the fiducial marks as far as their errors
    /// count (Welch and Satterthwaite); 1.96 where all are known.
    pub half_widths_95: Option<FiveParameters>,
    /// Standard error of one photo coordinate of weight 1 in mm (a y-parallax has √2 of it), from the residuals, made consistent where the
    /// rejection has cut their distribution; absent without redundancy.
    pub sigma0_mm: Option<f64>,
    /// The σ₀ that was known before.
    pub sigma0_a_priori_mm: Option<f64>,
    /// What the rejection has left of the variance of good observations, 1 without a rejection: σ₀² and the cofactors are those of the accepted
    /// observations divided by it. Absent in older projects.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub variance_left: Option<f64>,
    /// Present with σ₀ a priori and redundancy.
    pub global_test: Option<GlobalTest>,
    pub degrees_of_freedom: usize,
    pub iterations: usize,
    /// Size of the last step relative to a millionth of the standard errors, or to rounding where these are smaller: below 1 it has converged.
    #[serde(with = "crate::json::infinite")]
    pub last_step: f64,
    /// Cofactors of ω φ κ (radians), by bz (mm) for σ₀ = 1 mm: variances are σ₀² times the diagonal.
    pub cofactors: [[f64; 5]; 5],
    /// Of ω φ κ by bz, from the inverse of the normal equations.
    pub correlations: [[f64; 5]; 5],
    /// Largest by smallest eigenvalue of the matrix of correlations: 1 for independent unknowns.
    #[serde(with = "crate::json::infinite")]
    pub condition: f64,
    /// How far the points deviate from the best projective map of a plane, in standard errors of a coordinate: about 1 over a plane. Absent
    /// with fewer than ten points.
    pub plane_misfit: Option<f64>,
    /// The spread of the points in the left photo: root mean square distance from their middle, in focal lengths.
    pub spread: f64,
    /// Median parallax that the best rotation leaves, in mm: what of the photos' difference only a base explains.
    pub parallax_beside_rotation_mm: f64,
    pub warnings: Vec<Warning>,
    /// Standard error ellipse of by and bz in mm, with what the interior orientations add where that is known.
    pub base_ellipse_mm: Option<ErrorEllipse>,
    /// The ellipse in which by and bz both lie with a probability of 95 %.
    pub base_ellipse_95_mm: Option<ErrorEllipse>,
    /// δ₀: how many standard errors a residual is shifted by an error that its test finds with the probability β₀. Absent where fewer than two
    /// degrees of freedom estimate σ₀, by which none is found.
    pub noncentrality: Option<f64>,
    /// Corrections `[vx_left, vy_left, vx_right, vy_right]` in mm of every observation, the rejected ones included.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "Float64Array"))]
    pub residuals_mm: Vec<[f64; 4]>,
    /// One for each observation.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "Float64Array"))]
    pub points: Vec<Option<PointStatistics>>,
    /// Indices of the observations that were left out as gross errors.
    pub rejected: Vec<usize>,
    /// The left and the right camera where they are not known without error, in the photo axes of ω φ κ by bz; absent where both are.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cameras: Option<[EstimatedCamera; 2]>,
}

impl RelativeOrientation {
    /// The rotation from the left photo's axes to the right photo's and the direction of the base in the left one's, of length 1: both in
    /// the axes of the photo coordinates, whatever [`Self::turn_deg`] is.
    pub fn pose(&self) -> (Matrix3<f64>, Vector3<f64>) {
        let p = self.parameters;
        let rotation = rotation_from_angles(p.omega_deg.to_radians(), p.phi_deg.to_radians(), p.kappa_deg.to_radians());
        let base = Vector3::new(self.base_mm, p.by_mm, p.bz_mm).normalize();
        if self.turn_deg == 0.0 {
            return (rotation, base);
        }
        // From the photo's axes to those turned by 90°.
        let turn = Matrix3::new(0.0, 1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 1.0);
        (turn.transpose() * rotation * turn, turn.transpose() * base)
    }

    /// The orientation in photo axes that were turned by 90° for it: corrections go back to the axes of the photo coordinates.
    pub(crate) fn turned_back(mut self) -> Self {
        self.turn_deg = 90.0;
        self.residuals_mm.iter_mut().for_each(|v| *v = [-v[1], v[0], -v[3], v[2]]);
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_ellipse_has_its_axes_along_the_eigenvectors() {
        let ellipse = ErrorEllipse::new(4.0, 0.0, 1.0);
        assert_eq!((ellipse.semi_major, ellipse.semi_minor, ellipse.bearing_deg), (2.0, 1.0, 0.0));
        // Axes of 3 and 1, the long one at 30°.
        let (sin, cos) = (0.5, 0.75_f64.sqrt());
        let ellipse = ErrorEllipse::new(9.0 * cos * cos + sin * sin, 8.0 * sin * cos, 9.0 * sin * sin + cos * cos);
        assert!((ellipse.semi_major - 3.0).abs() < 1e-12 && (ellipse.semi_minor - 1.0).abs() < 1e-12);
        assert!((ellipse.bearing_deg - 30.0).abs() < 1e-12);
    }
}
