//! Where the photos of a block are taken, and how they are turned.

use super::flight::{BlockFlight, BlockView};
use crate::rotation_from_angles;
use crate::simulate::mounting::{Mounting, NADIR_MM};
use crate::simulate::random::{Random, Stream};
use nalgebra::{Matrix3, Vector3};

/// The flight wanders by this share of the base, and the angles by this many degrees.
const WANDERING: f64 = 0.04;
const TURNING_DEG: f64 = 2.0;

/// A photo of a block.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Exposure {
    /// M: photo = M·(X - X_L), photo x right, y up, against the view.
    pub rotation: Matrix3<f64>,
    /// X_L in m.
    pub centre: [f64; 3],
    /// Principal distance in px; the principal point is the middle of the image.
    pub focal_px: f64,
    /// Which of the block's cameras took it, from 0.
    pub camera: u32,
}

impl Exposure {
    /// Where a ground point is seen, in px, the centre of the top-left pixel at (0.5, 0.5); absent where it is behind or outside.
    pub fn project(&self, ground: [f64; 3], width_px: u32, height_px: u32) -> Option<[f64; 2]> {
        let p = self.rotation * (Vector3::from(ground) - Vector3::from(self.centre));
        if p.z >= 0.0 {
            return None;
        }
        let x = 0.5 * f64::from(width_px) - self.focal_px * p.x / p.z;
        let y = 0.5 * f64::from(height_px) + self.focal_px * p.y / p.z;
        let inside = (0.0..f64::from(width_px)).contains(&x) && (0.0..f64::from(height_px)).contains(&y);
        inside.then_some([x, y])
    }

    /// Where the ray of a position in px meets the level ground of height 0; absent where it does not come down.
    pub(super) fn on_level_ground(&self, [x, y]: [f64; 2], width_px: u32, height_px: u32) -> Option<[f64; 2]> {
        let photo = Vector3::new(x - 0.5 * f64::from(width_px), 0.5 * f64::from(height_px) - y, -self.focal_px);
        let ray = self.rotation.transpose() * photo;
        (ray.z < -1e-6).then(|| [0, 1].map(|axis| self.centre[axis] - self.centre[2] * ray[axis] / ray.z))
    }
}

/// The photos strip by strip, every other strip flown back; the cameras of an exposure follow one another.
pub(super) fn exposures(flight: &BlockFlight) -> Vec<Exposure> {
    let mut random = Random::new(flight.seed, Stream::BlockFlight);
    let height = |strip: usize| flight.flying_height_m * if flight.view == BlockView::TwoHeights && strip % 2 == 1 { 1.5 } else { 1.0 };
    // Photos lie across the flight: their short side is along it. The lowest strips set the overlaps.
    let ground_px = flight.flying_height_m * flight.pixel_mm / NADIR_MM;
    let base = ground_px * f64::from(flight.height_px) * (1.0 - flight.forward_overlap);
    let spacing = ground_px * f64::from(flight.width_px) * (1.0 - flight.side_overlap);
    let mut photos = Vec::new();
    for strip in 0..flight.strips {
        for exposure in 0..flight.exposures {
            let back = strip % 2 == 1;
            let along = if back { flight.exposures - 1 - exposure } else { exposure } as f64;
            let mut wander = |length: f64| length * random.between(-WANDERING, WANDERING);
            let centre = [strip as f64 * spacing + wander(spacing), along * base + wander(base), height(strip) + wander(base)];
            let mut turn = |angle: f64| (angle + random.between(-TURNING_DEG, TURNING_DEG)).to_radians();
            let heading = if back { 180.0 } else { 0.0 };
            let body = rotation_from_angles(turn(0.0), turn(0.0), turn(heading));
            photos.extend(flight.mountings().iter().enumerate().map(|(camera, Mounting { rotation, focal_mm })| Exposure {
                rotation: rotation * body,
                centre,
                focal_px: focal_mm / flight.pixel_mm,
                camera: camera as u32,
            }));
        }
    }
    photos
}
