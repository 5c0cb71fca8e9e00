//! What errors that observations share do to the result.

use super::ErrorModel;
use super::adjusted::Adjusted;
use super::condition::Condition;
use super::coplanarity::{Ray, Unknowns};
use super::interval::EstimatedPart;
use super::normals::Matrix5;
use super::parallax_modes::{Extent, MODES};
use super::precision::derivatives;
use nalgebra::SMatrix;

/// Covariance of ω φ κ (radians), by bz (mm) that shared errors give the adjusted unknowns.
pub(super) struct SharedCovariance {
    pub total: Matrix5,
    /// Its parts by errors whose size was estimated. Both rows of an affine transformation have one σ₀, and count as if each had its own: on the
    /// y-parallax, which alone decides, one of them acts.
    pub estimated: Vec<EstimatedPart>,
}

/// By first-order propagation; `None` without any shared errors.
///
/// `rays`, their `conditions` and their `weights` in the normal equations are those of the accepted observations, `accepted` tells which of all they are.
/// `sigma`: σ₀ in focal lengths that scales the standard errors, of which the modes of the y-parallax are shares.
pub(super) fn covariance_of(
    errors: &ErrorModel,
    adjusted: &Adjusted,
    (rays, conditions, weights, accepted): (&[Ray], &[Condition], &[f64], &[bool]),
    sigma: f64,
    base_mm: f64,
    focal_mm: f64,
) -> Option<SharedCovariance> {
    if errors.shared.is_empty() && errors.shared_parallax == [0.0; MODES] {
        return None;
    }
    let to_parameters = derivatives(&adjusted.pose, base_mm) * adjusted.cofactors;
    let lines = || conditions.iter().map(|condition| condition.line);
    let (mut total, mut estimated) = (Matrix5::zeros(), Vec::new());
    for group in &errors.shared {
        let mut response = [Unknowns::zeros(); 3];
        let effects = group.effects.iter().zip(accepted).filter(|(_, kept)| **kept).map(|(effect, _)| effect);
        for ((line, weight), effect) in lines().zip(weights).zip(effects) {
            let Some(line) = line else { continue };
            for (sum, change) in response.iter_mut().zip(effect) {
                let misclosure = (0..4).map(|k| line.by_coordinates[k] * change[k] / focal_mm).sum::<f64>();
                *sum -= line.by_unknowns * (weight * misclosure);
            }
        }
        let response = SMatrix::<f64, 5, 3>::from_columns(&response.map(|sum| to_parameters * sum));
        let covariance = SMatrix::<f64, 3, 3>::from_fn(|i, j| group.covariance[i][j]);
        let part = response * covariance * response.transpose();
        total += part;
        estimated.extend(group.degrees_of_freedom.map(|freedom| (part, freedom)));
    }
    if errors.shared_parallax != [0.0; MODES] {
        let mut response = [Unknowns::zeros(); MODES];
        let extent = Extent::of(rays);
        for ((line, weight), ray) in lines().zip(weights).zip(rays) {
            let Some(line) = line else { continue };
            response.iter_mut().zip(extent.modes(ray)).for_each(|(sum, mode)| *sum -= line.by_unknowns * (weight * mode));
        }
        for (sum, deviation) in response.iter().zip(&errors.shared_parallax) {
            let effect = to_parameters * sum * (deviation * sigma);
            total += effect * effect.transpose();
        }
    }
    Some(SharedCovariance { total: (total + total.transpose()) * 0.5, estimated })
}
