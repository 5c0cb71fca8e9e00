//! The focal length that matches determine, where the principal points are known and it is the same in both images.

use super::frame::{Frame, View};
use super::refine::refined;
use super::result::FocalEstimate;
use super::rotation::Turn;
use super::scale::NoiseLimits;
use super::transfer::square_transfer;
use crate::camera::nearest_rotation;
use crate::math::Candidate;
use crate::orientation::{Field, Poses, Ray, RelativePose, square_distance};
use nalgebra::Matrix3;

/// Shortest and longest focal length, in units of [`corner_px`]: 112° to 9.5° of the diagonal.
const RANGE: [f64; 2] = [0.67, 12.0];
/// Focal lengths that are tried first, evenly by their logarithms.
const TRIED: usize = 25;
/// Halvings of the interval around the best of these.
const HALVINGS: usize = 12;
/// Observations that decide.
const DECIDING: usize = 400;
/// By how much Σ d²/σ² rises on either side of a focal length that is determined, at least.
const LEAST_RISE: f64 = 16.0;
/// The standard error follows from focal lengths aside of the best, at first by this share...
const WIDEST_ASIDE: f64 = 0.1;
/// ...and nearer where Σ d²/σ² rises by more than this.
const LARGEST_RISE: f64 = 30.0;
/// Largest standard error as a share of the focal length.
const LARGEST_ERROR: f64 = 0.25;
/// Standard errors beyond which a distance counts no more.
const LARGEST_DISTANCE: f64 = 4.0;

/// What is not known of a camera whose focal length is sought, as a share of [`corner_px`]: standard errors of the principal point along
/// each axis, and of the radial distortion in the corners.
const INTERIOR_ERRORS: [f64; 3] = [0.01; 3];
/// Share of these errors by which their effect is found: small enough for a straight line.
const SMALL: f64 = 0.1;

/// What matches are at one focal length.
pub(super) struct AtFocal<M> {
    pub frame: Frame,
    pub model: M,
    /// Σ d²/σ² of the deciding observations.
    cost: f64,
}

/// A model at the focal length that fits best, and that focal length where it is determined.
pub(super) struct BestFocal<M> {
    pub best: AtFocal<M>,
    pub estimate: Option<FocalEstimate>,
}

/// What is taken for granted while a focal length is tried.
struct Assumed {
    frame: Frame,
    /// That of [`corner_px`].
    corner: f64,
    /// Radial distortion in the corners, as a share of that distance.
    radial: f64,
}

impl Assumed {
    fn rays(&self, points: &[[f64; 4]]) -> Vec<Ray> {
        let mut rays = self.frame.rays(points);
        let unit = self.frame.px() / self.corner;
        if self.radial != 0.0 {
            for side in rays.iter_mut().flat_map(|ray| ray.chunks_exact_mut(2)) {
                let share = 1.0 + self.radial * unit * unit * (side[0] * side[0] + side[1] * side[1]);
                side.iter_mut().for_each(|v| *v *= share);
            }
        }
        rays
    }
}

/// Mean distance of the principal points from the corners of the rectangles about them that hold the matches: where matches reach the borders of
/// an image and the principal point is its middle, half of the diagonal. It does not depend on where positions count from.
fn corner_px(points: &[[f64; 4]], principal: &[[f64; 2]; 2]) -> f64 {
    let farthest = |axis: usize, middle: f64| points.iter().fold(0.0, |far: f64, p| far.max((p[axis] - middle).abs()));
    let distance = |side: usize| {
        let [x, y] = [0, 1].map(|axis| farthest(2 * side + axis, principal[side][axis]));
        (x * x + y * y).sqrt()
    };
    0.5 * (distance(0) + distance(1))
}

/// The best focal length by `fit`, which gives the model at one of them, from a start of its own or from the model at another one. `corner`:
/// that of [`corner_px`].
fn search<M: Copy>(
    principal: &[[f64; 2]; 2],
    corner: f64,
    fit: impl Fn(&Assumed, Option<&M>) -> Option<AtFocal<M>>,
) -> Option<BestFocal<M>> {
    // The interior orientation with these errors, as shares of the distance of the corners.
    let with_errors = |log: f64, [dx, dy, radial]: [f64; 3]| {
        let view = |[x, y]: [f64; 2]| View { centre: [x + dx * corner, y + dy * corner], unit: libm::exp(log) };
        Assumed { frame: Frame { left: view(principal[0]), right: view(principal[1]) }, corner, radial }
    };
    let frame = |log: f64| with_errors(log, [0.0; 3]);
    let (first, last) = (libm::log(RANGE[0] * corner), libm::log(RANGE[1] * corner));
    let spacing = (last - first) / (TRIED - 1) as f64;
    let cost = |at: &Option<AtFocal<M>>| at.as_ref().map_or(f64::INFINITY, |at| at.cost);
    let mut tried: Vec<Option<AtFocal<M>>> = (0..TRIED).map(|k| fit(&frame(first + spacing * k as f64), None)).collect();
    // A start of its own may end in a poor model: the neighbours' models are others, upwards and then downwards.
    let upwards = (1..TRIED).map(|k| (k, k - 1));
    for (k, neighbour) in upwards.chain((0..TRIED - 1).rev().map(|k| (k, k + 1))) {
        let Some(start) = tried[neighbour].as_ref().map(|at| at.model) else { continue };
        let again = fit(&frame(first + spacing * k as f64), Some(&start));
        if cost(&again) < cost(&tried[k]) {
            tried[k] = again;
        }
    }
    let lowest = (0..TRIED).min_by(|a, b| cost(&tried[*a]).total_cmp(&cost(&tried[*b])))?;
    let rises = cost(&tried[0]).min(cost(&tried[TRIED - 1])) > cost(&tried[lowest]) + LEAST_RISE;
    let mut log = first + spacing * lowest as f64;
    let mut best = tried.into_iter().nth(lowest)??;
    let mut step = 0.5 * spacing;
    for _ in 0..HALVINGS {
        for candidate in [log - step, log + step] {
            if let Some(found) = fit(&frame(candidate), Some(&best.model)).filter(|found| found.cost < best.cost) {
                (best, log) = (found, candidate);
            }
        }
        step *= 0.5;
    }
    // The second difference of Σ d²/σ² by the logarithm is 2 / σ² of it; near enough for a parabola, far enough for more than rounding.
    let rise = |aside: f64| {
        cost(&fit(&frame(log - aside), Some(&best.model))) + cost(&fit(&frame(log + aside), Some(&best.model))) - 2.0 * best.cost
    };
    let mut aside = WIDEST_ASIDE;
    let mut around = rise(aside);
    while around > LARGEST_RISE && aside > 1e-6 {
        aside *= 0.5;
        around = rise(aside);
    }
    // Where a parabola through three focal lengths is lowest, by these errors of the interior orientation.
    let lowest_with = |errors: [f64; 3]| {
        let [before, here, after] = [-aside, 0.0, aside].map(|step| cost(&fit(&with_errors(log + step, errors), Some(&best.model))));
        0.5 * aside * (before - after) / (before + after - 2.0 * here)
    };
    let undisturbed = lowest_with([0.0; 3]);
    let square_of_effect = |k: usize| {
        let small = std::array::from_fn(|j| if j == k { SMALL * INTERIOR_ERRORS[k] } else { 0.0 });
        let effect = (lowest_with(small) - undisturbed) / SMALL;
        effect * effect
    };
    let error = (0..INTERIOR_ERRORS.len()).fold(2.0 * aside * aside / around, |sum, k| sum + square_of_effect(k)).sqrt();
    let determined = rises && around > 0.0 && error < LARGEST_ERROR;
    let focal_px = libm::exp(log);
    let estimate = determined.then_some(FocalEstimate { focal_px, standard_error_px: error * focal_px });
    Some(BestFocal { best, estimate })
}

/// Some of many points, evenly taken.
fn deciding(points: &[[f64; 4]]) -> Vec<[f64; 4]> {
    points.iter().step_by(points.len().div_ceil(DECIDING).max(1)).copied().collect()
}

fn sum_of_squares(squares: impl Iterator<Item = f64>, sigma: f64) -> f64 {
    squares.map(|square| (square / (sigma * sigma)).min(LARGEST_DISTANCE * LARGEST_DISTANCE)).sum()
}

/// The focal length of a pair with a base. `points`: matches that agree with the fundamental matrix `fundamental_px`; `sigma_px`: their
/// standard error.
///
/// # Source
/// The search replaces the closed form of Bougnoux 1998, which fails where the optical axes meet, as they do in most pairs of photographs.
pub(super) fn of_base(
    points: &[[f64; 4]],
    principal: &[[f64; 2]; 2],
    fundamental_px: &Matrix3<f64>,
    sigma_px: f64,
) -> Option<BestFocal<RelativePose>> {
    let deciding = deciding(points);
    search(principal, corner_px(points, principal), |assumed, start: Option<&RelativePose>| {
        let frame = &assumed.frame;
        let sigma = sigma_px / frame.px();
        let field = Field::new(&assumed.rays(&deciding), 1);
        let poses = Poses { field: &field, scale: &|_| sigma };
        let start = match start {
            Some(pose) => *pose,
            None => poses.pose_in_front(&frame.fundamental_from_px(fundamental_px), 10.0 * sigma)?,
        };
        let pose = poses.settled(&Candidate { model: start, scale: 2.0 * sigma }, deciding.len()).model;
        let essential = pose.essential();
        let cost = sum_of_squares(field.rays.iter().map(|ray| square_distance(&essential, *ray)), sigma);
        Some(AtFocal { frame: *frame, model: pose, cost })
    })
}

/// The focal length of a pair from one place. `points`: matches that agree with the homography `homography_px`.
pub(super) fn of_rotation(
    points: &[[f64; 4]],
    principal: &[[f64; 2]; 2],
    homography_px: &Matrix3<f64>,
    sigma_px: f64,
) -> Option<BestFocal<Matrix3<f64>>> {
    let deciding = deciding(points);
    search(principal, corner_px(points, principal), |assumed, start: Option<&Matrix3<f64>>| {
        let frame = &assumed.frame;
        let sigma = sigma_px / frame.px();
        let field = Field::new(&assumed.rays(&deciding), 1);
        let homography = frame.homography_from_px(homography_px);
        let start = match start {
            Some(rotation) => *rotation,
            None => nearest_rotation(&(homography * homography.determinant().signum()))?,
        };
        let limits = NoiseLimits { largest_threshold: 8.0 * sigma, fixed: true };
        let found = refined(&Turn, &field, &Candidate { model: start, scale: 2.0 * sigma }, &limits, deciding.len())?;
        let cost = sum_of_squares(field.rays.iter().map(|ray| square_transfer(&found.model, ray)), sigma);
        Some(AtFocal { frame: *frame, model: found.model, cost })
    })
}
