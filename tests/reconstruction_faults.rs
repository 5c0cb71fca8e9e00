//! The reconstruction of blocks of which what is known is wrong, missing or poor.

use super::sampling::cases;
use super::scene::{Scene, scene, selected};
use tiepoint::{
    BlockFlight, BlockOptions, BlockWarning, ControlRole, Datum, GroundControlPoint, ImageObservation, KnownCamera, ObservationVerdict,
    ObservedPosition, Reconstruction, ReconstructionOptions, geographic_from_local, tie_points,
};

/// Where the simulated blocks lie on the earth.
const ORIGIN: [f64; 3] = [8.0, 50.0, 200.0];

/// Errors of positions in m that are the same in every run: between -1 and 1 times a size.
fn error(index: usize, coordinate: usize) -> f64 {
    let mixed = (index * 3 + coordinate + 1) * 7919 % 2003;
    mixed as f64 / 1001.0 - 1.0
}

impl Scene {
    /// Gives every image the position that a receiver with errors up to 3 m records.
    fn record_positions(&mut self) {
        for (index, (image, exposure)) in self.description.images.iter_mut().zip(&self.block.exposures).enumerate() {
            let position = [0, 1, 2].map(|k| exposure.centre[k] + 3.0 * error(index, k));
            image.position = Some(ObservedPosition::Local { position, sigma: [3.0; 3] });
        }
    }

    /// The same on the earth, with a height for those images that `has_height` names.
    fn record_places(&mut self, has_height: impl Fn(usize) -> bool) {
        for (index, (image, exposure)) in self.description.images.iter_mut().zip(&self.block.exposures).enumerate() {
            let position = [0, 1, 2].map(|k| exposure.centre[k] + 3.0 * error(index, k));
            let [longitude_deg, latitude_deg, height_m] = geographic_from_local(position, ORIGIN);
            let height_m = has_height(index).then_some(height_m);
            image.position = Some(ObservedPosition::Geographic { longitude_deg, latitude_deg, height_m, sigma_m: [3.0, 3.0, 6.0] });
        }
    }

    fn shift_position(&mut self, image: usize, by: [f64; 3]) {
        if let Some(ObservedPosition::Local { position, .. }) = &mut self.description.images[image].position {
            (0..3).for_each(|k| position[k] += by[k]);
        }
    }

    /// A block that is reconstructed with all its images, its shape right to `most_off_m`.
    fn assert_all(&self, what: &str, most_off_m: f64) -> Reconstruction {
        let reconstruction = self.reconstruct(&selected());
        self.report(what, &reconstruction);
        assert_eq!((reconstruction.models.len(), reconstruction.unoriented.len()), (1, 0), "{what}: {:?}", reconstruction.unoriented);
        let (off, _) = self.errors(&reconstruction, 0);
        assert!(off < most_off_m, "{what}: {off} m");
        reconstruction
    }

    /// How far the images lie from the truth in m where the system is that of the truth: root mean squares of x, y and of z.
    fn off_in_system(&self, reconstruction: &Reconstruction) -> [f64; 2] {
        let model = &reconstruction.models[0];
        let mut sums = [0.0; 2];
        for (k, image) in model.images.iter().zip(&model.adjusted.block.images) {
            let d = [0, 1, 2].map(|i| image.pose.position[i] - self.block.exposures[*k].centre[i]);
            sums[0] += d[0] * d[0] + d[1] * d[1];
            sums[1] += d[2] * d[2];
        }
        sums.map(|sum| (sum / model.images.len() as f64).sqrt())
    }
}

fn says(reconstruction: &Reconstruction, words: &[&str]) -> bool {
    reconstruction.models[0].warnings.iter().any(|warning| words.iter().all(|word| warning.to_string().contains(word)))
}

#[test]
fn positions_without_heights_place_a_block_that_is_taken_as_level() {
    let mut scene = scene(&BlockFlight { strips: 3, exposures: 5, features: 1000, ..BlockFlight::default() }, 1.0);
    scene.record_places(|_| false);
    let reconstruction = scene.assert_all("no heights", 2.0);
    let model = &reconstruction.models[0];
    assert!(model.in_system && model.adjusted.datum == Datum::Gnss);
    assert!(says(&reconstruction, &["No heights of GNSS positions", "level"]), "{:?}", model.warnings);
    // Heights count from the mean of the flight; what is told of them is that they are uncertain.
    let heights: Vec<f64> = model.adjusted.block.images.iter().map(|image| image.pose.position[2]).collect();
    let mean = heights.iter().sum::<f64>() / heights.len() as f64;
    assert!(mean.abs() < 5.0 && heights.iter().all(|z| (z - mean).abs() < 60.0), "{heights:?}");
    assert!(model.adjusted.images.iter().all(|image| image.position_errors.unwrap()[2] > 10.0));
    assert!(model.adjusted.images.iter().all(|image| image.gnss.unwrap().residual[0].abs() < 10.0));
}

#[test]
fn a_height_that_is_missing_leaves_the_block_in_its_system() {
    let mut scene = scene(&BlockFlight { strips: 3, exposures: 5, features: 1000, ..BlockFlight::default() }, 1.0);
    for missing in [vec![0], vec![7], (3..15).collect()] {
        scene.record_places(|image| !missing.contains(&image));
        let reconstruction = scene.assert_all("a height missing", 2.0);
        let model = &reconstruction.models[0];
        assert!(model.in_system && model.adjusted.datum == Datum::Gnss, "{:?}", model.warnings);
        assert!(!says(&reconstruction, &["level"]), "{:?}", model.warnings);
        let gnss = model.adjusted.images[missing[0]].gnss.unwrap();
        assert!(gnss.residual[2] == 0.0 && gnss.residual[0] != 0.0);
    }
}

#[test]
fn a_wrong_recorded_position_is_left_out_and_told() {
    let mut scene = scene(&BlockFlight::default(), 1.0);
    for (by, told) in [([30.0, 0.0, 0.0], "m)"), ([300.0, 0.0, 0.0], "m)"), ([0.0, 0.0, -3000.0], "m)"), ([5e6, 0.0, 0.0], "m)")] {
        scene.record_positions();
        scene.shift_position(6, by);
        let reconstruction = scene.assert_all(&format!("a position {by:?} off"), 1.5);
        let model = &reconstruction.models[0];
        assert!(model.in_system && says(&reconstruction, &["GNSS position", "photo_00006", told]), "{:?}", model.warnings);
        let gnss = model.adjusted.images[6].gnss.unwrap();
        let size = by.iter().map(|v| v * v).sum::<f64>().sqrt();
        let residual = gnss.residual.iter().map(|v| v * v).sum::<f64>().sqrt();
        assert!(!gnss.accepted && (residual - size).abs() < 6.0, "{residual} {size}");
        let refused = model.adjusted.images.iter().filter(|image| !image.gnss.unwrap().accepted).count();
        assert_eq!(refused, 1);
        assert!(says(&reconstruction, &["1 GNSS position does not fit and is rejected"]), "{:?}", model.warnings);
        let off = scene.off_in_system(&reconstruction);
        assert!(off.iter().all(|off| *off < 3.0), "{off:?}");
    }
}

#[test]
fn a_receiver_without_a_fix_does_not_move_the_block() {
    let mut scene = scene(&BlockFlight { strips: 3, exposures: 5, features: 1000, ..BlockFlight::default() }, 1.0);
    scene.record_places(|_| true);
    for image in [0, 9] {
        let position = &mut scene.description.images[image].position;
        *position = Some(ObservedPosition::Geographic { longitude_deg: 0.0, latitude_deg: 0.0, height_m: Some(0.0), sigma_m: [3.0; 3] });
    }
    let reconstruction = scene.assert_all("two without a fix", 2.0);
    assert!(reconstruction.models[0].in_system && says(&reconstruction, &["2 GNSS positions", "photo_00000", "photo_00009"]));
    let origin = reconstruction.origin.unwrap();
    assert!((origin.latitude_deg - ORIGIN[1]).abs() < 0.1 && (origin.longitude_deg - ORIGIN[0]).abs() < 0.1, "{origin:?}");
}

#[test]
fn good_recorded_positions_are_all_kept() {
    for seed in 1..4 {
        let mut scene = scene(&BlockFlight { seed, ..BlockFlight::default() }, 1.0);
        scene.record_positions();
        let reconstruction = scene.assert_all("good positions", 1.5);
        assert!(reconstruction.models[0].adjusted.images.iter().all(|image| image.gnss.unwrap().accepted));
    }
}

#[test]
fn a_camera_for_every_image_is_calibrated_as_far_as_the_block_determines_it() {
    for &(relief_m, recorded) in cases(&[(15.0, true), (2.0, false), (60.0, false), (15.0, false)], 3) {
        let mut scene = scene(&BlockFlight { relief_m, ..BlockFlight::default() }, 1.0);
        if recorded {
            scene.record_positions();
        }
        let focal = scene.description.cameras[0].focal_px;
        let camera = KnownCamera::of_size(scene.block.width_px, scene.block.height_px, focal);
        scene.description.cameras = vec![camera; 30];
        scene.description.images.iter_mut().enumerate().for_each(|(index, image)| image.camera = index);
        let reconstruction = scene.assert_all(&format!("30 cameras, relief {relief_m} m, positions {recorded}"), 40.0);
        assert_eq!(reconstruction.models[0].cameras.len(), 30);
        assert!(reconstruction.models[0].in_system == recorded);
        // Cameras that are not determined contradict good positions.
        assert!(reconstruction.models[0].adjusted.images.iter().all(|image| image.gnss.is_none_or(|gnss| gnss.accepted)));
    }
}

/// Surveyed points, well spread, with marks in every image that shows them; marks are off by up to `most_px`.
fn surveyed(scene: &Scene, most_px: f64) -> Vec<GroundControlPoint> {
    let mut control = Vec::new();
    let ground = &scene.block.ground;
    let reach = |k: usize| ground.iter().map(|p| p[k]).fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], v| [a.min(v), b.max(v)]);
    let (x, y) = (reach(0), reach(1));
    for (index, share) in [[0.3, 0.3], [0.7, 0.3], [0.5, 0.5], [0.3, 0.7], [0.7, 0.7]].iter().enumerate() {
        let wanted = [x[0] + share[0] * (x[1] - x[0]), y[0] + share[1] * (y[1] - y[0])];
        let far = |p: &[f64; 3]| (p[0] - wanted[0]).powi(2) + (p[1] - wanted[1]).powi(2);
        let position = *ground.iter().min_by(|a, b| far(a).total_cmp(&far(b))).unwrap();
        let mut rays = Vec::new();
        for (image, exposure) in scene.block.exposures.iter().enumerate() {
            if let Some([x, y]) = exposure.project(position, scene.block.width_px, scene.block.height_px) {
                let off = [0, 1].map(|k| most_px * error(image * 5 + index, k));
                rays.push(ImageObservation { image, x_px: x + off[0], y_px: y + off[1], confidence: 1.0 });
            }
        }
        control.push(GroundControlPoint {
            name: format!("gcp {index}"),
            role: ControlRole::Control,
            sigma_px: None,
            position: ObservedPosition::Local { position, sigma: [0.02, 0.02, 0.03] },
            measurements: rays,
        });
    }
    control
}

#[test]
fn check_points_take_no_part_and_say_what_the_block_is_worth() {
    let mut scene = scene(&BlockFlight { strips: 3, exposures: 5, features: 1000, ..BlockFlight::default() }, 1.0);
    scene.description.control = surveyed(&scene, 0.3);
    scene.description.control[2].role = ControlRole::Check;
    let plain = scene.reconstruct(&selected());
    let model = &plain.models[0];
    assert_eq!((model.adjusted.block.control.len(), model.surveyed.len()), (4, 5));
    let check = model.surveyed.iter().find(|point| point.role == ControlRole::Check).unwrap();
    assert_eq!(check.name, "gcp 2");
    for k in 0..3 {
        let (difference, error) = (check.difference_m[k], check.standard_errors_m[k].unwrap());
        assert!(difference.abs() < 4.0 * error && error < 0.5, "{k}: {difference} +- {error}");
    }
    // A check point that is wrong says so, and moves nothing.
    let ObservedPosition::Local { position, .. } = &mut scene.description.control[2].position else { unreachable!() };
    position[2] += 5.0;
    let wrong = scene.reconstruct(&selected());
    let off = wrong.models[0].surveyed.iter().find(|point| point.role == ControlRole::Check).unwrap().difference_m[2];
    assert!((off + 5.0 - check.difference_m[2]).abs() < 1e-6, "{off}");
    assert_eq!(wrong.models[0].adjusted.block.images, model.adjusted.block.images);
}

#[test]
fn marks_are_judged_by_their_own_precision() {
    let mut scene = scene(&BlockFlight::default(), 1.0);
    for most_px in [1.0, 2.0] {
        scene.description.control = surveyed(&scene, most_px);
        let marks: usize = scene.description.control.iter().map(|control| control.measurements.len()).sum();
        let reconstruction = scene.assert_all(&format!("marks off by up to {most_px} px"), 1.5);
        let model = &reconstruction.models[0];
        assert!(marks >= 25 && model.in_system && model.adjusted.datum == Datum::Control);
        let accepted: usize = model.points.iter().zip(&model.adjusted.points).rev().take(5).map(|(_, point)| point.unwrap().rays).sum();
        assert!(accepted as f64 >= 0.95 * marks as f64, "{accepted} of {marks}");
        let off = scene.off_in_system(&reconstruction);
        assert!(off.iter().all(|off| *off < 4.0 * most_px), "{off:?}");
    }
}

#[test]
fn marks_that_do_not_fit_are_told_by_name() {
    let mut scene = scene(&BlockFlight::default(), 1.0);
    scene.description.control = surveyed(&scene, 0.3);
    let image = scene.description.control[2].measurements[1].image;
    scene.description.control[2].measurements[1].x_px += 60.0;
    for (index, ray) in scene.description.control[3].measurements.iter_mut().enumerate() {
        ray.x_px += 200.0 * error(index, 0);
        ray.y_px += 200.0 * error(index, 1);
    }
    let reconstruction = scene.assert_all("wrong marks", 1.5);
    let warnings = &reconstruction.models[0].warnings;
    assert!(says(&reconstruction, &["1 of the", "gcp 2", &format!("photo_{image:05}")]), "{warnings:?}");
    assert!(says(&reconstruction, &["gcp 3"]), "{warnings:?}");
    assert!(!says(&reconstruction, &["gcp 1"]), "{warnings:?}");
}

#[test]
fn surveyed_points_in_another_unit_contradict_recorded_positions() {
    let mut scene = scene(&BlockFlight { strips: 3, exposures: 5, features: 1000, ..BlockFlight::default() }, 1.0);
    let points = surveyed(&scene, 0.3);
    for (scale, told) in [
        (1.0, None),
        (1.1, None),
        (3.28084, Some(["3.3 times", "are they in feet?"])),
        (1000.0, Some(["1000 times", "are they in millimetres?"])),
        (1.6, Some(["1.6 times", "metres are needed"])),
        (0.001, Some(["0.0010 times", "are they in kilometres?"])),
    ] {
        scene.record_places(|image| image != 4);
        // A receiver without a fix is no reason to doubt the surveyed points.
        let no_fix = ObservedPosition::Geographic { longitude_deg: 0.0, latitude_deg: 0.0, height_m: Some(0.0), sigma_m: [3.0; 3] };
        scene.description.images[7].position = Some(no_fix);
        scene.description.control = points.clone();
        for control in &mut scene.description.control {
            let ObservedPosition::Local { position, sigma } = &mut control.position else { unreachable!() };
            position.iter_mut().chain(sigma).for_each(|v| *v *= scale);
        }
        let reconstruction = scene.reconstruct(&selected());
        let model = &reconstruction.models[0];
        assert!(model.in_system && model.adjusted.datum == Datum::Control, "{scale}: {:?}", model.warnings);
        assert!(reconstruction.origin.is_none(), "what the surveyed points are of has no place on the earth");
        assert!(model.adjusted.images.iter().all(|image| image.gnss.is_none()));
        assert_eq!(says(&reconstruction, &["times as large as the GNSS positions"]), told.is_some(), "{scale}: {:?}", model.warnings);
        assert!(told.is_none_or(|words| says(&reconstruction, &words)), "{scale}: {:?}", model.warnings);
    }
    // Recorded positions that are as uncertain as the block is wide tell nothing of its size.
    for image in &mut scene.description.images {
        let Some(ObservedPosition::Geographic { sigma_m, .. }) = &mut image.position else { unreachable!() };
        *sigma_m = [600.0; 3];
    }
    let reconstruction = scene.reconstruct(&selected());
    assert!(!says(&reconstruction, &["times as large"]), "{:?}", reconstruction.models[0].warnings);
}

#[test]
fn degrees_in_place_of_metres_are_told() {
    let mut scene = scene(&BlockFlight { strips: 3, exposures: 5, features: 1000, ..BlockFlight::default() }, 1.0);
    scene.description.control = surveyed(&scene, 0.3);
    let reconstruction = scene.reconstruct(&selected());
    assert!(!says(&reconstruction, &["longitude"]), "{:?}", reconstruction.models[0].warnings);
    for control in &mut scene.description.control {
        let ObservedPosition::Local { position, .. } = &mut control.position else { unreachable!() };
        *position = geographic_from_local(*position, ORIGIN);
    }
    let reconstruction = scene.reconstruct(&selected());
    // It stands first: that the points lie on a line, or in one place, follows from it.
    let told = reconstruction.models[0].warnings[0].to_string();
    assert!(told.contains("longitude and latitude") && told.contains("--crs EPSG:4326"), "{:?}", reconstruction.models[0].warnings);
}

/// Two strips whose positions, of these standard errors, have the second strip higher by this share of their distance.
fn sloping(slope: f64, sigma: [f64; 3]) -> Scene {
    let mut scene = scene(&BlockFlight { strips: 2, exposures: 6, features: 1000, ..BlockFlight::default() }, 1.0);
    let width = scene.block.exposures[6].centre[1] - scene.block.exposures[0].centre[1];
    for (index, (image, exposure)) in scene.description.images.iter_mut().zip(&scene.block.exposures).enumerate() {
        let mut position = exposure.centre;
        position[2] += if index >= 6 { slope * width } else { 0.0 };
        let [longitude_deg, latitude_deg, height_m] = geographic_from_local(position, ORIGIN);
        image.position = Some(ObservedPosition::Geographic { longitude_deg, latitude_deg, height_m: Some(height_m), sigma_m: sigma });
    }
    scene
}

/// The angle in degrees between the mean direction of view and a direction.
fn mean_view_off(reconstruction: &Reconstruction, view: [f64; 3]) -> f64 {
    let images = &reconstruction.models[0].adjusted.block.images;
    let mean = [0, 1, 2].map(|k| -images.iter().map(|image| image.pose.rotation[2][k]).sum::<f64>());
    let length = mean.iter().map(|v| v * v).sum::<f64>().sqrt();
    ((0..3).map(|k| mean[k] * view[k]).sum::<f64>() / length).clamp(-1.0, 1.0).acos().to_degrees()
}

const DOWN: [f64; 3] = [0.0, 0.0, -1.0];

#[test]
fn a_block_that_its_positions_hardly_level_is_levelled_by_its_views() {
    for slope in [0.0, 0.6] {
        let reconstruction = sloping(slope, [60.0, 60.0, 100.0]).reconstruct(&selected());
        let warnings = &reconstruction.models[0].warnings;
        assert!(
            reconstruction.models[0].in_system && says(&reconstruction, &["GNSS positions hardly", "taken as vertical"]),
            "{warnings:?}"
        );
        assert!(mean_view_off(&reconstruction, DOWN) < 3.0, "slope {slope}: {}", mean_view_off(&reconstruction, DOWN));
    }
}

#[test]
fn recorded_directions_of_view_level_a_block_before_the_vertical_does() {
    let mut scene = sloping(0.0, [60.0, 60.0, 100.0]);
    let (sine, cosine) = 10_f64.to_radians().sin_cos();
    let view = [0.0, sine, -cosine];
    scene.description.images.iter_mut().for_each(|image| image.view = Some(view));
    let reconstruction = scene.reconstruct(&selected());
    assert!(says(&reconstruction, &["recorded directions of view level it"]), "{:?}", reconstruction.models[0].warnings);
    assert!(mean_view_off(&reconstruction, view) < 3.0, "{}", mean_view_off(&reconstruction, view));
}

#[test]
fn positions_on_a_line_are_levelled_about_it() {
    let mut scene = scene(&BlockFlight { strips: 1, exposures: 8, features: 1000, ..BlockFlight::default() }, 1.0);
    for is_exact in [false, true] {
        scene.record_places(|_| true);
        for (image, exposure) in scene.description.images.iter_mut().zip(&scene.block.exposures).filter(|_| is_exact) {
            let first = scene.block.exposures[0].centre;
            let position = [exposure.centre[0], first[1], first[2]];
            image.position = Some(ObservedPosition::Local { position, sigma: [1.0; 3] });
        }
        let reconstruction = scene.reconstruct(&selected());
        let warnings = &reconstruction.models[0].warnings;
        assert!(reconstruction.models[0].in_system && says(&reconstruction, &["taken as vertical"]), "{is_exact}: {warnings:?}");
        assert!(mean_view_off(&reconstruction, DOWN) < 3.0, "{is_exact}: {}", mean_view_off(&reconstruction, DOWN));
    }
}

#[test]
fn positions_that_contradict_the_level_are_believed_and_the_tilt_is_told() {
    let reconstruction = sloping(0.6, [15.0, 15.0, 25.0]).reconstruct(&selected());
    let warnings = &reconstruction.models[0].warnings;
    assert!(says(&reconstruction, &["The GNSS positions hardly determine", "° off the vertical on average."]), "{warnings:?}");
    assert!(mean_view_off(&reconstruction, DOWN) > 20.0, "{}", mean_view_off(&reconstruction, DOWN));
}

#[test]
fn what_leaves_the_turn_of_a_block_open_is_named() {
    let mut scene = scene(&BlockFlight { strips: 2, exposures: 4, features: 1000, ..BlockFlight::default() }, 1.0);
    scene.description.control = surveyed(&scene, 0.3);
    for control in &mut scene.description.control {
        let ObservedPosition::Local { sigma, .. } = &mut control.position else { unreachable!() };
        *sigma = [20.0, 20.0, 300.0];
    }
    let reconstruction = scene.reconstruct(&selected());
    assert!(says(&reconstruction, &["The GCPs", "determine the rotation of the whole block"]), "{:?}", reconstruction.models[0].warnings);
    assert!(!says(&reconstruction, &["GNSS positions"]), "{:?}", reconstruction.models[0].warnings);
}

/// A block whose points are all given, with three rays or more, of which fewer than half are so many px off in either coordinate: whether it is said that
/// many observations are wrong, how many do not take part, and of how many.
fn of_wrong_observations(noise_px: f64, wrong_px: f32) -> (bool, usize, usize) {
    let mut scene = scene(&BlockFlight { strips: 3, exposures: 5, features: 600, noise_px, ..BlockFlight::default() }, 1.0);
    let options = BlockOptions { min_rays: 3, ..BlockOptions::default() };
    scene.points = tie_points(&scene.block.matches().unwrap(), &scene.block.image_features(), &options).unwrap().0;
    let size = [scene.block.width_px, scene.block.height_px].map(|side| side as f32);
    for point in 0..scene.points.len() {
        let rays = scene.points.rays(point);
        for (nth, ray) in rays.iter().enumerate().take((rays.len() - 1) / 2) {
            let at = &mut scene.block.features[ray.image as usize][ray.feature as usize];
            (0..2).for_each(|k| at[k] = (at[k] + wrong_px.copysign(error(10 * point + nth, k) as f32)).clamp(0.0, size[k]));
        }
    }
    let reconstruction = scene.reconstruct(&ReconstructionOptions::default());
    scene.report(&format!("noise {noise_px} px, {wrong_px} px off"), &reconstruction);
    let model = &reconstruction.models[0];
    let rejected = model.adjusted.rays.iter().filter(|ray| ray.verdict != ObservationVerdict::Accepted).count() + model.rejected.len();
    let says_so = model.warnings.iter().any(|warning| matches!(warning, BlockWarning::ManyRejected { .. }));
    (says_so, rejected, model.adjusted.rays.len() + model.rejected.len())
}

#[test]
fn many_wrong_observations_make_a_block_weak() {
    for (noise_px, wrong_px) in [(0.3, 6.0), (0.03, 6.0), (0.03, 2.0)] {
        let (says_so, rejected, observations) = of_wrong_observations(noise_px, wrong_px);
        assert!(says_so, "{noise_px} px, {wrong_px} px: {rejected} of {observations}");
    }
}

#[test]
fn cameras_are_named_by_their_images() {
    let flight = BlockFlight { strips: 2, exposures: 5, features: 1000, ..BlockFlight::default() };
    let mut scene = scene(&flight, 1.0);
    scene.description.cameras[0].focal_px = None;
    let reconstruction = scene.reconstruct(&selected());
    assert!(says(&reconstruction, &["The focal length of the camera is not known"]), "{:?}", reconstruction.models[0].warnings);
    let second = scene.description.cameras[0].clone();
    scene.description.cameras.push(second);
    scene.description.images[5..].iter_mut().for_each(|image| image.camera = 1);
    let reconstruction = scene.reconstruct(&selected());
    assert!(
        says(&reconstruction, &["The focal length of camera 2 (photo_00005 and 4 more images)"]),
        "{:?}",
        reconstruction.models[0].warnings
    );
}
