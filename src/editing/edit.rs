//! What may be changed by hand.

use crate::{ControlRole, PointSource, Remark};
use serde::{Deserialize, Serialize};

/// A change of a finished block by hand. Images count as those of the block.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum BlockEdit {
    /// They take no part, and are kept.
    RejectObservations {
        observations: Vec<PointImage>,
    },
    /// Those that did not fit before the adjustment come back, too; its tests may reject them again.
    RestoreObservations {
        observations: Vec<PointImage>,
    },
    RejectPoints {
        points: Vec<PointSource>,
    },
    RestorePoints {
        points: Vec<PointSource>,
    },
    RejectImages {
        images: Vec<usize>,
    },
    RestoreImages {
        images: Vec<usize>,
    },
    /// What only their matches support takes no part: of a tie point that both images show, the largest part stays whose images other pairs of the
    /// block connect (of equal ones that with the first image), and none of a single image. What was measured by hand stays.
    RejectPairs {
        /// Two images that matches connect, in any order.
        pairs: Vec<[usize; 2]>,
    },
    RestorePairs {
        pairs: Vec<[usize; 2]>,
    },
    /// Moves an observation, or adds it where the image had none of the point, which takes part from then on.
    Measure {
        point: PointSource,
        image: usize,
        /// Column and row in px.
        x_px: f64,
        y_px: f64,
        #[serde(default)]
        by: MeasuredBy,
    },
    /// A new tie point, seen in two or more images: [`PointSource::Manual`] with the number of such edits before.
    AddPoint {
        observations: Vec<HandMeasurement>,
    },
    /// A new surveyed point, which edits after it measure: [`PointSource::GroundControl`] with the number of those that the block was found with, and of such
    /// edits before. Where the block does not lie in the system of its coordinates, three or more that place it, each measured in two images or more, bring
    /// it there; until then these points take no part.
    AddControl {
        /// No other surveyed point has it.
        name: String,
        /// As a table of ground control points has them: in the coordinate reference system of the block, where one was chosen.
        position: [f64; 3],
        /// Standard errors of the place and of the height, above 0; absent: those of the settings.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        standard_errors: Option<[f64; 2]>,
        /// Standard error of a coordinate of its image measurements in px; absent: that of the settings.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        sigma_px: Option<f64>,
        #[serde(default, rename = "use")]
        role: ControlRole,
        /// The EPSG code of the system of its coordinates, of a place of an orthophoto whose code is known.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        epsg: Option<u16>,
        /// What is to be said of the coordinates of a place of an orthophoto, whose heights may count from elsewhere than those of the block.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        remarks: Vec<Remark>,
    },
    /// Whether a surveyed point places the block, checks it, or takes no part (absent).
    SetUse {
        /// Index of the surveyed point among those that the table does not say `off` of, and behind them those that were added.
        point: usize,
        #[serde(default, rename = "use")]
        role: Option<ControlRole>,
    },
}

/// The observation of a point in an image.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct PointImage {
    pub point: PointSource,
    pub image: usize,
}

/// A place in an image that was measured.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct HandMeasurement {
    pub image: usize,
    /// Column and row in px.
    pub x_px: f64,
    pub y_px: f64,
    #[serde(default)]
    pub by: MeasuredBy,
}

/// How a place was measured, which says what it weighs.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum MeasuredBy {
    /// Pointed at: as precise as an image measurement of a control point.
    #[default]
    Hand,
    /// Matched to another image from a place that was pointed at: as precise as a tie point.
    LeastSquares,
}
