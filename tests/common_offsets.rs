//! What all control points and GNSS positions of a block differ by: it is said, and accuses no point of its own.

use super::flown::{GNSS_SIGMA_M, RTK_SIGMA_M, adjusted, control, flown, flown_by, place, refused};
use super::scene::Scene;
use super::scene::selected;
use super::surveyed::MARK_PX;
use tiepoint::{Axis, BlockWarning, ControlApart, ControlKind, ObservedPosition, ReconstructionOptions};

#[test]
fn heights_of_another_zero_are_said_beside_positions_that_are_surer_than_they_differ() {
    let mut scene = flown(7, true, 5);
    for (image, exposure) in scene.description.images.iter_mut().zip(&scene.block.exposures) {
        image.position = Some(ObservedPosition::Local { position: exposure.centre, sigma: [0.03; 3] });
    }
    // One that is estimated takes the difference upon itself.
    scene.description.cameras.iter_mut().for_each(|camera| camera.free.focal = false);
    for k in control(&scene) {
        place(&mut scene.description.control[k])[2] += 47.0;
    }
    let model = adjusted(&scene);
    let apart = model.warnings.iter().find_map(|warning| match warning {
        BlockWarning::ControlLost { from_bottom: false, control_apart, .. } => Some(*control_apart),
        _ => None,
    });
    let Some(Some(ControlApart::Heights { up_m })) = apart else { panic!("{:?}", model.warnings) };
    assert!((up_m + 47.0).abs() < 1.0, "{up_m} m");
}

#[test]
fn control_points_that_all_contradict_the_positions_stay_used() {
    let mut scene = flown(8, true, 8);
    for point in control(&scene) {
        place(&mut scene.description.control[point])[2] += 8.0;
    }
    let model = adjusted(&scene);
    assert_eq!(model.adjusted.block.control.len(), 8);
    assert!(refused(&model).len() < 2, "{:?}", model.warnings);
}

#[test]
fn what_all_positions_differ_by_from_the_control_is_said() {
    let apart = |scene: &Scene| {
        let of = |warning: BlockWarning| match warning {
            // Control points that seem wrong are no other reason.
            BlockWarning::PositionsApart { axis, difference_m, times, control, .. } => Some((axis, difference_m, times, control)),
            _ => None,
        };
        adjusted(scene).warnings.into_iter().find_map(of)
    };
    // What the positions are off by shows in their residuals, or, where the block follows precise ones, in those of the control points.
    for (sigma_m, seed) in [(GNSS_SIGMA_M, 4), (GNSS_SIGMA_M, 5), (RTK_SIGMA_M, 4), (RTK_SIGMA_M, 5)] {
        let mut scene = flown_by(8, Some(sigma_m), seed);
        // Over flat ground a focal length that is estimated takes an offset of heights upon itself.
        scene.description.cameras.iter_mut().for_each(|camera| camera.free.focal = false);
        assert_eq!(apart(&scene), None);
        // As heights above the sea beside heights above an ellipsoid.
        for k in control(&scene) {
            place(&mut scene.description.control[k])[2] += 2.0;
        }
        let (axis, difference_m, times, control) = apart(&scene).unwrap();
        let within = 4.0 * difference_m.abs() / times;
        assert!(axis == Axis::Z && (difference_m + 2.0).abs() < within && times > 5.0 && control, "{axis:?} {difference_m} {times}");
    }
}

/// Nobody gave the control points of a block that an orthophoto alone holds: its heights are what is named.
#[test]
fn heights_of_an_orthophoto_that_are_off_beside_positions_are_not_named_control_points() {
    let said = |given: usize| {
        let mut scene = flown_by(8, Some(RTK_SIGMA_M), 4);
        scene.description.cameras.iter_mut().for_each(|camera| camera.free.focal = false);
        for k in control(&scene) {
            place(&mut scene.description.control[k])[2] += 5.0;
        }
        // Places of an orthophoto stand behind what was given.
        let options = ReconstructionOptions { mark_sigma_px: MARK_PX, tested_control: Some(given), ..selected() };
        let model = scene.reconstruct(&options).models.swap_remove(0);
        let apart = |warning: &BlockWarning| match warning {
            BlockWarning::PositionsApart { held_by, .. } => Some((*held_by, warning.to_string())),
            _ => None,
        };
        model.warnings.iter().find_map(apart).unwrap_or_else(|| panic!("{:?}", model.warnings))
    };
    let (held_by, text) = said(0);
    assert!(held_by == ControlKind::Places && text.contains("the heights of the orthophoto"), "{text}");
    assert!(!text.contains("control points"), "{text}");
    let (held_by, text) = said(4);
    assert!(held_by == ControlKind::Both && text.contains("the control points and places of the orthophoto"), "{text}");
    let (held_by, text) = said(12);
    assert!(held_by == ControlKind::Surveyed && !text.contains("orthophoto"), "{text}");
}

/// A camera height that is off by 0.6 m beside a standard error of 0.02 m must not pass as right; positions that weigh little are outvoted by the control.
#[test]
fn images_that_follow_precise_positions_away_from_the_control_are_no_oriented_block() {
    for (sigma_m, off_m, follow) in [(RTK_SIGMA_M, 0.6, true), (RTK_SIGMA_M, -2.0, true), (3.0, 6.0, false)] {
        let mut scene = flown_by(8, Some(sigma_m), 4);
        scene.description.cameras.iter_mut().for_each(|camera| camera.free.focal = false);
        for image in &mut scene.description.images {
            let Some(ObservedPosition::Local { position, .. }) = &mut image.position else { unreachable!() };
            position[2] += off_m;
        }
        let model = adjusted(&scene);
        let heights = model
            .adjusted
            .block
            .images
            .iter()
            .zip(&model.images)
            .map(|(image, k)| image.pose.position[2] - scene.block.exposures[*k].centre[2]);
        let mean = heights.sum::<f64>() / model.images.len() as f64;
        println!("{sigma_m} {off_m}: {mean} {:?}", model.adjusted.images[0].position_errors);
        let told = model.warnings.iter().find_map(|warning| match warning {
            BlockWarning::PositionsApart { images_m, .. } => Some(*images_m),
            _ => None,
        });
        let images_m = told.unwrap_or_else(|| panic!("{:?}", model.warnings));
        assert_eq!(images_m.is_some(), follow, "{sigma_m} {off_m}: {:?}", model.warnings);
        if let Some(images_m) = images_m {
            assert!((images_m - mean).abs() < 0.3 * mean.abs(), "{images_m} {mean}");
        }
    }
}
