//! Whether check points lie apart from the block all together, as heights of another zero have it.
//!
//! Each of them may differ within its standard error, while they cannot by chance differ alike: the standard error of what they have in common
//! follows from their covariances, since errors of the block are common to them.

use super::material::Known;
use super::mistake::Axis;
use super::result::{PointSource, ReconstructedModel, SurveyedPoint};
use super::warning::BlockWarning;
use crate::adjustment::{Part, Unknown};
use crate::math::{MEDIAN_BY_MEAN, median};
use crate::{BlockDescription, ControlRole};
use std::collections::BTreeMap;

/// So many points, at most, tell it: each column of their covariances is solved for.
const MOST_POINTS: usize = 60;

/// What some points have in common of their differences from the block.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct CommonShift {
    /// Median of the differences, adjusted minus surveyed, in m: one wrong point among several does not move it.
    pub difference_m: [f64; 3],
    /// Its standard errors.
    pub errors_m: [f64; 3],
    pub points: usize,
}

impl CommonShift {
    /// Of the check points of a model; absent without any, and without statistics. `own`: of the points so many, the first, were given; places of
    /// an orthophoto are behind them.
    pub(crate) fn of_checks(model: &ReconstructedModel, description: &BlockDescription, own: usize) -> Option<Self> {
        let place_of = |source: &PointSource| match source {
            PointSource::GroundControl(index) if *index < own => Some(description.control[*index].name.as_str()),
            _ => None,
        };
        let named = model.points.iter().enumerate().filter_map(|(place, source)| Some((place_of(source)?, place)));
        let named: BTreeMap<&str, usize> = named.collect();
        let check = |point: &'_ SurveyedPoint| {
            let is_check = point.role == ControlRole::Check && point.standard_errors_m.iter().all(Option::is_some);
            named.get(point.name.as_str()).copied().filter(|_| is_check)
        };
        let all: Vec<(&SurveyedPoint, usize)> = model.surveyed.iter().filter_map(|point| Some((point, check(point)?))).collect();
        let step = all.len().div_ceil(MOST_POINTS).max(1);
        let (points, places): (Vec<&SurveyedPoint>, Vec<usize>) = all.into_iter().step_by(step).unzip();
        let parts: Vec<Part> = places.iter().map(|place| Part::Point(*place)).collect();
        let (block, accepted) = model.with_support();
        let covariances = model.adjusted.covariances(&block, &accepted, &parts).ok().filter(|_| !points.is_empty())?;
        let variance = |k: usize| {
            let of_axis = |(_, unknown, _): &(usize, Unknown, f64)| *unknown == Unknown::Coordinate(k);
            let own: Vec<usize> = (0..covariances.unknowns.len()).filter(|at| of_axis(&covariances.unknowns[*at])).collect();
            let of_block: f64 = own.iter().map(|row| own.iter().map(|column| covariances.rows[*row][*column]).sum::<f64>()).sum();
            let of_places: f64 = own.iter().map(|at| covariances.rows[*at][*at]).sum();
            let of_survey = points.iter().zip(&places).map(|(point, place)| {
                let (whole, own) = (point.standard_errors_m[k].unwrap_or(0.0), model.adjusted.points[*place].and_then(|is| is.errors));
                (whole * whole - own.map_or(0.0, |own| own[k] * own[k])).max(0.0)
            });
            let of_survey: f64 = of_survey.sum();
            variance_of_median(points.len(), of_block + of_survey, of_places + of_survey)
        };
        let difference = |k: usize| median(&mut points.iter().map(|point| point.difference_m[k]).collect::<Vec<_>>());
        let [x, y, z] = [0, 1, 2].map(difference);
        let errors_m = [0, 1, 2].map(|k| variance(k).max(0.0).sqrt());
        Some(Self { difference_m: [x?, y?, z?], errors_m, points: points.len() })
    }
}

/// The variance of the median of differences. `of_sum`: that of their sum, by all of their covariances; `together`: theirs, added up.
///
/// What they share moves median and mean alike; what each has by itself moves the median further. Of one or two the median is the mean.
fn variance_of_median(number: usize, of_sum: f64, together: f64) -> f64 {
    let count = number as f64;
    let of_mean = of_sum / (count * count);
    if number < 3 {
        return of_mean;
    }
    let shared = (of_sum - together) / (count * (count - 1.0));
    of_mean + (MEDIAN_BY_MEAN * MEDIAN_BY_MEAN - 1.0) * (together / count - shared).max(0.0) / count
}

/// What the places of an orthophoto share of the standard error of one: as far as that it may be off as a whole.
pub(crate) const SHARED: f64 = 0.5;

/// What check points beside the places of an orthophoto may be off by together, along each axis: as far as that may be off as a whole.
pub(super) fn shared_by_places(known: &Known<'_>) -> [f64; 3] {
    let own = known.options.tested_control.unwrap_or(known.description.control.len());
    let places = known.frame.control.get(own..).unwrap_or_default();
    [0, 1, 2].map(|k| SHARED * median(&mut places.iter().map(|(_, sigma)| sigma[k]).collect::<Vec<_>>()).unwrap_or(0.0))
}

/// Check points that differ alike from the block beyond a limit.
pub(super) fn of_check_points(model: &ReconstructedModel, known: &Known<'_>) -> Option<BlockWarning> {
    let Known { description, options, .. } = *known;
    let own = options.tested_control.unwrap_or(description.control.len());
    let shift = CommonShift::of_checks(model, description, own)?;
    let shared = shared_by_places(known);
    let error = |axis: Axis| libm::hypot(shift.errors_m[axis.index()], shared[axis.index()]);
    let times = |axis: Axis| shift.difference_m[axis.index()].abs() / error(axis);
    let axis = Axis::ALL.into_iter().max_by(|a, b| times(*a).total_cmp(&times(*b)))?;
    (times(axis) > options.adjustment.limit()).then(|| BlockWarning::ChecksApart {
        axis,
        points: shift.points,
        difference_m: shift.difference_m[axis.index()],
        error_m: error(axis),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_median_errs_more_than_a_mean_by_what_each_has_by_itself_alone() {
        // Errors that are wholly common: variance 4 each, and of the sum of n of them 4 n².
        for number in [1, 2, 3, 8] {
            let n = number as f64;
            assert!((variance_of_median(number, 4.0 * n * n, 4.0 * n) - 4.0).abs() < 1e-12, "{number}");
        }
        // Errors of each by itself: pi / 2 times that of the mean.
        let alone = variance_of_median(8, 32.0, 32.0);
        assert!((alone / 0.5 - std::f64::consts::FRAC_PI_2).abs() < 1e-4, "{alone}");
        assert!((variance_of_median(2, 8.0, 8.0) - 2.0).abs() < 1e-12);
        // 3 in common and 1 alone.
        let both = variance_of_median(10, 100.0 * 3.0 + 10.0, 40.0);
        assert!((both - (3.0 + 0.1 * std::f64::consts::FRAC_PI_2)).abs() < 1e-4, "{both}");
    }
}
