//! The geometry of two views as it is given.

use crate::message::messages;
use crate::{Cause, Error};
use serde::{Deserialize, Serialize};

/// What relates the views; matrices by rows, of homogeneous positions in px and of norm 1.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum TwoViewModel {
    /// The relative orientation of calibrated views.
    Calibrated {
        /// qᵀ F p = 0 for a left position p and its right position q.
        fundamental: [[f64; 3]; 3],
        /// From the left photo's system (x right, y up, z against the line of sight) to the right photo's.
        rotation: [[f64; 3]; 3],
        /// Direction of the right camera in the left photo's system, of length 1.
        base: [f64; 3],
    },
    /// The epipolar geometry of views whose cameras are not known.
    Fundamental {
        /// qᵀ F p = 0 for a left position p and its right position q.
        fundamental: [[f64; 3]; 3],
    },
    /// The map of a plane from the left to the right image; all that is determined there without known cameras.
    Homography { homography: [[f64; 3]; 3] },
    /// There is no base.
    Rotation {
        homography: [[f64; 3]; 3],
        /// From the left photo's system to the right photo's.
        rotation: [[f64; 3]; 3],
    },
}

impl TwoViewModel {
    /// The name of the variant, as in JSON.
    pub(crate) fn kind(&self) -> &'static str {
        match self {
            Self::Calibrated { .. } => "calibrated",
            Self::Fundamental { .. } => "fundamental",
            Self::Homography { .. } => "homography",
            Self::Rotation { .. } => "rotation",
        }
    }
}

messages! {
    /// Why the general geometry is not determined.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(rename_all = "kebab-case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum Degeneracy as "degeneracy" {
        /// All points lie in a plane, or nearly so. Calibrated views have an orientation all the same, if a weaker one. Of unknown cameras
        /// it may be a rotation alone too.
        Plane,
        /// There is no base.
        PureRotation,
    }
}

messages! {
    /// Why matches give no geometry of two views.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum NoGeometry as "no_geometry" {
        /// Fewer different matches than are needed.
        TooFewMatches { matches: usize, needed: usize },
        /// No more matches agree on one geometry than would by chance.
        Chance { agreeing: usize, matches: usize },
    }
}

impl NoGeometry {
    /// The reason that an error of [`two_view`](crate::two_view) states; other errors are given back.
    ///
    /// # Errors
    /// The error itself.
    pub fn of(error: Error) -> Result<Self, Error> {
        match error {
            Error::TooFew { got, needed, .. } => Ok(Self::TooFewMatches { matches: got, needed }),
            Error::Degenerate { cause: Cause::Chance { agreeing, matches }, .. } => Ok(Self::Chance { agreeing, matches }),
            other => Err(other),
        }
    }
}

/// A focal length that was estimated from the matches.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct FocalEstimate {
    /// Of both cameras, in px.
    pub focal_px: f64,
    /// Its standard error in px, from the precision of the matches and from what an error of 1 % of half the diagonal of what is matched in either
    /// coordinate of the principal points, and in the distortion of the corners, would do.
    pub standard_error_px: f64,
}

/// The geometry of two views: [`two_view`](crate::two_view).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct TwoView {
    pub model: TwoViewModel,
    /// The matches that agree with the model, in ascending order; left out where all given ones do.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub inliers: Vec<usize>,
    /// The largest distance of these from the model, in px.
    pub threshold_px: f64,
    /// Standard error of a coordinate of these, in px.
    pub sigma_px: f64,
    pub degenerate: Option<Degeneracy>,
    /// Of a plane or a rotation the map from the left to the right image, in px.
    pub homography: Option<[[f64; 3]; 3]>,
    pub focal: Option<FocalEstimate>,
}
