//! What a bundle adjustment gives.

use super::block::Block;
use super::left_out::LeftOut;
use super::options::Datum;
use super::systematic_result::SystematicResult;
use crate::CameraParameter;
use crate::message::messages;
use serde::{Deserialize, Serialize};

/// An adjusted block with its precision and reliability.
///
/// Standard errors are with σ₀ a priori where that is given, else with the estimated one, enlarged by what rejections took from the
/// estimate; those of a free network are with respect to its inner constraints.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct AdjustmentResult {
    /// The adjusted values; points without rays are as they were given.
    pub block: Block,
    pub datum: Datum,
    /// Standard error of one image coordinate of weight 1 in px, made consistent where the rejection has cut the residuals; absent without
    /// redundancy.
    pub sigma0_px: Option<f64>,
    pub sigma0_a_priori_px: Option<f64>,
    /// Standard error of a coordinate of weight 1 by which everything was weighted whose standard error is stated: the weight of a GNSS coordinate
    /// that is stated as σ is the square of this by σ and the factor of its group. Absent in older projects.
    #[serde(default)]
    pub weighted_by_px: Option<f64>,
    /// Standard error of a coordinate of weight 1 by which cofactors become the covariances of what was estimated. Absent in older projects.
    #[serde(default)]
    pub unit_error_px: Option<f64>,
    /// What rejections have left of the variance of good observations, 1 without any: σ₀² is v'Pv by the degrees of freedom divided by it, and so is
    /// the square of `unit_error_px` beside that of σ₀. Absent in older projects.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub variance_left: Option<f64>,
    /// Standard deviation of the shared errors that standard errors hold, in standard errors of an observation.
    #[serde(default)]
    pub shared_errors: f64,
    pub degrees_of_freedom: usize,
    /// Root mean square length of the residuals of all accepted rays in px.
    pub rmse_px: f64,
    /// The same of the points of each number of rays, from 1 on, since a surveyed position counts as a ray; those without points are left
    /// out.
    pub rmse_by_rays: Vec<RayCountRmse>,
    /// Those of `weighting` not counted.
    pub iterations: usize,
    /// Root mean square of the last step in standard errors of the unknowns.
    pub last_step: f64,
    /// Adjustments until the set of accepted rays had settled; those of `weighting` not counted.
    pub rounds: usize,
    pub cameras: Vec<CameraStatistics>,
    pub images: Vec<ImageStatistics>,
    /// Absent for points without accepted rays.
    pub points: Vec<Option<ObjectPointStatistics>>,
    pub rays: Vec<ObservationStatistics>,
    /// One for each control point; absent where the datum does not use it.
    pub control: Vec<Option<PriorStatistics>>,
    /// How large the errors of observations are beside their stated standard errors, group by group; empty where no group states any.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub components: Vec<VarianceComponent>,
    /// How weights by the residuals were reached; absent where variance components were not to be estimated.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub weighting: Option<GroupWeighting>,
    /// What systematic errors GNSS positions have; absent where none were to be estimated, or the datum uses no positions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub systematic: Option<SystematicResult>,
}

impl AdjustmentResult {
    /// How many times their stated standard errors control points have, coordinate by coordinate, as far as weights follow it.
    pub(crate) fn factors_of_control(&self) -> [f64; 3] {
        let of = |group| self.components.iter().find(|component| component.group == group && component.applied).map_or(1.0, |c| c.factor);
        let [across, up] = [ObservationGroup::ControlPlan, ObservationGroup::ControlHeight].map(of);
        [across, across, up]
    }
}

messages! {
    /// Observations whose standard errors are stated together.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(rename_all = "snake_case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum ObservationGroup as "observation_group" {
        /// Image measurements of control and check points, and those by hand.
        Marks,
        /// X and Y of GNSS positions.
        GnssPlan,
        /// Z of GNSS positions.
        GnssHeight,
        /// X and Y of control points.
        ControlPlan,
        /// Z of control points.
        ControlHeight,
    }
}

impl ObservationGroup {
    pub(super) const ALL: [Self; 5] = [Self::Marks, Self::GnssPlan, Self::GnssHeight, Self::ControlPlan, Self::ControlHeight];
}

/// How the weights of groups of observations were found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct GroupWeighting {
    /// Times that a group was weighted anew.
    pub rounds: usize,
    /// Of all adjustments after the first of these.
    pub iterations: usize,
    /// Whether nothing was left to change; otherwise weights still changed when the rounds were spent.
    pub converged: bool,
}

/// What the residuals of a group say of its stated standard errors.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct VarianceComponent {
    pub group: ObservationGroup,
    /// Coordinates that took part.
    pub observations: usize,
    /// Sum of their redundancies.
    pub redundancy: f64,
    /// Standard errors by the residuals are so many times those that were stated; 1 where it is held.
    pub factor: f64,
    /// That holds the true factor in 95 of 100 cases at least; absent where it is held.
    pub interval: Option<[f64; 2]>,
    /// Whether the observations are weighted by it; otherwise by what was stated.
    pub applied: bool,
    /// Whether it was not estimated, since the redundancy does not determine it.
    #[serde(default)]
    pub held: bool,
}

/// A camera parameter that was to be estimated and was fixed, since the block does not determine it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct FixedParameter {
    pub parameter: CameraParameter,
    /// By how much one standard error of it would move a ray at the edge of the image, in px; absent where nothing determines it at all.
    pub effect_px: Option<f64>,
}

/// Precision of a camera.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct CameraStatistics {
    /// Of f, c_x, c_y in px, k₁, k₂, k₃, p₁, p₂; absent for what was not estimated.
    pub standard_errors: [Option<f64>; 8],
    /// Between the parameters that were estimated, in their order, row by row; empty without any.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub correlations: Vec<Vec<f64>>,
    pub fixed: Vec<FixedParameter>,
}

/// Precision of an image.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ImageStatistics {
    /// Accepted rays.
    pub rays: usize,
    /// Root mean square length of the residuals of its accepted rays in px; 0 without any.
    pub rmse_px: f64,
    /// Standard errors of ω, φ, κ; absent without statistics, and where φ is ±90°.
    pub angle_errors_deg: Option<[f64; 3]>,
    /// Standard errors of X₀; absent without statistics.
    pub position_errors: Option<[f64; 3]>,
    /// Correlations of X₀ with Y₀, of X₀ with Z₀, of Y₀ with Z₀; absent without statistics.
    #[serde(default)]
    pub position_correlations: Option<[f64; 3]>,
    /// Of its GNSS position, where the datum uses it.
    pub gnss: Option<PriorStatistics>,
}

/// What the adjustment says of an observed position; 0 for a coordinate that was not observed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct PriorStatistics {
    /// Whether it took part; otherwise it lies too far from where the other observations have it.
    pub accepted: bool,
    /// Observed minus adjusted: of a GNSS position with its systematic errors.
    pub residual: [f64; 3],
    /// r, 0..1, of each coordinate; absent without statistics.
    pub redundancy: Option<[f64; 3]>,
    /// Residual by its standard error (Baarda's w), of a new observation where it took no part; absent without statistics.
    pub w: Option<[f64; 3]>,
    /// The error that its test finds with a probability of 0.80 (internal reliability); absent where nothing checks the coordinate.
    #[serde(default)]
    pub detectable: [Option<f64>; 3],
    /// External reliability: no function of the unknowns changes by more than so many of its standard errors by an undetected error of that size.
    #[serde(default)]
    pub influence: [Option<f64>; 3],
    /// How far an undetected error of that size moves the adjusted coordinate.
    #[serde(default)]
    pub moves: [Option<f64>; 3],
    /// Of a control point: its place by all other observations; absent where these do not determine it, and without statistics.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub left_out: Option<LeftOut>,
}

/// Precision of an object point.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ObjectPointStatistics {
    /// Accepted rays.
    pub rays: usize,
    /// Root mean square length of the residuals of its accepted rays in px.
    pub rmse_px: f64,
    /// Standard errors of X, Y, Z; absent without statistics.
    pub errors: Option<[f64; 3]>,
    /// Correlations of X with Y, of X with Z, of Y with Z; absent without statistics.
    #[serde(default)]
    pub correlations: Option<[f64; 3]>,
}

/// Why a ray takes part, or does not.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum ObservationVerdict {
    Accepted,
    /// Data snooping rejected it.
    GrossError,
    /// Its point lies behind the image.
    Behind,
    /// Its point has fewer than two rays left, or rays that do not meet.
    LostPoint,
}

/// What the adjustment says of one ray, accepted or not.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ObservationStatistics {
    pub verdict: ObservationVerdict,
    /// Observed minus computed column and row in px.
    pub residual_px: [f64; 2],
    /// r, 0..1, of column and row: the share of an error that shows in the residual; absent without statistics.
    pub redundancy: Option<[f64; 2]>,
    /// Residuals by their standard errors (Baarda's w), of a new observation for a rejected one; absent without statistics.
    pub w: Option<[f64; 2]>,
    /// The error that its test finds with a probability of 0.80 (internal reliability); absent where nothing checks the coordinate.
    #[serde(default)]
    pub detectable_px: [Option<f64>; 2],
    /// External reliability: no function of the unknowns changes by more than so many of its standard errors by an undetected error of that size.
    #[serde(default)]
    pub influence: [Option<f64>; 2],
    /// How far an undetected error of that size moves its object point; absent in a free network, where that depends on the inner constraints.
    #[serde(default)]
    pub moves_point: [Option<f64>; 2],
}

/// Residuals of the points of one number of rays.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct RayCountRmse {
    /// Accepted rays of each of these points.
    pub rays: usize,
    pub points: usize,
    pub rmse_px: f64,
}
