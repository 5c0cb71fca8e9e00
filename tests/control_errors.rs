//! Wrong coordinates of ground control points: which are refused, what is said of them, and that good ones are left alone.

use super::flown::{adjusted, control, flown, place, refused};
use super::normal::Normal;
use super::sampling::cases;
use super::scene::{Scene, scene};
use super::surveyed::surveyed;
use tiepoint::{Axis, BlockFlight, BlockWarning, ControlRole, GroundControlPoint, Mistake, ObservedPosition, ReconstructedModel};

fn contradicts(model: &ReconstructedModel) -> bool {
    model.warnings.iter().any(|warning| matches!(warning, BlockWarning::ControlContradicts { .. }))
}

#[test]
fn clean_blocks_refuse_no_control_point_but_by_chance() {
    let mut by_chance = 0;
    for (has_gnss, seed) in [(true, 1), (true, 2), (false, 3), (true, 12)] {
        let scene = flown(6, has_gnss, seed);
        let model = adjusted(&scene);
        assert!(!contradicts(&model), "{seed}: {:?}", model.warnings);
        // Of 72 coordinates one exceeds the limit of 0.001 with a probability of 0.07.
        by_chance += refused(&model).len();
        let of_control = || model.surveyed.iter().filter(|point| point.role == ControlRole::Control);
        assert_eq!(of_control().filter(|point| point.refused.is_some()).count(), refused(&model).len());
        assert!(of_control().all(|point| point.detectable_m.iter().all(|error| error.is_some_and(|error| error > 0.0))));
        assert!(model.surveyed.iter().all(|point| point.role == ControlRole::Control || point.detectable_m == [None; 3]));
    }
    assert!(by_chance <= 1, "{by_chance}");
}

/// The error of a coordinate that the test of a control point finds, in a block without wrong points.
fn detectable(clean: &ReconstructedModel, name: &str, axis: usize) -> f64 {
    clean.surveyed.iter().find(|point| point.name == name).unwrap().detectable_m[axis].unwrap()
}

#[test]
fn a_mistyped_digit_is_refused_named_and_explained_and_moves_nothing() {
    let mut scene = flown(6, true, 4);
    let wrong = control(&scene)[2];
    let given = *place(&mut scene.description.control[wrong]);
    // Another digit of the tens.
    let tens = (given[0].abs() / 10.0).floor() % 10.0;
    place(&mut scene.description.control[wrong])[0] += given[0].signum() * if tens < 5.0 { 30.0 } else { -30.0 };
    let typed = *place(&mut scene.description.control[wrong]);
    assert!(typed[0] != given[0]);
    let model = adjusted(&scene);
    let name = scene.description.control[wrong].name.clone();
    let found = refused(&model);
    assert_eq!(found.len(), 1, "{:?}", model.warnings);
    let (point, axis, used, mistake) = found[0];
    assert!(point == name && axis == Axis::X && !used, "{found:?}");
    let Some(Mistake::Digit { axis: Axis::X, given: written, likely }) = mistake else { panic!("{found:?}") };
    assert!((written.parse::<f64>().unwrap() - typed[0]).abs() < 1e-9 && (likely.parse::<f64>().unwrap() - given[0]).abs() < 1e-9);
    let text = model.warnings.iter().map(ToString::to_string).find(|text| text.contains("is rejected")).unwrap();
    assert!(
        text.contains(&format!("The x of control point {name} is rejected")) && text.contains(likely) && text.contains("takes no part"),
        "{text}"
    );
    // It is where a check point would be, and the block lies as if it were one.
    let own = model.surveyed.iter().find(|point| point.name == name).unwrap();
    let left = own.left_out.unwrap();
    assert!(
        (left.difference[0] - (given[0] - typed[0])).abs() < 5.0 * left.standard_errors[0] && own.refused.unwrap().axis == Some(Axis::X)
    );
    scene.description.control[wrong].role = ControlRole::Check;
    let checked = adjusted(&scene);
    assert_eq!(checked.adjusted.block.images, model.adjusted.block.images);
    assert!(refused(&checked).is_empty());
}

#[test]
fn exchanged_axes_feet_and_a_decimal_point_of_one_point_are_told_apart() {
    type Slip = (fn([f64; 3]) -> [f64; 3], fn(&Mistake) -> bool);
    let slips: [Slip; 3] = [
        (|[x, y, z]| [y, x, z], |mistake| *mistake == Mistake::Exchanged),
        (|[x, y, z]| [x, y, z / 0.3048], |mistake| matches!(mistake, Mistake::Feet { .. })),
        (|[x, y, z]| [x * 10.0, y, z], |mistake| matches!(mistake, Mistake::DecimalPoint { axis: Axis::X, .. })),
    ];
    for (has_gnss, (slip, is_it)) in [true, false, true].into_iter().zip(slips) {
        let mut scene = flown(6, has_gnss, 5);
        // In a map's system, whose origin is far off.
        for point in &mut scene.description.control {
            let at = place(point);
            *at = [at[0] + 3000.0, at[1] + 5000.0, at[2] + 400.0];
        }
        for image in &mut scene.description.images {
            let Some(ObservedPosition::Local { position, .. }) = &mut image.position else { continue };
            *position = [position[0] + 3000.0, position[1] + 5000.0, position[2] + 400.0];
        }
        let wrong = control(&scene)[3];
        let at = place(&mut scene.description.control[wrong]);
        *at = slip(*at);
        let model = adjusted(&scene);
        let name = &scene.description.control[wrong].name;
        let found = refused(&model);
        assert!(found.len() == 1 && found[0].0 == name && !found[0].2 && found[0].3.is_some_and(is_it), "{:?}", model.warnings);
        assert_eq!(model.adjusted.block.control.len(), 5);
    }
}

#[test]
fn one_error_after_the_other_accuses_no_neighbour() {
    let mut scene = flown(8, true, 6);
    let points = control(&scene);
    let clean = adjusted(&scene);
    for (point, axis) in [(points[1], 2), (points[6], 1)] {
        let error = 3.0 * detectable(&clean, &scene.description.control[point].name, axis);
        place(&mut scene.description.control[point])[axis] += error;
    }
    let model = adjusted(&scene);
    let mut found: Vec<(&str, Axis, bool)> = refused(&model).into_iter().map(|(point, axis, used, _)| (point, axis, used)).collect();
    found.sort_by(|a, b| a.0.cmp(b.0));
    let name = |k: usize| scene.description.control[points[k]].name.as_str();
    let mut wanted = [(name(1), Axis::Z, false), (name(6), Axis::Y, false)];
    wanted.sort_by(|a, b| a.0.cmp(b.0));
    assert_eq!(found, wanted, "{:?}", model.warnings);
}

#[test]
fn too_few_points_all_stay_used_and_are_warned_of() {
    let mut scene = flown(4, false, 7);
    let wrong = control(&scene)[1];
    let error = 4.0 * detectable(&adjusted(&scene), &scene.description.control[wrong].name, 0);
    place(&mut scene.description.control[wrong])[0] += error;
    let model = adjusted(&scene);
    // Which of four is wrong nothing tells for sure: none is left out, and what is said is said of the points, not of their image measurements alone.
    assert_eq!(model.adjusted.block.control.len(), 4);
    assert!(refused(&model).iter().all(|(.., used, _)| *used));
    assert!(is_said(&model), "{:?}", model.warnings);
}

#[test]
fn a_wrong_point_that_keeps_the_block_from_being_placed_is_found_all_the_same() {
    let mut scene = flown(5, false, 22);
    let wrong = control(&scene)[2];
    place(&mut scene.description.control[wrong])[0] += 30.0;
    let model = adjusted(&scene);
    let found: Vec<(&str, Axis, bool)> = refused(&model).into_iter().map(|(point, axis, used, _)| (point, axis, used)).collect();
    assert_eq!(found, [(scene.description.control[wrong].name.as_str(), Axis::X, false)], "{:?}", model.warnings);
    assert!(model.in_system && model.adjusted.block.control.len() == 4);
}

#[test]
fn the_point_that_fits_worst_is_tried_before_its_neighbours() {
    let mut scene = flown(7, false, 5);
    let points = control(&scene);
    for (point, axis, error) in [(points[2], 0, 3.0), (points[3], 1, 30.0)] {
        place(&mut scene.description.control[point])[axis] += error;
    }
    let model = adjusted(&scene);
    let found: Vec<(&str, Axis, bool)> = refused(&model).into_iter().map(|(point, axis, used, _)| (point, axis, used)).collect();
    let name = |k: usize| scene.description.control[points[k]].name.as_str();
    assert_eq!(found, [(name(2), Axis::X, false), (name(3), Axis::Y, false)], "{:?}", model.warnings);
}

#[test]
fn exchanged_axes_of_all_points_are_said_where_the_block_is_seen_from_below() {
    let mut scene = flown(8, false, 6);
    for k in control(&scene) {
        place(&mut scene.description.control[k]).swap(0, 1);
    }
    let model = adjusted(&scene);
    let up = |warning: &BlockWarning| matches!(warning, BlockWarning::LookingUp { tilt_deg, .. } if *tilt_deg > 170.0);
    assert!(model.warnings.iter().any(up), "{:?}", model.warnings);
}

#[test]
fn standard_errors_that_are_stated_too_small_make_no_point_wrong() {
    let mut scene = flown(8, false, 9);
    for point in &mut scene.description.control {
        let ObservedPosition::Local { sigma, .. } = &mut point.position else { unreachable!() };
        *sigma = sigma.map(|sigma| 0.1 * sigma);
        point.sigma_px = Some(0.05);
    }
    let model = adjusted(&scene);
    assert!(refused(&model).is_empty(), "{:?}", model.warnings);
}

#[test]
fn few_or_badly_spread_control_points_are_said_with_figures() {
    let three = flown(3, false, 10);
    let model = adjusted(&three);
    let few = model.warnings.iter().find_map(|warning| match warning {
        BlockWarning::FewControl { points, positions: 0, detectable_m } => Some((*points, *detectable_m)),
        _ => None,
    });
    let (points, detectable_m) = few.unwrap();
    // What checks three points is their distances: an error shows late or not at all.
    let largest = |of: &ReconstructedModel| {
        let control = of.surveyed.iter().filter(|point| point.role == ControlRole::Control);
        control.flat_map(|point| point.detectable_m).try_fold(0.0, |most: f64, error| Some(most.max(error?)))
    };
    assert_eq!(detectable_m, largest(&model));
    assert!(points == 3 && detectable_m.is_none_or(|error| error > 0.3), "{detectable_m:?}");

    // Of three positions one is wrong: two are left beside the points.
    let mut beside = flown(3, true, 10);
    for (index, image) in beside.description.images.iter_mut().enumerate() {
        match &mut image.position {
            Some(ObservedPosition::Local { position, .. }) if index == 7 => position[0] += 500.0,
            position if index != 0 && index != 14 => *position = None,
            _ => {}
        }
    }
    let model = adjusted(&beside);
    let of_both = |warning: &BlockWarning| matches!(warning, BlockWarning::FewControl { points: 3, positions: 2, .. });
    assert!(model.warnings.iter().any(of_both), "{:?}", model.warnings);

    let spread = |keep: &dyn Fn([f64; 3], [f64; 2]) -> bool, seed| {
        let mut scene = flown(24, false, seed);
        let middle = [0, 1].map(|k| scene.block.ground.iter().map(|place| place[k]).sum::<f64>() / scene.block.ground.len() as f64);
        for point in &mut scene.description.control {
            let at = *place(point);
            if !keep(at, middle) {
                point.role = ControlRole::Check;
            }
        }
        assert!(control(&scene).len() >= 4, "{}", control(&scene).len());
        adjusted(&scene)
    };
    let span = |model: &ReconstructedModel| {
        model.warnings.iter().find_map(|warning| match warning {
            BlockWarning::ControlSpan { span_percent, .. } => Some(*span_percent),
            _ => None,
        })
    };
    let all = spread(&|_, _| true, 11);
    assert!(
        span(&all).is_none()
            && !all.warnings.iter().any(|w| matches!(w, BlockWarning::ControlOnLine { .. } | BlockWarning::FewControl { .. }))
    );
    let corner = spread(&|[x, y, _], [a, b]| x < a && y < b, 11);
    assert!(span(&corner).is_some_and(|percent| (2.0..25.0).contains(&percent)), "{:?}", corner.warnings);
}

/// A block of two strips without GNSS positions, with so many control points that are spread over it, as well as they can be.
fn spread(control: usize) -> Scene {
    let flight = BlockFlight { strips: 2, exposures: 4, width_px: 800, height_px: 600, pixel_mm: 0.09, seed: 3, ..BlockFlight::default() };
    let mut scene = scene(&BlockFlight { features: 700, ..flight }, 1.0);
    let mut all = surveyed(&scene.block, 40, 0, &mut Normal(3 << 32));
    let plan = |point: &mut GroundControlPoint| [place(point)[0], place(point)[1]];
    let places: Vec<[f64; 2]> = all.iter_mut().map(plan).collect();
    let distance = |a: usize, b: usize| (places[a][0] - places[b][0]).hypot(places[a][1] - places[b][1]);
    let mut chosen = vec![(0..all.len()).max_by(|a, b| distance(0, *a).total_cmp(&distance(0, *b))).unwrap()];
    while chosen.len() < control {
        let nearest = |point: &usize| chosen.iter().map(|of| distance(*of, *point)).fold(f64::MAX, f64::min);
        chosen.push((0..all.len()).max_by(|a, b| nearest(a).total_cmp(&nearest(b))).unwrap());
    }
    scene.description.control = chosen.into_iter().map(|index| all[index].clone()).collect();
    scene
}

/// The block with errors in coordinates of its control points.
fn with_errors(clean: &Scene, errors: &[(usize, usize, f64)]) -> ReconstructedModel {
    let mut scene = Scene { block: clean.block.clone(), points: clean.points.clone(), description: clean.description.clone() };
    errors.iter().for_each(|(point, axis, error)| place(&mut scene.description.control[*point])[*axis] += error);
    println!("{errors:?}");
    let model = adjusted(&scene);
    println!("  {:?}", model.surveyed.iter().map(|of| (&of.name, of.rays, of.refused.map(|of| of.is_used))).collect::<Vec<_>>());
    model
}

/// Whether a warning says that control points are wrong, or may be.
fn is_said(model: &ReconstructedModel) -> bool {
    let is_of_control = |warning: &BlockWarning| {
        matches!(
            warning,
            BlockWarning::ControlRefused { .. } | BlockWarning::ControlContradicts { .. } | BlockWarning::ControlUntested { .. }
        )
    };
    model.warnings.iter().any(is_of_control)
}

#[test]
fn one_wrong_of_four_control_points_is_seldom_silent() {
    let clean = spread(4);
    let model = adjusted(&clean);
    assert!(!is_said(&model), "{:?}", model.warnings);
    let (mut largest, mut silent) = (0.0_f64, Vec::new());
    let coordinates = cases(&[(0, 0), (1, 2), (3, 0), (0, 2), (1, 0), (3, 2)], 3);
    for &(point, axis) in coordinates {
        let detectable = detectable(&model, &clean.description.control[point].name, axis);
        for error in [1.5 * detectable, 3.0 * detectable, 100.0] {
            let wrong = with_errors(&clean, &[(point, axis, error)]);
            if !is_said(&wrong) && wrong.in_system {
                silent.push((point, axis, error / detectable));
            }
            for warning in &wrong.warnings {
                if let BlockWarning::ControlContradicts { w, .. } = warning {
                    assert!(w.is_some_and(|w| w > 3.29), "{w:?}");
                    // Where no point is named all that contradict each other are doubtful.
                    assert!(wrong.surveyed.iter().any(|point| point.refused.is_some()), "{:?}", wrong.surveyed);
                    largest = largest.max(w.unwrap());
                }
            }
        }
    }
    println!("silent: {silent:?}");
    assert!(largest > 6.0, "{largest}");
    // Now and then image measurements of other points are rejected in place of a small error.
    assert!(2 * silent.len() < coordinates.len() && silent.iter().all(|(.., times)| *times < 4.0), "{silent:?}");
}

#[test]
fn control_points_that_do_not_fit_together_are_named_where_they_do_not_place_a_block() {
    for control in [3, 4] {
        let clean = spread(control);
        for error in [100.0, 1000.0, 10_000.0] {
            let model = with_errors(&clean, &[(0, 0, error)]);
            let shape = model.warnings.iter().find_map(|warning| match warning {
                BlockWarning::ControlShape { names, ratio, point, .. } => Some((names.len(), *ratio, point.as_ref())),
                _ => None,
            });
            let Some((names, ratio, point)) = shape else {
                assert!(model.in_system && is_said(&model), "{control} {error}: {:?}", model.warnings);
                continue;
            };
            assert!(!model.in_system && names == control && ratio > 1.01, "{:?}", model.warnings);
            assert!(control == 3 && point.is_none() || point == Some(&clean.description.control[0].name), "{point:?}");
        }
    }
}

#[test]
fn two_wrong_of_five_control_points_are_not_used_without_a_word() {
    let clean = spread(5);
    assert!(!is_said(&adjusted(&clean)));
    for error in [20.0, 100.0] {
        let model = with_errors(&clean, &[(0, 0, error), (3, 1, -error)]);
        let is_doubted = |index: usize| {
            let name = &clean.description.control[index].name;
            model.surveyed.iter().find(|of| of.name == *name).is_none_or(|of| of.refused.is_some())
        };
        // Errors that bend the whole block are said, though not of the right points each time.
        let is_told = if error < 50.0 { is_doubted(0) && is_doubted(3) } else { is_said(&model) };
        assert!(!model.in_system || contradicts(&model) || is_told, "{:?}", model.warnings);
        assert!(!model.warnings.iter().any(|warning| matches!(warning, BlockWarning::ControlUnplaced { .. })), "{:?}", model.warnings);
    }
}

#[test]
fn a_wrong_control_point_accuses_no_neighbour() {
    for &control in cases(&[5, 7, 6], 2) {
        let clean = spread(control);
        for (axis, error) in [(0, 50.0), (2, 50.0), (0, 8.0)] {
            let model = with_errors(&clean, &[(0, axis, error)]);
            let named: Vec<&str> = refused(&model).into_iter().map(|(point, ..)| point).collect();
            assert!(named == [clean.description.control[0].name.as_str()], "{control} {axis} {error}: {:?}", model.warnings);
        }
    }
}
