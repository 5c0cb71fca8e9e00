//! Which rays take part: gross errors are rejected, and so is what its place alone excludes.

use super::course::Course;
use crate::adjustment::block::BlockObservation;
use crate::adjustment::gauss_newton::{Adjusted, LEAST_SIGMA_PX};
use crate::adjustment::loss::Robust;
use crate::adjustment::options::Loss;
use crate::adjustment::reduced::Problem;
use crate::adjustment::reliability::Judged;
use crate::adjustment::result::ObservationVerdict;
use crate::adjustment::scale::{sigma_by_median, variance_left};
use crate::adjustment::statistics::judge_by;
use crate::math::{normal_median_within, weighted_median};

/// Rounds of least squares in which what was rejected may come back; rays may once more at most with the same weights, so that the
/// rounds end.
pub(super) const FREE_ROUNDS: usize = 2;

/// Cofactors of an earlier round serve as long as they tell the same σ₀ but for this share.
const ALIKE_SIGMA: f64 = 0.03;

/// Known standard errors are judged with this redundancy and more, by rays that have so much of their own.
const FEW_KNOWN: f64 = 8.0;
const LEAST_CHECKED: f64 = 0.1;

/// Image measurements beyond so many times the limit distort a block by least squares: all of one point are rejected at once, since no two of them may agree.
const WILD: f64 = 10.0;

/// Below this redundancy the median alone is no estimate.
const FEW: i64 = 20;

/// Rays whose standard error is that of weight 1, with their verdicts.
struct OwnRays {
    rays: Vec<Option<[Judged; 2]>>,
    verdicts: Vec<ObservationVerdict>,
}

impl OwnRays {
    /// The coordinates of those that take part.
    fn accepted(&self) -> impl Iterator<Item = &Judged> {
        let accepted = self.rays.iter().zip(&self.verdicts).filter(|(_, verdict)| **verdict == ObservationVerdict::Accepted);
        accepted.filter_map(|(judged, _)| judged.as_ref()).flatten()
    }

    fn redundancy(&self) -> f64 {
        self.accepted().map(|judged| judged.redundancy).sum()
    }

    /// Their standard error by least squares.
    fn sigma(&self) -> f64 {
        let squares: f64 = self.accepted().map(|j| j.standardised * j.standardised * j.redundancy).sum();
        (squares / self.redundancy()).sqrt()
    }
}

impl Course<'_> {
    /// The verdict on a ray by the place of its point alone.
    pub fn in_front(&self, ray: usize) -> ObservationVerdict {
        let ray = &self.block.rays[ray];
        let [_, _, w] = self.state.images[ray.image].to_photo(&self.state.points[ray.point]);
        if w < 0.0 { ObservationVerdict::Accepted } else { ObservationVerdict::Behind }
    }

    /// Rejects rays to points behind their images and of points that their rays do not determine; whether there were any.
    pub fn drop_impossible(&mut self, problem: &Problem<'_>, robust: Robust) -> bool {
        let before = self.verdicts.clone();
        for ray in 0..before.len() {
            if before[ray] == ObservationVerdict::Accepted {
                self.verdicts[ray] = self.in_front(ray);
            }
        }
        for point in problem.undetermined_points(&self.state, robust) {
            for sight in problem.network.of_point(point) {
                self.verdicts[sight.ray as usize] = ObservationVerdict::LostPoint;
            }
        }
        self.lose_points();
        self.verdicts != before
    }

    /// Points with fewer than two accepted rays take no part; a surveyed position that the datum uses counts as one.
    pub fn lose_points(&mut self) {
        let mut rays = vec![0_usize; self.block.points.len()];
        let accepted = |verdict: &ObservationVerdict| *verdict == ObservationVerdict::Accepted;
        for (ray, _) in self.block.rays.iter().zip(&self.verdicts).filter(|(_, v)| accepted(v)) {
            rays[ray.point] += 1;
        }
        for control in self.block.control.iter().filter(|_| self.options.datum.uses_control()) {
            rays[control.point] += 1;
        }
        for (ray, verdict) in self.block.rays.iter().zip(&mut self.verdicts) {
            if accepted(verdict) && rays[ray.point] < 2 {
                *verdict = ObservationVerdict::LostPoint;
            }
        }
    }

    /// The rays by the cofactors that an earlier round left, as long as the loss is the same; they judge σ anew. `None` where they no longer serve.
    pub fn judged_by_earlier(&mut self, problem: &Problem<'_>, adjusted: &Adjusted, loss: Loss) -> Option<Vec<Option<[Judged; 2]>>> {
        let (_, orientations) = self.orientations.as_ref().filter(|(of_loss, _)| *of_loss == loss)?;
        let judged = judge_by(orientations, problem, adjusted, &self.block, &self.verdicts);
        let sigma = self.scale(&judged.rays, adjusted, problem.redundancy());
        // Where something is hardly determined, small steps make large cofactors others.
        if (sigma - self.sigma).abs() > ALIKE_SIGMA * self.sigma {
            return None;
        }
        self.sigma = sigma;
        Some(judged.rays)
    }

    /// The standard error of a ray by which rays are judged: that of rays of which none is stated, where these are enough.
    ///
    /// Rays of a stated standard error have the weight that it gives them beside the others. Where it is stated too large their residuals are the smaller,
    /// the smaller the σ is that they are compared with: it would fall from round to round, and the others be rejected one after the other.
    pub fn scale(&self, rays: &[Option<[Judged; 2]>], adjusted: &Adjusted, redundancy: i64) -> f64 {
        let limit = self.options.limit();
        if let Some(own) = self.unstated(rays) {
            return sigma_by_median(&own.rays, &own.verdicts, self.unstated_at_start, limit);
        }
        let by_median = sigma_by_median(rays, &self.verdicts, self.rays_at_start, limit);
        // A median of a few residuals may be far too small by chance, more easily than their σ.
        if redundancy < FEW { by_median.max(adjusted.sigma) } else { by_median }
    }

    /// σ₀ by least squares of all observations, or of the rays of which none is stated, as [`scale`](Self::scale) has it.
    pub fn unit_error(&self, rays: &[Option<[Judged; 2]>], adjusted: &Adjusted) -> f64 {
        self.unstated(rays).map_or(adjusted.sigma, |own| own.sigma())
    }

    /// σ₀ by the rays alone, made consistent where the rejection has cut their residuals: a wrong control point raises it less than σ₀ of all
    /// observations. `None` where their redundancy hardly tells it.
    pub fn sigma0_of_rays(&self, rays: &[Option<[Judged; 2]>]) -> Option<f64> {
        let own = self.own(rays)?;
        let left = variance_left(&own.verdicts, own.redundancy() as usize, self.options.alpha0);
        Some(own.sigma() / left.sqrt())
    }

    /// The rays of which no standard error is stated, where there are others and these carry a σ of their own.
    fn unstated(&self, rays: &[Option<[Judged; 2]>]) -> Option<OwnRays> {
        if self.weights.has_known_rays { self.own(rays) } else { None }
    }

    /// The rays whose standard error is that of weight 1, where they carry a σ of their own: those of which none is stated, or all.
    fn own(&self, rays: &[Option<[Judged; 2]>]) -> Option<OwnRays> {
        let is_own = |ray: &BlockObservation| ray.sigma_px.is_none() || !self.weights.has_known_rays;
        let of_block = self.block.rays.iter().zip(rays.iter().zip(&self.verdicts));
        let own = of_block.filter(|(ray, _)| is_own(ray)).map(|(_, (judged, verdict))| (*judged, *verdict));
        let (rays, verdicts) = own.unzip();
        Some(OwnRays { rays, verdicts }).filter(|own| own.redundancy() >= FEW as f64)
    }

    /// Rays of a known standard error are judged by how they scatter, where that is more: it may be stated too small, as that of positions.
    fn scale_of_known(&self, rays: &[Option<[Judged; 2]>], limit: f64) -> f64 {
        let known = self.block.rays.iter().zip(rays).filter(|(ray, _)| ray.sigma_px.is_some()).filter_map(|(_, judged)| judged.as_ref());
        let mut sizes: Vec<(f64, f64)> = known
            .flat_map(|judged| judged.map(|j| (j.standardised.abs(), if j.redundancy > LEAST_CHECKED { j.redundancy } else { 0.0 })))
            .collect();
        let sigma = self.sigma.max(LEAST_SIGMA_PX);
        let freedom: f64 = sizes.iter().map(|(_, redundancy)| redundancy).sum();
        let middle = weighted_median(&mut sizes).filter(|_| freedom >= FEW_KNOWN);
        // What their weights were made with.
        let stated = self.sigma0.filter(|_| self.weights.has_known_rays).map_or(1.0, |sigma0| sigma0 / sigma);
        middle.map_or(stated, |middle| (middle / normal_median_within(limit) / sigma).max(stated))
    }

    /// Rejects the worst ray of each point that exceeds the limit, and takes back what no longer does: in the first rounds, and once more when
    /// nothing is left to reject, for what fell by errors that were found after it. Whether anything changed.
    pub fn snoop(&mut self, rays: &[Option<[Judged; 2]>], loss: Loss, calm_rounds: usize) -> bool {
        let limit = self.options.limit() * self.sigma.max(self.options.sigma0_px.unwrap_or(0.0)).max(LEAST_SIGMA_PX);
        let sizes = rays.iter().map(|judged| judged.map(|[x, y]| x.standardised.abs().max(y.standardised.abs())));
        let known = self.scale_of_known(rays, self.options.limit());
        let before = self.verdicts.clone();
        let mut worst: Vec<Option<(usize, f64)>> = vec![None; self.block.points.len()];
        let (mut fitting, mut wild) = (Vec::new(), Vec::new());
        for (ray, size) in sizes.enumerate() {
            let Some(size) = size else { continue };
            let is_known = self.block.rays[ray].sigma_px.is_some();
            let size = if is_known { size / known } else { size };
            if is_known && loss != Loss::Squares && before[ray] == ObservationVerdict::Accepted && size > WILD * limit {
                wild.push(ray);
            }
            match before[ray] {
                ObservationVerdict::Accepted if size > limit => {
                    let worst = &mut worst[self.block.rays[ray].point];
                    if worst.is_none_or(|(_, other)| size > other) {
                        *worst = Some((ray, size));
                    }
                }
                ObservationVerdict::GrossError if size <= limit => fitting.push(ray),
                _ => {}
            }
        }
        let is_last = !self.is_reconsidered && calm_rounds >= FREE_ROUNDS && worst.iter().all(Option::is_none);
        if loss == Loss::Squares && (calm_rounds < FREE_ROUNDS || is_last) {
            if is_last {
                fitting.extend(self.regained(limit, known));
                self.is_reconsidered = !fitting.is_empty();
            }
            for ray in fitting {
                self.verdicts[ray] = self.in_front(ray);
            }
        }
        worst.iter().flatten().for_each(|(ray, _)| self.verdicts[*ray] = ObservationVerdict::GrossError);
        wild.into_iter().for_each(|ray| self.verdicts[ray] = ObservationVerdict::GrossError);
        self.lose_points();
        self.verdicts != before
    }
}
