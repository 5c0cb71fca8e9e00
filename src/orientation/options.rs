//! What the user chooses of the relative orientation.

use crate::Error;
use crate::math::normal_quantile;
use crate::parameters::{check, refuse};
use serde::{Deserialize, Serialize};

/// What is minimised.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum OrientationMethod {
    /// The corrections of all four photo coordinates (Gauss-Helmert).
    Rigorous,
    /// The coplanarity determinants, unweighted (the short textbook form).
    Determinant,
}

/// How observations that survived the rejection are weighted down for their residuals.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Weighting {
    /// By nothing: least squares.
    None,
    /// By 1.5 / |w| where the standardised residual |w| exceeds 1.5 (Huber 1964).
    Huber,
    /// By exp(0.05 (2³ - |w|³)) where |w| exceeds 2 (Krarup, Juhl & Kubik 1980, made continuous).
    Danish,
}

/// Options of [`orient_relative`](crate::orient_relative).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct OrientationOptions {
    pub method: OrientationMethod,
    /// Start from the consensus of minimal samples and reject gross errors.
    pub robust: bool,
    /// Probability α₀ with which data snooping rejects a good observation: 0.001 rejects beyond 3.29 standard errors (Baarda 1968).
    pub alpha0: f64,
    /// Probability β₀ with which a blunder of the minimal detectable size is found.
    pub beta0: f64,
    pub weighting: Weighting,
    /// Standard error of a photo coordinate of weight 1 in mm that was known before; absent: estimated from the residuals. Observations are
    /// rejected by it, or by the estimated one where that is larger.
    pub sigma0_mm: Option<f64>,
    /// Start of the random numbers.
    pub seed: u32,
    /// Photo base b in mm; absent: the median x-parallax of the accepted observations.
    pub base_mm: Option<f64>,
}

impl Default for OrientationOptions {
    fn default() -> Self {
        Self {
            method: OrientationMethod::Rigorous,
            robust: true,
            alpha0: 0.001,
            beta0: 0.8,
            weighting: Weighting::None,
            sigma0_mm: None,
            seed: 1,
            base_mm: None,
        }
    }
}

impl OrientationOptions {
    /// Refuses values outside their ranges.
    pub(crate) fn check(&self) -> Result<(), Error> {
        check("orientation.alpha0", self.alpha0)?;
        check("orientation.beta0", self.beta0)?;
        if let Some(sigma0_mm) = self.sigma0_mm {
            check("orientation.sigma0_mm", sigma0_mm)?;
        }
        match self.base_mm {
            Some(base_mm) if base_mm == 0.0 => Err(refuse("orientation.base_mm", base_mm, "-1000000 to 1000000, but not 0")),
            Some(base_mm) => check("orientation.base_mm", base_mm),
            None => Ok(()),
        }
    }

    /// The standardised residual beyond which an observation is rejected.
    pub(super) fn limit(&self) -> f64 {
        normal_quantile(1.0 - 0.5 * self.alpha0)
    }

    /// δ₀: the shift of a standardised residual that exceeds the limit with the probability β₀.
    pub(super) fn noncentrality(&self) -> f64 {
        self.limit() + normal_quantile(self.beta0)
    }
}
