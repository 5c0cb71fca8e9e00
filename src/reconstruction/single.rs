//! The orientation of one image by points whose places are given.

use super::net::Net;
use super::options::ReconstructionOptions;
use super::rays::Rays;
use super::resection::resect;
use super::warning::UnorientedReason;
use crate::camera::{Camera, Pose};

/// Orients an image by positions in px and the places that are seen there, of which many may be wrong: those within `limit_px` agree. Gives
/// how many do, too.
pub(crate) fn resect_image(
    camera: &Camera,
    seen: &[([f64; 2], [f64; 3])],
    limit_px: f64,
    least: usize,
    seed: u32,
) -> Result<(Pose, usize), UnorientedReason> {
    let rays = Rays::new(seen.iter().map(|(at, _)| [(0, *at)]), 1);
    let longer_side_px = [f64::from(camera.width_px.max(camera.height_px))];
    let mut net = Net::new(&rays, &[0], &longer_side_px, vec![*camera], &ReconstructionOptions::default());
    net.points = seen.iter().map(|(_, place)| Some(*place)).collect();
    resect(&net, 0, limit_px, least, seed)
}
