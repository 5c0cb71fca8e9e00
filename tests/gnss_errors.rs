//! Lever arms, offsets and drifts of GNSS positions, on simulated blocks whose errors are known.

use super::normal::Normal;
use super::sampling::{about, about_one, runs};
use tiepoint::{
    AdjustmentOptions, AdjustmentResult, Block, BlockFlight, BlockObservation, BlockPreset, Datum, Error, GnssErrors, Loss, PositionPrior,
    SystematicError, SystematicStatistics, SystematicVerdict, adjust_block, simulate_network,
};

const STRIPS: usize = 3;
const SIGMA_M: f64 = 0.02;

/// What is wrong with the positions of a block, in metres.
#[derive(Debug, Clone, Copy, Default)]
struct Wrong {
    lever_arm: [f64; 3],
    offsets: [[f64; 3]; STRIPS],
    drifts: [[f64; 3]; STRIPS],
}

impl Wrong {
    fn of(&self, error: SystematicError) -> [f64; 3] {
        match error {
            SystematicError::LeverArm { .. } => self.lever_arm,
            SystematicError::Offset => self.offsets[0],
            SystematicError::StripOffset { strip } => self.offsets[strip],
            SystematicError::StripDrift { strip } => self.drifts[strip],
        }
    }
}

fn flight(seed: u32, control_points: usize) -> BlockFlight {
    BlockFlight { seed, strips: STRIPS, exposures: 8, points_per_image: 25.0, control_points, ..BlockPreset::Network.flight() }
}

/// A block whose positions have these errors, in strips of as many exposures as the flight has.
fn block(flight: &BlockFlight, wrong: &Wrong) -> Block {
    let simulated = simulate_network(flight).unwrap();
    let (mut block, truth) = (simulated.observed, simulated.truth);
    let mut normal = Normal(u64::from(flight.seed) << 32);
    let n = flight.exposures;
    for strip in 0..flight.strips {
        let images = strip * n..(strip + 1) * n;
        let (first, last) = (truth.images[images.start].pose.position, truth.images[images.end - 1].pose.position);
        let length = last[0] - first[0];
        let middle = images.clone().map(|image| truth.images[image].pose.position[0]).sum::<f64>() / n as f64;
        for image in images {
            let pose = &truth.images[image].pose;
            let along = (pose.position[0] - middle) / length;
            let position = [0, 1, 2].map(|k| {
                let lever: f64 = (0..3).map(|row| pose.rotation[row][k] * wrong.lever_arm[row]).sum();
                pose.position[k] + lever + wrong.offsets[strip][k] + along * wrong.drifts[strip][k] + SIGMA_M * normal.next()
            });
            block.images[image].gnss = Some(PositionPrior { position, sigma: [Some(SIGMA_M); 3] });
        }
    }
    block
}

/// By least squares alone, as all distributions are known then.
fn squares(gnss_errors: GnssErrors, gnss_lever_arm: bool) -> AdjustmentOptions {
    AdjustmentOptions {
        datum: Datum::GnssAndControl,
        loss: Loss::Squares,
        snooping: false,
        gnss_errors,
        gnss_lever_arm,
        ..AdjustmentOptions::default()
    }
}

fn errors(result: &AdjustmentResult) -> &[SystematicStatistics] {
    &result.systematic.as_ref().unwrap().errors
}

/// Squares of the errors of what was kept, by their standard errors.
fn squares_of(result: &AdjustmentResult, wrong: &Wrong) -> Vec<f64> {
    let kept = errors(result).iter().filter(|error| error.verdict == SystematicVerdict::Kept);
    let square = |found: &SystematicStatistics, k: usize| {
        let off = (found.estimate[k] - wrong.of(found.error)[k]) / found.standard_errors[k]?;
        Some(off * off)
    };
    kept.flat_map(|found| (0..3).filter_map(move |k| square(found, k))).collect()
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

const LARGE: Wrong = Wrong {
    lever_arm: [0.4, -0.6, 0.5],
    offsets: [[0.5, -0.8, 1.2], [-0.7, 0.6, 0.9], [1.1, 0.4, -0.6]],
    drifts: [[0.4, -0.5, 0.6], [0.7, 0.5, -0.4], [-0.6, 0.6, 0.5]],
};

#[test]
fn offsets_and_drifts_of_strips_are_found_within_their_standard_errors() {
    let wrong = Wrong { lever_arm: [0.0; 3], ..LARGE };
    let mut all = Vec::new();
    for seed in 1..=runs(30) as u32 {
        let found = adjust_block(&block(&flight(seed, 8), &wrong), &squares(GnssErrors::StripDrifts, false)).unwrap();
        let own = squares_of(&found, &wrong);
        assert_eq!((own.len(), found.systematic.as_ref().unwrap().constraints), (18, 0), "{seed}: {:?}", found.systematic);
        assert_eq!(found.systematic.as_ref().unwrap().strips[1].images, (8..16).collect::<Vec<_>>());
        all.extend(own);
    }
    println!("offsets and drifts: {:.3}", mean(&all));
    assert!(about_one(0.25).contains(&mean(&all)), "{}", mean(&all));
}

#[test]
fn a_lever_arm_and_an_offset_are_found_within_their_standard_errors() {
    let wrong = Wrong { offsets: [[0.5, -0.8, 1.2]; STRIPS], drifts: [[0.0; 3]; STRIPS], ..LARGE };
    let mut all = Vec::new();
    let blocks = runs(30).max(10);
    for seed in 1..=blocks as u32 {
        let given = block(&flight(seed, 8), &wrong);
        let found = adjust_block(&given, &squares(GnssErrors::Offset, true)).unwrap();
        all.extend(squares_of(&found, &wrong));
    }
    println!("lever arm and offset: {:.3} of {}", mean(&all), all.len());
    assert!(about(1.0, 0.3, 30.0 / blocks as f64).contains(&mean(&all)), "{}", mean(&all));
}

#[test]
fn right_positions_keep_no_errors_but_by_chance() {
    let (mut kept, mut tested, mut spread) = (0, 0, Vec::new());
    let blocks = runs(120).max(40);
    for seed in 1..=blocks as u32 {
        let options = AdjustmentOptions { alpha0: 0.05, ..squares(GnssErrors::StripDrifts, false) };
        let found = adjust_block(&block(&flight(seed, 8), &Wrong::default()), &options).unwrap();
        kept += errors(&found).iter().filter(|error| error.verdict == SystematicVerdict::Kept).count();
        tested += errors(&found).len();
        spread.extend(errors(&found).iter().filter_map(|error| error.test));
    }
    let share = kept as f64 / tested as f64;
    println!("kept {kept} of {tested} by chance: {share:.3}; mean test {:.2}", mean(&spread));
    assert!(about(0.05, 0.02, 120.0 / blocks as f64).contains(&share), "{share}");
}

#[test]
fn right_positions_without_control_keep_no_errors_but_by_chance() {
    let (mut kept, mut tested) = (0, 0);
    let blocks = runs(60).max(20);
    for seed in 1..=blocks as u32 {
        let options = AdjustmentOptions { alpha0: 0.05, datum: Datum::Gnss, ..squares(GnssErrors::StripDrifts, false) };
        let found = adjust_block(&block(&flight(seed, 0), &Wrong::default()), &options).unwrap();
        kept += errors(&found).iter().filter(|error| error.verdict == SystematicVerdict::Kept).count();
        tested += errors(&found).iter().filter(|error| error.test.is_some()).count();
    }
    let share = kept as f64 / tested as f64;
    println!("kept {kept} of {tested} by chance without control: {share:.3}");
    assert!(tested > blocks as usize * STRIPS, "{tested}");
    assert!(share < 0.1, "{share}");
}

#[test]
fn a_lever_arm_is_found_without_control_but_for_its_height() {
    let wrong = Wrong { offsets: [[0.0; 3]; STRIPS], drifts: [[0.0; 3]; STRIPS], ..LARGE };
    let mut all = Vec::new();
    let blocks = runs(20).max(10);
    for seed in 1..=blocks as u32 {
        let options = AdjustmentOptions { datum: Datum::Gnss, ..squares(GnssErrors::None, true) };
        let found = adjust_block(&block(&flight(seed, 0), &wrong), &options).unwrap();
        let [lever] = errors(&found) else { panic!("{:?}", found.systematic) };
        assert_eq!((lever.verdict, lever.estimate[2], lever.standard_errors[2]), (SystematicVerdict::Kept, 0.0, None));
        all.extend(squares_of(&found, &wrong));
    }
    println!("lever arm without control: {:.3}", mean(&all));
    assert_eq!(all.len(), 2 * blocks as usize);
    assert!(about(1.0, 0.45, 20.0 / blocks as f64).contains(&mean(&all)), "{}", mean(&all));
}

#[test]
fn a_single_wrong_strip_is_the_one_that_is_kept() {
    let mut wrong = Wrong::default();
    wrong.offsets[1] = [0.3, -0.2, 0.4];
    for seed in 1..=5 {
        let found = adjust_block(&block(&flight(seed, 8), &wrong), &squares(GnssErrors::StripOffsets, false)).unwrap();
        let verdicts: Vec<bool> = errors(&found).iter().map(|error| error.verdict == SystematicVerdict::Kept).collect();
        assert_eq!(verdicts, [false, true, false], "{seed}: {:?}", found.systematic);
        assert!(squares_of(&found, &wrong).iter().all(|square| *square < 16.0), "{seed}: {:?}", errors(&found)[1]);
    }
}

/// Parallel strips tell neither the shift of the block from offsets nor its roll, which is one of heights.
#[test]
fn without_control_offsets_are_those_beside_their_mean() {
    let offsets = [[0.5, -0.8, 0.6], [-0.7, 0.6, -1.2], [1.1, 0.4, 0.6]];
    let middle = [0, 1, 2].map(|k| offsets.iter().map(|offset| offset[k]).sum::<f64>() / STRIPS as f64);
    let wrong = Wrong { offsets, ..Wrong::default() };
    let mut all = Vec::new();
    for seed in 1..=runs(30) as u32 {
        let options = AdjustmentOptions { datum: Datum::Gnss, ..squares(GnssErrors::StripOffsets, false) };
        let found = adjust_block(&block(&flight(seed, 0), &wrong), &options).unwrap();
        assert_eq!(found.systematic.as_ref().unwrap().constraints, 4);
        for (error, offset) in errors(&found).iter().zip(offsets) {
            assert_eq!(error.verdict, SystematicVerdict::Kept);
            let off = |k: usize| (error.estimate[k] - offset[k] + middle[k]) / error.standard_errors[k].unwrap();
            all.extend((0..2).map(|k| off(k) * off(k)));
        }
    }
    println!("offsets beside their mean: {:.3}", mean(&all));
    assert!(about_one(0.3).contains(&mean(&all)), "{}", mean(&all));
}

/// Three strips with an image in each turn between them, which has an error of its own.
fn block_with_turns(seed: u32, offsets: &[[f64; 3]; STRIPS], of_turns: [f64; 3]) -> Block {
    let flight = BlockFlight { strips: 5, side_overlap: 0.75, ..flight(seed, 0) };
    let simulated = simulate_network(&flight).unwrap();
    let (mut block, truth) = (simulated.observed, simulated.truth);
    let n = flight.exposures;
    // Every second strip gives one image alone, at the end where the strip before it ends.
    let near = |strip: usize| {
        let last = truth.images[strip * n - 1].pose.position[0];
        let off = |image: &usize| (truth.images[*image].pose.position[0] - last).abs();
        (strip * n..(strip + 1) * n).min_by(|a, b| off(a).total_cmp(&off(b))).unwrap()
    };
    let kept: Vec<usize> = (0..5)
        .flat_map(|strip: usize| if strip.is_multiple_of(2) { (strip * n..(strip + 1) * n).collect() } else { vec![near(strip)] })
        .collect();
    let mut normal = Normal(u64::from(seed) << 32);
    for image in &kept {
        let strip = image / n;
        let off = if strip.is_multiple_of(2) { offsets[strip / 2] } else { of_turns };
        let position = [0, 1, 2].map(|k| truth.images[*image].pose.position[k] + off[k] + SIGMA_M * normal.next());
        block.images[*image].gnss = Some(PositionPrior { position, sigma: [Some(SIGMA_M); 3] });
    }
    block.images = kept.iter().map(|image| block.images[*image].clone()).collect();
    let place = |image: usize| kept.iter().position(|own| *own == image);
    block.rays = block.rays.into_iter().filter_map(|ray| Some(BlockObservation { image: place(ray.image)?, ..ray })).collect();
    block
}

#[test]
fn images_in_turns_do_not_decide_where_a_block_lies() {
    let offsets = [[0.5, -0.8, 0.6], [-0.7, 0.6, -1.2], [1.1, 0.4, 0.6]];
    let middle = [0, 1, 2].map(|k| offsets.iter().map(|offset| offset[k]).sum::<f64>() / STRIPS as f64);
    let turns = [8, 17];
    let mut all = Vec::new();
    for seed in 1..=10 {
        let options = AdjustmentOptions { datum: Datum::Gnss, ..squares(GnssErrors::StripOffsets, false) };
        let found = adjust_block(&block_with_turns(seed, &offsets, [0.3, 0.5, -0.4]), &options).unwrap();
        let systematic = found.systematic.as_ref().unwrap();
        assert_eq!(systematic.strips.iter().map(|strip| strip.images[0]).collect::<Vec<_>>(), [0, 9, 18]);
        assert_eq!((systematic.constraints, &systematic.left_out[..]), (4, &turns[..]), "{seed}: {systematic:?}");
        assert!((0..26).all(|image| found.images[image].gnss.unwrap().accepted != turns.contains(&image)), "{seed}");
        for (error, offset) in errors(&found).iter().zip(offsets) {
            assert_eq!(error.verdict, SystematicVerdict::Kept);
            all.extend(
                (0..2).map(|k| (error.estimate[k] - offset[k] + middle[k]) / error.standard_errors[k].unwrap()).map(|off| off * off),
            );
        }
    }
    println!("offsets beside turns: {:.3}", mean(&all));
    assert!((0.6..1.4).contains(&mean(&all)), "{}", mean(&all));
}

/// One whose offset is nearly their mean holds the others then: no observation of the ground does.
#[test]
fn a_strip_that_is_fixed_at_zero_leaves_the_others_relative() {
    let mut wrong = Wrong::default();
    wrong.offsets[1] = [0.6, -0.4, 0.0];
    let mut fixed = 0;
    for seed in 1..=5 {
        let options = AdjustmentOptions { datum: Datum::Gnss, ..squares(GnssErrors::StripOffsets, false) };
        let mut given = block(&flight(seed, 0), &wrong);
        given.images.iter_mut().take(8).for_each(|image| image.gnss.as_mut().unwrap().position[0] += 0.3);
        given.images.iter_mut().take(8).for_each(|image| image.gnss.as_mut().unwrap().position[1] -= 0.2);
        let found = adjust_block(&given, &options).unwrap();
        fixed += errors(&found).iter().filter(|error| error.verdict == SystematicVerdict::NotSignificant).count();
        assert_eq!(found.systematic.as_ref().unwrap().constraints, 4, "{seed}: {:?}", found.systematic);
    }
    assert!(fixed > 0);
}

/// Neither an offset of all nor a lever arm explains a strip that is off.
#[test]
fn without_errors_of_strips_those_are_forgiven_nothing() {
    let mut wrong = Wrong::default();
    wrong.offsets[1] = [9.0, -6.0, 12.0];
    let given = block(&flight(1, 8), &wrong);
    let accepted = |errors, lever_arm| -> Vec<bool> {
        let found = adjust_block(&given, &squares(errors, lever_arm)).unwrap();
        found.images.iter().map(|image| image.gnss.unwrap().accepted).collect()
    };
    let plain = accepted(GnssErrors::None, false);
    assert!((0..24).all(|image| plain[image] != (8..16).contains(&image)), "{plain:?}");
    assert!(accepted(GnssErrors::Offset, false) == plain && accepted(GnssErrors::None, true) == plain);
    assert!(accepted(GnssErrors::StripOffsets, false).iter().all(|accepted| *accepted));
}

#[test]
fn without_control_drifts_are_estimated_but_for_motions_of_the_block() {
    let wrong = Wrong { lever_arm: [0.0; 3], ..LARGE };
    let options = AdjustmentOptions { datum: Datum::Gnss, ..squares(GnssErrors::StripDrifts, false) };
    let found = adjust_block(&block(&flight(3, 0), &wrong), &options).unwrap();
    let systematic = found.systematic.as_ref().unwrap();
    assert_eq!(systematic.constraints, 7, "{systematic:?}");
    let residual =
        found.images.iter().filter_map(|image| image.gnss).flat_map(|gnss| gnss.residual).fold(0.0, |most: f64, v| most.max(v.abs()));
    assert!(residual < 0.1, "{residual}");
}

#[test]
fn an_offset_of_all_positions_is_undetermined_without_control() {
    let wrong = Wrong { offsets: [[0.5, -0.8, 1.2]; STRIPS], ..Wrong::default() };
    let given = block(&flight(1, 0), &wrong);
    let plain = adjust_block(&given, &AdjustmentOptions { datum: Datum::Gnss, ..squares(GnssErrors::None, false) }).unwrap();
    let found = adjust_block(&given, &AdjustmentOptions { datum: Datum::Gnss, ..squares(GnssErrors::Offset, false) }).unwrap();
    assert_eq!(errors(&found)[0].verdict, SystematicVerdict::Undetermined);
    assert_eq!((errors(&found)[0].estimate, errors(&found)[0].test), ([0.0; 3], None));
    assert!(found.block == plain.block && plain.systematic.is_none());
    let with_control = adjust_block(&block(&flight(1, 8), &wrong), &squares(GnssErrors::Offset, false)).unwrap();
    assert_eq!(errors(&with_control)[0].verdict, SystematicVerdict::Kept);
}

#[test]
fn a_datum_without_positions_has_no_errors_of_them() {
    let options = AdjustmentOptions { datum: Datum::Control, ..squares(GnssErrors::StripDrifts, true) };
    let given = block(&flight(1, 8), &LARGE);
    let found = adjust_block(&given, &options).unwrap();
    assert_eq!(found, adjust_block(&given, &AdjustmentOptions { datum: Datum::Control, ..squares(GnssErrors::None, false) }).unwrap());
    assert!(found.systematic.is_none());
}

#[test]
fn gross_positions_are_rejected_beside_errors_of_strips_and_weights_follow_what_is_left() {
    let wrong = Wrong { lever_arm: [0.0; 3], ..LARGE };
    let flight = BlockFlight { exposures: 14, points_per_image: 60.0, ..flight(2, 8) };
    let options =
        AdjustmentOptions { loss: Loss::Cauchy, snooping: true, variance_components: true, ..squares(GnssErrors::StripDrifts, false) };
    for seed in 2..=4 {
        let mut given = block(&BlockFlight { seed, ..flight.clone() }, &wrong);
        given.images[20].gnss.as_mut().unwrap().position[0] += 60.0;
        given.images[33].gnss.as_mut().unwrap().position[2] += 0.3;
        let found = adjust_block(&given, &options).unwrap();
        let rejected: Vec<usize> = (0..42).filter(|image| found.images[*image].gnss.is_some_and(|gnss| !gnss.accepted)).collect();
        assert_eq!(rejected, [20, 33], "{seed}");
        let own = squares_of(&found, &wrong);
        assert!(own.len() == 18 && own.iter().all(|square| *square < 16.0), "{seed}: {:?}", found.systematic);
        // Without them, errors of positions look far larger than they are stated.
        assert!(found.components.iter().all(|component| (0.6..1.6).contains(&component.factor)), "{seed}: {:?}", found.components);
        let plain = adjust_block(&given, &AdjustmentOptions { gnss_errors: GnssErrors::None, ..options.clone() });
        // Or they pull images off their rays.
        let is_worse = plain.as_ref().is_ok_and(|plain| plain.components.iter().any(|component| component.factor > 5.0));
        assert!(is_worse || plain.is_err(), "{seed}: {:?}", plain.map(|plain| plain.components));
    }
}

#[test]
fn redundancy_numbers_come_to_the_degrees_of_freedom() {
    for (datum, control) in [(Datum::GnssAndControl, 8), (Datum::Gnss, 0)] {
        let options = AdjustmentOptions { datum, ..squares(GnssErrors::StripDrifts, true) };
        let found = adjust_block(&block(&flight(4, control), &LARGE), &options).unwrap();
        let rays: f64 = found.rays.iter().filter_map(|ray| ray.redundancy).map(|r| r[0] + r[1]).sum();
        let positions = found.images.iter().filter_map(|image| image.gnss).chain(found.control.iter().flatten().copied());
        let all = rays + positions.filter_map(|prior| prior.redundancy).flatten().sum::<f64>();
        assert!((all - found.degrees_of_freedom as f64).abs() < 0.01, "{datum:?}: {all} {}", found.degrees_of_freedom);
    }
}

#[test]
fn what_was_found_survives_json() -> Result<(), Error> {
    let found = adjust_block(&block(&flight(1, 8), &LARGE), &squares(GnssErrors::StripDrifts, true))?;
    let text = serde_json::to_string(&found.systematic).unwrap();
    let read: Option<tiepoint::SystematicResult> = serde_json::from_str(&text).unwrap();
    assert_eq!(read.unwrap().errors.len(), 7);
    assert!(text.contains(r#"{"kind":"lever_arm","camera":0}"#), "{text}");
    Ok(())
}
