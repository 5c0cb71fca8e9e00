//! What the user chooses of the refinement of observations.

use crate::catalogue::{choices, options};

choices! {
    /// How the observations of chosen points are refined.
    pub enum RefinementMethod {
        /// Observations stay where their features were found.
        None = "none",
        /// Least squares matching of each observation's window to that of a reference observation.
        LeastSquares = "least-squares" ("least squares"),
    }
}

options! {
    /// Whether and how observations are refined before the block is oriented.
    pub struct RefinementOptions in "refinement" {
        section "Refinement of observations";

        /// Whether the observations of chosen points are moved to where their grey values fit those of a reference observation best.
        method: RefinementMethod = RefinementMethod::LeastSquares, "Refinement", named "refine";

        /// The number of observations per image that are refined and orient the block, where there are as many: more make it more stable and
        /// take longer.
        per_image: usize = 200, "Refined observations per image", 10..=10000, acts "refinement.method is least-squares",
            named "refinement-per-image";

        /// The side of the window that is matched, in the image or, for points of large scales, in a reduced one: larger ones are more exact on
        /// even ground, and wrong where it is broken.
        window: usize = 17, "Refinement window", in "px", odd 9..=41, acts "refinement.method is least-squares", named "refinement-window";

        /// The maximum move of an observation in scales of its point; one that would go farther stays in place.
        farthest: f64 = 1.0, "Maximum move", in "scales", 0.1..=4, acts "refinement.method is least-squares", named "refinement-farthest";

        /// The minimum correlation of a window with that of the reference: higher leaves more observations in place.
        least_correlation: f64 = 0.8, "Minimum correlation", 0..=1, acts "refinement.method is least-squares",
            named "refinement-correlation";
    }
}
