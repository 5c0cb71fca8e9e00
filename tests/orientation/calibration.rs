//! Whether the statistics can be believed: standard errors, tests and reliability against many simulated sets of observations.
//!
//! `cargo test --lib integration::orientation::calibration -- --nocapture` prints the figures.

use super::super::sampling::{about_one, runs};
use super::scene::{ALONG_Y, Dice, FOCAL_MM, NADIR, OBLIQUE, Pair, UPSIDE_DOWN, spoil, standard_errors};
use tiepoint::{Observation, OrientationOptions, RelativeOrientation, Weighting, orient_relative, rotation_from_angles};

/// Sets of the main way; a variance of 1 then scatters by 0.03. The others have fewer, and wider bounds.
const SETS: u64 = 2000;
const FEWER_SETS: u64 = 500;
const SIGMA_MM: f64 = 0.005;
const NAMES: [&str; 5] = ["ω", "φ", "κ", "by", "bz"];

/// Errors divided by their standard errors.
fn ratios(pair: &Pair, found: &RelativeOrientation) -> [f64; 5] {
    let (errors, standard) = (pair.errors(found), standard_errors(found));
    std::array::from_fn(|k| errors[k] / standard[k])
}

/// Variances of errors / standard errors over many sets.
fn variances(all_sets: u64, pair: &Pair, options: &OrientationOptions, make: impl Fn(u64) -> Vec<Observation>) -> [f64; 5] {
    let (mut sums, sets) = ([0.0; 5], runs(all_sets));
    for seed in 0..sets {
        let found = orient_relative(&make(seed), FOCAL_MM, options).unwrap();
        sums.iter_mut().zip(ratios(pair, &found)).for_each(|(sum, ratio)| *sum += ratio * ratio / sets as f64);
    }
    sums
}

fn print(what: &str, all_sets: u64, variances: [f64; 5]) {
    let sets = runs(all_sets);
    let figures: Vec<String> = NAMES.iter().zip(variances).map(|(name, v)| format!("{name} {v:.3}")).collect();
    println!("variance of error / standard error, {what}, {sets} sets: {}", figures.join(", "));
}

#[test]
fn errors_have_the_size_of_their_standard_errors() {
    for (name, pair) in [("nadir", NADIR), ("oblique", OBLIQUE), ("base along y", ALONG_Y), ("κ 180°", UPSIDE_DOWN)] {
        let ways = [
            ("robust", OrientationOptions::default()),
            ("least squares", OrientationOptions { robust: false, ..OrientationOptions::default() }),
            ("Huber", OrientationOptions { weighting: Weighting::Huber, ..OrientationOptions::default() }),
            ("Danish", OrientationOptions { weighting: Weighting::Danish, ..OrientationOptions::default() }),
            ("σ₀ a priori", OrientationOptions { sigma0_mm: Some(SIGMA_MM), ..OrientationOptions::default() }),
        ];
        for (way, options) in ways {
            if !options.robust && (name == "κ 180°" || name == "oblique") {
                // Without the consensus only near-vertical pairs converge.
                continue;
            }
            let options = OrientationOptions { base_mm: Some(pair.base[0]), ..options };
            let (sets, bounds) = if (name, way) == ("nadir", "robust") { (SETS, about_one(0.1)) } else { (FEWER_SETS, about_one(0.25)) };
            let found = variances(sets, &pair, &options, |seed| pair.observe(150, SIGMA_MM, 1000 + seed));
            print(&format!("{name}, {way}"), sets, found);
            assert!(found.iter().all(|v| bounds.contains(v)), "{name}, {way}: {found:?}");
        }
    }
}

/// Observations of unequal precision, each of the weight that tells it.
fn unequal(pair: &Pair, count: usize, seed: u64) -> Vec<Observation> {
    let mut dice = Dice::new(seed);
    let mut observations = pair.observe(count, 0.0, seed);
    for (k, o) in observations.iter_mut().enumerate() {
        o.weight = [4.0, 1.0, 0.25][k % 3];
        let sigma = SIGMA_MM / o.weight.sqrt();
        o.left.iter_mut().chain(&mut o.right).for_each(|v| *v += sigma * dice.normal());
    }
    observations
}

#[test]
fn weights_tell_the_precision_of_observations() {
    let found = variances(FEWER_SETS, &NADIR, &NADIR.options(), |seed| unequal(&NADIR, 150, 3000 + seed));
    print("nadir, unequal weights", FEWER_SETS, found);
    assert!(found.iter().all(|v| about_one(0.25).contains(v)), "{found:?}");
    let observations = unequal(&NADIR, 600, 5);
    let weighted = orient_relative(&observations, FOCAL_MM, &NADIR.options()).unwrap();
    let sigma0 = weighted.sigma0_mm.unwrap();
    assert!((sigma0 / SIGMA_MM - 1.0).abs() < 0.08, "σ₀ {sigma0}");
    let equal: Vec<_> = observations.iter().map(|o| Observation { weight: 1.0, ..*o }).collect();
    let unweighted = orient_relative(&equal, FOCAL_MM, &NADIR.options()).unwrap();
    assert!((0..5).all(|k| standard_errors(&weighted)[k] < standard_errors(&unweighted)[k]));
    // A weight counts as that many observations.
    let doubled: Vec<_> = observations.iter().flat_map(|o| [Observation { weight: 0.5 * o.weight, ..*o }; 2]).collect();
    let plain = OrientationOptions { robust: false, ..NADIR.options() };
    let [once, twice] = [&observations, &doubled].map(|o| orient_relative(o, FOCAL_MM, &plain).unwrap());
    assert!(NADIR.errors(&once).iter().zip(NADIR.errors(&twice)).all(|(a, b)| (a - b).abs() < 1e-9));
}

/// Standard deviations of a count of `number` trials of this probability, from its expectation.
fn deviation(count: usize, number: usize, probability: f64) -> f64 {
    (count as f64 - probability * number as f64) / (number as f64 * probability * (1.0 - probability)).sqrt()
}

#[test]
fn good_observations_are_suspected_as_often_as_the_significance_says() {
    for (alpha0, limit) in [(0.05, 1.959_964), (0.01, 2.575_829), (0.001, 3.290_527)] {
        let options = OrientationOptions { alpha0, sigma0_mm: Some(SIGMA_MM), robust: false, ..NADIR.options() };
        let (mut suspected, mut number) = (0, 0);
        for seed in 0..runs(FEWER_SETS) {
            let found = orient_relative(&NADIR.observe(60, SIGMA_MM, 7000 + seed), FOCAL_MM, &options).unwrap();
            suspected += found.points.iter().flatten().filter(|p| p.w.abs() > limit).count();
            number += found.points.len();
        }
        println!(
            "w-tests of good observations at α₀ {alpha0}: {suspected} of {number} rejected, share {:.5}",
            suspected as f64 / number as f64
        );
        assert!(deviation(suspected, number, alpha0).abs() < 4.0, "{alpha0}: {suspected} of {number}");
    }
}

/// Moves the right point across its epipolar line.
pub fn displace(pair: &Pair, observation: &mut Observation, by_mm: f64) {
    let m = rotation_from_angles(pair.angles_deg[0].to_radians(), pair.angles_deg[1].to_radians(), pair.angles_deg[2].to_radians());
    let left = nalgebra::Vector3::new(observation.left[0], observation.left[1], -FOCAL_MM);
    let line = m * nalgebra::Vector3::from(pair.base).cross(&left);
    let length = (line.x * line.x + line.y * line.y).sqrt();
    observation.right[0] += by_mm * line.x / length;
    observation.right[1] += by_mm * line.y / length;
}

#[test]
fn a_blunder_of_the_detectable_size_is_found_with_its_power_and_moves_the_result_as_told() {
    for (pair, beta0) in [(NADIR, 0.8), (NADIR, 0.95), (OBLIQUE, 0.8)] {
        let options = OrientationOptions { beta0, sigma0_mm: Some(SIGMA_MM), ..pair.options() };
        let plain = OrientationOptions { alpha0: 1e-6, ..options.clone() };
        let (mut found, mut trials) = (0, 0);
        for seed in 0..1000 {
            let mut observations = pair.observe(20, SIGMA_MM, 9000 + seed);
            let clean = orient_relative(&observations, FOCAL_MM, &plain).unwrap();
            let suspect = seed as usize % 20;
            let before = orient_relative(&observations, FOCAL_MM, &options).unwrap();
            if !before.rejected.is_empty() {
                continue;
            }
            trials += 1;
            let before = before.points[suspect].unwrap();
            let sign = if seed % 2 == 0 { 1.0 } else { -1.0 };
            displace(&pair, &mut observations[suspect], sign * before.detectable_mm);
            found += usize::from(orient_relative(&observations, FOCAL_MM, &options).unwrap().rejected.contains(&suspect));
            let spoiled = orient_relative(&observations, FOCAL_MM, &plain).unwrap();
            if !spoiled.rejected.is_empty() || !clean.rejected.is_empty() {
                continue;
            }
            let standard = standard_errors(&clean);
            let moved = (0..5).map(|k| (pair.errors(&spoiled)[k] - pair.errors(&clean)[k]).abs() / standard[k]).fold(0.0, f64::max);
            assert!((moved / before.influence - 1.0).abs() < 0.05, "moved by {moved}, told {}", before.influence);
        }
        println!("blunders of the minimal detectable size at β₀ {beta0}: {found} of {trials} found");
        assert!(deviation(found, trials, beta0).abs() < 4.0, "{found} of {trials} at {beta0}");
    }
}

#[test]
fn redundancies_add_up_to_the_degrees_of_freedom() {
    let observations = unequal(&OBLIQUE, 60, 11);
    let found = orient_relative(&observations, FOCAL_MM, &OBLIQUE.options()).unwrap();
    let accepted = (0..60).filter(|k| !found.rejected.contains(k));
    let sum: f64 = accepted.map(|k| found.points[k].unwrap().redundancy).sum();
    assert!((sum - found.degrees_of_freedom as f64).abs() < 1e-6, "{sum}");
}

#[test]
fn model_points_are_projected_to_the_corrected_coordinates() {
    let observations = OBLIQUE.observe(60, 0.01, 21);
    let found = orient_relative(&observations, FOCAL_MM, &OBLIQUE.options()).unwrap();
    let p = &found.parameters;
    let m = rotation_from_angles(p.omega_deg.to_radians(), p.phi_deg.to_radians(), p.kappa_deg.to_radians());
    for (k, point) in found.points.iter().enumerate() {
        let [x, y, z] = point.unwrap().model_mm.unwrap();
        let seen = m * nalgebra::Vector3::new(x - found.base_mm, y - p.by_mm, z - p.bz_mm);
        let projected = [-FOCAL_MM * x / z, -FOCAL_MM * y / z, -FOCAL_MM * seen.x / seen.z, -FOCAL_MM * seen.y / seen.z];
        let observed = [observations[k].left, observations[k].right].concat();
        for (axis, value) in projected.iter().enumerate() {
            assert!((value - observed[axis] - found.residuals_mm[k][axis]).abs() < 1e-8, "point {k}, coordinate {axis}");
        }
    }
}

#[test]
fn the_global_test_tells_a_wrong_assumption() {
    let passed = |sigma0_mm: f64, seed: u64| {
        let options = OrientationOptions { sigma0_mm: Some(sigma0_mm), robust: false, ..NADIR.options() };
        orient_relative(&NADIR.observe(200, SIGMA_MM, 31 + seed), FOCAL_MM, &options).unwrap().global_test.unwrap().passed
    };
    let share = |sigma0_mm| (0..400).filter(|seed| passed(sigma0_mm, *seed)).count();
    let (right, low, high) = (share(SIGMA_MM), share(0.8 * SIGMA_MM), share(1.25 * SIGMA_MM));
    println!("global tests passed at 95 %: {right} of 400 with the right σ₀, {low} with 0.8 of it, {high} with 1.25");
    assert!(deviation(400 - right, 400, 0.05).abs() < 4.0 && low < 20 && high < 20);
    let untested = orient_relative(&NADIR.observe(200, SIGMA_MM, 31), FOCAL_MM, &NADIR.options()).unwrap();
    assert_eq!(untested.global_test, None);
}

#[test]
fn blunders_do_not_carry_the_result_away() {
    const SEEDS: u64 = 200;
    for share in [0.0, 0.3, 0.6] {
        let (mut all, mut each) = (0, [0; 5]);
        for seed in 0..SEEDS {
            let mut observations = NADIR.observe(300, SIGMA_MM, 20_000 + seed);
            spoil(&mut observations, share, 30_000 + seed);
            let found = orient_relative(&observations, FOCAL_MM, &NADIR.options()).unwrap();
            let ratios = ratios(&NADIR, &found);
            each.iter_mut().zip(ratios).for_each(|(count, ratio)| *count += usize::from(ratio.abs() <= 3.0));
            all += usize::from(ratios.iter().all(|ratio| ratio.abs() <= 3.0));
        }
        println!("{:.0} % blunders: within 3 standard errors each of five {each:?}, all at once {all}, of {SEEDS} seeds", 100.0 * share);
        // Of five correlated normal errors one exceeds 3 standard errors in 1.3 % of cases without any blunder.
        assert!(each.iter().sum::<usize>() >= 990, "{share}: {each:?}");
        assert!(all >= 192, "{share}: {all}");
    }
}
