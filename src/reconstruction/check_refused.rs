//! Check points that differ from a block by more than chance and the scatter of the others explain.

use super::common_shift::shared_by_places;
use super::material::Known;
use super::mistake::Axis;
use super::result::{ReconstructedModel, SurveyedPoint};
use super::warning::BlockWarning;
use crate::ControlRole;
use crate::math::{normal_quantile, scatter};
use std::collections::BTreeSet;

/// Check points, at least, that tell the scatter of all: of fewer a wrong one makes up the median.
const LEAST_POINTS: usize = 3;

/// Of each that is wrong, or shows that the block is, the coordinate that differs the most. A good one of all of them is called wrong with the probability
/// of a test.
pub(super) fn of_wrong_checks(model: &ReconstructedModel, known: &Known<'_>) -> Vec<BlockWarning> {
    let own = known.options.tested_control.unwrap_or(known.description.control.len());
    let given: BTreeSet<&str> = known.description.control[..own].iter().map(|point| point.name.as_str()).collect();
    let shared = shared_by_places(known);
    let checks = model.surveyed.iter().filter(|point| point.role == ControlRole::Check && given.contains(point.name.as_str()));
    let judged: Vec<Judged<'_>> = checks.filter_map(|point| Judged::new(point, shared)).collect();
    let mut sizes: Vec<f64> = judged.iter().flat_map(|check| Axis::ALL.map(|axis| check.size(axis))).collect();
    // Standard errors that were stated too small make no point wrong.
    let scatter = scatter(&mut sizes).filter(|_| judged.len() >= LEAST_POINTS).map_or(1.0, |found| found.max(1.0));
    let limit = scatter * normal_quantile(1.0 - 0.5 * known.options.adjustment.alpha0 / sizes.len().max(1) as f64);
    judged.iter().filter(|check| check.size(check.worst()) > limit).map(|check| check.warning(known, limit)).collect()
}

/// A check point with the standard errors of its differences.
struct Judged<'a> {
    point: &'a SurveyedPoint,
    errors_m: [f64; 3],
}

impl<'a> Judged<'a> {
    fn new(point: &'a SurveyedPoint, shared: [f64; 3]) -> Option<Self> {
        let own = point.without()?.standard_errors;
        Some(Self { point, errors_m: [0, 1, 2].map(|k| libm::hypot(own[k], shared[k])) })
    }

    fn size(&self, axis: Axis) -> f64 {
        self.point.difference_m[axis.index()].abs() / self.errors_m[axis.index()]
    }

    fn worst(&self) -> Axis {
        Axis::ALL.into_iter().fold(Axis::X, |worst, axis| if self.size(axis) > self.size(worst) { axis } else { worst })
    }

    fn warning(&self, known: &Known<'_>, limit: f64) -> BlockWarning {
        let axis = self.worst();
        BlockWarning::CheckRefused {
            point: self.point.name.clone(),
            axis,
            difference_m: self.point.difference_m[axis.index()],
            error_m: self.errors_m[axis.index()],
            mistake: self.point.mistake(known.frame, [self.point.difference_m, self.errors_m], limit),
        }
    }
}
