//! The strategies that compare grey values: the right place of a left point is searched in the right image itself.

use super::coarse_to_fine::CoarseToFine;
use super::cross_correlation::CrossCorrelation;
use super::fit::{Fit as Found, LeastSquaresOptions, Refusal};
use super::positions::check_positions;
use super::region::Region;
use super::rules::judge;
use super::search_area::SearchArea;
use super::surface::{Peak, Surface};
use super::{Expectation, Fit, MatchImage, MatchOptions, MatchSet, Rule, Verdict};
use crate::{Error, GreyImage, GreyView, Input, halve};
use std::ops::Range;

/// About an epipolar line this much more than the strip is correlated, in px, so that a summit within it is surrounded.
const AROUND_STRIP_PX: f64 = 1.0;

/// How far from the left point the way back may end, in px.
const WAY_BACK_PX: usize = 1;

/// Matches left points by normalised cross-correlation with all places of their search windows.
///
/// A match has its coefficient at or above the least one, is at most `ambiguity` times as far from 1 as the second summit, does not
/// lie on the border of its search window and, with `left_right`, correlates best with the place that it came from. Its place is that of
/// the summit of a quadratic surface through the coefficients around it.
///
/// # Errors
/// [`Error::InvalidInput`] where positions are not finite.
pub(super) fn correlate(
    left: MatchImage<'_>,
    right: GreyView<'_>,
    expected: Expectation<'_>,
    options: &MatchOptions,
) -> Result<MatchSet, Error> {
    check_positions(Input::LeftPoints, left.points)?;
    let mut search =
        Search { correlation: CrossCorrelation::new(options.template), images: [left.grey, right], columns: Vec::new(), options };
    let verdict = |point: &crate::InterestPoint| search.verdict([point.x, point.y], &expected.region(point.x, point.y, options.search / 2));
    let verdicts = left.points.iter().map(verdict).collect();
    Ok(judge(left.points, verdicts, expected.offset, options))
}

/// What stands ready to correlate points.
struct Search<'a> {
    correlation: CrossCorrelation,
    images: [GreyView<'a>; 2],
    /// The allowed columns of each row about an epipolar line.
    columns: Vec<Range<i64>>,
    options: &'a MatchOptions,
}

impl Search<'_> {
    fn verdict(&mut self, at: [f64; 2], region: &Region) -> Verdict {
        let [left, right] = self.images;
        let Some(pixel) = centre_pixel(left, at, self.options.template) else { return Verdict::none(Rule::NoDescriptor) };
        let centre = region.centre.map(|v| libm::floor(v) as i64);
        self.columns.clear();
        if region.is_strip() {
            self.columns.extend(allowed_columns(&region.widened(AROUND_STRIP_PX), centre));
        }
        let columns = region.is_strip().then_some(&self.columns[..]);
        let area = SearchArea { centre, reach: [region.reach; 2], columns };
        let Some(peak) = self.correlation.search(left, pixel, right, &area).and_then(Surface::peak) else {
            return Verdict::none(Rule::NoCandidate);
        };
        let mut verdict = self.judged(&peak);
        // Where the point does not lie in the middle of its pixel, its place does not either.
        verdict.position = Some([0, 1].map(|axis| peak.position[axis] + at[axis] - pixel[axis] as f64 - 0.5));
        let reach = [self.options.search / 2; 2];
        if verdict.rule == Rule::Matched
            && self.options.left_right
            && !self.correlation.returns((left, pixel), (right, peak.pixel), reach, WAY_BACK_PX)
        {
            verdict.rule = Rule::LeftRight;
        }
        verdict
    }

    /// The verdict on a summit of the correlation.
    fn judged(&self, peak: &Peak) -> Verdict {
        let (measure, second) = (1.0 - peak.coefficient, peak.second.map_or(f64::INFINITY, |second| 1.0 - second));
        let rule = if peak.coefficient < self.options.min_correlation {
            Rule::Threshold
        } else if peak.on_edge != [false; 2] {
            Rule::Border
        } else if self.options.is_ambiguous(measure, second) {
            Rule::Ambiguous
        } else {
            Rule::Matched
        };
        Verdict { measure, second, ..Verdict::none(rule) }
    }
}

/// The pixel of a left position whose window lies in the image.
fn centre_pixel(image: GreyView<'_>, at: [f64; 2], side: usize) -> Option<[usize; 2]> {
    let reach = side / 2;
    let along = |v: f64, length: usize| (v >= reach as f64 && v < (length as f64 - reach as f64)).then_some(v as usize);
    Some([along(at[0], image.width())?, along(at[1], image.height())?])
}

/// For each row of the region's window, the columns whose pixel centres the strip holds.
fn allowed_columns(region: &Region, centre: [i64; 2]) -> impl Iterator<Item = Range<i64>> + use<'_> {
    let reach = region.reach as i64;
    (centre[1] - reach..=centre[1] + reach).map(move |row| {
        let allows = |col: &i64| region.allows(*col as f64 + 0.5, row as f64 + 0.5);
        let mut columns = centre[0] - reach..centre[0] + reach + 1;
        let Some(first) = columns.find(allows) else { return 0..0 };
        first..columns.find(|col| !allows(col)).unwrap_or(centre[0] + reach + 1)
    })
}

/// Matches left points by least squares from coarse to fine.
///
/// On images halved until the search window is a few pixels wide, the highest correlation gives a start, which least squares matching
/// follows through the levels; one that does not settle on a reduced image leaves the start to the next. The last level decides.
///
/// # Errors
/// As [`correlate`].
pub(super) fn adjust(
    left: MatchImage<'_>,
    right: GreyView<'_>,
    expected: Expectation<'_>,
    options: &MatchOptions,
) -> Result<MatchSet, Error> {
    check_positions(Input::LeftPoints, left.points)?;
    let pyramids = [left.grey, right].map(|image| pyramid(image, options));
    let mut matching = CoarseToFine::new(options.template);
    let limits = limits(options);
    let verdict = |point: &crate::InterestPoint| {
        let (at, region) = ([point.x, point.y], expected.region(point.x, point.y, options.search / 2));
        if centre_pixel(left.grey, at, options.template).is_none() {
            return Verdict::none(Rule::NoDescriptor);
        }
        let found = matching.through_pyramid((&pyramids[0], at), (&pyramids[1], region.centre), region.reach as f64, &limits);
        let mut verdict = located(found, options);
        if let Some([x, y]) = verdict.matched() {
            let outside = [x - region.centre[0], y - region.centre[1]].iter().any(|d| d.abs() > region.reach as f64 + 1.0);
            verdict.rule = match (outside, region.allows(x, y)) {
                (true, _) => Rule::Border,
                (false, false) => Rule::Parallax,
                (false, true) => Rule::Matched,
            };
        }
        verdict
    };
    let verdicts = left.points.iter().map(verdict).collect();
    Ok(judge(left.points, verdicts, expected.offset, options))
}

/// The image, and its halvings down to where the search window is a few pixels wide.
fn pyramid(image: GreyView<'_>, options: &MatchOptions) -> Vec<GreyImage> {
    let mut levels = vec![image.to_image()];
    while options.search >> levels.len() > 4 {
        let smallest = levels[levels.len() - 1].view();
        if smallest.width().min(smallest.height()) < 4 * options.template {
            break;
        }
        levels.push(halve(smallest));
    }
    levels
}

/// What the options ask of least squares matching.
pub(super) fn limits(options: &MatchOptions) -> LeastSquaresOptions {
    LeastSquaresOptions { least_correlation: options.min_correlation, ..LeastSquaresOptions::default() }
}

/// The verdict on what least squares matching found.
pub(super) fn located(found: Result<Found, Refusal>, options: &MatchOptions) -> Verdict {
    let found = match found {
        Err(Refusal::Degenerate) => return Verdict::none(Rule::Imprecise),
        Err(Refusal::LowCorrelation) => return Verdict::none(Rule::Threshold),
        Err(Refusal::LeftImage) => return Verdict::none(Rule::NoCandidate),
        Err(Refusal::NotConverged | Refusal::MovedTooFar) => return Verdict::none(Rule::NotConverged),
        Ok(found) => found,
    };
    let fit = Fit { correlation: found.correlation, covariance: found.covariance, iterations: found.iterations };
    let rule = if fit.standard_error_px() > options.max_standard_error { Rule::Imprecise } else { Rule::Matched };
    Verdict { position: Some(found.position), measure: 1.0 - fit.correlation, fit: Some(fit), ..Verdict::none(rule) }
}
