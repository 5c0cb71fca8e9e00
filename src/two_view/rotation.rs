//! Photos from one place: the right photo differs from the left one by a rotation alone.

use super::frame::{Frame, View};
use super::homography::REFINED_BY;
use super::least_direction::by_rows;
use super::refine::{Kind, Lines, refined};
use super::scale::{Conditions, NoiseLimits};
use super::transfer::{lines, square_transfer};
use crate::camera::nearest_rotation;
use crate::math::{BLOCK, Candidate, Problem};
use crate::orientation::{Field, Ray};
use nalgebra::{Matrix3, SVector, Vector3};
use std::ops::Range;

/// The rotation that takes two left directions to the right ones; `None` where either two are one.
pub(super) fn two_point(sample: &[Ray; 2]) -> Option<Matrix3<f64>> {
    let axes = |first: usize| {
        let [a, b] = sample.map(|ray| Vector3::new(ray[first], ray[first + 1], -1.0).normalize());
        // The bisector, the difference and what is at right angles to both: errors of both directions count the same.
        let middle = (a + b).try_normalize(1e-9)?;
        let across = (b - a).try_normalize(1e-9)?;
        Some(Matrix3::from_columns(&[middle, across, middle.cross(&across)]))
    };
    Some(axes(2)? * axes(0)?.transpose())
}

/// The refinement of a rotation: three small turns.
pub(super) struct Turn;

impl Kind<3> for Turn {
    const CONDITIONS: Conditions = Conditions::Two;

    fn tangents(&self, matrix: &Matrix3<f64>) -> [[f64; 9]; 3] {
        std::array::from_fn(|k| by_rows(&(Vector3::ith(k, 1.0).cross_matrix() * matrix)))
    }

    fn moved(&self, matrix: &Matrix3<f64>, step: &SVector<f64, 3>) -> Matrix3<f64> {
        let moved = matrix + Vector3::new(step[0], step[1], step[2]).cross_matrix() * matrix;
        nearest_rotation(&moved).unwrap_or(*matrix)
    }

    fn lines(&self, matrix: &Matrix3<f64>, ray: &Ray) -> Option<Lines> {
        lines(matrix, ray)
    }

    fn square(&self, matrix: &Matrix3<f64>, ray: &Ray) -> f64 {
        square_transfer(matrix, ray)
    }
}

/// The search for a rotation.
pub(super) struct Rotations<'a> {
    pub field: &'a Field,
    pub limits: NoiseLimits,
}

impl Problem for Rotations<'_> {
    type Model = Matrix3<f64>;
    const SAMPLE: usize = 2;

    fn count(&self) -> usize {
        self.field.rays.len()
    }

    fn drafts(&self, sample: &[usize], take: &mut dyn FnMut(Matrix3<f64>)) {
        two_point(&[self.field.rays[sample[0]], self.field.rays[sample[1]]]).into_iter().for_each(take);
    }

    fn squares(&self, draft: &Matrix3<f64>, range: Range<usize>, squares: &mut [f64; BLOCK]) {
        squares.iter_mut().zip(&self.field.rays[range]).for_each(|(square, ray)| *square = square_transfer(draft, ray));
    }

    fn refined(&self, draft: &Matrix3<f64>, scale: f64) -> Option<Candidate<Matrix3<f64>>> {
        refined(&Turn, self.field, &Candidate { model: *draft, scale }, &self.limits, REFINED_BY)
    }

    fn draft_of(&self, model: &Matrix3<f64>) -> Matrix3<f64> {
        *model
    }

    fn penalty(&self, _: &Matrix3<f64>, _: f64) -> f64 {
        0.0
    }
}

/// A focal length that is given may be off by this share: that of EXIF is rounded, and focusing changes it.
const FOCAL_ERROR: f64 = 0.1;
/// Focal lengths that are tried on either side.
const TRIED: i32 = 5;

/// The rotation that explains matches in px best, with focal lengths near those of the `frame`. What moves as if the camera had turned about
/// itself at one of them tells nothing of a base.
pub(super) fn near_focal(points: &[[f64; 4]], frame: &Frame, start: &Matrix3<f64>, largest_px: f64) -> Option<(Frame, Matrix3<f64>)> {
    let at = |k: i32| {
        let scaled = |view: View| View { unit: view.unit * (1.0 + FOCAL_ERROR * f64::from(k) / f64::from(TRIED)), ..view };
        let frame = Frame { left: scaled(frame.left), right: scaled(frame.right) };
        let limits = NoiseLimits { largest_threshold: largest_px / frame.px(), fixed: false };
        let field = Field::new(&frame.rays(points), 1);
        let found = refined(&Turn, &field, &Candidate { model: *start, scale: limits.largest_threshold }, &limits, REFINED_BY)?;
        let cost: f64 = field.rays.iter().take(REFINED_BY).map(|ray| square_transfer(&found.model, ray).sqrt()).sum();
        Some((cost * frame.px(), frame, found.model))
    };
    let best = (-TRIED..=TRIED).filter_map(at).min_by(|a, b| a.0.total_cmp(&b.0));
    best.map(|(_, frame, rotation)| (frame, rotation))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::camera::rotation_from_angles;

    fn seen(rotation: &Matrix3<f64>, x: f64, y: f64) -> Ray {
        let right = rotation * Vector3::new(x, y, -1.0);
        [x, y, -right.x / right.z, -right.y / right.z]
    }

    #[test]
    fn two_points_give_the_rotation() {
        let truth = rotation_from_angles(0.2, -0.3, 2.0);
        let found = two_point(&[seen(&truth, 0.1, 0.3), seen(&truth, -0.4, 0.2)]).unwrap();
        assert!((found - truth).amax() < 1e-12);
        assert!(two_point(&[seen(&truth, 0.1, 0.3); 2]).is_none());
    }

    #[test]
    fn refinement_stays_a_rotation_and_finds_the_true_one() {
        let truth = rotation_from_angles(0.2, -0.3, 2.0);
        let rays: Vec<Ray> = (0..100).map(|k| seen(&truth, 0.01 * k as f64 - 0.5, 0.3 * ((k * k) as f64).sin())).collect();
        let field = Field::new(&rays, 1);
        let start = Candidate { model: rotation_from_angles(0.21, -0.28, 2.01), scale: 0.05 };
        let found = refined(&Turn, &field, &start, &NoiseLimits { largest_threshold: 0.1, fixed: false }, 100).unwrap();
        assert!((found.model - truth).amax() < 1e-9, "{}", (found.model - truth).amax());
    }
}
