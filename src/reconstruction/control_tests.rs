//! Which control points contradict the other observations of a block: found one after the other, the largest test first, each left out before the
//! others are judged, so that a wrong point accuses none of its neighbours.
//!
//! A wrong coordinate shows in the test of its residual. One that is far off does not: the image measurements of its point are rejected as gross
//! errors before. So a point is tried without its coordinates, too, where image measurements of it were rejected, and from the start where it
//! lies far from the similarity on which most positions agree. Where the other observations then have it within chance, it takes part again.
//!
//! # Source
//! Baarda 1968, A testing procedure for use in geodetic networks.
use super::control_course::{Contradicting, ControlTests, Course, LEAST_LEFT, MOST_ALONE, Next, Refused, Tests};
use super::control_test::{ControlTest, fits};
use super::material::Known;
use super::placing::Placing;
use crate::Error;
use crate::adjustment::{AdjustmentResult, Block, Datum};

pub(super) type Adjusted = (AdjustmentResult, Placing);

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
            Next::Done if !course.is_enlarged && course.take_back(&tests) => kept = Some(Kept { adjusted, placing, tests, is_refused }),
            Next::Done => {
                let tests = if tests.may_grow() && !course.is_enlarged { course.enlarged(tests) } else { tests };
                return Ok(course.told((adjusted, placing), &tests, &adjust));
            }
            Next::Contradiction => {
                let beyond = course.refused() + course.beyond(&tests).count();
                let of_all = if is_placed_by_all == Some(false) { None } else { adjust(block).ok().filter(is_placed) };
                let Some((adjusted, placing)) = of_all else { return Ok(course.told((adjusted, placing), &tests, &adjust)) };
                course.is_refused.fill(false);
                let of_all = course.tests(&adjusted);
                if !course.is_enlarged && of_all.may_grow() {
                    course.start_with(None);
                    course.is_enlarged = true;
                    continue;
                }
                let w = of_all.of.iter().flatten().map(ControlTest::size).fold(0.0, f64::max);
                let mut told = course.done(&adjusted, &of_all);
                told.refused.retain(|refused| !refused.is_used);
                told.contradicting = Some(Contradicting { refused: beyond, of: course.tested(), w });
                return Ok((adjusted, placing, told));
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
pub(super) fn is_placed((adjusted, placing): &Adjusted) -> bool {
    adjusted.datum.uses_control() && !matches!(placing, Placing::Free { .. })
}

/// A course that begins again.
impl Course<'_> {
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
        let mut told = self.done(&adjusted, &tests);
        // What was to be left out by its test may accuse its neighbours.
        let is_doubted = |refused: &Refused| refused.is_used && doubted.contains(&refused.point);
        if told.refused.iter().any(is_doubted) {
            told.refused.retain(|refused| !refused.is_used || is_doubted(refused));
        }
        // Where some take no part warnings name them.
        told.stopped = (self.refused() == 0).then(|| [left_out, self.tested()]);
        (adjusted, placing, told)
    }
}

#[cfg(test)]
mod tests {
    use super::{ControlTests, Refused, tested_control};
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
            let (points, _) = tie_points(&simulated.matches().unwrap(), &simulated.image_features(), &BlockOptions::default()).unwrap();
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
                assert!(taking == 7 && points.iter().all(|(_, is_used, _)| *is_used), "axis {axis}, {error} m: {points:?}");
            }
        }
    }
}
