//! What operators find: candidates, and the points that are left of them.

use super::{MultiscaleOptions, ScalePoint};
use serde::{Deserialize, Serialize};

/// A point of interest. Positions are in px; the centre of the top-left pixel is (0.5, 0.5).
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct InterestPoint {
    pub x: f64,
    pub y: f64,
    /// The operator's interest value; its unit is the operator's.
    pub value: f64,
}

/// The scale and the direction of a point that has them.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LocalFrame {
    /// Standard deviation of the Gaussian at whose blur the point is most distinct, px.
    pub scale_px: f64,
    /// The dominant direction of the gradients, from x towards y; 0 where none was sought.
    pub orientation_rad: f64,
}

/// How many points each phase left (the first rows of the paper's Table 1).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct PointCounts {
    /// Pixels (or windows) that passed the operator's threshold.
    pub candidates: usize,
    /// Of these, the ones that passed the threshold of roundness; all of them where the operator has none.
    pub after_roundness: usize,
    /// Of these, the ones that suppression of non-maxima left.
    pub after_suppression: usize,
}

/// What an operator found before suppression.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Candidates {
    /// The points that passed all thresholds, in raster order: by row, then column.
    pub points: Vec<InterestPoint>,
    /// How many passed the first threshold, before that of roundness.
    pub candidates: usize,
    /// The threshold that was applied, in the operator's unit: as given, or as found for the wanted fraction.
    pub threshold: f64,
}

/// What an operator found, after suppression of non-maxima.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PointSet {
    /// In raster order: by row, then column; points of many scales by octave.
    pub points: Vec<InterestPoint>,
    /// One for each point, or none for the operators that look at one scale.
    pub frames: Vec<LocalFrame>,
    pub counts: PointCounts,
    /// As in [`Candidates`].
    pub threshold: f64,
}

impl From<&ScalePoint> for InterestPoint {
    fn from(point: &ScalePoint) -> Self {
        Self { x: point.x, y: point.y, value: point.weight }
    }
}

impl PointSet {
    /// The set of points of many scales; their order is kept.
    pub(crate) fn of_scales(framed: Vec<(InterestPoint, LocalFrame)>, options: &MultiscaleOptions) -> Self {
        let number = framed.len();
        let (points, frames) = framed.into_iter().unzip();
        let counts = PointCounts { candidates: number, after_roundness: number, after_suppression: number };
        Self { points, frames, counts, threshold: options.contrast }
    }
}
