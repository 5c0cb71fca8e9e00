//! Pairs whose cameras stand in their files.

use tiepoint::{
    Camera, CameraCaution, CameraMm, CameraOrigin, CameraUncertainty, ExifCamera, Flight, GreyImage, NoOrientation, PairImage, PairInput,
    PairResult, PairSettings, Side, Strategy, Warning, match_pair, simulate,
};

/// A pair of grey planes, of which no strategy finds anything.
fn result(camera: &ExifCamera, input: &PairInput, strategy: Strategy) -> PairResult {
    let grey = GreyImage::new(200, 150, vec![99; 200 * 150]).unwrap();
    result_of([&grey, &grey], camera, input, strategy)
}

fn result_of(images: [&GreyImage; 2], camera: &ExifCamera, input: &PairInput, strategy: Strategy) -> PairResult {
    let images = images.map(|grey| PairImage { grey: grey.view(), exif: Some(camera), mask: None });
    let mut settings = PairSettings::default();
    settings.matching.strategy = strategy;
    match_pair(images[0], images[1], input, &settings).unwrap()
}

fn file_camera(origin: CameraOrigin) -> ExifCamera {
    ExifCamera { focal_mm: 0.2, pixel_mm: Some(0.001), origin, ..ExifCamera::default() }
}

#[test]
fn a_panorama_is_not_oriented_unless_its_camera_is_given() {
    let camera = file_camera(CameraOrigin::Panorama);
    for strategy in [Strategy::Moments, Strategy::Gradient] {
        let found = result(&camera, &PairInput::default(), strategy);
        assert_eq!(found.orientation.unwrap_err(), NoOrientation::Panorama { side: Side::Left });
        assert!(found.interior.is_none());
    }
    let input = PairInput { camera: Some(CameraMm::without_distortion(0.2, Some(0.001))), ..PairInput::default() };
    assert!(result(&camera, &input, Strategy::Moments).interior.is_some());
}

#[test]
fn a_cropped_photo_counts_as_one_of_an_unknown_camera() {
    let [taken_width_px, taken_height_px, width_px, height_px] = [4000, 3000, 200, 150];
    let cropped = CameraCaution::Cropped { taken_width_px, taken_height_px, width_px, height_px };
    let camera = ExifCamera { pixel_mm: None, cautions: vec![cropped.clone()], ..file_camera(CameraOrigin::FocalLengthAlone) };
    // What is missing of a camera is said where there are matches that it would orient.
    let photos = simulate(&Flight { width_px: 200, height_px: 220, ..Flight::default() }).unwrap();
    let reason_of = |camera: &ExifCamera| {
        result_of([&photos.left, &photos.right], camera, &PairInput::default(), Strategy::Moments).orientation.unwrap_err()
    };
    let reason = reason_of(&camera);
    assert!(reason.to_string().contains("taken with 4000 x 3000 px, but the file has 200 x 150 px: it was cropped"), "{reason}");
    assert_eq!(reason, NoOrientation::Altered { side: Side::Left, camera_caution: cropped });
    // Of a camera that no table lists, resized or not, the size of a pixel is what is missing.
    let resized = CameraCaution::Resized { taken_width_px, taken_height_px, width_px, height_px };
    for cautions in [vec![], vec![resized]] {
        let unlisted = ExifCamera { cautions, ..camera.clone() };
        assert_eq!(reason_of(&unlisted), NoOrientation::NoPixelSize { side: Side::Left });
    }
}

#[test]
fn a_photo_of_fewer_pixels_than_it_was_taken_with_may_be_resized_or_cropped() {
    let camera = |taken_width_px, taken_height_px| {
        let cautions = vec![CameraCaution::Resized { taken_width_px, taken_height_px, width_px: 200, height_px: 150 }];
        ExifCamera { cautions, ..file_camera(CameraOrigin::ExifFocalPlane) }
    };
    let interior = |camera: &ExifCamera, input: &PairInput| result(camera, input, Strategy::Moments).interior.unwrap();
    // 4/3 of the side: the focal length is 200 px, or 267 px and the principal point up to 33 px off the middle.
    let found = interior(&camera(267, 200), &PairInput::default());
    let known = found.left.uncertainty.unwrap();
    assert!((0.2..0.25).contains(&known.focal) && (0.09..0.11).contains(&known.principal_point), "{known:?}");
    let (taken_width_px, taken_height_px, width_px, height_px) = (267, 200, 200, 150);
    let doubt = Warning::ResizedOrCropped { side: Side::Left, taken_width_px, taken_height_px, width_px, height_px };
    assert!(found.doubt == Some(doubt) && doubt.is_weakness(), "{:?}", found.doubt);
    // A photo that was enlarged is whole; a camera that is given is that of the file as it is.
    let given = PairInput { camera: Some(CameraMm::without_distortion(0.2, Some(0.001))), ..PairInput::default() };
    for sound in [
        interior(&camera(100, 75), &PairInput::default()),
        interior(&camera(201, 151), &PairInput::default()),
        interior(&camera(267, 200), &given),
    ] {
        assert!(sound.doubt.is_none() && sound.left.uncertainty.unwrap().principal_point <= 0.01, "{sound:?}");
    }
}

#[test]
fn the_lens_of_a_file_is_the_interior_orientation_with_what_its_origin_is_worth() {
    let lens = Camera {
        principal_point_px: [103.0, 74.0],
        radial: [-0.2, 0.05, 0.0],
        pixel_mm: Some(0.001),
        ..Camera::without_distortion(200, 150, 210.0)
    };
    let camera = ExifCamera { focal_mm: 0.21, lens: Some(Box::new(lens)), ..file_camera(CameraOrigin::XmpCalibration) };
    let interior = result(&camera, &PairInput::default(), Strategy::Moments).interior.unwrap();
    assert_eq!(interior.left.uncertainty, Some(CameraUncertainty::XMP_CALIBRATION));
    let ([x, y], [u, v]) = (interior.left.photo_mm(20.0, 20.0), lens.direction([20.0, 20.0]).unwrap());
    assert!((x / interior.focal_mm - u).abs() < 1e-4 && (y / interior.focal_mm + v).abs() < 1e-4, "{x} {y} {u} {v}");
    for origin in [CameraOrigin::Exif35Mm, CameraOrigin::SensorTable] {
        let interior = result(&file_camera(origin), &PairInput::default(), Strategy::Moments).interior.unwrap();
        assert_eq!(interior.left.uncertainty, Some(CameraUncertainty::EXIF));
    }
}
