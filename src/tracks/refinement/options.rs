//! What the user chooses of the refinement of rays.

use crate::Error;
use crate::parameters::check;
use serde::{Deserialize, Serialize};

/// How the rays of chosen points are refined.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum RefinementMethod {
    /// Rays stay where their features were found.
    None,
    /// Least squares matching of each ray's window to that of a reference ray.
    LeastSquares,
}

/// Whether and how rays are refined before the block is oriented.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct RefinementOptions {
    pub method: RefinementMethod,
    /// Rays an image that are refined at least; the block is oriented by these.
    pub per_image: usize,
    /// Side of the windows in px, odd, of the image or of a reduced one by the scale of the point.
    pub window: usize,
    /// How far a ray may move, in multiples of its scale.
    pub farthest: f64,
    /// Correlation of the matched windows at least, 0..1.
    pub least_correlation: f64,
}

impl Default for RefinementOptions {
    fn default() -> Self {
        Self { method: RefinementMethod::None, per_image: 200, window: 17, farthest: 1.0, least_correlation: 0.8 }
    }
}

impl RefinementOptions {
    /// Refuses values outside their ranges.
    pub(crate) fn check(&self) -> Result<(), Error> {
        check("refinement.per_image", self.per_image as f64)?;
        check("refinement.window", self.window as f64)?;
        check("refinement.farthest", self.farthest)?;
        check("refinement.least_correlation", self.least_correlation)
    }
}
