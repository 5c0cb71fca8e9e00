//! Pairs that can be computed but hardly be believed are said to be so, with the figure that shows it.

use super::scene::{Dice, FOCAL_MM, NADIR, PLANE, Pair};
use tiepoint::{Observation, RelativeOrientation, Warning, orient_relative};

const SIGMA_MM: f64 = 0.02;

fn oriented(observations: &[Observation]) -> RelativeOrientation {
    orient_relative(observations, FOCAL_MM, &NADIR.options()).unwrap()
}

#[test]
fn relief_over_the_whole_photo_is_without_warning() {
    for seed in 0..20 {
        let found = oriented(&NADIR.observe(300, SIGMA_MM, seed));
        assert!(found.warnings.is_empty(), "{:?}", found.warnings);
        assert!(found.plane_misfit.unwrap() > 10.0 && found.condition < 2000.0 && found.spread > 0.3);
    }
}

#[test]
fn a_plane_is_told_from_relief_by_its_misfit() {
    for seed in 0..20 {
        let found = oriented(&PLANE.observe(300, SIGMA_MM, seed));
        assert!(found.warnings.iter().any(|w| matches!(w, Warning::Plane { .. })), "{:?}, misfit {:?}", found.warnings, found.plane_misfit);
        assert!((0.7..1.3).contains(&found.plane_misfit.unwrap()), "{:?}", found.plane_misfit);
    }
    // Relief of as little as the noise: still a plane. Ten times that: none.
    let relief = |share: f64| {
        oriented(&Pair { relief: share, ..NADIR }.observe(300, SIGMA_MM, 3)).warnings.iter().any(|w| matches!(w, Warning::Plane { .. }))
    };
    assert!(relief(0.5 * SIGMA_MM / 92.0) && !relief(20.0 * SIGMA_MM / 92.0));
}

#[test]
fn points_in_a_corner_are_clustered() {
    let near = |o: &Observation| (o.left[0] - 40.0).abs() < 9.0 && (o.left[1] - 20.0).abs() < 9.0;
    let observations: Vec<Observation> = NADIR.observe(20_000, SIGMA_MM, 1).into_iter().filter(near).collect();
    assert!(observations.len() > 40);
    let found = oriented(&observations);
    assert!(
        found.warnings.iter().any(|w| matches!(w, Warning::Clustered { .. })) && found.spread < 0.05,
        "{:?}, spread {}",
        found.warnings,
        found.spread
    );
}

#[test]
fn a_focal_length_that_nothing_checks_is_said_and_one_that_relief_checks_is_not() {
    let seen = |pair: &Pair, seed: u64, within_mm: f64| -> Vec<Observation> {
        let is_near = |o: &Observation| o.left.iter().chain(&o.right).all(|v| v.abs() < within_mm);
        pair.observe(4000, SIGMA_MM, seed).into_iter().filter(is_near).collect()
    };
    let unchecked = |observations: &[Observation], factor: f64| {
        let found = orient_relative(observations, factor * FOCAL_MM, &NADIR.options()).unwrap();
        println!("{:.0} {:.3} {:?}", found.condition, found.spread, found.warnings);
        found.warnings.iter().any(|w| matches!(w, Warning::UncheckedFocal { .. }))
    };
    let level = Pair { base: [30.0, 0.4, -0.2], relief: 0.01, ..NADIR };
    let hills = Pair { relief: 0.2, ..level };
    for seed in 0..5 {
        // Three times too long a focal length, of a level ground; the right one of the same view is checked by what it sees.
        assert!(unchecked(&seen(&level, seed, 60.0), 3.0), "{seed}");
        assert!(!unchecked(&seen(&level, seed, 60.0), 1.0), "{seed}");
        assert!(!unchecked(&seen(&hills, seed, 30.0), 1.0), "{seed}");
    }
}

#[test]
fn a_focal_length_twice_too_long_is_heard_where_views_converge() {
    // The best pose of twice the focal length lies where no small change of it helps.
    let converging = Pair { angles_deg: [0.5, -16.0, -4.0], base: [50.0, 20.0, -3.0], relief: 0.2, ..NADIR };
    let heard = |factor: f64, seed: u64| {
        let found = orient_relative(&converging.observe(400, SIGMA_MM, seed), factor * FOCAL_MM, &converging.options()).unwrap();
        found.warnings.iter().find_map(|warning| match warning {
            Warning::FocalLength { change_percent, .. } => Some(*change_percent),
            _ => None,
        })
    };
    for seed in 0..5 {
        assert_eq!(heard(1.0, seed), None, "{seed}");
        assert!(heard(2.0, seed).is_some_and(|change| change == -50.0), "{seed}");
    }
}

#[test]
fn a_critical_cylinder_is_told_by_the_condition() {
    // Points on a circular cylinder along the base that holds both projection centres (Finsterwalder's critical cylinder).
    let mut dice = Dice::new(5);
    let radius = 0.5 * FOCAL_MM;
    let observations: Vec<Observation> = (0..400)
        .map(|_| {
            let (x, angle) = (dice.uniform(0.0, 92.0), dice.uniform(-1.2, 1.2));
            let (y, depth) = (radius * angle.sin(), radius * (1.0 + angle.cos()));
            let photo = |x: f64, dice: &mut Dice| [FOCAL_MM * x / depth, FOCAL_MM * y / depth].map(|v| v + SIGMA_MM * dice.normal());
            Observation::new(photo(x, &mut dice), photo(x - 92.0, &mut dice))
        })
        .collect();
    match orient_relative(&observations, FOCAL_MM, &NADIR.options()) {
        Ok(found) => assert!(
            found.warnings.iter().any(|w| matches!(w, Warning::IllConditioned { .. })) && found.condition > 2e4,
            "{:?}, condition {}",
            found.warnings,
            found.condition
        ),
        Err(refused) => assert!(refused.to_string().contains("condition"), "{refused}"),
    }
}
