//! What the user chooses of gradient descriptors.

use crate::catalogue::options;
use crate::{Group, MultiscaleOptions, PartlyGiven};
use serde::{Deserialize, Serialize};

options! {
    /// Options of [`gradient_features`](crate::gradient_features).
    pub struct GradientOptions in "gradient" {
        section "Gradient descriptors";

        /// No dominant direction is sought: better and faster where the images are not rotated against each other.
        upright: bool = false, "Upright", acts "matching.strategy is gradient";

        /// A point with several dominant directions gets a descriptor for each, up to this many: more match more points and take longer.
        orientations: usize = 1, "Maximum directions", 1..=4, acts "matching.strategy is gradient and gradient.upright is false";

        /// The side of one of the 4 x 4 cells in scales of the point: larger cells tell more points apart and tolerate less relief.
        cell: f64 = 5.0, "Cell", in "scales", 0.5..=20, acts "matching.strategy is gradient", named "gradient-cell";

        /// Square roots of the histograms are compared, so that strong gradients do not outweigh the others.
        roots: bool = true, "Square roots", acts "matching.strategy is gradient";
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

impl PartlyGiven for FeatureOptions {
    const GROUPS: &'static [Group] = &[
        Group { path: "multiscale", parameters: MultiscaleOptions::PARAMETERS },
        Group { path: "gradient", parameters: GradientOptions::PARAMETERS },
    ];
}
