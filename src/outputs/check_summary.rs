//! What check points say of a model, in figures.

use crate::{ControlRole, SurveyedPoint};
use serde::Serialize;

/// What check points say of a model: differences, adjusted minus surveyed, as `surveyed.csv` has them: in m on the ground along the axes of the coordinate
/// reference system of the results, where one was chosen, and otherwise along those of the adjustment.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct CheckSummary {
    pub points: usize,
    /// Root mean squares of x, y, z.
    pub rmse_m: [f64; 3],
    /// Root mean squares of the length of x and y, and of the height.
    pub plan_rmse_m: f64,
    pub height_rmse_m: f64,
    pub mean_m: [f64; 3],
    /// Root mean square of the differences by their predicted standard errors: about 1 where these hold; absent without statistics.
    pub ratio: Option<f64>,
}

impl CheckSummary {
    /// Of the check points among the surveyed points of a model; absent without any.
    pub(super) fn of(surveyed: &[SurveyedPoint]) -> Option<Self> {
        let checks: Vec<&SurveyedPoint> = surveyed.iter().filter(|point| point.role == ControlRole::Check).collect();
        let mean = |of: &dyn Fn(&SurveyedPoint) -> f64| checks.iter().map(|point| of(point)).sum::<f64>() / checks.len() as f64;
        let ratios: Vec<f64> =
            (checks.iter()).flat_map(|point| (0..3).filter_map(|k| Some(point.difference_m[k] / point.standard_errors_m[k]?))).collect();
        let square = |k: usize| mean(&|point| point.difference_m[k] * point.difference_m[k]);
        (!checks.is_empty()).then(|| Self {
            points: checks.len(),
            rmse_m: [0, 1, 2].map(|k| square(k).sqrt()),
            plan_rmse_m: (square(0) + square(1)).sqrt(),
            height_rmse_m: square(2).sqrt(),
            mean_m: [0, 1, 2].map(|k| mean(&|point| point.difference_m[k])),
            ratio: (!ratios.is_empty()).then(|| (ratios.iter().map(|ratio| ratio * ratio).sum::<f64>() / ratios.len() as f64).sqrt()),
        })
    }
}
