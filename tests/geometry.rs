//! The geometry of two views against scenes whose truth is known.

#[path = "geometry/scene.rs"]
mod scene;

use super::sampling::runs;
use nalgebra::{Matrix3, Vector3};
use scene::{CONVERGENT, FLAT, FOCAL, RELIEF, SIZE, Scene, TOWN, TURNED, cameras};
use tiepoint::{
    Degeneracy, Error, Guide, GuidedOptions, Located, Pinhole, Refusal, TwoView, TwoViewModel, TwoViewOptions, fundamental_eight_point,
    fundamental_seven_point, guided_matches, homography_direct, two_view,
};

const SIGMA_PX: f64 = 0.5;

/// Checks that the good matches are found, few others, and σ; the wrong matches come first.
fn check_matches(what: &str, found: &TwoView, count: usize, wrong: f64) {
    let first_good = (wrong * count as f64) as usize;
    let bad = found.inliers.iter().filter(|k| **k < first_good).count();
    let good = found.inliers.len() - bad;
    assert!(good * 100 >= (count - first_good) * 97, "{what}: {good} of {} found", count - first_good);
    assert!(bad * 50 <= found.inliers.len() + 50, "{what}: {bad} wrong ones among {}", found.inliers.len());
    assert!((found.sigma_px / SIGMA_PX - 1.0).abs() < 0.25, "{what}: σ {}", found.sigma_px);
    assert!(found.threshold_px >= 2.0 * found.sigma_px - 1e-9 && found.threshold_px <= 4.0, "{what}: {}", found.threshold_px);
    assert!(found.inliers.is_sorted());
}

fn pose_errors(scene: &Scene, found: &TwoView) -> [f64; 2] {
    match &found.model {
        TwoViewModel::Calibrated { rotation, base, .. } => scene.errors(rotation, base),
        other => panic!("no relative orientation: {other:?}"),
    }
}

/// The largest distance of true matches from the epipolar lines of a matrix.
fn worst_distance(scene: &Scene, fundamental: &[[f64; 3]; 3]) -> f64 {
    let matrix = Matrix3::from_fn(|i, j| fundamental[i][j]);
    let distance = |[x, y, u, v]: &[f64; 4]| {
        let line = matrix * Vector3::new(*x, *y, 1.0);
        line.dot(&Vector3::new(*u, *v, 1.0)).abs() / (line.x * line.x + line.y * line.y).sqrt()
    };
    scene.matches(300, 0.0, 0.0, 99).iter().map(distance).fold(0.0, f64::max)
}

#[test]
fn calibrated_views_are_oriented_among_wrong_matches() {
    for (name, scene, degenerate) in
        [("relief", RELIEF, None), ("town", TOWN, None), ("convergent", CONVERGENT, None), ("flat", FLAT, Some(Degeneracy::Plane))]
    {
        for (count, wrong) in [(2000, 0.0), (2000, 0.6), (2000, 0.75), (200, 0.5)] {
            let what = format!("{name} {count} {wrong}");
            let found = two_view(&scene.matches(count, SIGMA_PX, wrong, 5), &cameras(Some(FOCAL))).unwrap();
            check_matches(&what, &found, count, wrong);
            assert_eq!(found.degenerate, degenerate, "{what}");
            assert_eq!(found.homography.is_some(), degenerate.is_some(), "{what}");
            let [rotation, base] = pose_errors(&scene, &found);
            assert!(rotation < 0.003 && base < 0.01, "{what}: {rotation} {base}");
        }
    }
}

#[test]
fn pure_rotation_is_flagged() {
    for wrong in [0.0, 0.6] {
        for (focal, options) in [(true, cameras(Some(FOCAL))), (false, cameras(None))] {
            let found = two_view(&TURNED.matches(1000, SIGMA_PX, wrong, 6), &options).unwrap();
            check_matches("turned", &found, 1000, wrong);
            assert_eq!(found.degenerate, Some(Degeneracy::PureRotation));
            let TwoViewModel::Rotation { rotation, homography } = &found.model else { panic!("{:?}", found.model) };
            assert!(TURNED.errors(rotation, &[1.0, 0.0, 0.0])[0] < 1e-3 && found.homography == Some(*homography));
            let estimate =
                found.focal.map(|f| (f.focal_px - FOCAL).abs() < 3.0 * f.standard_error_px && f.standard_error_px < 0.05 * FOCAL);
            assert_eq!(estimate, (!focal).then_some(true), "{:?}", found.focal);
        }
    }
}

#[test]
fn pure_rotation_is_flagged_where_the_focal_length_is_a_little_off() {
    for factor in [0.94, 1.04] {
        let found = two_view(&TURNED.matches(1000, SIGMA_PX, 0.3, 6), &cameras(Some(factor * FOCAL))).unwrap();
        assert_eq!(found.degenerate, Some(Degeneracy::PureRotation), "{factor}");
        let TwoViewModel::Rotation { rotation, .. } = &found.model else { panic!("{factor}: {:?}", found.model) };
        // As far off as the focal length at most.
        assert!(TURNED.errors(rotation, &[1.0, 0.0, 0.0])[0] < 0.06 * 0.55, "{factor}");
        for scene in [RELIEF, TOWN, CONVERGENT, FLAT] {
            let found = two_view(&scene.matches(1000, SIGMA_PX, 0.3, 6), &cameras(Some(factor * FOCAL))).unwrap();
            assert_ne!(found.degenerate, Some(Degeneracy::PureRotation), "{factor}");
        }
    }
}

#[test]
fn the_same_photo_twice_is_no_base() {
    let points: Vec<[f64; 4]> = RELIEF.matches(300, 0.0, 0.0, 7).iter().map(|[x, y, _, _]| [*x, *y, *x, *y]).collect();
    for options in [cameras(Some(FOCAL)), cameras(None)] {
        assert_eq!(two_view(&points, &options).unwrap().degenerate, Some(Degeneracy::PureRotation));
    }
}

#[test]
fn unknown_cameras_give_the_fundamental_matrix() {
    for (name, scene) in [("relief", RELIEF), ("town", TOWN), ("convergent", CONVERGENT)] {
        for (count, wrong) in [(2000, 0.0), (2000, 0.6), (200, 0.5)] {
            let what = format!("{name} {count} {wrong}");
            let found = two_view(&scene.matches(count, SIGMA_PX, wrong, 5), &TwoViewOptions::default()).unwrap();
            check_matches(&what, &found, count, wrong);
            let TwoViewModel::Fundamental { fundamental } = &found.model else { panic!("{what}: {:?}", found.model) };
            assert!(found.degenerate.is_none() && found.focal.is_none());
            assert!(worst_distance(&scene, fundamental) < 3.0, "{what}: {}", worst_distance(&scene, fundamental));
        }
    }
}

#[test]
fn a_plane_seen_by_unknown_cameras_gives_its_map() {
    for options in [TwoViewOptions::default(), cameras(None)] {
        for wrong in [0.0, 0.6] {
            let found = two_view(&FLAT.matches(1000, SIGMA_PX, wrong, 8), &options).unwrap();
            check_matches("flat", &found, 1000, wrong);
            assert_eq!(found.degenerate, Some(Degeneracy::Plane));
            let TwoViewModel::Homography { homography } = found.model else { panic!("{:?}", found.model) };
            let map = Matrix3::from_fn(|i, j| homography[i][j]);
            for [x, y, u, v] in FLAT.matches(100, 0.0, 0.0, 98) {
                let seen = map * Vector3::new(x, y, 1.0);
                assert!((seen.x / seen.z - u).abs() < 1.0 && (seen.y / seen.z - v).abs() < 1.0);
            }
        }
    }
}

/// Matches as a camera sees them whose principal point and distortion are off by 1 % of half the diagonal, with these signs.
fn disturbed(points: &mut [[f64; 4]], [dx, dy, radial]: [f64; 3]) {
    let corner = 0.5 * (SIZE[0] * SIZE[0] + SIZE[1] * SIZE[1]).sqrt();
    for side in points.iter_mut().flat_map(|point| point.chunks_exact_mut(2)) {
        let (x, y) = (side[0] - 0.5 * SIZE[0], side[1] - 0.5 * SIZE[1]);
        let share = 1.0 + 0.01 * radial * (x * x + y * y) / (corner * corner);
        side[0] += x * (share - 1.0) + 0.01 * dx * corner;
        side[1] += y * (share - 1.0) + 0.01 * dy * corner;
    }
}

/// Distance of the four coordinates of a match from a fundamental matrix, to first order, px.
fn distance_px(fundamental: &[[f64; 3]; 3], [x, y, u, v]: [f64; 4]) -> f64 {
    let matrix = Matrix3::from_fn(|i, j| fundamental[i][j]);
    let (left, right) = (Vector3::new(x, y, 1.0), Vector3::new(u, v, 1.0));
    let (line, back) = (matrix * left, matrix.tr_mul(&right));
    right.dot(&line).abs() / (line.xy().norm_squared() + back.xy().norm_squared()).sqrt()
}

#[test]
fn inliers_of_an_estimated_focal_length_agree_with_the_pose_that_is_given() {
    for seed in 20..24 {
        let points = CONVERGENT.matches(400, SIGMA_PX, 0.3, seed);
        let found = two_view(&points, &cameras(None)).unwrap();
        let (Some(_), TwoViewModel::Calibrated { fundamental, .. }) = (found.focal, found.model) else { panic!("{:?}", found.model) };
        let agrees = |k: &usize| distance_px(&fundamental, points[*k]) <= found.threshold_px + 1e-9;
        assert!(found.inliers.iter().all(agrees), "seed {seed}");
        // The others lie behind a camera.
        let left_out = (0..points.len()).filter(agrees).filter(|k| !found.inliers.contains(k)).count();
        assert!(left_out < 10, "seed {seed}: {left_out}");
    }
}

#[test]
fn the_focal_length_does_not_depend_on_where_positions_count_from() {
    let points = CONVERGENT.matches(400, SIGMA_PX, 0.0, 20);
    let estimate = |origin: [f64; 2]| {
        let moved: Vec<[f64; 4]> = points.iter().map(|p| std::array::from_fn(|k| p[k] - origin[k % 2])).collect();
        let camera = Pinhole { focal_px: None, principal_px: [0.5 * SIZE[0] - origin[0], 0.5 * SIZE[1] - origin[1]] };
        two_view(&moved, &TwoViewOptions { left: Some(camera), right: Some(camera), ..TwoViewOptions::default() }).unwrap().focal
    };
    let usual = estimate([0.0; 2]).expect("convergent views over relief determine it");
    for origin in [[0.5 * SIZE[0], 0.5 * SIZE[1]], [0.5 * SIZE[0], 0.0], [-3000.0, 200.0]] {
        let found = estimate(origin).unwrap_or_else(|| panic!("{origin:?}: not determined"));
        assert!((found.focal_px - usual.focal_px).abs() < 0.2 * usual.standard_error_px, "{origin:?}: {found:?}, {usual:?}");
    }
}

#[test]
fn matches_that_are_all_wrong_have_no_geometry() {
    for seed in 0..runs(30) {
        for count in [30, 100] {
            let strangers = RELIEF.matches(count, SIGMA_PX, 1.0, 1000 + seed);
            for options in [cameras(Some(FOCAL)), cameras(None)] {
                let found = two_view(&strangers, &options);
                assert!(matches!(found, Err(Error::Degenerate { .. })), "seed {seed}: {found:?}");
            }
        }
    }
}

#[test]
fn the_focal_length_is_estimated_with_its_precision() {
    let mut squares = Vec::new();
    for seed in 0..8 {
        let sign = |bit: u64| if seed >> bit & 1 == 1 { 1.0 } else { -1.0 };
        let mut points = CONVERGENT.matches(400, SIGMA_PX, 0.3, 20 + seed);
        let found = two_view(&points, &cameras(None)).unwrap();
        assert!(found.focal.is_some(), "convergent views over relief determine it");
        let [rotation, base] = pose_errors(&CONVERGENT, &found);
        assert!(rotation < 0.01 && base < 0.01, "{rotation} {base}");
        disturbed(&mut points, [0, 1, 2].map(sign));
        let focal = two_view(&points, &cameras(None)).unwrap().focal.expect("a little off");
        let ratio = (focal.focal_px - FOCAL) / focal.standard_error_px;
        squares.push(ratio * ratio);
    }
    let variance = squares.iter().sum::<f64>() / squares.len() as f64;
    assert!((0.3..3.0).contains(&variance), "{variance}: {squares:?}");
}

#[test]
fn parallel_axes_over_low_relief_leave_the_focal_length_open() {
    let level = Scene { angles: [0.0; 3], base: [0.4, 0.0, 0.0], relief: 0.05, ..RELIEF };
    let found = two_view(&level.matches(1000, SIGMA_PX, 0.3, 9), &cameras(None)).unwrap();
    assert!(found.focal.is_none() && matches!(found.model, TwoViewModel::Fundamental { .. }), "{found:?}");
}

#[test]
fn cameras_of_different_focal_lengths_are_oriented() {
    let mut points = RELIEF.matches(1000, 0.0, 0.4, 10);
    // The right photo at half the size.
    points.iter_mut().for_each(|p| (p[2], p[3]) = (0.5 * p[2], 0.5 * p[3]));
    let camera =
        |factor: f64| Some(Pinhole { focal_px: Some(factor * FOCAL), principal_px: [0.5 * factor * SIZE[0], 0.5 * factor * SIZE[1]] });
    let found = two_view(&points, &TwoViewOptions { left: camera(1.0), right: camera(0.5), ..TwoViewOptions::default() }).unwrap();
    let [rotation, base] = pose_errors(&RELIEF, &found);
    assert!(rotation < 1e-6 && base < 1e-6, "{rotation} {base}");
    assert!((600..=610).contains(&found.inliers.len()), "{}", found.inliers.len());
}

#[test]
fn matches_at_random_have_no_geometry() {
    for (count, seed) in [(30, 1), (200, 2), (2000, 3)] {
        let options = TwoViewOptions { max_samples: 2000, ..TwoViewOptions::default() };
        for options in [TwoViewOptions { left: cameras(Some(FOCAL)).left, right: cameras(Some(FOCAL)).right, ..options.clone() }, options] {
            let refused = two_view(&RELIEF.matches(count, 0.0, 1.0, 60 + seed), &options);
            assert!(matches!(refused, Err(Error::Degenerate { .. })), "{count}: {refused:?}");
        }
    }
}

#[test]
fn the_threshold_follows_the_precision_or_is_given() {
    for sigma in [0.1, 0.3, 1.0] {
        let found = two_view(&RELIEF.matches(1000, sigma, 0.3, 11), &cameras(Some(FOCAL))).unwrap();
        assert!((found.sigma_px / sigma - 1.0).abs() < 0.15 && found.threshold_px < 3.6 * found.sigma_px, "{sigma}: {found:?}");
    }
    let given = TwoViewOptions { threshold_px: Some(3.0), ..cameras(Some(FOCAL)) };
    assert!((two_view(&RELIEF.matches(1000, 0.3, 0.3, 11), &given).unwrap().threshold_px - 3.0).abs() < 1e-12);
}

#[test]
fn a_seed_gives_its_result_and_any_seed_a_good_one() {
    let points = RELIEF.matches(500, SIGMA_PX, 0.5, 12);
    let with = |seed| two_view(&points, &TwoViewOptions { seed, ..cameras(Some(FOCAL)) }).unwrap();
    assert_eq!(with(3), with(3));
    for seed in 0..5 {
        let [rotation, base] = pose_errors(&RELIEF, &with(seed));
        assert!(rotation < 0.002 && base < 0.004, "{seed}: {rotation} {base}");
    }
}

#[test]
fn input_that_is_none_is_refused() {
    let points = RELIEF.matches(100, SIGMA_PX, 0.0, 13);
    let refused = |points: &[[f64; 4]], options: &TwoViewOptions| two_view(points, options).unwrap_err();
    let default = TwoViewOptions::default();
    assert!(matches!(refused(&points[..11], &default), Error::TooFew { got: 11, needed: 12, .. }));
    assert!(matches!(refused(&[], &default), Error::TooFew { got: 0, .. }));
    assert!(matches!(refused(&[[1.0, 2.0, 3.0, 4.0]; 50], &default), Error::TooFew { got: 1, .. }));
    for wrong in [f64::NAN, f64::INFINITY, -2e6] {
        let mut points = points.clone();
        points[7][2] = wrong;
        assert!(matches!(refused(&points, &default), Error::InvalidInput { refusal: Refusal::MatchPosition { .. } }));
    }
    let one = TwoViewOptions { right: None, ..cameras(None) };
    assert!(matches!(refused(&points, &one), Error::InvalidInput { refusal: Refusal::OneCamera }));
    let one = TwoViewOptions { right: cameras(None).right, ..cameras(Some(FOCAL)) };
    assert!(matches!(refused(&points, &one), Error::InvalidInput { refusal: Refusal::OneFocalLength }));
    for (options, named) in [
        (TwoViewOptions { threshold_px: Some(f64::NAN), ..default.clone() }, "geometry.threshold_px"),
        (TwoViewOptions { largest_threshold_px: 0.0, ..default.clone() }, "geometry.largest_threshold_px"),
        (TwoViewOptions { confidence: 1.0, ..default.clone() }, "geometry.confidence"),
        (TwoViewOptions { max_samples: 0, ..default.clone() }, "geometry.max_samples"),
    ] {
        assert!(matches!(refused(&points, &options), Error::InvalidOption { field, .. } if field == named), "{named}");
    }
    assert!(refused(&points, &cameras(Some(-5.0))).to_string().contains("focal length of a camera"));
    // Points on a line fit any number of geometries.
    let on_a_line: Vec<[f64; 4]> = (0..60).map(|k| f64::from(k) * 30.0).map(|t| [t, 2.0 * t, t + 50.0, 2.0 * t + 3.0]).collect();
    for options in [default, cameras(Some(FOCAL)), cameras(None)] {
        let found = two_view(&on_a_line, &options);
        assert!(found.as_ref().map_or(true, |found| found.degenerate.is_some()), "{found:?}");
    }
}

#[test]
fn linear_solutions_are_those_of_good_points() {
    let points = RELIEF.matches(30, 0.0, 0.0, 14);
    assert!(worst_distance(&RELIEF, &fundamental_eight_point(&points).unwrap()) < 1e-5);
    let seven: [[f64; 4]; 7] = std::array::from_fn(|k| points[k]);
    let found = fundamental_seven_point(&seven).unwrap();
    assert!(found.iter().any(|matrix| worst_distance(&RELIEF, matrix) < 1e-3));
    let flat = FLAT.matches(30, 0.0, 0.0, 15);
    assert!(matches!(fundamental_eight_point(&flat), Err(Error::Degenerate { .. })));
    let homography = homography_direct(&flat).unwrap();
    let [x, y, u, v] = FLAT.matches(1, 0.0, 0.0, 16)[0];
    let [a, b, c] = homography.map(|row| row[0] * x + row[1] * y + row[2]);
    assert!((a / c - u).abs() < 1e-6 && (b / c - v).abs() < 1e-6);
    assert!(matches!(fundamental_eight_point(&points[..7]), Err(Error::TooFew { needed: 8, .. })));
    assert!(matches!(homography_direct(&points[..3]), Err(Error::TooFew { needed: 4, .. })));
    assert!(matches!(homography_direct(&[[f64::NAN; 4]; 4]), Err(Error::InvalidInput { .. })));
}

#[test]
fn the_fundamental_matrix_guides_matching() {
    let points = RELIEF.matches(500, 0.2, 0.0, 17);
    let found = two_view(&points, &cameras(Some(FOCAL))).unwrap();
    let TwoViewModel::Calibrated { fundamental, .. } = found.model else { panic!("{:?}", found.model) };
    // Each descriptor is that of four points: the whole image is ambiguous, an epipolar line hardly ever is.
    let descriptors: Vec<u8> =
        (0..500usize).flat_map(|k| (0..128).map(move |j| ((k % 125 * 37 + j * j * (k % 125 + 3)) % 251) as u8)).collect();
    let side = |first: usize| points.iter().map(|p| [p[first], p[first + 1]]).collect::<Vec<_>>();
    let (left, right) = (side(0), side(2));
    let located = |positions| Located { positions, descriptors: &descriptors };
    let matches = guided_matches(located(&left), located(&right), &Guide::Lines(fundamental), &GuidedOptions::default()).unwrap();
    let right_ones = matches.iter().filter(|m| m.left == m.right).count();
    assert!(right_ones > 450 && matches.len() - right_ones < 15, "{right_ones} of {}", matches.len());
}
