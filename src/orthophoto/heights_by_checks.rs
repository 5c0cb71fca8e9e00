//! Whether the heights of an orthophoto's ground are as precise as is stated: heights that are off in a part of it pull the block there, and what contradicts them most
//! is rejected, so that residuals alone hardly show it. Places that take no part do.

use crate::math::{median, scatter};
use crate::pipeline::is_place_of_orthophoto;
use crate::{BlockRun, BlockWarning, ControlRole, SurveyedPoint};

/// Fewer places tell no scatter.
const LEAST_CHECKS: usize = 12;
/// Heights that scatter by more standard errors than this are not what is stated of them. Errors that neighbours share make it 1 where they are as large as is
/// stated, and matching on roofs and trees leaves less than half of the places so far off that the median holds.
const MOST_SCATTER: f64 = 3.0;

/// The scatter of differences about their median, as the standard deviation of normally distributed ones.
fn scatter_about_median(mut differences: Vec<f64>) -> Option<f64> {
    let middle = median(&mut differences)?;
    differences.iter_mut().for_each(|difference| *difference = (*difference - middle).abs());
    scatter(&mut differences)
}

/// What the places that check a block say of the heights, of which `stated_m` is stated.
fn told<'a>(surveyed: impl Iterator<Item = &'a SurveyedPoint>, stated_m: f64) -> Option<BlockWarning> {
    let checks = surveyed.filter(|point| point.role == ControlRole::Check && is_place_of_orthophoto(&point.name));
    let differences: Vec<f64> = checks.map(|point| point.difference_m[2]).filter(|difference| difference.is_finite()).collect();
    let checks = differences.len();
    let scatter_m = scatter_about_median(differences)?;
    let holds = checks < LEAST_CHECKS || scatter_m <= MOST_SCATTER * stated_m;
    (!holds).then_some(BlockWarning::OrthophotoHeightsScatter { checks, scatter_m, stated_m })
}

impl BlockRun {
    /// With what its check places say against the heights of the orthophoto's ground, of which `stated_m` is stated.
    pub(super) fn judged_by_checks(mut self, stated_m: f64) -> Self {
        if let Some(model) = self.reconstruction.as_mut().ok().and_then(|assembly| assembly.models.first_mut()) {
            model.warnings.extend(told(model.surveyed.iter(), stated_m));
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The warning on as many check places as there are heights above the block.
    fn said(heights_m: impl Iterator<Item = f64>) -> Option<BlockWarning> {
        let check = |(k, height_m): (usize, f64)| SurveyedPoint {
            name: format!("orthophoto_{k}"),
            role: ControlRole::Check,
            rays: 4,
            position: [0.0; 3],
            difference_m: [0.0, 0.0, height_m],
            standard_errors_m: [None; 3],
            left_out: None,
            detectable_m: [None; 3],
            refused: None,
        };
        told(heights_m.enumerate().map(check).collect::<Vec<_>>().iter(), 0.5)
    }

    #[test]
    fn heights_that_are_off_in_a_part_are_told_from_those_that_are_as_stated_and_from_roofs() {
        let right = |k: usize| 0.5 * ((k * 37 % 21) as f64 / 10.0 - 1.0);
        assert_eq!(said((0..60).map(right)), None);
        // A third of the places on roofs, and all heights off together: that is not theirs to say.
        assert_eq!(said((0..60).map(|k| right(k) + if k % 3 == 0 { 8.0 } else { 0.0 })), None);
        assert_eq!(said((0..60).map(|k| right(k) + 5.0)), None);
        let Some(BlockWarning::OrthophotoHeightsScatter { checks: 60, scatter_m, stated_m: 0.5 }) =
            said((0..60).map(|k| right(k) + if k < 30 { 5.0 } else { 0.0 }))
        else {
            panic!("not told")
        };
        assert!(scatter_m > 2.0, "{scatter_m}");
        assert_eq!(said((0..LEAST_CHECKS - 1).map(|k| 5.0 * (k % 2) as f64)), None);
    }
}
