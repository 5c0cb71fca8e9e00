//! Variance components: how large the errors of each group of observations are beside the standard errors that were stated of them.
//!
//! With v'Pv and the redundancy r of a group, v'Pv / r is its σ₀² (Förstner's estimator); beside the σ₀² that its weights were made with it shows by
//! how much the stated variance is wrong. Residuals of a group hold errors of the others, too: the part tr R² of tr R = r is its own, with R the
//! group's part of the redundancy matrix, and a change of its variance shows by that part alone (the diagonal of Helmert's equations). It lies between
//! the sum of the squares of redundancy numbers and r itself, which it is where the group alone determines what its residuals check.
//!
//! One group at a time is weighted anew, the one that its residuals contradict most, since a wrong group spoils the residuals of the others. Where nothing
//! is left to change, groups are weighted as stated again whose interval has come to hold 1.
//!
//! # Source
//! Helmert 1924; Förstner 1979, Ein Verfahren zur Schätzung von Varianz- und Kovarianzkomponenten; Koch 1999, Parameter estimation, 3.6;
//! Satterthwaite 1946 (degrees of freedom of a quadratic form).

use super::block::Block;
use super::reduced::Problem;
use super::reliability::{Scale, of_position};
use super::result::{ObservationGroup, ObservationVerdict, PriorStatistics, VarianceComponent};
use super::state::State;
use super::statistics::Statistics;
use crate::math::chi_square_quantile;

/// Degrees of freedom that determine a factor: fewer hold it at 1. With two, wrong marks made right control look wrong in nine of ten blocks.
pub(super) const LEAST_FREEDOM: f64 = 8.0;
/// Probability that the factor of right standard errors lies outside its interval.
const SIGNIFICANCE: f64 = 0.05;
/// A variance has converged when it would change by less than this share.
const CONVERGED: f64 = 0.02;
/// A step changes a variance by no more than this factor.
const LONGEST: f64 = 9.0;
/// Factors of standard errors are no smaller and no larger than these.
const SMALLEST: f64 = 0.01;
const LARGEST: f64 = 100.0;
/// Rounds of weighting: those of simulated blocks converge in less than half as many.
const MOST_ROUNDS: usize = 40;
/// A group that was weighted as stated again so many times stays so: it would come and go for ever.
const MOST_DROPS: usize = 2;
/// Standard error in px below which rays weigh no less, and below which there is nothing to compare stated standard errors with.
const LEAST_SIGMA_PX: f64 = 0.01;

/// Sums over the observations of a group.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Sum {
    observations: usize,
    /// v'Pv.
    squares: f64,
    redundancy: f64,
    /// Sum of the squares of redundancies: tr R² at least.
    own: f64,
}

impl Sum {
    fn add(&mut self, square: f64, redundancy: f64) {
        self.observations += 1;
        self.squares += square;
        self.redundancy += redundancy;
        self.own += redundancy * redundancy;
    }

    fn add_position(&mut self, statistics: &PriorStatistics, weight: &[f64; 3], coordinates: std::ops::Range<usize>) {
        let Some(redundancy) = statistics.redundancy else { return };
        for k in coordinates.filter(|k| weight[*k] > 0.0) {
            self.add(weight[k] * statistics.residual[k] * statistics.residual[k], redundancy[k]);
        }
    }

    /// Whether its redundancy determines a factor.
    fn carries(&self) -> bool {
        self.own >= LEAST_FREEDOM
    }
}

/// Sums over the observations of a block.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Sums {
    /// Redundancy of the rays of which nothing is stated.
    rest: f64,
    groups: [Sum; 5],
}

pub(super) fn sums_of_groups(
    block: &Block,
    problem: &Problem<'_>,
    state: &State,
    statistics: &Statistics,
    verdicts: &[ObservationVerdict],
) -> Sums {
    let mut sums = Sums::default();
    for ((ray, judged), _) in
        block.rays.iter().zip(&statistics.rays).zip(verdicts).filter(|(_, verdict)| **verdict == ObservationVerdict::Accepted)
    {
        for judged in judged.iter().flatten() {
            if ray.sigma_px.is_some() {
                sums.groups[0].add(judged.standardised * judged.standardised * judged.redundancy, judged.redundancy);
            } else {
                sums.rest += judged.redundancy;
            }
        }
    }
    let scale = Scale::of_tests(1.0);
    for (image, prior) in problem.gnss.iter().enumerate() {
        let Some(prior) = prior else { continue };
        let judged = of_position(prior, &problem.systematic.antenna(state, image), Some(statistics.of_position(image)), scale, true);
        sums.groups[1].add_position(&judged, &prior.weight, 0..2);
        sums.groups[2].add_position(&judged, &prior.weight, 2..3);
    }
    for (point, prior) in problem.control.iter().enumerate() {
        let (Some(prior), Some(q)) = (prior, statistics.points[point]) else { continue };
        let judged = of_position(prior, &state.points[point], Some([q[0][0], q[1][1], q[2][2]]), scale, true);
        sums.groups[3].add_position(&judged, &prior.weight, 0..2);
        sums.groups[4].add_position(&judged, &prior.weight, 2..3);
    }
    sums
}

/// What the residuals of a group say of its weights.
#[derive(Debug, Clone, Copy)]
pub(super) struct Estimate {
    /// Its variance by that of its weights, without the part of others in its residuals, with the interval that holds it.
    variance: f64,
    interval: [f64; 2],
    /// By which its variance is multiplied next.
    step: f64,
    /// How far its residuals are from what its weights let expect, in standard errors of that.
    misfit: f64,
}

impl Estimate {
    /// Of a group with redundancy, for weights made with the standard error `unit` of a ray.
    ///
    /// v'Pv follows a χ² distribution of r² / tr R² degrees of freedom, scaled: of r at least. A variance that differs from that of the weights by some
    /// share shows by tr R² / r of that.
    fn new(sum: &Sum, unit: f64) -> Self {
        let ratio = (sum.squares / sum.redundancy / (unit * unit)).clamp(1.0 / LONGEST, LONGEST);
        let own = sum.own / sum.redundancy;
        let without_others = |ratio: f64| (1.0 + (ratio - 1.0) / own).max(0.0);
        let limit = |probability: f64| without_others(ratio * sum.redundancy / chi_square_quantile(probability, sum.redundancy));
        Self {
            variance: without_others(ratio),
            interval: [limit(1.0 - 0.5 * SIGNIFICANCE), limit(0.5 * SIGNIFICANCE)],
            // For any tr R² between its limits what is left is no more than (1 - own) / (1 + own) of what was wrong.
            step: libm::pow(ratio, 2.0 / (1.0 + own)).clamp(1.0 / LONGEST, LONGEST),
            misfit: libm::log(ratio).abs() * (0.5 * sum.redundancy).sqrt(),
        }
    }
}

/// What holds of one group.
#[derive(Debug, Clone, Copy)]
struct Component {
    /// By which the stated variances are multiplied: 1 unless it is applied.
    variance: f64,
    is_applied: bool,
    drops: usize,
    last: Option<VarianceComponent>,
}

impl Component {
    const STATED: Self = Self { variance: 1.0, is_applied: false, drops: 0, last: None };

    fn estimated(&self, estimate: &Estimate) -> f64 {
        (self.variance * estimate.variance).clamp(SMALLEST * SMALLEST, LARGEST * LARGEST)
    }

    /// Whether the stated variance is among those that the residuals allow.
    fn holds_one(&self, estimate: &Estimate) -> bool {
        self.variance * estimate.interval[0] <= 1.0 && self.variance * estimate.interval[1] >= 1.0
    }

    /// The next variance; `None` where it stays as it is.
    fn next(&self, sum: &Sum, estimate: &Estimate) -> Option<f64> {
        let next = (self.variance * estimate.step).clamp(SMALLEST * SMALLEST, LARGEST * LARGEST);
        let is_wanted = match self.is_applied {
            true => (next / self.variance - 1.0).abs() > CONVERGED,
            false => self.drops < MOST_DROPS && !self.holds_one(estimate),
        };
        (sum.carries() && is_wanted).then_some(next)
    }

    fn describe(&self, group: ObservationGroup, sum: &Sum, estimate: Option<&Estimate>) -> VarianceComponent {
        let is_held = !sum.carries() && !self.is_applied;
        let found = estimate.filter(|_| !is_held);
        VarianceComponent {
            group,
            observations: sum.observations,
            redundancy: sum.redundancy,
            // The one by which it is weighted, which has converged to the estimated one.
            factor: if self.is_applied { self.variance.sqrt() } else { found.map_or(1.0, |found| self.estimated(found).sqrt()) },
            interval: found.map(|found| found.interval.map(|limit| (self.variance * limit).sqrt())),
            applied: self.is_applied,
            held: is_held,
        }
    }
}

/// The factors that hold.
#[derive(Debug, Clone)]
pub(super) struct Weights {
    components: [Component; 5],
    /// Whether the block has rays of a known standard error beside others.
    pub has_known_rays: bool,
    /// Times that a group was weighted anew, and whether nothing is left to change.
    pub rounds: usize,
    pub is_converged: bool,
}

impl Default for Weights {
    fn default() -> Self {
        Self { components: [Component::STATED; 5], has_known_rays: false, rounds: 0, is_converged: true }
    }
}

impl Weights {
    /// Gives rays of a known standard error their weights beside the others, whose standard error is `sigma_px`. Without others their weights
    /// are those of their standard errors, and σ₀ is that of 1 px.
    pub fn weigh_rays(&mut self, block: &mut Block, sigma_px: f64) {
        let known = block.rays.iter().filter(|ray| ray.sigma_px.is_some()).count();
        self.has_known_rays = known > 0 && known < block.rays.len();
        let unit = if self.has_known_rays { sigma_px.max(LEAST_SIGMA_PX) } else { 1.0 };
        for ray in &mut block.rays {
            if let Some(own) = ray.sigma_px {
                ray.weight = (unit / own * (unit / own)).clamp(1e-12, 1e12);
            }
        }
    }

    /// Estimates all components from the sums of an adjustment whose weights were made with the standard error `unit` of a ray; `None` where too little
    /// tells that.
    pub fn estimate(&mut self, sums: &Sums, unit: f64) -> Option<[Option<Estimate>; 5]> {
        if !(sums.rest >= LEAST_FREEDOM && unit >= LEAST_SIGMA_PX) {
            return None;
        }
        let estimates = sums.groups.map(|sum| (sum.redundancy > 0.0).then(|| Estimate::new(&sum, unit)));
        let of_groups = self.components.iter_mut().zip(&sums.groups).zip(&estimates).zip(ObservationGroup::ALL);
        for (((component, sum), estimate), group) in of_groups {
            component.last = (sum.observations > 0).then(|| component.describe(group, sum, estimate.as_ref()));
        }
        Some(estimates)
    }

    /// Estimates all components and changes one at most; whether weights are others now.
    pub fn update(&mut self, sums: &Sums, unit: f64) -> bool {
        let Some(estimates) = self.estimate(sums, unit) else { return false };
        let change = self.changed(&sums.groups, &estimates).or_else(|| self.dropped(&sums.groups, &estimates));
        self.is_converged = change.is_none();
        let Some((group, component)) = change.filter(|_| self.rounds < MOST_ROUNDS) else { return false };
        self.components[group] = component;
        self.rounds += 1;
        true
    }

    /// The group that its residuals contradict most among those that are to change, as it is then.
    fn changed(&self, sums: &[Sum; 5], estimates: &[Option<Estimate>; 5]) -> Option<(usize, Component)> {
        let next = |group: usize| {
            let (component, estimate) = (self.components[group], estimates[group]?);
            let variance = component.next(&sums[group], &estimate)?;
            Some((estimate.misfit, (group, Component { variance, is_applied: true, ..component })))
        };
        (0..5).rev().filter_map(next).max_by(|(a, _), (b, _)| a.total_cmp(b)).map(|(_, change)| change)
    }

    /// Of the groups whose factor is no longer certain the one that is nearest to what was stated, weighted as stated.
    fn dropped(&self, sums: &[Sum; 5], estimates: &[Option<Estimate>; 5]) -> Option<(usize, Component)> {
        let uncertain = |group: &usize| {
            let component = &self.components[*group];
            let is_certain = sums[*group].carries() && estimates[*group].is_some_and(|estimate| !component.holds_one(&estimate));
            component.is_applied && !is_certain
        };
        let size = |group: usize| libm::log(self.components[group].variance).abs();
        let group = (0..5).filter(uncertain).min_by(|a, b| size(*a).total_cmp(&size(*b)))?;
        Some((group, Component { drops: self.components[group].drops + 1, ..Component::STATED }))
    }

    /// The block's standard errors: those that were given times the factors.
    pub fn state_anew(&self, block: &mut Block, given: &Block) {
        let [marks, gnss_plan, gnss_height, control_plan, control_height] = self.components.map(|component| component.variance.sqrt());
        for (ray, given) in block.rays.iter_mut().zip(&given.rays) {
            ray.sigma_px = given.sigma_px.map(|sigma| sigma * marks);
        }
        let gnss = [gnss_plan, gnss_plan, gnss_height];
        for (image, given) in block.images.iter_mut().zip(&given.images) {
            if let (Some(own), Some(given)) = (&mut image.gnss, &given.gnss) {
                own.sigma = [0, 1, 2].map(|k| given.sigma[k].map(|sigma| sigma * gnss[k]));
            }
        }
        let control = [control_plan, control_plan, control_height];
        for (own, given) in block.control.iter_mut().zip(&given.control) {
            own.sigma = [0, 1, 2].map(|k| given.sigma[k] * control[k]);
        }
    }

    /// What was found last of each group that has observations.
    pub fn components(&self) -> Vec<VarianceComponent> {
        self.components.iter().filter_map(|component| component.last).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: f64 = 0.3;

    fn sum(observations: usize, share: f64, ratio: f64) -> Sum {
        let redundancy = observations as f64 * share;
        Sum { observations, squares: redundancy * ratio * UNIT * UNIT, redundancy, own: redundancy * share }
    }

    /// Sums of groups whose variances are `truth` times the stated ones, weighted by what holds now: the other observations' part of the residuals of
    /// each is `mixed` of the errors of the one before, and right otherwise.
    fn sums(weights: &Weights, observations: usize, share: f64, truth: [f64; 5], mixed: f64) -> Sums {
        let own = |group: usize| truth[group] / weights.components[group].variance;
        let other = |group: usize| 1.0 + mixed * (own((group + 4) % 5) - 1.0);
        let groups = std::array::from_fn(|group| sum(observations, share, share * own(group) + (1.0 - share) * other(group)));
        Sums { rest: 1000.0, groups }
    }

    fn converged(observations: usize, share: f64, truth: [f64; 5], mixed: f64) -> (Vec<VarianceComponent>, usize) {
        let mut weights = Weights::default();
        while weights.update(&sums(&weights, observations, share, truth, mixed), UNIT) {}
        assert!(weights.is_converged, "{weights:?}");
        (weights.components(), weights.rounds)
    }

    fn one(truth: f64) -> [f64; 5] {
        [1.0, truth, 1.0, 1.0, 1.0]
    }

    #[test]
    fn a_wrong_standard_error_is_found_and_a_right_one_kept() {
        for truth in [0.25, 4.0, 9.0] {
            let (found, rounds) = converged(60, 0.8, one(truth), 0.0);
            let [low, high] = found[1].interval.unwrap();
            assert!(found[1].applied && (found[1].factor / truth.sqrt() - 1.0).abs() < 0.02 && rounds < 8, "{truth}: {found:?} {rounds}");
            assert!(low < truth.sqrt() && high > truth.sqrt(), "{found:?}");
            assert!([0, 2, 3, 4].iter().all(|k| !found[*k].applied && (found[*k].factor - 1.0).abs() < 1e-9), "{found:?}");
        }
        let (right, rounds) = converged(60, 0.8, one(1.1), 0.0);
        assert!(!right[1].applied && rounds == 0, "{right:?}");
    }

    #[test]
    fn a_group_that_another_one_spoiled_is_weighted_as_stated_again() {
        let mut weights = Weights::default();
        // So wrong a group lets the next one look wrong; it is changed first.
        let truth = one(9.0);
        assert!(!weights.components[2].holds_one(&Estimate::new(&sums(&weights, 60, 0.7, truth, 1.0).groups[2], UNIT)));
        weights.update(&sums(&weights, 60, 0.7, truth, 1.0), UNIT);
        assert!(weights.components.map(|component| component.is_applied) == [false, true, false, false, false]);
        // One that was changed nevertheless is dropped once its interval holds 1.
        weights.components[2] = Component { variance: 2.0, is_applied: true, ..Component::STATED };
        while weights.update(&sums(&weights, 60, 0.7, truth, 1.0), UNIT) {}
        assert!(weights.is_converged && weights.components[1].is_applied && !weights.components[2].is_applied, "{weights:?}");
        assert!(weights.components[2].variance == 1.0 && weights.components[2].drops == 1, "{weights:?}");
    }

    #[test]
    fn several_wrong_groups_are_all_found() {
        let truth = [0.09, 4.0, 1.0, 9.0, 1.0];
        let (found, rounds) = converged(60, 0.8, truth, 0.5);
        for (found, truth) in found.iter().zip(truth) {
            assert!(found.applied == (truth != 1.0) && (found.factor / truth.sqrt() - 1.0).abs() < 0.05, "{rounds} {found:?}");
        }
        assert!(2 * rounds < MOST_ROUNDS, "{rounds}");
    }

    #[test]
    fn what_redundancy_does_not_carry_is_held_as_it_was_stated() {
        let (few, rounds) = converged(4, 0.3, one(25.0), 0.0);
        assert!(
            few.iter().all(|held| held.held && !held.applied && held.factor == 1.0 && held.interval.is_none()) && rounds == 0,
            "{few:?}"
        );
        assert!((few[1].redundancy - 1.2).abs() < 1e-12);
    }

    #[test]
    fn weights_that_never_converge_end_at_the_bound() {
        let mut weights = Weights::default();
        let mut calls = 0;
        // Whatever it is weighted by, the residuals ask for another weight.
        while weights.update(&Sums { rest: 1000.0, groups: [sum(60, 0.8, if calls % 2 == 0 { 9.0 } else { 0.11 }); 5] }, UNIT) {
            calls += 1;
        }
        assert!(calls == MOST_ROUNDS && weights.rounds == MOST_ROUNDS && !weights.is_converged);
    }
}
