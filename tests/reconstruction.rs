//! The reconstruction of simulated blocks: everything from the rays alone.

use super::normal::Normal;
use super::sampling::{about_one, runs};
use super::scene::{Scene, scene, selected};
use tiepoint::{
    AdjustmentOptions, Block, BlockDescription, BlockFlight, BlockOptions, BlockView, BlockWarning, CameraUncertainty, ControlRole, Datum,
    FreeParameters, GnssErrors, GroundControlPoint, ImageObservation, ObservationVerdict, ObservedPosition, PointSource, Reconstruction,
    ReconstructionOptions, TiePoints, UnorientedReason, adjust_block, geographic_from_local, local_from_geographic, reconstruct_block,
    simulate_block, tie_points,
};

/// One model of all images, as precise as the rays: σ₀ is the noise of the features.
fn assert_whole(scene: &Scene, reconstruction: &Reconstruction, most_off_m: f64) {
    assert_eq!((reconstruction.models.len(), reconstruction.unoriented.len()), (1, 0), "{:?}", reconstruction.unoriented);
    let model = &reconstruction.models[0];
    assert_eq!(model.images.len(), scene.description.images.len());
    let sigma0 = model.adjusted.sigma0_px.unwrap();
    assert!((sigma0 / 0.3 - 1.0).abs() < 0.06, "{sigma0}");
    let (position, angle) = scene.errors(reconstruction, 0);
    assert!(position < most_off_m && angle < 0.5, "{position} m, {angle} deg");
}

#[test]
fn nadir_blocks_are_oriented_whole() {
    for relief_m in [60.0, 0.0] {
        let scene = scene(&BlockFlight { relief_m, ..BlockFlight::default() }, 1.0);
        let reconstruction = scene.reconstruct(&selected());
        scene.report(&format!("relief of {relief_m} m"), &reconstruction);
        assert_whole(&scene, &reconstruction, 1.5);
        assert!(!reconstruction.models[0].in_system && reconstruction.models[0].warnings[0].to_string().contains("arbitrary"));
    }
}

#[test]
fn an_oblique_block_with_wrong_focal_lengths_is_calibrated() {
    // Forward and backward views of a short strip show other ground than the views down: the block must be longer than it is high.
    let flight = BlockFlight {
        view: BlockView::Oblique,
        exposures: 9,
        forward_overlap: 0.5,
        side_overlap: 0.4,
        features: 1000,
        ..BlockFlight::default()
    };
    let scene = scene(&flight, 1.04);
    let reconstruction = scene.reconstruct(&selected());
    scene.report("oblique", &reconstruction);
    assert_whole(&scene, &reconstruction, 1.0);
    for (camera, calibrated) in reconstruction.models[0].adjusted.block.cameras.iter().enumerate() {
        let wanted = scene.description.cameras[camera].focal_px.unwrap() / 1.04;
        assert!((calibrated.focal_px / wanted - 1.0).abs() < 0.01, "{camera}: {}, {wanted}", calibrated.focal_px);
    }
}

#[test]
fn a_block_of_two_heights_finds_its_focal_length() {
    let mut scene = scene(&BlockFlight { view: BlockView::TwoHeights, ..BlockFlight::default() }, 1.0);
    let wanted = scene.description.cameras[0].focal_px.take().unwrap();
    let reconstruction = scene.reconstruct(&selected());
    scene.report("two heights", &reconstruction);
    assert_whole(&scene, &reconstruction, 3.0);
    let model = &reconstruction.models[0];
    assert_eq!(model.guessed_focal, [0]);
    let (found, error) = (model.adjusted.block.cameras[0].focal_px, model.adjusted.cameras[0].standard_errors[0].unwrap());
    assert!((found - wanted).abs() < 4.0 * error && error < 0.02 * wanted, "{found} ± {error}, {wanted}");
    assert!(model.warnings.iter().any(|warning| matches!(warning, BlockWarning::FocalEstimated { .. })), "{:?}", model.warnings);
}

/// The error of the focal length of a small block, its standard error, and what moved from the given value, as shares of the true one.
fn focal_error(flight: BlockFlight, factor: f64, within: CameraUncertainty) -> [f64; 3] {
    let mut scene = scene(&BlockFlight { strips: 3, exposures: 4, features: 600, ..flight }, factor);
    scene.description.cameras.iter_mut().for_each(|camera| camera.uncertainty = Some(within));
    let model = scene.reconstruct(&selected()).models.swap_remove(0);
    let wanted = scene.description.cameras[0].focal_px.unwrap() / factor;
    let found = model.adjusted.block.cameras[0].focal_px / wanted;
    let error = model.adjusted.cameras[0].standard_errors[0].unwrap_or(0.0) / wanted;
    println!("f x {factor:.3}: {:+.2} % ± {:.2} %", 100.0 * (found - 1.0), 100.0 * error);
    [found - 1.0, error, found - factor]
}

#[test]
fn focal_lengths_of_flat_nadir_blocks_err_by_as_much_as_told() {
    let flat = |seed| BlockFlight { relief_m: 0.0, seed, ..BlockFlight::default() };
    // Quantiles of the normal distribution: the given focal lengths err as EXIF does.
    let deviates = [-1.53, -0.89, -0.49, -0.16, 0.16, 0.49, 0.89, 1.53];
    let errors = deviates.iter().enumerate().map(|(seed, deviate)| {
        let factor = 1.0 + CameraUncertainty::EXIF.focal * deviate;
        focal_error(flat(seed as u32 + 1), factor, CameraUncertainty::EXIF)
    });
    let ratios: Vec<f64> = errors.map(|[off, error, _]| off * off / (error * error)).collect();
    let mean = (ratios.iter().sum::<f64>() / ratios.len() as f64).sqrt();
    println!("error by standard error: {mean:.2}");
    assert!((0.5..1.5).contains(&mean), "{ratios:?}");
    for seed in [11, 12] {
        let [off, error, moved] = focal_error(flat(seed), 1.03, CameraUncertainty::EXIF);
        assert!(off.abs() < 3.0 * error && moved.abs() < CameraUncertainty::EXIF.focal, "{off} {error} {moved}");
        // A calibrated one is held as firmly as it is known.
        let [_, error, moved] = focal_error(flat(seed), 1.003, CameraUncertainty::GIVEN);
        assert!(moved.abs() < 2.0 * CameraUncertainty::GIVEN.focal && error <= 1.003 * CameraUncertainty::GIVEN.focal, "{error} {moved}");
    }
}

#[test]
fn two_wrong_matches_in_five_do_not_keep_a_block_from_being_oriented() {
    for repeated in [0.05, 0.5] {
        let scene = scene(&BlockFlight { wrong: 0.4, repeated, seed: 3, ..BlockFlight::default() }, 1.04);
        let reconstruction = scene.reconstruct(&selected());
        scene.report("40 % wrong", &reconstruction);
        assert_whole(&scene, &reconstruction, 2.0);
    }
}

#[test]
fn parts_without_common_points_are_models_of_their_own() {
    // Forward, backward and downward views of a short block show three stretches of ground.
    let scene = scene(&BlockFlight { view: BlockView::Oblique, strips: 4, exposures: 5, ..BlockFlight::default() }, 1.0);
    let reconstruction = scene.reconstruct(&selected());
    scene.report("short oblique block", &reconstruction);
    assert!(reconstruction.models.len() > 1);
    assert!(reconstruction.models.windows(2).all(|pair| pair[0].images.len() >= pair[1].images.len()));
    let mut all: Vec<usize> = reconstruction.models.iter().flat_map(|model| model.images.clone()).collect();
    all.extend(reconstruction.unoriented.iter().map(|image| image.image));
    all.sort_unstable();
    assert_eq!(all, (0..100).collect::<Vec<_>>(), "every image is in one model or has a reason");
    for model in 0..reconstruction.models.len() {
        assert!(scene.errors(&reconstruction, model).0 < 3.0);
    }
}

#[test]
fn images_that_cannot_be_oriented_have_a_reason() {
    let flight = BlockFlight::default();
    let simulated = simulate_block(&flight).unwrap();
    let whole = scene(&flight, 1.0);
    // Image 7 has no matches at all; of image 20 only eight with each other image are left.
    let counts: Vec<u32> = simulated.features.iter().map(|list| list.len() as u32).collect();
    let mut matches = tiepoint::BlockMatches::new(&counts).unwrap();
    for (images, list) in simulated.pairs.iter().filter(|(images, _)| !images.contains(&7)) {
        let most = if images.contains(&20) { 1 } else { list.len() };
        matches.add_pair(*images, &list[..most]).unwrap();
    }
    let (points, _) = tie_points(&matches, &simulated.image_features(), &BlockOptions::default()).unwrap();
    let reconstruction = reconstruct_block(&whole.description, &points, &whole.block.image_features(), &selected()).unwrap();
    reconstruction.unoriented.iter().for_each(|image| println!("{}", image.reason));
    assert_eq!(reconstruction.models[0].images.len(), 28);
    assert_eq!(reconstruction.unoriented.iter().map(|image| image.image).collect::<Vec<_>>(), [7, 20]);
    assert_eq!(reconstruction.unoriented[0].reason, UnorientedReason::NoPoints);
    assert!(
        matches!(reconstruction.unoriented[1].reason, UnorientedReason::TooFewPoints { needed: 12, .. }),
        "{:?}",
        reconstruction.unoriented[1]
    );
    assert_eq!(reconstruction.unoriented[1].image, 20);
}

#[test]
fn errors_of_assembled_blocks_are_as_large_as_told() {
    let sigma = 0.1;
    let mut squares = [Vec::new(), Vec::new()];
    let mut variances = Vec::new();
    for seed in 1..=runs(120) as u32 {
        let flight = BlockFlight { strips: 3, exposures: 5, features: 1000, seed, ..BlockFlight::default() };
        let mut scene = scene(&flight, 1.0);
        let mut normal = Normal(u64::from(seed) << 32);
        for (image, exposure) in scene.description.images.iter_mut().zip(&scene.block.exposures) {
            let position = exposure.centre.map(|v| v + sigma * normal.next());
            image.position = Some(ObservedPosition::Local { position, sigma: [sigma; 3] });
        }
        scene.description.cameras[0].free = FreeParameters::default();
        let reconstruction = scene.reconstruct(&selected());
        let model = &reconstruction.models[0];
        assert!(model.in_system && model.images.len() == 15);
        variances.push((model.adjusted.sigma0_px.unwrap() / 0.3).powi(2));
        for ((k, image), statistics) in model.images.iter().zip(&model.adjusted.block.images).zip(&model.adjusted.images) {
            let told = statistics.position_errors.unwrap();
            squares[0].extend((0..3).map(|i| ((image.pose.position[i] - scene.block.exposures[*k].centre[i]) / told[i]).powi(2)));
        }
        for ((point, known), statistics) in model.adjusted.block.points.iter().zip(&model.points).zip(&model.adjusted.points) {
            let (Some(statistics), PointSource::TiePoint(index)) = (statistics, known) else { continue };
            let rays = scene.points.rays(*index as usize);
            let owners: Vec<_> = rays.iter().map(|ray| scene.block.owners[ray.image as usize][ray.feature as usize]).collect();
            // Of a point with a ray that does not belong to it the truth is not one place.
            let Some(owner) = owners[0].filter(|_| owners.iter().all(|owner| *owner == owners[0])) else { continue };
            let told = statistics.errors.unwrap();
            let wanted = scene.block.ground[owner as usize];
            squares[1].extend((0..3).map(|i| ((point[i] - wanted[i]) / told[i]).powi(2)));
        }
    }
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let [positions, points] = squares.map(|values| mean(&values));
    let variance = mean(&variances);
    println!("positions {positions:.3}, points {points:.3}, variance of a coordinate {variance:.3}");
    assert!([positions, points, variance].iter().all(|v| about_one(0.1).contains(v)), "{positions} {points} {variance}");
}

#[test]
fn geographic_positions_and_control_put_a_block_onto_the_earth() {
    let mut scene = scene(&BlockFlight::default(), 1.0);
    let origin = [8.0, 50.0, 200.0];
    for (image, exposure) in scene.description.images.iter_mut().zip(&scene.block.exposures) {
        let [longitude_deg, latitude_deg, height_m] = geographic_from_local(exposure.centre, origin);
        image.position =
            Some(ObservedPosition::Geographic { longitude_deg, latitude_deg, height_m: Some(height_m), sigma_m: [3.0, 3.0, 5.0] });
    }
    // A surveyed point is measured wherever it was found.
    let target = (0..scene.points.len()).find(|point| scene.points.rays(*point).len() >= 6).unwrap();
    let rays = scene.points.rays(target);
    let owner = scene.block.owners[rays[0].image as usize][rays[0].feature as usize].unwrap();
    let [longitude_deg, latitude_deg, height_m] = geographic_from_local(scene.block.ground[owner as usize], origin);
    let ray = |ray: &tiepoint::FeatureObservation| {
        let [x, y] = scene.block.features[ray.image as usize][ray.feature as usize];
        ImageObservation { image: ray.image as usize, x_px: f64::from(x), y_px: f64::from(y), confidence: 1.0 }
    };
    let control = GroundControlPoint {
        name: "church".into(),
        role: ControlRole::Control,
        sigma_px: None,
        position: ObservedPosition::Geographic { longitude_deg, latitude_deg, height_m: Some(height_m), sigma_m: [0.02; 3] },
        measurements: rays.iter().map(ray).collect(),
    };
    scene.description.control.push(control);
    let reconstruction = scene.reconstruct(&selected());
    scene.report("on the earth", &reconstruction);
    assert_whole(&scene, &reconstruction, 1.5);
    let model = &reconstruction.models[0];
    assert!(model.in_system && model.adjusted.datum == Datum::GnssAndControl);
    assert_eq!(model.points.last(), Some(&PointSource::GroundControl(0)));
    // The model's place of an image on the earth is that of the exposure.
    let from = reconstruction.origin.unwrap();
    let from = [from.longitude_deg, from.latitude_deg, from.height_m];
    for (k, image) in model.images.iter().zip(&model.adjusted.block.images) {
        let at = local_from_geographic(geographic_from_local(image.pose.position, from), origin);
        let off = (0..3).map(|i| (at[i] - scene.block.exposures[*k].centre[i]).powi(2)).sum::<f64>().sqrt();
        assert!(off < 4.0, "image {k} is off by {off} m");
    }
    let exported = reconstruction.block_model(0, &scene.description, &scene.points).unwrap();
    exported.check().unwrap();
    assert_eq!((exported.images.len(), exported.origin), (30, reconstruction.origin));
    let accepted = model.adjusted.rays.iter().filter(|ray| ray.verdict == ObservationVerdict::Accepted).count();
    assert_eq!(exported.points.iter().map(|point| point.rays.len()).sum::<usize>(), accepted);
    // There and back: alone, the chosen points adjust to somewhat smaller residuals than with those that determined the block, too.
    let again = adjust_block(&Block::of_model(&exported).unwrap(), &AdjustmentOptions::default()).unwrap();
    let smaller = model.adjusted.rmse_px - again.rmse_px;
    assert!((0.0..0.1 * model.adjusted.rmse_px).contains(&smaller), "{} {}", again.rmse_px, model.adjusted.rmse_px);
    assert!(model.adjusted.degrees_of_freedom > 2 * again.degrees_of_freedom);
}

#[test]
fn positions_of_a_strip_that_are_off_are_told_from_the_others() {
    let mut scene = scene(&BlockFlight { strips: 4, ..BlockFlight::default() }, 1.0);
    let mut normal = Normal(7);
    for (index, (image, exposure)) in scene.description.images.iter_mut().zip(&scene.block.exposures).enumerate() {
        // Heights as of no plane: the roll of parallel strips is one of heights.
        let off = if index / 6 == 1 { [6.0, -5.0, 8.0] } else { [0.0; 3] };
        let position = [0, 1, 2].map(|k| exposure.centre[k] + off[k] + 0.1 * normal.next());
        image.position = Some(ObservedPosition::Local { position, sigma: [0.1; 3] });
    }
    let adjustment = AdjustmentOptions { gnss_errors: GnssErrors::StripOffsets, ..selected().adjustment };
    let reconstruction = scene.reconstruct(&ReconstructionOptions { adjustment, ..selected() });
    scene.report("a strip off", &reconstruction);
    let model = &reconstruction.models[0];
    let systematic = model.adjusted.systematic.as_ref().unwrap();
    assert_eq!(systematic.strips.iter().map(|strip| strip.images.len()).collect::<Vec<_>>(), [6; 4]);
    assert!(model.adjusted.images.iter().all(|image| image.gnss.is_some_and(|gnss| gnss.accepted)), "{:?}", model.warnings);
    let x = |strip: usize| systematic.errors[strip].estimate[0];
    assert!((x(1) - 0.5 * (x(0) + x(2)) - 6.0).abs() < 0.5, "{systematic:?}");
    let relative = |warning: &BlockWarning| matches!(warning, BlockWarning::PositionErrorsRelative { motions } if *motions >= 3);
    assert!(model.warnings.iter().any(relative), "{:?}", model.warnings);
    let text = serde_json::to_string(&reconstruction).unwrap();
    assert_eq!(serde_json::from_str::<Reconstruction>(&text).unwrap(), reconstruction);
}

#[test]
fn the_same_rays_give_the_same_block() {
    let scene = scene(&BlockFlight { strips: 3, exposures: 4, wrong: 0.2, ..BlockFlight::default() }, 1.02);
    let first = scene.reconstruct(&selected());
    assert_eq!(first, scene.reconstruct(&selected()));
    let text = serde_json::to_string(&first).unwrap();
    assert_eq!(serde_json::from_str::<Reconstruction>(&text).unwrap(), first);
}

#[test]
fn what_does_not_fit_together_is_refused() {
    let scene = scene(&BlockFlight { strips: 2, exposures: 3, ..BlockFlight::default() }, 1.0);
    let refused = |change: &dyn Fn(&mut BlockDescription, &mut ReconstructionOptions), words: &str| {
        let (mut description, mut options) = (scene.description.clone(), selected());
        change(&mut description, &mut options);
        let error = reconstruct_block(&description, &scene.points, &scene.block.image_features(), &options).unwrap_err();
        assert!(error.to_string().contains(words), "{error}");
    };
    let local = |z: f64| Some(ObservedPosition::Local { position: [0.0, 0.0, z], sigma: [1.0; 3] });
    let geographic = ObservedPosition::Geographic { longitude_deg: 8.0, latitude_deg: 50.0, height_m: Some(0.0), sigma_m: [1.0; 3] };
    refused(&|d, _| d.images[2].camera = 1, "index 1 for 'photo_00002'");
    refused(&|d, _| d.cameras[0].focal_px = Some(f64::NAN), "focal length of a camera: got NaN");
    refused(&|d, _| d.cameras[0].focal_px = Some(0.0), "focal length of a camera: got 0");
    refused(&|d, _| d.cameras[0].radial[1] = f64::INFINITY, "distortion");
    refused(&|d, _| d.cameras[0].free.radial = 4, "radial");
    refused(&|d, _| d.images[0].position = local(f64::NAN), "position: got NaN");
    refused(&|d, _| (d.images[0].position, d.images[1].position) = (local(1.0), Some(geographic)), "1 geographic and 1 local");
    refused(&|d, _| d.images.truncate(1), "at least 2");
    refused(&|d, _| d.images.truncate(5), "features of 6 images");
    refused(&|_, o| o.least_angle_deg = f64::NAN, "reconstruction.least_angle_deg is NaN");
    refused(&|_, o| o.least_rays = 2, "reconstruction.least_rays is 2");
    refused(&|_, o| o.adjustment.alpha0 = 2.0, "adjustment.alpha0");
    refused(&|_, o| o.datum = Some(Datum::Gnss), "GNSS positions or control points");
    let ray = ImageObservation { image: 9, x_px: 1.0, y_px: 1.0, confidence: 1.0 };
    let control = GroundControlPoint {
        name: "a".into(),
        role: ControlRole::Control,
        sigma_px: None,
        position: local(0.0).unwrap(),
        measurements: vec![ray],
    };
    refused(&|d, _| d.control.push(control.clone()), "index 9 as image of GCP a");
    for (x_px, y_px) in [(-500.0, 99_999.0), (-0.5, 10.0), (10.0, 3000.5), (f64::NAN, 10.0)] {
        let ray = ImageObservation { image: 1, x_px, y_px, confidence: 1.0 };
        let got = format!("got ({x_px}, {y_px}) for a in photo_00001, outside the image; allowed: positions within its 4000 x 3000 px");
        refused(&|d, _| d.control.push(GroundControlPoint { measurements: vec![ray], ..control.clone() }), &got);
    }
    let ray = ImageObservation { image: 1, x_px: 4000.0, y_px: 0.0, confidence: 1.0 };
    refused(&|d, _| d.control.push(GroundControlPoint { measurements: vec![ray; 2], ..control.clone() }), "two for a in photo_00001");
    let earth = GroundControlPoint { position: geographic, measurements: Vec::new(), ..control.clone() };
    refused(&|d, _| (d.images[0].position, d.control) = (local(1.0), vec![earth.clone(); 2]), "2 geographic and 1 local");
}

#[test]
fn a_block_without_points_has_no_model() {
    let scene = scene(&BlockFlight { strips: 2, exposures: 2, ..BlockFlight::default() }, 1.0);
    let none = TiePoints::default();
    let reconstruction = reconstruct_block(&scene.description, &none, &scene.block.image_features(), &selected()).unwrap();
    assert!(reconstruction.models.is_empty());
    assert!(
        reconstruction.unoriented.len() == 4 && reconstruction.unoriented.iter().all(|image| image.reason == UnorientedReason::NoPoints)
    );
}
