//! What an adjustment says of systematic errors of GNSS positions.

use super::strips::Strip;
use crate::message::messages;
use serde::{Deserialize, Serialize};

/// The systematic errors of GNSS positions that were to be estimated.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct SystematicResult {
    /// The strips whose errors were to be estimated. Images that follow no line are in none.
    pub strips: Vec<Strip>,
    pub errors: Vec<SystematicStatistics>,
    /// Motions of the whole block that nothing tells from all of these errors together: those that are estimated are relative to each other, or to those
    /// that were fixed at zero.
    pub constraints: usize,
    /// Images in no strip whose positions therefore take no part: errors of strips say nothing of theirs.
    #[serde(default)]
    pub left_out: Vec<usize>,
}

messages! {
    /// An error that GNSS positions have in common, with three values in the unit of the positions: metres in a georeferenced block.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum SystematicError as "systematic_error" {
        /// From the projection centre to the antenna in the axes of the camera: x right, y up, z against the direction of view.
        LeverArm { camera: usize },
        /// X, Y, Z that are added to all positions.
        Offset,
        /// X, Y, Z that are added to the positions of a strip: in its middle, where it has a drift.
        StripOffset { strip: usize },
        /// By how much the error of the positions of a strip grows from its first image to its last.
        StripDrift { strip: usize },
    }
}

messages! {
    /// What became of a systematic error.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(rename_all = "snake_case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum SystematicVerdict as "systematic_verdict" {
        /// It differs from zero by more than chance: positions are corrected by it.
        Kept,
        /// It does not: it is zero.
        NotSignificant,
        /// Nothing determines it: it is zero.
        Undetermined,
    }
}

/// A systematic error as the adjustment has it, or had it before it was fixed at zero.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct SystematicStatistics {
    pub error: SystematicError,
    pub verdict: SystematicVerdict,
    /// In the unit of the positions, as the standard errors; 0, without a standard error, for a value that nothing determines.
    pub estimate: [f64; 3],
    /// Absent for a value that was not estimated, and without statistics.
    pub standard_errors: [Option<f64>; 3],
    /// The mean square of the estimate in its standard errors, correlations taken into account; absent where it was not tested.
    pub test: Option<f64>,
    /// Above it, the test says that the error is not zero: the quantile of the F distribution (of χ² by its degrees of freedom where σ₀ is known).
    pub limit: Option<f64>,
}

impl SystematicStatistics {
    /// A value, where anything determines it.
    pub fn value(&self, axis: usize) -> Option<f64> {
        Some(self.estimate[axis]).filter(|value| *value != 0.0 || self.standard_errors[axis].is_some())
    }

    /// Of an error that was not estimated.
    pub(super) fn none(error: SystematicError, verdict: SystematicVerdict) -> Self {
        Self { error, verdict, estimate: [0.0; 3], standard_errors: [None; 3], test: None, limit: None }
    }
}
