//! The rounds of an adjustment: adjust, check, and again until no check changes anything.

use super::course::Course;
use super::parameters::Candidates;
use crate::adjustment::axis::observed_axes;
use crate::adjustment::block::Block;
use crate::adjustment::components::sums_of_groups;
use crate::adjustment::datum::{held_images, moved_onto};
use crate::adjustment::gauss_newton::{Adjusted, Demand, LEAST_SIGMA_PX};
use crate::adjustment::network::Columns;
use crate::adjustment::options::{AdjustmentOptions, Datum, Loss};
use crate::adjustment::reduced::{KnownParameter, Problem};
use crate::adjustment::reliability::Judged;
use crate::adjustment::result::{FixedParameter, GroupWeighting, ObservationVerdict, VarianceComponent};
use crate::adjustment::shared::{SharedCofactors, shared_cofactors};
use crate::adjustment::statistics::{Statistics, statistics};
use crate::adjustment::systematic_result::SystematicResult;
use crate::{Cause, Computation, Error, Few, Unsettled};

/// Rounds with the robust loss, and in all from one weighting of groups to the next, but for those that fix camera parameters.
const ROBUST_ROUNDS: usize = 10;
const MAX_ROUNDS: usize = 40;
/// Where a robust round rejects no more than this share of the rays, least squares can go on.
const FEW_GROSS_ERRORS: f64 = 0.01;

/// Steps of robust rounds need not be as small, in standard errors, as those of the last.
const ROBUST_TOLERANCE: f64 = 1e-2;
const TOLERANCE: f64 = 1e-4;
/// Once nothing changes any more, steps go on to this: another program that starts from the result finds it again.
const LAST_TOLERANCE: f64 = 1e-6;

/// The median that weights observed positions while rays are rejected has settled when it changes by less than this share.
const SETTLED_SIGMA: f64 = 0.02;
/// The same of σ₀, which takes its place. It hardly follows its own weights, and settles in two or three rounds, where the rays are more than what it weighs.
const SETTLED_SIGMA0: f64 = 1e-4;
const MOST_WEIGHINGS: usize = 10;

/// A settled adjustment.
pub(in crate::adjustment) struct Settled {
    /// With the weights and standard errors that held in it.
    pub block: Block,
    /// What the residuals say of stated standard errors.
    pub components: Vec<VarianceComponent>,
    pub adjusted: Adjusted,
    pub statistics: Option<Statistics>,
    /// What errors add that the rays of an image share; absent where none are expected.
    pub shared: Option<SharedCofactors>,
    pub verdicts: Vec<ObservationVerdict>,
    pub columns: Columns,
    /// Systematic errors of GNSS positions; absent where none were to be estimated.
    pub systematic: Option<SystematicResult>,
    pub fixed: Vec<Vec<FixedParameter>>,
    pub redundancy: usize,
    /// Whether the GNSS position of each image took part, where it has one.
    pub placed: Vec<bool>,
    /// Standard error of a coordinate of weight 1 that the observed positions were weighted by.
    pub weighted_by: f64,
    /// The same as the residuals have it.
    pub sigma: f64,
    /// Those before groups of observations were weighted anew.
    pub iterations: usize,
    pub rounds: usize,
    /// Absent where no variance components are estimated.
    pub weighting: Option<GroupWeighting>,
}

/// Adjusts a block until nothing changes any more.
///
/// # Errors
/// Those of [`adjust_block`](crate::adjust_block), but for what its input alone tells.
pub(in crate::adjustment) fn settle(block: &Block, options: &AdjustmentOptions) -> Result<Settled, Error> {
    let mut course = Course::new(block, options)?;
    course.fix_undetermined()?;
    let mut is_robust = options.loss != Loss::Squares;
    // Rounds of which `aside` count for nothing: what ends them has an end of its own.
    let (mut calm_rounds, mut rounds, mut aside) = (0, 0, 0);
    // What the adjustment with the weights that were stated took.
    let mut stated: Option<(usize, usize)> = None;
    // Rounds before the last weighting.
    let mut before = 0;
    let mut last = Unsettled::GrossErrors;
    while rounds - before - aside < MAX_ROUNDS {
        rounds += 1;
        let outcome = course.round(if is_robust { options.loss } else { Loss::Squares }, calm_rounds)?;
        calm_rounds += usize::from(!is_robust);
        if !matches!(outcome, Outcome::Scaled) {
            course.weighings = 0;
        }
        match outcome {
            Outcome::Fixed | Outcome::Scaled => aside += 1,
            Outcome::Changed { rejected, what } => {
                last = what;
                let few = rejected as f64 <= FEW_GROSS_ERRORS * block.rays.len() as f64;
                is_robust &= !(options.snooping && (few || rounds - before - aside >= ROBUST_ROUNDS));
            }
            Outcome::Weighted => {
                stated = stated.or(Some((rounds, course.iterations)));
                (before, aside) = (rounds, 0);
            }
            Outcome::Settled(settled) => {
                let (rounds, iterations) = stated.unwrap_or((rounds, course.iterations));
                let weighting = options.variance_components.then(|| course.weighting(course.iterations - iterations));
                return Ok(Settled { rounds, iterations, weighting, ..*settled });
            }
        }
    }
    let cause = Cause::Unsettled { unsettled: last, rounds: MAX_ROUNDS };
    Err(Error::NotConverged { computation: Computation::BundleAdjustment, iterations: course.iterations, cause })
}

/// How a round ends.
enum Outcome {
    /// Rays, observed positions or weights are others now; so many rays were rejected.
    Changed {
        rejected: usize,
        what: Unsettled,
    },
    /// Camera parameters or systematic errors of positions were fixed, and nothing else changed.
    Fixed,
    /// Another σ₀ weighs what has a stated standard error, and nothing else changed.
    Scaled,
    /// A group of observations was weighted anew by its residuals, and nothing else changed.
    Weighted,
    Settled(Box<Settled>),
}

/// An adjustment of the accepted rays, and what its checks ask of it.
struct Round<'a> {
    problem: Problem<'a>,
    adjusted: Adjusted,
    loss: Loss,
    /// Rounds of least squares before this one.
    calm_rounds: usize,
    /// Standard errors of a coordinate: as the round before saw it, and as it weighted observed positions.
    sigma_before: f64,
    weighted_by: f64,
    statistics: Option<Statistics>,
}

/// A check of a round: it ends the round where it changes what is adjusted next, and says how; `None` leaves the round to the next check.
type Check<'a> = fn(&mut Course<'a>, &mut Round<'_>) -> Result<Option<Outcome>, Error>;

impl<'a> Course<'a> {
    /// The checks of a round in their order. Each row stands on those above it having changed nothing:
    ///
    /// | check | where | changes | the round ends as |
    /// |---|---|---|---|
    /// | `creeping` | steps did not vanish | fixes camera parameters | `Fixed` |
    /// | `impossible` | points lie behind images or are not determined | rejects rays | `Changed` |
    /// | `by_earlier_cofactors` | an earlier round of this loss left cofactors | rejects rays, or weighs by another σ₀ | `Changed` or `Scaled` |
    /// | `by_own_cofactors` | always | rejects and takes back rays and positions, weighs positions anew, ends the robust loss | `Changed` |
    /// | `weighted_by_another` | σ₀ is not what standard errors were weighted by | weighs by σ₀ from now on | `Scaled` |
    /// | `weights` | variance components are to weigh | weighs a group of observations anew | `Weighted` |
    /// | `undetermined` | camera parameters are worse than the limit, or nothing determines systematic errors of positions | fixes them | `Fixed` |
    /// | `insignificant` | systematic errors of positions are no more than chance | fixes them at zero | `Fixed` |
    ///
    /// Below the last row the adjustment is settled.
    const CHECKS: [Check<'a>; 8] = [
        Self::creeping,
        Self::impossible,
        Self::by_earlier_cofactors,
        Self::by_own_cofactors,
        Self::weighted_by_another,
        Self::weights,
        Self::undetermined,
        Self::insignificant,
    ];

    /// Adjusts the accepted rays and makes the checks.
    fn round(&mut self, loss: Loss, calm_rounds: usize) -> Result<Outcome, Error> {
        let weighted_by = self.weighted_by();
        self.weights.weigh_rays(&mut self.block, weighted_by);
        let network = self.network()?;
        let (gnss, control) = self.observed(weighted_by);
        let columns = self.columns(&gnss);
        let (systematic, constraints) = (self.systematic.clone(), self.constraints(&network, &columns, (&gnss, &control)));
        let axes = observed_axes(&self.block, self.options.datum, weighted_by);
        let held = (self.options.datum == Datum::Free).then(|| held_images(&network, &self.state));
        let known = KnownParameter::of_block(&self.block, &columns, weighted_by);
        let problem = Problem {
            network: &network,
            columns: &columns,
            gnss: &gnss,
            control: &control,
            axes: &axes,
            held,
            known: &known,
            systematic: &systematic,
            constraints: &constraints,
        };
        let tolerance = if loss == Loss::Squares || !self.options.snooping { TOLERANCE } else { ROBUST_TOLERANCE };
        // Parameters that are hardly determined creep; which they are, what was reached tells.
        let adjusted = self.adjusted(&problem, loss, tolerance, problem.columns.number() > 0)?;
        let mut round = Round { problem, adjusted, loss, calm_rounds, sigma_before: self.sigma, weighted_by, statistics: None };
        for check in Self::CHECKS {
            if let Some(outcome) = check(self, &mut round)? {
                return Ok(outcome);
            }
        }
        let shared = self.shared(&round)?;
        let last = self.adjusted(&round.problem, loss, LAST_TOLERANCE, true)?;
        if last.unsettled.is_none() {
            round.adjusted = last;
        }
        let sigma = self.round_error(&round);
        // Where nothing is weighted beside the rays their σ₀ is that of weight 1 all the same.
        let of_rays = round.statistics.as_ref().filter(|_| !self.is_weighted() && self.options.sigma0_px.is_none());
        let weighted_by = of_rays.and_then(|found| self.sigma0_of_rays(&found.rays)).unwrap_or(weighted_by);
        Ok(Outcome::Settled(Box::new(Settled {
            shared,
            sigma,
            block: self.block.clone(),
            components: self.weights.components(),
            redundancy: round.problem.redundancy() as usize,
            adjusted: round.adjusted,
            statistics: round.statistics.filter(|_| self.options.statistics),
            verdicts: self.verdicts.clone(),
            systematic: self.systematic_result(&round.problem),
            columns: columns.clone(),
            fixed: self.fixed.clone(),
            placed: self.placed.clone(),
            weighted_by,
            iterations: 0,
            rounds: 0,
            weighting: None,
        })))
    }

    /// σ₀ of a round.
    fn round_error(&self, round: &Round<'_>) -> f64 {
        round.statistics.as_ref().map_or(round.adjusted.sigma, |found| self.unit_error(&found.rays, &round.adjusted))
    }

    /// What the shared errors of a settled round add.
    fn shared(&self, round: &Round<'_>) -> Result<Option<SharedCofactors>, Error> {
        let Some(factored) = self.nearby.as_ref().filter(|_| self.options.statistics && self.options.shared_errors > 0.0) else {
            return Ok(None);
        };
        let reduced = round.problem.eliminated(&self.state, 0.0, round.adjusted.robust);
        shared_cofactors(&round.problem, &reduced, factored, &round.adjusted, &self.block).map(Some)
    }

    /// One adjustment from the present state, which becomes the adjusted one.
    fn adjusted(&mut self, problem: &Problem<'_>, loss: Loss, tolerance: f64, passing: bool) -> Result<Adjusted, Error> {
        let redundancy = problem.redundancy();
        if redundancy < 0 {
            let needed = problem.unknowns();
            return Err(Error::TooFew { few: Few::ObservedCoordinates, got: (needed as i64 + redundancy) as usize, needed });
        }
        let demand = Demand {
            loss,
            sigma: self.options.sigma0_px.unwrap_or(0.0),
            max_iterations: self.options.max_iterations,
            warm: self.iterations > 0,
            passing,
            tolerance,
        };
        let mut adjusted = problem.adjust(self.state.clone(), &demand, &mut self.nearby)?;
        self.iterations += adjusted.iterations;
        if problem.held.is_some() && adjusted.unsettled.is_none() {
            adjusted.state = moved_onto(problem.network, adjusted.state, &self.start)?;
        }
        self.state = adjusted.state.clone();
        Ok(adjusted)
    }

    fn creeping(&mut self, round: &mut Round<'_>) -> Result<Option<Outcome>, Error> {
        if round.adjusted.unsettled.is_none() {
            return Ok(None);
        }
        self.forget();
        self.sigma = round.adjusted.sigma;
        // What creeps although it is within the limit is still what is determined worst.
        let limit_px = self.options.calibration_limit_px;
        if self.fix_weakest(&round.problem, limit_px, Candidates::Unknown)?
            || self.fix_undetermined_error(&round.problem)?
            || self.fix_weakest(&round.problem, 0.0, Candidates::Unknown)?
            || self.fix_weakest(&round.problem, 0.0, Candidates::All)?
        {
            return Ok(Some(Outcome::Fixed));
        }
        round.adjusted.check_converged().map(|()| None)
    }

    fn impossible(&mut self, round: &mut Round<'_>) -> Result<Option<Outcome>, Error> {
        Ok(self.drop_impossible(&round.problem, round.adjusted.robust).then(|| self.changed(round, Unsettled::GrossErrors)))
    }

    fn by_earlier_cofactors(&mut self, round: &mut Round<'_>) -> Result<Option<Outcome>, Error> {
        if !self.options.snooping {
            return Ok(None);
        }
        let Some(rays) = self.judged_by_earlier(&round.problem, &round.adjusted, round.loss) else { return Ok(None) };
        if self.snoop(&rays, round.loss, round.calm_rounds) || round.loss != Loss::Squares {
            return Ok(Some(self.changed(round, Unsettled::GrossErrors)));
        }
        // What they find nothing wrong with is judged by its own cofactors, unless its weights are still on their way.
        let is_on_its_way = self.sigma0.is_some() && self.weighs_by_another(&rays, round);
        Ok(is_on_its_way.then_some(Outcome::Scaled))
    }

    fn by_own_cofactors(&mut self, round: &mut Round<'_>) -> Result<Option<Outcome>, Error> {
        let options = self.options;
        let mut is_snooped = false;
        if options.statistics || options.snooping {
            let (found, factored, orientations) = statistics(&round.problem, &round.adjusted, &self.block, &self.verdicts)?;
            self.sigma = self.scale(&found.rays, &round.adjusted, round.problem.redundancy());
            is_snooped = options.snooping && self.snoop(&found.rays, round.loss, round.calm_rounds);
            self.nearby = Some(factored);
            self.orientations = Some((round.loss, orientations));
            round.statistics = Some(found);
        } else {
            self.sigma = round.adjusted.sigma;
        }
        let is_reweighted =
            self.is_weighted() && self.sigma0.is_none() && (self.sigma - round.sigma_before).abs() > SETTLED_SIGMA * self.sigma;
        let found = round.statistics.as_ref().filter(|_| options.snooping);
        let is_replaced = found.is_some_and(|found| self.snoop_positions(found, round.weighted_by, round.calm_rounds));
        // What a robust loss leaves is judged again without it.
        let is_judged_again = options.snooping && round.loss != Loss::Squares;
        let what = match (is_replaced, is_snooped, is_reweighted, is_judged_again) {
            (true, ..) => Unsettled::Positions,
            (_, true, ..) => Unsettled::GrossErrors,
            (_, _, true, _) => Unsettled::Weights,
            (.., true) => Unsettled::GrossErrors,
            _ => return Ok(None),
        };
        self.settle_weights(round.sigma_before, what);
        Ok(Some(self.changed(round, what)))
    }

    /// Where weights alone change, and back and forth, those between come next: the residuals of a block that stated standard errors hold follow them
    /// so closely that their median would never settle.
    fn settle_weights(&mut self, sigma_before: f64, what: Unsettled) {
        let change = if matches!(what, Unsettled::Weights) { self.sigma - sigma_before } else { 0.0 };
        if change * self.sigma_change < 0.0 {
            self.sigma = (self.sigma * sigma_before).sqrt();
        }
        self.sigma_change = change;
    }

    fn weights(&mut self, round: &mut Round<'_>) -> Result<Option<Outcome>, Error> {
        let Some(found) = round.statistics.as_ref() else { return Ok(None) };
        let sums = sums_of_groups(&self.block, &round.problem, &round.adjusted.state, found, &self.verdicts);
        if !self.options.variance_components {
            self.weights.estimate(&sums, round.weighted_by);
            return Ok(None);
        }
        let changed = self.weights.update(&sums, round.weighted_by);
        if changed {
            self.weights.state_anew(&mut self.block, self.given);
            // What was rejected by other weights is judged by these.
            self.is_reconsidered = false;
        }
        Ok(changed.then_some(Outcome::Weighted))
    }

    /// What weighting groups took; `iterations`: those of its adjustments.
    fn weighting(&self, iterations: usize) -> GroupWeighting {
        GroupWeighting { rounds: self.weights.rounds, iterations, converged: self.weights.is_converged }
    }

    fn undetermined(&mut self, round: &mut Round<'_>) -> Result<Option<Outcome>, Error> {
        let is_fixed = self.fix_weakest(&round.problem, self.options.calibration_limit_px, Candidates::Unknown)?
            || self.fix_undetermined_error(&round.problem)?;
        Ok(is_fixed.then_some(Outcome::Fixed))
    }

    fn insignificant(&mut self, round: &mut Round<'_>) -> Result<Option<Outcome>, Error> {
        if round.problem.columns.systematic.is_empty() {
            return Ok(None);
        }
        let shared = self.shared(round)?;
        Ok(self.fix_insignificant(&round.problem, self.round_error(round), shared.as_ref())?.then_some(Outcome::Fixed))
    }

    fn weighted_by_another(&mut self, round: &mut Round<'_>) -> Result<Option<Outcome>, Error> {
        let Some(found) = round.statistics.as_ref().filter(|_| round.loss == Loss::Squares) else { return Ok(None) };
        Ok(self.weighs_by_another(&found.rays, round).then_some(Outcome::Scaled))
    }

    /// Weighs by σ₀ of the rays, with which the standard errors of what it weighs are those that were stated; whether it was another.
    fn weighs_by_another(&mut self, rays: &[Option<[Judged; 2]>], round: &Round<'_>) -> bool {
        if !self.is_weighted() {
            return false;
        }
        let Some(sigma0) = self.sigma0_of_rays(rays) else {
            self.sigma0 = None;
            return false;
        };
        let sigma0 = sigma0.max(LEAST_SIGMA_PX);
        let is_another = (sigma0 - round.weighted_by).abs() > SETTLED_SIGMA0 * sigma0 && self.weighings < MOST_WEIGHINGS;
        if is_another {
            // What was rejected by other weights is judged by these.
            self.is_reconsidered &= self.sigma0.is_some();
            self.sigma0 = Some(sigma0);
            self.weighings += 1;
        }
        is_another
    }

    /// Whether σ as it is estimated weighs anything.
    fn is_weighted(&self) -> bool {
        let is_observed = self.options.datum != Datum::Free || !self.block.camera_priors.is_empty() || self.weights.has_known_rays;
        is_observed && self.options.sigma0_px.is_none()
    }

    fn changed(&self, round: &Round<'_>, what: Unsettled) -> Outcome {
        Outcome::Changed { rejected: round.problem.network.sights.len().saturating_sub(self.accepted()), what }
    }
}
