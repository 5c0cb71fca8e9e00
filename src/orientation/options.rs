//! What the user chooses of the relative orientation.

use crate::Error;
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

/// Options of [`orient_relative`](crate::orient_relative).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct OrientationOptions {
    pub method: OrientationMethod,
    /// Start from the consensus of minimal samples and reject gross errors.
    pub robust: bool,
    /// Standardised residual above which an observation is rejected; 3.29 rejects one good observation in a thousand (Baarda 1968).
    pub rejection: f64,
    /// Start of the random numbers.
    pub seed: u32,
    /// Photo base b in mm; absent: the median x-parallax of the accepted observations.
    pub base_mm: Option<f64>,
}

impl Default for OrientationOptions {
    fn default() -> Self {
        Self { method: OrientationMethod::Rigorous, robust: true, rejection: 3.29, seed: 1, base_mm: None }
    }
}

impl OrientationOptions {
    /// Refuses values outside their ranges.
    pub(crate) fn check(&self) -> Result<(), Error> {
        check("orientation.rejection", self.rejection)?;
        match self.base_mm {
            Some(base_mm) if base_mm == 0.0 => Err(refuse("orientation.base_mm", base_mm, "-1000000 to 1000000, but not 0")),
            Some(base_mm) => check("orientation.base_mm", base_mm),
            None => Ok(()),
        }
    }
}
