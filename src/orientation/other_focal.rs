//! What half and twice the focal length say: whether one of them fits far better than the given one, or half of it as well.
//!
//! Of a focal length that is far off the residuals ask for no small change: views that converge fit it by another pose, which is the best one nearby.

use super::adjusted::Adjusted;
use super::adjustment::{NEARLY_SETTLED, adjust};
use super::coplanarity::{Ray, RelativePose};
use super::focal::{FocalMisfit, LEAST_SIGMA, NARROW};
use super::result::Warning;
use crate::camera::{angles_from_rotation, rotation_from_angles};
use crate::math::student_limit;
use nalgebra::Vector3;

/// With half the focal length σ₀ was 0.99 to 1.05 times as large where the given one was 2.5 times too long, and 1.6 times and more where it was right, on
/// photographs of narrow view; errors that matches share do less. Over level ground it is 1 for right ones as well, as for parts of the scans of metric
/// cameras, which the caller spares.
const EXCLUDED: f64 = 1.2;

/// What matches share imitates no ratio of σ₀ below this: none of the 243 right pairs of the bench `verdict` is weak by it alone.
const PREFERRED: f64 = 0.8;

const HALF: f64 = 0.5;
const TWICE: f64 = 2.0;

/// Of more observations a part is looked at: ratios of σ₀ far from 1 need no more.
const MOST_RAYS: usize = 1000;

/// σ₀ with other focal lengths by that with the given one, of the same observations.
pub(super) struct OtherFocals {
    half: Option<f64>,
    twice: Option<f64>,
    /// Degrees of freedom of all, beside one more unknown.
    freedom: usize,
}

impl OtherFocals {
    /// `weights`: those of the accepted observations in the normal equations.
    pub fn of(adjusted: &Adjusted, (rays, weights): (&[Ray], &[f64])) -> Self {
        let freedom = rays.len().saturating_sub(6);
        let every = rays.len().div_ceil(MOST_RAYS).max(1);
        let part: Vec<Ray> = rays.iter().copied().step_by(every).collect();
        let weights: Vec<f64> = weights.iter().copied().step_by(every).collect();
        let sigma =
            |rays: &[Ray], start: RelativePose| adjust(rays, &weights, start, NEARLY_SETTLED, |_| Ok(())).ok().map(|found| found.sigma);
        let given = sigma(&part, adjusted.pose).filter(|given| freedom > 0 && *given > LEAST_SIGMA);
        let ratio = |factor: f64| -> Option<f64> {
            // Coordinates in units of the other focal length, and so is their σ.
            let scaled: Vec<Ray> = part.iter().map(|ray| ray.map(|v| v / factor)).collect();
            let starts = [adjusted.pose, scaled_pose(&adjusted.pose, factor)];
            let least = starts.into_iter().filter_map(|start| sigma(&scaled, start)).min_by(f64::total_cmp)?;
            Some(factor * least / given?)
        };
        Self { half: ratio(HALF), twice: ratio(TWICE), freedom }
    }

    /// The one that fits far better, beyond chance with the significance `alpha0`.
    pub fn misfit(&self, alpha0: f64) -> Option<FocalMisfit> {
        let tried = [(self.half, HALF), (self.twice, TWICE)];
        let (ratio, factor) = tried.into_iter().filter_map(|(ratio, factor)| Some((ratio?, factor))).min_by(|a, b| a.0.total_cmp(&b.0))?;
        // Of one more unknown: what it takes from the sum of squares, by the variance that is left.
        let w = ((1.0 / (ratio * ratio) - 1.0).max(0.0) * self.freedom as f64).sqrt();
        let change = factor - 1.0;
        (ratio < PREFERRED && w > student_limit(alpha0, self.freedom)).then_some(FocalMisfit { change, w: w.copysign(change) })
    }

    /// The warning that half the focal length fits nearly as well as the given one: views of a long focal length hardly tell it over level ground, and no
    /// interval holds an error of it.
    pub fn unchecked(&self, condition: f64) -> Option<Warning> {
        let ratio = self.half.filter(|ratio| condition > NARROW && *ratio < EXCLUDED)?;
        Some(Warning::UncheckedFocal { ratio, least: EXCLUDED })
    }
}

/// About where views converge as much as their images say with so many times the focal length: tilts and depths go with it.
fn scaled_pose(pose: &RelativePose, factor: f64) -> RelativePose {
    let [omega, phi, kappa] = angles_from_rotation(&pose.rotation);
    let [omega, phi] = [omega, phi].map(|tilt| libm::atan2(libm::sin(tilt), factor * libm::cos(tilt)));
    let base = Vector3::new(pose.base.x, pose.base.y, factor * pose.base.z).normalize();
    RelativePose { rotation: rotation_from_angles(omega, phi, kappa), base }
}
