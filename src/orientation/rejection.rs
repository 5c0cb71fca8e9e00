//! Rejection of gross errors by standardised residuals.

use super::adjustment::{Adjusted, adjust};
use super::consensus::{Consensus, least_agreement};
use super::coplanarity::{Linearised, Pose, Ray};
use crate::Error;
use crate::math::{mad_within, median, smallest};

/// Observations with their weights.
#[derive(Debug, Clone, Copy)]
pub(super) struct Weighted<'a> {
    pub rays: &'a [Ray],
    pub weights: &'a [f64],
}

impl Weighted<'_> {
    /// The rays and weights of those that are kept.
    pub fn kept(&self, accepted: &[bool]) -> (Vec<Ray>, Vec<f64>) {
        let all = self.rays.iter().zip(self.weights).zip(accepted);
        all.filter(|(_, kept)| **kept).map(|((ray, weight), _)| (*ray, *weight)).unzip()
    }
}

/// An adjustment free of gross errors.
#[derive(Debug, Clone)]
pub(super) struct Clean {
    pub adjusted: Adjusted,
    /// One for each observation: whether it took part.
    pub accepted: Vec<bool>,
}

/// In this many rounds, rejected observations may come back; then they may not, so that the rounds end.
const FREE_ROUNDS: usize = 10;
const MAX_ROUNDS: usize = 40;

/// Below this redundancy the median alone is no estimate.
const FEW: usize = 20;

/// Below this (in units of the focal length) residuals are rounding, and none is a gross error.
const LEAST_SCALE: f64 = 1e-11;

/// Adjusts, rejects what exceeds `limit` standardised residuals, and adjusts again until nothing changes.
///
/// A standardised residual is v / (σ √q_vv); an observation has one condition, so that its four coordinates have the same. For a rejected
/// one, q_vv is that of a new observation. Rays that meet behind a camera are rejected whatever their residual. σ is taken from the median
/// of the accepted ones, so that gross errors do not hide behind the σ that they raise; or it is `known_sigma` (0: not known) where that
/// is larger. One that is too small would reject what is good: the global test tells of it.
///
/// # Errors
/// Those of [`adjust`]; [`Error::TooFew`] where fewer than five observations remain.
pub(super) fn adjust_without_gross_errors(observed: Weighted<'_>, start: &Consensus, limit: f64, known_sigma: f64) -> Result<Clean, Error> {
    let scale_factor = 1.0 / mad_within(limit);
    let mut accepted = first_acceptance(observed, start, limit, scale_factor);
    let mut pose = start.pose;
    for round in 0..MAX_ROUNDS {
        let (kept, weights) = observed.kept(&accepted);
        if kept.len() < 5 {
            return Err(Error::TooFew { what: "observations that agree on a relative orientation", got: kept.len(), needed: 5 });
        }
        let adjusted = adjust(&kept, &weights, pose, |_| Ok(()))?;
        pose = adjusted.pose;
        let standardised = standardised_residuals(observed, &accepted, &adjusted);
        let mut of_accepted: Vec<f64> = standardised.iter().zip(&accepted).filter(|(_, kept)| **kept).map(|(t, _)| *t).collect();
        let redundancy = kept.len() - 5;
        let from_median = median(&mut of_accepted).unwrap_or(0.0) * scale_factor;
        // A median of a few residuals may be far too small by chance, more easily than their σ.
        let scale = if redundancy < FEW { from_median.max(adjusted.sigma) } else { from_median };
        let threshold = (student_limit(limit, redundancy) * scale.max(LEAST_SCALE)).max(limit * known_sigma);
        let next: Vec<bool> = standardised.iter().zip(&accepted).map(|(t, was)| *t <= threshold && (*was || round < FREE_ROUNDS)).collect();
        if redundancy == 0 || next == accepted {
            return Ok(Clean { adjusted, accepted });
        }
        accepted = next;
    }
    Err(super::refusal::diverged(MAX_ROUNDS, "the rejection of gross errors did not settle".into()))
}

/// What lies within the limit of the start's own scale, that scale made consistent first; never fewer than the consensus stands on.
fn first_acceptance(observed: Weighted<'_>, start: &Consensus, limit: f64, scale_factor: f64) -> Vec<bool> {
    let rays = observed.rays;
    let distances: Vec<f64> =
        rays.iter().zip(observed.weights).map(|(ray, weight)| start.pose.project(ray).1.abs() * weight.sqrt()).collect();
    let mut scale = start.scale;
    for _ in 0..10 {
        let mut within: Vec<f64> = distances.iter().copied().filter(|d| *d <= limit * scale).collect();
        let Some(middle) = median(&mut within).filter(|_| within.len() > 5) else {
            break;
        };
        scale = (middle * scale_factor).max(LEAST_SCALE);
    }
    let least = smallest(&mut distances.clone(), least_agreement(rays.len()) - 1);
    let threshold = (limit * scale).max(least);
    distances.iter().map(|d| *d <= threshold).collect()
}

/// The limit of Student's distribution that is exceeded as rarely as `limit` of the normal one: the σ of few residuals is uncertain.
///
/// # Source
/// Wallace 1959, Bounds on normal approximations to Student's and the chi-square distributions, inverted.
pub(super) fn student_limit(limit: f64, redundancy: usize) -> f64 {
    let freedom = redundancy.max(1) as f64;
    let stretched = limit * (8.0 * freedom + 3.0) / (8.0 * freedom + 1.0);
    (freedom * libm::expm1(stretched * stretched / freedom)).sqrt()
}

/// |v| / √q_vv of every observation, in units of the focal length.
fn standardised_residuals(observed: Weighted<'_>, accepted: &[bool], adjusted: &Adjusted) -> Vec<f64> {
    let tangents = adjusted.pose.tangents();
    let standardise = |((ray, weight), accepted): ((&Ray, &f64), &bool)| {
        let (at, distance) = adjusted.pose.project(ray);
        let Some(line) = adjusted.pose.linearise(&tangents, ray, &at) else {
            return 0.0;
        };
        let of_unknowns = share_of_unknowns(&line, adjusted);
        let cofactor = if *accepted { 1.0 / weight - of_unknowns } else { 1.0 / weight + of_unknowns };
        // An observation without redundancy has no residual to judge.
        if cofactor * weight > 1e-6 { distance.abs() / cofactor.sqrt() } else { 0.0 }
    };
    observed.rays.iter().zip(observed.weights).zip(accepted).map(standardise).collect()
}

pub(super) fn share_of_unknowns(line: &Linearised, adjusted: &Adjusted) -> f64 {
    line.by_unknowns.dot(&(adjusted.cofactors * line.by_unknowns))
}

/// Corrections of the four coordinates of every observation, in units of the focal length.
pub(super) fn corrections(rays: &[Ray], pose: &Pose) -> Vec<[f64; 4]> {
    rays.iter()
        .map(|ray| {
            let (adjusted, _) = pose.project(ray);
            std::array::from_fn(|k| adjusted[k] - ray[k])
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limits_are_those_of_the_tables_of_student() {
        // Two-sided probability 0.27 %: that of 3 standard errors.
        for (freedom, wanted, tolerance) in [(3, 9.22, 0.7), (5, 5.51, 0.15), (10, 3.96, 0.03), (100, 3.08, 0.01)] {
            let got = student_limit(3.0, freedom);
            assert!((got - wanted).abs() < tolerance, "{freedom}: {got}");
        }
    }
}
