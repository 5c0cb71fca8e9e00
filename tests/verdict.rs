//! What a pair is worth, as it is told to whoever sets nothing.

use super::known::{self, input};
use std::sync::OnceLock;
use tiepoint::{
    CameraMm, Error, GreyImage, KnownWorst, Match, NoOrientation, PairImage, PairInput, PairInterior, PairResult, PairSettings,
    PairVerdict, PhotoDifference, Refusal, SAMPLE_SEED, Side, Strategy, Warning, judged, match_pair, sample_pair,
};

fn matched(left: &GreyImage, right: &GreyImage, mask: Option<&GreyImage>, input: &PairInput) -> PairResult {
    matched_by([left, right], mask, input, &PairSettings::default())
}

fn matched_by([left, right]: [&GreyImage; 2], mask: Option<&GreyImage>, input: &PairInput, settings: &PairSettings) -> PairResult {
    let image = |grey, mask| PairImage { grey, exif: None, mask };
    match_pair(image(left.view(), mask.map(GreyImage::view)), image(right.view(), None), input, settings).unwrap()
}

/// What nothing that is set makes of the sample.
fn found() -> &'static PairResult {
    static FOUND: OnceLock<PairResult> = OnceLock::new();
    let sample = known::sample();
    FOUND.get_or_init(|| matched(&sample.left, &sample.right, None, &input(sample)))
}

#[test]
fn a_good_pair_is_oriented_with_nothing_set() {
    let sample = known::sample();
    let result = found();
    let PairVerdict::Oriented { points, sigma0_px: Some(sigma0_px), kappa_deg, half_width_deg, worst, worst_half_width_deg, .. } =
        result.verdict()
    else {
        panic!("{}", result.verdict())
    };
    assert_eq!(points, result.matching.matches.len() - result.orientation.as_ref().unwrap().rejected.len());
    assert!(sigma0_px < 0.15 && (kappa_deg - sample.truth.kappa_deg).abs() < half_width_deg && half_width_deg < 0.022);
    assert!(result.verdict().to_string().starts_with(&format!("Oriented from {points} points, σ0 0.")), "{}", result.verdict());
    // Over flat ground κ is known best.
    let half = result.orientation.as_ref().unwrap().half_widths_95.unwrap();
    assert!(worst != KnownWorst::Kappa && worst_half_width_deg >= half.omega_deg.max(half.phi_deg) && half_width_deg == half.kappa_deg);
    assert!(result.verdict().to_string().contains("to ± "), "{}", result.verdict());
}

#[test]
fn errors_that_correlated_matches_share_are_not_taken_for_a_wrong_focal_length() {
    let mut settings = PairSettings::default();
    settings.matching.strategy = Strategy::Correlation;
    for seed in [SAMPLE_SEED, SAMPLE_SEED + 1] {
        let sample = sample_pair(seed).unwrap();
        let mut given = input(&sample);
        let verdict = |given: &PairInput| matched_by([&sample.left, &sample.right], None, given, &settings).verdict();
        assert!(matches!(verdict(&given), PairVerdict::Oriented { .. }), "{seed}: {}", verdict(&given));
        // One that is half as long again is heard, and what it differs by is possible.
        given.camera = given.camera.map(|camera| CameraMm { focal_mm: 1.5 * camera.focal_mm, ..camera });
        let PairVerdict::Weak { warning: Warning::FocalLength { change_percent, .. }, .. } = verdict(&given) else { panic!("{seed}") };
        assert!((-90.0..-20.0).contains(&change_percent), "{change_percent}");
    }
}

#[test]
fn matches_of_few_places_are_weak() {
    let sample = known::sample();
    let (width, height) = (sample.left.width(), sample.left.height());
    let middle = |k: usize| (k % width).abs_diff(width / 2) < 70 && (k / width).abs_diff(height / 2) < 70;
    let mask = GreyImage::new(width, height, (0..width * height).map(|k| if middle(k) { 255 } else { 0 }).collect()).unwrap();
    let result = matched(&sample.left, &sample.right, Some(&mask), &input(sample));
    let warnings = &result.orientation.as_ref().unwrap().warnings;
    assert!(warnings.iter().any(|w| matches!(w, Warning::FewPlaces { places, least: 16 } if *places < 16)), "{warnings:?}");
    let PairVerdict::Weak { warning, .. } = result.verdict() else { panic!("{}", result.verdict()) };
    assert_eq!(Some(&warning), warnings.iter().find(|w| w.is_weakness()));
}

#[test]
fn photos_of_different_towns_and_one_photo_twice_are_not_oriented() {
    let (one, other) = (known::sample(), sample_pair(SAMPLE_SEED + 1).unwrap());
    for right in [&other.right, &one.left] {
        let result = matched(&one.left, right, None, &input(one));
        assert!(matches!(result.verdict(), PairVerdict::NotOriented { .. }), "{}", result.verdict());
        assert!(result.verdict().to_string().starts_with("Not oriented: "), "{}", result.verdict());
    }
}

#[test]
fn where_hardly_anything_matches_the_missing_camera_is_not_the_reason() {
    let sample = known::sample();
    let level = GreyImage::from_fn(sample.right.width(), sample.right.height(), |_, _| 128).unwrap();
    let mut settings = PairSettings::default();
    settings.matching.strategy = Strategy::Moments;
    for given in [PairInput::default(), input(sample)] {
        let result = matched_by([&sample.left, &level], None, &given, &settings);
        assert_eq!(result.orientation, Err(NoOrientation::TooFewMatches { matches: 0, needed: 5 }));
    }
    let [four, five] = [4, 5].map(NoOrientation::of_few);
    assert_eq!(
        four.unwrap().to_string(),
        "only 4 matches were found, and an orientation takes at least 5 (do both photos show the same ground?)"
    );
    assert_eq!(five, None);
}

#[test]
fn matches_of_a_similarity_make_an_orientation_weak() {
    let result = found().clone();
    // As if the photos were digital ones.
    let (orientation, interior) = (result.orientation.unwrap(), PairInterior { are_scans: false, ..result.interior.unwrap() });
    // The same left positions with what a shift makes of them, whatever the orientation came of.
    let mut shifted = result.matching.matches.clone();
    for (k, m) in shifted.iter_mut().enumerate() {
        let error = |k: usize| 0.2 * ((k * 7919 % 1000) as f64 / 500.0 - 1.0);
        m.right_px = [m.left_px[0] - 40.0 + error(k), m.left_px[1] + 3.0 + error(3 * k + 1)];
    }
    let verdict = |matches: &[Match], interior: &PairInterior| {
        let points = Some([result.left.points.len(), result.right.points.len()]);
        PairVerdict::of(&judged(orientation.clone(), matches, interior, points), interior.left.pixel_mm())
    };
    assert!(matches!(verdict(&result.matching.matches, &interior), PairVerdict::Oriented { .. }));
    assert!(matches!(verdict(&shifted, &interior), PairVerdict::Weak { warning: Warning::SimilarityAlone, .. }));
    // Scans whose fiducial marks were measured are two photographs.
    let scans = PairInterior { are_scans: true, ..interior };
    assert!(!matches!(verdict(&shifted, &scans), PairVerdict::Weak { warning: Warning::SimilarityAlone, .. }));
}

#[test]
fn a_doubted_camera_makes_a_good_pair_weak() {
    let result = found().clone();
    let (orientation, interior) = (result.orientation.unwrap(), result.interior.unwrap());
    let points = Some([result.left.points.len(), result.right.points.len()]);
    let doubt = Warning::ContradictedFocal { side: Side::Right, given_px: 604.0, file_px: 1208.0 };
    let verdict = |doubt: Option<Warning>| {
        let interior = PairInterior { doubt, ..interior };
        let found = judged(orientation.clone(), &result.matching.matches, &interior, points);
        PairVerdict::of(&found, interior.left.pixel_mm())
    };
    assert!(matches!(verdict(None), PairVerdict::Oriented { .. }), "{}", verdict(None));
    assert!(matches!(verdict(Some(doubt)), PairVerdict::Weak { warning, .. } if warning == doubt), "{}", verdict(Some(doubt)));
}

/// A photo of a facade of equal windows, every other row of which stands out by some px; `view` gives where it lies on the facade. Windows
/// differ by some grey values: those of another seed are of another facade.
fn facade(seed: u32, variation: f64, parallax_px: f64, view: impl Fn([f64; 2]) -> [f64; 2]) -> GreyImage {
    let random = |a: i64, b: i64, seed: u32| {
        let mixed = (a as u32).wrapping_mul(2_654_435_761) ^ (b as u32).wrapping_mul(2_246_822_519) ^ seed.wrapping_mul(3_266_489_917);
        let mixed = (mixed ^ (mixed >> 15)).wrapping_mul(2_654_435_761);
        f64::from((mixed ^ (mixed >> 13)) & 0xffff) / 65_535.0 - 0.5
    };
    GreyImage::from_fn(640, 480, |col, row| {
        let [u, v] = view([col as f64 + 0.5, row as f64 + 0.5]);
        let j = (v / 48.0).floor();
        let u = if j as i64 % 2 == 0 { u + parallax_px } else { u };
        let i = (u / 40.0).floor();
        let (a, b) = (u - 40.0 * i, v - 48.0 * j);
        let cell = variation * random(i as i64, j as i64, seed);
        let is_window = (9.0..31.0).contains(&a) && (10.0..38.0).contains(&b);
        let is_frame = is_window && ((a - 20.0).abs() > 8.5 || (b - 24.0).abs() > 11.5 || (a - 20.0).abs() < 1.2);
        let is_sill = (38.0..42.0).contains(&b) && (6.0..34.0).contains(&a);
        let grey = match (is_frame, is_window, is_sill) {
            (true, ..) => 205.0,
            (_, true, _) => 60.0 + cell,
            (.., true) => 90.0,
            _ => 150.0 + 0.3 * cell,
        };
        (grey + 6.0 * random(col as i64, row as i64, seed + 77)).clamp(0.0, 255.0) as u8
    })
    .unwrap()
}

#[test]
fn equal_facades_that_face_each_other_are_not_oriented() {
    let camera = CameraMm::without_distortion(6.0, Some(0.01));
    let input = PairInput { camera: Some(camera), ..PairInput::default() };
    let (mut most, mut all) = (0, 0);
    for (k, variation) in [0.0, 8.0, 25.0].into_iter().enumerate() {
        let seed = 10 * k as u32;
        let left = facade(seed + 1, variation, 0.0, |[x, y]| [x + 0.02 * y, y - 0.01 * x + 500.0]);
        // Shifted by periods along another facade, and seen in perspective from the other side.
        let shifted = facade(seed + 2, variation, 5.0, |[x, y]| [x + 120.0 + 13.0, y + 500.0 + 96.0]);
        let opposite = facade(seed + 3, variation, 6.0, |[x, y]| {
            let depth = 1.0 + 2.5e-4 * (x - 320.0);
            [320.0 + (x - 320.0) / depth, 740.0 + (y - 240.0) / depth]
        });
        for right in [&shifted, &opposite] {
            let result = matched(&left, right, None, &input);
            assert!(!matches!(result.verdict(), PairVerdict::Oriented { .. }), "variation {variation}: {}", result.verdict());
            println!("{variation}: {} matches, {}", result.matching.matches.len(), result.verdict());
            most = most.max(result.matching.verdicts.iter().filter(|v| v.best.is_some()).count());
            all += 1;
        }
    }
    assert!(all == 6 && most > 200, "no facade resembles the other: the test shows nothing");
}

#[test]
fn a_mirrored_photo_is_not_oriented() {
    let sample = known::sample();
    let (view, width, height) = (sample.right.view(), sample.right.width(), sample.right.height());
    let columns = GreyImage::from_fn(width, height, |col, row| view.at(width - 1 - col, row)).unwrap();
    let rows = GreyImage::from_fn(width, height, |col, row| view.at(col, height - 1 - row)).unwrap();
    for right in [columns, rows] {
        let result = matched(&sample.left, &right, None, &input(sample));
        assert!(!matches!(result.verdict(), PairVerdict::Oriented { .. }), "{}", result.verdict());
    }
}

#[test]
fn marks_that_were_exchanged_are_refused_with_their_sigma0() {
    let sample = known::sample();
    let mut exchanged = input(sample);
    let marks = &mut exchanged.right.fiducials;
    let [first, second] = [0, 1].map(|k| (marks[k].col, marks[k].row));
    (marks[0].col, marks[0].row) = second;
    (marks[1].col, marks[1].row) = first;
    let [left, right] = [&sample.left, &sample.right].map(|grey| PairImage { grey: grey.view(), exif: None, mask: None });
    let refused = match_pair(left, right, &exchanged, &PairSettings::default()).unwrap_err();
    let Error::InvalidInput { refusal: Refusal::MarksSigma0 { sigma0_mm, most_mm } } = refused else { panic!("{refused}") };
    assert!(sigma0_mm > 10.0 && most_mm == 1.0, "{refused}");
}

#[test]
fn no_camera_is_assumed_in_place_of_one_that_is_given() {
    let sample = known::sample();
    let given = |focal_mm| PairInput { camera: Some(CameraMm::without_distortion(focal_mm, None)), ..PairInput::default() };
    let result = matched(&sample.left, &sample.right, None, &given(30.0));
    assert!(matches!(result.geometry, Some(Ok(_))) && result.interior.is_none());
    assert_eq!(result.orientation.unwrap_err(), NoOrientation::NoPixelSize { side: Side::Left });
    let [left, right] = [&sample.left, &sample.right].map(|grey| PairImage { grey: grey.view(), exif: None, mask: None });
    let refused = match_pair(left, right, &given(-1.0), &PairSettings::default()).unwrap_err();
    assert!(matches!(refused, Error::InvalidOption { .. }), "{refused}");
}

#[test]
fn without_a_camera_a_pair_is_oriented_only_where_it_determines_the_focal_length() {
    let sample = known::sample();
    // What is known of the camera is a guess; the photos are nearly vertical over a flat town, which leaves it open.
    let guess = tiepoint::CameraUncertainty::ASSUMED;
    let mut assumed = input(sample);
    assumed.camera = assumed.camera.map(|camera| CameraMm { uncertainty: Some(guess), ..camera });
    let result = matched(&sample.left, &sample.right, None, &assumed);
    let orientation = result.orientation.as_ref().unwrap();
    let error = orientation.cameras.unwrap().map(|camera| camera.focal_standard_error_mm / camera.focal_mm);
    let is_unknown = orientation.warnings.contains(&Warning::UnknownCamera);
    assert!(error[0] > 0.02 && is_unknown, "{error:?}, {:?}", orientation.warnings);
    // The same orientation, of cameras that it determined.
    let mut determined = orientation.clone();
    determined.warnings.clear();
    for camera in determined.cameras.iter_mut().flatten() {
        camera.focal_standard_error_mm = 0.01 * camera.focal_mm;
    }
    let points = Some([result.left.points.len(), result.right.points.len()]);
    let found = judged(determined, &result.matching.matches, result.interior.as_ref().unwrap(), points);
    assert!(!found.warnings.contains(&Warning::UnknownCamera), "{:?}", found.warnings);
}

#[test]
fn how_photos_lie_to_each_other_is_found_however_they_are_turned() {
    let sample = known::sample();
    let (right, [width, height]) = (sample.right.view(), [sample.right.width(), sample.right.height()]);
    let upright = PhotoDifference::between(sample.left.view(), right).unwrap().unwrap();
    assert!((upright.turn_deg - sample.truth.kappa_deg).abs() < 1.0 && (upright.scale - 1.0).abs() < 0.03, "{upright:?}");
    let [dx, dy] = found_by_correlation();
    assert!((upright.offset_px[0] - dx).abs() < 8.0 && (upright.offset_px[1] - dy).abs() < 8.0, "{upright:?}, {dx}, {dy}");
    // A quarter turn clockwise on the screen.
    let quarter = GreyImage::from_fn(height, width, |col, row| right.at(row, height - 1 - col)).unwrap();
    let turned = PhotoDifference::between(sample.left.view(), quarter.view()).unwrap().unwrap();
    assert!((turned.turn_deg - upright.turn_deg - 90.0).abs() < 0.5, "{turned:?}");
    let level = GreyImage::from_fn(width, height, |_, _| 128).unwrap();
    assert_eq!(PhotoDifference::between(sample.left.view(), level.view()), Ok(None));
}

/// The offset of the sample as it is estimated where it is needed.
fn found_by_correlation() -> [f64; 2] {
    let sample = known::sample();
    tiepoint::estimate_offset(sample.left.view(), sample.right.view()).median_px
}
