//! Rejection of gross errors by standardised residuals.

use super::adjusted::Adjusted;
use super::adjustment::{NEARLY_SETTLED, SETTLED, adjust};
use super::agreement::{agreeing, contradicting};
use super::coplanarity::{Linearised, RelativePose};
use super::in_twos::{linearised, projected};
use super::normals::times;
use super::observed::{Limits, Weighted};
use super::refusal::near_vertical;
use super::robust_start::{Consensus, least_agreement, median_parallax};
use super::significance::significance_of_test;
use crate::math::{
    chi_square_quantile, median, normal_median_within, normal_outside, normal_spread_within, smallest, student_limit, tau_limit,
    variance_left,
};
use crate::{Cause, Error, Few, Unsettled};
use std::collections::BTreeMap;

/// An adjustment free of gross errors.
#[derive(Debug, Clone)]
pub(super) struct Clean {
    pub adjusted: Adjusted,
    /// One for each observation: whether it took part.
    pub accepted: Vec<bool>,
    /// How many of those that did not take part have rays that meet behind a camera.
    pub behind: usize,
}

impl Clean {
    /// How many were rejected by their residuals.
    pub fn beyond(&self) -> usize {
        self.accepted.iter().filter(|accepted| !**accepted).count() - self.behind
    }
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

/// Few observations: the order in which they agree is found one by one.
const FEW: usize = 200;

/// A minimum is another one where its σ is smaller by this factor.
const CLEARLY_SMALLER: f64 = 0.9;

/// One in so many gross errors is seen by the residuals of all: it has √50 of their σ.
const HARDLY_ANY: usize = 50;

/// By this factor a residual is beyond its limit whatever the last steps of an adjustment change.
const CLEARLY_BEYOND: f64 = 1.1;

/// Rays that meet at less than this many standard errors of a coordinate meet at infinity, for all that the observations tell.
const PARALLEL: f64 = 5.0;

/// Adjusts without the observations that contradict the others, and without those whose rays meet behind a camera.
///
/// First all observations are adjusted. Where none of their residuals exceeds its limit, and no subset agrees so much better that chance does not
/// explain it, that is the result: least squares of all. Else the largest set whose observations agree is adjusted, and what exceeds the
/// limit of its residuals is rejected, the largest first, until nothing does.
///
/// A standardised residual is v / √q_vv; an observation has one condition, so that its four coordinates have the same. It is tested by the σ
/// that it took part in estimating (τ), with few degrees of freedom at a significance that all tests share, or by a known σ, normally. A σ that was known and that the result contradicts is not used.
///
/// # Errors
/// Those of [`adjust`]; [`Error::TooFew`] where fewer than five observations remain; [`Error::Degenerate`] where too few agree to carry an
/// orientation and all together have none, and where most rays meet behind a camera.
///
/// # Source
/// Baarda 1968, A testing procedure for use in geodetic networks; Pope 1976, The statistics of residuals and the detection of outliers.
pub(super) fn adjust_without_gross_errors(observed: Weighted<'_>, start: &Consensus, limits: Limits) -> Result<Clean, Error> {
    let clean = clean_by(observed, start, limits)?;
    let kept = clean.accepted.iter().filter(|kept| **kept).count();
    if kept == 5 && kept < observed.rays.len() {
        // Any five observations agree.
        return Err(weak_support(kept, observed));
    }
    let freedom = kept.saturating_sub(5) as f64;
    match limits.known_sigma {
        Some(known) if freedom > 0.0 && freedom * (clean.adjusted.sigma / known).powi(2) > chi_square_quantile(0.975, freedom) => {
            clean_by(observed, start, Limits { known_sigma: None, ..limits })
        }
        _ => Ok(clean),
    }
}

fn clean_by(observed: Weighted<'_>, start: &Consensus, limits: Limits) -> Result<Clean, Error> {
    let number = observed.rays.len();
    let mut accepted = vec![true; number];
    let first = first_agreement(observed, start, limits);
    let disagreeing = first.iter().filter(|agrees| !**agrees).count();
    if number <= FEW {
        accepted = agreeing(observed, start, limits);
    } else {
        // So few do not hide behind the σ of all.
        let most = limits.most_by_mistake(number);
        let may_be_good =
            disagreeing * HARDLY_ANY <= number && !(disagreeing > most && lose_more_at_once(observed, start.model, limits, most));
        let by_all = may_be_good.then(|| by_residuals(observed, accepted.clone(), start.model, limits, most));
        if let Some(found) = by_all.and_then(Result::ok).filter(|found| found.beyond() <= most) {
            return in_front(observed, found, limits);
        }
        // More than good observations would lose: there are gross errors, and σ is that of those that agree.
        if let Some(found) = by_rounds(observed, start.model, first, limits).ok().filter(|found| found.beyond() > most) {
            return in_front(observed, found, limits);
        }
    }
    let is_all = accepted.iter().all(|kept| *kept);
    match by_residuals(observed, accepted, start.model, limits, number) {
        // All together have no orientation, and no part of them agrees well enough to be one. Where all agree, it is the iteration that fails.
        Err(Error::NotConverged { .. }) if is_all && disagreeing > 0 => Err(weak_support(number - disagreeing, observed)),
        found => {
            let found = found?;
            let in_doubt = if number <= FEW { contradicting(observed, &found.accepted, start, limits) } else { None };
            if let Some(agreeing) = in_doubt {
                return Err(weak_support(agreeing, observed));
            }
            let found = in_front(observed, found, limits)?;
            let takes_all = number <= FEW && found.accepted.iter().all(|kept| *kept);
            Ok(if takes_all { of_smaller_minimum(observed, found, limits) } else { found })
        }
    }
}

/// Where few observations all take part, the smaller one of two minima of v'Pv: nearly all of six or seven agree by chance with many a pose, from which
/// least squares of all leads to another minimum than from the vertical pair. A pose that has points behind a camera is none.
fn of_smaller_minimum(observed: Weighted<'_>, found: Clean, limits: Limits) -> Clean {
    let start = RelativePose::vertical(median_parallax(observed.rays));
    let other = adjust(observed.rays, observed.weights, start, SETTLED, near_vertical).ok();
    let other = other.filter(|other| other.sigma < CLEARLY_SMALLER * found.adjusted.sigma);
    let other = other.and_then(|other| by_residuals(observed, found.accepted.clone(), other.pose, limits, observed.rays.len()).ok());
    let other = other.and_then(|other| in_front(observed, other, limits).ok());
    other.filter(|other| other.behind == 0).unwrap_or(found)
}

fn weak_support(agreeing: usize, observed: Weighted<'_>) -> Error {
    super::refusal::degenerate(Cause::WeakSupport { agreeing, observations: observed.rays.len() })
}

/// Adjusts those that are accepted, and rejects what exceeds the limit, the largest first. It ends too once more than `most` are
/// rejected, with the adjustment that rejected them: none of them would come back.
fn by_residuals(observed: Weighted<'_>, mut accepted: Vec<bool>, start: RelativePose, limits: Limits, most: usize) -> Result<Clean, Error> {
    let mut pose = start;
    let at_once = most_at_once(observed);
    loop {
        let (kept, weights) = observed.kept(&accepted);
        let adjusted = adjust(&kept, &weights, pose, SETTLED, |_| Ok(()))?;
        pose = adjusted.pose;
        let rejected = accepted.len() - kept.len();
        let limit = limit_of_residuals(&adjusted, kept.len(), rejected, limits);
        let standardised = standardised_residuals(observed, &accepted, &adjusted, true);
        let mut beyond: Vec<usize> = (0..accepted.len()).filter(|k| accepted[*k] && standardised[*k].size > limit).collect();
        if beyond.is_empty() || kept.len() <= 5 {
            return Ok(Clean { adjusted, accepted, behind: 0 });
        }
        beyond.sort_by(|a, b| standardised[*b].size.total_cmp(&standardised[*a].size).then(a.cmp(b)));
        beyond.truncate(at_once.min(kept.len() - 5));
        beyond.iter().for_each(|k| accepted[*k] = false);
        if rejected + beyond.len() > most {
            return Ok(Clean { adjusted, accepted, behind: 0 });
        }
    }
}

/// How many are rejected before the others are adjusted again.
fn most_at_once(observed: Weighted<'_>) -> usize {
    1.max(observed.rays.len() / 100)
}

/// The limit of a standardised residual in an adjustment of `kept` observations after so many were rejected.
fn limit_of_residuals(adjusted: &Adjusted, kept: usize, rejected: usize, limits: Limits) -> f64 {
    match limits.known_sigma {
        Some(known) => limits.normal() * known,
        None => {
            let freedom = kept.saturating_sub(5);
            let alpha = significance_of_test(limits.alpha0, freedom);
            let sigma = adjusted.sigma / variance_left(kept, freedom, rejected, alpha).sqrt();
            (tau_limit(alpha, freedom) * sigma).max(limits.normal() * limits.least_sigma())
        }
    }
}

/// Whether [`by_residuals`] of all would reject more than `most` as soon as it looks at them: then it need not be run to its end.
///
/// An adjustment that has nearly settled tells it. What is left of its steps moves a residual by a hundredth of its standard error, so that those
/// which exceed the limit by a tenth exceed it in the end.
fn lose_more_at_once(observed: Weighted<'_>, start: RelativePose, limits: Limits, most: usize) -> bool {
    let number = observed.rays.len();
    if most_at_once(observed) <= most {
        return false;
    }
    let Ok(adjusted) = adjust(observed.rays, observed.weights, start, NEARLY_SETTLED, |_| Ok(())) else { return false };
    let limit = CLEARLY_BEYOND * limit_of_residuals(&adjusted, number, 0, limits);
    let standardised = standardised_residuals(observed, &vec![true; number], &adjusted, false);
    standardised.iter().filter(|t| t.size > limit).count() > most
}

/// Leaves out what lies behind a camera: the base is the one that has most points in front.
fn in_front(observed: Weighted<'_>, mut clean: Clean, limits: Limits) -> Result<Clean, Error> {
    loop {
        let least_angle = PARALLEL * clean.adjusted.sigma.max(limits.least_sigma());
        let pose = clean.adjusted.pose;
        let (mut forwards, mut backwards) = (Vec::new(), Vec::new());
        for k in (0..clean.accepted.len()).filter(|k| clean.accepted[*k]) {
            let [own, opposite] = pose.in_front_of_either(&observed.rays[k], least_angle);
            if !own {
                forwards.push(k);
            }
            if !opposite {
                backwards.push(k);
            }
        }
        let behind = if backwards.len() < forwards.len() { backwards } else { forwards };
        if behind.is_empty() {
            return Ok(clean);
        }
        behind.iter().for_each(|k| clean.accepted[*k] = false);
        clean.behind += behind.len();
        let (kept, weights) = observed.kept(&clean.accepted);
        if kept.len() <= clean.behind || kept.len() < 5 {
            let cause = Cause::BehindCameras { in_front: kept.len(), points: kept.len() + clean.behind };
            return Err(super::refusal::degenerate(cause));
        }
        clean.adjusted = adjust(&kept, &weights, pose, SETTLED, |_| Ok(()))?;
    }
}

/// Adjusts, rejects what exceeds the limit of standardised residuals, and adjusts again until nothing changes: many observations.
///
/// The first rounds take residuals to first order, from adjustments that have nearly settled; what these leave is judged by final ones. For a
/// rejected observation, q_vv is that of a new one. σ is that of those that agree (within 3 σ), made consistent; each of these is tested
/// by it as by a σ that it took part in estimating. A least σ that is known holds where the estimated one is smaller.
///
/// `agreeing`: those that agree with the start.
fn by_rounds(observed: Weighted<'_>, start: RelativePose, mut agreeing: Vec<bool>, limits: Limits) -> Result<Clean, Error> {
    let mut accepted = agreeing.clone();
    let mut pose = start;
    let mut last = false;
    let (mut before, mut swings) = (Vec::new(), false);
    let (mut student, mut tau) = (Remembered::of(student_limit), Remembered::of(tau_limit));
    for round in 0..MAX_ROUNDS {
        let (kept, weights) = observed.kept(&accepted);
        if kept.len() < 5 {
            return Err(Error::TooFew { few: Few::AgreeingObservations, got: kept.len(), needed: 5 });
        }
        let adjusted = adjust(&kept, &weights, pose, if last { SETTLED } else { NEARLY_SETTLED }, |_| Ok(()))?;
        pose = adjusted.pose;
        let standardised = standardised_residuals(observed, &accepted, &adjusted, last);
        let sigma = sigma_of_agreeing(&standardised, &mut agreeing, limits.least_sigma(), &mut student);
        let redundancy = agreeing.iter().filter(|agrees| **agrees).count().saturating_sub(5);
        let within = sigma * tau.at(limits.alpha0, redundancy);
        let beyond = sigma * student.at(limits.alpha0, redundancy);
        let free = round < FREE_ROUNDS && !swings;
        let tested = standardised.iter().zip(&agreeing).zip(&accepted);
        let next: Vec<bool> = tested.map(|((t, agrees), was)| t.size <= if *agrees { within } else { beyond } && (*was || free)).collect();
        if next == accepted || kept.len() == 5 {
            if last {
                return Ok(Clean { adjusted, accepted, behind: 0 });
            }
            last = true;
        } else {
            // Two sets that lead to each other would do so until rounds are no longer free: on with the one that it is then.
            swings |= next == before && round < FREE_ROUNDS && (FREE_ROUNDS - round) % 2 == 1;
            before = std::mem::replace(&mut accepted, next);
        }
    }
    Err(super::refusal::diverged(MAX_ROUNDS, Cause::Unsettled { unsettled: Unsettled::GrossErrors, rounds: MAX_ROUNDS }))
}

/// Limits by a probability and degrees of freedom, of which rounds ask for few again and again.
struct Remembered {
    limit: fn(f64, usize) -> f64,
    found: BTreeMap<(u64, usize), f64>,
}

impl Remembered {
    fn of(limit: fn(f64, usize) -> f64) -> Self {
        Self { limit, found: BTreeMap::new() }
    }

    fn at(&mut self, probability: f64, freedom: usize) -> f64 {
        *self.found.entry((probability.to_bits(), freedom)).or_insert_with(|| (self.limit)(probability, freedom))
    }
}

/// A standardised residual, in σ: v / √q_vv.
#[derive(Debug, Clone, Copy)]
struct Standardised {
    size: f64,
    /// What it tells of σ: its redundancy number where it took part, 1 where it did not.
    share: f64,
}

/// σ by the residuals that agree, and which these are: where the two fit each other.
fn sigma_of_agreeing(standardised: &[Standardised], agreeing: &mut [bool], least_sigma: f64, student: &mut Remembered) -> f64 {
    let mut sigma = least_sigma;
    let mut cut = f64::INFINITY;
    let agreeing_beyond = normal_outside(AGREEING);
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
        sigma = estimate.max(least_sigma);
        cut = student.at(agreeing_beyond, number.saturating_sub(5));
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
    let (_, mut distances) = projected(&start.model, rays);
    distances.iter_mut().zip(observed.weights).for_each(|(distance, weight)| *distance = distance.abs() * weight.sqrt());
    let least = smallest(&mut distances.clone(), least_agreement(rays.len()) - 1);
    let reach = student_limit(normal_outside(START), least_agreement(rays.len()).saturating_sub(5)).min(FURTHEST_START);
    let threshold = (reach * start.scale.max(limits.least_sigma())).max(least);
    distances.iter().map(|d| *d <= threshold).collect()
}

/// |v| / √q_vv of every observation, in units of the focal length; to first order where not `exact`.
fn standardised_residuals(observed: Weighted<'_>, accepted: &[bool], adjusted: &Adjusted, exact: bool) -> Vec<Standardised> {
    const NOTHING: Standardised = Standardised { size: 0.0, share: 0.0 };
    let nearest = exact.then(|| projected(&adjusted.pose, observed.rays));
    let places = nearest.as_ref().map_or(observed.rays, |(places, _)| places);
    let mut all = Vec::with_capacity(observed.rays.len());
    linearised(&adjusted.pose, observed.rays, places, |k, line| {
        let Some(line) = line else { return all.push(NOTHING) };
        let distance = nearest.as_ref().map_or(line.misclosure, |(_, distances)| distances[k]);
        let (weight, of_unknowns) = (observed.weights[k], share_of_unknowns(&line, adjusted));
        let cofactor = if accepted[k] { 1.0 / weight - of_unknowns } else { 1.0 / weight + of_unknowns };
        // An observation without redundancy has no residual to judge.
        let has_redundancy = cofactor * weight > 1e-6;
        let own = || Standardised { size: distance.abs() / cofactor.sqrt(), share: (cofactor * weight).min(1.0) };
        all.push(if has_redundancy { own() } else { NOTHING });
    });
    all
}

pub(super) fn share_of_unknowns(line: &Linearised, adjusted: &Adjusted) -> f64 {
    line.by_unknowns.dot(&times(&adjusted.cofactors, &line.by_unknowns))
}
