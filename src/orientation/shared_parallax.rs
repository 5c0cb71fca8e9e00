//! The y-parallax that matches share over the image: 1, x, y, xy, x², y².

use super::coplanarity::Ray;

pub const MODES: usize = 6;

/// Standard deviation of each mode of the y-parallax that matches share, in standard errors of a coordinate: walls, roofs and the shape of a point's
/// surroundings give matches of one part of the image an error of the same sign. It is hardly smaller for matches by least squares, whose standard
/// errors are.
pub const SHARED_BY_FITS: f64 = 0.2;
pub const SHARED_BY_FEATURES: f64 = 0.1;

/// The modes at a point of the left photo.
pub fn modes(ray: &Ray, extent: f64) -> [f64; MODES] {
    let [x, y] = [ray[0] / extent, ray[1] / extent];
    [1.0, x, y, x * y, x * x, y * y]
}

/// Largest coordinate of the rays, by which those of the modes are divided.
pub fn extent(rays: &[Ray]) -> f64 {
    rays.iter().flat_map(|ray| [ray[0].abs(), ray[1].abs()]).fold(f64::MIN_POSITIVE, f64::max)
}
