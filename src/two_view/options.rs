//! What the user chooses of the geometry of two views.

use super::scale::NoiseLimits;
use crate::Error;
use crate::parameters::check;
use serde::{Deserialize, Serialize};

/// A camera without distortion.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Pinhole {
    /// Focal length in px; absent: unknown, the same in both images, and estimated where the matches determine it.
    #[serde(default)]
    pub focal_px: Option<f64>,
    /// Principal point in px.
    pub principal_px: [f64; 2],
}

/// Options of [`two_view`](crate::two_view).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct TwoViewOptions {
    /// The cameras; absent: nothing is known of them. Both or neither.
    pub left: Option<Pinhole>,
    pub right: Option<Pinhole>,
    /// Largest distance of a good match from the geometry in px; absent: it follows from the precision of the matches.
    pub threshold_px: Option<f64>,
    /// Bound of the threshold that follows from the matches, in px.
    pub largest_threshold_px: f64,
    /// Probability of drawing at least one sample of good matches only.
    pub confidence: f64,
    /// Most samples that are drawn.
    pub max_samples: u32,
    /// Start of the random numbers.
    pub seed: u32,
}

impl Default for TwoViewOptions {
    fn default() -> Self {
        Self { left: None, right: None, threshold_px: None, largest_threshold_px: 4.0, confidence: 0.999, max_samples: 10_000, seed: 1 }
    }
}

/// What is known of the cameras.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Cameras {
    Unknown,
    /// Principal points alone.
    Principal([[f64; 2]; 2]),
    /// Focal lengths and principal points.
    Known([(f64, [f64; 2]); 2]),
}

impl Cameras {
    /// The principal points, where they are all that is known.
    pub fn principal(&self) -> Option<[[f64; 2]; 2]> {
        if let Self::Principal(principal) = self { Some(*principal) } else { None }
    }
}

impl TwoViewOptions {
    /// Refuses values outside their ranges.
    pub(crate) fn check(&self) -> Result<(), Error> {
        if let Some(threshold) = self.threshold_px {
            check("geometry.threshold_px", threshold)?;
        }
        check("geometry.largest_threshold_px", self.largest_threshold_px)?;
        check("geometry.confidence", self.confidence)?;
        check("geometry.max_samples", f64::from(self.max_samples))?;
        for camera in [self.left, self.right].into_iter().flatten() {
            camera.focal_px.map_or(Ok(()), |focal| check("geometry.focal_px", focal))?;
            camera.principal_px.iter().try_for_each(|v| check("geometry.principal_px", *v))?;
        }
        self.cameras().map(|_| ())
    }

    pub(super) fn cameras(&self) -> Result<Cameras, Error> {
        let one = |what: &str| Error::InvalidInput { what: "the cameras", got: what.into(), allowed: "both or neither".into() };
        match (self.left, self.right) {
            (None, None) => Ok(Cameras::Unknown),
            (Some(left), Some(right)) => match (left.focal_px, right.focal_px) {
                (None, None) => Ok(Cameras::Principal([left.principal_px, right.principal_px])),
                (Some(a), Some(b)) => Ok(Cameras::Known([(a, left.principal_px), (b, right.principal_px)])),
                _ => Err(one("one focal length")),
            },
            _ => Err(one("one camera")),
        }
    }

    /// The limits of noise in units of `px`.
    pub(super) fn limits(&self, px: f64) -> NoiseLimits {
        let largest_threshold = self.threshold_px.unwrap_or(self.largest_threshold_px) / px;
        NoiseLimits { largest_threshold, fixed: self.threshold_px.is_some() }
    }
}
