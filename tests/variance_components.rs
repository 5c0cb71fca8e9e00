//! Weights of groups of observations by their residuals, on simulated blocks whose errors are known.

use super::normal::Normal;
use super::stated::{Case, GROUPS, MARK_PX, Simulated};
use tiepoint::{
    AdjustmentOptions, AdjustmentResult, Block, BlockObservation, Datum, ObservationGroup, ObservationVerdict, VarianceComponent,
    adjust_block,
};

const RIGHT: Case = Case { factors: [1.0; 5], control: 12, datum: Datum::GnssAndControl };

fn estimated(case: &Case, seed: u32, options: AdjustmentOptions) -> (Simulated, AdjustmentResult) {
    let simulated = Simulated::new(case, seed).unwrap();
    let adjusted = adjust_block(&simulated.block, &AdjustmentOptions { datum: case.datum, variance_components: true, ..options }).unwrap();
    (simulated, adjusted)
}

fn of(adjusted: &AdjustmentResult, group: ObservationGroup) -> VarianceComponent {
    *adjusted.components.iter().find(|component| component.group == group).unwrap()
}

#[test]
fn factors_are_beside_what_is_stated_whatever_sigma0_is_given() {
    let factors = |sigma0_px| {
        let (_, adjusted) = estimated(&RIGHT, 3, AdjustmentOptions { sigma0_px, ..AdjustmentOptions::default() });
        [ObservationGroup::GnssPlan, ObservationGroup::GnssHeight].map(|group| of(&adjusted, group).factor)
    };
    // True are 0.4 px. A larger one takes errors of tie points for smaller than they are stated, and no group for larger.
    for (free, given, larger) in (0..2).map(|k| (factors(None)[k], factors(Some(0.4))[k], factors(Some(0.6))[k])) {
        assert!((given / free - 1.0).abs() < 0.03 && (0.75..1.05 * free).contains(&larger), "{free} {given} {larger}");
    }
}

#[test]
fn weighted_image_measurements_keep_the_standard_error_that_was_stated() {
    let case = Case { factors: [3.0, 1.0, 1.0, 1.0, 1.0], ..RIGHT };
    let (simulated, adjusted) = estimated(&case, 2, AdjustmentOptions::default());
    let marks = of(&adjusted, ObservationGroup::Marks);
    assert!(marks.applied && (marks.factor / 3.0 - 1.0).abs() < 0.15, "{marks:?}");
    assert_eq!(adjusted.components.iter().filter(|component| component.applied).count(), 1, "{:?}", adjusted.components);
    let sigma0 = adjusted.sigma0_px.unwrap();
    for (given, ray) in simulated.block.rays.iter().zip(&adjusted.block.rays) {
        assert_eq!(given.sigma_px, ray.sigma_px);
        // Its weight is the one that it had, by the factor.
        let used = ray.sigma_px.map_or(sigma0, |sigma| sigma * marks.factor);
        assert!((sigma0 / used / ray.weight.sqrt() - 1.0).abs() < 0.05, "{ray:?}");
    }
    // So that the adjusted block, adjusted again, finds the same.
    let again =
        adjust_block(&adjusted.block, &AdjustmentOptions { datum: case.datum, variance_components: true, ..AdjustmentOptions::default() });
    let again = of(&again.unwrap(), ObservationGroup::Marks);
    assert!((again.factor / marks.factor - 1.0).abs() < 0.02 && MARK_PX == 1.0, "{again:?} {marks:?}");
}

#[test]
fn factors_are_told_where_weights_stay_as_stated() {
    let simulated = Simulated::new(&Case { factors: [3.0, 1.0, 1.0, 1.0, 1.0], ..RIGHT }, 2).unwrap();
    let adjusted = adjust_block(&simulated.block, &AdjustmentOptions { datum: RIGHT.datum, ..AdjustmentOptions::default() }).unwrap();
    let marks = of(&adjusted, ObservationGroup::Marks);
    assert!(adjusted.components.len() == 5 && adjusted.components.iter().all(|component| !component.applied), "{:?}", adjusted.components);
    assert!((marks.factor / 3.0 - 1.0).abs() < 0.2 && marks.interval.unwrap()[0] > 1.0 && !marks.held, "{marks:?}");
}

#[test]
fn sigma0_is_that_of_tie_points_however_well_others_fit() {
    // A third of all rays are of places whose standard errors are stated five times too large: they neither lower σ₀ nor cost good tie points.
    let case = Case { factors: [0.2, 1.0, 1.0, 1.0, 1.0], control: 150, ..RIGHT };
    // Rays of tie points have errors of 0.4 px, which their redundancy tells to 0.01.
    for seed in 1..=3 {
        let simulated = Simulated::new(&case, seed).unwrap();
        let adjusted = adjust_block(&simulated.block, &AdjustmentOptions { datum: case.datum, ..AdjustmentOptions::default() }).unwrap();
        let stated = simulated.block.rays.iter().filter(|ray| ray.sigma_px.is_some()).count();
        let rejected = adjusted.rays.iter().filter(|ray| ray.verdict == ObservationVerdict::GrossError).count();
        let sigma0 = adjusted.sigma0_px.unwrap();
        assert!((0.37..0.43).contains(&sigma0), "{sigma0}, {stated} of {} rays", adjusted.rays.len());
        assert!(3 * stated > adjusted.rays.len() && 200 * rejected < adjusted.rays.len(), "{rejected} of {}", adjusted.rays.len());
    }
}

#[test]
fn what_is_stated_is_weighted_beside_the_sigma0_that_is_reported() {
    // Errors of real matches have longer tails than the normal distribution: the median of these is a seventh below their σ₀.
    for (seed, datum) in [(4, Datum::GnssAndControl), (5, Datum::Gnss), (6, Datum::Control)] {
        let mut simulated = Simulated::new(&Case { datum, ..RIGHT }, seed).unwrap();
        let mut normal = Normal(u64::from(seed));
        for ray in simulated.block.rays.iter_mut().filter(|ray| ray.sigma_px.is_none()).step_by(5) {
            (ray.x_px, ray.y_px) = (ray.x_px + 0.8 * normal.next(), ray.y_px + 0.8 * normal.next());
        }
        let adjusted = adjust_block(&simulated.block, &AdjustmentOptions { datum, ..AdjustmentOptions::default() }).unwrap();
        let [sigma0, weighted_by] = [adjusted.sigma0_px, adjusted.weighted_by_px].map(Option::unwrap);
        assert!((weighted_by / sigma0 - 1.0).abs() < 0.005, "{datum:?}: {weighted_by} {sigma0}");
        let known = |ray: &&BlockObservation| ray.sigma_px.is_some();
        let is_so = |ray: &BlockObservation| (ray.weight * ray.sigma_px.unwrap().powi(2) / weighted_by.powi(2) - 1.0).abs() < 1e-9;
        assert!(adjusted.block.rays.iter().filter(known).all(is_so) && adjusted.block.rays.iter().filter(known).count() > 20);
    }
}

#[test]
fn marks_of_one_point_that_show_no_common_place_cost_nothing_else() {
    let datum = Datum::Control;
    let mut simulated = Simulated::new(&Case { datum, ..RIGHT }, 7).unwrap();
    let clean = adjust_block(&simulated.block, &AdjustmentOptions { datum, ..AdjustmentOptions::default() }).unwrap();
    let marks = |block: &Block, point: usize| block.rays.iter().filter(|ray| ray.point == point && ray.sigma_px.is_some()).count();
    let point = simulated.block.control.iter().map(|control| control.point).max_by_key(|point| marks(&simulated.block, *point)).unwrap();
    let number = marks(&simulated.block, point);
    let camera = simulated.block.cameras[0];
    for (k, ray) in simulated.block.rays.iter_mut().filter(|ray| ray.point == point).enumerate() {
        ray.x_px = (ray.x_px + 613.0 * k as f64) % f64::from(camera.width_px);
        ray.y_px = (ray.y_px * 7919.0) % f64::from(camera.height_px);
    }
    let torn = adjust_block(&simulated.block, &AdjustmentOptions { datum, ..AdjustmentOptions::default() }).unwrap();
    let rejected = |adjusted: &AdjustmentResult| adjusted.rays.iter().filter(|ray| ray.verdict == ObservationVerdict::GrossError).count();
    assert!(number >= 4 && rejected(&torn) <= rejected(&clean) + number + 2, "{number}: {} {}", rejected(&torn), rejected(&clean));
    assert!(torn.iterations < 3 * clean.iterations + 20, "{} {}", torn.iterations, clean.iterations);
    for (one, other) in torn.block.images.iter().zip(&clean.block.images).zip(&clean.images).map(|((torn, clean), errors)| {
        let moved = [0, 1, 2].map(|k| (torn.pose.position[k] - clean.pose.position[k]).abs());
        (moved, errors.position_errors.unwrap())
    }) {
        assert!((0..3).all(|k| one[k] < 2.0 * other[k]), "{one:?} {other:?}");
    }
}

#[test]
fn image_measurements_that_fit_by_the_last_weights_are_not_left_rejected_by_others() {
    // Stated at 1 px where they have 0.3 px: on the way to that they weigh too much for some.
    let case = Case { factors: [0.3, 1.0, 1.0, 1.0, 1.0], control: 7, datum: Datum::Control };
    let gross = |adjusted: &AdjustmentResult| {
        let of_rays = adjusted.block.rays.iter().zip(&adjusted.rays).enumerate();
        let rejected = of_rays.filter(|(_, (ray, judged))| ray.sigma_px.is_some() && judged.verdict == ObservationVerdict::GrossError);
        rejected.map(|(ray, _)| ray).collect::<Vec<_>>()
    };
    // Of these each had one.
    for seed in [8, 12, 13, 18] {
        let (mut simulated, adjusted) = estimated(&case, seed, AdjustmentOptions::default());
        let factor = |group| Some(of(&adjusted, group)).filter(|found| found.applied).map_or(1.0, |found| found.factor);
        let marks = factor(ObservationGroup::Marks);
        let [plan, height] = [ObservationGroup::ControlPlan, ObservationGroup::ControlHeight].map(factor);
        simulated.block.rays.iter_mut().for_each(|ray| ray.sigma_px = ray.sigma_px.map(|sigma| sigma * marks));
        simulated.block.control.iter_mut().for_each(|c| c.sigma = [c.sigma[0] * plan, c.sigma[1] * plan, c.sigma[2] * height]);
        let stated = adjust_block(&simulated.block, &AdjustmentOptions { datum: case.datum, ..AdjustmentOptions::default() }).unwrap();
        let [own, stated] = [&adjusted, &stated].map(gross);
        assert!(own.iter().all(|ray| stated.contains(ray)), "{seed}: {own:?}, with the same weights from the start {stated:?}");
    }
}

#[test]
fn rounds_of_weighting_are_counted_apart() {
    let case = Case { factors: [3.0, 1.0, 1.0, 1.0, 1.0], ..RIGHT };
    let (simulated, adjusted) = estimated(&case, 2, AdjustmentOptions::default());
    let plain = adjust_block(&simulated.block, &AdjustmentOptions { datum: case.datum, ..AdjustmentOptions::default() }).unwrap();
    // The last steps come once, after the last weighting.
    assert_eq!(adjusted.rounds, plain.rounds);
    assert!((plain.iterations - 2..=plain.iterations).contains(&adjusted.iterations), "{} {}", adjusted.iterations, plain.iterations);
    let weighting = adjusted.weighting.unwrap();
    assert!(weighting.converged && (1..20).contains(&weighting.rounds) && weighting.iterations >= weighting.rounds, "{weighting:?}");
    assert_eq!(plain.weighting, None);
}

#[test]
fn a_factor_that_few_points_do_not_determine_is_held() {
    let case = Case { factors: [1.0, 1.0, 1.0, 3.0, 3.0], control: 3, datum: Datum::Control };
    let (simulated, adjusted) = estimated(&case, 1, AdjustmentOptions::default());
    for group in [ObservationGroup::ControlPlan, ObservationGroup::ControlHeight] {
        let found = of(&adjusted, group);
        assert!(found.held && !found.applied && found.factor == 1.0 && found.interval.is_none(), "{found:?}");
        assert!(found.redundancy < 6.0 && found.observations >= simulated.block.control.len(), "{found:?}");
    }
}

#[test]
fn right_groups_keep_their_weights_beside_wrong_ones() {
    let mut applied = [0; 5];
    for seed in 1..=6 {
        let (_, adjusted) = estimated(&Case { factors: [1.0, 3.0, 3.0, 1.0, 1.0], ..RIGHT }, seed, AdjustmentOptions::default());
        assert!(adjusted.weighting.unwrap().converged, "{seed}: {:?}", adjusted.components);
        for component in adjusted.components.iter().filter(|component| component.applied) {
            applied[GROUPS.iter().position(|group| *group == component.group).unwrap()] += 1;
        }
    }
    assert!(applied[1] == 6 && applied[2] == 6 && applied[0] + applied[3] + applied[4] <= 2, "{applied:?}");
}

#[test]
fn check_points_hold_their_standard_errors_once_wrong_weights_are_found() {
    let case = Case { factors: [3.0, 1.0, 1.0, 1.0, 1.0], control: 12, datum: Datum::Control };
    let [mut stated, mut weighted] = [0.0; 2];
    let mut differences = 0.0;
    for seed in 1..=4 {
        let (simulated, adjusted) = estimated(&case, seed, AdjustmentOptions::default());
        let plain = adjust_block(&simulated.block, &AdjustmentOptions { datum: case.datum, ..AdjustmentOptions::default() }).unwrap();
        for point in &simulated.checks {
            let squares = |adjusted: &AdjustmentResult| {
                let errors = adjusted.points[*point].unwrap().errors.unwrap();
                let off = |k: usize| (adjusted.block.points[*point][k] - simulated.truth.points[*point][k]) / errors[k];
                (0..3).map(|k| off(k) * off(k)).sum::<f64>()
            };
            stated += squares(&plain);
            weighted += squares(&adjusted);
            differences += 3.0;
        }
    }
    let [stated, weighted] = [stated, weighted].map(|sum| (sum / differences).sqrt());
    assert!(stated > 1.5 && (0.75..1.3).contains(&weighted), "{stated} {weighted}");
}
