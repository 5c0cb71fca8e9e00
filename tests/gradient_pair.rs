//! Photos of any rotation and direction of flight, matched by gradients with and without a known camera.

use super::known::{self, input};
use image::ImageEncoder;
use tiepoint::{
    CameraMm, DecodeLimits, Degeneracy, Expectation, FeatureMatchOptions, Flight, GreyImage, Located, NoOrientation, OffsetField, Operator,
    PairImage, PairInput, PairResult, PairSettings, PairVerdict, PointOptions, Refinement, Rule, SAMPLE_SEED, Strategy, decode,
    describe_image, match_features, match_in_rounds, match_pair, nearest_of, sample_pair, simulate,
};

/// The image as it is read again from a JPEG of this quality.
fn saved_again(image: &GreyImage, quality: u8) -> GreyImage {
    let mut file = Vec::new();
    let (width, height) = (image.width() as u32, image.height() as u32);
    let encoder = image::codecs::jpeg::JpegEncoder::new_with_quality(&mut file, quality);
    encoder.write_image(image.data(), width, height, image::ExtendedColorType::L8).unwrap();
    decode(&file, &DecodeLimits::default()).unwrap().grey
}

/// Each pixel the mean of four.
fn halved(image: &GreyImage) -> GreyImage {
    let view = image.view();
    let sum = |col: usize, row: usize| (0..4).map(|k| u16::from(view.at(2 * col + k % 2, 2 * row + k / 2))).sum::<u16>();
    GreyImage::from_fn(image.width() / 2, image.height() / 2, |col, row| (sum(col, row) / 4) as u8).unwrap()
}

/// The image without a margin of a tenth to the left and above.
fn cropped(image: &GreyImage) -> GreyImage {
    let (view, col0, row0) = (image.view(), image.width() / 10, image.height() / 10);
    GreyImage::from_fn(image.width() - col0, image.height() - row0, |col, row| view.at(col + col0, row + row0)).unwrap()
}

/// The image turned by a quarter clockwise.
fn turned(image: &GreyImage) -> GreyImage {
    let (view, height) = (image.view(), image.height());
    GreyImage::from_fn(height, image.width(), |col, row| view.at(row, height - 1 - col)).unwrap()
}

fn settings() -> PairSettings {
    let mut settings = PairSettings::default();
    settings.points.operator = Some(Operator::Multiscale);
    settings.matching.strategy = Strategy::Gradient;
    settings
}

fn matched(left: &GreyImage, right: &GreyImage, input: &PairInput, settings: &PairSettings) -> PairResult {
    let [left, right] = [left, right].map(|image| PairImage { grey: image.view(), exif: None, mask: None });
    match_pair(left, right, input, settings).unwrap()
}

#[test]
fn a_quarter_turn_of_one_photo_changes_little() {
    let sample = known::sample();
    let plain = matched(&sample.left, &sample.right, &PairInput::default(), &settings());
    let other = matched(&sample.left, &turned(&sample.right), &PairInput::default(), &settings());
    let count = |result: &PairResult| result.matching.matches.len();
    assert!(count(&plain) > 2000 && count(&other) > 4 * count(&plain) / 5, "{} and {} matches", count(&plain), count(&other));
    // Back in the first photo's axes the matches lie where they lay.
    let height = sample.right.height() as f64;
    let (mut found, mut same) = (0, 0);
    for m in &other.matching.matches {
        let [x, y] = [m.right_px[1], height - m.right_px[0]];
        let near = |n: &&tiepoint::Match| (n.left_px[0] - m.left_px[0]).abs() < 0.3 && (n.left_px[1] - m.left_px[1]).abs() < 0.3;
        let Some(n) = plain.matching.matches.iter().find(near) else { continue };
        found += 1;
        same += usize::from((n.right_px[0] - x).abs() < 1.0 && (n.right_px[1] - y).abs() < 1.0);
    }
    assert!(10 * found > 7 * count(&other) && 100 * same > 97 * found, "{same} of {found} of {}", count(&other));
}

#[test]
fn a_base_along_y_is_oriented_in_turned_axes() {
    let sample = known::sample();
    let along_x = matched(&sample.left, &sample.right, &input(sample), &settings());
    // Both photos turned: marks and origins with them. A clockwise quarter turn takes (col, row) to (height - row, col).
    let mut across = input(sample);
    for (photo, image) in [(&mut across.left, &sample.left), (&mut across.right, &sample.right)] {
        let [col, row] = photo.origin.unwrap();
        let height = image.height() as f64 + row;
        photo.fiducials.iter_mut().for_each(|mark| {
            (mark.col, mark.row) = (height - mark.row, mark.col);
            (mark.x_mm, mark.y_mm) = (mark.y_mm, -mark.x_mm);
        });
        photo.origin = Some([0.0, col]);
    }
    let along_y = matched(&turned(&sample.left), &turned(&sample.right), &across, &settings());
    let (a, b) = (along_x.orientation.unwrap(), along_y.orientation.unwrap());
    assert_eq!((a.turn_deg, b.turn_deg), (0.0, 90.0));
    // The turned axes are those of the photos before they were turned, or the opposite ones.
    let direction = b.base_mm.signum() * a.base_mm.signum();
    let (p, q) = (a.parameters, b.parameters);
    let differences = [p.omega_deg - direction * q.omega_deg, p.phi_deg - direction * q.phi_deg, p.kappa_deg - q.kappa_deg];
    assert!(differences.iter().all(|d| d.abs() < 0.03), "{p:?} {q:?}");
    let scale = a.base_mm / b.base_mm;
    assert!((p.by_mm - scale * q.by_mm).abs() < 0.1 && (p.bz_mm - direction * scale * q.bz_mm).abs() < 0.1, "{p:?} {q:?}");
}

#[test]
fn one_photo_is_named_however_it_was_saved() {
    let photo = &known::sample().left;
    let (one, parts) = (NoOrientation::OnePhoto, NoOrientation::PartsOfOneImage);
    for (name, right, expected) in [
        ("compressed", saved_again(photo, 30), &one),
        ("halved", saved_again(&halved(photo), 90), &one),
        ("turned", saved_again(&turned(photo), 75), &one),
        ("cropped", saved_again(&cropped(photo), 85), &parts),
    ] {
        let result = matched(photo, &right, &PairInput::default(), &settings());
        assert_eq!(result.orientation.as_ref().err(), Some(expected), "{name}: {}", result.verdict());
    }
}

#[test]
fn level_photos_of_flat_ground_are_not_called_parts_of_one_image() {
    let level = Flight {
        omega_deg: 0.0,
        phi_deg: 0.0,
        kappa_deg: 0.0,
        by_mm: 0.0,
        bz_mm: 0.0,
        left_omega_deg: 0.0,
        left_phi_deg: 0.0,
        left_kappa_deg: 0.0,
        relief_m: 0.0,
        buildings: 0,
        trees: 0,
        ..Flight::default()
    };
    let sample = simulate(&level).unwrap();
    // The simulated patches show the same ground: what is left of them is what overlaps of two photos.
    let width = sample.left.width();
    let (left, right) = (columns(&sample.left, 100, width), columns(&sample.right, 0, width - 100));
    let camera = CameraMm::without_distortion(150.0, Some(0.25));
    for camera in [None, Some(camera)] {
        let result = matched(&left, &right, &PairInput { camera, ..PairInput::default() }, &settings());
        assert!(result.matching.matches.len() > 100, "{:?}", result.matching.counts);
        assert!(!matches!(result.orientation, Err(NoOrientation::OnePhoto | NoOrientation::PartsOfOneImage)), "{}", result.verdict());
        assert!(!matches!(result.verdict(), PairVerdict::Oriented { .. }), "{}", result.verdict());
    }
}

#[test]
fn every_operator_can_be_described_by_gradients() {
    let sample = known::sample();
    for operator in [Operator::Ground2, Operator::Forstner] {
        let mut settings = settings();
        settings.points = PointOptions { operator: Some(operator), ..PointOptions::default() };
        let result = matched(&sample.left, &sample.right, &input(sample), &settings);
        assert_eq!(result.left.frames.len(), result.left.points.len());
        assert!(result.matching.matches.len() > 500 && result.orientation.is_ok(), "{operator:?}: {:?}", result.matching.counts);
    }
}

#[test]
fn an_image_and_itself_differ_by_a_rotation_alone() {
    let sample = known::sample();
    let camera = CameraMm::without_distortion(150.0, Some(0.1));
    let result = matched(&sample.left, &turned(&sample.left), &PairInput { camera: Some(camera), ..PairInput::default() }, &settings());
    let geometry = result.geometry.unwrap().unwrap();
    assert_eq!(geometry.degenerate, Some(Degeneracy::PureRotation));
    assert!(result.orientation.unwrap_err() == NoOrientation::OnePhoto);
    assert!(result.matching.matches.len() > 3000);
}

#[test]
fn different_grounds_are_not_matched_and_the_reason_is_reported() {
    let (one, other) = (known::sample(), sample_pair(SAMPLE_SEED + 1).unwrap());
    let result = matched(&one.left, &other.right, &input(one), &settings());
    assert!(result.matching.matches.is_empty());
    assert!(result.geometry.unwrap().unwrap_err().to_string().contains("by chance"));
    assert!(result.orientation.is_err());
    assert!(result.matching.verdicts.iter().any(|v| v.rule == Rule::Parallax));
}

#[test]
fn points_under_a_mask_are_left_out() {
    let sample = known::sample();
    let half = GreyImage::from_fn(sample.left.width(), sample.left.height(), |col, _| if col < sample.left.width() / 2 { 0 } else { 255 })
        .unwrap();
    let small = GreyImage::from_fn(20, 20, |_, _| 255).unwrap();
    for operator in [Operator::Multiscale, Operator::Ground2] {
        let mut settings = settings();
        settings.points.operator = Some(operator);
        let left = PairImage { grey: sample.left.view(), exif: None, mask: Some(half.view()) };
        let right = PairImage { grey: sample.right.view(), exif: None, mask: None };
        let result = match_pair(left, right, &PairInput::default(), &settings).unwrap();
        assert!(result.left.points.len() > 500);
        assert!(result.left.points.iter().all(|p| p.x >= (sample.left.width() / 2) as f64));
        let wrong = PairImage { mask: Some(small.view()), ..right };
        assert!(matches!(
            match_pair(left, wrong, &PairInput::default(), &settings),
            Err(tiepoint::Error::InvalidInput { refusal: tiepoint::Refusal::MaskSize { .. } })
        ));
    }
}

#[test]
fn refinement_follows_a_quarter_turn() {
    let sample = known::sample();
    let mut settings = settings();
    settings.matching.refine = Some(Refinement::LeastSquares);
    let result = matched(&sample.left, &turned(&sample.right), &PairInput::default(), &settings);
    assert!(result.matching.matches.len() > 1000, "{:?}", result.matching.counts);
    assert!(result.matching.matches.iter().all(|m| m.fit.is_some_and(|fit| fit.correlation > 0.7)));
}

#[test]
fn nearest_neighbours_found_in_pieces_give_the_same_matches() {
    let sample = known::sample();
    let mut settings = settings();
    settings.multiscale.number = 1500;
    let [left, right] = [&sample.left, &sample.right].map(|image| describe_image(image.view(), None, &settings).unwrap());
    let images = [left.match_image(sample.left.view(), Strategy::Gradient), right.match_image(sample.right.view(), Strategy::Gradient)];
    let offset = OffsetField::constant(0.0, 0.0);
    let whole = match_in_rounds(images, &offset, None, &settings).unwrap();
    let rows = left.set.points.len();
    let mut table = nearest_of(&left.gradients, 0..700, &right.gradients).unwrap();
    let some = Expectation { nearest: Some(&table), ..Expectation::from(&offset) };
    assert!(matches!(
        match_in_rounds(images, some, None, &settings),
        Err(tiepoint::Error::InvalidInput { refusal: tiepoint::Refusal::NeighboursOfOthers { .. } })
    ));
    table.join(nearest_of(&left.gradients, 700..rows, &right.gradients).unwrap()).unwrap();
    let all = Expectation { nearest: Some(&table), ..Expectation::from(&offset) };
    assert_eq!(match_in_rounds(images, all, None, &settings).unwrap(), whole);
}

/// The columns of an image from `first` to before `end`.
fn columns(image: &GreyImage, first: usize, end: usize) -> GreyImage {
    let view = image.view();
    GreyImage::from_fn(end - first, image.height(), |col, row| view.at(col + first, row)).unwrap()
}

/// The image in a dark border with fiducial marks and a data strip, on a scan that begins `shift` px further left and up.
fn framed(image: &GreyImage, shift: [usize; 2]) -> GreyImage {
    let (width, height) = (image.width(), image.height());
    let border = 90;
    let view = image.view();
    GreyImage::from_fn(width + 2 * border + shift[0], height + 2 * border + shift[1], |col, row| {
        let (u, v) = (col as i64 - shift[0] as i64, row as i64 - shift[1] as i64);
        let (x, y) = (u - border as i64, v - border as i64);
        if (0..width as i64).contains(&x) && (0..height as i64).contains(&y) {
            return view.at(x as usize, y as usize);
        }
        // Signs of a strip on the left, ticks all around: of different shapes, the same on every frame.
        let cell = |k: i64| (k / 9).wrapping_mul(2_654_435_761) ^ ((k / 9) >> 3);
        let sign = (cell(u) ^ cell(v).wrapping_mul(40_503)) >> 7 & 7;
        let on_margin = u > 20 && v > 20 && (u < 60 || v < 60 || u > width as i64 + 120 || v > height as i64 + 120);
        if on_margin && sign == 0 { 220 } else { 12 }
    })
    .unwrap()
}

#[test]
fn film_borders_do_not_match() {
    let sample = known::sample();
    // The ground moves by 100 px from one frame to the other.
    let width = sample.left.width();
    let pictures = [columns(&sample.left, 100, width), columns(&sample.right, 0, width - 100)];
    let [left, right] = [framed(&pictures[0], [0, 0]), framed(&pictures[1], [23, 11])];
    let mut settings = settings();
    let count = |result: &PairResult| {
        // Both lie equally on their frames.
        let on_frame =
            |m: &&tiepoint::Match| (m.right_px[0] - m.left_px[0] - 23.0).abs() < 3.0 && (m.right_px[1] - m.left_px[1] - 11.0).abs() < 3.0;
        (result.matching.matches.iter().filter(on_frame).count(), result.matching.matches.len())
    };
    let without = matched(&left, &right, &PairInput::default(), &settings);
    settings.matching.without_frame = false;
    let with = matched(&left, &right, &PairInput::default(), &settings);
    let (frame, all) = count(&without);
    assert!(without.matching.counts.frame > 20 && frame <= all / 200, "{frame} of {all}; {:?}", without.matching.counts);
    assert_eq!(with.matching.counts.frame, 0);
    let verified = matched(&pictures[0], &pictures[1], &PairInput::default(), &settings).matching.matches.len();
    assert!(10 * all > 7 * verified, "{all} of {verified}");
}

#[test]
fn images_of_a_block_say_that_they_have_a_frame_in_common() {
    let sample = sample_pair(SAMPLE_SEED).unwrap();
    let width = sample.left.width();
    let pictures = [columns(&sample.left, 100, width), columns(&sample.right, 0, width - 100)];
    let has_frame = |images: &[GreyImage; 2]| {
        let settings = settings().resolved();
        let described = images.each_ref().map(|image| describe_image(image.view(), None, &settings).unwrap());
        let positions = described.each_ref().map(|image| image.set.points.iter().map(|p| [p.x, p.y]).collect::<Vec<_>>());
        let located = |side: usize| Located { positions: &positions[side], descriptors: &described[side].gradients };
        let sizes = Some(images.each_ref().map(|image| [image.width(), image.height()]));
        match_features(located(0), located(1), &FeatureMatchOptions { sizes, ..FeatureMatchOptions::default() }).unwrap().has_frame
    };
    assert!(has_frame(&[framed(&pictures[0], [0, 0]), framed(&pictures[1], [23, 11])]));
    assert!(!has_frame(&pictures));
}

#[test]
fn an_upside_down_pair_is_not_oriented_by_wrong_matches_of_moments() {
    let sample = known::sample();
    let right = turned(&turned(&sample.right));
    let mut by_moments = PairSettings::default();
    by_moments.matching.strategy = Strategy::Moments;
    let result = matched(&sample.left, &right, &input(sample), &by_moments);
    assert!(result.matching.matches.len() > 20, "no wrong matches: the test shows nothing");
    let reason = result.orientation.unwrap_err().to_string();
    assert!(reason.contains("σ0 is") && reason.contains("the matches are wrong"), "{reason}");
}

#[test]
fn a_strip_of_few_rows_is_not_taken_for_a_film_border() {
    // Grey values of a lattice, between its points by their distance.
    let lattice =
        |x: usize, y: usize| f64::from((x as u32).wrapping_mul(2_654_435_761).wrapping_add((y as u32).wrapping_mul(40_503_241)) >> 9 & 255);
    let smooth = |x: usize, y: usize, side: usize| {
        let (col, row, u, v) = (x / side, y / side, (x % side) as f64 / side as f64, (y % side) as f64 / side as f64);
        let along = |row: usize| lattice((col * 7919) ^ row, row) * (1.0 - u) + lattice(((col + 1) * 7919) ^ row, row) * u;
        along(row) * (1.0 - v) + along(row + 1) * v
    };
    let strip =
        |from: usize| GreyImage::from_fn(40_000, 60, |x, y| (0.6 * smooth(x + from, y, 5) + 0.4 * smooth(x + from, y, 13)) as u8).unwrap();
    let result = matched(&strip(0), &strip(20), &PairInput::default(), &settings());
    let matches = &result.matching.matches;
    assert!(matches.len() > 300, "{:?}, {:?}", result.matching.counts, result.geometry.map(|found| found.map(|found| found.inliers.len())));
    assert!(matches.iter().all(|m| (m.left_px[0] - m.right_px[0] - 20.0).abs() < 1.0 && (m.left_px[1] - m.right_px[1]).abs() < 1.0));
}
