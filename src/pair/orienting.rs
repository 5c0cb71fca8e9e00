//! From matches and interior orientations to the relative orientation.

use super::geometry::PairInterior;
use super::self_calibration::{self, Measured};
use super::shared_parallax::{is_at_a_pixel, shared_parallax};
use super::weakness::NEIGHBOURHOOD_PX;
use crate::math::median;
use crate::orientation::{Estimate, MODES, RelativePose};
use crate::{
    Cause, Computation, Error, ErrorModel, Fit, Interior, Match, Observation, OrientationOptions, RelativeOrientation, SharedErrors,
    Warning, Weighting,
};

/// Largest standard error of a photo coordinate that matches of one scene have, in px of the left photo. They reach 0.1 to 0.4 px on the
/// simulated flights, 0.04 to 0.8 px on most real pairs, and 1.6 and 2.4 px where 12 MP are distorted and nobody calibrated them. Wrong matches
/// lie anywhere in their search window: of its 25 px by default they leave 25 / √12 / √2 = 5.1 px, and 4.0 px once the worst are rejected.
const MOST_SIGMA0_PX: f64 = 3.0;

/// Standard error of a position that was rounded to whole pixels: that of a uniform distribution of a width of 1.
const WHOLE_PIXEL_SIGMA: f64 = 0.288_675_134_594_812_9;

/// Rounds in which unknown cameras and the gross errors are told by each other.
const CALIBRATIONS: usize = 2;

/// There is no parallax where more than this share of the matches lie within this distance of the same place of both: refinement moves them by less.
const MOST_EQUAL: f64 = 0.9;
const SAME_PX: f64 = 0.05;

/// Matches of either kind, with a fit and without, whose scatter tells how precise they are: its standard error is then a tenth.
const LEAST_OF_A_KIND: usize = 50;
/// The least weight of matches without a fit: positions of features are not ten times poorer than those of windows.
const LEAST_WEIGHT: f64 = 0.01;

/// Orients the right photo from matches, weighted by the precision that least squares matching gave them. The total standard errors allow
/// for what matches share, and for the errors of cameras and interior orientations where these are known.
///
/// by and bz are in units of b, so the base must lie along the x axis rather than along y: where it does not, ω φ κ by bz are those of
/// photo axes turned by 90°, as [`RelativeOrientation::turn_deg`] tells.
///
/// # Errors
/// As [`orient_relative`](crate::orient_relative).
pub fn orient_matches(matches: &[Match], interior: &PairInterior, options: &OrientationOptions) -> Result<RelativeOrientation, Error> {
    if are_without_parallax(matches) {
        return Err(Error::Degenerate { computation: Computation::RelativeOrientation, cause: Cause::NoParallax });
    }
    let plain = orient_along_x(matches, interior, options);
    let is_across = match &plain {
        Ok(found) => found.parameters.by_mm.abs() > found.base_mm.abs(),
        Err(error) => matches!(error, Error::Degenerate { computation: Computation::ByAndBz, .. }),
    };
    if !is_across {
        return plain;
    }
    match orient_along_x(matches, &interior.turned(), options) {
        Ok(turned) => Ok(turned.turned_back()),
        Err(_) => plain,
    }
}

/// Whether nothing moves from one image to the other: then any rotation and base fit, whatever the images are and however few the matches.
fn are_without_parallax(matches: &[Match]) -> bool {
    let stays = |m: &&Match| (0..2).all(|k| (m.left_px[k] - m.right_px[k]).abs() < SAME_PX);
    let equal = matches.iter().filter(stays).count();
    !matches.is_empty() && equal as f64 > MOST_EQUAL * matches.len() as f64
}

fn orient_along_x(matches: &[Match], interior: &PairInterior, options: &OrientationOptions) -> Result<RelativeOrientation, Error> {
    let WeightedMatches { positions, weights, estimate } = WeightedMatches::of(matches, interior, options)?;
    let shared = shared_parallax(matches);
    let mut found = described_as_given(estimate, &positions, shared, interior)?;
    if self_calibration::tells_more(interior) {
        // Estimated cameras decide which matches are gross errors, and these the cameras.
        for _ in 0..CALIBRATIONS {
            found = orient_calibrated(&positions, &weights, shared, interior, &found, options)?;
        }
    }
    check_precision(&found, interior.left.pixel_mm(), options)?;
    if interior.are_scans {
        // The focal length of a metric camera is of its calibration: that the photos do not check it is nothing against it.
        found.warnings.retain(|warning| !matches!(warning, Warning::UncheckedFocal { .. }));
    }
    if !self_calibration::is_calibrated(interior) {
        // The intervals hold what is not known of the focal length.
        found.warnings.retain(|warning| !matches!(warning, Warning::FocalLength { .. } | Warning::UncheckedFocal { .. }));
    }
    Ok(found)
}

/// σ₀ in mm of all matches: least squares of the same weights from the vertical pair, without rejection and without robust weights. Cameras
/// are as given. `None` where that does not converge, and without redundancy. `turn_deg`: as of the orientation with rejection.
pub(crate) fn sigma0_of_all_mm(matches: &[Match], interior: &PairInterior, turn_deg: f64, options: &OrientationOptions) -> Option<f64> {
    let turned = (turn_deg != 0.0).then(|| interior.turned());
    let options = OrientationOptions { robust: false, weighting: Weighting::None, ..options.clone() };
    WeightedMatches::of(matches, turned.as_ref().unwrap_or(interior), &options).ok()?.estimate.sigma0_mm()
}

/// Matches with their weights, and the orientation that these give.
struct WeightedMatches {
    positions: Vec<[f64; 4]>,
    weights: Vec<f64>,
    estimate: Estimate,
}

impl WeightedMatches {
    /// # Errors
    /// As [`orient_relative`](crate::orient_relative).
    fn of(matches: &[Match], interior: &PairInterior, options: &OrientationOptions) -> Result<Self, Error> {
        let positions: Vec<[f64; 4]> = matches.iter().map(|m| [m.left_px[0], m.left_px[1], m.right_px[0], m.right_px[1]]).collect();
        let fits: Vec<Option<Fit>> = matches.iter().map(|m| m.fit).collect();
        let mut weights = match_weights(&fits);
        let mut estimate = estimated(&positions, &weights, interior, options)?;
        if let Some(weight) = weight_without_fit(&fits, &weights, &estimate) {
            weights.iter_mut().zip(&fits).filter(|(_, fit)| fit.is_none()).for_each(|(own, _)| *own = weight);
            estimate = estimate.reweighted(&weights)?;
        }
        Ok(Self { positions, weights, estimate })
    }
}

/// The weight of the matches that least squares matching did not confirm, beside those that it did: the ratio of the variances of their
/// y-parallaxes. `None` where either are too few to tell, or there is nothing to tell apart.
fn weight_without_fit(fits: &[Option<Fit>], weights: &[f64], found: &Estimate) -> Option<f64> {
    let with_fit = fits.iter().flatten().count();
    if with_fit.min(fits.len() - with_fit) < LEAST_OF_A_KIND {
        return None;
    }
    let parallaxes_mm = found.parallaxes_mm();
    let scatter = |with_fit: bool| {
        let own = fits.iter().zip(weights).zip(&parallaxes_mm).filter(|((fit, _), _)| fit.is_some() == with_fit);
        let mut sizes: Vec<f64> = own.filter_map(|((_, weight), parallax_mm)| parallax_mm.map(|v| weight.sqrt() * v.abs())).collect();
        if sizes.len() < LEAST_OF_A_KIND { None } else { median(&mut sizes) }
    };
    let (refined, coarse) = (scatter(true)?, scatter(false)?);
    let ratio = refined / coarse;
    // A ratio of nothing by nothing is no weight.
    (ratio * ratio).is_finite().then(|| (ratio * ratio).clamp(LEAST_WEIGHT, 1.0))
}

/// The orientation with the cameras that the matches tell which an earlier orientation accepted. `shared_parallax`: as of [`ErrorModel`].
fn orient_calibrated(
    positions: &[[f64; 4]],
    weights: &[f64],
    shared_parallax: [f64; MODES],
    interior: &PairInterior,
    earlier: &RelativeOrientation,
    options: &OrientationOptions,
) -> Result<RelativeOrientation, Error> {
    let mut is_accepted = vec![true; positions.len()];
    earlier.rejected.iter().for_each(|k| is_accepted[*k] = false);
    let accepted = || (0..positions.len()).filter(|k| is_accepted[*k]);
    let (kept, kept_weights): (Vec<_>, Vec<_>) = accepted().map(|k| (positions[k], weights[k])).unzip();
    let (rotation, base) = earlier.pose();
    let neighbourhood = NEIGHBOURHOOD_PX * interior.left.pixel_mm() / interior.focal_mm;
    let sigma = earlier.sigma0_mm.unwrap_or(0.0) / earlier.focal_mm;
    let (measured, pose) =
        (Measured { positions: &kept, weights: &kept_weights, sigma, shared_parallax, neighbourhood }, RelativePose { rotation, base });
    match self_calibration::calibrated(interior, &measured, pose) {
        // Cameras and shared y-parallax are estimated together: their errors depend on each other.
        Some(cameras) => {
            let errors = ErrorModel { shared: cameras.shared_errors(positions), ..ErrorModel::default() };
            let found = described(estimated(positions, weights, &cameras.interior, options)?, positions, &cameras.interior, errors)?;
            Ok(RelativeOrientation { cameras: Some(cameras.cameras()), ..found })
        }
        None => orient_as_given(positions, weights, shared_parallax, interior, options),
    }
}

/// The orientation with the cameras as they were given, whose errors count in the total standard errors.
fn orient_as_given(
    positions: &[[f64; 4]],
    weights: &[f64],
    shared_parallax: [f64; MODES],
    interior: &PairInterior,
    options: &OrientationOptions,
) -> Result<RelativeOrientation, Error> {
    described_as_given(estimated(positions, weights, interior, options)?, positions, shared_parallax, interior)
}

fn described_as_given(
    estimate: Estimate,
    positions: &[[f64; 4]],
    shared_parallax: [f64; MODES],
    interior: &PairInterior,
) -> Result<RelativeOrientation, Error> {
    let shared = self_calibration::errors_as_given(interior, positions);
    let found = described(estimate, positions, interior, ErrorModel { shared, shared_parallax, ..ErrorModel::default() })?;
    Ok(RelativeOrientation { cameras: self_calibration::cameras_as_given(interior), ..found })
}

/// The orientation with fixed cameras.
fn estimated(positions: &[[f64; 4]], weights: &[f64], interior: &PairInterior, options: &OrientationOptions) -> Result<Estimate, Error> {
    let mut observed = observations(positions, &interior.left, &interior.right);
    observed.iter_mut().zip(weights).for_each(|(observation, weight)| observation.weight = *weight);
    let resolution_mm = if positions.iter().all(|[xl, yl, xr, yr]| is_at_a_pixel([*xl, *yl]) && is_at_a_pixel([*xr, *yr])) {
        WHOLE_PIXEL_SIGMA * interior.left.pixel_mm()
    } else {
        0.0
    };
    Estimate::of(&observed, resolution_mm, interior.focal_mm, options)
}

/// `errors`: what is known of those of the cameras, and of those that matches share over the image.
fn described(
    estimate: Estimate,
    positions: &[[f64; 4]],
    interior: &PairInterior,
    errors: ErrorModel,
) -> Result<RelativeOrientation, Error> {
    estimate.described(&ErrorModel {
        shared: interior_errors(positions, interior).into_iter().chain(errors.shared).collect(),
        neighbourhood_mm: NEIGHBOURHOOD_PX * interior.left.pixel_mm(),
        ..errors
    })
}

/// Refuses an orientation with which the matches agree no better than wrong ones do.
fn check_precision(found: &RelativeOrientation, pixel_mm: f64, options: &OrientationOptions) -> Result<(), Error> {
    // Who knows a larger standard error expects a larger one.
    let most_px = options.sigma0_mm.map_or(0.0, |sigma0_mm| 2.0 * sigma0_mm / pixel_mm).max(MOST_SIGMA0_PX);
    match found.sigma0_mm.map(|sigma0_mm| sigma0_mm / pixel_mm) {
        Some(sigma0_px) if sigma0_px > most_px => {
            let cause = Cause::LargeResiduals { sigma0_px, most_px };
            Err(Error::Degenerate { computation: Computation::RelativeOrientation, cause })
        }
        _ => Ok(()),
    }
}

/// What errors of the interior orientations do to the observations: each row of either affine transformation has three parameters, which
/// act by column, row and 1 on the coordinate that the row gives. Distortion changes that by less than a hundredth.
fn interior_errors(positions: &[[f64; 4]], interior: &PairInterior) -> Vec<SharedErrors> {
    let (Some(left), Some(right)) = (interior.left.covariance, interior.right.covariance) else { return Vec::new() };
    let freedom = [interior.left.degrees_of_freedom, interior.right.degrees_of_freedom];
    let group = |coordinate: usize, covariance: [[f64; 3]; 3]| {
        let side = coordinate / 2 * 2;
        let effect = |m: &[f64; 4]| [m[side], m[side + 1], 1.0].map(|by| std::array::from_fn(|k| if k == coordinate { by } else { 0.0 }));
        SharedErrors { effects: positions.iter().map(effect).collect(), covariance, degrees_of_freedom: freedom[coordinate / 2] }
    };
    [(0, left), (1, left), (2, right), (3, right)].map(|(coordinate, covariance)| group(coordinate, covariance)).into()
}

/// Photo coordinates of matches, given as `[x_left, y_left, x_right, y_right]` in px.
pub fn observations(matches: &[[f64; 4]], left: &Interior, right: &Interior) -> Vec<Observation> {
    matches.iter().map(|[xl, yl, xr, yr]| Observation::new(left.photo_mm(*xl, *yl), right.photo_mm(*xr, *yr))).collect()
}

/// Weights of matches by the variances v of their right positions: 2 m / (m + v) with m the median variance, so that a match of median
/// precision has the weight 1; 1 for matches without a fit.
///
/// The covariance of a fit tells what noise of grey values does. The shape of the ground within the window, which it does not see, is taken
/// to be as large in the median: a weight never exceeds 2.
fn match_weights(fits: &[Option<Fit>]) -> Vec<f64> {
    let variance = |fit: &Fit| 0.5 * (fit.covariance[0] + fit.covariance[2]);
    let usable = |v: &f64| v.is_finite() && *v >= 0.0;
    let middle = median(&mut fits.iter().flatten().map(variance).filter(usable).collect::<Vec<_>>()).unwrap_or(0.0);
    let weight = |fit: &Fit| 2.0 * middle / (middle + variance(fit));
    fits.iter().map(|fit| fit.as_ref().map_or(1.0, weight)).map(|w| if w > 1e-6 { w } else { 1.0 }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_match_of_median_precision_has_the_weight_one() {
        let fit = |v: f64| Some(Fit { correlation: 0.9, covariance: [v, 0.0, v], iterations: 3 });
        assert_eq!(match_weights(&[fit(1e-4), fit(4e-4), fit(1e-2), None]), [1.6, 1.0, 2.0 * 4.0 / 104.0, 1.0]);
        assert_eq!(match_weights(&[None, None]), [1.0, 1.0]);
        assert_eq!(match_weights(&[fit(0.0), fit(f64::NAN)]), [1.0, 1.0]);
    }
}
