//! What cannot be oriented, and why.

use super::adjusted::Adjusted;
use super::coplanarity::{Ray, RelativePose};
use super::normals::{Matrix5, correlations};
use super::result::Observation;
use super::warning::{LARGEST_CONDITION, condition};
use crate::catalogue::check_call;
use crate::error::refuse as refuse_input;
use crate::math::median;
use crate::{Cause, Computation, Error, Few, Refusal, Side};

/// Largest photo coordinate in focal lengths: 89.4° off the axis. Coordinates beyond it are pixels taken for mm, or worse.
const LARGEST_COORDINATE: f64 = 100.0;

/// Least width of the points across the line through them, as a share of their length.
const LEAST_WIDTH: f64 = 1e-4;

/// Least median parallax after the rotation is taken off, in standard errors of a photo coordinate. Without any base it is 1.7: what is
/// below 6 tells noise and base apart badly.
const LEAST_PARALLAX: f64 = 6.0;

/// By this factor a parallax is beyond the least one whatever rounding does.
const CLEARLY: f64 = 1.01;
/// Angles in radians up to this have a tangent that tells them from others.
const WIDEST: f64 = 1.5;

/// Largest standard error of an angle or of the base's direction, in radians, that still is an orientation.
const LARGEST_ERROR: f64 = 0.35;

/// No camera has a shorter focal length; one of film in m does.
const TINY_FOCAL_MM: f64 = 1.0;

/// Different observations that the five unknowns take at least.
pub(crate) const LEAST_OBSERVATIONS: usize = 5;

/// Refuses a focal length and observations that are none.
pub(super) fn check_input(observations: &[Observation], focal_mm: f64) -> Result<(), Error> {
    check_call("focal_mm", focal_mm)?;
    let largest = LARGEST_COORDINATE * focal_mm;
    for (index, observation) in observations.iter().enumerate() {
        if !(observation.weight >= 1e-12 && observation.weight <= 1e12) {
            return refuse_input(Refusal::ObservationWeight { weight: observation.weight, observation: index });
        }
        let coordinates = observation.left.iter().chain(&observation.right);
        if let Some(&value_mm) = coordinates.into_iter().find(|v| !(v.abs() <= largest)) {
            let (largest_mm, focal_lengths) = (largest, LARGEST_COORDINATE);
            let tiny_mm = Some(focal_mm).filter(|focal_mm| *focal_mm < TINY_FOCAL_MM);
            return refuse_input(Refusal::PhotoCoordinates { value_mm, observation: index, largest_mm, focal_lengths, tiny_mm });
        }
    }
    Ok(())
}

/// Refuses observations that cannot determine five unknowns whatever the pose: too few different ones, all on a line, no parallax.
pub(super) fn check_geometry(rays: &[Ray]) -> Result<(), Error> {
    let mut different: Vec<&Ray> = Vec::new();
    for ray in rays {
        if different.len() < LEAST_OBSERVATIONS && !different.contains(&ray) {
            different.push(ray);
        }
    }
    if different.len() < LEAST_OBSERVATIONS {
        return Err(Error::TooFew { few: Few::DifferentObservations, got: different.len(), needed: LEAST_OBSERVATIONS });
    }
    for (side, first) in [(Side::Left, 0), (Side::Right, 2)] {
        let width = relative_width(rays, first);
        if !(width >= LEAST_WIDTH) {
            return Err(degenerate(Cause::PointsOnLine { side, width, least: LEAST_WIDTH }));
        }
    }
    if rays.iter().all(|[xl, yl, xr, yr]| (xl - xr).abs() < 1e-12 && (yl - yr).abs() < 1e-12) {
        return Err(degenerate(Cause::NoParallax));
    }
    Ok(())
}

/// Width of the points of a photo divided by their length, by the principal axes of their scatter.
fn relative_width(rays: &[Ray], first: usize) -> f64 {
    let n = rays.len() as f64;
    let mean = |k: usize| rays.iter().map(|ray| ray[k]).sum::<f64>() / n;
    let (x, y) = (mean(first), mean(first + 1));
    let sum = |product: fn(f64, f64) -> f64| rays.iter().map(|ray| product(ray[first] - x, ray[first + 1] - y)).sum::<f64>();
    let (xx, xy, yy) = (sum(|x, _| x * x), sum(|x, y| x * y), sum(|_, y| y * y));
    let (half_trace, half_difference) = (0.5 * (xx + yy), 0.5 * (xx - yy));
    let root = (half_difference * half_difference + xy * xy).sqrt();
    ((half_trace - root).max(0.0) / (half_trace + root)).sqrt()
}

/// Refuses a pose without a base: after its rotation nothing is left of the parallaxes but noise of the standard error `sigma`.
pub(super) fn check_parallax(pose: &RelativePose, sigma: f64, rays: &[Ray]) -> Result<(), Error> {
    let noise = sigma.max(1e-10);
    let clearly = CLEARLY * LEAST_PARALLAX * noise;
    // Of most pairs nearly all parallaxes are far beyond that: to count these takes less than the median of angles.
    let tangent = libm::tan(clearly);
    if clearly < WIDEST && 2 * rays.iter().filter(|ray| pose.meets_beyond(ray, tangent)).count() > rays.len() {
        return Ok(());
    }
    let parallax = median(&mut rays.iter().map(|ray| pose.parallactic_angle(ray)).collect::<Vec<_>>()).unwrap_or(0.0);
    if parallax > LEAST_PARALLAX * noise {
        return Ok(());
    }
    Err(degenerate(Cause::NoBase { parallax: parallax / noise, least: LEAST_PARALLAX }))
}

/// Refuses unknowns that can hardly be told apart.
pub(super) fn check_condition(cofactors: &Matrix5) -> Result<(), Error> {
    let condition = condition(&correlations(cofactors));
    if condition <= LARGEST_CONDITION {
        return Ok(());
    }
    Err(degenerate(Cause::Inseparable { condition, most: LARGEST_CONDITION }))
}

/// Refuses an adjusted pose that the observations do not support: no base, absurd standard errors, points behind the cameras.
pub(super) fn check_result(adjusted: &Adjusted, rays: &[Ray]) -> Result<(), Error> {
    check_parallax(&adjusted.pose, adjusted.sigma, rays)?;
    let errors = adjusted.cofactors.diagonal().map(|q| adjusted.sigma * q.sqrt());
    if !(errors.amax() < LARGEST_ERROR) {
        return Err(degenerate(Cause::LargeErrors { largest_deg: errors.amax().to_degrees() }));
    }
    let in_front = rays.iter().filter(|ray| adjusted.pose.in_front(ray, 0.0)).count();
    if 2 * in_front <= rays.len() {
        return Err(degenerate(Cause::BehindCameras { in_front, points: rays.len() }));
    }
    Ok(())
}

/// Bounds of an iteration that starts from the vertical pair.
pub(super) fn near_vertical(pose: &RelativePose) -> Result<(), Cause> {
    let cosine = 0.5 * (pose.rotation.trace() - 1.0);
    let rise = pose.base.z.abs();
    if !(cosine > 0.5) {
        return Err(Cause::TurnedAway);
    }
    if !(rise < 0.87) {
        return Err(Cause::RisingBase);
    }
    Ok(())
}

/// The error of singular normal equations.
pub(super) fn undetermined(share: f64) -> Error {
    degenerate(Cause::SingularNormals { share, least: 1e-13 })
}

/// The error of observations that do not determine the orientation.
pub(super) fn degenerate(cause: Cause) -> Error {
    Error::Degenerate { computation: Computation::RelativeOrientation, cause }
}

/// The error of an iteration that did not converge.
pub(super) fn diverged(iterations: usize, cause: Cause) -> Error {
    Error::NotConverged { computation: Computation::RelativeOrientation, iterations, cause }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_focal_length_in_metres_is_named_where_the_photo_is_too_large_for_it() {
        let at = |x_mm: f64| Observation { left: [x_mm, 0.0], right: [0.0; 2], weight: 1.0 };
        let told = |x_mm, focal_mm| check_input(&[at(x_mm)], focal_mm).unwrap_err().to_string();
        let in_metres = told(-110.4321, 0.1525);
        assert!(
            in_metres.ends_with("got -110.432 mm in observation 0 (counted from 0); allowed: -15.25 to 15.25 mm, 100 focal lengths; the focal length of 0.1525 mm may be given in metres"),
            "{in_metres}"
        );
        assert!(told(1e6, 152.5).ends_with("mm, 100 focal lengths"));
    }
}
