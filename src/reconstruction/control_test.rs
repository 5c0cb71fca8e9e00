//! What the other observations say of the coordinates of one control point.
//!
//! # Source
//! Baarda 1968, A testing procedure for use in geodetic networks.

use super::mistake::Axis;
use crate::adjustment::{AdjustmentResult, PriorStatistics};

/// Below this redundancy nothing checks a coordinate.
const LEAST_REDUNDANCY: f64 = 1e-6;

/// What the other observations say of the coordinates of a control point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ControlTest {
    /// Where they have the point minus surveyed, coordinate by coordinate, in m: where it takes part, each with the other two as surveyed.
    pub difference: [f64; 3],
    /// Standard errors of that; infinite where nothing checks a coordinate.
    pub errors: [f64; 3],
    /// Errors that the tests find with a probability of 0.80.
    pub detectable: [Option<f64>; 3],
}

impl ControlTest {
    pub fn new(difference: [f64; 3], errors: [f64; 3], shift: f64) -> Self {
        let detectable = errors.map(|error| Some(shift * error).filter(|error| error.is_finite()));
        Self { difference, errors, detectable }
    }

    /// Beside a limit that is so many times as large, since the tests of all points scatter as much more.
    pub fn within(&self, scale: f64) -> Self {
        Self { detectable: self.detectable.map(|error| error.map(|error| scale * error)), ..*self }
    }

    pub fn values(&self) -> [f64; 3] {
        [0, 1, 2].map(|k| (self.difference[k] / self.errors[k]).abs())
    }

    /// The coordinate whose test is largest.
    pub fn axis(&self) -> Axis {
        let values = self.values();
        Axis::ALL.into_iter().max_by(|a, b| values[a.index()].total_cmp(&values[b.index()])).unwrap_or(Axis::X)
    }

    pub fn size(&self) -> f64 {
        self.values().into_iter().fold(0.0, f64::max)
    }
}

/// Whether the other observations have a point within chance: one that nothing tests is not known to be right.
pub(super) fn fits(test: Option<&ControlTest>, limit: f64) -> bool {
    test.is_some_and(|test| test.size() <= limit)
}

/// Of a control point that took part with these standard errors; `errors` are those of its adjusted place, which hold what the observations of an
/// image share.
pub(super) fn of_residuals(
    adjusted: &AdjustmentResult,
    statistics: &PriorStatistics,
    sigma: [f64; 3],
    errors: [f64; 3],
    shift: f64,
) -> Option<ControlTest> {
    let (redundancy, unit, by) = (statistics.redundancy?, adjusted.unit_error_px?, adjusted.weighted_by_px?);
    let of_tests = adjusted.sigma0_a_priori_px.or(adjusted.sigma0_px)?;
    let of = |k: usize| {
        let r = redundancy[k];
        if r < LEAST_REDUNDANCY {
            return (0.0, f64::INFINITY);
        }
        let of_residual = r * (sigma[k] * of_tests / by) * (sigma[k] * of_tests / by);
        let independent = (1.0 - r) * (sigma[k] * unit / by) * (sigma[k] * unit / by);
        let shared = if adjusted.shared_errors > 0.0 { (errors[k] * errors[k] - independent).max(0.0) } else { 0.0 };
        (-statistics.residual[k] / r, (of_residual + shared).sqrt() / r)
    };
    let of = [0, 1, 2].map(of);
    Some(ControlTest::new(of.map(|(difference, _)| difference), of.map(|(_, error)| error), shift))
}

#[cfg(test)]
mod tests {
    use super::{ControlTest, fits};

    #[test]
    fn a_point_that_nothing_tests_does_not_fit() {
        let test = ControlTest::new([0.02, 0.0, -0.03], [0.01; 3], 4.13);
        assert!(fits(Some(&test), 3.29) && !fits(Some(&test), 2.9));
        assert!(!fits(None, f64::MAX));
    }
}
