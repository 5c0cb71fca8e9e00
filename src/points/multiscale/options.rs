//! What the user chooses of multi-scale points.

use crate::catalogue::{choices, options};

choices! {
    /// How a point's position is found between the pixels.
    pub enum PointPosition {
        /// The maximum of a quadratic through responses half a pixel apart, at the point's own scale.
        Quadratic = "quadratic",
        /// The corner or circle's centre that fits the gradients best by least squares (Förstner); the scale by the quadratic.
        Forstner = "forstner" ("Förstner"),
    }
}

options! {
    /// Options of [`multiscale_points`](crate::multiscale_points).
    pub struct MultiscaleOptions in "multiscale" {
        section "Points of many scales";

        /// The maximum number of points per image: more take longer; they are distributed so that dull regions keep their share.
        number: usize = 10_000, "Number of points", 1..=1000000, acts "points.operator is multiscale";

        /// The steps of the pyramid while the scale doubles: more find points of more exact scales and take longer.
        levels: usize = 3, "Levels per octave", 1..=8, acts "points.operator is multiscale or matching.strategy is gradient";

        /// A lower minimum contrast of a point to its surroundings finds more, noisier points.
        contrast: f64 = 0.5, "Minimum contrast", in "grey values", 0..=255, acts "points.operator is multiscale";

        /// A higher minimum keeps fewer, rounder points at the point's scale: 1 is a corner or spot, 0 an edge.
        roundness: f64 = 0.0, "Minimum roundness q", 0..=1, acts "points.operator is multiscale", named "multiscale-roundness";

        /// The cells on the longer side of the image, over which half of the points are distributed equally: more spread the points more
        /// evenly; 1 keeps the best of the whole image.
        cells: usize = 16, "Cells", 1..=256, acts "points.operator is multiscale";

        /// The maximum of a quadratic through the responses, or the corner or centre of a circle by least squares (Förstner).
        position: PointPosition = PointPosition::Quadratic, "Position", acts "points.operator is multiscale";
    }
}
