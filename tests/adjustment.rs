//! The bundle adjustment on simulated blocks whose every answer is known.

use super::sampling::{about_one, runs};
use tiepoint::{
    AdjustmentOptions, AdjustmentResult, Block, BlockFlight, BlockPreset, BlockView, CameraPrior, Datum, FreeParameters, Loss,
    ObservationVerdict, SimulatedNetwork, adjust_block, angles_from_rotation, simulate_network,
};

/// A block that starts from the truth: the errors of a free network then lie in its own datum.
fn from_truth(flight: &BlockFlight) -> SimulatedNetwork {
    simulate_network(&BlockFlight { approximate_m: 0.0, ..flight.clone() }).unwrap()
}

fn squares() -> AdjustmentOptions {
    AdjustmentOptions { loss: Loss::Squares, snooping: false, ..AdjustmentOptions::default() }
}

fn angles(rotation: &[[f64; 3]; 3]) -> [f64; 3] {
    angles_from_rotation(&nalgebra::Matrix3::from_fn(|r, c| rotation[r][c]))
}

/// Errors by their standard errors: of angles, positions and points.
fn standardised(result: &AdjustmentResult, truth: &Block) -> [Vec<f64>; 3] {
    let (mut turns, mut positions, mut points) = (Vec::new(), Vec::new(), Vec::new());
    for ((image, true_image), statistics) in result.block.images.iter().zip(&truth.images).zip(&result.images) {
        let (got, wanted) = (angles(&image.pose.rotation), angles(&true_image.pose.rotation));
        let errors = statistics.angle_errors_deg.unwrap();
        for k in 0..3 {
            let turn = (got[k] - wanted[k]).to_degrees();
            turns.push((turn + 540.0).rem_euclid(360.0) - 180.0);
            *turns.last_mut().unwrap() /= errors[k];
            positions.push((image.pose.position[k] - true_image.pose.position[k]) / statistics.position_errors.unwrap()[k]);
        }
    }
    for ((point, true_point), statistics) in result.block.points.iter().zip(&truth.points).zip(&result.points) {
        if let Some(statistics) = statistics {
            let errors = statistics.errors.unwrap();
            points.extend((0..3).map(|k| (point[k] - true_point[k]) / errors[k]));
        }
    }
    [turns, positions, points]
}

fn mean_square(values: &[f64]) -> f64 {
    values.iter().map(|v| v * v).sum::<f64>() / values.len() as f64
}

/// The square of standardised errors by their correlations, for each of them: 1 on average.
fn together(errors: &[f64], correlation: impl Fn(usize, usize) -> f64) -> f64 {
    let n = errors.len();
    let errors = nalgebra::DVector::from_column_slice(errors);
    let inverse = nalgebra::DMatrix::from_fn(n, n, correlation).try_inverse().unwrap();
    (errors.transpose() * inverse * &errors)[0] / n as f64
}

/// Errors of a block go together, so that a mean square tells something only over many blocks.
const RUNS: u64 = 30;

/// Mean squares of the standardised errors of many simulations of a block.
fn mean_squares(flight: &BlockFlight, options: &AdjustmentOptions, all_runs: u64) -> [f64; 3] {
    let mut all: [Vec<f64>; 3] = Default::default();
    for seed in 1..=runs(all_runs) {
        let simulated = from_truth(&BlockFlight { seed: seed as u32, ..flight.clone() });
        let result = adjust_block(&simulated.observed, options).unwrap();
        for (all, own) in all.iter_mut().zip(standardised(&result, &simulated.truth)) {
            all.extend(own);
        }
    }
    all.map(|values| mean_square(&values))
}

fn within(what: &str, values: [f64; 3]) {
    println!("{what}: angles {:.3}, positions {:.3}, points {:.3}", values[0], values[1], values[2]);
    assert!(values.iter().all(|v| about_one(0.1).contains(v)), "{what}: {values:?}");
}

#[test]
fn errors_of_a_free_nadir_block_are_as_large_as_told() {
    within("nadir", mean_squares(&BlockPreset::Network.flight(), &squares(), 24 * RUNS));
}

#[test]
fn errors_of_a_free_oblique_block_are_as_large_as_told() {
    let flight = BlockFlight { view: BlockView::Oblique, strips: 3, exposures: 4, points_per_image: 25.0, ..BlockPreset::Network.flight() };
    within("oblique", mean_squares(&flight, &squares(), 12 * RUNS));
}

#[test]
fn errors_of_a_self_calibrated_block_are_as_large_as_told() {
    let flight = BlockFlight {
        view: BlockView::TwoHeights,
        radial: [-0.05, 0.02, 0.0],
        tangential: [0.001, -0.0005],
        receiver_m: 0.03,
        ..BlockPreset::Network.flight()
    };
    let options = AdjustmentOptions { datum: Datum::GnssAndControl, sigma0_px: Some(flight.noise_px), ..squares() };
    let mut all: [Vec<f64>; 4] = Default::default();
    let (mut of_cameras, mut of_positions) = (Vec::new(), Vec::new());
    for seed in 1..=runs(4 * RUNS) {
        let flight = BlockFlight { seed: seed as u32, control_points: 5, ..flight.clone() };
        let mut simulated = simulate_network(&flight).unwrap();
        let camera = &mut simulated.observed.cameras[0];
        camera.focal_px *= 1.01;
        camera.principal_point_px = [2000.0, 1500.0];
        (camera.radial, camera.tangential) = ([0.0; 3], [0.0; 2]);
        camera.free = FreeParameters { radial: 2, ..FreeParameters::ALL };
        let result = adjust_block(&simulated.observed, &options).unwrap();
        assert!(result.cameras[0].fixed.is_empty(), "{:?}", result.cameras[0]);
        let (own, wanted) = (&result.block.cameras[0], &simulated.truth.cameras[0]);
        let errors = [
            own.focal_px - wanted.focal_px,
            own.principal_point_px[0] - wanted.principal_point_px[0],
            own.principal_point_px[1] - wanted.principal_point_px[1],
            own.radial[0] - wanted.radial[0],
            own.radial[1] - wanted.radial[1],
            own.tangential[0] - wanted.tangential[0],
            own.tangential[1] - wanted.tangential[1],
        ];
        let told = [0, 1, 2, 3, 4, 6, 7].map(|k| result.cameras[0].standard_errors[k].unwrap());
        let standard: Vec<f64> = errors.iter().zip(told).map(|(error, told)| error / told).collect();
        of_cameras.push(together(&standard, |i, j| result.cameras[0].correlations[i][j]));
        all[3].extend(standard);
        for ((image, truth), statistics) in result.block.images.iter().zip(&simulated.truth.images).zip(&result.images) {
            let error = |k: usize| (image.pose.position[k] - truth.pose.position[k]) / statistics.position_errors.unwrap()[k];
            let [xy, xz, yz] = statistics.position_correlations.unwrap();
            let correlations = [[1.0, xy, xz], [xy, 1.0, yz], [xz, yz, 1.0]];
            of_positions.push(together(&[0, 1, 2].map(error), |i, j| correlations[i][j]));
        }
        for (all, own) in all.iter_mut().zip(standardised(&result, &simulated.truth)) {
            all.extend(own);
        }
    }
    let camera = mean_square(&all[3]);
    println!("camera: {camera:.3}");
    assert!(about_one(0.4).contains(&camera), "{camera}");
    for (what, squares) in [("camera", of_cameras), ("positions", of_positions)] {
        let mean = squares.iter().sum::<f64>() / squares.len() as f64;
        println!("{what}, with correlations: {mean:.3}");
        assert!(about_one(0.4).contains(&mean), "{what}: {mean}");
    }
    within("two heights, self-calibrated", [0, 1, 2].map(|k| mean_square(&all[k])));
}

#[test]
fn a_camera_that_is_known_beforehand_stays_where_it_is_known_to_be() {
    // Level ground from one height says nothing of the focal length.
    let flight = BlockFlight { relief_m: 0.0, receiver_m: 0.0, ..BlockPreset::Network.flight() };
    let mut simulated = simulate_network(&flight).unwrap();
    let truth = simulated.truth.cameras[0].focal_px;
    let camera = &mut simulated.observed.cameras[0];
    camera.focal_px = 1.02 * truth;
    camera.free = FreeParameters { focal: true, ..FreeParameters::default() };
    let mut values = [0.0; 8];
    values[0] = 1.001 * truth;
    let known = |sigma: f64| {
        let sigma = [Some(sigma * truth), None, None, None, None, None, None, None];
        let camera_priors = vec![CameraPrior { camera: 0, values, sigma }];
        let block = Block { camera_priors, ..simulated.observed.clone() };
        adjust_block(&block, &AdjustmentOptions { calibration_limit_px: 1000.0, ..squares() }).unwrap()
    };
    let (held, loose) = (known(1e-7), known(1e3));
    assert!((held.block.cameras[0].focal_px / values[0] - 1.0).abs() < 1e-6, "{}", held.block.cameras[0].focal_px);
    let [tight, wide] = [&held, &loose].map(|result| result.cameras[0].standard_errors[0].unwrap());
    assert!(tight < 1e-5 * truth && wide > 100.0 * tight, "{tight} {wide}");
    assert_eq!(held.degrees_of_freedom, loose.degrees_of_freedom);
    let free = adjust_block(&simulated.observed, &AdjustmentOptions { calibration_limit_px: 1000.0, ..squares() }).unwrap();
    assert_eq!(held.degrees_of_freedom, free.degrees_of_freedom + 1);
    assert!((free.block.cameras[0].focal_px - loose.block.cameras[0].focal_px).abs() < 0.1 * wide);
    let wrong = Block { camera_priors: vec![CameraPrior { camera: 9, values, sigma: [None; 8] }], ..simulated.observed.clone() };
    assert!(adjust_block(&wrong, &squares()).unwrap_err().to_string().contains("camera of a prior"));
}

#[test]
fn redundancies_sum_up_to_the_degrees_of_freedom() {
    let flight = BlockFlight { view: BlockView::TwoHeights, receiver_m: 0.05, control_points: 4, ..BlockPreset::Network.flight() };
    let mut simulated = simulate_network(&flight).unwrap();
    simulated.observed.cameras[0].free = FreeParameters { focal: true, principal_point: true, radial: 1, tangential: false };
    for datum in [Datum::Free, Datum::Gnss, Datum::Control, Datum::GnssAndControl] {
        let result = adjust_block(&simulated.observed, &AdjustmentOptions { datum, sigma0_px: Some(0.4), ..squares() }).unwrap();
        let rays: f64 = result.rays.iter().filter_map(|ray| ray.redundancy).flatten().sum();
        let gnss: f64 = result.images.iter().filter_map(|image| image.gnss?.redundancy).flatten().sum();
        let control: f64 = result.control.iter().filter_map(|c| (*c)?.redundancy).flatten().sum();
        let freedom = result.degrees_of_freedom as f64;
        assert!((rays + gnss + control - freedom).abs() < 1e-6 * freedom, "{datum:?}: {rays} + {gnss} + {control}, {freedom}");
        let tests: Vec<f64> = result.rays.iter().filter_map(|ray| ray.w).flatten().collect();
        assert!((0.95..1.05).contains(&mean_square(&tests)), "{datum:?}: {}", mean_square(&tests));
    }
}

#[test]
fn a_free_network_keeps_its_shape_whatever_the_start() {
    let flight = BlockPreset::Network.flight();
    let near = adjust_block(&from_truth(&flight).observed, &squares()).unwrap();
    let far = adjust_block(&simulate_network(&BlockFlight { approximate_m: 2.0, ..flight }).unwrap().observed, &squares()).unwrap();
    assert!((near.rmse_px - far.rmse_px).abs() < 1e-9);
    let largest = near.rays.iter().zip(&far.rays).flat_map(|(a, b)| [0, 1].map(|k| (a.residual_px[k] - b.residual_px[k]).abs()));
    assert!(largest.fold(0.0, f64::max) < 1e-4);
    // What is not seen from the datum: redundancies, and the ratio of distances.
    let redundancy = near.rays.iter().zip(&far.rays).map(|(a, b)| (a.redundancy.unwrap()[0] - b.redundancy.unwrap()[0]).abs());
    assert!(redundancy.fold(0.0, f64::max) < 1e-5);
    let distance = |result: &AdjustmentResult, a: usize, b: usize| {
        let (a, b) = (result.block.images[a].pose.position, result.block.images[b].pose.position);
        (0..3).map(|k| (a[k] - b[k]) * (a[k] - b[k])).sum::<f64>().sqrt()
    };
    let ratio = distance(&near, 0, 29) / distance(&near, 3, 17) * distance(&far, 3, 17) / distance(&far, 0, 29);
    assert!((ratio - 1.0).abs() < 1e-7, "{ratio}");
}

#[test]
fn a_free_network_stays_in_the_middle_of_its_start() {
    let simulated = simulate_network(&BlockPreset::Network.flight()).unwrap();
    let result = adjust_block(&simulated.observed, &squares()).unwrap();
    for k in 0..3 {
        let mean = |block: &Block| block.images.iter().map(|image| image.pose.position[k]).sum::<f64>() / 30.0;
        assert!((mean(&result.block) - mean(&simulated.observed)).abs() < 1e-9);
    }
}

#[test]
fn errors_of_a_block_held_by_gps_are_as_large_as_told() {
    let flight = BlockFlight { receiver_m: 0.05, ..BlockPreset::Network.flight() };
    let options = AdjustmentOptions { datum: Datum::Gnss, ..squares() };
    within("GNSS", mean_squares(&flight, &options, 60));
}

#[test]
fn errors_of_a_block_held_by_control_points_are_as_large_as_told() {
    let flight = BlockFlight { control_points: 6, approximate_m: 1.0, ..BlockPreset::Network.flight() };
    let options = AdjustmentOptions { datum: Datum::Control, ..squares() };
    within("control", mean_squares(&flight, &options, 200));
}

#[test]
fn gnss_with_a_gross_error_shows_it_in_its_test() {
    let mut simulated = simulate_network(&BlockFlight { receiver_m: 0.05, ..BlockPreset::Network.flight() }).unwrap();
    simulated.observed.images[11].gnss.as_mut().unwrap().position[2] += 0.6;
    let result = adjust_block(&simulated.observed, &AdjustmentOptions { datum: Datum::Gnss, ..squares() }).unwrap();
    let size = |image: usize| result.images[image].gnss.unwrap().w.unwrap().iter().fold(0.0_f64, |most, w| most.max(w.abs()));
    let worst = (0..result.images.len()).max_by(|a, b| size(*a).total_cmp(&size(*b))).unwrap();
    assert!(worst == 11 && size(11) > 3.29, "{worst}: {}", size(worst));
}

#[test]
fn a_surveyed_point_with_one_ray_still_counts() {
    let mut simulated = simulate_network(&BlockFlight { control_points: 6, ..BlockPreset::Network.flight() }).unwrap();
    let block = &mut simulated.observed;
    let point = block.control[5].point;
    let first = block.rays.iter().position(|ray| ray.point == point).unwrap();
    let kept = block.rays[first];
    block.rays.retain(|ray| ray.point != point);
    block.rays.push(kept);
    let result = adjust_block(block, &AdjustmentOptions { datum: Datum::Control, ..squares() }).unwrap();
    assert_eq!(result.rays.last().unwrap().verdict, ObservationVerdict::Accepted);
    assert!(result.control[5].is_some());
    assert!(result.rmse_by_rays[0].rays == 1 && result.rmse_by_rays[0].points == 1, "{:?}", result.rmse_by_rays[0]);
    let free = adjust_block(block, &squares()).unwrap();
    assert_eq!(free.rays.last().unwrap().verdict, ObservationVerdict::LostPoint);
    assert!(free.control.iter().all(Option::is_none));
}

#[test]
fn one_ray_in_five_may_be_wrong() {
    let flight = BlockFlight { gross_share: 0.2, points_per_image: 80.0, forward_overlap: 0.8, ..BlockPreset::Network.flight() };
    let simulated = simulate_network(&flight).unwrap();
    let result = adjust_block(&simulated.observed, &AdjustmentOptions::default()).unwrap();
    let sigma0 = result.sigma0_px.unwrap();
    let kept = result
        .rays
        .iter()
        .enumerate()
        .filter(|(k, ray)| ray.verdict == ObservationVerdict::Accepted && error_of(&simulated, *k) > 8.0)
        .count();
    println!("sigma0 {sigma0}, {kept} of {} large gross errors kept", simulated.gross.len());
    assert!((sigma0 / flight.noise_px - 1.0).abs() < 0.08, "{sigma0}");
    assert!((kept as f64) < 0.01 * simulated.gross.len() as f64);
}

#[test]
fn gross_errors_are_found_and_good_rays_kept() {
    let flight = BlockFlight { gross_share: 0.05, points_per_image: 80.0, ..BlockPreset::Network.flight() };
    let simulated = simulate_network(&flight).unwrap();
    let result = adjust_block(&simulated.observed, &AdjustmentOptions::default()).unwrap();
    let mut is_gross = vec![false; result.rays.len()];
    simulated.gross.iter().for_each(|ray| is_gross[*ray] = true);
    // What data snooping can see: errors that exceed what its residual shows beside noise.
    let (mut large, mut found, mut lost) = (0, 0, 0);
    for (index, (ray, gross)) in result.rays.iter().zip(&is_gross).enumerate() {
        let error = error_of(&simulated, index);
        if *gross && error > 5.0 {
            large += 1;
            found += usize::from(ray.verdict != ObservationVerdict::Accepted);
        }
        lost += usize::from(!gross && ray.verdict == ObservationVerdict::GrossError);
    }
    let good = is_gross.iter().filter(|gross| !**gross).count();
    println!("{found} of {large} gross errors found, {lost} of {good} good rays rejected, sigma0 {:?}", result.sigma0_px);
    assert!(large > 50 && found as f64 > 0.97 * large as f64);
    assert!((lost as f64) < 0.01 * good as f64);
    assert!((result.sigma0_px.unwrap() / flight.noise_px - 1.0).abs() < 0.05);
}

#[test]
fn rays_of_two_photos_are_kept() {
    // Along the base nothing can be told of a point's rays: residuals there are no measure of what is good.
    let flight = BlockFlight { strips: 1, exposures: 2, points_per_image: 300.0, ..BlockPreset::Network.flight() };
    let simulated = simulate_network(&flight).unwrap();
    let result = adjust_block(&simulated.observed, &AdjustmentOptions::default()).unwrap();
    let lost = result.rays.iter().filter(|ray| ray.verdict != ObservationVerdict::Accepted).count();
    println!("{lost} of {} rays rejected, sigma0 {:?}", result.rays.len(), result.sigma0_px);
    assert!(lost * 100 <= 2 * result.rays.len(), "{lost} of {}", result.rays.len());
    assert!((result.sigma0_px.unwrap() / flight.noise_px - 1.0).abs() < 0.1, "{:?}", result.sigma0_px);
}

#[test]
fn a_rejected_ray_is_told_the_test_it_had() {
    let flight = BlockFlight { receiver_m: 3.0, ..BlockPreset::Network.flight() };
    let mut simulated = simulate_network(&flight).unwrap();
    let rays_of = |point: usize| simulated.observed.rays.iter().filter(|ray| ray.point == point).count();
    let wrong = simulated.observed.rays.iter().position(|ray| rays_of(ray.point) >= 4).unwrap();
    simulated.observed.rays[wrong].y_px += 12.0 * flight.noise_px;
    let sigma0_px = Some(flight.noise_px);
    let mut tests = Vec::new();
    for datum in [Datum::Free, Datum::Gnss] {
        let options = AdjustmentOptions { datum, sigma0_px, loss: Loss::Squares, ..AdjustmentOptions::default() };
        let kept = adjust_block(&simulated.observed, &AdjustmentOptions { snooping: false, ..options.clone() }).unwrap();
        let snooped = adjust_block(&simulated.observed, &options).unwrap();
        assert_eq!(snooped.rays[wrong].verdict, ObservationVerdict::GrossError);
        // By how much a residual exceeds its standard error does not depend on whether it took part.
        tests.extend([&kept, &snooped].map(|result| result.rays[wrong].w.unwrap()[1]));
        assert!(snooped.rays[wrong].residual_px[1].abs() > kept.rays[wrong].residual_px[1].abs());
    }
    println!("{tests:?}");
    assert!(tests.iter().all(|w| (w / tests[0] - 1.0).abs() < 0.03), "{tests:?}");
}

/// How far a ray was observed from where the truth has it, in px.
fn error_of(simulated: &SimulatedNetwork, ray: usize) -> f64 {
    let ray = simulated.truth.rays[ray];
    let (image, point) = (&simulated.truth.images[ray.image], simulated.truth.points[ray.point]);
    let d = [0, 1, 2].map(|k| point[k] - image.pose.position[k]);
    let [u, v, w] = image.pose.rotation.map(|row| (0..3).map(|k| row[k] * d[k]).sum::<f64>());
    let at = simulated.truth.cameras[image.camera].project(-u / w, v / w);
    ((at[0] - ray.x_px) * (at[0] - ray.x_px) + (at[1] - ray.y_px) * (at[1] - ray.y_px)).sqrt()
}

#[test]
fn what_a_block_does_not_determine_is_fixed_and_named() {
    // Flat ground, one height, no control: focal length and flying height cannot be told apart.
    let flight = BlockFlight { relief_m: 0.0, ..BlockPreset::Network.flight() };
    let mut simulated = simulate_network(&flight).unwrap();
    simulated.observed.cameras[0].free = FreeParameters { focal: true, principal_point: false, radial: 1, tangential: false };
    let result = adjust_block(&simulated.observed, &squares()).unwrap();
    let fixed: Vec<_> = result.cameras[0].fixed.iter().map(|f| f.parameter).collect();
    println!("{:?}", result.cameras[0]);
    assert_eq!(fixed, [tiepoint::CameraParameter::Focal]);
    assert_eq!(result.block.cameras[0].focal_px, flight.focal_px());
    assert!(result.cameras[0].standard_errors[3].is_some());
}

#[test]
fn a_lens_that_bends_is_calibrated_by_a_free_network() {
    let flight = BlockFlight { view: BlockView::TwoHeights, radial: [-0.06, 0.03, -0.005], ..BlockPreset::Network.flight() };
    let mut simulated = simulate_network(&flight).unwrap();
    let camera = &mut simulated.observed.cameras[0];
    camera.radial = [0.0; 3];
    camera.free = FreeParameters { radial: 3, focal: true, ..FreeParameters::default() };
    let result = adjust_block(&simulated.observed, &AdjustmentOptions::default()).unwrap();
    assert!((result.sigma0_px.unwrap() / flight.noise_px - 1.0).abs() < 0.05, "{:?}", result.sigma0_px);
    let (own, told) = (&result.block.cameras[0], &result.cameras[0].standard_errors);
    println!("{own:?} {told:?}");
    assert!((own.radial[0] + 0.06).abs() < 4.0 * told[3].unwrap());
}

#[test]
fn gnss_in_a_single_strip_does_not_hold_a_block() {
    let mut simulated =
        simulate_network(&BlockFlight { strips: 1, exposures: 8, receiver_m: 0.02, ..BlockPreset::Network.flight() }).unwrap();
    for (k, image) in simulated.observed.images.iter_mut().enumerate() {
        image.gnss.as_mut().unwrap().position = [k as f64 * 20.0, 0.0, 100.0];
    }
    let error = adjust_block(&simulated.observed, &AdjustmentOptions { datum: Datum::Gnss, ..squares() }).unwrap_err();
    assert_eq!(error.code(), "degenerate");
}

#[test]
fn a_single_strip_is_a_free_network_too() {
    within("one strip", mean_squares(&BlockFlight { strips: 1, exposures: 8, ..BlockPreset::Network.flight() }, &squares(), 240));
}

#[test]
fn rays_without_errors_give_the_truth() {
    let simulated = simulate_network(&BlockFlight { noise_px: 0.0, ..BlockPreset::Network.flight() }).unwrap();
    for options in [squares(), AdjustmentOptions::default()] {
        let result = adjust_block(&simulated.observed, &options).unwrap();
        assert!(result.rmse_px < 1e-6, "{}", result.rmse_px);
        assert!(result.rays.iter().all(|ray| ray.verdict == ObservationVerdict::Accepted));
    }
}

#[test]
fn a_block_that_falls_apart_is_refused() {
    let mut simulated = simulate_network(&BlockPreset::Network.flight()).unwrap();
    let side: Vec<bool> = simulated.observed.points.iter().map(|p| p[1] < 0.0).collect();
    simulated.observed.rays.retain(|ray| (ray.image < 15) == side[ray.point]);
    let error = adjust_block(&simulated.observed, &squares()).unwrap_err();
    assert!(error.code() == "degenerate" && error.to_string().contains("parts"), "{error}");
}

#[test]
fn wrong_blocks_are_refused_by_what_is_wrong() {
    let block = simulate_network(&BlockPreset::Network.flight()).unwrap().observed;
    let refused = |change: &dyn Fn(&mut Block)| {
        let mut block = block.clone();
        change(&mut block);
        let error = adjust_block(&block, &squares()).unwrap_err();
        (error.code(), error.to_string())
    };
    let (code, text) = refused(&|b| b.rays[7].image = 99);
    assert!(code == "invalid-input" && text.contains("99") && text.contains("observation 7"), "{text}");
    let (code, text) = refused(&|b| b.rays[3].x_px = f64::NAN);
    assert!(code == "invalid-input" && text.contains("observation 3"), "{text}");
    let (code, text) = refused(&|b| b.images[2].pose.rotation[0] = [0.0; 3]);
    assert!(code == "invalid-input" && text.contains("image 2"), "{text}");
    let (code, text) = refused(&|b| b.rays.push(b.rays[0]));
    assert!(code == "invalid-input" && text.contains("got two of image"), "{text}");
    let (code, text) = refused(&|b| b.rays.retain(|ray| ray.image != 4));
    assert!(code == "degenerate" && text.contains("image 4"), "{text}");
    let (code, _) = refused(&|b| b.images.truncate(1));
    assert_eq!(code, "too-few");
    let error = adjust_block(&block, &AdjustmentOptions { alpha0: 0.0, ..squares() }).unwrap_err();
    assert_eq!(error.code(), "invalid-option");
    let error = adjust_block(&block, &AdjustmentOptions { datum: Datum::Gnss, ..squares() }).unwrap_err();
    assert_eq!(error.code(), "too-few");
}

#[test]
fn the_same_block_gives_the_same_bits_in_any_order_of_its_rays() {
    let simulated = simulate_network(&BlockPreset::Network.flight()).unwrap();
    let mut turned = simulated.observed.clone();
    turned.rays.reverse();
    let (a, b) = (adjust_block(&simulated.observed, &squares()).unwrap(), adjust_block(&turned, &squares()).unwrap());
    assert_eq!(a.block.images, b.block.images);
    assert_eq!(a.block.points, b.block.points);
}

#[test]
fn no_significance_of_data_snooping_lets_sigma0_collapse() {
    let block = simulate_network(&BlockPreset::Network.flight()).unwrap().observed;
    let sigma0 =
        |alpha0: f64| adjust_block(&block, &AdjustmentOptions { alpha0, ..AdjustmentOptions::default() }).unwrap().sigma0_px.unwrap();
    let usual = sigma0(0.001);
    for alpha0 in [1e-6, 0.01, 0.05] {
        // Where it rejects many good ones, the correction is a coarse one.
        let most = if alpha0 > 0.02 { 0.5 } else { 0.1 };
        assert!((sigma0(alpha0) / usual - 1.0).abs() < most, "{alpha0}: {} for {usual}", sigma0(alpha0));
    }
}

#[test]
fn a_control_point_left_out_is_where_an_adjustment_without_it_has_it() {
    let flight = BlockFlight { control_points: 8, seed: 5, ..BlockPreset::Network.flight() };
    let simulated = simulate_network(&flight).unwrap();
    let alone = AdjustmentOptions { datum: Datum::Control, sigma0_px: Some(flight.noise_px), ..squares() };
    let whole = adjust_block(&simulated.observed, &alone).unwrap();
    // Errors that the rays of an image share are those of its place without it, too.
    let options = AdjustmentOptions { shared_errors: 1.0, ..alone };
    let sharing = adjust_block(&simulated.observed, &options).unwrap();
    let mut compared = 0;
    for (index, control) in simulated.observed.control.iter().enumerate() {
        let Some(told) = sharing.control[index].unwrap().left_out else { continue };
        let independent = whole.control[index].unwrap().left_out.unwrap();
        assert!((0..3).all(|k| told.standard_errors[k] > 1.05 * independent.standard_errors[k]), "{index}: {told:?} {independent:?}");
        assert_eq!(told.difference, independent.difference);
        let mut without = simulated.observed.clone();
        without.control.remove(index);
        let without = adjust_block(&without, &options).unwrap();
        let errors = without.points[control.point].unwrap().errors.unwrap();
        for k in 0..3 {
            let difference = without.block.points[control.point][k] - control.position[k];
            let error = (errors[k] * errors[k] + control.sigma[k] * control.sigma[k]).sqrt();
            assert!((told.difference[k] - difference).abs() < 0.02 * error, "{index}: {} {difference} ± {error}", told.difference[k]);
            assert!((told.standard_errors[k] / error - 1.0).abs() < 0.02, "{index}: {} {error}", told.standard_errors[k]);
        }
        compared += 1;
    }
    assert!(compared >= 5, "{compared}");
}
