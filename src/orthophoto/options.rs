//! What the user chooses of placing images on an orthophoto.

use crate::catalogue::options;

options! {
    /// Options of [`place_image`](crate::place_image).
    pub struct PlacingOptions in "placing" {
        section "Placing on an orthophoto";

        /// The place near which the image was taken, in the system of the orthophoto: X; the search goes no farther than the radius.
        near_x: Option<f64> = None, "Near X", in "m", -1e8..=1e8, absent "the whole orthophoto";

        /// The same: Y.
        near_y: Option<f64> = None, "Near Y", in "m", -1e8..=1e8, absent "the whole orthophoto";

        /// The distance from that place within which the image may show the ground.
        within_m: f64 = 500.0, "Radius", in "m", 1.0..=1e6;

        /// The maximum number of points of the image that are sought on the orthophoto: more find harder places and take longer.
        points: usize = 10000, "Number of points", 500..=20000;

        /// The standard error of a place of the orthophoto, in its px: a larger one enlarges the standard errors of the image.
        place_sigma_px: f64 = 0.3, "Standard error of a place", in "px", 0.01..=100;

        /// The standard error of a height of the ground, by which all heights of a model may be wrong together: a larger one enlarges the standard errors of the image, and weakens links far from the nadir.
        height_sigma_m: Option<f64> = None, "Standard error of a height", in "m", 0.001..=1000, absent "one pixel of the orthophoto with a height model, ten without";

        /// The height of the zero of the heights of the ground above the ellipsoid of WGS 84, where their file does not say that they count from the ellipsoid: that of the geoid for heights above sea level, 0 for ellipsoidal ones.
        /// The height of a precise GNSS position, which is above the ellipsoid, is then compared with that of the image.
        heights_geoid_m: Option<f64> = None, "Geoid of the heights", in "m", -200..=200, absent "not known: precise GNSS positions are taken to count from the zero of the heights, unless the file of the heights says another one";

        /// The share of the links that takes no part and checks the orientation instead.
        check_share: f64 = 0.2, "Share of check links", 0..=0.5;

        /// The start of the random numbers: the same seed gives the same result.
        seed: u32 = 1, "Seed", 0..=4294967295.0;
    }
}
