//! Light: the sun, the sky, and the shadows that solids cast.

use super::super::buckets::{Buckets, Rectangle};
use super::super::photo::Ray;
use super::solid::Solid;
use nalgebra::Vector3;

/// Share of the light on level ground that comes from the whole sky.
const SKY: f64 = 0.32;

/// Side of the cells in which shadows are looked up, in m.
const CELL_M: f64 = 5.0;

/// The sun with the list of solids whose shadow may fall into each cell of the ground.
pub(super) struct Sun {
    /// Unit vector to the sun.
    pub(super) direction: Vector3<f64>,
    shadows: Buckets,
}

impl Sun {
    /// The sun in the south-east, 48 degrees high. No point of the scene lies below `floor_m`.
    pub(super) fn new(area: Rectangle, floor_m: f64, solids: &[Solid]) -> Self {
        let direction = Vector3::new(0.38, -0.55, 0.74).normalize();
        let extents: Vec<Rectangle> = solids.iter().map(|solid| shadow_extent(solid, floor_m, direction)).collect();
        Self { direction, shadows: Buckets::new(area, CELL_M, &extents) }
    }

    /// Light on a surface as a share of that on level ground in full sun. `own` is the solid that has the surface.
    pub(super) fn light(&self, solids: &[Solid], point: Vector3<f64>, normal: Vector3<f64>, own: Option<u32>) -> f64 {
        let incidence = normal.dot(&self.direction);
        if incidence <= 0.0 || self.is_shaded(solids, point, own) {
            return SKY;
        }
        SKY + (1.0 - SKY) * incidence / self.direction.z
    }

    /// Convex solids never shade the faces they turn to the sun, so that the own solid is left out.
    fn is_shaded(&self, solids: &[Solid], point: Vector3<f64>, own: Option<u32>) -> bool {
        let ray = Ray { origin: point, direction: self.direction };
        let blocks = |index: u32| solids[index as usize].span(&ray).is_some_and(|span| span.exit > 0.0);
        self.shadows.at(point.x, point.y).iter().any(|&index| Some(index) != own && blocks(index))
    }
}

/// The rectangle of the ground plan over which a solid and its shadow lie.
fn shadow_extent(solid: &Solid, floor_m: f64, sun: Vector3<f64>) -> Rectangle {
    let bounds = solid.bounds(floor_m);
    let fall = (bounds.high.z - floor_m) / sun.z;
    let (dx, dy) = (-sun.x * fall, -sun.y * fall);
    [bounds.low.x + dx.min(0.0), bounds.low.y + dy.min(0.0), bounds.high.x + dx.max(0.0), bounds.high.y + dy.max(0.0)]
}
