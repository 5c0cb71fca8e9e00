//! Cameras that are not known without error: the errors of an orientation by their total standard errors, over many cameras.

use super::scene::{Dice, FOCAL_MM, NADIR};
use tiepoint::{CameraMm, CameraUncertainty, Interior, Match, OrientationOptions, PairInterior, orient_matches};

const SIZE_PX: usize = 2000;
const PIXEL_MM: f64 = 0.12;
const SETS: usize = 100;

/// What a camera of this interior orientation shows at a photo coordinate, which is free of distortion.
fn px(interior: &Interior, [x, y]: [f64; 2]) -> [f64; 2] {
    let pixel = interior.pixel_mm();
    let [x0, y0] = interior.principal_point_px();
    interior.image_px(x0 + x / pixel, y0 - y / pixel).unwrap()
}

#[test]
fn total_standard_errors_hold_what_exif_does_not_tell() {
    check(CameraUncertainty::EXIF, 0.4, 20.0);
}

#[test]
fn total_standard_errors_hold_what_a_camera_is_off_that_is_given() {
    check(CameraUncertainty::GIVEN, 0.4, 5.0);
}

#[test]
fn total_standard_errors_hold_what_the_pair_does_not_tell_of_an_unknown_camera() {
    check(CameraUncertainty { focal: 0.15, ..CameraUncertainty::ASSUMED }, 0.4, 20.0);
}

/// Total standard errors of ω φ κ where the right image is stored as it was taken, turned by 90°, or of half the size.
fn errors_deg(uncertainty: CameraUncertainty, stored: Stored) -> [f64; 3] {
    let (width, height) = (SIZE_PX, SIZE_PX - 200);
    let side = |width: usize, height: usize, pixel_mm: f64| {
        let camera = CameraMm { uncertainty: Some(uncertainty), ..CameraMm::without_distortion(FOCAL_MM, Some(pixel_mm)) };
        Interior::from_pixel_size(&camera, width, height).unwrap()
    };
    let left = side(width, height, PIXEL_MM);
    let right = match stored {
        Stored::AsTaken => left,
        Stored::Turned => side(height, width, PIXEL_MM),
        Stored::Halved => side(width / 2, height / 2, 2.0 * PIXEL_MM),
    };
    let seen = NADIR.observe(600, 0.02, 80_000);
    let one = |(index, [xl, yl], [xr, yr]): (usize, [f64; 2], [f64; 2])| {
        let right_mm = if stored == Stored::Turned { [yr, -xr] } else { [xr, yr] };
        Match { left: index, right: None, left_px: px(&left, [xl, yl]), right_px: px(&right, right_mm), measure: 0.0, fit: None }
    };
    let matches: Vec<Match> = seen.iter().enumerate().map(|(k, o)| one((k, o.left, o.right))).collect();
    let interior = PairInterior { left, right, focal_mm: FOCAL_MM, doubt: None, one_lens: stored != Stored::AsTaken, are_scans: false };
    let options = OrientationOptions { base_mm: Some(92.0), ..OrientationOptions::default() };
    let found = orient_matches(&matches, &interior, &options).unwrap();
    let [one, other] = found.cameras.unwrap().map(|camera| camera.focal_mm);
    assert!((one / other - 1.0).abs() < 1e-3, "{one} {other}");
    let standard = found.total_standard_errors.unwrap();
    [standard.omega_deg, standard.phi_deg, standard.kappa_deg]
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Stored {
    AsTaken,
    Turned,
    Halved,
}

#[test]
fn photos_of_one_lens_share_its_focal_length_however_they_are_stored() {
    for uncertainty in [CameraUncertainty::EXIF, CameraUncertainty { focal: 0.15, ..CameraUncertainty::ASSUMED }] {
        let as_taken = errors_deg(uncertainty, Stored::AsTaken);
        for stored in [Stored::Turned, Stored::Halved] {
            let found = errors_deg(uncertainty, stored);
            // Their principal points are apart, of 1 % of the focal length each: 0.6° and 0.8° together.
            let allowed = |k: usize| 2.0 * as_taken[k] + 1.0;
            assert!((0..3).all(|k| found[k] < allowed(k)), "{stored:?}: {found:?}, as taken {as_taken:?}");
        }
    }
}

/// `least`: the least variance of error over standard error of an unknown of the pose; `beside`: what one exceeds where the camera is taken to be known.
fn check(uncertainty: CameraUncertainty, least: f64, beside: f64) {
    let nominal = CameraMm::without_distortion(FOCAL_MM, Some(PIXEL_MM));
    let (mut with, mut without) = ([0.0; 5], [0.0; 5]);
    let mut focal = 0.0;
    for set in 0..SETS as u64 {
        let mut dice = Dice::new(70_000 + set);
        let focal_mm = FOCAL_MM * (uncertainty.focal * dice.normal()).exp();
        let true_camera = CameraMm {
            principal_point_mm: [0, 1].map(|_| uncertainty.principal_point * focal_mm * dice.normal()),
            radial_distortion: [uncertainty.k1 * dice.normal() / (focal_mm * focal_mm), 0.0, 0.0],
            tangential_distortion: [0, 1].map(|_| uncertainty.decentring() * dice.normal() / focal_mm),
            ..CameraMm::without_distortion(focal_mm, Some(PIXEL_MM))
        };
        let seen_by = Interior::from_pixel_size(&true_camera, SIZE_PX, SIZE_PX).unwrap();
        let known = |camera: &CameraMm| {
            let side = Interior::from_pixel_size(camera, SIZE_PX, SIZE_PX).unwrap();
            PairInterior { left: side, right: side, focal_mm: FOCAL_MM, doubt: None, one_lens: false, are_scans: false }
        };
        let scale = focal_mm / FOCAL_MM;
        let seen = NADIR.observe(600, 0.02, 80_000 + set);
        let matches: Vec<Match> = seen
            .iter()
            .enumerate()
            .map(|(left, o)| Match {
                left,
                right: None,
                left_px: px(&seen_by, o.left.map(|v| v * scale)),
                right_px: px(&seen_by, o.right.map(|v| v * scale)),
                measure: 0.0,
                fit: None,
            })
            .collect();
        let options = OrientationOptions { base_mm: Some(92.0), ..OrientationOptions::default() };
        let uncalibrated = orient_matches(&matches, &known(&CameraMm { uncertainty: Some(uncertainty), ..nominal }), &options).unwrap();
        let exact = CameraMm { uncertainty: Some(CameraUncertainty::NONE), ..nominal };
        let as_if_calibrated = orient_matches(&matches, &known(&exact), &options).unwrap();
        for (sums, found) in [(&mut with, &uncalibrated), (&mut without, &as_if_calibrated)] {
            let standard = found.total_standard_errors.unwrap();
            let standard = [standard.omega_deg, standard.phi_deg, standard.kappa_deg, standard.by_mm, standard.bz_mm];
            let errors = NADIR.errors(found);
            sums.iter_mut().zip(errors).zip(standard).for_each(|((sum, error), s)| *sum += (error / s) * (error / s) / SETS as f64);
        }
        let [camera, _] = uncalibrated.cameras.unwrap();
        assert!(as_if_calibrated.cameras.is_none());
        let error = (camera.focal_mm - focal_mm) / camera.focal_standard_error_mm;
        focal += error * error / SETS as f64;
    }
    println!(
        "variance of error / total standard error over {SETS} cameras: {with:.2?}, as if calibrated {without:.1?}, focal length {focal:.2}"
    );
    assert!(with.iter().all(|v| (least..1.7).contains(v)), "{with:?}");
    assert!((0.4..1.7).contains(&focal), "{focal}");
    assert!(without.iter().any(|v| *v > beside), "{without:?}");
}
