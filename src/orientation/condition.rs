//! The conditions of the observations at their adjusted coordinates, from which precision, tests and statistics follow.

use super::coplanarity::{Linearised, Ray, RelativePose};
use super::in_twos::{linearised, projected};

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
        let (places, distances) = projected(pose, rays);
        let mut all = Vec::with_capacity(rays.len());
        linearised(pose, rays, &places, |k, line| all.push(Self { at: places[k], distance: distances[k], line }));
        all
    }
}
