//! What the user chooses of the moments.

use crate::catalogue::{choices, options};
use serde::{Deserialize, Serialize};

choices! {
    /// How grey values I become the weights g of the moments.
    pub enum Brightness {
        /// `(I - min) / Σ(I - min)`: neither gain nor offset matters.
        Sum = "sum",
        /// `(I - min) / (max - min)`.
        Range = "range",
        /// `I / 255`.
        Unit = "unit" ("grey / 255"),
    }
}

choices! {
    /// The window's outline.
    pub enum WindowShape {
        Square = "square",
        /// The pixels whose centres lie within half the side of the window's centre: for images rotated against each other.
        Circle = "circle",
    }
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

options! {
    /// Options of the window around a point.
    pub struct WindowOptions in "window" {
        section "Moments";

        /// The side of the window whose moments describe a point (paper: 11): larger windows are more distinct and tolerate less relief.
        side: usize = 11, "Moment window", in "px", odd 3..=63, acts "matching.strategy is moments, invariants", named "window";

        /// A circular window does not change when the image is rotated; a square one does.
        shape: WindowShape = WindowShape::Square, "Window shape", acts "matching.strategy is moments, invariants";

        /// How grey values become weights: sum and range do not change with gain and offset; unit is grey / 255.
        brightness: Brightness = Brightness::Sum, "Brightness", acts "matching.strategy is moments, invariants";
    }
}
