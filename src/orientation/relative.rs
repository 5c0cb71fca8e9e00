//! The dependent relative orientation of the right photo: from observations to the result.

use super::adjusted::Adjusted;
use super::condition::Condition;
use super::coplanarity::Ray;
use super::estimate::Estimate;
use super::focal;
use super::identical::Different;
use super::interval::{effective_freedom, fewer, half_widths};
use super::normals::{Matrix5, correlations};
use super::observed::Weighted;
use super::other_focal::OtherFocals;
use super::plane::PlaneFit;
use super::precision::{derivatives, in_degrees, parameters, propagated, signed_base, standard_errors};
use super::reliability::{Judgement, model_point};
use super::result::{ErrorEllipse, PointStatistics, Warning};
use super::robust_start::median_parallax;
use super::shared_covariance::{self, SharedCovariance};
use super::sigma::Sigma;
use super::warning::{condition, parallax_beside_rotation, spread, warnings};
use super::{ErrorModel, Observation, OrientationMethod, OrientationOptions, RelativeOrientation, neighbours};
use crate::Error;
use crate::math::{joint_limit, median};

/// With fewer degrees of freedom the residuals are all of one size, or nearly, whatever is wrong.
const LEAST_CHECKED: usize = 3;

/// So many times as long as at photo scale, a base is beyond what any overlap allows: at the scale of the nearest ground in view, which is hardly ten
/// times as near as its median, it leaves the photos.
const LARGEST_BASE: f64 = 10.0;

/// Orients the right photo relative to the left one, which stays fixed: ω φ κ, by and bz for a given b.
///
/// photo = M·(X - X_L) with M = M3(κ)·M2(φ)·M1(ω); the left photo has M = I and X_L = 0, the right photo X_L = (b, by, bz). Points lie in
/// front of both cameras, at negative Z. Photo coordinates in mm, x right, y up, both photos of the same principal distance `focal_mm`.
///
/// The rigorous form minimises the corrections of all four coordinates (Gauss-Helmert, linearised at the adjusted coordinates); the
/// determinant form minimises the unweighted determinants of coplanarity, its σ0 being that of the determinants divided by the root mean
/// square of their gradients. Degrees of freedom: accepted observations - 5.
///
/// With `robust` the start is the consensus of minimal samples, for any rotation of the photo, and observations whose standardised residual
/// is beyond what `alpha0` allows, or whose rays meet behind a camera, are left out; in the determinant form too these are judged by the
/// rigorous residuals. Without it, all observations are adjusted from the vertical pair. The estimated σ₀ allows for what the rejection
/// has cut off its distribution.
///
/// `base_mm` gives the length of b, its sign is that of the geometry: positive where the right photo lies to the right. Absent, it is the
/// median x-parallax of the accepted observations, or the length of their median parallax where the x-parallax is below a hundredth of it.
///
/// The residuals see only what lies across the epipolar line: a match that is wrong along it has none. Over exactly flat ground two poses
/// fit; the one nearer to the vertical pair is given.
///
/// # Errors
/// [`Error::InvalidOption`]; [`Error::InvalidInput`] for coordinates or weights that are no numbers or absurd; [`Error::TooFew`] below five different
/// observations; [`Error::Degenerate`] for points on a line, photos without parallax or rotated only, a base along y or z;
/// [`Error::NotConverged`] where the iteration runs away or does not settle.
///
/// # Source
/// Kraus 2007, Photogrammetry, 2nd ed. (relative orientation); Nistér 2004 (minimal samples).
pub fn orient_relative(observations: &[Observation], focal_mm: f64, options: &OrientationOptions) -> Result<RelativeOrientation, Error> {
    orient_relative_with(observations, &ErrorModel::default(), focal_mm, options)
}

/// As [`orient_relative`], with what is known of how the errors of the observations depend on each other: it does not change the residuals,
/// but [`RelativeOrientation::total_standard_errors`].
///
/// # Errors
/// As [`orient_relative`]; those of an error model that does not fit the observations.
pub fn orient_relative_with(
    observations: &[Observation],
    errors: &ErrorModel,
    focal_mm: f64,
    options: &OrientationOptions,
) -> Result<RelativeOrientation, Error> {
    errors.check(observations.len())?;
    Estimate::of(observations, errors.resolution_mm, focal_mm, options)?.described(errors)
}

impl Estimate {
    /// The orientation with its precision and reliability.
    ///
    /// # Errors
    /// Those of an error model that does not fit the observations.
    pub fn described(self, errors: &ErrorModel) -> Result<RelativeOrientation, Error> {
        errors.check(self.different.place.len())?;
        let Self { different, rays, weights, focal_mm, options, adjusted, accepted, behind, solved, factors, .. } = self;
        let observed = Weighted { rays: &rays, weights: &weights };
        let (kept, kept_solved) = Weighted { rays: &rays, weights: &solved }.kept(&accepted);
        let conditions = Condition::all(&adjusted.pose, &rays);
        let kept_conditions: Vec<Condition> = conditions.iter().zip(&accepted).filter(|(_, kept)| **kept).map(|(one, _)| *one).collect();
        let base_mm = signed_base(&adjusted.pose, options.base_mm.unwrap_or_else(|| focal_mm * default_base(&kept)));
        let taken: Vec<bool> = different.spread(&accepted).iter().zip(&different.is_first).map(|(kept, first)| *kept && *first).collect();
        let in_normals: Vec<f64> = kept_solved.iter().zip(&factors).map(|(weight, factor)| weight * factor).collect();
        let sigma = Sigma::of(adjusted.sigma, kept.len() - 5, options.sigma0_mm.map(|sigma0_mm| sigma0_mm / focal_mm));
        let observed_kept = (&kept[..], &kept_conditions[..], &in_normals[..], &taken[..]);
        let used = sigma.used().unwrap_or(adjusted.sigma);
        let by_shared = shared_covariance::covariance_of(errors, &adjusted, observed_kept, used, base_mm, focal_mm);
        let side = errors.neighbourhood_mm / focal_mm;
        let by_groups = (side > 0.0)
            .then(|| neighbours::covariance_of(&adjusted, (&kept, &kept_conditions), &kept_solved, &factors, side, base_mm))
            .flatten();
        let outcome = Outcome { adjusted, accepted, factors, solved, sigma, by_shared, by_groups, behind, base_mm, focal_mm };
        Ok(for_all(outcome.describe((observed, &conditions), (&kept, &kept_solved), &options), &different))
    }
}

/// Of the different observations, what is said of each is said of all its copies.
fn for_all(of_different: RelativeOrientation, different: &Different) -> RelativeOrientation {
    let mut found = of_different;
    if different.copies() == 0 {
        return found;
    }
    let mut rejected = vec![false; different.number];
    found.rejected.iter().for_each(|k| rejected[*k] = true);
    let different_rejected = found.rejected.len();
    found.rejected = different.spread(&rejected).iter().enumerate().filter(|(_, rejected)| **rejected).map(|(k, _)| k).collect();
    let copies_rejected = found.rejected.len() - different_rejected;
    found.residuals_mm = different.spread(&found.residuals_mm);
    found.points = different.spread(&found.points);
    found.warnings.push(Warning::Identical { copies: different.copies(), rejected: copies_rejected });
    found
}

/// Median x-parallax in units of the focal length; where there is next to none, the length of the median parallax.
fn default_base(rays: &[Ray]) -> f64 {
    let [x, y] = median_parallax(rays);
    let length = (x * x + y * y).sqrt();
    if x.abs() >= 0.01 * length { x.abs() } else { length }
}

/// An accepted orientation, before it is described.
struct Outcome {
    adjusted: Adjusted,
    accepted: Vec<bool>,
    /// What robust weighting made of the weights of the accepted observations.
    factors: Vec<f64>,
    /// The weights of all in the normal equations, before that.
    solved: Vec<f64>,
    sigma: Sigma,
    /// How many points were left out behind a camera.
    behind: usize,
    /// Covariance of ω φ κ by bz by errors that all observations share.
    by_shared: Option<SharedCovariance>,
    /// Covariance as groups of neighbours show it, for the estimated σ.
    by_groups: Option<Matrix5>,
    base_mm: f64,
    focal_mm: f64,
}

impl Outcome {
    fn describe(
        &self,
        (observed, conditions): (Weighted<'_>, &[Condition]),
        (kept, kept_solved): (&[Ray], &[f64]),
        options: &OrientationOptions,
    ) -> RelativeOrientation {
        let (adjusted, focal_mm) = (&self.adjusted, self.focal_mm);
        let propagated = propagated(&adjusted.pose, self.base_mm, &adjusted.precision);
        let correlations = correlations(&propagated);
        let degrees_of_freedom = kept.len() - 5;
        let Sigma { estimated, given, global_test } = self.sigma;
        let (known, sigma) = (self.sigma.known(), self.sigma.used());
        let freedom = known.is_none().then_some(degrees_of_freedom);
        let noncentrality = options.noncentrality(freedom);
        let total = sigma.map(|sigma| self.total(&propagated, sigma));
        let parts = self.by_shared.as_ref().map_or(&[][..], |shared| &shared.estimated);
        let effective = total.map(|covariance| effective_freedom(&covariance, freedom, parts));
        let half_widths = total.zip(effective).map(|(covariance, effective)| half_widths(&covariance, &effective));
        let (condition, spread) = (condition(&correlations), spread(kept));
        let plane = PlaneFit::of(kept, adjusted.sigma);
        let beside_rotation = parallax_beside_rotation(kept);
        let both_poses =
            plane.as_ref().and_then(|plane| plane.warning(Weighted { rays: kept, weights: kept_solved }, &adjusted.pose, adjusted.sigma));
        let mut warnings = warnings(condition, both_poses, spread, (beside_rotation, adjusted.sigma));
        if known.is_none() && degrees_of_freedom < LEAST_CHECKED {
            warnings.push(Warning::Unchecked { observations: kept.len() });
        }
        warnings.extend(options.base_mm.and_then(|_| self.doubtful_base(kept)));
        if self.behind > 0 {
            warnings.push(Warning::Behind { points: self.behind });
        }
        if let Some((estimated, given)) = estimated.zip(given).filter(|_| self.sigma.is_contradicted()) {
            let [estimated_um, given_um] = [estimated, given].map(|sigma| 1000.0 * focal_mm * sigma);
            warnings.push(Warning::Sigma { estimated_um, given_um });
        }
        let in_normals: Vec<f64> = kept_solved.iter().zip(&self.factors).map(|(weight, factor)| weight * factor).collect();
        let misfit = half_widths
            .as_ref()
            .and_then(|widths| focal::misfit(adjusted, (kept, &in_normals), widths, (self.base_mm, condition), options.alpha0));
        let others = OtherFocals::of(adjusted, (kept, &in_normals));
        // Where both are asked for, the one that takes more from the residuals.
        let misfit = misfit.into_iter().chain(others.misfit(options.alpha0)).max_by(|a, b| a.w.abs().total_cmp(&b.w.abs()));
        warnings.extend(misfit.map(|found| Warning::FocalLength { change_percent: 100.0 * found.change, w: found.w }));
        warnings.extend(others.unchecked(condition));
        let ellipse = total.map(|c| ErrorEllipse::new(c[(3, 3)], c[(3, 4)], c[(4, 4)]));
        let cofactors: [[f64; 5]; 5] = std::array::from_fn(|i| std::array::from_fn(|j| propagated[(i, j)] / (focal_mm * focal_mm)));
        RelativeOrientation {
            parameters: parameters(&adjusted.pose, self.base_mm),
            turn_deg: 0.0,
            base_mm: self.base_mm,
            focal_mm,
            method: options.method,
            standard_errors: sigma.map(|sigma| standard_errors(&propagated, sigma)),
            total_standard_errors: total
                .filter(|_| self.by_shared.is_some() || self.by_groups.is_some())
                .map(|covariance| standard_errors(&covariance, 1.0)),
            half_widths_95: half_widths.as_ref().map(in_degrees),
            sigma0_mm: estimated.map(|sigma| sigma * focal_mm),
            sigma0_a_priori_mm: options.sigma0_mm,
            global_test,
            variance_left: Some(adjusted.variance_left),
            degrees_of_freedom,
            iterations: adjusted.iterations,
            last_step: adjusted.last_step,
            cofactors,
            correlations,
            condition,
            plane_misfit: plane.map(|plane| plane.misfit),
            spread,
            parallax_beside_rotation_mm: beside_rotation * focal_mm,
            warnings,
            base_ellipse_mm: ellipse,
            base_ellipse_95_mm: ellipse.zip(effective).map(|(ellipse, [.., by, bz])| ellipse.scaled(joint_limit(0.05, 2, fewer(by, bz)))),
            noncentrality: Some(noncentrality).filter(|shift| shift.is_finite()),
            residuals_mm: observed.rays.iter().zip(conditions).map(|(ray, condition)| correction(ray, condition, focal_mm)).collect(),
            points: self.points((observed.weights, conditions), sigma.unwrap_or(0.0), &propagated, (noncentrality, options.method)),
            rejected: self.accepted.iter().enumerate().filter(|(_, kept)| !**kept).map(|(index, _)| index).collect(),
            cameras: None,
        }
    }

    /// What speaks against a given base: the points that it leads to lie so many focal lengths away, where at photo scale they lie about one away.
    fn doubtful_base(&self, kept: &[Ray]) -> Option<Warning> {
        let depth = |ray: &Ray| model_point(&self.adjusted.pose, ray, self.base_mm).map(|[_, _, z]| -z / self.focal_mm);
        let times = median(&mut kept.iter().filter_map(depth).collect::<Vec<_>>())?;
        (times > LARGEST_BASE).then_some(Warning::DoubtfulBase { base_mm: self.base_mm, times, most: LARGEST_BASE })
    }

    /// Covariance for a σ: no less than that of independent errors, with what neighbours share and with what the interior orientations add,
    /// where these are known.
    fn total(&self, propagated: &Matrix5, sigma: f64) -> Matrix5 {
        let independent = propagated * (sigma * sigma);
        let ratio = sigma / self.adjusted.sigma.max(f64::MIN_POSITIVE);
        let own = self.by_groups.map_or(independent, |by_groups| neighbours::no_less(&independent, &(by_groups * (ratio * ratio))));
        own + self.by_shared.as_ref().map_or_else(Matrix5::zeros, |shared| shared.total)
    }

    fn points(
        &self,
        (weights, conditions): (&[f64], &[Condition]),
        sigma: f64,
        propagated: &Matrix5,
        (noncentrality, method): (f64, OrientationMethod),
    ) -> Vec<Option<PointStatistics>> {
        let Self { adjusted, base_mm, focal_mm, .. } = self;
        let judgement = Judgement {
            adjusted,
            covariance: &adjusted.precision,
            unweighted: method == OrientationMethod::Determinant,
            sigma,
            derivatives: derivatives(&adjusted.pose, *base_mm),
            propagated,
            base_mm: *base_mm,
            focal_mm: *focal_mm,
            noncentrality,
        };
        let mut factors = self.factors.iter();
        let mut factor = |accepted: bool| if accepted { *factors.next().unwrap_or(&1.0) } else { 0.0 };
        let all = conditions.iter().zip(weights).zip(&self.accepted).zip(&self.solved);
        all.map(|(((condition, weight), accepted), solved)| judgement.of(condition, *weight, factor(*accepted), *solved)).collect()
    }
}

/// The correction of an observation's coordinates, in mm.
fn correction(ray: &Ray, condition: &Condition, focal_mm: f64) -> [f64; 4] {
    std::array::from_fn(|k| (condition.at[k] - ray[k]) * focal_mm)
}
