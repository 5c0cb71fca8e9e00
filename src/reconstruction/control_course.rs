//! The order in which control points of a block are left out and taken again, from one adjustment to the next, and what is told of them in the end.

use super::control_test::{ControlTest, fits, of_residuals};
use super::material::Known;
use crate::adjustment::{AdjustmentResult, Block, Datum, ObservationVerdict, far_control};
use crate::math::{median, normal_median_within};
use std::borrow::Cow;
use std::collections::BTreeMap;

/// Positions, of images or control points, that have to be left: fewer do not tell which of them is wrong.
pub(super) const LEAST_LEFT: usize = 4;
/// So many of few control points may be wrong, of many this share: more contradict the block as a whole.
const FEW_WRONG: usize = 3;
const MANY_WRONG: f64 = 0.15;
/// Standard error of the median size of a normal number, by the root of how many there are, as a share of it.
const MEDIAN_ERROR: f64 = 1.166;
/// Standard errors that are stated too small make no point wrong: by so many of its standard errors the median of the tests is too large then.
const BEYOND: f64 = 2.0;
/// That standard errors are stated too small shows where the coordinates fulfil so many conditions: of fewer one wrong point makes up the median.
const LEAST_CONDITIONS: usize = 12;
/// Position, rotation and scale of a block.
const FREEDOMS: usize = 7;
/// Standard errors that were stated too small by more are a contradiction.
const MOST_TOO_SMALL: f64 = 3.0;
/// Up to so many control points each is left out alone, and each is tested by the stated standard errors first.
pub(super) const MOST_ALONE: usize = 12;
/// Image measurements of a point that tell a wrong one among them from wrong coordinates.
const LEAST_MARKS: usize = 3;

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
    /// Whether enough is left without it to tell that it is the wrong one.
    pub is_certain: bool,
    /// Whether a warning names it: otherwise it is one of those that contradict each other.
    pub is_named: bool,
}

/// Control points that contradict each other or the other observations, where nothing tells which are wrong.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Contradicting {
    pub refused: usize,
    /// Of so many that were tested.
    pub of: usize,
    /// The largest test.
    pub w: f64,
}

/// What became of the control points of a block.
#[derive(Debug, Default)]
pub(super) struct ControlTests {
    /// In the order of the block's control points.
    pub refused: Vec<Refused>,
    /// Errors that the tests of each point that was tested find with a probability of 0.80, by the index of the point in the adjusted block.
    pub detectable: BTreeMap<usize, [Option<f64>; 3]>,
    pub contradicting: Option<Contradicting>,
    /// Where the block has no adjustment without those that were to be left out, and all take part: how many they are, of how many that were tested.
    pub stopped: Option<[usize; 2]>,
    /// The points, by their indices in the adjusted block, that take no part since the block has no adjustment of any kind with them; the others do not
    /// place it either.
    pub unadjusted: Vec<usize>,
}

pub(super) enum Next {
    /// Other control points take part now.
    Again,
    Done,
    /// Too many would have to be left out.
    Contradiction,
}

/// What changes from one adjustment to the next; control points by their indices in the block.
pub(super) struct Course<'a> {
    pub block: &'a Block,
    /// The others take part as they are.
    pub is_tested: &'a [bool],
    known: &'a Known<'a>,
    datum: Datum,
    pub is_refused: Vec<bool>,
    /// What was tried takes part to the end.
    is_settled: Vec<bool>,
    /// The one that was left out last since its own test was the largest: it does not take part again before another one is found wrong.
    last: Option<usize>,
    /// With these the block was not placed.
    pub keeps_from_placing: Vec<bool>,
    /// Of one that is tried without its coordinates: the largest test of its image measurements that were rejected beside them, of which the most fitted.
    rivals: Vec<f64>,
    /// Whether the limit of the tests grows with their scatter.
    pub is_enlarged: bool,
}

/// The tests of all control points, absent where nothing checks them; and what they are compared with.
pub(super) struct Tests {
    pub of: Vec<Option<ControlTest>>,
    pub limit: f64,
    /// By how much standard errors are stated too small, as the tests of those that take part have it: 1 where they do not say.
    pub scale: f64,
}

impl Tests {
    /// Whether this scatter may be that of standard errors that were stated too small.
    pub fn may_grow(&self) -> bool {
        self.scale > 1.0 && self.scale <= MOST_TOO_SMALL
    }

    /// The limit beside the scatter of the tests.
    fn enlarged(&self, plain: f64) -> f64 {
        plain * self.scale.min(MOST_TOO_SMALL)
    }
}

impl<'a> Course<'a> {
    pub fn new(block: &'a Block, is_tested: &'a [bool], known: &'a Known<'a>, datum: Datum) -> Self {
        let number = block.control.len();
        let (is_refused, is_settled, rivals) = (vec![false; number], vec![false; number], vec![0.0; number]);
        let keeps_from_placing = vec![false; number];
        let mut course =
            Self { block, is_tested, known, datum, is_refused, is_settled, last: None, keeps_from_placing, rivals, is_enlarged: false };
        // Of many points a wrong one does not make up the median of the tests.
        course.is_enlarged = course.tested() > MOST_ALONE;
        let far: Vec<usize> = far_control(block, datum).into_iter().filter(|control| is_tested[*control]).collect();
        if far.len() <= course.most() && number - far.len() + course.images() >= LEAST_LEFT {
            far.into_iter().for_each(|control| course.is_refused[control] = true);
        }
        course
    }

    /// Forgets what was tried; begins without one of them, or with all.
    pub fn start_with(&mut self, without: Option<usize>) {
        self.is_refused.fill(false);
        self.is_settled.fill(false);
        self.rivals.fill(0.0);
        self.last = without;
        without.into_iter().for_each(|control| self.is_refused[control] = true);
    }

    /// How many image measurements of those that take part were rejected.
    pub fn rejected(&self, adjusted: &AdjustmentResult) -> usize {
        let mut takes_part = vec![false; adjusted.block.points.len()];
        adjusted.block.control.iter().for_each(|control| takes_part[control.point] = true);
        let of_rays = adjusted.block.rays.iter().zip(&adjusted.rays);
        of_rays.filter(|(ray, statistics)| takes_part[ray.point] && statistics.verdict != ObservationVerdict::Accepted).count()
    }

    /// The block with the control points that take part.
    pub fn taking(&self) -> Cow<'a, Block> {
        if !self.is_refused.contains(&true) {
            return Cow::Borrowed(self.block);
        }
        let mut block = self.block.clone();
        let mut refused = self.is_refused.iter();
        block.control.retain(|_| refused.next() == Some(&false));
        Cow::Owned(block)
    }

    /// Images with a GNSS position that may take part.
    pub fn images(&self) -> usize {
        self.block.images.iter().filter(|image| image.gnss.is_some() && self.datum.uses_gnss()).count()
    }

    pub fn tested(&self) -> usize {
        self.is_tested.iter().filter(|tested| **tested).count()
    }

    /// How many may be refused.
    pub fn most(&self) -> usize {
        let number = self.tested();
        (number.saturating_sub(1) / 2).min(FEW_WRONG).max((MANY_WRONG * number as f64) as usize)
    }

    pub fn refused(&self) -> usize {
        self.is_refused.iter().filter(|refused| **refused).count()
    }

    pub fn tests(&self, adjusted: &AdjustmentResult) -> Tests {
        let of: Vec<Option<ControlTest>> =
            (0..self.is_refused.len()).map(|control| self.test(adjusted, control).filter(|_| self.is_tested[control])).collect();
        let taking = of.iter().zip(&self.is_refused).filter(|(_, refused)| !**refused).filter_map(|(test, _)| test.as_ref());
        let mut sizes: Vec<f64> = taking.flat_map(ControlTest::values).filter(|value| *value > 0.0).collect();
        let limit = self.limit();
        let conditions = self.conditions(adjusted);
        let certain = 1.0 + BEYOND * MEDIAN_ERROR / (conditions.max(1) as f64).sqrt();
        let scale = median(&mut sizes).map(|middle| middle / normal_median_within(limit));
        let scale = scale.filter(|scale| *scale > certain && conditions >= LEAST_CONDITIONS).unwrap_or(1.0);
        let tests = Tests { of, limit, scale };
        if self.is_enlarged { self.enlarged(tests) } else { tests }
    }

    /// With the limit beside the scatter of the tests, and the errors that are found so.
    pub fn enlarged(&self, tests: Tests) -> Tests {
        let limit = tests.enlarged(self.limit());
        let of = tests.of.iter().map(|test| Some(test.as_ref()?.within(limit / tests.limit))).collect();
        Tests { of, limit, ..tests }
    }

    fn limit(&self) -> f64 {
        self.known.options.adjustment.limit()
    }

    /// How many conditions the coordinates that are tested and take part fulfil by their errors alone: all positions together give the block its seven freedoms.
    fn conditions(&self, adjusted: &AdjustmentResult) -> usize {
        let taking = self.is_tested.iter().zip(&self.is_refused).filter(|(tested, refused)| **tested && !**refused).count();
        (3 * taking).min((3 * self.left(adjusted)).saturating_sub(FREEDOMS))
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
    pub fn beyond<'t>(&'t self, tests: &'t Tests) -> impl Iterator<Item = (usize, &'t ControlTest)> {
        let all = tests.of.iter().enumerate().filter(|(control, _)| !self.is_refused[*control]);
        all.filter_map(|(control, test)| Some((control, test.as_ref()?))).filter(|(_, test)| test.size() > tests.limit)
    }

    pub fn next(&mut self, adjusted: &AdjustmentResult, tests: &Tests) -> Next {
        // Of a wrong coordinate and a wrong image measurement that explain each other, the one with the larger test is wrong.
        let fits = |control: &usize| fits(tests.of[*control].as_ref(), tests.limit.max(self.rivals[*control]));
        let may_return = |control: &usize| self.is_refused[*control] && self.last != Some(*control);
        let back: Vec<usize> = (0..self.is_refused.len()).filter(may_return).filter(fits).collect();
        if !back.is_empty() {
            back.into_iter().for_each(|control| (self.is_refused[control], self.is_settled[control]) = (false, true));
            return Next::Again;
        }
        let may_go = self.left(adjusted) > LEAST_LEFT;
        // One of which no image measurement fits holds nothing: without its coordinates the others are what they were.
        let is_open = |worst: &Unmeasured| self.refused() < self.most() && (may_go || worst.is_lost);
        if let Some(worst) = self.unmeasured(adjusted).filter(is_open) {
            (self.is_refused[worst.control], self.rivals[worst.control]) = (true, worst.rival());
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

    /// Positions that take part, of control points and images.
    pub fn left(&self, adjusted: &AdjustmentResult) -> usize {
        let gnss = adjusted.images.iter().filter(|image| image.gnss.is_some_and(|gnss| gnss.accepted)).count();
        self.is_refused.len() - self.refused() + gnss
    }

    /// Has those take part again of which the others say within the scatter of all tests that they are right; whether there are any.
    pub fn take_back(&mut self, tests: &Tests) -> bool {
        let limit = tests.enlarged(self.limit());
        let is_back = |control: &usize| {
            let may_return = tests.may_grow() && self.is_refused[*control] && !self.keeps_from_placing[*control];
            may_return && fits(tests.of[*control].as_ref(), limit.max(self.rivals[*control]))
        };
        let back: Vec<usize> = (0..self.is_refused.len()).filter(is_back).collect();
        self.is_enlarged |= !back.is_empty();
        back.iter().for_each(|control| (self.is_refused[*control], self.is_settled[*control]) = (false, true));
        !back.is_empty()
    }

    /// Where the block has no adjustment but without those that take no part now.
    pub fn unadjusted(&self) -> ControlTests {
        let refused = self.block.control.iter().zip(&self.is_refused).filter(|(_, refused)| **refused);
        ControlTests { unadjusted: refused.map(|(control, _)| control.point).collect(), ..ControlTests::default() }
    }

    pub fn done(&self, adjusted: &AdjustmentResult, tests: &Tests) -> ControlTests {
        let beyond: Vec<usize> = self.beyond(tests).map(|(control, _)| control).collect();
        let is_certain = self.left(adjusted) >= LEAST_LEFT;
        let refused = |control: usize| {
            let (point, is_used) = (self.block.control[control].point, !self.is_refused[control]);
            if is_used && self.is_lost(adjusted, control) {
                return Some(Refused { point, test: None, is_used: false, is_within: false, is_certain: false, is_named: true });
            }
            let is_named = !is_used || beyond.binary_search(&control).is_ok();
            let test = tests.of[control];
            let is_within = !is_used && self.keeps_from_placing[control] && fits(test.as_ref(), tests.limit);
            is_named.then_some(Refused { point, test, is_used, is_within, is_certain: is_certain && !is_used, is_named })
        };
        let refused = (0..self.is_refused.len()).filter_map(refused).collect();
        ControlTests { refused, detectable: self.detectable(tests), ..ControlTests::default() }
    }

    /// Whether a point that is to take part does not, since none of its image measurements fit.
    fn is_lost(&self, adjusted: &AdjustmentResult, control: usize) -> bool {
        let place = adjusted.block.control.iter().position(|of| of.point == self.block.control[control].point);
        self.is_tested[control] && place.is_some_and(|place| adjusted.control[place].is_none())
    }

    pub fn detectable(&self, tests: &Tests) -> BTreeMap<usize, [Option<f64>; 3]> {
        let points = self.block.control.iter().map(|control| control.point);
        points.zip(&tests.of).filter_map(|(point, test)| Some((point, test.as_ref()?.detectable))).collect()
    }

    /// The control point that takes part and whose image measurements were rejected, most of them or one of three and more, where it was not tried
    /// without its coordinates; with the largest test of those where the others fitted. Of several the one of which all were rejected, then one of which
    /// most were, then the one with the largest test: a wrong point pulls the block off the measurements of its neighbours.
    pub fn unmeasured(&self, adjusted: &AdjustmentResult) -> Option<Unmeasured> {
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
        Unmeasured::worst(doubtful)
    }
}

/// A control point of which image measurements were rejected.
pub(super) struct Unmeasured {
    pub control: usize,
    /// Whether all were.
    pub is_lost: bool,
    /// Whether most were.
    is_most: bool,
    rejected: usize,
    /// Their largest test; 0 where none fitted, which leaves nothing to test them by.
    largest: f64,
}

impl Unmeasured {
    /// The test of a wrong image measurement that may explain what the coordinates seem to be off by: none where most were rejected.
    pub fn rival(&self) -> f64 {
        if self.is_most { 0.0 } else { self.largest }
    }

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

#[cfg(test)]
mod tests {
    use super::Unmeasured;

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
