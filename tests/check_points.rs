//! Check points: that they err as predicted, and that wrong ones are named, one by one or together.

use super::flown::{adjusted, flown, place};
use super::sampling::cases;
use super::scene::Scene;
use tiepoint::{Axis, BlockWarning, ControlRole, Datum, ReconstructedModel};

#[test]
fn check_points_beside_positions_err_as_predicted_with_one_or_two_control_points_or_none() {
    for control_points in 0..=2 {
        let mut squares: Vec<f64> = Vec::new();
        for seed in 20..20 + cases(&[(); 6], 3).len() as u32 {
            let model = adjusted(&flown(control_points, true, seed));
            let datum = if control_points == 0 { Datum::Gnss } else { Datum::GnssAndControl };
            assert!(model.in_system && model.adjusted.datum == datum, "{:?}", model.adjusted.datum);
            let checks: Vec<_> = model.surveyed.iter().filter(|point| point.role == ControlRole::Check).collect();
            assert_eq!((checks.len(), model.surveyed.len()), (4, 4 + control_points));
            for point in checks {
                squares.extend((0..3).map(|k| (point.difference_m[k] / point.standard_errors_m[k].unwrap()).powi(2)));
            }
        }
        let rms = (squares.iter().sum::<f64>() / squares.len() as f64).sqrt();
        println!("{control_points} control points: {rms} of {}", squares.len());
        assert!((0.7..1.4).contains(&rms), "{control_points} control points: {rms}");
    }
}

#[test]
fn a_wrong_check_point_is_named_and_good_ones_are_not() {
    for seed in [1, 2] {
        let mut scene = flown(8, true, seed);
        let wrong = (0..scene.description.control.len()).find(|k| scene.description.control[*k].role == ControlRole::Check).unwrap();
        let named = |scene: &Scene| -> Vec<(String, Axis, f64)> {
            let of = |warning: BlockWarning| match warning {
                BlockWarning::CheckRefused { point, axis, difference_m, .. } => Some((point, axis, difference_m)),
                _ => None,
            };
            adjusted(scene).warnings.into_iter().filter_map(of).collect()
        };
        assert_eq!(named(&scene), []);
        place(&mut scene.description.control[wrong])[1] += 1.5;
        let found = named(&scene);
        let [(point, Axis::Y, difference_m)] = &found[..] else { panic!("{found:?}") };
        assert!(*point == scene.description.control[wrong].name && (difference_m + 1.5).abs() < 0.5, "{found:?}");
    }
}

#[test]
fn check_points_that_differ_alike_are_told_though_each_is_within_its_standard_error() {
    let apart = |model: &ReconstructedModel| {
        let of = |warning: &BlockWarning| match *warning {
            BlockWarning::ChecksApart { axis, points, difference_m, error_m } => Some((axis, points, difference_m, error_m)),
            _ => None,
        };
        model.warnings.iter().find_map(of)
    };
    let checks =
        |scene: &Scene| (0..scene.description.control.len()).filter(|k| scene.description.control[*k].role == ControlRole::Check).collect();
    let mut clean = 0;
    for seed in 40..40 + cases(&[(); 8], 3).len() as u32 {
        for control_points in [0, 6] {
            let mut scene = flown(control_points, true, seed);
            clean += usize::from(apart(&adjusted(&scene)).is_some());
            if seed > 41 {
                continue;
            }
            // Errors of the block are common to the points: their mean is known less well than by chance alone, and better than one of them.
            let error_m = adjusted(&scene).surveyed.iter().filter_map(|point| point.standard_errors_m[2]).fold(0.0, f64::max);
            let raised: Vec<usize> = checks(&scene);
            raised.iter().for_each(|point| place(&mut scene.description.control[*point])[2] += 6.0 * error_m);
            let (axis, points, difference_m, told_m) = apart(&adjusted(&scene)).unwrap();
            assert_eq!((axis, points), (Axis::Z, 4));
            assert!((difference_m + 6.0 * error_m).abs() < 3.0 * error_m && told_m < 1.2533 * error_m, "{difference_m} {told_m} {error_m}");
        }
    }
    assert!(clean <= 1, "{clean} blocks without errors");
}
