//! What is flown for a block, seen and matched.

use crate::catalogue::{choices, options};
use crate::simulate::mounting::{Mounting, NADIR_MM, five, nadir};
use serde::{Deserialize, Serialize};

choices! {
    /// How the photos of a block look at the ground.
    pub enum BlockView {
        /// Straight down.
        Nadir = "nadir",
        /// Five cameras per exposure: one down with 85 mm, four tilted by 45° forwards, backwards, left and right with 65 mm.
        Oblique = "oblique",
        /// Straight down, every other strip at 1.5 times the height; a network's strips once more across at 1.3 times the height.
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

        section "Networks of rays";

        /// The ground points in the area of one image.
        points_per_image: f64 = 60.0, "Points per image", 1..=1e5;

        /// The share of the observations that are gross errors.
        gross_share: f64 = 0.0, "Gross errors", 0..=0.9;

        /// The largest gross error in each coordinate.
        gross_px: f64 = 60.0, "Size of gross errors", in "px", 0..=10000;

        /// The number of control points, spread over the block.
        control_points: usize = 0, "Control points", 0..=100000;

        /// The standard deviation of a coordinate of a control point.
        control_sigma_m: f64 = 0.02, "Control noise", in "m", 1e-6..=1000;

        /// The standard deviation of the approximate positions of images and points, up to a fifth of the flying height; angles err by as much
        /// at the distance of the ground.
        approximate_m: f64 = 0.5, "Approximations", in "m", 0..=20000;

        beside;

        /// Distortion of all cameras of a network.
        radial: [f64; 3] = [0.0; 3];
        tangential: [f64; 2] = [0.0; 2];
    }
}

/// Flights of blocks that are ready made.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum BlockPreset {
    /// Features and matches of large photos.
    Features,
    /// Photos of a size that is soon rendered, by a wide angle: block geometry is strong where bases are long against heights.
    Photos,
    /// The same of half the size, for a page.
    SmallPhotos,
    /// A network of rays of a low flight by a wide angle, without GNSS positions.
    Network,
}

impl BlockPreset {
    /// The flight.
    pub fn flight(self) -> BlockFlight {
        let features = BlockFlight::default();
        match self {
            Self::Features => features,
            Self::Photos => BlockFlight { width_px: 1600, height_px: 1200, pixel_mm: 0.045, relief_m: 40.0, ..features },
            Self::SmallPhotos => BlockFlight { width_px: 800, height_px: 600, pixel_mm: 0.09, ..Self::Photos.flight() },
            Self::Network => BlockFlight {
                pixel_mm: NADIR_MM / 3600.0,
                flying_height_m: 100.0,
                relief_m: 15.0,
                forward_overlap: 0.7,
                receiver_m: 0.0,
                noise_px: 0.4,
                ..features
            },
        }
    }
}

impl BlockFlight {
    /// Principal distance in px of the camera that looks down.
    pub fn focal_px(&self) -> f64 {
        NADIR_MM / self.pixel_mm
    }

    /// The cameras at each exposure.
    pub(in crate::simulate) fn mountings(&self) -> Vec<Mounting> {
        if self.view == BlockView::Oblique { five().to_vec() } else { vec![nadir()] }
    }

    /// The parameters on which photos depend.
    pub fn photo_parameters() -> impl Iterator<Item = &'static crate::Parameter> {
        Self::PARAMETERS.iter().filter(|p| p.section == "Flight")
    }
}
