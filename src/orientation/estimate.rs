//! The relative orientation of observations of some weights, before its precision is described.

use super::adjusted::Adjusted;
use super::adjustment::{SETTLED, adjust};
use super::condition::Condition;
use super::coplanarity::{Ray, RelativePose};
use super::determinant::{adjust_determinants, implied_weights, with_precision};
use super::identical::Different;
use super::observed::{Limits, Weighted};
use super::precision::check_describable;
use super::refusal::{check_geometry, check_input, check_result, near_vertical};
use super::rejection::{Clean, adjust_without_gross_errors};
use super::reliability::parallax_mm;
use super::robust_start::{Consensus, median_parallax, robust_start};
use super::weighting::reweight;
use super::{Observation, OrientationMethod, OrientationOptions};
use crate::math::variance_left;
use crate::{Cause, Error};

/// A relative orientation with the observations that it was estimated from, the different ones of all.
#[derive(Debug)]
pub(crate) struct Estimate {
    pub(super) different: Different,
    pub(super) rays: Vec<Ray>,
    pub(super) weights: Vec<f64>,
    pub(super) focal_mm: f64,
    pub(super) options: OrientationOptions,
    resolution_mm: f64,
    /// What most observations agree with; the weights do not change it. Absent where gross errors are not looked for.
    start: Option<Consensus>,
    pub(super) adjusted: Adjusted,
    pub(super) accepted: Vec<bool>,
    /// How many points were left out behind a camera.
    pub(super) behind: usize,
    /// The weights of all in the normal equations.
    pub(super) solved: Vec<f64>,
    /// What robust weighting made of the weights of the accepted observations.
    pub(super) factors: Vec<f64>,
}

impl Estimate {
    /// `resolution_mm`: as of [`ErrorModel`](super::ErrorModel).
    ///
    /// # Errors
    /// As [`orient_relative`](super::orient_relative).
    pub fn of(observations: &[Observation], resolution_mm: f64, focal_mm: f64, options: &OrientationOptions) -> Result<Self, Error> {
        options.check()?;
        check_input(observations, focal_mm)?;
        let different = Different::of(observations);
        let firsts = observations.iter().zip(&different.is_first).filter(|(_, first)| **first).map(|(o, _)| o);
        let rays: Vec<Ray> = firsts.map(|o| [o.left[0], o.left[1], o.right[0], o.right[1]].map(|v| v / focal_mm)).collect();
        let weights = different.weights(observations.iter().map(|o| o.weight));
        check_geometry(&rays)?;
        let start = options.robust.then(|| robust_start(&rays, options.seed));
        let adjusted = Adjustment::of(Weighted { rays: &rays, weights: &weights }, start.as_ref(), resolution_mm, focal_mm, options)?;
        let Adjustment { adjusted, accepted, behind, solved, factors } = adjusted;
        let options = options.clone();
        Ok(Self { different, rays, weights, focal_mm, options, resolution_mm, start, adjusted, accepted, behind, solved, factors })
    }

    /// The same observations with other weights, above 0, one for each of all.
    ///
    /// # Errors
    /// As [`orient_relative`](super::orient_relative).
    pub fn reweighted(self, weights: &[f64]) -> Result<Self, Error> {
        let weights = self.different.weights(weights.iter().copied());
        let observed = Weighted { rays: &self.rays, weights: &weights };
        let adjusted = Adjustment::of(observed, self.start.as_ref(), self.resolution_mm, self.focal_mm, &self.options)?;
        let Adjustment { adjusted, accepted, behind, solved, factors } = adjusted;
        Ok(Self { weights, adjusted, accepted, behind, solved, factors, ..self })
    }

    /// σ₀ in mm of the accepted observations; `None` without redundancy.
    pub fn sigma0_mm(&self) -> Option<f64> {
        let accepted = self.accepted.iter().filter(|accepted| **accepted).count();
        (accepted > 5).then_some(self.adjusted.sigma * self.focal_mm)
    }

    /// Residual y-parallaxes in mm of all observations; `None` of one that says nothing.
    pub fn parallaxes_mm(&self) -> Vec<Option<f64>> {
        let conditions = Condition::all(&self.adjusted.pose, &self.rays);
        let parallax = |one: &Condition| one.line.map(|line| parallax_mm(one.distance, &line, self.focal_mm));
        self.different.spread(&conditions.iter().map(parallax).collect::<Vec<_>>())
    }
}

/// What comes of observations of some weights.
struct Adjustment {
    adjusted: Adjusted,
    accepted: Vec<bool>,
    behind: usize,
    solved: Vec<f64>,
    factors: Vec<f64>,
}

impl Adjustment {
    fn of(
        observed: Weighted<'_>,
        start: Option<&Consensus>,
        resolution_mm: f64,
        focal_mm: f64,
        options: &OrientationOptions,
    ) -> Result<Self, Error> {
        let clean = start.map_or_else(|| plain(observed, options), |start| robust(observed, start, resolution_mm, focal_mm, options))?;
        let Clean { mut adjusted, accepted, behind } = clean;
        let (kept, kept_weights) = observed.kept(&accepted);
        face_the_points(&mut adjusted, &kept);
        check_result(&adjusted, &kept)?;
        check_describable(&adjusted.pose)?;
        let (solved, (adjusted, factors)) = match options.method {
            OrientationMethod::Rigorous => {
                let sigma = options.sigma0_mm.map_or(adjusted.sigma, |sigma0_mm| sigma0_mm / focal_mm);
                (observed.weights.to_vec(), reweight(&kept, &kept_weights, adjusted, sigma, options.weighting)?)
            }
            OrientationMethod::Determinant => {
                let solved = implied_weights(&adjusted.pose, observed.rays, &accepted);
                (solved, (adjusted, vec![1.0; kept.len()]))
            }
        };
        Ok(Self { adjusted, accepted, behind, solved, factors })
    }
}

fn robust(
    observed: Weighted<'_>,
    start: &Consensus,
    resolution_mm: f64,
    focal_mm: f64,
    options: &OrientationOptions,
) -> Result<Clean, Error> {
    let limits = Limits {
        alpha0: options.alpha0,
        known_sigma: options.sigma0_mm.map(|sigma0_mm| sigma0_mm / focal_mm),
        resolution: resolution_mm / focal_mm,
    };
    let mut clean = adjust_without_gross_errors(observed, start, limits)?;
    if options.method == OrientationMethod::Determinant {
        clean.adjusted = by_determinants(observed.rays, &clean.accepted, clean.adjusted.pose, |_| Ok(()))?;
    }
    let kept = clean.accepted.iter().filter(|kept| **kept).count();
    let freedom = kept.saturating_sub(5);
    let left = variance_left(kept, freedom, clean.beyond(), limits.share_beyond(clean.adjusted.sigma, freedom));
    clean.adjusted.variance_left = left;
    clean.adjusted.sigma /= left.sqrt();
    // The estimate itself loses as much: least squares of those within the cut, repeated until it settles, has this much of the variance that
    // least squares of all of them would have.
    clean.adjusted.precision /= left;
    clean.adjusted.sensitivity /= left;
    Ok(clean)
}

fn plain(observed: Weighted<'_>, options: &OrientationOptions) -> Result<Clean, Error> {
    let start = RelativePose::vertical(median_parallax(observed.rays));
    let accepted = vec![true; observed.rays.len()];
    let adjusted = match options.method {
        OrientationMethod::Rigorous => adjust(observed.rays, observed.weights, start, SETTLED, near_vertical)?,
        OrientationMethod::Determinant => by_determinants(observed.rays, &accepted, start, near_vertical)?,
    };
    Ok(Clean { adjusted, accepted, behind: 0 })
}

/// Adjusts the determinants of the accepted observations, with the precision of what these estimate.
fn by_determinants(
    rays: &[Ray],
    accepted: &[bool],
    start: RelativePose,
    bounds: impl Fn(&RelativePose) -> Result<(), Cause>,
) -> Result<Adjusted, Error> {
    let kept: Vec<Ray> = rays.iter().zip(accepted).filter(|(_, kept)| **kept).map(|(ray, _)| *ray).collect();
    let adjusted = adjust_determinants(&kept, start, bounds)?;
    let weights = implied_weights(&adjusted.pose, &kept, &vec![true; kept.len()]);
    with_precision(adjusted, &kept, &weights)
}

/// Coplanarity does not know the direction of the base: it is the one that has the points in front of the cameras.
fn face_the_points(adjusted: &mut Adjusted, rays: &[Ray]) {
    let (mut in_front, mut reversed) = (0, 0);
    for [own, other] in rays.iter().map(|ray| adjusted.pose.in_front_of_either(ray, 0.0)) {
        in_front += usize::from(own);
        reversed += usize::from(other);
    }
    if reversed > in_front {
        adjusted.reverse_base();
    }
}
