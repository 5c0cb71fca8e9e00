//! What the user chooses of the bundle adjustment.

use crate::Error;
use crate::math::normal_quantile;
use crate::parameters::check;
use serde::{Deserialize, Serialize};

/// What says where the block lies in object space.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Datum {
    /// The approximate values: a free network with seven inner constraints on the orientations of all images.
    Free,
    /// The images' GNSS positions.
    Gnss,
    /// The control points.
    Control,
    /// Both.
    GnssAndControl,
}

/// How rays with large residuals are weighted down until the gross errors are found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Loss {
    /// Not at all: least squares.
    Squares,
    /// In proportion beyond two standard errors (Huber 1964).
    Huber,
    /// By 1 / (1 + (v/3σ)²): gross errors lose all influence.
    Cauchy,
}

/// Options of [`adjust_block`](crate::adjust_block).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct AdjustmentOptions {
    pub datum: Datum,
    pub loss: Loss,
    /// Reject gross errors by data snooping.
    pub snooping: bool,
    /// Probability α₀ with which data snooping rejects a good coordinate (Baarda 1968).
    pub alpha0: f64,
    /// Standard error of an image coordinate of weight 1 in px that was known before; absent: estimated from the residuals.
    pub sigma0_px: Option<f64>,
    /// A free camera parameter is fixed where its standard error moves a ray at the edge of the image by more than this, in px.
    pub calibration_limit_px: f64,
    /// Iterations that one adjustment may take.
    pub max_iterations: usize,
    /// Compute standard errors, redundancies and tests; data snooping needs them.
    pub statistics: bool,
}

impl Default for AdjustmentOptions {
    fn default() -> Self {
        Self {
            datum: Datum::Free,
            loss: Loss::Cauchy,
            snooping: true,
            alpha0: 0.001,
            sigma0_px: None,
            calibration_limit_px: 2.0,
            max_iterations: 100,
            statistics: true,
        }
    }
}

impl AdjustmentOptions {
    /// Refuses values outside their ranges.
    pub(crate) fn check(&self) -> Result<(), Error> {
        check("adjustment.alpha0", self.alpha0)?;
        if let Some(sigma0_px) = self.sigma0_px {
            check("adjustment.sigma0_px", sigma0_px)?;
        }
        check("adjustment.calibration_limit_px", self.calibration_limit_px)?;
        check("adjustment.max_iterations", self.max_iterations as f64)
    }

    /// The standardised residual beyond which a coordinate is a gross error.
    pub(super) fn limit(&self) -> f64 {
        normal_quantile(1.0 - 0.5 * self.alpha0)
    }
}

impl Datum {
    pub(crate) fn uses_gnss(self) -> bool {
        matches!(self, Self::Gnss | Self::GnssAndControl)
    }

    pub(crate) fn uses_control(self) -> bool {
        matches!(self, Self::Control | Self::GnssAndControl)
    }
}
