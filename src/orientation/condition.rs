//! The conditions of the observations at their adjusted coordinates, from which precision, tests and statistics follow.

use super::coplanarity::{Linearised, Ray, RelativePose};

/// The condition of an observation at its adjusted coordinates.
#[derive(Debug, Clone, Copy)]
pub(super) struct Condition {
    /// The adjusted coordinates.
    pub at: Ray,
    /// Signed distance of the observed coordinates from them.
    pub distance: f64,
    /// `None` where the observation says nothing.
    pub line: Option<Linearised>,
}

impl Condition {
    /// Of each of `rays`.
    pub fn all(pose: &RelativePose, rays: &[Ray]) -> Vec<Self> {
        let tangents = pose.tangents();
        let one = |ray: &Ray| {
            let (at, distance) = pose.project(ray);
            Self { at, distance, line: pose.linearise(&tangents, ray, &at) }
        };
        rays.iter().map(one).collect()
    }
}
