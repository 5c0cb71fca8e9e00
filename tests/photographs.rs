//! The whole pipeline on photographs beside the project; skipped where they are absent.

use nalgebra::{Matrix3, Vector3};
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use tiepoint::{
    CameraMm, DecodeLimits, Decoded, Degeneracy, Error, Fiducial, FiducialModel, MatchOptions, NoOrientation, Operator, PairImage,
    PairInput, PairResult, PairSettings, PointOptions, RelativeOrientation, Strategy, Warning, decode, match_pair, orient_fiducials,
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
