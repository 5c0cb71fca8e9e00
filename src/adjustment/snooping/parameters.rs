//! Which camera parameters are estimated: those that the block hardly determines are fixed, one a camera and round.

use super::course::Course;
use crate::adjustment::axis::observed_axes;
use crate::adjustment::calibration::{effects, weakest_of_each};
use crate::adjustment::datum::held_images;
use crate::adjustment::loss::Robust;
use crate::adjustment::network::Columns;
use crate::adjustment::options::{Datum, Loss};
use crate::adjustment::reduced::{KnownParameter, Problem};
use crate::adjustment::result::FixedParameter;
use crate::adjustment::solution::{Factored, Singular};
use crate::{CameraParameter, Error};

/// Before the first adjustment a camera parameter is only fixed where it is this many times worse than the limit: σ₀ is not known yet.
const FIRST_TOLERANCE: f64 = 50.0;

impl Course<'_> {
    /// Fixes what the block does not determine at all, before anything is adjusted.
    pub fn fix_undetermined(&mut self) -> Result<(), Error> {
        if self.free.iter().flatten().all(|free| !free) {
            return Ok(());
        }
        let network = self.network()?;
        let (gnss, control) = self.observed(self.weighted_by());
        let axes = observed_axes(&self.block, self.options.datum, self.weighted_by());
        let held = (self.options.datum == Datum::Free).then(|| held_images(&network, &self.state));
        loop {
            let columns = Columns::new(&self.free);
            let known = KnownParameter::of_block(&self.block, &columns, self.weighted_by());
            let problem =
                Problem { network: &network, columns: &columns, gnss: &gnss, control: &control, axes: &axes, held, known: &known };
            let limit = FIRST_TOLERANCE * self.options.calibration_limit_px;
            let found = self.worse_than(&problem, limit, self.weighted_by())?;
            if found.is_empty() {
                return Ok(());
            }
            found.iter().for_each(|(column, effect)| self.fix(columns.parameter[*column], *effect));
        }
    }

    /// Fixes of each camera the parameter that is determined worst, where its effect exceeds a limit in px; whether there were any.
    pub fn fix_weakest(&mut self, problem: &Problem<'_>, limit_px: f64) -> Result<bool, Error> {
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
