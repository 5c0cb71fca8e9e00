//! The y-parallax that matches share over the image: 1, x, y, xy, x², y².

use super::coplanarity::Ray;

pub const MODES: usize = 6;

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
