//! What the user chooses of multi-scale points.

use crate::Error;
use crate::parameters::check;
use serde::{Deserialize, Serialize};

/// How a point's position is found between the pixels.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum PointPosition {
    /// The maximum of a quadratic through responses half a pixel apart, at the point's own scale.
    Quadratic,
    /// The corner or circle's centre that fits the gradients best by least squares (Förstner); the scale by the quadratic.
    Forstner,
}

/// Options of [`multiscale_points`](crate::multiscale_points).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct MultiscaleOptions {
    /// Most points.
    pub number: usize,
    /// Levels of an octave of the pyramid, in which the scale doubles.
    pub levels: usize,
    /// Least contrast of a point, the root of its response, in grey values.
    pub contrast: f64,
    /// Least roundness q of the Förstner tensor at a point, 0..1; the determinant of the Hessian refuses most edges by itself.
    pub roundness: f64,
    /// Cells on the image's longer side of the grid over which half of the points are distributed equally; 1 chooses the most distinct.
    pub cells: usize,
    pub position: PointPosition,
}

impl Default for MultiscaleOptions {
    fn default() -> Self {
        Self { number: 10_000, levels: 3, contrast: 0.5, roundness: 0.0, cells: 16, position: PointPosition::Quadratic }
    }
}

impl MultiscaleOptions {
    pub(crate) fn check(&self) -> Result<(), Error> {
        check("multiscale.number", self.number as f64)?;
        check("multiscale.levels", self.levels as f64)?;
        check("multiscale.contrast", self.contrast)?;
        check("multiscale.roundness", self.roundness)?;
        check("multiscale.cells", self.cells as f64)
    }
}
