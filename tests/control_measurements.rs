//! Wrong or missing image measurements of surveyed points: which points they lose, and what is said of these.

use super::flown::{adjusted, control, flown};
use super::scene::Scene;
use tiepoint::{BlockWarning, ControlRole, ReconstructedModel};

#[test]
fn a_point_whose_measurements_show_no_common_place_takes_no_part_and_is_named_without_figures() {
    let mut told = Vec::new();
    for shift_px in [3.0, 6.0, 10.0, 15.0, 25.0, 40.0] {
        let mut scene = flown(7, true, 5);
        let wrong = control(&scene)[3];
        let name = scene.description.control[wrong].name.clone();
        for (k, mark) in scene.description.control[wrong].measurements.iter_mut().enumerate() {
            let (sine, cosine) = (2.4 * k as f64).sin_cos();
            (mark.x_px, mark.y_px) = (mark.x_px + shift_px * cosine, mark.y_px + shift_px * sine);
        }
        let model = adjusted(&scene);
        let is_untested = |warning: &BlockWarning| matches!(warning, BlockWarning::ControlUntested { point, measurements } if *point == name && *measurements > 1);
        let own = model.surveyed.iter().find(|point| point.name == name);
        println!("{shift_px}: {} {:?}", model.adjusted.block.control.len(), own.map(|point| (point.rays, point.refused)));
        if model.warnings.iter().any(is_untested) {
            told.push(shift_px);
            assert_eq!(model.adjusted.block.control.len(), 6, "{:?}", model.warnings);
            assert!(own.is_none_or(|point| point.refused.is_some_and(|refused| refused.axis.is_none() && !refused.is_used)), "{own:?}");
        }
    }
    assert!(!told.is_empty());
}

#[test]
fn control_points_that_most_lose_by_their_measurements_are_said_with_rows_that_count_from_the_bottom() {
    let lost = |model: &ReconstructedModel| {
        let of = |warning: &BlockWarning| match *warning {
            BlockWarning::ControlLost { lost, points, from_bottom, .. } => Some((lost, points, from_bottom)),
            _ => None,
        };
        model.warnings.iter().find_map(of)
    };
    let is_unplaced = |model: &ReconstructedModel| model.warnings.iter().any(|is| matches!(is, BlockWarning::ControlWithoutPlace { .. }));
    for has_gnss in [false, true] {
        let clean = flown(7, has_gnss, 5);
        let model = adjusted(&clean);
        assert!(lost(&model).is_none() && !is_unplaced(&model), "{:?}", model.warnings);
        let [mut from_bottom, mut scattered] = [(); 2].map(|()| flown(7, has_gnss, 5));
        for point in control(&scattered) {
            for (k, mark) in from_bottom.description.control[point].measurements.iter_mut().enumerate() {
                let camera = from_bottom.description.images[mark.image].camera;
                mark.y_px = f64::from(from_bottom.description.cameras[camera].height_px) - mark.y_px;
                let other = &mut scattered.description.control[point].measurements[k];
                (other.x_px, other.y_px) = (other.x_px * [0.2, 0.9][k % 2], other.y_px * [0.9, 0.1, 0.5][k % 3]);
            }
        }
        for (scene, is_flipped) in [(from_bottom, true), (scattered, false)] {
            let model = adjusted(&scene);
            let (lost, points, from_bottom) = lost(&model).unwrap();
            assert!(lost >= 4 && points == 7 && from_bottom == is_flipped, "{:?}", model.warnings);
            // GNSS positions place the block all the same.
            assert_eq!(is_unplaced(&model), !has_gnss, "{:?}", model.warnings);
        }
    }
}

#[test]
fn the_only_control_point_is_lost_by_its_measurements_beside_positions_and_that_is_told() {
    for count in [1, 2] {
        let mut scene = flown(count, true, 5);
        let first = control(&scene)[0];
        for mark in &mut scene.description.control[first].measurements {
            let camera = scene.description.images[mark.image].camera;
            mark.y_px = f64::from(scene.description.cameras[camera].height_px) - mark.y_px;
        }
        let model = adjusted(&scene);
        let lost = model.warnings.iter().find_map(|warning| match *warning {
            BlockWarning::ControlLost { lost, points, from_bottom, .. } => Some((lost, points, from_bottom)),
            _ => None,
        });
        assert_eq!(lost, Some((1, count, true)));
    }
}

#[test]
fn a_point_that_is_measured_in_one_image_is_named_by_what_it_is_for() {
    let mut scene = flown(5, true, 5);
    let first = |scene: &Scene, role| scene.description.control.iter().position(|point| point.role == role).unwrap();
    for role in [ControlRole::Control, ControlRole::Check] {
        let point = first(&scene, role);
        scene.description.control[point].name = "GCP 1".into();
        scene.description.control[point].measurements.truncate(1);
    }
    let texts: Vec<String> = adjusted(&scene).warnings.iter().map(ToString::to_string).collect();
    let has = |text: &str| texts.iter().any(|told| told == text);
    assert!(has("Control point GCP 1 takes no part: it is measured in one oriented image."), "{texts:?}");
    assert!(has("Check point GCP 1 is not determined: it is measured in one oriented image."), "{texts:?}");
}
