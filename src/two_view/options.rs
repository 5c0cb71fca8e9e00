//! What the user chooses of the geometry of two views.

use super::scale::NoiseLimits;
use crate::catalogue::{FOCAL_PX, check_values, options};
use crate::error::refuse;
use crate::{Error, Input, Location, Refusal, Side};
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

options! {
    /// Options of [`two_view`](crate::two_view).
    pub struct TwoViewOptions in "geometry" {
        section "Geometry of the two views";

        /// The maximum distance of a good match from the geometry: higher keeps more, less exact matches.
        threshold_px: Option<f64> = None, "Threshold", in "px", 0.001..=100, absent "from the precision of the matches",
            acts "matching.strategy is gradient";

        /// The upper limit of the threshold that follows from the matches: raise it for coarse matches.
        largest_threshold_px: f64 = 4.0, "Maximum threshold", in "px", 0.01..=100,
            acts "matching.strategy is gradient and geometry.threshold_px is absent";

        /// The probability of drawing at least one sample of good matches only: higher draws more samples.
        confidence: f64 = 0.999, "Confidence", 0.5..=0.999999, acts "matching.strategy is gradient";

        /// The maximum number of samples: more take longer where few matches are good.
        max_samples: u32 = 10_000, "Maximum samples", 1..=1000000, acts "matching.strategy is gradient";

        /// The start of the random numbers: the same seed gives the same result.
        seed: u32 = 1, "Seed", 0..=4294967295.0, acts "matching.strategy is gradient", named "geometry-seed";

        beside;

        /// The cameras; absent: nothing is known of them. Both or neither.
        left: Option<Pinhole> = None;
        right: Option<Pinhole> = None;
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
        self.check_ranges()?;
        for (camera, side) in [(self.left, Side::Left), (self.right, Side::Right)] {
            let Some(Pinhole { focal_px, principal_px }) = camera else { continue };
            let place = || Location::Geometry { side };
            check_values(Input::CameraFocalLength, focal_px.as_slice(), FOCAL_PX, place)?;
            check_values(Input::CameraPrincipalPoint, &principal_px, -1e6..=1e6, place)?;
        }
        self.cameras().map(|_| ())
    }

    pub(super) fn cameras(&self) -> Result<Cameras, Error> {
        match (self.left, self.right) {
            (None, None) => Ok(Cameras::Unknown),
            (Some(left), Some(right)) => match (left.focal_px, right.focal_px) {
                (None, None) => Ok(Cameras::Principal([left.principal_px, right.principal_px])),
                (Some(a), Some(b)) => Ok(Cameras::Known([(a, left.principal_px), (b, right.principal_px)])),
                _ => refuse(Refusal::OneFocalLength),
            },
            _ => refuse(Refusal::OneCamera),
        }
    }

    /// The limits of noise in units of `px`.
    pub(super) fn limits(&self, px: f64) -> NoiseLimits {
        let largest_threshold = self.threshold_px.unwrap_or(self.largest_threshold_px) / px;
        NoiseLimits { largest_threshold, fixed: self.threshold_px.is_some() }
    }
}
