//! What the user chooses of an interest operator.

use super::Selection;
use crate::Error;
use crate::parameters::refuse;
use serde::{Deserialize, Serialize};

/// The published interest operators, and points of many scales.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Operator {
    Moravec,
    Forstner,
    Ground1,
    Ground2,
    /// Points distinct in position and scale: [`multiscale_points`](crate::multiscale_points), which has options of its own.
    Multiscale,
}

/// Which of equal neighbouring values survive the suppression of non-maxima.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Ties {
    /// All of them.
    Keep,
    /// The first in raster order.
    First,
}

/// Options of [`detect`](crate::detect). What is absent takes the operator's own default; all but the operator is of those that look at one
/// scale.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct PointOptions {
    pub operator: Operator,
    /// Moravec: sum of squared grey differences. Förstner: factor of the mean weight. Ground: grey difference. Absent, as is
    /// `fraction`: the operator's default, lowered where it leaves less than 5 % of the pixels as candidates.
    pub threshold: Option<f64>,
    /// Instead of a threshold: the share of all pixels that are to be candidates, 0..1.
    pub fraction: Option<f64>,
    /// Least roundness q (Förstner, ground 2), 0..1.
    pub roundness: Option<f64>,
    /// Side of the operator's window in px (Moravec 4 or 8, Förstner 5 or 7; any from 2 or 3 up is taken).
    pub operator_window: Option<usize>,
    /// Moravec: windows side by side in place of one at each pixel.
    pub tiled: bool,
    /// Side of the suppression window in px, odd; 1 suppresses nothing.
    pub suppression_window: usize,
    pub ties: Ties,
}

impl Default for PointOptions {
    fn default() -> Self {
        Self {
            operator: Operator::Ground2,
            threshold: None,
            fraction: None,
            roundness: None,
            operator_window: None,
            tiled: false,
            suppression_window: 3,
            ties: Ties::Keep,
        }
    }
}

impl PointOptions {
    /// The threshold or the fraction: as given, or the operator's default threshold, adapted to the image.
    pub(super) fn selection(&self) -> Result<Selection, Error> {
        match (self.threshold, self.fraction) {
            (Some(_), Some(_)) => Err(refuse("points.fraction", "given beside points.threshold", "one of the two")),
            (None, Some(fraction)) => Ok(Selection::Fraction(fraction)),
            (Some(threshold), None) => Ok(Selection::Threshold(threshold)),
            (None, None) => Ok(Selection::Adaptive(self.operator.default_threshold())),
        }
    }

    pub(super) fn roundness(&self) -> f64 {
        self.roundness.unwrap_or(self.operator.default_roundness())
    }

    pub(super) fn operator_window(&self) -> usize {
        self.operator_window.unwrap_or(self.operator.default_window())
    }
}

impl Operator {
    /// The paper's threshold; for Moravec, where it has none, one that suits well exposed 8-bit aerial photographs; 0 where the operator has
    /// none.
    pub const fn default_threshold(self) -> f64 {
        match self {
            Operator::Multiscale => 0.0,
            Operator::Moravec => 4000.0,
            Operator::Forstner => 1.0,
            Operator::Ground1 | Operator::Ground2 => 40.0,
        }
    }

    /// The lower end of the paper's range; 0 where the operator has no roundness.
    pub const fn default_roundness(self) -> f64 {
        match self {
            Operator::Moravec | Operator::Ground1 | Operator::Multiscale => 0.0,
            Operator::Forstner => 0.5,
            Operator::Ground2 => 0.32,
        }
    }

    /// Side of the operator's window in px; 0 where it has none of one size.
    pub const fn default_window(self) -> usize {
        match self {
            Operator::Multiscale => 0,
            Operator::Moravec => 4,
            Operator::Forstner => 5,
            Operator::Ground1 | Operator::Ground2 => 3,
        }
    }
}
