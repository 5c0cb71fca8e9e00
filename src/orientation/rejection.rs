//! Rejection of gross errors by standardised residuals.

use super::adjusted::Adjusted;
use super::adjustment::{NEARLY_SETTLED, SETTLED, adjust};
use super::coplanarity::{Linearised, Ray, RelativePose};
use super::robust_start::{Consensus, least_agreement};
use crate::math::{median, normal_median_within, normal_spread_within, smallest};
use crate::{Cause, Error, Unsettled};

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

/// What is known of σ before, and beyond how many of it an observation is rejected.
#[derive(Debug, Clone, Copy)]
pub(super) struct Limits {
    /// The limit of a standardised residual of normal errors.
    pub rejection: f64,
    /// σ is at least this, in units of the focal length: what was known of it, or the resolution of the coordinates; 0 where neither is.
    pub least_sigma: f64,
}

/// In this many rounds, rejected observations may come back; then they may not, so that the rounds end.
const FREE_ROUNDS: usize = 20;
const MAX_ROUNDS: usize = 40;

/// Residuals up to this many σ agree: σ is estimated from all of them, whatever the limit of rejection. A limit that cuts good
/// observations off must not make the σ smaller by which it cuts; and few gross errors are that small.
const AGREEING: f64 = 3.0;

/// From this number on the median tells σ well enough, and small gross errors hardly move it; of fewer, the mean square tells more.
const MANY: usize = 200;

/// What agrees with the start lies within this many of its scale: more where few observations gave that scale, as far as a gross error may
/// be told by it.
const START: f64 = 4.0;
const FURTHEST_START: f64 = 12.0;

/// Below this (in units of the focal length) residuals are rounding, and none is a gross error.
const LEAST_SCALE: f64 = 1e-11;

/// Adjusts, rejects what exceeds the limit of standardised residuals, and adjusts again until nothing changes.
///
/// The first rounds take residuals to first order, from adjustments that have nearly settled; what these leave is judged by final ones.
///
/// A standardised residual is v / √q_vv; an observation has one condition, so that its four coordinates have the same. For a rejected one,
/// q_vv is that of a new observation. σ is that of those that agree (within 3 σ, more where few of them make σ uncertain),
/// made consistent; each of these is tested by it as by a σ that it took part in estimating. A least σ that is known holds where the estimated one is
/// smaller; one that is too small rejects nothing that is good: the global test tells of it. Rays that meet behind a camera are rejected
/// whatever their residual.
///
/// # Errors
/// Those of [`adjust`]; [`Error::TooFew`] where fewer than five observations remain.
///
/// # Source
/// Baarda 1968, A testing procedure for use in geodetic networks; Pope 1976, The statistics of residuals and the detection of outliers.
pub(super) fn adjust_without_gross_errors(observed: Weighted<'_>, start: &Consensus, limits: Limits) -> Result<Clean, Error> {
    let mut agreeing = first_agreement(observed, start, limits);
    let mut accepted = agreeing.clone();
    let mut pose = start.model;
    let mut last = false;
    for round in 0..MAX_ROUNDS {
        let (kept, weights) = observed.kept(&accepted);
        if kept.len() < 5 {
            return Err(Error::TooFew { what: "observations that agree on a relative orientation", got: kept.len(), needed: 5 });
        }
        let adjusted = adjust(&kept, &weights, pose, if last { SETTLED } else { NEARLY_SETTLED }, |_| Ok(()))?;
        pose = adjusted.pose;
        let standardised = standardised_residuals(observed, &accepted, &adjusted, last);
        let sigma = sigma_of_agreeing(&standardised, &mut agreeing, limits.least_sigma);
        let redundancy = agreeing.iter().filter(|agrees| **agrees).count().saturating_sub(5);
        let within = sigma * internal_limit(limits.rejection, redundancy);
        let beyond = sigma * student_limit(limits.rejection, redundancy);
        let free = round < FREE_ROUNDS;
        let tested = standardised.iter().zip(&agreeing).zip(&accepted);
        let next: Vec<bool> = tested.map(|((t, agrees), was)| t.size <= if *agrees { within } else { beyond } && (*was || free)).collect();
        if next == accepted || kept.len() == 5 {
            if last {
                return Ok(Clean { adjusted, accepted });
            }
            last = true;
        } else {
            accepted = next;
        }
    }
    Err(super::refusal::diverged(MAX_ROUNDS, Cause::Unsettled { unsettled: Unsettled::GrossErrors, rounds: MAX_ROUNDS }))
}

/// A standardised residual, in σ: v / √q_vv.
#[derive(Debug, Clone, Copy)]
struct Standardised {
    size: f64,
    /// What it tells of σ: its redundancy number where it took part, 1 where it did not.
    share: f64,
}

/// σ by the residuals that agree, and which these are: where the two fit each other.
fn sigma_of_agreeing(standardised: &[Standardised], agreeing: &mut [bool], least_sigma: f64) -> f64 {
    let least = least_sigma.max(LEAST_SCALE);
    let mut sigma = least;
    let mut cut = f64::INFINITY;
    for _ in 0..20 {
        let within = || standardised.iter().zip(&*agreeing).filter(|(_, agrees)| **agrees).map(|(t, _)| *t);
        let number = within().count();
        let redundancy = within().map(|t| t.share).sum::<f64>();
        // Consistent where the cut has taken the tails away.
        let estimate = if number < MANY {
            let mean_square = within().map(|t| t.share * t.size * t.size).sum::<f64>() / redundancy.max(1e-6);
            mean_square.sqrt() / normal_spread_within(cut)
        } else {
            median(&mut within().map(|t| t.size).collect::<Vec<_>>()).unwrap_or(0.0) / normal_median_within(cut)
        };
        sigma = estimate.max(least);
        cut = student_limit(AGREEING, number.saturating_sub(5));
        let reach = sigma * cut;
        let next = standardised.iter().map(|t| t.size <= reach);
        let settled = next.clone().eq(agreeing.iter().copied());
        agreeing.iter_mut().zip(next).for_each(|(agrees, now)| *agrees = now);
        if settled {
            break;
        }
    }
    sigma
}

/// What agrees with the start by the start's own scale; never fewer than the consensus stands on.
fn first_agreement(observed: Weighted<'_>, start: &Consensus, limits: Limits) -> Vec<bool> {
    let rays = observed.rays;
    let distances: Vec<f64> =
        rays.iter().zip(observed.weights).map(|(ray, weight)| start.model.project(ray).1.abs() * weight.sqrt()).collect();
    let least = smallest(&mut distances.clone(), least_agreement(rays.len()) - 1);
    let reach = student_limit(START, least_agreement(rays.len()).saturating_sub(5)).min(FURTHEST_START);
    let threshold = (reach * start.scale.max(limits.least_sigma).max(LEAST_SCALE)).max(least);
    distances.iter().map(|d| *d <= threshold).collect()
}

/// The limit of a standardised residual by a σ that it took part in estimating (Pope's τ), exceeded as rarely as `limit` of the normal one.
fn internal_limit(limit: f64, redundancy: usize) -> f64 {
    if redundancy < 2 {
        return f64::INFINITY;
    }
    let freedom = redundancy as f64;
    let outside = student_limit(limit, redundancy - 1);
    if outside.is_infinite() { freedom.sqrt() } else { freedom.sqrt() * outside / (freedom - 1.0 + outside * outside).sqrt() }
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

/// |v| / √q_vv of every observation, in units of the focal length; to first order where not `exact`.
fn standardised_residuals(observed: Weighted<'_>, accepted: &[bool], adjusted: &Adjusted, exact: bool) -> Vec<Standardised> {
    let tangents = adjusted.pose.tangents();
    let standardise = |((ray, weight), accepted): ((&Ray, &f64), &bool)| {
        let projected = exact.then(|| adjusted.pose.project(ray));
        let Some(line) = adjusted.pose.linearise(&tangents, ray, &projected.map_or(*ray, |(at, _)| at)) else {
            return Standardised { size: 0.0, share: 0.0 };
        };
        let distance = projected.map_or(line.misclosure, |(_, distance)| distance);
        let of_unknowns = share_of_unknowns(&line, adjusted);
        let cofactor = if *accepted { 1.0 / weight - of_unknowns } else { 1.0 / weight + of_unknowns };
        // An observation without redundancy has no residual to judge.
        if cofactor * weight > 1e-6 {
            Standardised { size: distance.abs() / cofactor.sqrt(), share: (cofactor * weight).min(1.0) }
        } else {
            Standardised { size: 0.0, share: 0.0 }
        }
    };
    observed.rays.iter().zip(observed.weights).zip(accepted).map(standardise).collect()
}

pub(super) fn share_of_unknowns(line: &Linearised, adjusted: &Adjusted) -> f64 {
    line.by_unknowns.dot(&(adjusted.cofactors * line.by_unknowns))
}

/// Corrections of the four coordinates of every observation, in units of the focal length.
pub(super) fn corrections(rays: &[Ray], pose: &RelativePose) -> Vec<[f64; 4]> {
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
