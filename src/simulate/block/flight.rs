//! What is flown for a block, seen and matched.

use crate::catalogue::{choices, options};

choices! {
    /// How the photos of a block look at the ground.
    pub enum BlockView {
        /// Straight down.
        Nadir = "nadir",
        /// Five cameras per exposure: one down with 85 mm, four tilted by 45° forwards, backwards, left and right with 65 mm.
        Oblique = "oblique",
        /// Straight down, every other strip at 1.5 times the height.
        TwoHeights = "two-heights",
    }
}

options! {
    /// What is flown, seen and matched.
    pub struct BlockFlight in "block_flight" {
        section "Flight";

        /// Straight down; one camera down and four tilted by 45°; or straight down with every other strip at 1.5 times the height.
        view: BlockView = BlockView::Nadir, "View";

        /// The number of strips that are flown side by side.
        strips: usize = 5, "Strips", 1..=1000;

        /// The number of exposures per strip, each by one camera, or by five in an oblique block.
        exposures: usize = 6, "Exposures per strip", 1..=1000;

        /// The overlap of photos that follow one another in a strip.
        forward_overlap: f64 = 0.75, "Forward overlap", 0..=0.95;

        /// The overlap of neighbouring strips.
        side_overlap: f64 = 0.5, "Side overlap", 0..=0.95;

        /// The columns of a photo, across the flight.
        width_px: u32 = 4000, "Columns", in "px", 16..=100000;

        /// The rows of a photo, along the flight.
        height_px: u32 = 3000, "Rows", in "px", 16..=100000;

        /// The side of a pixel, with principal distances of 85 mm and 65 mm: larger pixels show more ground.
        pixel_mm: f64 = 0.009, "Pixel", in "mm", 0.0005..=1;

        /// The height above the mean ground: a larger one makes the scale smaller.
        flying_height_m: f64 = 800.0, "Flying height", in "m", 10..=10000;

        /// The range of the ground's heights.
        relief_m: f64 = 60.0, "Relief", in "m", 0..=1000;

        /// The standard deviation of a coordinate of a GNSS position.
        receiver_m: f64 = 1.0, "GNSS noise", in "m", 0..=100;

        /// The buildings of a photographed scene; fewer stand where there are fewer lots.
        buildings: f64 = 2000.0, "Buildings", in "km⁻²", 0..=20000;

        /// The trees of a photographed scene, where gardens are left for them.
        trees: f64 = 2500.0, "Trees", in "km⁻²", 0..=20000;

        /// Everything random follows from it: the same seed gives the same block.
        seed: u32 = 1, "Seed", 0..=4294967295.0;

        section "Features without photos";

        /// The number of features per image, on average.
        features: usize = 2000, "Features per image", 1..=100000;

        /// The share of the features that no other image shows.
        clutter: f64 = 0.3, "Lone features", 0..=0.9;

        /// The probability that a feature which two images show is matched between them.
        matched: f64 = 0.8, "Matched", 0..=1;

        /// The share of the matches that join different places.
        wrong: f64 = 0.05, "Wrong matches", 0..=1;

        /// The share of the wrong matches that join the same two places in every pair of images.
        repeated: f64 = 0.05, "Repeated structures", 0..=1;

        /// The standard deviation of a feature's coordinate.
        noise_px: f64 = 0.3, "Noise", in "px", 0..=10;
    }
}

impl BlockFlight {
    /// The parameters on which photos depend.
    pub fn photo_parameters() -> impl Iterator<Item = &'static crate::Parameter> {
        Self::PARAMETERS.iter().filter(|p| p.section == "Flight")
    }
}
