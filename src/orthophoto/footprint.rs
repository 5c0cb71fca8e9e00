//! What an oriented image shows of the ground.

use super::heights::Heights;
use crate::camera::matrix;
use crate::{Camera, Pose};
use nalgebra::Vector3;

/// An oriented image above the ground.
#[derive(Clone, Copy)]
pub(super) struct Footprint<'a> {
    pub camera: &'a Camera,
    pub pose: &'a Pose,
    pub heights: &'a Heights,
}

/// Rays along a side of the image that find its border on the ground.
const RAYS: usize = 8;
/// Rays that go farther than this many heights above ground are cut there.
const FARTHEST: f64 = 6.0;

/// A ray meets the ground at the height where it last arrived, so many times.
const APPROACHES: usize = 4;

impl Footprint<'_> {
    /// Height above the middle of the model of heights.
    pub fn above_ground(&self) -> f64 {
        let [low, high] = self.heights.range();
        let below = self.heights.at([self.pose.position[0], self.pose.position[1]]).unwrap_or(0.5 * (low + high));
        self.pose.position[2] - below
    }

    /// The place at which a ray through a position in px arrives on the ground.
    pub fn arrives(&self, at: [f64; 2]) -> Option<[f64; 2]> {
        let [x, y] = self.camera.direction(at).ok()?;
        let ray = matrix(&self.pose.rotation).transpose() * Vector3::new(x, -y, -1.0);
        let flat = (ray.x * ray.x + ray.y * ray.y).sqrt();
        let mut height = self.above_ground();
        let [x0, y0, z0] = self.pose.position;
        let mut place = [x0, y0];
        for _ in 0..APPROACHES {
            let share = if -ray.z * FARTHEST > flat { height / -ray.z } else { FARTHEST * height / flat };
            place = [x0 + share * ray.x, y0 + share * ray.y];
            match self.heights.at(place) {
                Some(ground) => height = z0 - ground,
                None => break,
            }
        }
        Some(place)
    }

    /// The places where the border of the image arrives, in its order.
    pub fn border(&self) -> Vec<[f64; 2]> {
        let [w, h] = [self.camera.width_px, self.camera.height_px].map(f64::from);
        let share = |k: usize| k as f64 / RAYS as f64;
        let sides = (0..RAYS).map(|k| [w * share(k), 0.0]).chain((0..RAYS).map(|k| [w, h * share(k)]));
        let sides = sides.chain((0..RAYS).map(|k| [w * (1.0 - share(k)), h])).chain((0..RAYS).map(|k| [0.0, h * (1.0 - share(k))]));
        sides.filter_map(|at| self.arrives(at)).collect()
    }

    /// Side of a pixel of the image on the ground.
    pub fn gsd(&self) -> f64 {
        let corners = self.border();
        let area: f64 =
            (0..corners.len()).map(|k| (corners[k], corners[(k + 1) % corners.len()])).map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum::<f64>();
        (0.5 * area.abs() / (f64::from(self.camera.width_px) * f64::from(self.camera.height_px))).sqrt()
    }
}
