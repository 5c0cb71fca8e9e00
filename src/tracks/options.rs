//! What the user chooses of a block: how points are joined, and how many are kept.

use crate::catalogue::{choices, options};

choices! {
    /// What is done with matches that would give a point two observations in one image.
    pub enum Conflicts {
        /// The least probable matches between the two observations are cut: one point becomes two or more.
        Resolve = "resolve",
        /// The whole point is dropped.
        Drop = "drop",
    }
}

options! {
    /// How matches are joined to tie points.
    pub struct BlockOptions in "block" {
        section "Tie points";

        /// What is done where matches give a point two observations in one image: the least probable matches are cut, or the point is dropped.
        conflicts: Conflicts = Conflicts::Resolve, "Conflicts";

        /// The expected share of points with an observation that does not belong to them: matches that third images confirm too little are
        /// ignored, and more gives more points of two images where the overlap is small.
        impure: f64 = 0.002, "Impure points", 0..=0.5;

        /// The minimum number of images that show a point: more leave fewer, more certain points.
        min_rays: usize = 2, "Minimum rays", 2..=100;

        /// The expected share of right matches where no third image decides, as in a block of two images: higher keeps more points.
        expected_right: f64 = 0.998, "Expected right matches", 0.01..=0.9999;
    }
}

options! {
    /// How many points are kept, and where.
    pub struct SelectOptions in "selection" {
        section "Selection of points";

        /// The number of its points that an image keeps, spread evenly; its connections may need more.
        per_image: usize = 40, "Points per image", 1..=10000;

        /// The number of common points that two overlapping images keep, or all where they have fewer.
        per_connection: usize = 3, "Points per connection", 0..=1000;
    }
}
