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
use std::collections::BTreeMap;

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

    /// Beside a limit that is so many times as large, since the tests of all points scatter as much more.
    fn within(self, scale: f64) -> Self {
        Self { detectable: self.detectable.map(|error| error.map(|error| scale * error)), ..self }
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
    /// Whether its coordinates are right within chance: it takes no part since the block is not placed with it.
    pub is_within: bool,
}

/// What became of the control points of a block.
#[derive(Debug, Default)]
pub(super) struct ControlTests {
    /// In the order of the block's control points.
    pub refused: Vec<Refused>,
    /// Errors that the tests of each point that was tested find with a probability of 0.80, by the index of the point in the adjusted block.
    pub detectable: BTreeMap<usize, [Option<f64>; 3]>,
    /// Where nothing tells which are wrong: how many contradict the rest of the block, of how many that were tested.
    pub contradicting: Option<[usize; 2]>,
    /// Where the block has no adjustment without those that were to be left out, and all take part: how many they are, of how many that were tested.
    pub stopped: Option<[usize; 2]>,
    /// The points, by their indices in the adjusted block, that take no part since the block has no adjustment of any kind with them; the others do not
    /// place it either.
    pub unadjusted: Vec<usize>,
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
    // A wrong point may keep the block from being placed at all: then all are tried, and after that each is left out alone. What places the block
    // once is kept: where no adjustment after it does, it is the result.
    let mut is_placed_by_all = None;
    let mut kept: Option<Kept> = None;
    // An adjustment without those far off that places nothing is better than none.
    let mut floating: Option<(AdjustmentResult, Placing, ControlTests)> = None;
    loop {
        let takes_all = !course.is_refused.contains(&true);
        let tried = adjust(&course.taking());
        if takes_all {
            is_placed_by_all = Some(tried.as_ref().is_ok_and(is_placed));
        }
        let (adjusted, placing) = match tried {
            Ok(found) if is_placed(&found) => found,
            // The free network failed, too, if no datum was chosen: an image is to be left out then, not a point.
            Err(error @ (Error::UndeterminedImage { .. } | Error::Degenerate { .. }))
                if takes_all && kept.is_none() && floating.is_none() && options.datum.is_none() =>
            {
                return Err(error);
            }
            without_far if is_placed_by_all.is_none() => {
                floating = without_far.ok().map(|(adjusted, placing)| (adjusted, placing, course.unadjusted()));
                course.start_with(None);
                continue;
            }
            of_all => match kept {
                Some(kept) => return Ok(course.back_to(kept)),
                None => match course.without_one(&adjust) {
                    Some(found) => found,
                    None => {
                        let of_all = of_all.map(|(adjusted, placing)| (adjusted, placing, ControlTests::default()));
                        return of_all.or_else(|error| floating.ok_or(error));
                    }
                },
            },
        };
        let tests = course.tests(&adjusted);
        let is_refused = course.is_refused.clone();
        match course.next(&adjusted, &tests) {
            Next::Again => kept = Some(Kept { adjusted, placing, tests, is_refused }),
            Next::Done => return Ok((adjusted, placing, course.done(&tests))),
            Next::Contradiction => {
                let beyond = course.refused() + course.beyond(&tests).count();
                let of_all = if is_placed_by_all == Some(false) { None } else { adjust(block).ok().filter(is_placed) };
                let Some((adjusted, placing)) = of_all else { return Ok((adjusted, placing, course.done(&tests))) };
                let contradicting = Some([beyond, course.tested()]);
                course.is_refused.fill(false);
                let detectable = course.detectable(&course.tests(&adjusted));
                return Ok((adjusted, placing, ControlTests { contradicting, detectable, ..ControlTests::default() }));
            }
        }
    }
}

/// An adjustment that places the block, with its tests and the control points that took no part.
struct Kept {
    adjusted: AdjustmentResult,
    placing: Placing,
    tests: Tests,
    is_refused: Vec<bool>,
}

/// Whether control points place a block.
fn is_placed((adjusted, placing): &Adjusted) -> bool {
    adjusted.datum.uses_control() && !matches!(placing, Placing::Free { .. })
}

enum Next {
    /// Other control points take part now.
    Again,
    Done,
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
    /// With these the block was not placed.
    keeps_from_placing: Vec<bool>,
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
        let keeps_from_placing = vec![false; number];
        let mut course = Self { block, is_tested, known, datum, is_refused, is_settled, last: None, keeps_from_placing, rivals };
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

    /// Begins without the one beside which the others fit best: the fewest of their image measurements are rejected; then its own coordinates contradict
    /// them; then their largest test is smallest. `None` where nothing tells which, and all take part again.
    fn without_one(&mut self, adjust: impl Fn(&Block) -> Result<Adjusted, Error>) -> Option<Adjusted> {
        let number = self.is_refused.len();
        let images = self.images();
        let may_go = self.most() > 0 && number + images > LEAST_LEFT;
        let mut best: Option<((usize, bool), f64, usize, Adjusted)> = None;
        let is_open = |control: &usize| may_go && self.is_tested[*control] && self.tested() <= MOST_ALONE;
        for control in (0..number).filter(is_open).collect::<Vec<_>>() {
            self.start_with(Some(control));
            let Ok(found) = adjust(&self.taking()) else { continue };
            if !is_placed(&found) {
                continue;
            }
            let tests = self.tests(&found.0);
            let rank = (self.rejected(&found.0), fits(tests.of[control].as_ref(), tests.limit));
            let largest =
                tests.of.iter().zip(&self.is_refused).filter(|(_, refused)| !**refused).filter_map(|(test, _)| Some(test.as_ref()?.size()));
            let largest = largest.fold(0.0, f64::max);
            if best.as_ref().is_none_or(|(first, least, ..)| rank < *first || rank == *first && largest < *least) {
                best = Some((rank, largest, control, found));
            }
        }
        let without = best.as_ref().map(|(_, _, control, _)| *control);
        self.start_with(without);
        without.into_iter().for_each(|control| self.keeps_from_placing[control] = true);
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
        let scale = scale.unwrap_or(1.0);
        Tests { of: of.into_iter().map(|test| Some(test?.within(scale))).collect(), limit: limit * scale }
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

    fn next(&mut self, adjusted: &AdjustmentResult, tests: &Tests) -> Next {
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
        // Without its coordinates nothing would tell where a point is of which one image measurement fits.
        let is_found = |control: usize| adjusted.points[self.block.control[control].point].is_some_and(|point| point.rays >= 2);
        let is_last = self.refused() >= self.most();
        let open = self.beyond(tests).filter(|(control, _)| !self.is_settled[*control] && (is_last || is_found(*control)));
        let worst = open.max_by(|(_, a), (_, b)| a.size().total_cmp(&b.size()));
        match worst.filter(|_| may_go) {
            Some((control, _)) if self.refused() < self.most() => {
                (self.is_refused[control], self.last) = (true, Some(control));
                Next::Again
            }
            Some(_) if self.most() > 0 => Next::Contradiction,
            _ => Next::Done,
        }
    }

    /// Where the block has no adjustment but without those that take no part now.
    fn unadjusted(&self) -> ControlTests {
        let refused = self.block.control.iter().zip(&self.is_refused).filter(|(_, refused)| **refused);
        ControlTests { unadjusted: refused.map(|(control, _)| control.point).collect(), ..ControlTests::default() }
    }

    /// The last adjustment that places the block, where the one after it does not.
    fn back_to(&mut self, kept: Kept) -> (AdjustmentResult, Placing, ControlTests) {
        let Kept { adjusted, placing, tests, is_refused } = kept;
        let left_out = self.refused();
        let failed = std::mem::replace(&mut self.is_refused, is_refused);
        let mut doubted = Vec::new();
        for (control, failed) in failed.into_iter().enumerate() {
            self.keeps_from_placing[control] |= self.is_refused[control] && !failed;
            doubted.extend((failed && !self.is_refused[control]).then_some(self.block.control[control].point));
        }
        let mut told = self.done(&tests);
        // What was to be left out by its test may accuse its neighbours.
        let is_doubted = |refused: &Refused| refused.is_used && doubted.contains(&refused.point);
        if told.refused.iter().any(is_doubted) {
            told.refused.retain(|refused| !refused.is_used || is_doubted(refused));
        }
        // Where some take no part warnings name them.
        told.stopped = (self.refused() == 0).then(|| [left_out, self.tested()]);
        (adjusted, placing, told)
    }

    fn done(&self, tests: &Tests) -> ControlTests {
        let beyond: Vec<usize> = self.beyond(tests).map(|(control, _)| control).collect();
        let refused = |control: usize| {
            let (point, is_used) = (self.block.control[control].point, !self.is_refused[control]);
            let is_named = !is_used || beyond.binary_search(&control).is_ok();
            let test = tests.of[control];
            let is_within = !is_used && self.keeps_from_placing[control] && fits(test.as_ref(), tests.limit);
            is_named.then_some(Refused { point, test, is_used, is_within })
        };
        let refused = (0..self.is_refused.len()).filter_map(refused).collect();
        ControlTests { refused, detectable: self.detectable(tests), ..ControlTests::default() }
    }

    fn detectable(&self, tests: &Tests) -> BTreeMap<usize, [Option<f64>; 3]> {
        let points = self.block.control.iter().map(|control| control.point);
        points.zip(&tests.of).filter_map(|(point, test)| Some((point, test.as_ref()?.detectable))).collect()
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
    use super::{ControlTest, ControlTests, Refused, Unmeasured, fits, tested_control};
    use crate::adjustment::{AdjustmentOptions, AdjustmentResult, Block, Datum, adjust_block};
    use crate::reconstruction::frame::Frame;
    use crate::reconstruction::material::Known;
    use crate::reconstruction::placing::Placing;
    use crate::{
        BlockDescription, BlockFlight, BlockOptions, Cause, Computation, ControlRole, Error, Exposure, GroundControlPoint,
        ImageObservation, ObservedPosition, ReconstructedModel, ReconstructionOptions, SelectOptions, reconstruct_block, simulate_block,
        tie_points,
    };
    use std::cell::Cell;
    use std::sync::OnceLock;

    /// A block with seven control points, without errors.
    fn given() -> &'static (BlockDescription, ReconstructionOptions, ReconstructedModel) {
        static GIVEN: OnceLock<(BlockDescription, ReconstructionOptions, ReconstructedModel)> = OnceLock::new();
        GIVEN.get_or_init(|| {
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
            assert_eq!(model.adjusted.block.control.len(), 7, "{:?}", model.warnings);
            (description, options, model)
        })
    }

    /// So many times the error of a height that is found in the block without errors.
    fn raised(block: &mut Block, control: usize, times: f64) {
        let detectable = given().2.surveyed[control].detectable_m[2].unwrap();
        block.control[control].position[2] += times * detectable;
    }

    const NOT_CONVERGED: Error =
        Error::NotConverged { computation: Computation::BundleAdjustment, iterations: 50, cause: Cause::NoPosition };

    /// What becomes of the control points of a changed block, of which the first ones are tested, and the number of adjustments. `placed`: whether control
    /// points place it.
    fn tested(
        change: impl Fn(&mut Block),
        first: usize,
        placed: impl Fn(&Block) -> Result<bool, Error>,
    ) -> (Result<(AdjustmentResult, ControlTests), Error>, usize) {
        let (description, options, model) = given();
        let frame = Frame::new(description).unwrap();
        let known = Known { description, options, frame: &frame };
        let mut block = model.adjusted.block.clone();
        change(&mut block);
        let count = Cell::new(0);
        let is_tested: Vec<bool> = (0..7).map(|control| control < first).collect();
        let found = tested_control(&block, &is_tested, &known, |part| {
            count.set(count.get() + 1);
            let by_control = placed(part)?;
            let datum = if by_control { Datum::Control } else { Datum::Free };
            let placing = if by_control { Placing::Observed } else { Placing::Free { cause: None } };
            adjust_block(part, &AdjustmentOptions { datum, ..options.adjustment.clone() }).map(|adjusted| (adjusted, placing))
        });
        (found.map(|(adjusted, _, tests)| (adjusted, tests)), count.get())
    }

    /// Control points that take part, and of those that are named: their number, whether they take part, and whether they are right within chance.
    fn named((adjusted, tests): &(AdjustmentResult, ControlTests)) -> (usize, Vec<(usize, bool, bool)>) {
        let number = |point: usize| given().2.adjusted.block.control.iter().position(|control| control.point == point).unwrap();
        let of = |refused: &Refused| (number(refused.point), refused.is_used, refused.is_within);
        (adjusted.block.control.len(), tests.refused.iter().map(of).collect())
    }

    #[test]
    fn tests_of_a_block_that_has_no_adjustment_without_a_point_say_that_they_stopped() {
        let wrong = |block: &mut Block| block.control[3].position[2] += 2.0;
        let found = tested(wrong, 7, |_| Ok(true)).0.unwrap();
        assert_eq!((named(&found), found.1.stopped), ((6, vec![(3, false, false)]), None));
        let (found, adjustments) = tested(wrong, 7, |part| if part.control.len() < 7 { Err(NOT_CONVERGED) } else { Ok(true) });
        let found = found.unwrap();
        // The wrong one keeps its figures, and nothing is adjusted twice.
        assert_eq!((named(&found), found.1.stopped), ((7, vec![(3, true, false)]), Some([1, 7])));
        assert!(adjustments <= 3, "{adjustments}");
    }

    #[test]
    fn a_right_point_with_which_a_block_is_not_placed_is_not_called_wrong() {
        let of_six = |part: &Block| if part.control.len() == 7 { Err(NOT_CONVERGED) } else { Ok(true) };
        let found = tested(|_| {}, 7, of_six).0.unwrap();
        let (taking, points) = named(&found);
        assert!(taking == 6 && matches!(points[..], [(_, false, true)]), "{points:?}");
        let wrong = tested(|block| raised(block, 3, 4.0), 7, of_six).0.unwrap();
        assert_eq!(named(&wrong), (6, vec![(3, false, false)]));
    }

    #[test]
    fn what_placed_the_block_is_kept_where_no_adjustment_after_it_does() {
        let wrong = |block: &mut Block| [(0, 4.0), (1, 3.0)].iter().for_each(|(control, times)| raised(block, *control, *times));
        let only_six = |part: &Block| match part.control.len() {
            7 => Ok(false),
            6 => Ok(true),
            _ => Err(NOT_CONVERGED),
        };
        let is_kept = |found: &(AdjustmentResult, ControlTests)| {
            let (taking, mut points) = named(found);
            points.sort_by_key(|(_, is_used, _)| *is_used);
            let is_left_out = matches!(points[0], (0 | 1, false, false));
            let is_used = points[1..].iter().all(|(_, is_used, _)| *is_used) && points[1..].iter().any(|(control, ..)| *control < 2);
            taking == 6 && is_left_out && is_used && found.1.contradicting.is_none() && found.1.stopped.is_none()
        };
        assert!(is_kept(&tested(wrong, 7, only_six).0.unwrap()));
    }

    #[test]
    fn a_block_that_has_no_adjustment_with_a_far_point_floats_without_it() {
        let far = |block: &mut Block| block.control[3].position[2] += 2000.0;
        let undetermined = || Error::UndeterminedImage { computation: Computation::BundleAdjustment, image: 2, cause: Cause::NoPosition };
        for error in [NOT_CONVERGED, undetermined()] {
            let without = |part: &Block| if part.control.len() == 7 { Err(error.clone()) } else { Ok(false) };
            let (adjusted, tests) = tested(far, 7, without).0.unwrap();
            let point = given().2.adjusted.block.control[3].point;
            assert_eq!((adjusted.datum, adjusted.control.len(), tests.unadjusted), (Datum::Free, 6, vec![point]));
        }
    }

    #[test]
    fn an_image_that_nothing_determines_costs_no_control_point() {
        let undetermined = || Error::UndeterminedImage { computation: Computation::BundleAdjustment, image: 2, cause: Cause::NoPosition };
        let (found, adjustments) = tested(|_| {}, 7, |_| Err(undetermined()));
        assert!(matches!(found, Err(Error::UndeterminedImage { image: 2, .. })) && adjustments == 1, "{adjustments}");
        let (found, adjustments) = tested(|_| {}, 7, |_| Err(NOT_CONVERGED));
        assert!(matches!(found, Err(Error::NotConverged { .. })) && adjustments == 8, "{adjustments}");
    }

    #[test]
    fn what_a_test_finds_holds_what_the_observations_of_an_image_share() {
        let (description, options, model) = given();
        let frame = Frame::new(description).unwrap();
        let known = Known { description, options, frame: &frame };
        // Beside what the residual of the point alone finds.
        let detectable = |shared_errors: f64| -> Vec<f64> {
            let adjustment = AdjustmentOptions { datum: Datum::Control, shared_errors, ..options.adjustment.clone() };
            let adjust = |part: &Block| adjust_block(part, &adjustment).map(|adjusted| (adjusted, Placing::Observed));
            let (adjusted, _, tests) = tested_control(&model.adjusted.block, &[true; 7], &known, adjust).unwrap();
            assert_eq!((tests.refused.len(), tests.detectable.len(), adjusted.control.len()), (0, 7, 7));
            let own = adjusted.block.control.iter().zip(&adjusted.control);
            own.flat_map(|(control, statistics)| {
                let (of_test, of_residual) = (tests.detectable[&control.point], statistics.unwrap().detectable);
                [0, 1, 2].map(|k| of_test[k].unwrap() / of_residual[k].unwrap())
            })
            .collect()
        };
        let (alone, shared) = (detectable(0.0), detectable(0.5));
        assert!(alone.iter().all(|ratio| (ratio - 1.0).abs() < 1e-6), "{alone:?}");
        assert!(shared.iter().all(|ratio| *ratio >= 1.0) && shared.iter().any(|ratio| *ratio > 1.001), "{shared:?}");
    }

    #[test]
    fn a_wrong_point_in_one_image_stays_used() {
        for axis in 0..3 {
            for error in (1..=20).map(|k| 0.01 * f64::from(k)).chain([0.5, 1.0, 3.0, 10.0]) {
                let lone = |block: &mut Block| {
                    let point = block.control[3].point;
                    let mut seen = 0;
                    block.rays.retain(|ray| {
                        seen += usize::from(ray.point == point);
                        ray.point != point || seen == 1
                    });
                    block.control[3].position[axis] += error;
                    block.points[point] = block.control[3].position;
                };
                let found = tested(lone, 7, |_| Ok(true)).0.unwrap();
                let (taking, points) = named(&found);
                if !points.is_empty() {
                    println!("axis {axis} error {error}: {points:?}");
                }
                assert!(taking == 7 && points.iter().all(|(_, is_used, _)| *is_used), "axis {axis}, {error} m: {points:?}");
            }
        }
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
