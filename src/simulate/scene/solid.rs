//! The solids of a scene.

use super::super::photo::Ray;
use super::building::Building;
use super::facade;
use super::span::{Box3, Span};
use super::tree::Tree;
use nalgebra::Vector3;

/// A thing that stands on the ground.
#[derive(Debug, Clone)]
pub(super) enum Solid {
    Building(Building),
    Tree(Tree),
}

impl Solid {
    pub(super) fn span(&self, ray: &Ray) -> Option<Span> {
        match self {
            Solid::Building(building) => building.span(ray),
            Solid::Tree(tree) => tree.span(ray),
        }
    }

    /// Grey in full sun and outward normal at a point of a face.
    pub(super) fn look(&self, face: usize, point: Vector3<f64>) -> (f64, Vector3<f64>) {
        match self {
            Solid::Building(building) => (facade::tone(building, face, point), building.normal(face)),
            Solid::Tree(tree) => (tree.tone_at(point), tree.normal(point)),
        }
    }

    /// The box around it; a building's reaches down to `floor_m`.
    pub(super) fn bounds(&self, floor_m: f64) -> Box3 {
        match self {
            Solid::Building(building) => building.bounds(floor_m),
            Solid::Tree(tree) => tree.bounds(),
        }
    }
}

#[cfg(test)]
impl Solid {
    /// Whether a point lies inside: the plain definition of each shape, for comparison with what rays find.
    pub(super) fn contains(&self, point: Vector3<f64>) -> bool {
        match self {
            Solid::Building(building) => building.contains(point),
            Solid::Tree(tree) => (point - tree.centre).norm() < tree.radius_m,
        }
    }
}
