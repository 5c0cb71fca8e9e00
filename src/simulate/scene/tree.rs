//! Trees: round crowns.

use super::super::lattice::value;
use super::super::photo::Ray;
use super::span::{Box3, Span};
use nalgebra::Vector3;

/// A tree's crown, a sphere.
#[derive(Debug, Clone)]
pub(super) struct Tree {
    pub(super) centre: Vector3<f64>,
    pub(super) radius_m: f64,
    /// Grey of the leaves in full sun.
    pub(super) tone: f64,
    pub(super) seed: u32,
}

impl Tree {
    /// The part of a ray inside the crown.
    pub(super) fn span(&self, ray: &Ray) -> Option<Span> {
        let from_centre = ray.origin - self.centre;
        let (a, b) = (ray.direction.norm_squared(), from_centre.dot(&ray.direction));
        let discriminant = b * b - a * (from_centre.norm_squared() - self.radius_m * self.radius_m);
        if discriminant <= 0.0 {
            return None;
        }
        let root = discriminant.sqrt();
        Some(Span { enter: (-b - root) / a, exit: (-b + root) / a, face: 0 })
    }

    pub(super) fn normal(&self, point: Vector3<f64>) -> Vector3<f64> {
        (point - self.centre) / self.radius_m
    }

    pub(super) fn bounds(&self) -> Box3 {
        let reach = Vector3::repeat(self.radius_m);
        Box3 { low: self.centre - reach, high: self.centre + reach }
    }

    /// Grey of the leaves in full sun at a point of the crown: clumps of branches.
    pub(super) fn tone_at(&self, point: Vector3<f64>) -> f64 {
        self.tone * (1.0 + 0.45 * value(0.7 * point.x, 0.7 * point.y, self.seed))
    }
}
