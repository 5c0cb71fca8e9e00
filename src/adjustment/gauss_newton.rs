//! One adjustment of a given set of rays: damped Gauss-Newton steps until they vanish.

use super::axis::WeightedAxis;
use super::collinearity::project;
use super::datum::Freedoms;
use super::datum_part::DatumConstraint;
use super::loss::Robust;
use super::options::Loss;
use super::reduced::{KnownParameter, Problem};
use super::solution::{Factored, Singular, Step};
use super::state::State;
use super::weighted::Weighted;
use crate::math::{MEDIAN_LENGTH, median};
use crate::{CameraParameter, Cause, Computation, Error};

/// Adjusted values with how they were reached.
#[derive(Debug, Clone)]
pub(super) struct Adjusted {
    pub state: State,
    /// Standard error of a coordinate of weight 1 in px; 0 without redundancy.
    pub sigma: f64,
    /// The loss at the end, with its scale.
    pub robust: Robust,
    pub iterations: usize,
    /// Why the steps did not vanish, where that was allowed.
    pub unsettled: Option<Cause>,
    /// Root mean square of the last step in standard errors of the unknowns.
    pub last_step: f64,
}

/// What one adjustment is asked for.
pub(super) struct Demand {
    pub loss: Loss,
    /// Known standard error of a coordinate; 0: not known.
    pub sigma: f64,
    pub max_iterations: usize,
    /// A step of this root mean square, in standard errors of the unknowns, has converged.
    pub tolerance: f64,
    /// The start is an adjusted one of nearly the same rays: no damping is needed.
    pub warm: bool,
    /// Where it does not converge, what was reached serves: it is adjusted again later.
    pub passing: bool,
}

/// Share of the own diagonals that is added at first; it falls by `EASE` with each success and rises by `STIFFEN` with each failure.
const FIRST_DAMPING: f64 = 1e-4;
const EASE: f64 = 0.05;
const STIFFEN: f64 = 10.0;
/// Below this, damping is none; above `STIFFEST`, no step helps any more.
const LEAST_DAMPING: f64 = 1e-9;
const STIFFEST: f64 = 1e8;
/// A damped step says nothing of convergence above this.
const SLACK: f64 = 1e-3;

/// After so many iterations steps creep along what is hardly determined: they have converged where no unknown can have moved by more than
/// this share of its standard error.
const PATIENCE: usize = 20;
const CREEPING: f64 = 1e-2;
/// Where iterations are spent, a step in which none can have moved by more than this share is the last: standard errors tell the rest.
const LAST_CREEPING: f64 = 1e-1;

/// Residuals below this are rounding.
pub(super) const LEAST_SIGMA_PX: f64 = 1e-9;

impl Adjusted {
    /// Itself, unless it had to converge and did not.
    fn passed(self, demand: &Demand) -> Result<Self, Error> {
        if !demand.passing {
            self.check_converged()?;
        }
        Ok(self)
    }

    /// # Errors
    /// [`Error::NotConverged`] where it did not.
    pub fn check_converged(&self) -> Result<(), Error> {
        match &self.unsettled {
            Some(cause) => {
                Err(Error::NotConverged { computation: Computation::BundleAdjustment, iterations: self.iterations, cause: cause.clone() })
            }
            None => Ok(()),
        }
    }
}

/// The sums that decide whether a step is taken.
impl Problem<'_> {
    /// Observed minus computed coordinates of each sight.
    pub fn residuals(&self, state: &State) -> Vec<[f64; 2]> {
        let residual = |s: &super::network::Sight| {
            let at = project(&state.cameras[s.camera as usize], &state.images[s.image as usize], &state.points[s.point as usize]);
            [s.at[0] - at[0], s.at[1] - at[1]]
        };
        self.network.sights.iter().map(residual).collect()
    }

    /// Weighted squares of the residuals of each sight; infinite where the point lies in the plane of the perspective centre.
    fn squares(&self, state: &State) -> Vec<f64> {
        let square = |(s, [x, y]): (&super::network::Sight, [f64; 2])| {
            let square = s.weight * (x * x + y * y);
            if square.is_finite() { square } else { f64::INFINITY }
        };
        self.network.sights.iter().zip(self.residuals(state)).map(square).collect()
    }

    /// Weighted square sum of what the observed positions and the known axes are off.
    fn square_sum_of_positions(&self, state: &State) -> f64 {
        let square = |(prior, at): (&Option<Weighted>, &[f64; 3])| {
            prior.map_or(0.0, |p| (0..3).map(|k| p.weight[k] * (p.position[k] - at[k]) * (p.position[k] - at[k])).sum())
        };
        let antennas: Vec<[f64; 3]> = (0..state.images.len()).map(|image| self.systematic.antenna(state, image)).collect();
        let images: f64 = self.gnss.iter().zip(&antennas).map(square).sum();
        let axes: f64 = self.axes.iter().zip(&state.images).filter_map(|(axis, pose)| Some(axis.as_ref()?.square(pose))).sum();
        let sum = images + axes + self.control.iter().zip(&state.points).map(square).sum::<f64>();
        let held = |constraint: &DatumConstraint| {
            let sum = constraint.sum(self.columns, state);
            constraint.weight * sum * sum
        };
        self.constraints.iter().map(held).fold(sum, |sum, square| sum + square)
    }

    /// Weighted square sum of what the camera parameters are off from what was known of them.
    fn square_sum_of_cameras(&self, state: &State) -> f64 {
        let square = |(known, (camera, parameter)): (&KnownParameter, &(usize, usize))| {
            let off = known.value - state.cameras[*camera][*parameter];
            known.weight * off * off
        };
        self.known.iter().zip(&self.columns.parameter).map(square).sum()
    }

    /// Number of unknowns, the freedoms of a free network and what constraints take not counted.
    pub fn unknowns(&self) -> usize {
        let freedoms = if self.held.is_some() { 7 } else { 0 };
        6 * self.network.free_images() + 3 * self.network.used_points() + self.columns.number() - freedoms - self.constraints.len()
    }

    /// Number of observed coordinates beyond the unknowns; negative where some are missing.
    pub fn redundancy(&self) -> i64 {
        let positions: usize = self.gnss.iter().chain(self.control).flatten().map(Weighted::observed).sum();
        let axes = WeightedAxis::OBSERVED * self.axes.iter().flatten().count();
        let cameras = self.known.iter().filter(|known| known.weight > 0.0).count();
        (2 * self.network.sights.len() + positions + axes + cameras) as i64 - self.unknowns() as i64
    }

    fn step(&self, state: &State, damping: f64, robust: Robust, nearby: &mut Option<Factored>) -> Result<Step, Singular> {
        let mut reduced = self.reduce(state, damping, robust);
        let is_heavy = self.network.pattern.is_heavy();
        if let Some(step) = nearby.as_ref().filter(|_| is_heavy).and_then(|nearby| Step::near(self, &reduced, nearby)) {
            return Ok(step);
        }
        let factored = Factored::new(&self.network.pattern, &mut reduced)?;
        let step = Step::new(self, &reduced, &factored);
        *nearby = Some(factored).filter(|_| is_heavy);
        Ok(step)
    }

    fn robust_for(&self, demand: &Demand, squares: &[f64]) -> Robust {
        if demand.loss == Loss::Squares {
            return Robust::squares();
        }
        let middle = median(&mut squares.to_vec()).unwrap_or(0.0).sqrt() / MEDIAN_LENGTH;
        Robust::new(demand.loss, middle.max(demand.sigma).max(LEAST_SIGMA_PX))
    }

    /// Adjusts from a start. `nearby` is the factor of equations of the same pattern and cameras, if there is one; where factorisations are
    /// what takes the time, it serves as long as it leads to the steps, and a new one is put in its place where it does not.
    ///
    /// # Errors
    /// [`Error::NotConverged`]; [`Error::Degenerate`] where the equations are singular.
    ///
    /// # Source
    /// Levenberg 1944; Marquardt 1963; Triggs et al. 2000, Bundle adjustment: a modern synthesis.
    pub fn adjust(&self, start: State, demand: &Demand, nearby: &mut Option<Factored>) -> Result<Adjusted, Error> {
        let mut state = start;
        let mut damping = if demand.warm { 0.0 } else { FIRST_DAMPING };
        let mut squares = self.squares(&state);
        let mut last_step = f64::INFINITY;
        for iteration in 1..=demand.max_iterations {
            let robust = self.robust_for(demand, &squares);
            let cost = |state: &State, squares: &[f64]| {
                let rays = squares.iter().map(|s| robust.cost(*s)).sum::<f64>();
                rays + self.square_sum_of_positions(state) + self.square_sum_of_cameras(state)
            };
            let before = cost(&state, &squares);
            if !before.is_finite() {
                return Err(Error::Degenerate { computation: Computation::BundleAdjustment, cause: Cause::PointInPlane });
            }
            let sigma = (before / self.redundancy().max(1) as f64).sqrt();
            let share = match iteration {
                last if last == demand.max_iterations => LAST_CREEPING,
                late if late > PATIENCE => CREEPING,
                _ => 0.0,
            };
            let creeping = share / (self.unknowns() as f64).sqrt();
            loop {
                let step = match self.step(&state, damping, robust, nearby) {
                    Ok(step) => Some(step),
                    Err(singular) if damping >= 1.0 => return Err(self.singular(singular)),
                    Err(_) => None,
                };
                if let Some(mut step) = step {
                    if self.held.is_some() {
                        Freedoms::new(self.network, &state)?.constrain(&state, &mut step);
                    }
                    last_step = (step.square.max(0.0) / self.unknowns() as f64).sqrt() / sigma.max(LEAST_SIGMA_PX);
                    let trial = self.after(&state, &step);
                    let after = self.squares(&trial);
                    let converged = last_step < demand.tolerance.max(creeping) && (damping <= SLACK || sigma < LEAST_SIGMA_PX);
                    if converged || cost(&trial, &after) <= before {
                        (state, squares) = (trial, after);
                        damping = if damping * EASE < LEAST_DAMPING { 0.0 } else { damping * EASE };
                        if converged {
                            return Ok(self.settled(state, &squares, robust, iteration, last_step));
                        }
                        break;
                    }
                }
                damping = (damping * STIFFEN).max(LEAST_DAMPING);
                if damping > STIFFEST {
                    let reached = self.settled(state, &squares, robust, iteration, last_step);
                    return Adjusted { unsettled: Some(Cause::Stalled { last_step }), ..reached }.passed(demand);
                }
            }
        }
        let robust = self.robust_for(demand, &squares);
        let reached = self.settled(state, &squares, robust, demand.max_iterations, last_step);
        Adjusted { unsettled: Some(Cause::LongSteps { ratio: last_step / demand.tolerance }), ..reached }.passed(demand)
    }

    fn settled(&self, state: State, squares: &[f64], robust: Robust, iterations: usize, last_step: f64) -> Adjusted {
        let observed = self.square_sum_of_positions(&state) + self.square_sum_of_cameras(&state);
        let sum = squares.iter().map(|s| robust.factor(*s) * s).sum::<f64>() + observed;
        let redundancy = self.redundancy();
        let sigma = if redundancy > 0 { (sum / redundancy as f64).sqrt() } else { 0.0 };
        Adjusted { state, sigma, robust, iterations, unsettled: None, last_step }
    }

    /// The error of singular normal equations, by what they do not determine.
    pub fn singular(&self, singular: Singular) -> Error {
        match singular {
            Singular::Image(refused) => {
                let cause = if refused.unknown < 3 { Cause::NoRotation } else { Cause::NoPosition };
                Error::UndeterminedImage { computation: Computation::BundleAdjustment, image: refused.node, cause }
            }
            Singular::Column(column) => {
                let cause = match self.columns.parameter.get(column) {
                    Some((camera, parameter)) => {
                        Cause::NoCameraParameter { camera: *camera, camera_parameter: CameraParameter::ALL[*parameter] }
                    }
                    // Those that nothing determines are fixed before: what is left follows from positions that are none.
                    None => Cause::NoPosition,
                };
                Error::Degenerate { computation: Computation::BundleAdjustment, cause }
            }
        }
    }
}
