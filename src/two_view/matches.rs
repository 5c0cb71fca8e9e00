//! Matches with gross errors: which of them agree with a geometry, and whether a simpler one explains these.

use super::chance::{Support, chance_of_agreeing};
use super::frame::Frame;
use super::homography::Homographies;
use super::options::TwoViewOptions;
use super::refine::{Kind, refined};
use super::result::{TwoView, TwoViewModel};
use super::scale::{Conditions, LEAST_REDUNDANCY, Noise, NoiseLimits, noise, search_scale};
use super::support::Tolerance;
use super::transfer::square_transfer;
use crate::math::{Candidate, Problem, Search, consensus};
use crate::orientation::{Field, Ray};
use crate::{Cause, Computation, Error, Few};
use nalgebra::Matrix3;

/// Of a thousand pairs without overlap, one may be told to have a geometry.
const LARGEST_LOG_FALSE_ALARMS: f64 = -6.9;
/// By how much Σ d²/σ² rises where the freedom that the map of a plane has beyond a rotation is significant.
const SIGNIFICANT: f64 = 30.0;
/// What distortion that is left adds to the residuals of a rotation, as a share of the mean distance of the points from their centre.
const DISTORTED: f64 = 0.001;
/// Standard errors beyond which a residual counts no more.
const FARTHEST: f64 = 5.0;

/// The matches, in px and as coordinates.
pub(super) struct Matches<'a> {
    pub points: &'a [[f64; 4]],
    pub options: &'a TwoViewOptions,
    pub frame: Frame,
    pub rays: Vec<Ray>,
    pub limits: NoiseLimits,
    /// Mean distance of the points from their centre, in units of coordinates.
    pub extent: f64,
    pub tolerance: Tolerance,
}

/// A geometry, and the matches that agree with it.
pub(super) struct Found<M> {
    pub model: M,
    pub noise: Noise,
    pub inliers: Vec<usize>,
}

impl<'a> Matches<'a> {
    pub fn new(points: &'a [[f64; 4]], frame: Frame, options: &'a TwoViewOptions, tolerance: Tolerance) -> Result<Self, Error> {
        let mut different = points.to_vec();
        different.sort_unstable_by(|a, b| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal));
        different.dedup();
        let needed = <Homographies as Problem>::SAMPLE + LEAST_REDUNDANCY;
        if different.len() < needed {
            return Err(Error::TooFew { few: Few::DifferentMatches, got: different.len(), needed });
        }
        let extent = Frame::normalising(points).px() / frame.px();
        Ok(Self { points, options, frame, rays: frame.rays(points), limits: options.limits(frame.px()), extent, tolerance })
    }

    pub fn field(&self) -> Field {
        Field::new(&self.rays, self.options.seed)
    }

    pub fn search(&self, most_samples: usize) -> Search {
        Search {
            seed: self.options.seed,
            missing: 1.0 - self.options.confidence,
            least_samples: 12,
            most_samples,
            margin: 1.0,
            scale: 0.5 * self.limits.largest_threshold,
        }
    }

    /// The model that most matches agree with, by as many samples as the options allow.
    pub fn best<P: Problem>(&self, problem: &P) -> Option<Candidate<P::Model>> {
        consensus(problem, None, &self.search(self.options.max_samples as usize))
    }

    /// The standard error of a coordinate by the distances of all, while a pose is searched.
    pub fn scale(&self) -> impl Fn(&mut [f64]) -> f64 {
        let limits = self.limits;
        move |distances| search_scale(distances, Conditions::One, &limits)
    }

    /// A matrix of one kind refined by all matches; as it was where they do not determine it.
    pub fn refined<const N: usize>(&self, kind: &impl Kind<N>, field: &Field, start: &Candidate<Matrix3<f64>>) -> Matrix3<f64> {
        refined(kind, field, start, &self.limits, field.rays.len()).unwrap_or(*start).model
    }

    /// Where the search starts that refines a matrix in px known from other matches.
    pub fn known<M>(&self, model: M, known: &TwoView) -> Candidate<M> {
        Candidate { model, scale: known.sigma_px / self.frame.px() }
    }

    /// The matches whose square distance is within the threshold, which follows from the distances of all.
    pub fn agreeing<M>(&self, model: M, conditions: Conditions, square: impl Fn(&Ray) -> f64) -> Found<M> {
        let distances: Vec<f64> = self.rays.iter().map(|ray| square(ray).sqrt()).collect();
        let noise = noise(&distances, conditions, &self.limits);
        let inliers = (0..distances.len()).filter(|k| distances[*k] <= noise.threshold).collect();
        Found { model, noise, inliers }
    }

    /// Some of the matches by themselves.
    pub fn only(&self, indices: &[usize]) -> Field {
        let rays: Vec<Ray> = indices.iter().map(|k| self.rays[*k]).collect();
        Field::new(&rays, self.options.seed)
    }

    pub fn points_of(&self, indices: &[usize]) -> Vec<[f64; 4]> {
        indices.iter().map(|k| self.points[*k]).collect()
    }

    /// Whether a homography (or a rotation) explains the matches that agree with a general geometry: those that deviate are no more than
    /// wrong matches along epipolar lines.
    pub fn explains<M>(&self, homography: &Matrix3<f64>, general: &Found<M>) -> bool {
        !self.tolerance.is_exceeded(&general.noise, self.off(homography, general).count())
    }

    pub fn off<'b, M>(&'b self, homography: &Matrix3<f64>, general: &'b Found<M>) -> impl Iterator<Item = usize> + use<'b, 'a, M> {
        let limit = self.tolerance.off(&general.noise, self.extent);
        let homography = *homography;
        general.inliers.iter().copied().filter(move |k| square_transfer(&homography, &self.rays[*k]) > limit * limit)
    }

    /// Whether a rotation fits the matches that agree with the map of a plane as well as that does, though it has fewer unknowns.
    pub fn is_as_good<M>(&self, rotation: &Matrix3<f64>, plane: &Matrix3<f64>, found: &Found<M>) -> bool {
        let largest = FARTHEST * FARTHEST * found.noise.sigma * found.noise.sigma;
        let sum = |map: &Matrix3<f64>| found.inliers.iter().map(|k| square_transfer(map, &self.rays[*k]).min(largest)).sum::<f64>();
        let excess = sum(rotation) - sum(plane);
        let distorted = DISTORTED * self.extent;
        excess <= SIGNIFICANT * found.noise.sigma * found.noise.sigma || excess <= found.inliers.len() as f64 * distorted * distorted
    }

    pub fn result<M>(&self, model: TwoViewModel, found: Found<M>) -> TwoView {
        let px = self.frame.px();
        TwoView {
            model,
            inliers: found.inliers,
            threshold_px: found.noise.threshold * px,
            sigma_px: found.noise.sigma * px,
            degenerate: None,
            homography: None,
            focal: None,
        }
    }

    /// Whether more matches agree than would with the best of all models if all were wrong. `models`: the most through one sample.
    pub fn is_supported<M>(&self, found: &Found<M>, sample: usize, models: usize, conditions: Conditions) -> bool {
        let chance = chance_of_agreeing(self.points, found.noise.threshold * self.frame.px(), conditions);
        let support = Support { count: self.points.len(), agreeing: found.inliers.len(), sample, models, chance };
        found.noise.is_supported(sample) && support.log_false_alarms() < LARGEST_LOG_FALSE_ALARMS
    }

    /// Refuses a geometry that came from other matches and that hardly any of these agree with. `sample`: matches of a minimal sample.
    pub fn check_known<M>(&self, found: &Found<M>, sample: usize) -> Result<(), Error> {
        if found.noise.is_supported(sample) { Ok(()) } else { Err(self.unsupported(found.inliers.len())) }
    }

    pub fn unsupported(&self, agreeing: usize) -> Error {
        Error::Degenerate { computation: Computation::TwoViewGeometry, cause: Cause::Chance { agreeing, matches: self.rays.len() } }
    }
}
