//! Which camera parameters are estimated: those that the block hardly determines are fixed, one a camera and round, unless prior information
//! holds them: their standard errors then say how little the block determines them.

use super::course::Course;
use crate::adjustment::axis::observed_axes;
use crate::adjustment::calibration::{effects, weakest_of_each};
use crate::adjustment::datum::held_images;
use crate::adjustment::loss::Robust;
use crate::adjustment::options::{Datum, Loss};
use crate::adjustment::reduced::{KnownParameter, Problem};
use crate::adjustment::result::FixedParameter;
use crate::adjustment::solution::{Factored, Singular};
use crate::{CameraParameter, Error};

/// Before the first adjustment a camera parameter is only fixed where it is this many times worse than the limit: σ₀ is not known yet.
const FIRST_TOLERANCE: f64 = 50.0;

/// Which camera parameters may be fixed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Candidates {
    /// Those without prior information.
    Unknown,
    /// All, where nothing else lets the adjustment converge.
    All,
}

impl Course<'_> {
    /// Fixes what the block does not determine at all, before anything is adjusted.
    pub fn fix_undetermined(&mut self) -> Result<(), Error> {
        if self.free.iter().flatten().all(|free| !free) && self.systematic.is_empty() {
            return Ok(());
        }
        let network = self.network()?;
        let (gnss, control) = self.observed(self.weighted_by());
        let axes = observed_axes(&self.block, self.options.datum, self.weighted_by());
        let held = (self.options.datum == Datum::Free).then(|| held_images(&network, &self.state));
        let systematic = self.systematic.clone();
        loop {
            let columns = self.columns(&gnss);
            let known = KnownParameter::of_block(&self.block, &columns, self.weighted_by());
            let constraints = self.constraints(&network, &columns, (&gnss, &control));
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
            let limit = FIRST_TOLERANCE * self.options.calibration_limit_px;
            let found = self.worse_than(&problem, limit, self.weighted_by(), Candidates::Unknown)?;
            found.iter().for_each(|(column, effect)| self.fix(columns.parameter[*column], *effect));
            if found.is_empty() && !self.fix_undetermined_error(&problem)? {
                return Ok(());
            }
        }
    }

    /// Fixes of each camera the parameter that is determined worst, where its effect exceeds a limit in px; whether there were any.
    pub fn fix_weakest(&mut self, problem: &Problem<'_>, limit_px: f64, candidates: Candidates) -> Result<bool, Error> {
        if problem.columns.parameter.is_empty() {
            return Ok(false);
        }
        let sigma = self.ray_error();
        let found = self.worse_than(problem, limit_px, sigma, candidates)?;
        found.iter().for_each(|(column, effect)| self.fix(problem.columns.parameter[*column], *effect));
        Ok(!found.is_empty())
    }

    /// Of each camera the column determined worst, where its effect in px (absent: unbounded) exceeds a limit.
    fn worse_than(
        &mut self,
        problem: &Problem<'_>,
        limit: f64,
        sigma: f64,
        candidates: Candidates,
    ) -> Result<Vec<(usize, Option<f64>)>, Error> {
        match self.factor(problem) {
            Err(Singular::Column(column)) if column < problem.columns.parameter.len() => return Ok(vec![(column, None)]),
            // A systematic error of positions, which is fixed after the cameras.
            Err(Singular::Column(_)) => return Ok(Vec::new()),
            Err(singular) => return Err(problem.singular(singular)),
            Ok(()) => {}
        }
        let Some(factored) = &self.nearby else { return Ok(Vec::new()) };
        let effects = effects(problem.network, &self.state);
        let is_held =
            |column: usize| candidates == Candidates::Unknown && problem.known.get(column).is_some_and(|known| known.weight > 0.0);
        let worst = weakest_of_each(&factored.cameras, &problem.columns.of_camera, &effects, sigma, is_held).into_iter();
        Ok(worst.filter(|(_, effect)| !(*effect <= limit)).map(|(column, effect)| (column, Some(effect))).collect())
    }

    /// Makes `nearby` the factor of the equations of least squares at the present values.
    pub fn factor(&mut self, problem: &Problem<'_>) -> Result<(), Singular> {
        // The statistics of least squares leave the factor of just these equations.
        let is_known = self.orientations.as_ref().is_some_and(|(loss, _)| *loss == Loss::Squares) && self.nearby.is_some();
        if !is_known {
            let mut reduced = problem.reduce(&self.state, 0.0, Robust::squares());
            self.nearby = Some(Factored::new(&problem.network.pattern, &mut reduced)?);
        }
        Ok(())
    }

    /// Fixes a camera parameter at the value that is known beforehand, or was given.
    fn fix(&mut self, (camera, parameter): (usize, usize), effect_px: Option<f64>) {
        self.forget();
        self.free[camera][parameter] = false;
        let known = self.block.camera_priors.iter().find(|prior| prior.camera == camera).filter(|prior| prior.sigma[parameter].is_some());
        self.state.cameras[camera][parameter] = known.map_or(self.start.cameras[camera][parameter], |known| known.values[parameter]);
        self.fixed[camera].push(FixedParameter { parameter: CameraParameter::ALL[parameter], effect_px });
    }
}
