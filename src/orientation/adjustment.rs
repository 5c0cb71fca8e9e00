//! The rigorous adjustment: all four photo coordinates are observed, the coplanarity of the rays is the condition (Gauss-Helmert).

use super::adjusted::Adjusted;
use super::coplanarity::{Ray, RelativePose};
use super::in_twos::linearised;
use super::normals::{Matrix5, Normals};
use super::refusal::{check_condition, check_parallax, diverged, undetermined};
use crate::{Cause, Error};

const MAX_ITERATIONS: usize = 50;

/// What a step may be, in units of [`step_tolerance`], where the adjustment is final.
pub(super) const SETTLED: f64 = 1.0;
/// The same where it only tells gross errors from others: a hundredth of σ.
pub(super) const NEARLY_SETTLED: f64 = 1e4;

/// No single step turns the photo or the base by more than this (radians): a longer one is beyond what a linearisation means.
const LONGEST_STEP: f64 = 0.2;

/// A step has converged when its size √(δᵀNδ / 5) is below a millionth of σ, or is rounding.
pub(super) fn step_tolerance(sigma: f64) -> f64 {
    (1e-6 * sigma).max(1e-13)
}

/// Moves the pose by a step, cut to the longest one allowed.
pub(super) fn move_within_bounds(pose: &RelativePose, step: &super::coplanarity::Unknowns) -> RelativePose {
    let length = step.norm();
    if length > LONGEST_STEP { pose.moved(&(step * (LONGEST_STEP / length))) } else { pose.moved(step) }
}

/// Adjusts the pose to `rays` of these weights by least squares of the corrections of their coordinates, linearised at the adjusted coordinates until the
/// steps vanish.
///
/// The last step is below `settled` times [`step_tolerance`]. `bounds` tells for each pose whether it is still believable; plain iteration from a poor start may run away.
///
/// # Errors
/// [`Error::Degenerate`] where the normal equations are singular, and where it does not settle because the unknowns can hardly be told
/// apart; [`Error::NotConverged`].
///
/// # Source
/// Mikhail & Ackermann 1976, Observations and Least Squares, on conditions with unknowns; Lenzmann & Lenzmann 2004 on linearising at the
/// adjusted observations.
pub(super) fn adjust(
    rays: &[Ray],
    weights: &[f64],
    start: RelativePose,
    settled: f64,
    bounds: impl Fn(&RelativePose) -> Result<(), Cause>,
) -> Result<Adjusted, Error> {
    let redundancy = rays.len().saturating_sub(5);
    let mut pose = start;
    let mut adjusted = rays.to_vec();
    let mut lines = Vec::with_capacity(rays.len());
    let (mut last_step, mut last_sigma, mut last_cofactors) = (f64::INFINITY, 0.0, Matrix5::identity());
    for iteration in 1..=MAX_ITERATIONS {
        let mut normals = Normals::new();
        lines.clear();
        linearised(&pose, rays, &adjusted, |k, line| {
            if let Some(line) = &line {
                normals.add(&line.by_unknowns, line.misclosure, weights[k]);
            }
            lines.push(line);
        });
        let solution = normals.solve().map_err(undetermined)?;
        let mut square_sum = 0.0;
        for (((line, observed), at), weight) in lines.iter().zip(rays).zip(&mut adjusted).zip(weights) {
            if let Some(line) = line {
                let distance = line.misclosure + line.by_unknowns.dot(&solution.step);
                square_sum += weight * distance * distance;
                *at = line.adjusted(observed, distance);
            }
        }
        let sigma = if redundancy > 0 { (square_sum / redundancy as f64).sqrt() } else { 0.0 };
        pose = move_within_bounds(&pose, &solution.step);
        (last_sigma, last_cofactors) = (sigma, solution.cofactors);
        last_step = solution.size / step_tolerance(sigma);
        bounds(&pose).map_err(|cause| diverged(iteration, cause))?;
        if last_step < settled {
            let cofactors = solution.cofactors;
            let (precision, sensitivity) = (cofactors, cofactors);
            return Ok(Adjusted { pose, cofactors, precision, sensitivity, sigma, variance_left: 1.0, iterations: iteration, last_step });
        }
    }
    // Without a base there is no direction of it to settle on.
    check_parallax(&pose, last_sigma, rays)?;
    check_condition(&last_cofactors)?;
    Err(diverged(MAX_ITERATIONS, Cause::LongSteps { ratio: last_step }))
}
