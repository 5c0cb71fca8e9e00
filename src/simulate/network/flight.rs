//! What the user chooses of a simulated block.

use crate::Error;
use crate::catalogue::{choices, options, refuse};

choices! {
    /// How the images of a simulated block look down.
    pub enum NetworkKind {
        /// One camera that looks straight down, neighbouring strips flown in opposite directions.
        Nadir = "nadir",
        /// Five cameras at each station: one of the given focal length down, four of 65/85 of it at 45° to the four sides.
        Oblique = "oblique",
        /// The strips once, and once more across them at 1.3 times the height.
        TwoHeights = "two_heights",
    }
}

options! {
    /// A block to be simulated. The ground's mean height is 0.
    pub struct NetworkFlight in "network" {
        section "Network";

        /// How the images look down.
        kind: NetworkKind = NetworkKind::Nadir, "Kind";

        /// The number of parallel flight lines.
        strips: usize = 5, "Strips", 1..=1000;

        /// The number of exposures per strip.
        stations: usize = 6, "Stations", 1..=1000;

        /// The height above the mean ground.
        flying_height_m: f64 = 100.0, "Flying height", in "m", 1..=100000;

        /// The range of the ground's heights, up to half the flying height.
        relief_m: f64 = 15.0, "Relief", in "m", 0..=50000;

        /// The columns of an image, across the strip.
        width_px: usize = 4000, "Columns", in "px", 16..=100000;

        /// The rows of an image, along the strip.
        height_px: usize = 3000, "Rows", in "px", 16..=100000;

        /// The focal length of the camera that looks down.
        focal_px: f64 = 3600.0, "Focal length", in "px", 10..=1e6;

        /// The share of an image that the next one of the strip shows.
        end_lap: f64 = 0.7, "End lap", 0..=0.95;

        /// The share of an image that the next strip shows.
        side_lap: f64 = 0.5, "Side lap", 0..=0.95;

        /// The ground points in the area of one image.
        points_per_image: f64 = 60.0, "Points per image", 1..=1e5;

        /// The standard deviation of an image coordinate.
        noise_px: f64 = 0.4, "Noise", in "px", 0..=100;

        /// The share of the observations that are gross errors.
        gross_share: f64 = 0.0, "Gross errors", 0..=0.9;

        /// The largest gross error in each coordinate.
        gross_px: f64 = 60.0, "Size of gross errors", in "px", 0..=10000;

        /// The standard deviation of a coordinate of a GNSS position; 0: no positions.
        gnss_sigma_m: f64 = 0.0, "GNSS noise", in "m", 0..=1000;

        /// The number of control points, spread over the block.
        control_points: usize = 0, "Control points", 0..=100000;

        /// The standard deviation of a coordinate of a control point.
        control_sigma_m: f64 = 0.02, "Control noise", in "m", 1e-6..=1000;

        /// The standard deviation of the approximate positions of images and points, up to a fifth of the flying height; angles err by as much
        /// at the distance of the ground.
        approximate_m: f64 = 0.5, "Approximations", in "m", 0..=20000;

        /// The start of the random numbers: the same seed gives the same block.
        seed: u32 = 1, "Seed", 0..=4294967295.0;

        beside;

        /// Distortion of all cameras.
        radial: [f64; 3] = [0.0; 3];
        tangential: [f64; 2] = [0.0; 2];
    }
}

impl NetworkFlight {
    /// Rejects values outside their ranges.
    pub(super) fn check(&self) -> Result<(), Error> {
        self.check_ranges()?;
        for (field, value, most) in [("network.relief_m", self.relief_m, 0.5), ("network.approximate_m", self.approximate_m, 0.2)] {
            let most = most * self.flying_height_m;
            if !(value <= most) {
                return Err(refuse(field, value, format!("0 to {most}")));
            }
        }
        let lens = self.radial.iter().chain(&self.tangential);
        match lens.clone().find(|k| !(k.abs() <= 1.0)) {
            Some(wrong) => Err(refuse("network.radial, network.tangential", wrong, "numbers from -1 to 1")),
            None => Ok(()),
        }
    }
}
