//! What relative orientation takes and gives.

use serde::{Deserialize, Serialize};

/// Photo coordinates of one point in both photos, in mm, x to the right, y up, origin at the principal point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Observation {
    pub left: [f64; 2],
    pub right: [f64; 2],
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

/// The dependent relative orientation of the right photo, with its precision.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct RelativeOrientation {
    #[serde(flatten)]
    pub parameters: FiveParameters,
    /// The base component b that was fixed.
    pub base_mm: f64,
    pub focal_mm: f64,
    pub method: super::OrientationMethod,
    /// Absent without redundancy.
    pub standard_errors: Option<FiveParameters>,
    /// Standard error of one photo coordinate in mm (a y-parallax has √2 of it); absent without redundancy.
    pub sigma0_mm: Option<f64>,
    pub degrees_of_freedom: usize,
    pub iterations: usize,
    /// Size of the last step relative to a millionth of the standard errors, or to rounding where these are smaller: below 1 it has converged.
    pub last_step: f64,
    /// Of ω φ κ by bz, from the inverse of the normal equations.
    pub correlations: [[f64; 5]; 5],
    /// Corrections `[vx_left, vy_left, vx_right, vy_right]` in mm of every observation, the rejected ones included.
    pub residuals_mm: Vec<[f64; 4]>,
    /// Indices of the observations that were left out as gross errors.
    pub rejected: Vec<usize>,
}
