//! The whole pipeline on photographs beside the project; skipped where they are absent.

use image::ImageEncoder;
use nalgebra::{Matrix3, Vector3};
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use tiepoint::{
    CameraCaution, CameraMm, CameraOrigin, DecodeLimits, Decoded, Degeneracy, Error, ExifCamera, Fiducial, FiducialModel, GreyImage,
    MatchOptions, NoOrientation, OneImage, Operator, PairImage, PairInput, PairResult, PairSettings, PairVerdict, PointOptions,
    RelativeOrientation, Strategy, Warning, decode, match_pair, orient_fiducials,
};

fn folder(name: &str) -> Option<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/data").join(name);
    if !folder.is_dir() {
        println!("skipped: {} is absent", folder.display());
    }
    folder.is_dir().then_some(folder)
}

fn image(folder: &Path, name: &str) -> Decoded {
    decode(&fs::read(folder.join(name)).unwrap(), &DecodeLimits::default()).unwrap()
}

fn truth(folder: &Path) -> Value {
    serde_json::from_str(&fs::read_to_string(folder.join("truth.json")).unwrap()).unwrap()
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect()
}

fn run(left: &Decoded, right: &Decoded, input: &PairInput, points: PointOptions) -> Result<PairResult, Error> {
    let image = |decoded: &'_ Decoded| decoded.camera.clone();
    let (left_exif, right_exif) = (image(left), image(right));
    let pair =
        [(left, &left_exif), (right, &right_exif)].map(|(d, exif)| PairImage { grey: d.grey.view(), exif: exif.as_ref(), mask: None });
    match_pair(pair[0], pair[1], input, &PairSettings { points, ..PairSettings::default() })
}

/// Angles in degrees between the found rotation and base direction and those of `X_right = R X_left + t` with x right, y down, z forward.
fn errors_deg(found: &RelativeOrientation, rotation: &Value, translation: &Value) -> [f64; 2] {
    let (m, base) = found.pose();
    // From photo axes (x right, y up, z backward) to those of the truth.
    let flip = Matrix3::from_diagonal(&Vector3::new(1.0, -1.0, -1.0));
    let (found_rotation, found_translation) = (flip * m * flip, -(flip * m * base).normalize());
    let rows: Vec<f64> = rotation.as_array().unwrap().iter().flat_map(numbers).collect();
    let wanted = Matrix3::from_row_slice(&rows);
    let direction = Vector3::from_vec(numbers(translation)).normalize();
    let cosine = ((wanted.transpose() * found_rotation).trace() - 1.0) / 2.0;
    [cosine, direction.dot(&found_translation)].map(|c| c.clamp(-1.0, 1.0).acos().to_degrees())
}

#[test]
fn a_rendered_stereo_pair_is_oriented_as_it_was_rendered() {
    let Some(folder) = folder("semisynth_exact_caliterra") else { return };
    let truth = truth(&folder);
    let k = numbers(&truth["images"][0]["K"]);
    // Any pixel size will do: the focal length is in its unit. The truth's pixels count from the centre of the first.
    let pixel = 0.005;
    let principal_point_mm = [(k[2] + 0.5 - 500.0) * pixel, (375.0 - (k[3] + 0.5)) * pixel];
    let camera = CameraMm { principal_point_mm, ..CameraMm::without_distortion(k[0] * pixel, Some(pixel)) };
    let input = PairInput { camera: Some(camera), ..PairInput::default() };
    let (left, right) = (image(&folder, "v1.png"), image(&folder, "v2.png"));
    let result = run(&left, &right, &input, PointOptions { fraction: Some(0.148), ..PointOptions::default() }).unwrap();
    assert!(result.matching.matches.len() > 1000, "{:?}", result.matching.counts);
    let errors = errors_deg(&result.orientation.unwrap(), &truth["pairs"][0]["R"], &truth["pairs"][0]["t"]);
    assert!(errors[0] < 0.3 && errors[1] < 0.5, "{errors:?} deg");
}

#[test]
fn a_drone_pair_of_12_mp_is_oriented_with_nothing_given() {
    let Some(folder) = folder("pair_full_caliterra") else { return };
    let (left, right) = (image(&folder, "IMG_9401.jpg"), image(&folder, "IMG_9402.jpg"));
    let result = run(&left, &right, &PairInput::default(), PointOptions::default()).unwrap();
    assert!(result.matching.matches.len() > 1000, "{:?}", result.matching.counts);
    let truth = truth(&folder);
    let errors = errors_deg(&result.orientation.unwrap(), &truth["pairs"][0]["R"], &truth["pairs"][0]["t"]);
    // The reference is good to about 1 deg in rotation and 3 deg in direction, the EXIF focal length to 4 %.
    assert!(errors[0] < 1.5 && errors[1] < 4.0, "{errors:?} deg");
}

#[test]
fn a_camera_that_only_turned_is_flagged() {
    let Some(folder) = folder("degenerate_rotation_arches") else { return };
    let (left, right) = (image(&folder, "JDW_9518.jpg"), image(&folder, "JDW_9519.jpg"));
    let camera = CameraMm::without_distortion(30.0, Some(0.025));
    let input = PairInput { camera: Some(camera), ..PairInput::default() };
    for strategy in [Strategy::Moments, Strategy::Correlation, Strategy::LeastSquares] {
        let mut settings = PairSettings::default();
        settings.matching = MatchOptions { strategy, search: 61, ..settings.matching };
        let [one, two] = [&left, &right].map(|decoded| PairImage { grey: decoded.grey.view(), exif: None, mask: None });
        let result = match_pair(one, two, &input, &settings).unwrap();
        assert!(result.matching.matches.len() > 300);
        match result.orientation {
            Ok(o) => assert!(
                o.warnings.iter().any(|w| matches!(w, Warning::Rotation { .. })),
                "{strategy:?}: {} mm",
                o.parallax_beside_rotation_mm
            ),
            Err(reason) => assert!(reason.to_string().contains("rotation"), "{reason}"),
        }
    }
}

#[test]
fn images_of_16_bits_give_points_and_matches() {
    let Some(folder) = folder("tiff16_multispectral_garfield") else { return };
    let (left, right) = (image(&folder, "IMG_161122_163239_0001_GRE.TIF"), image(&folder, "IMG_161122_164150_0091_GRE_deflate.tif"));
    assert_eq!((left.bits_per_sample, right.bits_per_sample), (16, 16));
    let itself = run(&left, &left, &PairInput { offset: Some([0.0, 0.0]), ..PairInput::default() }, PointOptions::default()).unwrap();
    assert!(itself.left.points.len() > 1000);
    assert!(itself.matching.matches.iter().all(|m| m.right == Some(m.left) && m.measure == 0.0));
    // Without parallax there is nothing to orient, and that is said.
    let reason = itself.orientation.unwrap_err().to_string();
    assert!(reason.contains("one photo twice"), "{reason}");
    // Turned by 27 deg against each other, which is beyond this strategy: it must end well all the same.
    assert!(run(&left, &right, &PairInput::default(), PointOptions::default()).is_ok());
}

#[test]
fn scanned_frames_are_oriented_by_their_fiducials() {
    let Some(folder) = folder("film_fiducials_canberra") else { return };
    let truth = truth(&folder);
    let mut oriented = 0;
    for photo in truth["images"].as_array().unwrap() {
        // The marks of a frame of 9 x 9 inches lie near ±106 mm; no calibration is known.
        let place =
            |corner: &str| [if corner.ends_with('L') { -106.0 } else { 106.0 }, if corner.starts_with('T') { 106.0 } else { -106.0 }];
        let marks: Vec<Fiducial> = (photo["fiducials_px"].as_array().unwrap().iter())
            .map(|mark| {
                let [x_mm, y_mm] = place(mark["corner"].as_str().unwrap());
                Fiducial { col: mark["x"].as_f64().unwrap() + 0.5, row: mark["y"].as_f64().unwrap() + 0.5, x_mm, y_mm }
            })
            .collect();
        if marks.len() < 4 {
            assert!(matches!(orient_fiducials(&marks, FiducialModel::Affine), Err(Error::TooFew { .. })));
            continue;
        }
        for model in [FiducialModel::Affine, FiducialModel::Similarity] {
            let found = orient_fiducials(&marks, model).unwrap();
            let [[a, b, _], [d, e, _]] = found.parameters;
            let pixel_mm = (a * e - b * d).abs().sqrt();
            assert!((pixel_mm - 0.127).abs() < 0.003, "{pixel_mm} mm");
            // Measured to 1.5 px.
            assert!(found.sigma0_mm.unwrap() < 3.0 * pixel_mm, "{:?}", found.sigma0_mm);
        }
        oriented += 1;
    }
    assert!(oriented >= 2);
}

#[test]
fn low_relief_without_a_camera_is_a_plane_and_no_rotation() {
    for (name, photos, expected) in [
        ("simulated-a", ["left.png", "right.png"], Degeneracy::Plane),
        ("degenerate_rotation_arches", ["JDW_9518.jpg", "JDW_9519.jpg"], Degeneracy::PureRotation),
    ] {
        let Some(folder) = folder(name) else { continue };
        let [left, right] = photos.map(|photo| image(&folder, photo));
        // Without cameras multi-scale points find a plane over the arches, which explains them as well.
        let mut settings = PairSettings::default();
        (settings.points.operator, settings.matching.strategy) = (Some(Operator::Ground2), Strategy::Gradient);
        let pair = [&left, &right].map(|d| PairImage { grey: d.grey.view(), exif: None, mask: None });
        let result = match_pair(pair[0], pair[1], &PairInput::default(), &settings).unwrap();
        assert_eq!(result.geometry.unwrap().unwrap().degenerate, Some(expected), "{name}");
        // Two photographs are neither one twice nor parts of one.
        let is_one = matches!(result.orientation, Err(NoOrientation::OnePhoto | NoOrientation::PartsOfOneImage));
        assert!(!is_one, "{name}: {:?}", result.orientation);
    }
}

/// Part of an image, from a column and row on.
fn part(image: &GreyImage, [col0, row0]: [usize; 2], [width, height]: [usize; 2]) -> GreyImage {
    let view = image.view();
    GreyImage::from_fn(width, height, |col, row| view.at(col + col0, row + row0)).unwrap()
}

/// Positions of the matches by gradients of two images of which nothing else is known.
fn positions(left: &GreyImage, right: &GreyImage) -> Vec<[f64; 4]> {
    let mut settings = PairSettings::default();
    settings.matching.strategy = Strategy::Gradient;
    let [left, right] = [left, right].map(|grey| PairImage { grey: grey.view(), exif: None, mask: None });
    let matches = match_pair(left, right, &PairInput::default(), &settings).unwrap().matching.matches;
    matches.iter().map(|m| [m.left_px[0], m.left_px[1], m.right_px[0], m.right_px[1]]).collect()
}

/// Of windows of 100 to 600 px cut out of the right image with a hundred matches and more: how many are called parts of the left one, and how many
/// there are.
fn called_parts(matches: &[[f64; 4]], left: (usize, usize), right: (usize, usize)) -> [usize; 2] {
    let mut state = 1_u64;
    let mut below = |most: usize| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % most
    };
    let (mut called, mut all) = (0, 0);
    for _ in 0..300 {
        let (width, height) = (100 + below(500), 100 + below(500));
        let (x0, y0) = (below(right.0 - width) as f64, below(right.1 - height) as f64);
        let inside = |m: &&[f64; 4]| (x0..x0 + width as f64).contains(&m[2]) && (y0..y0 + height as f64).contains(&m[3]);
        let own: Vec<[f64; 4]> = matches.iter().filter(inside).map(|[x, y, u, v]| [*x, *y, u - x0, v - y0]).collect();
        if own.len() >= 100 {
            called += usize::from(OneImage::of(&own, [left, (width, height)]).is_some());
            all += 1;
        }
    }
    [called, all]
}

#[test]
fn windows_of_other_photographs_are_hardly_called_parts_and_windows_of_copies_are() {
    let Some(folder) = folder("block_caliterra") else { return };
    let [first, second] = ["IMG_9404.jpg", "IMG_9405.jpg"].map(|name| image(&folder, name).grey);
    let size = (first.width(), first.height());
    let matches = positions(&first, &second);
    assert_eq!(OneImage::of(&matches, [size; 2]), None);
    let [called, all] = called_parts(&matches, size, size);
    println!("photographs: {called} of {all} windows are called parts, {} matches", matches.len());
    assert!(all > 50 && 100 * called <= 4 * all, "{called} of {all}");
    let mut file = Vec::new();
    let encoder = image::codecs::jpeg::JpegEncoder::new_with_quality(&mut file, 50);
    encoder.write_image(second.data(), size.0 as u32, size.1 as u32, image::ExtendedColorType::L8).unwrap();
    let copy = decode(&file, &DecodeLimits::default()).unwrap().grey;
    let [called, all] = called_parts(&positions(&second, &copy), size, size);
    println!("copies: {called} of {all} windows are called parts");
    assert!(all > 50 && 100 * called >= 90 * all, "{called} of {all}");
}

#[test]
fn photographs_cropped_to_another_format_are_weak_and_their_intervals_hold() {
    let Some(folder) = folder("truth_terrestrial_fountain") else { return };
    let truth = truth(&folder);
    let pair = truth["pairs"].as_array().unwrap().iter().find(|pair| pair["a"] == "0004.jpg" && pair["b"] == "0005.jpg").unwrap();
    let [left, right] = ["0004.jpg", "0005.jpg"].map(|name| image(&folder, name).grey);
    for ([at_left, at_right], [width, height]) in [([[400, 80], [300, 40]], [1000, 900]), ([[0, 0], [500, 100]], [900, 900])] {
        let cropped = [part(&left, at_left, [width, height]), part(&right, at_right, [width, height])];
        let [width_px, height_px] = [width as u32, height as u32];
        let caution = CameraCaution::Cropped { taken_width_px: 1536, taken_height_px: 1024, width_px, height_px };
        let camera =
            ExifCamera { focal_mm: 20.0, origin: CameraOrigin::FocalLengthAlone, cautions: vec![caution], ..ExifCamera::default() };
        let images = cropped.each_ref().map(|grey| PairImage { grey: grey.view(), exif: Some(&camera), mask: None });
        let result = match_pair(images[0], images[1], &PairInput::default(), &PairSettings::default()).unwrap();
        let verdict = result.verdict();
        assert!(matches!(verdict, PairVerdict::Weak { warning: Warning::Cropped { .. }, .. }), "{verdict}");
        let interior = result.interior.unwrap();
        let found = result.orientation.unwrap();
        let half = found.half_widths_95.unwrap();
        let rotation_deg = half.omega_deg.hypot(half.phi_deg).hypot(half.kappa_deg);
        let base_deg = half.by_mm.hypot(half.bz_mm).atan2(found.base_mm.abs()).to_degrees();
        let errors = errors_deg(&found, &pair["R"], &pair["t"]);
        for camera in found.cameras.unwrap() {
            let [focal_px, error_px] = [camera.focal_mm, camera.focal_standard_error_mm].map(|v| v / interior.left.pixel_mm());
            println!("{width} x {height} px: focal length {focal_px:.0} ± {error_px:.0} px, true 1381");
            assert!((focal_px - 1381.0).abs() < 2.5 * error_px, "{focal_px} ± {error_px} px");
        }
        println!("rotation off by {:.2} of ± {rotation_deg:.2} deg, base by {:.2} of ± {base_deg:.2} deg", errors[0], errors[1]);
        // An interval of the base as wide as that says that its direction, and its sense, are not known. A rotation that is uncertain by as much as
        // rays of the two photographs differ in direction changes the sign of all parallaxes: then the sense alone is not known.
        let line_deg = errors[1].min(180.0 - errors[1]);
        assert!(errors[0] < 1.3 * rotation_deg && (line_deg < 1.3 * base_deg || base_deg > 60.0), "{errors:?} deg");
    }
}
