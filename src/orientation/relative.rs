//! The dependent relative orientation of the right photo: from observations to the result.

use super::adjustment::{Adjusted, adjust};
use super::consensus::{consensus, median_parallax};
use super::coplanarity::{Pose, Ray};
use super::determinant::adjust_determinants;
use super::normals::correlations;
use super::precision::{check_describable, parameters, propagated, signed_base, standard_errors};
use super::refusal::{check_geometry, check_input, check_result, near_vertical};
use super::rejection::{Clean, adjust_without_gross_errors, corrections};
use super::{Observation, OrientationMethod, OrientationOptions, RelativeOrientation};
use crate::Error;

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
/// exceeds `rejection` are left out; in the determinant form too these are judged by the rigorous residuals. Without it, all observations
/// are adjusted from the vertical pair.
///
/// `base_mm` gives the length of b, its sign is that of the geometry: positive where the right photo lies to the right. Absent, it is the
/// median x-parallax of the accepted observations, or the length of their median parallax where the x-parallax is below a hundredth of it.
///
/// The residuals see only what lies across the epipolar line: a match that is wrong along it has none. Over exactly flat ground two poses
/// fit; the one nearer to the vertical pair is given.
///
/// # Errors
/// [`Error::InvalidOption`]; [`Error::InvalidInput`] for coordinates that are no numbers or absurd; [`Error::TooFew`] below five different
/// observations; [`Error::Degenerate`] for points on a line, photos without parallax or rotated only, a base along y or z;
/// [`Error::NotConverged`] where the iteration runs away or does not settle.
///
/// # Source
/// Kraus 2007, Photogrammetry, 2nd ed. (relative orientation); Nistér 2004 (minimal samples).
pub fn orient_relative(observations: &[Observation], focal_mm: f64, options: &OrientationOptions) -> Result<RelativeOrientation, Error> {
    options.check()?;
    check_input(observations, focal_mm)?;
    let rays: Vec<Ray> = observations.iter().map(|o| [o.left[0], o.left[1], o.right[0], o.right[1]].map(|v| v / focal_mm)).collect();
    check_geometry(&rays)?;
    let Clean { mut adjusted, accepted } = if options.robust { robust(&rays, options)? } else { plain(&rays, options)? };
    let kept: Vec<Ray> = rays.iter().zip(&accepted).filter(|(_, kept)| **kept).map(|(ray, _)| *ray).collect();
    face_the_points(&mut adjusted, &kept);
    check_result(&adjusted, &kept)?;
    check_describable(&adjusted.pose)?;
    let base_mm = signed_base(&adjusted.pose, options.base_mm.unwrap_or_else(|| focal_mm * default_base(&kept)));
    Ok(describe(&adjusted, &rays, &accepted, base_mm, focal_mm, options.method))
}

fn robust(rays: &[Ray], options: &OrientationOptions) -> Result<Clean, Error> {
    let start = consensus(rays, options.seed);
    let clean = adjust_without_gross_errors(rays, &start, options.rejection)?;
    if options.method == OrientationMethod::Rigorous {
        return Ok(clean);
    }
    let kept: Vec<Ray> = rays.iter().zip(&clean.accepted).filter(|(_, kept)| **kept).map(|(ray, _)| *ray).collect();
    let adjusted = adjust_determinants(&kept, clean.adjusted.pose, |_| Ok(()))?;
    Ok(Clean { adjusted, accepted: clean.accepted })
}

fn plain(rays: &[Ray], options: &OrientationOptions) -> Result<Clean, Error> {
    let start = Pose::vertical(median_parallax(rays));
    let adjusted = match options.method {
        OrientationMethod::Rigorous => adjust(rays, start, near_vertical)?,
        OrientationMethod::Determinant => adjust_determinants(rays, start, near_vertical)?,
    };
    Ok(Clean { adjusted, accepted: vec![true; rays.len()] })
}

/// Coplanarity does not know the direction of the base: it is the one that has the points in front of the cameras.
fn face_the_points(adjusted: &mut Adjusted, rays: &[Ray]) {
    let in_front = |pose: &Pose| rays.iter().filter(|ray| pose.in_front(ray, 0.0)).count();
    let reversed = Pose { base: -adjusted.pose.base, ..adjusted.pose };
    if in_front(&reversed) > in_front(&adjusted.pose) {
        adjusted.reverse_base();
    }
}

/// Median x-parallax in units of the focal length; where there is next to none, the length of the median parallax.
fn default_base(rays: &[Ray]) -> f64 {
    let [x, y] = median_parallax(rays);
    let length = (x * x + y * y).sqrt();
    if x.abs() >= 0.01 * length { x.abs() } else { length }
}

fn describe(
    adjusted: &Adjusted,
    rays: &[Ray],
    accepted: &[bool],
    base_mm: f64,
    focal_mm: f64,
    method: OrientationMethod,
) -> RelativeOrientation {
    let cofactors = propagated(&adjusted.pose, base_mm, &adjusted.cofactors);
    let degrees_of_freedom = accepted.iter().filter(|kept| **kept).count() - 5;
    RelativeOrientation {
        parameters: parameters(&adjusted.pose, base_mm),
        base_mm,
        focal_mm,
        method,
        standard_errors: (degrees_of_freedom > 0).then(|| standard_errors(&cofactors, adjusted.sigma)),
        sigma0_mm: (degrees_of_freedom > 0).then_some(adjusted.sigma * focal_mm),
        degrees_of_freedom,
        iterations: adjusted.iterations,
        last_step: adjusted.last_step,
        correlations: correlations(&cofactors),
        residuals_mm: corrections(rays, &adjusted.pose).into_iter().map(|v| v.map(|v| v * focal_mm)).collect(),
        rejected: accepted.iter().enumerate().filter(|(_, kept)| !**kept).map(|(index, _)| index).collect(),
    }
}
