//! The y-parallax that matches share over the image: 1, x, y, xy, x², y².

use super::coplanarity::Ray;

pub const MODES: usize = 6;

/// Standard deviations of the modes of the y-parallax that matches share, in standard errors of a coordinate: walls, roofs and the shape of a
/// point's surroundings give matches of one part of the image an error of the same sign, and from the middle of the overlap to its corners the two
/// photos see more and more different walls. They are hardly smaller for matches by least squares, whose standard errors are. Set by the errors
/// of 96 flights of the four presets by all strategies (maximum likelihood), beside those of their fiducial marks.
pub const SHARED_BY_FITS: [f64; MODES] = [0.6, 0.35, 0.05, 0.25, 0.3, 0.07];
pub const SHARED_BY_FEATURES: [f64; MODES] = [0.28, 0.13, 0.03, 0.11, 0.1, 0.08];

/// Where the matches lie in the left photo.
#[derive(Clone, Copy)]
pub struct Extent {
    middle: [f64; 2],
    /// Of the longer side.
    half: f64,
}

impl Extent {
    pub fn of(rays: &[Ray]) -> Self {
        let ranges = [0, 1].map(|axis| {
            let ends = (f64::INFINITY, f64::NEG_INFINITY);
            rays.iter().fold(ends, |(least, most), ray| (least.min(ray[axis]), most.max(ray[axis])))
        });
        let half = ranges.iter().map(|(least, most)| 0.5 * (most - least)).fold(f64::MIN_POSITIVE, f64::max);
        Self { middle: ranges.map(|(least, most)| 0.5 * (least + most)), half }
    }

    /// The modes at a point of the left photo.
    pub fn modes(&self, ray: &Ray) -> [f64; MODES] {
        let [x, y] = [0, 1].map(|axis| (ray[axis] - self.middle[axis]) / self.half);
        [1.0, x, y, x * y, x * x, y * y]
    }
}
