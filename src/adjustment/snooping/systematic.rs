//! Which systematic errors of GNSS positions are estimated: those that nothing determines are fixed at zero, and so are those that do not differ from
//! zero by more than chance, the least significant first.

use super::course::Course;
use crate::Error;
use crate::adjustment::datum_part::{DatumConstraint, datum_constraints};
use crate::adjustment::network::{Columns, Network};
use crate::adjustment::reduced::Problem;
use crate::adjustment::scale::variance_left;
use crate::adjustment::shared::SharedCofactors;
use crate::adjustment::significance::Estimates;
use crate::adjustment::solution::Singular;
use crate::adjustment::systematic_result::{SystematicResult, SystematicStatistics, SystematicVerdict};
use crate::adjustment::weighted::Weighted;
use crate::math::f_limit;

/// A value whose standard error is so many times that of a position is determined by nothing.
const MOST_ERRORS: f64 = 100.0;
/// Constraints that leave a value this share of the variance that it would have if all else were known leave nothing of it.
const LEAST_LEFT: f64 = 0.01;

impl Course<'_> {
    /// The columns of the camera parameters and of the systematic errors that are estimated, as far as positions that take part observe these.
    pub fn columns(&self, gnss: &[Option<Weighted>]) -> Columns {
        let observed = self.systematic.observed(gnss);
        let free: Vec<[bool; 3]> = self.estimated.iter().zip(observed).map(|(free, seen)| [0, 1, 2].map(|k| free[k] && seen[k])).collect();
        Columns::new(&self.free).with_systematic(&free)
    }

    /// Those that there were before any error was fixed.
    fn wanted(&self, gnss: &[Option<Weighted>]) -> Columns {
        Columns::new(&self.free).with_systematic(&self.systematic.observed(gnss))
    }

    /// What keeps the systematic errors apart from motions of the whole block.
    pub fn constraints(
        &self,
        network: &Network,
        columns: &Columns,
        observed: (&[Option<Weighted>], &[Option<Weighted>]),
    ) -> Vec<DatumConstraint> {
        datum_constraints(network, columns, &self.systematic, &self.state, observed)
    }

    /// Fixes the value of a systematic error that is determined worst, where nothing determines it; whether there was one.
    pub fn fix_undetermined_error(&mut self, problem: &Problem<'_>) -> Result<bool, Error> {
        let Some((error, axis)) = self.undetermined_error(problem)? else { return Ok(false) };
        self.fix_error(error, axis);
        Ok(true)
    }

    /// Fixes a value of a systematic error at zero, since nothing determines it.
    pub fn fix_error(&mut self, error: usize, axis: usize) {
        self.forget();
        self.estimated[error][axis] = false;
        self.state.systematic[error][axis] = 0.0;
    }

    fn undetermined_error(&mut self, problem: &Problem<'_>) -> Result<Option<(usize, usize)>, Error> {
        let columns = problem.columns;
        let first = columns.parameter.len();
        if columns.systematic.is_empty() {
            return Ok(None);
        }
        match self.factor(problem) {
            Err(Singular::Column(column)) => return Ok(columns.systematic.get(column.wrapping_sub(first)).copied()),
            Err(singular) => return Err(problem.singular(singular)),
            Ok(()) => {}
        }
        let Some(factored) = &self.nearby else { return Ok(None) };
        let (q, cofactors) = (columns.number(), factored.cameras.inverse());
        let of_positions = problem.gnss.iter().flatten().flat_map(|prior| prior.weight).filter(|weight| *weight > 0.0);
        let (number, sum) = of_positions.fold((0.0, 0.0), |(number, sum), weight| (number + 1.0, sum + weight));
        let information = information(problem, &self.state);
        let size = |k: usize| {
            let cofactor = cofactors[(first + k) * q + first + k].max(0.0);
            let is_held = !problem.constraints.is_empty() && information[k] * cofactor < LEAST_LEFT;
            if is_held { f64::INFINITY } else { (cofactor * sum / number).sqrt() }
        };
        let worst = (0..columns.systematic.len()).map(|k| (k, size(k))).max_by(|a, b| a.1.total_cmp(&b.1));
        Ok(worst.filter(|(_, size)| !(*size <= MOST_ERRORS)).map(|(k, _)| columns.systematic[k]))
    }

    /// Tests the systematic errors, each with its three values, and fixes those at zero that are not significant; whether there were any. `unit_error`
    /// is σ₀.
    pub fn fix_insignificant(&mut self, problem: &Problem<'_>, unit_error: f64, shared: Option<&SharedCofactors>) -> Result<bool, Error> {
        let (columns, first) = (problem.columns, problem.columns.parameter.len());
        if columns.systematic.is_empty() {
            return Ok(false);
        }
        self.factor(problem).map_err(|singular| problem.singular(singular))?;
        let Some(factored) = &self.nearby else { return Ok(false) };
        let (q, n, inverse) = (columns.number(), columns.systematic.len(), factored.cameras.inverse());
        let at = |k: usize| (first + k / n) * q + first + k % n;
        let redundancy = problem.redundancy().max(1) as usize;
        // As of all standard errors.
        let left = variance_left(&self.verdicts, redundancy, self.options.alpha0).sqrt();
        let (sigma, sigmas) = (self.options.sigma0_px.unwrap_or(unit_error / left) / left, self.options.shared_errors);
        let variance = |k: usize| inverse[at(k)] + shared.map_or(0.0, |shared| sigmas * sigmas * shared.cameras[at(k)]);
        let mut estimates = Estimates {
            values: columns.systematic.iter().map(|(error, axis)| self.state.systematic[*error][*axis]).collect(),
            cofactors: (0..n * n).map(|k| inverse[at(k)]).collect(),
            covariances: (0..n * n).map(|k| sigma * sigma * variance(k)).collect(),
        };
        let freedom = self.options.sigma0_px.is_none().then_some(redundancy);
        let limits = [1, 2, 3].map(|values| f_limit(self.options.alpha0, values, freedom));
        let of_error = |error: &usize| -> Vec<usize> { columns.of_systematic[*error].iter().flatten().map(|c| c - first).collect() };
        let mut open: Vec<usize> = (0..columns.of_systematic.len()).filter(|error| !of_error(error).is_empty()).collect();
        let mut is_fixed = false;
        loop {
            let tested: Vec<(usize, f64, f64)> = (open.iter())
                .map(|error| {
                    let own = of_error(error);
                    (*error, estimates.test(&own), limits[own.len() - 1])
                })
                .collect();
            for (error, test, limit) in &tested {
                let mut judged = SystematicStatistics::none(self.systematic.errors[*error], SystematicVerdict::Kept);
                (judged.test, judged.limit) = (Some(*test), Some(*limit));
                for axis in 0..3 {
                    let Some(column) = columns.of_systematic[*error][axis] else { continue };
                    judged.estimate[axis] = estimates.values[column - first];
                    judged.standard_errors[axis] = Some(estimates.standard_error(column - first));
                }
                self.judged[*error] = judged;
            }
            let least = tested.iter().min_by(|a, b| (a.1 / a.2).total_cmp(&(b.1 / b.2)));
            let Some((error, ..)) = least.filter(|(_, test, limit)| test <= limit) else { break };
            self.judged[*error].verdict = SystematicVerdict::NotSignificant;
            self.estimated[*error] = [false; 3];
            self.state.systematic[*error] = [0.0; 3];
            is_fixed = true;
            open.retain(|other| other != error);
            // One that is zero may place the others: then fewer constraints are needed, and what they leave is another.
            let observed = (problem.gnss, problem.control);
            let needed = || self.constraints(problem.network, &self.columns(problem.gnss), observed).len();
            if !problem.constraints.is_empty() && needed() != problem.constraints.len() {
                break;
            }
            match estimates.without(&of_error(error)) {
                Some(next) => estimates = next,
                None => break,
            }
        }
        if is_fixed {
            self.forget();
        }
        Ok(is_fixed)
    }

    /// What became of the systematic errors; absent where none were to be estimated.
    pub fn systematic_result(&self, problem: &Problem<'_>) -> Option<SystematicResult> {
        let result = |error: usize| {
            let judged = self.judged[error];
            let is_estimated = problem.columns.of_systematic[error].iter().any(Option::is_some);
            let is_undetermined = !is_estimated && judged.verdict == SystematicVerdict::Kept;
            if is_undetermined { SystematicStatistics::none(judged.error, SystematicVerdict::Undetermined) } else { judged }
        };
        (self.options.datum.uses_gnss() && self.systematic.is_wanted).then(|| SystematicResult {
            strips: if self.systematic.is_of_strips() { self.systematic.strips.clone() } else { Vec::new() },
            errors: (0..self.systematic.errors.len()).map(result).collect(),
            constraints: self.constraints(problem.network, &self.wanted(problem.gnss), (problem.gnss, problem.control)).len(),
            left_out: self.systematic.left_out.clone(),
        })
    }
}

/// What positions say of each systematic column where all else is known.
fn information(problem: &Problem<'_>, state: &crate::adjustment::state::State) -> Vec<f64> {
    let first = problem.columns.parameter.len();
    let mut sums = vec![0.0; problem.columns.systematic.len()];
    for (image, prior) in problem.gnss.iter().enumerate().filter_map(|(image, prior)| Some((image, prior.as_ref()?))) {
        for (column, slope) in problem.systematic.by_columns(problem.columns, state, image) {
            sums[column - first] += (0..3).map(|k| prior.weight[k] * slope[k] * slope[k]).sum::<f64>();
        }
    }
    sums
}
