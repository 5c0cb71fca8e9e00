//! Few observations, as textbooks have them, and what is said of a result that its observations contradict.

use super::scene::{FOCAL_MM, NADIR, OBLIQUE, standard_errors};
use tiepoint::{Observation, OrientationMethod, OrientationOptions, PairVerdict, RelativeOrientation, Warning, orient_relative};

const SIGMA_MM: f64 = 0.005;

fn oriented(observations: &[Observation], options: &OrientationOptions) -> RelativeOrientation {
    orient_relative(observations, FOCAL_MM, options).unwrap()
}

#[test]
fn clean_observations_give_plain_least_squares_digit_for_digit() {
    let plain = OrientationOptions { robust: false, ..NADIR.options() };
    let mut same = 0;
    // Six points have one degree of freedom, as the examples of textbooks.
    for (points, seeds) in [(6, 300), (7, 300), (10, 300), (15, 300)] {
        for seed in 0..seeds {
            let observations = NADIR.observe(points, SIGMA_MM, seed);
            let (default, plain) = (oriented(&observations, &NADIR.options()), oriented(&observations, &plain));
            if !default.rejected.is_empty() {
                continue;
            }
            same += 1;
            let (standard, expected) = (standard_errors(&default), standard_errors(&plain));
            assert!((default.sigma0_mm.unwrap() / plain.sigma0_mm.unwrap() - 1.0).abs() < 1e-6, "{points}, {seed}");
            assert!((0..5).all(|k| (standard[k] / expected[k] - 1.0).abs() < 1e-6), "{points}, {seed}");
            let apart = NADIR.errors(&default).into_iter().zip(NADIR.errors(&plain)).zip(expected).map(|((a, b), s)| (a - b).abs() / s);
            assert!(apart.fold(0.0, f64::max) < 1e-5, "{points}, {seed}");
        }
    }
    assert!(same > 1180, "{same}");
}

#[test]
fn six_points_are_never_rejected_and_nothing_is_detectable() {
    let found = oriented(&NADIR.observe(6, SIGMA_MM, 3), &NADIR.options());
    assert_eq!((found.rejected.len(), found.degrees_of_freedom, found.noncentrality), (0, 1, None));
    assert_eq!(found.warnings, [Warning::Unchecked { observations: 6 }]);
    let warnings = |points: usize| oriented(&NADIR.observe(points, SIGMA_MM, 3), &NADIR.options()).warnings;
    assert_eq!((warnings(7), warnings(8)), (vec![Warning::Unchecked { observations: 7 }], vec![]));
    // A σ₀ that is known tells a gross error from noise.
    let known = OrientationOptions { sigma0_mm: Some(SIGMA_MM), ..NADIR.options() };
    assert_eq!(oriented(&NADIR.observe(6, SIGMA_MM, 3), &known).warnings, []);
    assert!(found.points.iter().flatten().all(|p| p.detectable_mm.is_infinite() && p.influence.is_infinite()));
    // 12.706: Student's limit of one degree of freedom.
    assert!((found.half_widths_95.unwrap().kappa_deg / found.standard_errors.unwrap().kappa_deg - 12.7062).abs() < 1e-4);
}

#[test]
fn an_example_of_six_points_comes_out_as_another_adjustment_has_it() {
    // Wolf and Dewitt's photographs of f 152.113 mm. The values are those of a bundle adjustment of its 24 coordinates in another language.
    let measured = [
        [[-4.878, 1.968], [-97.92, -2.91]],
        [[89.296, 2.689], [-1.485, -1.836]],
        [[-0.256, 84.138], [-90.906, 78.98]],
        [[90.328, 83.854], [-1.568, 79.482]],
        [[-4.673, -86.815], [-100.06, -95.733]],
        [[88.591, -85.269], [-0.973, -94.312]],
    ];
    let observations = measured.map(|[left, right]| Observation::new(left, right));
    let found =
        orient_relative(&observations, 152.113, &OrientationOptions { base_mm: Some(92.0), ..OrientationOptions::default() }).unwrap();
    let p = &found.parameters;
    let got = [p.omega_deg, p.phi_deg, p.kappa_deg, p.by_mm, p.bz_mm, found.sigma0_mm.unwrap()];
    let parameters = [2.4275008, 0.5396185, -0.2003540, -1.7964831, -3.8127174, 0.0136654];
    let errors = [0.01969060, 0.02097344, 0.00972608, 0.06296892, 0.02279830];
    assert!(got.iter().zip(parameters).all(|(got, expected)| (got - expected).abs() < 1e-6), "{got:?}");
    assert!(standard_errors(&found).iter().zip(errors).all(|(got, expected)| (got / expected - 1.0).abs() < 1e-3), "{found:?}");
    assert_eq!((found.rejected.len(), found.degrees_of_freedom), (0, 1));
}

#[test]
fn identical_observations_count_once() {
    let once = NADIR.observe(20, SIGMA_MM, 5);
    let often: Vec<Observation> = (0..100).map(|k| once[k * 7 % 20]).collect();
    let (one, five) = (oriented(&once, &NADIR.options()), oriented(&often, &NADIR.options()));
    assert!((one.sigma0_mm.unwrap() / five.sigma0_mm.unwrap() - 1.0).abs() < 1e-6);
    assert_eq!((five.degrees_of_freedom, five.rejected.len(), five.points.len(), five.residuals_mm.len()), (15, 0, 100, 100));
    assert_eq!(five.points[3], five.points[23]);
    assert_eq!(five.warnings, [Warning::Identical { copies: 80, rejected: 0 }]);
    let PairVerdict::Oriented { points, .. } = PairVerdict::of_observations(&five) else { panic!("{five:?}") };
    assert_eq!(points, 20);
}

#[test]
fn points_behind_a_camera_are_left_out_and_said() {
    // A third of the points has its x axis mirrored: their rays meet on the other side.
    let mut observations = NADIR.observe(100, SIGMA_MM, 3);
    for observation in observations.iter_mut().step_by(3) {
        observation.right[0] += 2.0 * (observation.left[0] - observation.right[0]);
    }
    let found = oriented(&observations, &NADIR.options());
    let expected: Vec<usize> = (0..100).step_by(3).collect();
    assert!(expected.iter().all(|k| found.rejected.contains(k)), "{:?}", found.rejected);
    assert!(found.warnings.iter().any(|w| matches!(w, Warning::Behind { .. })), "{:?}", found.warnings);
}

#[test]
fn a_wrong_focal_length_is_heard_and_a_right_one_is_not() {
    let heard = |pair: &super::scene::Pair, factor: f64| {
        let warned = |seed| {
            let found = orient_relative(&pair.observe(300, SIGMA_MM, seed), factor * FOCAL_MM, &pair.options()).unwrap();
            found.warnings.iter().any(|w| matches!(w, Warning::FocalLength { .. }))
        };
        (0..50).filter(|seed| warned(*seed)).count()
    };
    for pair in [NADIR, OBLIQUE] {
        assert_eq!((heard(&pair, 1.0), heard(&pair, 1.05), heard(&pair, 0.95)), (0, 50, 50));
    }
}

#[test]
fn a_sigma_that_the_residuals_contradict_is_not_used() {
    let observations = NADIR.observe(200, SIGMA_MM, 8);
    let with = |sigma0_mm| oriented(&observations, &OrientationOptions { sigma0_mm, ..NADIR.options() });
    let (without, right, wrong) = (with(None), with(Some(SIGMA_MM)), with(Some(0.25 * SIGMA_MM)));
    assert!(right.global_test.unwrap().passed && right.warnings.is_empty(), "{:?}", right.warnings);
    assert!(!wrong.global_test.unwrap().passed && matches!(wrong.warnings[..], [Warning::Sigma { .. }]), "{:?}", wrong.warnings);
    assert_eq!(wrong.standard_errors, without.standard_errors);
    assert_eq!(wrong.half_widths_95, without.half_widths_95);
}

#[test]
fn determinants_have_the_redundancies_of_their_own_estimator() {
    for pair in [NADIR, OBLIQUE] {
        let options = OrientationOptions { method: OrientationMethod::Determinant, alpha0: 1e-6, ..pair.options() };
        let (mut squares, mut sigma) = ([0.0; 2], 0.0);
        for seed in 0..300 {
            let found = oriented(&pair.observe(12, SIGMA_MM, 700 + seed), &options);
            let kept = (0..12).filter(|k| !found.rejected.contains(k));
            let sum: f64 = kept.map(|k| found.points[k].unwrap().redundancy).sum();
            assert!((sum - found.degrees_of_freedom as f64).abs() < 1e-6, "{sum}");
            sigma += (found.sigma0_mm.unwrap() / SIGMA_MM).powi(2) / 300.0;
            // An observation in a corner and another.
            for (square, k) in squares.iter_mut().zip([0, 7]) {
                *square += found.points[k].unwrap().w.powi(2) / 300.0;
            }
        }
        assert!((sigma - 1.0).abs() < 0.15 && squares.iter().all(|square| (square - 1.0).abs() < 0.25), "σ₀² {sigma}, w² {squares:?}");
    }
}
