//! Epipolar geometry over a plane that most points lie on: the plane's homography, and two points off it.

use super::scale::NoiseLimits;
use super::{fundamental::Fundamentals, transfer::square_transfer};
use crate::math::{BLOCK, Candidate, Problem};
use crate::orientation::{Field, Ray};
use nalgebra::{Matrix3, Vector3};
use std::ops::Range;

/// The search for a fundamental matrix that agrees with a homography.
pub(super) struct OffPlane<'a> {
    general: Fundamentals<'a>,
    homography: Matrix3<f64>,
    /// Observations off the plane.
    off: Vec<Ray>,
}

impl<'a> OffPlane<'a> {
    /// `distance`: that from the homography beyond which an observation lies off the plane. `None` where fewer than two do.
    pub fn new(field: &'a Field, limits: NoiseLimits, homography: Matrix3<f64>, distance: f64) -> Option<Self> {
        let off: Vec<Ray> = field.rays.iter().filter(|ray| square_transfer(&homography, ray) > distance * distance).copied().collect();
        (off.len() >= 2).then_some(Self { general: Fundamentals { field, limits }, homography, off })
    }

    /// F = [e]× G, the epipole e where the parallaxes of two points meet.
    ///
    /// # Source
    /// Chum, Werner & Matas 2005, Two-view geometry estimation unaffected by a dominant plane, CVPR.
    fn draft(&self, a: &Ray, b: &Ray) -> Option<Matrix3<f64>> {
        let parallax = |ray: &Ray| {
            let on_plane = self.homography * Vector3::new(ray[0], ray[1], -1.0);
            on_plane.cross(&Vector3::new(ray[2], ray[3], -1.0)).normalize()
        };
        let epipole = parallax(a).cross(&parallax(b)).try_normalize(1e-9)?;
        let matrix = epipole.cross_matrix() * self.homography;
        Some(matrix / matrix.norm()).filter(|m| m.iter().all(|v| v.is_finite()))
    }
}

impl Problem for OffPlane<'_> {
    type Model = Matrix3<f64>;
    const SAMPLE: usize = 2;

    fn count(&self) -> usize {
        self.general.count()
    }

    fn drawn_from(&self) -> usize {
        self.off.len()
    }

    fn drafts(&self, sample: &[usize], take: &mut dyn FnMut(Matrix3<f64>)) {
        self.draft(&self.off[sample[0]], &self.off[sample[1]]).into_iter().for_each(take);
    }

    fn squares(&self, draft: &Matrix3<f64>, range: Range<usize>, squares: &mut [f64; BLOCK]) {
        self.general.squares(draft, range, squares);
    }

    fn refined(&self, draft: &Matrix3<f64>, scale: f64) -> Option<Candidate<Matrix3<f64>>> {
        self.general.refined(draft, scale)
    }

    fn draft_of(&self, model: &Matrix3<f64>) -> Matrix3<f64> {
        *model
    }

    fn penalty(&self, _: &Matrix3<f64>, _: f64) -> f64 {
        0.0
    }
}
