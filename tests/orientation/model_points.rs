//! The object points of a pair against generated truth.

use super::super::sampling::{about_one, runs};
use super::scene::{FOCAL_MM, NADIR, OBLIQUE, Pair, TO_THE_LEFT, spoil};
use nalgebra::{Matrix3x2, Vector3};
use tiepoint::{Error, Observation, model_points, orient_relative, rotation_from_angles};

/// Where the rays of an errorless observation meet, in mm.
fn true_point(pair: &Pair, o: &Observation) -> Vector3<f64> {
    let [omega, phi, kappa] = pair.angles_deg.map(f64::to_radians);
    let left = Vector3::new(o.left[0], o.left[1], -FOCAL_MM);
    let right = rotation_from_angles(omega, phi, kappa).transpose() * Vector3::new(o.right[0], o.right[1], -FOCAL_MM);
    let rays = Matrix3x2::from_columns(&[left, -right]);
    left * ((rays.transpose() * rays).try_inverse().unwrap() * rays.transpose() * Vector3::from(pair.base))[0]
}

#[test]
fn errors_of_object_points_are_as_large_as_told() {
    const LENGTH: f64 = 640.0;
    for (name, pair) in [("nadir", NADIR), ("oblique", OBLIQUE), ("leftwards", TO_THE_LEFT)] {
        let scale = LENGTH / Vector3::from(pair.base).norm();
        let mut squares = [0.0; 3];
        let mut number = 0.0;
        for seed in 1..=runs(150) {
            let observations = pair.observe(25, 0.02, seed);
            let found = orient_relative(&observations, FOCAL_MM, &pair.options()).unwrap();
            let points = model_points(&found, &observations, LENGTH).unwrap();
            for (point, exact) in points.iter().zip(pair.observe(25, 0.0, seed)).filter_map(|(point, exact)| Some((point.as_ref()?, exact)))
            {
                let wanted = true_point(&pair, &exact) * scale;
                let errors = point.errors.unwrap();
                (0..3).for_each(|k| squares[k] += ((point.position[k] - wanted[k]) / errors[k]).powi(2));
                number += 1.0;
            }
        }
        let means = squares.map(|square| square / number);
        println!("{name}: {means:.3?}");
        assert!(means.iter().all(|mean| about_one(0.25).contains(mean)), "{name}: {means:?}");
    }
}

#[test]
fn object_points_have_the_base_as_unit_and_show_what_was_rejected() {
    let mut observations = NADIR.observe(40, 0.005, 3);
    let spoiled = spoil(&mut observations, 0.1, 4);
    let found = orient_relative(&observations, FOCAL_MM, &NADIR.options()).unwrap();
    let points = model_points(&found, &observations, 1.0).unwrap();
    let rejected: Vec<usize> = (0..40).filter(|k| points[*k].is_some_and(|point| !point.accepted)).collect();
    assert_eq!(rejected, found.rejected);
    assert!(spoiled.iter().filter(|k| rejected.contains(k)).count() > 2, "{rejected:?}");
    let length = Vector3::from(NADIR.base).norm();
    for (point, exact) in points.iter().zip(NADIR.observe(40, 0.0, 3)).filter(|(point, _)| point.is_some_and(|point| point.accepted)) {
        let wanted = true_point(&NADIR, &exact) / length;
        assert!((Vector3::from(point.unwrap().position) - wanted).norm() < 0.01, "{point:?} {wanted}");
    }
    assert!(matches!(model_points(&found, &observations[1..], 1.0), Err(Error::InvalidInput { .. })));
    assert!(model_points(&found, &observations, 0.0).is_err() && model_points(&found, &observations, f64::NAN).is_err());
}
