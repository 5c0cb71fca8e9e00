//! A start that gross errors do not carry away: the pose most observations agree with, from random minimal samples of five.

use super::coplanarity::{Ray, RelativePose, Unknowns};
use super::field::Field;
use super::five_point::five_point;
use super::in_twos::linearised;
use super::normals::Normals;
use crate::math::{BLOCK, Candidate, Problem, Search, consensus, median, smallest};
use nalgebra::Matrix3;
use std::borrow::Cow;
use std::ops::Range;

/// The pose most observations agree with, and about how well they do: the standard error of a coordinate within a factor of two, in units
/// of the focal length.
pub(crate) type Consensus = Candidate<RelativePose>;

/// The share of observations beyond five that must agree; the scale is estimated from them.
const LEAST_AGREEMENT: f64 = 0.25;

/// The quantile [`LEAST_AGREEMENT`] of the distances lies at 0.32 standard errors where all observations agree, at 0.89 where 40 % do.
const QUANTILE_IN_SIGMA: f64 = 0.5;

/// Below this, distances are rounding.
const LEAST_SCALE: f64 = 1e-10;

/// A random choice of this many observations refines a pose during the search as well as all of them would.
const REFINED_BY: usize = 500;

/// What counts for an observation behind a camera: as much as ten standard errors.
const BEHIND: f64 = 101.0;

/// Finds the pose by random sampling.
///
/// The scale is a low quantile of the distances of the best pose so far. A pose is refined by reweighted least squares. The vertical pair,
/// refined in the same way, is the first candidate, and only a clearly lower cost displaces a candidate: over flat ground two different
/// poses fit the same observations.
pub(super) fn robust_start(rays: &[Ray], seed: u32) -> Consensus {
    let field = Field::new(rays, seed);
    let poses = Poses { field: &field, scale: &quantile_scale };
    let vertical = RelativePose::vertical(median_parallax(rays));
    let start = Candidate { model: vertical, scale: f64::INFINITY };
    let first = poses.improved(&start, field.rays.len());
    let search = Search {
        seed,
        // Enough samples for one of five good observations with this probability of missing it, but never more than serve at 66 % gross errors.
        missing: 1e-3,
        least_samples: 12,
        most_samples: 1500,
        margin: (0.1 * rays.len() as f64).min(5.0),
        scale: first.scale,
    };
    let best = consensus(&poses, Some(first), &search).unwrap_or(first);
    poses.improved(&best, field.rays.len())
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

/// Standard error of the coordinates of the observations that agree best.
fn quantile_scale(distances: &mut [f64]) -> f64 {
    let rank = least_agreement(distances.len()) - 1;
    (smallest(distances, rank) / QUANTILE_IN_SIGMA).max(LEAST_SCALE)
}

/// The search for a pose.
pub(crate) struct Poses<'a> {
    pub field: &'a Field,
    /// The standard error of an observation by the distances of all.
    pub scale: &'a dyn Fn(&mut [f64]) -> f64,
}

impl Problem for Poses<'_> {
    type Model = RelativePose;
    const SAMPLE: usize = 5;

    fn count(&self) -> usize {
        self.field.rays.len()
    }

    fn drafts(&self, sample: &[usize], take: &mut dyn FnMut(Matrix3<f64>)) {
        five_point(&std::array::from_fn(|k| self.field.rays[sample[k]])).as_slice().iter().for_each(|essential| take(*essential));
    }

    fn squares(&self, draft: &Matrix3<f64>, range: Range<usize>, squares: &mut [f64; BLOCK]) {
        self.field.squares(draft, range, squares);
    }

    fn refined(&self, draft: &Matrix3<f64>, scale: f64) -> Option<Consensus> {
        let pose = self.pose_in_front(draft, scale)?;
        Some(self.improved(&Candidate { model: pose, scale }, REFINED_BY))
    }

    fn draft_of(&self, pose: &RelativePose) -> Matrix3<f64> {
        pose.essential()
    }

    /// What lies behind a camera counts as a gross error.
    fn penalty(&self, pose: &RelativePose, scale: f64) -> f64 {
        let agreeing = self.field.within(pose.essential(), 3.0 * scale);
        agreeing.filter(|ray| !pose.in_front(ray, 5.0 * scale)).count() as f64 * libm::log(BEHIND)
    }
}

impl Poses<'_> {
    /// Of the four poses of an essential matrix the one that has most of the agreeing points in front of both cameras.
    pub fn pose_in_front(&self, essential: &Matrix3<f64>, scale: f64) -> Option<RelativePose> {
        let agreeing: Vec<&Ray> = self.field.within(*essential, 3.0 * scale).take(200).collect();
        let count = |pose: &RelativePose| agreeing.iter().filter(|ray| pose.in_front(ray, 0.0)).count();
        let mut best: Option<(usize, RelativePose)> = None;
        for pose in RelativePose::from_essential(essential)? {
            let in_front = count(&pose);
            if best.is_none_or(|(most, _)| in_front > most) {
                best = Some((in_front, pose));
            }
        }
        best.map(|(_, pose)| pose)
    }

    /// A pose refined by reweighted least squares (weights 1 / (1 + d²/s²)) of the first `count` observations, s shrinking with the
    /// distances but never above that of `start`: until a step is a tenth of its standard errors, or ten steps, which serves a search.
    pub fn improved(&self, start: &Consensus, count: usize) -> Consensus {
        self.refined_until(start, count, 10, 0.1, |_, rays| Cow::Borrowed(rays))
    }

    /// As [`Self::improved`], until a step is a hundredth of its standard errors, with the conditions at the adjusted coordinates: at the
    /// observed ones their noise biases what is weakly determined.
    pub fn settled(&self, start: &Consensus, count: usize) -> Consensus {
        self.refined_until(start, count, 50, 0.01, |pose, rays| rays.iter().map(|ray| pose.nearer(ray)).collect())
    }

    fn refined_until(
        &self,
        start: &Consensus,
        count: usize,
        steps: usize,
        share: f64,
        adjusted: impl for<'r> Fn(&RelativePose, &'r [Ray]) -> Cow<'r, [Ray]>,
    ) -> Consensus {
        let scale = |pose: &RelativePose| (self.scale)(&mut self.field.distances(&pose.essential(), count)).min(start.scale);
        let rays = &self.field.rays[..count.min(self.field.rays.len())];
        let mut found = Candidate { model: start.model, scale: scale(&start.model) };
        for _ in 0..steps {
            let mut normals = Normals::new();
            let weight_at = 1.0 / (found.scale * found.scale);
            linearised(&found.model, rays, &adjusted(&found.model, rays), |_, line| {
                let Some(line) = line else { return };
                let weight = 1.0 / (1.0 + line.misclosure * line.misclosure * weight_at);
                normals.add(&line.by_unknowns, line.misclosure, weight);
            });
            let Ok(solution) = normals.solve() else { break };
            found.model = found.model.moved(&limited(&solution.step));
            found.scale = scale(&found.model);
            if solution.size < share * found.scale {
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
