//! Adjusts until the set of accepted rays and of estimated camera parameters has settled: robust first, then by least squares.

use super::adjustment::{Adjusted, Demand, LEAST_SIGMA_PX};
use super::block::Block;
use super::calibration::{effects, weakest_of_each};
use super::check::check_network;
use super::collinearity::{CAMERA_PARAMETERS, in_photo};
use super::datum::{Weighted, held_images, moved_onto, moved_to_observed, observed};
use super::loss::Robust;
use super::misplaced::placed_now;
use super::network::{Columns, Network};
use super::options::{BundleOptions, Datum, Loss};
use super::precision::Orientations;
use super::reduced::Problem;
use super::reliability::{Judged, of_position};
use super::result::{FixedParameter, RayVerdict};
use super::scale::sigma_by_median;
use super::solution::{Factored, Singular};
use super::sparse::Pattern;
use super::state::{State, free_of};
use super::statistics::{Statistics, judge_by, statistics};
use crate::{CameraParameter, Cause, Error, Task, Unsettled};
use std::rc::Rc;

/// Rounds with the robust loss, and in all but for those that fix camera parameters.
const ROBUST_ROUNDS: usize = 10;
const MAX_ROUNDS: usize = 40;
/// Where a robust round rejects no more than this share of the rays, least squares can go on.
const FEW_GROSS_ERRORS: f64 = 0.01;
/// Rounds of least squares in which rejected rays may come back; then they may once more at most, so that the rounds end.
const FREE_ROUNDS: usize = 2;

/// Steps of robust rounds need not be as small, in standard errors, as those of the last.
const ROBUST_TOLERANCE: f64 = 1e-2;
const TOLERANCE: f64 = 1e-4;

/// Before the first adjustment a camera parameter is only fixed where it is this many times worse than the limit: σ₀ is not known yet.
const FIRST_TOLERANCE: f64 = 50.0;

/// A σ₀ that weights observed positions has settled when it changes by less than this share.
const SETTLED_SIGMA: f64 = 0.02;

/// No more than this share of the positions that agree at the start are refused later, or none.
const MANY_WRONG: f64 = 0.15;

/// Cofactors of an earlier round serve as long as they tell the same σ₀ but for this share.
const ALIKE_SIGMA: f64 = 0.03;

/// Below this redundancy the median alone is no estimate.
const FEW: i64 = 20;

/// A settled adjustment.
pub(super) struct Settled {
    pub adjusted: Adjusted,
    pub statistics: Option<Statistics>,
    pub verdicts: Vec<RayVerdict>,
    pub columns: Columns,
    pub fixed: Vec<Vec<FixedParameter>>,
    pub redundancy: usize,
    /// Whether the GPS position of each image took part, where it has one.
    pub placed: Vec<bool>,
    /// Standard error of a coordinate of weight 1 that the observed positions were weighted by.
    pub weighted_by: f64,
    pub iterations: usize,
    pub rounds: usize,
}

/// What changes from round to round.
struct Course<'a> {
    block: &'a Block,
    options: &'a BundleOptions,
    verdicts: Vec<RayVerdict>,
    free: Vec<[bool; CAMERA_PARAMETERS]>,
    fixed: Vec<Vec<FixedParameter>>,
    /// Whether the GPS position of each image takes part.
    placed: Vec<bool>,
    /// Those that agreed at the start, and whether all these are kept: too many were refused since.
    agreed: Vec<bool>,
    keeps_agreed: bool,
    /// Whether rejected rays were taken back after the first rounds.
    is_reconsidered: bool,
    start: State,
    /// How many rays were accepted at the start.
    rays_at_start: usize,
    state: State,
    /// Standard error of a coordinate as the last round saw it; 0 at first.
    sigma: f64,
    iterations: usize,
    /// What of earlier rounds serves as long as the rays are nearly the same: the pattern of the equations, a factor, the cofactors of
    /// orientations. The cofactors are those of one loss.
    pattern: Option<Rc<Pattern>>,
    nearby: Option<Factored>,
    orientations: Option<(Loss, Orientations)>,
}

/// Adjusts a block until nothing changes any more.
///
/// # Errors
/// Those of [`adjust_block`](crate::adjust_block), but for what its input alone tells.
pub(super) fn settle(block: &Block, options: &BundleOptions) -> Result<Settled, Error> {
    let start = State::of(block);
    let verdicts = block.rays.iter().map(|ray| in_front(&start, ray.image, ray.point)).collect();
    let free = block.cameras.iter().map(free_of).collect();
    let fixed = vec![Vec::new(); block.cameras.len()];
    let mut course = Course {
        block,
        options,
        verdicts,
        free,
        fixed,
        placed: vec![true; block.images.len()],
        agreed: vec![true; block.images.len()],
        keeps_agreed: false,
        is_reconsidered: false,
        state: start.clone(),
        start,
        rays_at_start: 0,
        sigma: 0.0,
        iterations: 0,
        pattern: None,
        nearby: None,
        orientations: None,
    };
    course.lose_points();
    course.rays_at_start = course.verdicts.iter().filter(|v| **v == RayVerdict::Accepted).count();
    if options.datum != Datum::Free {
        let network = course.network()?;
        (course.state, course.placed) = moved_to_observed(block, &network, &course.state, options.datum)?;
        course.agreed = course.placed.clone();
    }
    course.fix_undetermined()?;
    let mut robust = options.loss != Loss::Squares;
    let (mut calm_rounds, mut rounds, mut fixing) = (0, 0, 0);
    let mut last = Unsettled::GrossErrors;
    while rounds - fixing < MAX_ROUNDS {
        rounds += 1;
        let loss = if robust { options.loss } else { Loss::Squares };
        let outcome = course.round(loss, calm_rounds)?;
        calm_rounds += usize::from(!robust);
        match outcome {
            Outcome::Fixed => fixing += 1,
            Outcome::Changed { rejected, what } => {
                last = what;
                let few = rejected as f64 <= FEW_GROSS_ERRORS * block.rays.len() as f64;
                robust &= !(options.snooping && (few || rounds - fixing >= ROBUST_ROUNDS));
            }
            Outcome::Settled(mut settled) => {
                settled.rounds = rounds;
                return Ok(*settled);
            }
        }
    }
    let cause = Cause::Unsettled { unsettled: last, rounds: MAX_ROUNDS };
    Err(Error::NotConverged { task: Task::BundleAdjustment, iterations: course.iterations, cause })
}

enum Outcome {
    /// Rays, observed positions or weights are others now; so many rays were rejected.
    Changed {
        rejected: usize,
        what: Unsettled,
    },
    /// Camera parameters were fixed, and nothing else changed.
    Fixed,
    Settled(Box<Settled>),
}

/// The verdict of a point's place alone.
fn in_front(state: &State, image: usize, point: usize) -> RayVerdict {
    let [_, _, w] = in_photo(&state.images[image], &state.points[point]);
    if w < 0.0 { RayVerdict::Accepted } else { RayVerdict::Behind }
}

impl Course<'_> {
    fn network(&mut self) -> Result<Network, Error> {
        let accepted: Vec<bool> = self.verdicts.iter().map(|v| *v == RayVerdict::Accepted).collect();
        let network = Network::new(self.block, &accepted, self.pattern.as_ref());
        if !self.pattern.as_ref().is_some_and(|pattern| Rc::ptr_eq(pattern, &network.pattern)) {
            self.pattern = Some(network.pattern.clone());
            self.forget();
        }
        check_network(&network, self.options.datum)?;
        Ok(network)
    }

    /// Forgets what equations of another pattern or of other cameras left.
    fn forget(&mut self) {
        (self.nearby, self.orientations) = (None, None);
    }

    /// The standard error of a ray that weights observed positions.
    fn weighted_by(&self) -> f64 {
        self.options.sigma0_px.unwrap_or(if self.sigma > 0.0 { self.sigma } else { 1.0 })
    }

    /// Adjusts the accepted rays and says whether everything stays as it is.
    fn round(&mut self, loss: Loss, calm_rounds: usize) -> Result<Outcome, Error> {
        let network = self.network()?;
        let columns = Columns::new(&self.free);
        let weighted_by = self.weighted_by();
        let (gps, control) = self.observed(weighted_by);
        let is_free = self.options.datum == Datum::Free;
        let held = is_free.then(|| held_images(&network, &self.state));
        let problem = Problem { network: &network, columns: &columns, gps: &gps, control: &control, held, known: &[] };
        let demand = Demand {
            loss,
            sigma: self.options.sigma0_px.unwrap_or(0.0),
            max_iterations: self.options.max_iterations,
            warm: self.iterations > 0,
            // Parameters that are hardly determined creep; which they are, what was reached tells.
            passing: columns.number() > 0,
            tolerance: if loss == Loss::Squares || !self.options.snooping { TOLERANCE } else { ROBUST_TOLERANCE },
        };
        let accepted = network.sights.len();
        let redundancy = problem.redundancy();
        if redundancy < 0 {
            let needed = problem.unknowns();
            return Err(Error::TooFew { what: "observed coordinates", got: (needed as i64 + redundancy) as usize, needed });
        }
        let mut adjusted = problem.adjust(self.state.clone(), &demand, &mut self.nearby)?;
        self.iterations += adjusted.iterations;
        if adjusted.unsettled.is_some() {
            self.forget();
            (self.state, self.sigma) = (adjusted.state.clone(), adjusted.sigma);
            // What creeps although it is within the limit is still what is determined worst.
            let fixed = self.fix_weakest(&problem, self.options.calibration_limit_px)? || self.fix_weakest(&problem, 0.0)?;
            return if fixed { Ok(Outcome::Fixed) } else { adjusted.converged().map(|_| Outcome::Fixed) };
        }
        if is_free {
            adjusted.state = moved_onto(&network, adjusted.state, &self.start)?;
        }
        self.state = adjusted.state.clone();
        if self.drop_impossible(&problem, adjusted.robust) {
            return Ok(Outcome::Changed { rejected: self.rejected_of(accepted), what: Unsettled::GrossErrors });
        }
        let before = self.sigma;
        if self.options.snooping && self.snoop_by_earlier(&problem, &adjusted, loss, calm_rounds) {
            return Ok(Outcome::Changed { rejected: self.rejected_of(accepted), what: Unsettled::GrossErrors });
        }
        let mut by_statistics = None;
        let mut snooped = false;
        if self.options.statistics || self.options.snooping {
            let (found, factored, orientations) = statistics(&problem, &adjusted, self.block, &self.verdicts)?;
            self.sigma = self.scale(&found.rays, &adjusted, redundancy);
            snooped = self.options.snooping && self.snoop(&found.rays, loss, calm_rounds);
            self.nearby = Some(factored);
            self.orientations = Some((loss, orientations));
            by_statistics = Some(found);
        } else {
            self.sigma = adjusted.sigma;
        }
        // What a robust loss leaves is judged again without it.
        let is_last = !self.options.snooping || loss == Loss::Squares;
        let reweighted = !is_free && self.options.sigma0_px.is_none() && (self.sigma - before).abs() > SETTLED_SIGMA * self.sigma;
        let replaced = self.options.snooping && by_statistics.as_ref().is_some_and(|s| self.snoop_positions(s, weighted_by, calm_rounds));
        if snooped || replaced || reweighted || !is_last {
            let what = if replaced {
                Unsettled::Positions
            } else if reweighted && !snooped {
                Unsettled::Weights
            } else {
                Unsettled::GrossErrors
            };
            return Ok(Outcome::Changed { rejected: self.rejected_of(accepted), what });
        }
        if self.fix_weakest(&problem, self.options.calibration_limit_px)? {
            return Ok(Outcome::Fixed);
        }
        let settled = Settled {
            adjusted,
            statistics: by_statistics.filter(|_| self.options.statistics),
            verdicts: self.verdicts.clone(),
            columns: columns.clone(),
            fixed: self.fixed.clone(),
            placed: self.placed.clone(),
            redundancy: redundancy as usize,
            weighted_by,
            iterations: self.iterations,
            rounds: 0,
        };
        Ok(Outcome::Settled(Box::new(settled)))
    }

    /// The observed positions of images and points that take part.
    fn observed(&self, weighted_by: f64) -> (Vec<Option<Weighted>>, Vec<Option<Weighted>>) {
        let (mut gps, control) = observed(self.block, self.options.datum, weighted_by);
        gps.iter_mut().zip(&self.placed).filter(|(_, placed)| !**placed).for_each(|(prior, _)| *prior = None);
        (gps, control)
    }

    /// How many fewer rays than before are accepted.
    fn rejected_of(&self, accepted: usize) -> usize {
        accepted.saturating_sub(self.verdicts.iter().filter(|v| **v == RayVerdict::Accepted).count())
    }

    /// Snoops by the cofactors that an earlier round left, as long as the loss is the same; whether that settles what to do next. What they
    /// find nothing wrong with is judged by its own cofactors.
    fn snoop_by_earlier(&mut self, problem: &Problem<'_>, adjusted: &Adjusted, loss: Loss, calm_rounds: usize) -> bool {
        let Some((of_loss, orientations)) = self.orientations.as_ref().filter(|(of_loss, _)| *of_loss == loss) else { return false };
        let is_robust = *of_loss != Loss::Squares;
        let judged = judge_by(orientations, problem, adjusted, self.block, &self.verdicts);
        let sigma = self.scale(&judged.rays, adjusted, problem.redundancy());
        // Where something is hardly determined, small steps make large cofactors others: then they no longer serve.
        if (sigma - self.sigma).abs() > ALIKE_SIGMA * self.sigma {
            return false;
        }
        self.sigma = sigma;
        self.snoop(&judged.rays, loss, calm_rounds) || is_robust
    }

    /// The standard error of a ray by which rays are judged.
    fn scale(&self, rays: &[Option<[Judged; 2]>], adjusted: &Adjusted, redundancy: i64) -> f64 {
        let by_median = sigma_by_median(rays, &self.verdicts, self.rays_at_start, self.options.limit());
        // A median of a few residuals may be far too small by chance, more easily than their σ.
        if redundancy < FEW { by_median.max(adjusted.sigma) } else { by_median }
    }

    /// Rejects the worst ray of each point that exceeds the limit, and takes back what no longer does: in the first rounds, and once more when
    /// nothing is left to reject, for what fell by errors that were found after it. Whether anything changed.
    fn snoop(&mut self, rays: &[Option<[Judged; 2]>], loss: Loss, calm_rounds: usize) -> bool {
        let limit = self.options.limit() * self.sigma.max(self.options.sigma0_px.unwrap_or(0.0)).max(LEAST_SIGMA_PX);
        let sizes = rays.iter().map(|judged| judged.map(|[x, y]| x.standardised.abs().max(y.standardised.abs())));
        let before = self.verdicts.clone();
        let mut worst: Vec<Option<(usize, f64)>> = vec![None; self.block.points.len()];
        let mut fitting = Vec::new();
        for (ray, size) in sizes.enumerate() {
            let Some(size) = size else { continue };
            match before[ray] {
                RayVerdict::Accepted if size > limit => {
                    let worst = &mut worst[self.block.rays[ray].point];
                    if worst.is_none_or(|(_, other)| size > other) {
                        *worst = Some((ray, size));
                    }
                }
                RayVerdict::GrossError if size <= limit => fitting.push(ray),
                _ => {}
            }
        }
        let is_last = !self.is_reconsidered && calm_rounds >= FREE_ROUNDS && worst.iter().all(Option::is_none);
        if loss == Loss::Squares && (calm_rounds < FREE_ROUNDS || is_last) {
            self.is_reconsidered |= is_last && !fitting.is_empty();
            for ray in fitting {
                self.verdicts[ray] = in_front(&self.state, self.block.rays[ray].image, self.block.rays[ray].point);
            }
        }
        worst.iter().flatten().for_each(|(ray, _)| self.verdicts[*ray] = RayVerdict::GrossError);
        self.lose_points();
        self.verdicts != before
    }

    /// Refuses GPS positions that lie too far off and takes back those that no longer do; whether there were any.
    fn snoop_positions(&mut self, statistics: &Statistics, weighted_by: f64, calm_rounds: usize) -> bool {
        if self.keeps_agreed {
            return false;
        }
        let (gps, control) = observed(self.block, self.options.datum, weighted_by);
        let sigma = self.options.sigma0_px.unwrap_or(self.sigma).max(LEAST_SIGMA_PX);
        let judge = |(image, prior): (usize, &Option<Weighted>)| {
            let at = &self.state.images[image].position;
            prior.map(|prior| of_position(&prior, at, Some(statistics.of_position(image)), sigma, self.placed[image]))
        };
        let judged: Vec<_> = gps.iter().enumerate().map(judge).collect();
        let surveyed = control.iter().flatten().count();
        let now = placed_now(&judged, &self.placed, surveyed, self.options.limit(), calm_rounds < FREE_ROUNDS);
        // A block that contradicts many positions is wrong itself, in cameras that it does not determine say.
        let refused = now.iter().zip(&self.agreed).filter(|(now, agreed)| **agreed && !**now).count();
        self.keeps_agreed = refused as f64 > MANY_WRONG * judged.iter().flatten().count() as f64;
        let now = if self.keeps_agreed { self.agreed.clone() } else { now };
        let changed = now != self.placed;
        if changed {
            self.placed = now;
            self.forget();
        }
        changed
    }

    /// Rejects rays to points behind their images and of points that their rays do not determine; whether there were any.
    fn drop_impossible(&mut self, problem: &Problem<'_>, robust: Robust) -> bool {
        let before = self.verdicts.clone();
        for (ray, verdict) in self.block.rays.iter().zip(&mut self.verdicts) {
            if *verdict == RayVerdict::Accepted {
                *verdict = in_front(&self.state, ray.image, ray.point);
            }
        }
        for point in problem.undetermined_points(&self.state, robust) {
            for sight in problem.network.of_point(point) {
                self.verdicts[sight.ray as usize] = RayVerdict::LostPoint;
            }
        }
        self.lose_points();
        self.verdicts != before
    }

    /// Points with fewer than two accepted rays take no part; a surveyed position that the datum uses counts as one.
    fn lose_points(&mut self) {
        let mut rays = vec![0_usize; self.block.points.len()];
        let accepted = |verdict: &RayVerdict| *verdict == RayVerdict::Accepted;
        for (ray, _) in self.block.rays.iter().zip(&self.verdicts).filter(|(_, v)| accepted(v)) {
            rays[ray.point] += 1;
        }
        for control in self.block.control.iter().filter(|_| self.options.datum.uses_control()) {
            rays[control.point] += 1;
        }
        for (ray, verdict) in self.block.rays.iter().zip(&mut self.verdicts) {
            if accepted(verdict) && rays[ray.point] < 2 {
                *verdict = RayVerdict::LostPoint;
            }
        }
    }

    /// Fixes what the block does not determine at all, before anything is adjusted.
    fn fix_undetermined(&mut self) -> Result<(), Error> {
        if self.free.iter().flatten().all(|free| !free) {
            return Ok(());
        }
        let network = self.network()?;
        let (gps, control) = self.observed(self.weighted_by());
        let held = (self.options.datum == Datum::Free).then(|| held_images(&network, &self.state));
        loop {
            let columns = Columns::new(&self.free);
            let problem = Problem { network: &network, columns: &columns, gps: &gps, control: &control, held, known: &[] };
            let limit = FIRST_TOLERANCE * self.options.calibration_limit_px;
            let found = self.worse_than(&problem, limit, self.weighted_by())?;
            if found.is_empty() {
                return Ok(());
            }
            found.iter().for_each(|(column, effect)| self.fix(columns.parameter[*column], *effect));
        }
    }

    /// Fixes of each camera the parameter that is determined worst, where its effect exceeds a limit in px; whether there were any.
    fn fix_weakest(&mut self, problem: &Problem<'_>, limit_px: f64) -> Result<bool, Error> {
        if problem.columns.number() == 0 {
            return Ok(false);
        }
        let sigma = self.options.sigma0_px.unwrap_or(self.sigma);
        let found = self.worse_than(problem, limit_px, sigma)?;
        found.iter().for_each(|(column, effect)| self.fix(problem.columns.parameter[*column], *effect));
        Ok(!found.is_empty())
    }

    /// Of each camera the column determined worst, where its effect in px (absent: unbounded) exceeds a limit.
    fn worse_than(&mut self, problem: &Problem<'_>, limit: f64, sigma: f64) -> Result<Vec<(usize, Option<f64>)>, Error> {
        // The statistics of least squares leave the factor of just these equations.
        let is_known = self.orientations.as_ref().is_some_and(|(loss, _)| *loss == Loss::Squares) && self.nearby.is_some();
        if !is_known {
            let mut reduced = problem.reduce(&self.state, 0.0, Robust::squares());
            match Factored::new(&problem.network.pattern, &mut reduced) {
                Err(Singular::Camera(column)) => return Ok(vec![(column, None)]),
                Err(singular) => return Err(problem.singular(singular)),
                Ok(factored) => self.nearby = Some(factored),
            }
        }
        let Some(factored) = &self.nearby else { return Ok(Vec::new()) };
        let effects = effects(problem.network, &self.state);
        let worst = weakest_of_each(&factored.cameras, &problem.columns.of_camera, &effects, sigma).into_iter();
        Ok(worst.filter(|(_, effect)| !(*effect <= limit)).map(|(column, effect)| (column, Some(effect))).collect())
    }

    /// Fixes a camera parameter at the value that was given.
    fn fix(&mut self, (camera, parameter): (usize, usize), effect_px: Option<f64>) {
        self.forget();
        self.free[camera][parameter] = false;
        self.state.cameras[camera][parameter] = self.start.cameras[camera][parameter];
        self.fixed[camera].push(FixedParameter { parameter: CameraParameter::ALL[parameter], effect_px });
    }
}
