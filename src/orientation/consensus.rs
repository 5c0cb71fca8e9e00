//! A start that gross errors do not carry away: the best of many poses, each from a random minimal sample of five observations.

use super::coplanarity::{Pose, Ray, Unknowns};
use super::five_point::five_point;
use super::normals::Normals;
use crate::math::{Random, median, smallest};
use nalgebra::Matrix3;

/// The pose most observations agree with, and about how well they do.
#[derive(Debug, Clone, Copy)]
pub(super) struct Consensus {
    pub pose: Pose,
    /// Standard error of a coordinate within a factor of two, in units of the focal length.
    pub scale: f64,
}

/// The share of observations beyond five that must agree; the scale is estimated from them.
const LEAST_AGREEMENT: f64 = 0.25;

/// The quantile [`LEAST_AGREEMENT`] of the distances lies at 0.32 standard errors where all observations agree, at 0.89 where 40 % do.
const QUANTILE_IN_SIGMA: f64 = 0.5;

/// Below this, distances are rounding.
const LEAST_SCALE: f64 = 1e-10;

/// Enough samples for one of five good observations with this probability of missing it...
const MISSING: f64 = 1e-3;
/// ...but never more than these: enough at 66 % gross errors.
const MAX_SAMPLES: usize = 1500;
const MIN_SAMPLES: usize = 12;

/// Finds the pose by random sampling.
///
/// The cost of a pose is Σ ln(1 + d²/s²) over all distances d from coplanarity: it grows so slowly that gross errors hardly weigh, and it
/// needs no threshold; s is estimated along the way as a low quantile of the distances of the best pose so far. A pose that beats all
/// minimal samples before it is refined by reweighted least squares over all observations. The vertical pair, refined in the same way, is
/// the first candidate, and only a clearly lower cost displaces a candidate: over flat ground two different poses fit the same
/// observations.
///
/// # Source
/// Fischler & Bolles 1981 (random samples); Chum, Matas & Kittler 2003 (local optimisation).
pub(super) fn consensus(rays: &[Ray], seed: u32) -> Consensus {
    let mut random = Random::new(seed);
    let mut order: Vec<Ray> = rays.to_vec();
    random.shuffle(&mut order);
    let field = Field::new(&order);
    let mut best = field.candidate(Pose::vertical(median_parallax(rays)), f64::INFINITY);
    let mut lowest_raw = f64::INFINITY;
    let mut needed = samples_needed(&field, &best);
    let mut drawn = 0;
    while drawn < needed {
        drawn += 1;
        let sample = random.different::<5>(order.len()).map(|index| order[index]);
        for essential in five_point(&sample).as_slice() {
            let Some(raw) = field.cost(essential, best.scale, lowest_raw) else {
                continue;
            };
            lowest_raw = raw;
            let Some(pose) = field.pose_in_front(essential, best.scale) else {
                continue;
            };
            let candidate = field.candidate(pose, best.scale);
            if field.pose_cost(&candidate.pose, candidate.scale) < field.pose_cost(&best.pose, candidate.scale) - field.margin() {
                best = candidate;
                // The scale has changed, and the costs with it.
                lowest_raw = field.cost(essential, best.scale, f64::INFINITY).unwrap_or(f64::INFINITY);
                needed = samples_needed(&field, &best);
            }
        }
    }
    best
}

/// How many of `count` observations must agree: five fit a minimal sample exactly, so the share is that of the others.
pub(super) fn least_agreement(count: usize) -> usize {
    let others = count.saturating_sub(5) as f64;
    (5 + (LEAST_AGREEMENT * others).ceil() as usize).min(count)
}

/// Median of left minus right coordinates, in x and in y.
pub(super) fn median_parallax(rays: &[Ray]) -> [f64; 2] {
    [0, 1].map(|k| median(&mut rays.iter().map(|ray| ray[k] - ray[k + 2]).collect::<Vec<_>>()).unwrap_or(0.0))
}

fn samples_needed(field: &Field, best: &Consensus) -> usize {
    let agreeing = field.distances(&best.pose.essential()).filter(|d| *d <= 3.0 * best.scale).count();
    let share = agreeing as f64 / field.rays.len() as f64;
    let all_good = share * share * share * share * share;
    if all_good >= 1.0 {
        return MIN_SAMPLES;
    }
    let needed = libm::log(MISSING) / libm::log1p(-all_good);
    (needed.ceil() as usize).clamp(MIN_SAMPLES, MAX_SAMPLES)
}

/// All observations, in random order and as columns.
struct Field<'a> {
    rays: &'a [Ray],
    columns: [Vec<f64>; 4],
}

/// Number of terms whose product stays within the range of numbers.
const BLOCK: usize = 16;
/// Largest d²/s²; its 16th power is a number.
const LARGEST_RATIO: f64 = 1e12;

impl<'a> Field<'a> {
    fn new(rays: &'a [Ray]) -> Self {
        Self { rays, columns: std::array::from_fn(|k| rays.iter().map(|ray| ray[k]).collect()) }
    }

    /// By how much a cost must be lower to count as better.
    fn margin(&self) -> f64 {
        (0.1 * self.rays.len() as f64).min(5.0)
    }

    /// Σ ln(1 + d²/s²), d the distance from coplanarity to first order; `None` as soon as it reaches `limit`.
    fn cost(&self, essential: &Matrix3<f64>, scale: f64, limit: f64) -> Option<f64> {
        let weight = 1.0 / (scale * scale);
        let mut sum = 0.0;
        let n = self.rays.len();
        for first in (0..n).step_by(BLOCK) {
            let block = first..n.min(first + BLOCK);
            let columns: [&[f64]; 4] = std::array::from_fn(|k| &self.columns[k][block.clone()]);
            let mut terms = [1.0; BLOCK];
            for (k, term) in terms.iter_mut().enumerate().take(block.len()) {
                let square = square_distance(essential, [columns[0][k], columns[1][k], columns[2][k], columns[3][k]]);
                *term = 1.0 + (square * weight).min(LARGEST_RATIO);
            }
            // The logarithm of the product is the sum of the logarithms, at a sixteenth of the price.
            sum += libm::log(terms.iter().product());
            if sum.is_nan() || sum >= limit {
                return None;
            }
        }
        Some(sum)
    }

    /// The cost of a pose; what lies behind a camera counts as a gross error.
    fn pose_cost(&self, pose: &Pose, scale: f64) -> f64 {
        let cost = self.cost(&pose.essential(), scale, f64::INFINITY).unwrap_or(f64::INFINITY);
        let behind = self.agreeing(&pose.essential(), scale).filter(|ray| !pose.in_front(ray, 5.0 * scale)).count();
        cost + behind as f64 * libm::log(101.0)
    }

    fn distances(&self, essential: &Matrix3<f64>) -> impl Iterator<Item = f64> {
        let essential = *essential;
        self.rays.iter().map(move |ray| square_distance(&essential, *ray).sqrt())
    }

    fn agreeing(&self, essential: &Matrix3<f64>, scale: f64) -> impl Iterator<Item = &Ray> {
        let (essential, limit) = (*essential, 9.0 * scale * scale);
        self.rays.iter().filter(move |ray| square_distance(&essential, **ray) <= limit)
    }

    /// Standard error of the coordinates of the observations that agree best.
    fn scale(&self, essential: &Matrix3<f64>) -> f64 {
        let mut distances: Vec<f64> = self.distances(essential).map(|d| if d.is_finite() { d } else { f64::MAX }).collect();
        let rank = least_agreement(distances.len()) - 1;
        (smallest(&mut distances, rank) / QUANTILE_IN_SIGMA).max(LEAST_SCALE)
    }

    /// Of the four poses of an essential matrix the one that has most of the agreeing points in front of both cameras.
    fn pose_in_front(&self, essential: &Matrix3<f64>, scale: f64) -> Option<Pose> {
        let agreeing: Vec<&Ray> = self.agreeing(essential, scale).take(500).collect();
        let count = |pose: &Pose| agreeing.iter().filter(|ray| pose.in_front(ray, 0.0)).count();
        let mut best: Option<(usize, Pose)> = None;
        for pose in Pose::from_essential(essential)? {
            let in_front = count(&pose);
            if best.is_none_or(|(most, _)| in_front > most) {
                best = Some((in_front, pose));
            }
        }
        best.map(|(_, pose)| pose)
    }

    /// A pose refined by reweighted least squares (weights 1 / (1 + d²/s²)), s shrinking with the distances but never above `scale`.
    fn candidate(&self, start: Pose, scale: f64) -> Consensus {
        let mut found = Consensus { pose: start, scale: self.scale(&start.essential()).min(scale) };
        for _ in 0..10 {
            let tangents = found.pose.tangents();
            let mut normals = Normals::new();
            let weight_at = 1.0 / (found.scale * found.scale);
            for line in self.rays.iter().filter_map(|ray| found.pose.linearise(&tangents, ray, ray)) {
                let weight = 1.0 / (1.0 + line.misclosure * line.misclosure * weight_at);
                normals.add(&line.by_unknowns, line.misclosure, weight);
            }
            let Ok(solution) = normals.solve() else { break };
            found.pose = found.pose.moved(&limited(&solution.step));
            found.scale = self.scale(&found.pose.essential()).min(scale);
            if solution.size < 0.1 * found.scale {
                break;
            }
        }
        found
    }
}

/// A step of at most a fifth of a radian.
fn limited(step: &Unknowns) -> Unknowns {
    step * (0.2 / step.norm()).min(1.0)
}

/// Square of the distance of a point's coordinates from coplanarity, to first order (Sampson's).
#[inline(always)]
fn square_distance(e: &Matrix3<f64>, [xl, yl, xr, yr]: Ray) -> f64 {
    let (line_x, line_y) = (e[(0, 0)] * xl + e[(0, 1)] * yl - e[(0, 2)], e[(1, 0)] * xl + e[(1, 1)] * yl - e[(1, 2)]);
    let line_z = e[(2, 0)] * xl + e[(2, 1)] * yl - e[(2, 2)];
    let (back_x, back_y) = (e[(0, 0)] * xr + e[(1, 0)] * yr - e[(2, 0)], e[(0, 1)] * xr + e[(1, 1)] * yr - e[(2, 1)]);
    let condition = xr * line_x + yr * line_y - line_z;
    condition * condition / (line_x * line_x + line_y * line_y + back_x * back_x + back_y * back_y)
}
