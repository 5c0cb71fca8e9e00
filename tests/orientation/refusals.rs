//! What cannot be oriented is refused with its reason.

use super::scene::{Dice, FOCAL_MM, NADIR, Pair, spoil};
use tiepoint::{Error, Observation, OrientationOptions, orient_relative};

#[test]
fn what_cannot_be_oriented_is_refused_with_its_reason() {
    let refuse = |observations: &[Observation]| {
        let [robust, plain] = [true, false].map(|robust| {
            let options = OrientationOptions { robust, ..NADIR.options() };
            orient_relative(observations, FOCAL_MM, &options).expect_err("no orientation")
        });
        // A value that is no number is unequal to itself.
        assert_eq!(robust.to_string(), plain.to_string());
        robust
    };
    let good = NADIR.observe(50, 0.01, 30);
    assert_eq!(refuse(&good[..4]).code(), "too-few");
    assert_eq!(refuse(&[]).code(), "too-few");
    assert_eq!(refuse(&[good[0]; 20]).code(), "too-few");
    let four_places: Vec<_> = (0..20).map(|k| good[k % 4]).collect();
    assert_eq!(refuse(&four_places).code(), "too-few");
    let identical: Vec<_> = good.iter().map(|o| Observation { right: o.left, ..*o }).collect();
    assert_eq!(refuse(&identical).code(), "degenerate");
    let on_a_line: Vec<_> = good.iter().map(|o| Observation { left: [o.left[0], 0.5 * o.left[0] + 3.0], ..*o }).collect();
    assert_eq!(refuse(&on_a_line).code(), "degenerate");
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300] {
        let mut absurd = good.clone();
        absurd[17].right[1] = value;
        let error = refuse(&absurd);
        assert!(error.code() == "invalid-input" && error.to_string().contains("observation 17"), "{error}");
    }
}

#[test]
fn a_pure_rotation_is_flagged() {
    let turned = Pair { base: [0.0; 3], angles_deg: [3.0, -5.0, 10.0], ..NADIR };
    for (sigma, share) in [(0.0, 0.0), (0.02, 0.0), (0.02, 0.2)] {
        for seed in 0..5 {
            let mut observations = turned.observe(300, sigma, 50 + seed);
            spoil(&mut observations, share, seed);
            let error = orient_relative(&observations, FOCAL_MM, &OrientationOptions::default()).expect_err("a rotation has no base");
            assert!(error.code() == "degenerate", "σ {sigma}, {share}: {error}");
        }
    }
}

#[test]
fn a_base_without_x_is_named() {
    let pair = Pair { base: [0.0, 80.0, 0.0], ..NADIR };
    let error = orient_relative(&pair.observe(100, 0.0, 60), FOCAL_MM, &OrientationOptions::default()).unwrap_err();
    assert!(error.code() == "degenerate" && error.to_string().contains("by and bz"), "{error}");
}

#[test]
fn options_outside_their_ranges_are_named() {
    let observations = NADIR.observe(20, 0.01, 70);
    let refused = |options: OrientationOptions, focal_mm: f64| match orient_relative(&observations, focal_mm, &options) {
        Err(Error::InvalidOption { field, .. }) => field,
        other => panic!("{other:?}"),
    };
    let default = OrientationOptions::default;
    for wrong in [0.0, 0.3, 1.0, f64::NAN] {
        assert_eq!(refused(OrientationOptions { alpha0: wrong, ..default() }, FOCAL_MM), "orientation.alpha0");
    }
    for wrong in [0.4, 1.0, f64::NAN] {
        assert_eq!(refused(OrientationOptions { beta0: wrong, ..default() }, FOCAL_MM), "orientation.beta0");
    }
    for wrong in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(refused(OrientationOptions { sigma0_mm: Some(wrong), ..default() }, FOCAL_MM), "orientation.sigma0_mm");
    }
    for base_mm in [f64::NAN, f64::INFINITY, 1e7, 0.0] {
        assert_eq!(refused(OrientationOptions { base_mm: Some(base_mm), ..default() }, FOCAL_MM), "orientation.base_mm");
    }
    for focal_mm in [0.0, -153.0, f64::NAN, f64::INFINITY] {
        assert_eq!(refused(default(), focal_mm), "focal_mm");
    }
}

#[test]
fn observations_without_any_geometry_never_panic_and_never_look_precise() {
    for seed in 0..20 {
        let mut dice = Dice::new(seed);
        let mut place = || [dice.uniform(-100.0, 100.0), dice.uniform(-100.0, 100.0)];
        let observations: Vec<_> = (0..100).map(|_| Observation::new(place(), place())).collect();
        if let Ok(found) = orient_relative(&observations, FOCAL_MM, &OrientationOptions::default()) {
            assert!(found.sigma0_mm.unwrap() > 1.0, "seed {seed}: σ0 {:?}, {} rejected", found.sigma0_mm, found.rejected.len());
        }
    }
}
