//! Which control points contradict the other observations of a block: found one after the other, the largest test first, each left out before the
//! others are judged, so that a wrong point accuses none of its neighbours.
//!
//! A wrong coordinate shows in the test of its residual. One that is far off does not: the image measurements of its point are rejected as gross
//! errors before. So a point is tried without its coordinates, too, where image measurements of it were rejected, and from the start where it
//! lies far from the similarity on which most positions agree. Where the other observations then have it within chance, it takes part again.
//!
//! # Source
//! Baarda 1968, A testing procedure for use in geodetic networks.

use super::material::Known;
use super::mistake::Axis;
use super::placing::Placing;
use crate::Error;
use crate::adjustment::{AdjustmentResult, Block, Datum, ObservationVerdict, PriorStatistics, far_control};
use crate::math::{median, normal_median_within};
use std::borrow::Cow;

/// Positions, of images or control points, that have to be left: fewer do not tell which of them is wrong.
const LEAST_LEFT: usize = 4;
/// So many of few control points may be wrong, of many this share: more contradict the block as a whole.
const FEW_WRONG: usize = 3;
const MANY_WRONG: f64 = 0.15;
/// Standard error of the median size of a normal number, by the root of how many there are, as a share of it.
const MEDIAN_ERROR: f64 = 1.166;
/// Standard errors that are stated too small make no point wrong: by so many of its standard errors the median of the tests is too large then.
const BEYOND: f64 = 2.0;
/// Image measurements of a point that tell a wrong one among them from wrong coordinates.
const LEAST_MARKS: usize = 3;
/// Up to so many control points each is left out alone where all of them do not place the block.
const MOST_ALONE: usize = 12;
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
    fn new(difference: [f64; 3], errors: [f64; 3], shift: f64) -> Self {
        let detectable = errors.map(|error| Some(shift * error).filter(|error| error.is_finite()));
        Self { difference, errors, detectable }
    }

    fn values(&self) -> [f64; 3] {
        [0, 1, 2].map(|k| (self.difference[k] / self.errors[k]).abs())
    }

    /// The coordinate whose test is largest.
    pub fn axis(&self) -> Axis {
        let values = self.values();
        Axis::ALL.into_iter().max_by(|a, b| values[a.index()].total_cmp(&values[b.index()])).unwrap_or(Axis::X)
    }

    fn size(&self) -> f64 {
        self.values().into_iter().fold(0.0, f64::max)
    }
}

/// A control point that contradicts the other observations.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Refused {
    /// Index of its point in the adjusted block.
    pub point: usize,
    /// Absent where too few of its image measurements fit: nothing tells where the other observations have it.
    pub test: Option<ControlTest>,
    /// Whether it takes part all the same.
    pub is_used: bool,
}

/// What became of the control points of a block.
#[derive(Debug, Default)]
pub(super) struct ControlTests {
    /// In the order of the block's control points.
    pub refused: Vec<Refused>,
    /// Where nothing tells which are wrong: how many contradict the rest of the block, of how many that were tested.
    pub contradicting: Option<[usize; 2]>,
    /// Where the block has no adjustment without those that were to be left out, and all take part: how many they are, of how many that were tested.
    pub stopped: Option<[usize; 2]>,
}

type Adjusted = (AdjustmentResult, Placing);

/// Adjusts a block without the control points that contradict the other observations, of those that are to be tested. `adjust` adjusts it with those
/// that it is given.
///
/// # Errors
/// Those of `adjust`.
pub(super) fn tested_control(
    block: &Block,
    is_tested: &[bool],
    known: &Known<'_>,
    adjust: impl Fn(&Block) -> Result<Adjusted, Error>,
) -> Result<(AdjustmentResult, Placing, ControlTests), Error> {
    let whole = |tests: ControlTests| adjust(block).map(|(adjusted, placing)| (adjusted, placing, tests));
    let options = known.options;
    let datum = options.datum.unwrap_or(Datum::GnssAndControl);
    if !is_tested.contains(&true) || !options.adjustment.snooping || !options.adjustment.statistics || !datum.uses_control() {
        return whole(ControlTests::default());
    }
    let mut course = Course::new(block, is_tested, known, datum);
    // A wrong point may keep the block from being placed at all: then all are tried, and after that each is left out alone.
    let mut is_whole_tried = false;
    let mut is_each_tried = false;
    loop {
        let (adjusted, placing) = match adjust(&course.taking()) {
            Ok(found) if is_placed(&found) => found,
            Ok(_) | Err(_) if course.is_refused.contains(&true) && !is_whole_tried => {
                is_whole_tried = true;
                course.start_with(None);
                continue;
            }
            Ok(_) | Err(_) if course.is_refused.contains(&true) => {
                let found = adjust(block)?;
                // Of a block that control points do not place another warning says why.
                let stopped = is_placed(&found).then(|| [course.refused(), course.tested()]);
                return Ok((found.0, found.1, ControlTests { stopped, ..ControlTests::default() }));
            }
            of_all => {
                let found = if is_each_tried { None } else { course.without_one(&adjust) };
                (is_whole_tried, is_each_tried) = (true, true);
                match found {
                    Some(found) => found,
                    None => return of_all.map(|(adjusted, placing)| (adjusted, placing, ControlTests::default())),
                }
            }
        };
        match course.next(&adjusted) {
            Next::Again => {}
            Next::Done(tests) => return Ok((adjusted, placing, tests)),
            Next::Contradiction => {
                let (adjusted, placing) = adjust(block)?;
                course.is_refused.fill(false);
                let contradicting = [course.beyond(&course.tests(&adjusted)).count(), course.tested()];
                return Ok((adjusted, placing, ControlTests { contradicting: Some(contradicting), ..ControlTests::default() }));
            }
        }
    }
}

/// Whether control points place a block.
fn is_placed((adjusted, placing): &Adjusted) -> bool {
    adjusted.datum.uses_control() && !matches!(placing, Placing::Free { .. })
}

enum Next {
    /// Other control points take part now.
    Again,
    Done(ControlTests),
    /// Too many would have to be left out.
    Contradiction,
}

/// What changes from one adjustment to the next; control points by their indices in the block.
struct Course<'a> {
    block: &'a Block,
    /// The others take part as they are.
    is_tested: &'a [bool],
    known: &'a Known<'a>,
    datum: Datum,
    is_refused: Vec<bool>,
    /// What was tried takes part to the end.
    is_settled: Vec<bool>,
    /// The one that was left out last since its own test was the largest: it does not take part again before another one is found wrong.
    last: Option<usize>,
    /// Of one that is tried without its coordinates: the largest test of its image measurements that were rejected beside them, of which the most fitted.
    rivals: Vec<f64>,
}

/// The tests of all control points, absent where nothing checks them; and what they are compared with.
struct Tests {
    of: Vec<Option<ControlTest>>,
    limit: f64,
}

impl<'a> Course<'a> {
    fn new(block: &'a Block, is_tested: &'a [bool], known: &'a Known<'a>, datum: Datum) -> Self {
        let number = block.control.len();
        let (is_refused, is_settled, rivals) = (vec![false; number], vec![false; number], vec![0.0; number]);
        let mut course = Self { block, is_tested, known, datum, is_refused, is_settled, last: None, rivals };
        let far: Vec<usize> = far_control(block, datum).into_iter().filter(|control| is_tested[*control]).collect();
        if far.len() <= course.most() && number - far.len() + course.images() >= LEAST_LEFT {
            far.into_iter().for_each(|control| course.is_refused[control] = true);
        }
        course
    }

    /// Forgets what was tried; begins without one of them, or with all.
    fn start_with(&mut self, without: Option<usize>) {
        self.is_refused.fill(false);
        self.is_settled.fill(false);
        self.rivals.fill(0.0);
        self.last = without;
        without.into_iter().for_each(|control| self.is_refused[control] = true);
    }

    /// Begins without the one beside which the others fit best: the fewest of their image measurements are rejected, and then their largest test is
    /// smallest. `None` where nothing tells which, and all take part again.
    fn without_one(&mut self, adjust: impl Fn(&Block) -> Result<Adjusted, Error>) -> Option<Adjusted> {
        let number = self.is_refused.len();
        let images = self.images();
        let may_go = self.most() > 0 && number + images > LEAST_LEFT;
        let mut best: Option<(usize, f64, usize, Adjusted)> = None;
        let is_open = |control: &usize| may_go && self.is_tested[*control] && self.tested() <= MOST_ALONE;
        for control in (0..number).filter(is_open).collect::<Vec<_>>() {
            self.start_with(Some(control));
            let Ok(found) = adjust(&self.taking()) else { continue };
            if !is_placed(&found) {
                continue;
            }
            let rejected = self.rejected(&found.0);
            let tests = self.tests(&found.0);
            let largest =
                tests.of.iter().zip(&self.is_refused).filter(|(_, refused)| !**refused).filter_map(|(test, _)| Some(test.as_ref()?.size()));
            let largest = largest.fold(0.0, f64::max);
            if best.as_ref().is_none_or(|(fewest, least, ..)| rejected < *fewest || rejected == *fewest && largest < *least) {
                best = Some((rejected, largest, control, found));
            }
        }
        self.start_with(best.as_ref().map(|(_, _, control, _)| *control));
        best.map(|(.., found)| found)
    }

    /// How many image measurements of those that take part were rejected.
    fn rejected(&self, adjusted: &AdjustmentResult) -> usize {
        let mut takes_part = vec![false; adjusted.block.points.len()];
        adjusted.block.control.iter().for_each(|control| takes_part[control.point] = true);
        let of_rays = adjusted.block.rays.iter().zip(&adjusted.rays);
        of_rays.filter(|(ray, statistics)| takes_part[ray.point] && statistics.verdict != ObservationVerdict::Accepted).count()
    }

    /// The block with the control points that take part.
    fn taking(&self) -> Cow<'a, Block> {
        if !self.is_refused.contains(&true) {
            return Cow::Borrowed(self.block);
        }
        let mut block = self.block.clone();
        let mut refused = self.is_refused.iter();
        block.control.retain(|_| refused.next() == Some(&false));
        Cow::Owned(block)
    }

    /// Images with a GNSS position that may take part.
    fn images(&self) -> usize {
        self.block.images.iter().filter(|image| image.gnss.is_some() && self.datum.uses_gnss()).count()
    }

    fn tested(&self) -> usize {
        self.is_tested.iter().filter(|tested| **tested).count()
    }

    /// How many may be refused.
    fn most(&self) -> usize {
        let number = self.tested();
        (number.saturating_sub(1) / 2).min(FEW_WRONG).max((MANY_WRONG * number as f64) as usize)
    }

    fn refused(&self) -> usize {
        self.is_refused.iter().filter(|refused| **refused).count()
    }

    fn tests(&self, adjusted: &AdjustmentResult) -> Tests {
        let of: Vec<Option<ControlTest>> =
            (0..self.is_refused.len()).map(|control| self.test(adjusted, control).filter(|_| self.is_tested[control])).collect();
        let taking = of.iter().zip(&self.is_refused).filter(|(_, refused)| !**refused).filter_map(|(test, _)| test.as_ref());
        let mut sizes: Vec<f64> = taking.flat_map(ControlTest::values).filter(|value| *value > 0.0).collect();
        let limit = self.known.options.adjustment.limit();
        let certain = 1.0 + BEYOND * MEDIAN_ERROR / (sizes.len().max(1) as f64).sqrt();
        let scale = median(&mut sizes).map(|middle| middle / normal_median_within(limit)).filter(|scale| *scale > certain);
        Tests { of, limit: limit * scale.unwrap_or(1.0) }
    }

    fn test(&self, adjusted: &AdjustmentResult, control: usize) -> Option<ControlTest> {
        let given = &self.block.control[control];
        let shift = self.known.options.adjustment.detectable_shift(adjusted.degrees_of_freedom);
        let factors = adjusted.factors_of_control();
        let sigma = [0, 1, 2].map(|k| given.sigma[k] * factors[k]);
        let point = adjusted.points[given.point]?;
        let errors = point.errors?;
        if self.is_refused[control] {
            let difference = [0, 1, 2].map(|k| adjusted.block.points[given.point][k] - given.position[k]);
            let of_difference = [0, 1, 2].map(|k| (errors[k] * errors[k] + sigma[k] * sigma[k]).sqrt());
            return (point.rays >= 2).then(|| ControlTest::new(difference, of_difference, shift));
        }
        let place = adjusted.block.control.iter().position(|control| control.point == given.point)?;
        of_residuals(adjusted, adjusted.control[place].as_ref()?, sigma, errors, shift)
    }

    /// Those that take part beyond the limit.
    fn beyond<'t>(&'t self, tests: &'t Tests) -> impl Iterator<Item = (usize, &'t ControlTest)> {
        let all = tests.of.iter().enumerate().filter(|(control, _)| !self.is_refused[*control]);
        all.filter_map(|(control, test)| Some((control, test.as_ref()?))).filter(|(_, test)| test.size() > tests.limit)
    }

    fn next(&mut self, adjusted: &AdjustmentResult) -> Next {
        let tests = self.tests(adjusted);
        // Of a wrong coordinate and a wrong image measurement that explain each other, the one with the larger test is wrong.
        let fits = |control: &usize| fits(tests.of[*control].as_ref(), tests.limit.max(self.rivals[*control]));
        let may_return = |control: &usize| self.is_refused[*control] && self.last != Some(*control);
        let back: Vec<usize> = (0..self.is_refused.len()).filter(may_return).filter(fits).collect();
        if !back.is_empty() {
            back.into_iter().for_each(|control| (self.is_refused[control], self.is_settled[control]) = (false, true));
            return Next::Again;
        }
        let gnss = adjusted.images.iter().filter(|image| image.gnss.is_some_and(|gnss| gnss.accepted)).count();
        let taking = self.is_refused.len() - self.refused();
        let may_go = taking + gnss > LEAST_LEFT;
        if let Some((control, rival)) = self.unmeasured(adjusted).filter(|_| self.refused() < self.most() && may_go) {
            (self.is_refused[control], self.rivals[control]) = (true, rival);
            return Next::Again;
        }
        let open = self.beyond(&tests).filter(|(control, _)| !self.is_settled[*control]);
        let worst = open.max_by(|(_, a), (_, b)| a.size().total_cmp(&b.size()));
        match worst.filter(|_| may_go) {
            Some((control, _)) if self.refused() < self.most() => {
                (self.is_refused[control], self.last) = (true, Some(control));
                Next::Again
            }
            Some(_) if self.most() > 0 => Next::Contradiction,
            _ => Next::Done(self.done(&tests)),
        }
    }

    fn done(&self, tests: &Tests) -> ControlTests {
        let beyond: Vec<usize> = self.beyond(tests).map(|(control, _)| control).collect();
        let refused = |control: usize| {
            let (point, is_used) = (self.block.control[control].point, !self.is_refused[control]);
            let is_named = !is_used || beyond.binary_search(&control).is_ok();
            is_named.then_some(Refused { point, test: tests.of[control], is_used })
        };
        ControlTests { refused: (0..self.is_refused.len()).filter_map(refused).collect(), ..ControlTests::default() }
    }

    /// The control point that takes part and whose image measurements were rejected, most of them or one of three and more, where it was not tried
    /// without its coordinates; with the largest test of those where the others fitted. Of several the one of which all were rejected, then one of which
    /// most were, then the one with the largest test: a wrong point pulls the block off the measurements of its neighbours.
    fn unmeasured(&self, adjusted: &AdjustmentResult) -> Option<(usize, f64)> {
        let mut counts = vec![[0_usize; 2]; adjusted.block.points.len()];
        let mut largest = vec![0.0_f64; adjusted.block.points.len()];
        for (ray, statistics) in adjusted.block.rays.iter().zip(&adjusted.rays) {
            let is_rejected = statistics.verdict != ObservationVerdict::Accepted;
            counts[ray.point][usize::from(is_rejected)] += 1;
            if is_rejected {
                let size = statistics.w.map_or(0.0, |w| w[0].abs().max(w[1].abs()));
                largest[ray.point] = largest[ray.point].max(size);
            }
        }
        let is_open = |control: &usize| self.is_tested[*control] && !self.is_refused[*control] && !self.is_settled[*control];
        let doubtful = (0..self.is_refused.len()).filter(is_open).filter_map(|control| {
            let point = self.block.control[control].point;
            let [accepted, rejected] = counts[point];
            let is_most = rejected > accepted;
            let is_doubtful = accepted + rejected >= if is_most { 2 } else { LEAST_MARKS } && rejected > 0;
            is_doubtful.then(|| Unmeasured { control, is_lost: accepted == 0, is_most, rejected, largest: largest[point] })
        });
        let worst = Unmeasured::worst(doubtful)?;
        Some((worst.control, if worst.is_most { 0.0 } else { worst.largest }))
    }
}

/// Whether the other observations have a point within chance: one that nothing tests is not known to be right.
fn fits(test: Option<&ControlTest>, limit: f64) -> bool {
    test.is_some_and(|test| test.size() <= limit)
}

/// A control point of which image measurements were rejected.
struct Unmeasured {
    control: usize,
    /// Whether all were.
    is_lost: bool,
    /// Whether most were.
    is_most: bool,
    rejected: usize,
    /// Their largest test; 0 where none fitted, which leaves nothing to test them by.
    largest: f64,
}

impl Unmeasured {
    /// Of equal ones the first.
    fn worst(all: impl Iterator<Item = Self>) -> Option<Self> {
        all.reduce(|worst, next| if next.is_worse_than(&worst) { next } else { worst })
    }

    fn is_worse_than(&self, other: &Self) -> bool {
        let kind = |of: &Self| (of.is_lost, of.is_most);
        let by_size = || self.largest.total_cmp(&other.largest).then(self.rejected.cmp(&other.rejected));
        kind(self).cmp(&kind(other)).then_with(by_size).is_gt()
    }
}

/// Of a control point that took part with these standard errors; `errors` are those of its adjusted place, which hold what the observations of an
/// image share.
fn of_residuals(
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
    use super::{ControlTest, Unmeasured, fits, tested_control};
    use crate::adjustment::{AdjustmentOptions, Datum, adjust_block};
    use crate::reconstruction::frame::Frame;
    use crate::reconstruction::material::Known;
    use crate::reconstruction::placing::Placing;
    use crate::{
        BlockFlight, BlockOptions, Cause, Computation, ControlRole, Error, Exposure, GroundControlPoint, ImageObservation,
        ObservedPosition, ReconstructionOptions, SelectOptions, reconstruct_block, simulate_block, tie_points,
    };

    #[test]
    fn tests_of_a_block_that_has_no_adjustment_without_a_point_say_that_they_stopped() {
        let simulated = simulate_block(&BlockFlight { strips: 2, exposures: 4, features: 700, ..BlockFlight::default() }).unwrap();
        let mut description = simulated.description(Some(1.0));
        let seen = |place: &[f64; 3]| -> Vec<ImageObservation> {
            let at = |exposure: &Exposure| exposure.project(*place, simulated.width_px, simulated.height_px);
            let marks = simulated.exposures.iter().enumerate().filter_map(|(image, exposure)| Some((image, at(exposure)?)));
            marks.map(|(image, [x_px, y_px])| ImageObservation { image, x_px, y_px, confidence: 1.0 }).collect()
        };
        let shown: Vec<_> = simulated.ground.iter().map(|place| (*place, seen(place))).filter(|(_, seen)| seen.len() >= 4).collect();
        description.control = (0..7)
            .map(|k| {
                let (position, measurements) = shown[k * shown.len() / 7].clone();
                let (position, role) = (ObservedPosition::Local { position, sigma: [0.02; 3] }, ControlRole::Control);
                GroundControlPoint { name: format!("G{k}"), position, role, sigma_px: None, measurements }
            })
            .collect();
        let (points, _) = tie_points(&simulated.matches().unwrap(), &BlockOptions::default()).unwrap();
        let options = ReconstructionOptions { selection: Some(SelectOptions::default()), ..ReconstructionOptions::default() };
        let model = reconstruct_block(&description, &points, &simulated.image_features(), &options).unwrap().models.swap_remove(0);
        let frame = Frame::new(&description).unwrap();
        let known = Known { description: &description, options: &options, frame: &frame };
        let mut block = model.adjusted.block.clone();
        assert_eq!(block.control.len(), 7, "{:?}", model.warnings);
        block.control[3].position[2] += 2.0;
        let adjustment = AdjustmentOptions { datum: Datum::Control, ..options.adjustment.clone() };
        let tests = |fails: bool| {
            let found = tested_control(&block, &[true; 7], &known, |part| {
                if fails && part.control.len() < 7 {
                    return Err(Error::Degenerate { computation: Computation::BundleAdjustment, cause: Cause::NoPosition });
                }
                adjust_block(part, &adjustment).map(|adjusted| (adjusted, Placing::Observed))
            });
            let (adjusted, _, tests) = found.unwrap();
            (adjusted.block.control.len(), tests.refused.len(), tests.stopped)
        };
        assert_eq!(tests(false), (6, 1, None));
        assert_eq!(tests(true), (7, 0, Some([1, 7])));
    }

    #[test]
    fn a_point_that_nothing_tests_does_not_fit() {
        let test = ControlTest::new([0.02, 0.0, -0.03], [0.01; 3], 4.13);
        assert!(fits(Some(&test), 3.29) && !fits(Some(&test), 2.9));
        assert!(!fits(None, f64::MAX));
    }

    #[test]
    fn the_point_whose_measurements_fit_worst_is_tried_first() {
        let of = |control: usize, [accepted, rejected]: [usize; 2], largest: f64| Unmeasured {
            control,
            is_lost: accepted == 0,
            is_most: rejected > accepted,
            rejected,
            largest,
        };
        // One wrong measurement of four, good neighbours of a wrong point, and points that nothing fits.
        let mut all = vec![(0, [3, 1], 60.0), (1, [2, 4], 8.0), (2, [1, 3], 20.0), (3, [0, 3], 0.0), (4, [0, 5], 0.0), (5, [1, 3], 20.0)];
        for wanted in [4, 3, 2, 5, 1, 0] {
            let worst = Unmeasured::worst(all.iter().map(|(control, counts, largest)| of(*control, *counts, *largest)));
            assert_eq!(worst.map(|worst| worst.control), Some(wanted));
            all.retain(|(control, ..)| *control != wanted);
        }
        assert!(Unmeasured::worst(std::iter::empty()).is_none());
    }
}
