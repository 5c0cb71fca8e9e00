//! What a block says of its uncertainty: regions of 95 %, and what undetected errors do.

use super::sampling::runs;
use tiepoint::{
    AdjustmentOptions, AdjustmentResult, Block, BlockFlight, BlockPreset, Datum, Loss, SimulatedNetwork, adjust_block, ellipsoid_semi_axes,
    simulate_network,
};

fn squares() -> AdjustmentOptions {
    AdjustmentOptions { loss: Loss::Squares, snooping: false, ..AdjustmentOptions::default() }
}

/// A short strip of few points: some thirty degrees of freedom.
fn short_strip(seed: u32) -> SimulatedNetwork {
    let flight = BlockFlight { strips: 1, exposures: 3, points_per_image: 20.0, approximate_m: 0.0, seed, ..BlockPreset::Network.flight() };
    simulate_network(&flight).unwrap()
}

/// The square of a difference by the covariance of errors and correlations.
fn by_covariance(difference: [f64; 3], errors: [f64; 3], [xy, xz, yz]: [f64; 3]) -> f64 {
    let matrix = nalgebra::Matrix3::new(1.0, xy, xz, xy, 1.0, yz, xz, yz, 1.0);
    let standardised = nalgebra::Vector3::from_fn(|k, _| difference[k] / errors[k]);
    (standardised.transpose() * matrix.try_inverse().unwrap() * standardised)[0]
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|k| a[k] - b[k])
}

/// Of the coordinates, the planes and the places of all centres and points: how many regions were looked at, and how many hold the truth.
fn covered(result: &AdjustmentResult, truth: &Block, counts: &mut [[usize; 2]; 3]) {
    let factors = result.factors_95().unwrap();
    let centres = result.images.iter().enumerate().map(|(image, statistics)| {
        let [own, wanted] = [&result.block, truth].map(|block| block.images[image].pose.position);
        (minus(own, wanted), statistics.position_errors.unwrap(), statistics.position_correlations.unwrap())
    });
    let points = result.points.iter().enumerate().filter_map(|(point, statistics)| {
        let statistics = statistics.as_ref()?;
        Some((minus(result.block.points[point], truth.points[point]), statistics.errors.unwrap(), statistics.correlations.unwrap()))
    });
    let mut count = |kind: usize, is_inside: bool| {
        counts[kind][0] += 1;
        counts[kind][1] += usize::from(is_inside);
    };
    for (difference, errors, [xy, xz, yz]) in centres.chain(points) {
        (0..3).for_each(|k| count(0, difference[k].abs() <= factors.interval * errors[k]));
        // A third coordinate that has nothing in common with the others, and no difference.
        let [x, y, _] = difference;
        count(1, by_covariance([x, y, 0.0], errors, [xy, 0.0, 0.0]) <= factors.ellipse * factors.ellipse);
        count(2, by_covariance(difference, errors, [xy, xz, yz]) <= factors.ellipsoid * factors.ellipsoid);
    }
}

#[test]
fn intervals_ellipses_and_ellipsoids_hold_the_truth_in_95_of_100_cases() {
    let mut counts = [[0; 2]; 3];
    let (mut freedom, mut adjusted, all) = (0, 0_u32, runs(1800));
    for seed in 1..=all {
        let simulated = short_strip(seed as u32);
        // By chance few points may leave an image undetermined.
        let Ok(result) = adjust_block(&simulated.observed, &squares()) else { continue };
        adjusted += 1;
        freedom += result.degrees_of_freedom;
        covered(&result, &simulated.truth, &mut counts);
    }
    let shares = counts.map(|[all, inside]| inside as f64 / all as f64);
    println!("{} degrees of freedom on average; intervals, ellipses, ellipsoids: {shares:.4?}", freedom as f64 / f64::from(adjusted));
    assert!(10 * u64::from(adjusted) > 9 * all, "{adjusted} of {all}");
    // Regions of one block go together: of 300 blocks a share is uncertain by less than 0.01.
    assert!(shares.iter().all(|share| (0.94..0.96).contains(share)), "{shares:?}");
}

#[test]
fn a_known_sigma0_leaves_the_limits_of_the_normal_distribution() {
    let simulated = short_strip(1);
    let estimated = adjust_block(&simulated.observed, &squares()).unwrap().factors_95().unwrap();
    let known = adjust_block(&simulated.observed, &AdjustmentOptions { sigma0_px: Some(0.4), ..squares() }).unwrap().factors_95().unwrap();
    let close = |got: f64, wanted: f64| (got / wanted - 1.0).abs() < 1e-4;
    assert!(close(known.interval, 1.959_96) && close(known.ellipse, 2.447_75) && close(known.ellipsoid, 2.795_48), "{known:?}");
    assert!(estimated.interval > known.interval && estimated.ellipse > known.ellipse && estimated.ellipsoid > known.ellipsoid);
    let [long, middle, short] = ellipsoid_semi_axes([3.0, 1.0, 2.0], [0.0; 3]);
    assert!(long >= middle && middle >= short);
}

/// A small block that GNSS positions and control points place, with the true σ₀.
fn placed() -> (Block, AdjustmentOptions) {
    let flight = BlockFlight {
        strips: 2,
        exposures: 4,
        points_per_image: 20.0,
        receiver_m: 0.05,
        control_points: 5,
        ..BlockPreset::Network.flight()
    };
    let block = simulate_network(&flight).unwrap().observed;
    (block, AdjustmentOptions { datum: Datum::GnssAndControl, sigma0_px: Some(flight.noise_px), ..squares() })
}

/// Small enough for the adjustment to be linear, in detectable errors.
const PART: f64 = 0.05;

/// The largest change of a coordinate of a centre or point in its standard errors, for a change of `PART` of a detectable error.
fn largest_change(before: &AdjustmentResult, after: &AdjustmentResult) -> f64 {
    let ratio =
        |own: [f64; 3], other: [f64; 3], errors: [f64; 3]| (0..3).map(|k| (other[k] - own[k]).abs() / errors[k]).fold(0.0, f64::max);
    let images = before.images.iter().zip(&before.block.images).zip(&after.block.images);
    let centres =
        images.map(|((statistics, own), other)| ratio(own.pose.position, other.pose.position, statistics.position_errors.unwrap()));
    let points = before.points.iter().zip(&before.block.points).zip(&after.block.points);
    let points = points.filter_map(|((statistics, own), other)| Some(ratio(*own, *other, statistics.as_ref()?.errors?)));
    centres.chain(points).fold(0.0, f64::max) / PART
}

#[test]
fn an_undetected_error_does_what_external_reliability_says() {
    let (block, options) = placed();
    let before = adjust_block(&block, &options).unwrap();
    let mut reached: f64 = 0.0;
    let mut check = |changed: Block, influence: f64, moved: &dyn Fn(&AdjustmentResult) -> f64, told: f64| {
        let after = adjust_block(&changed, &options).unwrap();
        let got = moved(&after) / PART;
        assert!((got / told - 1.0).abs() < 0.02, "{got} for {told}");
        let most = largest_change(&before, &after);
        assert!(most <= 1.01 * influence, "{most} of {influence}");
        reached = reached.max(most / influence);
    };
    let distance = |a: [f64; 3], b: [f64; 3]| minus(a, b).iter().map(|d| d * d).sum::<f64>().sqrt();
    // Rays of tie points and, the last ones, of control points.
    let of_control = block.rays.iter().position(|ray| ray.point == block.control[0].point).unwrap();
    for ray in [0, 17, 60, of_control] {
        let statistics = &before.rays[ray];
        let mut changed = block.clone();
        changed.rays[ray].x_px += PART * statistics.detectable_px[0].unwrap();
        let point = block.rays[ray].point;
        let moved = |after: &AdjustmentResult| distance(after.block.points[point], before.block.points[point]);
        check(changed, statistics.influence[0].unwrap(), &moved, statistics.moves_point[0].unwrap());
    }
    for image in [0, 5] {
        let statistics = before.images[image].gnss.unwrap();
        for axis in [0, 2] {
            let mut changed = block.clone();
            changed.images[image].gnss.as_mut().unwrap().position[axis] += PART * statistics.detectable[axis].unwrap();
            let moved = |after: &AdjustmentResult| {
                (after.block.images[image].pose.position[axis] - before.block.images[image].pose.position[axis]).abs()
            };
            check(changed, statistics.influence[axis].unwrap(), &moved, statistics.moves[axis].unwrap());
        }
    }
    for control in [0, 3] {
        let statistics = before.control[control].unwrap();
        for axis in [1, 2] {
            let mut changed = block.clone();
            changed.control[control].position[axis] += PART * statistics.detectable[axis].unwrap();
            let point = block.control[control].point;
            let moved = |after: &AdjustmentResult| (after.block.points[point][axis] - before.block.points[point][axis]).abs();
            check(changed, statistics.influence[axis].unwrap(), &moved, statistics.moves[axis].unwrap());
        }
    }
    // The bound is nearly reached: by the coordinate itself where that is observed.
    assert!(reached > 0.9, "{reached}");
}

#[test]
fn influence_is_the_shift_by_the_share_that_does_not_show() {
    let (block, options) = placed();
    let result = adjust_block(&block, &options).unwrap();
    for ray in &result.rays {
        for k in 0..2 {
            let (r, influence) = (ray.redundancy.unwrap()[k], ray.influence[k].unwrap());
            assert!((influence / (4.132_148 * ((1.0 - r) / r).sqrt()) - 1.0).abs() < 1e-5);
        }
    }
    // Where a point of a free network lies is a matter of its inner constraints.
    let free = adjust_block(&block, &squares()).unwrap();
    assert!(free.rays.iter().all(|ray| ray.moves_point == [None; 2] && ray.influence.iter().all(Option::is_some)));
}
