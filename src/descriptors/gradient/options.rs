//! What the user chooses of gradient descriptors.

use crate::parameters::check;
use crate::{Error, MultiscaleOptions};
use serde::{Deserialize, Serialize};

/// Options of [`gradient_features`](crate::gradient_features).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct GradientOptions {
    /// The grid's rows lie along the image's: for images that are not rotated against each other.
    pub upright: bool,
    /// Most dominant directions of a point, each of which gets its own descriptor.
    pub orientations: usize,
    /// Side of one of the 4 x 4 cells, in scales of the point.
    pub cell: f64,
    /// Square roots of the histogram are compared.
    pub roots: bool,
}

impl Default for GradientOptions {
    fn default() -> Self {
        Self { upright: false, orientations: 1, cell: 5.0, roots: true }
    }
}

impl GradientOptions {
    pub(crate) fn check(&self) -> Result<(), Error> {
        check("gradient.orientations", self.orientations as f64)?;
        check("gradient.cell", self.cell)
    }
}

/// Options of [`features`](crate::features).
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct FeatureOptions {
    pub multiscale: MultiscaleOptions,
    pub gradient: GradientOptions,
}
