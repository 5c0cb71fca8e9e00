//! The normal equations of an adjusted block, built and factored once more at its adjusted values: for what its result does not hold.

use super::axis::observed_axes;
use super::block::Block;
use super::datum::{Freedoms, held_images};
use super::datum_part::datum_constraints;
use super::loss::Robust;
use super::network::{Columns, Network};
use super::options::Datum;
use super::reduced::{KnownParameter, Problem, Reduced};
use super::result::{AdjustmentResult, CameraStatistics, ObservationGroup};
use super::shared::for_each_mode;
use super::solution::{Factored, Step};
use super::sparse::N;
use super::state::State;
use super::systematic::SystematicErrors;
use super::systematic_result::{SystematicStatistics, SystematicVerdict};
use super::weighted::observed;
use crate::error::refuse;
use crate::{Camera, CameraParameter, Error, Few, Refusal};

/// The factored equations at the adjusted values.
pub(super) struct Solved<'a> {
    pub problem: &'a Problem<'a>,
    pub reduced: &'a Reduced,
    pub state: &'a State,
    /// Of a free network.
    pub freedoms: Option<&'a Freedoms>,
    /// The standard error of an observation of weight 1, in px.
    pub unit_error: f64,
    factored: &'a Factored,
    block: &'a Block,
    /// The standard deviation of errors that the rays of an image share, in standard errors of an observation.
    shared_errors: f64,
}

impl Solved<'_> {
    /// What follows from a right-hand side of images and cameras, in the datum of the inner constraints where nothing else places the block. `of_point`: a
    /// point that has one of its own, which was eliminated from the others.
    pub fn solve(&self, mut images: Vec<f64>, mut cameras: Vec<f64>, of_point: Option<(usize, [f64; 3])>) -> Step {
        let Self { problem, reduced, state, .. } = self;
        let pattern = &problem.network.pattern;
        self.factored.solve(pattern, &mut images, &mut cameras);
        let right = |point: usize| of_point.filter(|(own, _)| *own == point).map_or([0.0; 3], |(_, right)| right);
        let points = (0..problem.network.points()).map(|point| reduced.back_substitute(problem, point, right(point), &images, &cameras));
        let points = points.collect();
        let images = pattern.place.iter().map(|at| std::array::from_fn(|k| images[*at as usize * N + k])).collect();
        let mut step = Step { images, cameras, points, square: 0.0 };
        if let Some(freedoms) = self.freedoms {
            freedoms.constrain(state, &mut step);
        }
        step
    }

    /// Gives what each mode of the errors that the rays of an image share does to the unknowns, with the share by which its square counts.
    pub fn for_each_shared(&self, mut take: impl FnMut(&Step, f64)) {
        if self.shared_errors > 0.0 {
            let at = (self.state, Robust::squares());
            let take = |step: &Step, share: f64| take(step, share * self.shared_errors * self.shared_errors);
            for_each_mode(self.problem, self.reduced, self.factored, at, self.block, self.freedoms, take);
        }
    }
}

impl AdjustmentResult {
    /// Hands over the equations. `block`: the adjusted one with all points by which it was adjusted, its own first; `accepted`: which of its rays took part.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for a project that a former version kept; [`Error::TooFew`] without redundancy, which leaves σ₀ unknown;
    /// [`Error::Degenerate`] where the normal equations are singular; those of `use_them`.
    pub(super) fn with_equations<T>(
        &self,
        block: &Block,
        accepted: &[bool],
        use_them: impl FnOnce(&Solved<'_>) -> Result<T, Error>,
    ) -> Result<T, Error> {
        // Of projects that former versions kept, the standard errors are those of other weights.
        let (Some(unit_error), Some(weighted_by)) = (self.unit_error_px, self.weighted_by_px) else {
            return refuse(Refusal::CovariancesUnsupported);
        };
        if unit_error <= 0.0 {
            return Err(Error::TooFew { few: Few::DegreesOfFreedom, got: self.degrees_of_freedom, needed: 1 });
        }
        let block = &self.as_weighted(block);
        let systematic = SystematicErrors::of_result(block, self.systematic.as_ref());
        let mut state = State::of(block).with_systematic(systematic.errors.len());
        let free = self.kept_errors(&mut state);
        let network = Network::new(block, accepted, None);
        let columns = Columns::new(&self.estimated()).with_systematic(&free);
        let (mut gnss, control) = observed(block, self.datum, weighted_by);
        let took_part = |image: usize| self.images[image].gnss.is_none_or(|gnss| gnss.accepted);
        gnss.iter_mut().enumerate().filter(|(image, _)| !took_part(*image)).for_each(|(_, prior)| *prior = None);
        let axes = observed_axes(block, self.datum, weighted_by);
        let held = (self.datum == Datum::Free).then(|| held_images(&network, &state));
        let known = KnownParameter::of_block(block, &columns, weighted_by);
        let constraints = datum_constraints(&network, &columns, &systematic, &state, (&gnss, &control));
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
        let mut reduced = problem.reduce(&state, 0.0, Robust::squares());
        let factored = Factored::new(&network.pattern, &mut reduced).map_err(|singular| problem.singular(singular))?;
        let freedoms = held.map(|_| Freedoms::new(&network, &state)).transpose()?;
        use_them(&Solved {
            problem: &problem,
            reduced: &reduced,
            state: &state,
            freedoms: freedoms.as_ref(),
            unit_error,
            factored: &factored,
            block,
            shared_errors: self.shared_errors,
        })
    }

    /// Which parameters of each camera were estimated.
    fn estimated(&self) -> Vec<[bool; 8]> {
        let of_camera = |(camera, statistics): (&Camera, &CameraStatistics)| {
            let mut free = camera.free.flags();
            for (k, parameter) in CameraParameter::ALL.iter().enumerate() {
                free[k] &= statistics.fixed.iter().all(|fixed| fixed.parameter != *parameter);
            }
            free
        };
        self.block.cameras.iter().zip(&self.cameras).map(of_camera).collect()
    }

    /// Puts the systematic errors of positions into a state that were kept; which of their values were estimated.
    fn kept_errors(&self, state: &mut State) -> Vec<[bool; 3]> {
        let errors = self.systematic.iter().flat_map(|systematic| &systematic.errors).zip(&mut state.systematic);
        let of_error = |(statistics, values): (&SystematicStatistics, &mut [f64; 3])| {
            if statistics.verdict != SystematicVerdict::Kept {
                return [false; 3];
            }
            *values = statistics.estimate;
            statistics.standard_errors.map(|error| error.is_some())
        };
        errors.map(of_error).collect()
    }

    /// A block with the standard errors of observed positions by which these were weighted.
    fn as_weighted(&self, block: &Block) -> Block {
        let factor = |group: ObservationGroup| self.components.iter().find(|c| c.group == group && c.applied).map_or(1.0, |c| c.factor);
        let [plan, height] = [factor(ObservationGroup::GnssPlan), factor(ObservationGroup::GnssHeight)];
        let mut block = block.clone();
        for gnss in block.images.iter_mut().filter_map(|image| image.gnss.as_mut()) {
            (0..3).for_each(|k| gnss.sigma[k] = gnss.sigma[k].map(|sigma| sigma * if k < 2 { plan } else { height }));
        }
        let control = self.factors_of_control();
        for point in &mut block.control {
            (0..3).for_each(|k| point.sigma[k] *= control[k]);
        }
        block
    }
}
