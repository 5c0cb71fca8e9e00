//! What the user chooses of the moments.

use super::kernel::Kernel;
use crate::Error;
use crate::parameters::check;
use serde::{Deserialize, Serialize};

/// How grey values I become the weights g of the moments.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Brightness {
    /// `(I - min) / Σ(I - min)`: neither gain nor offset matters.
    Sum,
    /// `(I - min) / (max - min)`.
    Range,
    /// `I / 255`.
    Unit,
}

/// The window's outline.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum WindowShape {
    Square,
    /// The pixels whose centres lie within half the side of the window's centre: for images rotated against each other.
    Circle,
}

/// What two points are compared by.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Measure {
    /// The seven normalised moments (eq. 16).
    Dm,
    /// The seven invariants (eq. 15).
    Di,
}

/// Options of the window around a point.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct WindowOptions {
    /// Side in px, odd.
    pub side: usize,
    pub shape: WindowShape,
    pub brightness: Brightness,
}

impl Default for WindowOptions {
    fn default() -> Self {
        Self { side: 11, shape: WindowShape::Square, brightness: Brightness::Sum }
    }
}

impl WindowOptions {
    /// Whether each pixel of the window lies within its outline, row by row.
    ///
    /// # Errors
    /// [`Error::InvalidOption`] for the side.
    pub fn mask(&self) -> Result<Vec<bool>, Error> {
        self.check()?;
        Ok(Kernel::new(self.side, self.shape).mask())
    }

    /// Refuses a side outside its range.
    pub(crate) fn check(&self) -> Result<(), Error> {
        check("window.side", self.side as f64)
    }
}
