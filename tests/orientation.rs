//! Relative orientation against generated truth.

#[path = "orientation/calibration.rs"]
mod calibration;
#[path = "orientation/coverage.rs"]
mod coverage;
#[path = "orientation/few.rs"]
mod few;
#[path = "orientation/fiducials.rs"]
mod fiducials;
#[path = "orientation/model_points.rs"]
mod points;
#[path = "orientation/refusals.rs"]
mod refusals;
#[path = "orientation/scene.rs"]
mod scene;
#[path = "orientation/simulated_pair.rs"]
mod simulated_pair;
#[path = "orientation/snooping.rs"]
mod snooping;
#[path = "orientation/uncalibrated.rs"]
mod uncalibrated;
#[path = "orientation/warnings.rs"]
mod warnings;

use scene::{ALONG_Y, FOCAL_MM, NADIR, OBLIQUE, PLANE, TO_THE_LEFT, UPSIDE_DOWN, spoil, standard_errors};
use tiepoint::{Error, Observation, OrientationMethod, OrientationOptions, orient_relative, rotation_from_angles};

#[test]
fn errorless_observations_give_the_truth() {
    for (name, pair) in
        [("nadir", NADIR), ("oblique", OBLIQUE), ("κ 180°", UPSIDE_DOWN), ("base along y", ALONG_Y), ("leftwards", TO_THE_LEFT)]
    {
        for (method, tolerance) in [(OrientationMethod::Rigorous, 1e-7), (OrientationMethod::Determinant, 1e-6)] {
            let options = OrientationOptions { method, ..pair.options() };
            let found = orient_relative(&pair.observe(60, 0.0, 5), FOCAL_MM, &options).unwrap_or_else(|e| panic!("{name}: {e}"));
            assert!(pair.errors(&found).iter().all(|e| e.abs() < tolerance), "{name}: {:?}", pair.errors(&found));
            assert_eq!((found.degrees_of_freedom, found.base_mm), (55, pair.base[0]), "{name}");
            assert!(found.rejected.is_empty() && found.last_step < 1.0 && found.sigma0_mm.unwrap() < 1e-10, "{name}");
        }
    }
}

#[test]
fn noise_of_a_known_size_is_found_and_errors_stay_within_their_standard_errors() {
    for (name, pair) in [("nadir", NADIR), ("oblique", OBLIQUE), ("κ 180°", UPSIDE_DOWN), ("base along y", ALONG_Y), ("plane", PLANE)] {
        for method in [OrientationMethod::Rigorous, OrientationMethod::Determinant] {
            let options = OrientationOptions { method, ..pair.options() };
            let found = orient_relative(&pair.observe(800, 0.02, 6), FOCAL_MM, &options).unwrap_or_else(|e| panic!("{name}: {e}"));
            let sigma0 = found.sigma0_mm.unwrap();
            assert!((0.018..0.022).contains(&sigma0), "{name} {method:?}: σ0 {sigma0}");
            let (errors, standard) = (pair.errors(&found), standard_errors(&found));
            assert!(errors.iter().zip(standard).all(|(e, s)| e.abs() < 4.0 * s), "{name} {method:?}: {errors:?} of {standard:?}");
        }
    }
}

#[test]
fn gross_errors_are_rejected_and_do_not_move_the_result() {
    for (name, pair) in [("nadir", NADIR), ("oblique", OBLIQUE), ("κ 180°", UPSIDE_DOWN), ("base along y", ALONG_Y), ("plane", PLANE)] {
        for share in [0.15, 0.3, 0.6] {
            let mut observations = pair.observe(500, 0.02, 8);
            let spoiled = spoil(&mut observations, share, 9);
            let found = orient_relative(&observations, FOCAL_MM, &pair.options()).unwrap_or_else(|e| panic!("{name} {share}: {e}"));
            let (errors, standard) = (pair.errors(&found), standard_errors(&found));
            assert!(errors.iter().zip(standard).all(|(e, s)| e.abs() < 5.0 * s), "{name} {share}: {errors:?} of {standard:?}");
            let sigma0 = found.sigma0_mm.unwrap();
            assert!((0.017..0.026).contains(&sigma0), "{name} {share}: σ0 {sigma0}");
            let good_lost = found.rejected.iter().filter(|index| !spoiled.contains(index)).count();
            assert!(good_lost <= (500 - spoiled.len()) / 50, "{name} {share}: {good_lost} good ones rejected");
            // ±12 px hide within 3 σ0 of the line by chance: 0.12 mm·√2 of 3 mm to either side, and some of the smaller shifts.
            let missed = spoiled.iter().filter(|index| !found.rejected.contains(index)).count();
            assert!(missed <= spoiled.len() / 10, "{name} {share}: {missed} of {} kept", spoiled.len());
        }
    }
}

#[test]
fn two_gross_errors_among_twelve_observations() {
    let mut exactly_these = 0;
    for seed in 0..100 {
        let mut observations = NADIR.observe(12, 0.005, 40 + seed);
        observations[3].right[1] += 2.0;
        observations[8].right[1] -= 3.0;
        let found = orient_relative(&observations, FOCAL_MM, &NADIR.options()).unwrap();
        assert!(found.rejected.contains(&3) && found.rejected.contains(&8), "seed {seed}: {:?}", found.rejected);
        exactly_these += usize::from(found.rejected == [3, 8]);
    }
    // Seven of ten good observations agree by chance far better than their σ in a few sets: then the others look wrong.
    assert!(exactly_these >= 95, "{exactly_these} of 100");
}

#[test]
fn the_same_seed_gives_the_same_bits_and_another_seed_the_same_result() {
    let mut observations = OBLIQUE.observe(400, 0.02, 3);
    spoil(&mut observations, 0.3, 4);
    let run = |seed| orient_relative(&observations, FOCAL_MM, &OrientationOptions { seed, ..OBLIQUE.options() }).unwrap();
    assert_eq!(run(1), run(1));
    let (first, second) = (run(1), run(2));
    assert_eq!(first.rejected, second.rejected);
    let standard = standard_errors(&first);
    for ((a, b), s) in OBLIQUE.errors(&first).iter().zip(OBLIQUE.errors(&second)).zip(standard) {
        assert!((a - b).abs() < 1e-4 * s);
    }
}

#[test]
fn order_and_unit_of_the_observations_do_not_matter() {
    let observations = NADIR.observe(100, 0.02, 12);
    let found = orient_relative(&observations, FOCAL_MM, &NADIR.options()).unwrap();
    let mut reversed = observations.clone();
    reversed.reverse();
    let again = orient_relative(&reversed, FOCAL_MM, &NADIR.options()).unwrap();
    let scaled: Vec<_> = observations.iter().map(|o| Observation::new(o.left.map(|v| v / 10.0), o.right.map(|v| v / 10.0))).collect();
    let options = OrientationOptions { base_mm: Some(9.2), ..NADIR.options() };
    let in_cm = orient_relative(&scaled, FOCAL_MM / 10.0, &options).unwrap();
    for (a, b) in NADIR.errors(&found).iter().zip(NADIR.errors(&again)) {
        assert!((a - b).abs() < 1e-7);
    }
    assert!((in_cm.parameters.omega_deg - found.parameters.omega_deg).abs() < 1e-7);
    assert!((in_cm.parameters.by_mm * 10.0 - found.parameters.by_mm).abs() < 1e-6);
    assert!((in_cm.sigma0_mm.unwrap() * 10.0 - found.sigma0_mm.unwrap()).abs() < 1e-8);
}

#[test]
fn the_base_scales_by_and_bz_alone() {
    let observations = NADIR.observe(100, 0.02, 12);
    let with = |base_mm| orient_relative(&observations, FOCAL_MM, &OrientationOptions { base_mm, ..NADIR.options() }).unwrap();
    let (single, double) = (with(Some(92.0)), with(Some(184.0)));
    assert_eq!(single.parameters.omega_deg, double.parameters.omega_deg);
    assert!((2.0 * single.parameters.by_mm - double.parameters.by_mm).abs() < 1e-12);
    let free = with(None);
    let accepted = observations.iter().enumerate().filter(|(index, _)| !free.rejected.contains(index));
    let mut parallaxes: Vec<f64> = accepted.map(|(_, o)| o.left[0] - o.right[0]).collect();
    parallaxes.sort_by(f64::total_cmp);
    let middle = [(parallaxes.len() - 1) / 2, parallaxes.len() / 2];
    assert!((free.base_mm - 0.5 * (parallaxes[middle[0]] + parallaxes[middle[1]])).abs() < 1e-9);
}

#[test]
fn corrected_coordinates_are_coplanar_and_sigma_is_their_size() {
    let mut observations = OBLIQUE.observe(80, 0.03, 15);
    observations[7].right[1] += 5.0;
    let found = orient_relative(&observations, FOCAL_MM, &OBLIQUE.options()).unwrap();
    assert_eq!(found.rejected, [7]);
    let p = &found.parameters;
    let m = rotation_from_angles(p.omega_deg.to_radians(), p.phi_deg.to_radians(), p.kappa_deg.to_radians());
    let base = nalgebra::Vector3::new(found.base_mm, p.by_mm, p.bz_mm);
    let mut square_sum = 0.0;
    for (index, (o, v)) in observations.iter().zip(&found.residuals_mm).enumerate() {
        let left = nalgebra::Vector3::new(o.left[0] + v[0], o.left[1] + v[1], -FOCAL_MM);
        let right = m.transpose() * nalgebra::Vector3::new(o.right[0] + v[2], o.right[1] + v[3], -FOCAL_MM);
        let sine = base.dot(&left.cross(&right)) / (base.norm() * left.norm() * right.norm());
        assert!(sine.abs() < 1e-12, "{index}: {sine}");
        if index != 7 {
            square_sum += v.iter().map(|v| v * v).sum::<f64>();
        }
    }
    let sigma0 = (square_sum / found.degrees_of_freedom as f64).sqrt();
    // A normal distribution that is cut at 3.29 has 0.99413 of its standard deviation left, and τ of 74 degrees of freedom about as much;
    // σ₀ is that before the cut.
    assert!((sigma0 / found.sigma0_mm.unwrap() - 0.99417).abs() < 5e-5, "{}", sigma0 / found.sigma0_mm.unwrap());
    let length = found.residuals_mm[7].iter().map(|v| v * v).sum::<f64>().sqrt();
    assert!((3.0..4.0).contains(&length), "a y-parallax of 5 mm is a correction of 5/√2 mm: {length}");
}

#[test]
fn correlations_are_those_of_the_unknowns() {
    let found = orient_relative(&NADIR.observe(200, 0.02, 16), FOCAL_MM, &NADIR.options()).unwrap();
    for (i, row) in found.correlations.iter().enumerate() {
        assert_eq!(row[i], 1.0);
        for (j, value) in row.iter().enumerate() {
            assert!(value.abs() <= 1.0 && *value == found.correlations[j][i]);
        }
    }
    // In a vertical pair ω goes with by and φ with bz; κ goes with neither.
    assert!(found.correlations[0][3].abs() > 0.9 && found.correlations[1][4].abs() < 0.9, "{:?}", found.correlations);
}

#[test]
fn without_robustness_clean_observations_give_the_same_result() {
    let observations = NADIR.observe(100, 0.005, 18);
    let robust = orient_relative(&observations, FOCAL_MM, &OrientationOptions { alpha0: 1e-6, ..NADIR.options() }).unwrap();
    let plain = orient_relative(&observations, FOCAL_MM, &OrientationOptions { robust: false, ..NADIR.options() }).unwrap();
    for (a, b) in NADIR.errors(&robust).iter().zip(NADIR.errors(&plain)) {
        assert!((a - b).abs() < 1e-7);
    }
}

#[test]
fn without_robustness_gross_errors_give_the_least_squares_minimum_or_no_convergence() {
    let mut outcomes = [0; 2];
    for seed in 0..30 {
        let mut observations = NADIR.observe(100, 0.02, 200 + seed);
        spoil(&mut observations, 0.3, seed);
        let plain = |method| orient_relative(&observations, FOCAL_MM, &OrientationOptions { robust: false, method, ..NADIR.options() });
        for method in [OrientationMethod::Rigorous, OrientationMethod::Determinant] {
            match plain(method) {
                Ok(found) => {
                    outcomes[0] += 1;
                    assert!(found.last_step < 1.0 && found.sigma0_mm.unwrap() > 0.1 && found.rejected.is_empty());
                    assert!(found.parameters.phi_deg.abs() < 30.0 && found.parameters.bz_mm.abs() < 100.0);
                }
                Err(Error::NotConverged { .. } | Error::Degenerate { .. }) => outcomes[1] += 1,
                Err(other) => panic!("{other}"),
            }
        }
    }
    assert!(outcomes[0] > 0);
}

#[test]
fn five_observations_have_no_redundancy() {
    let found = orient_relative(&NADIR.observe(5, 0.0, 21), FOCAL_MM, &NADIR.options()).unwrap();
    assert_eq!((found.degrees_of_freedom, found.sigma0_mm, found.standard_errors), (0, None, None));
    assert!(found.residuals_mm.iter().flatten().all(|v| v.abs() < 1e-9));
    assert!(NADIR.errors(&found).iter().all(|e| e.abs() < 1e-5), "{:?}", NADIR.errors(&found));
}
