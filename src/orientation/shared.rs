//! Errors that many observations share, as those of the interior orientation: what they do to the result.

use super::adjusted::Adjusted;
use super::coplanarity::{Ray, Unknowns};
use super::normals::Matrix5;
use super::precision::derivatives;
use nalgebra::SMatrix;

/// Three causes of error that act on all observations, as the parameters of a row of an affine transformation.
#[derive(Debug, Clone, PartialEq)]
pub struct SharedErrors {
    /// For each observation the change of its `[x_left, y_left, x_right, y_right]` in mm by a unit of each cause.
    pub effects: Vec<[[f64; 4]; 3]>,
    /// Covariance of the causes.
    pub covariance: [[f64; 3]; 3],
}

/// Covariance of ω φ κ (radians), by bz (mm) that shared errors give the adjusted unknowns, by first-order propagation.
///
/// `rays` and `weights` are those of the accepted observations, `accepted` tells which of all they are.
pub(super) fn covariance_of(
    shared: &[SharedErrors],
    adjusted: &Adjusted,
    (rays, weights, accepted): (&[Ray], &[f64], &[bool]),
    base_mm: f64,
    focal_mm: f64,
) -> Matrix5 {
    let tangents = adjusted.pose.tangents();
    let to_parameters = derivatives(&adjusted.pose, base_mm) * adjusted.cofactors;
    let lines: Vec<_> = rays.iter().map(|ray| adjusted.pose.linearise(&tangents, ray, &adjusted.pose.project(ray).0)).collect();
    let mut total = Matrix5::zeros();
    for group in shared {
        let mut response = [Unknowns::zeros(); 3];
        let effects = group.effects.iter().zip(accepted).filter(|(_, kept)| **kept).map(|(effect, _)| effect);
        for ((line, weight), effect) in lines.iter().zip(weights).zip(effects) {
            let Some(line) = line else { continue };
            for (sum, change) in response.iter_mut().zip(effect) {
                let misclosure = (0..4).map(|k| line.by_coordinates[k] * change[k] / focal_mm).sum::<f64>();
                *sum -= line.by_unknowns * (weight * misclosure);
            }
        }
        let response = SMatrix::<f64, 5, 3>::from_columns(&response.map(|sum| to_parameters * sum));
        let covariance = SMatrix::<f64, 3, 3>::from_fn(|i, j| group.covariance[i][j]);
        total += response * covariance * response.transpose();
    }
    (total + total.transpose()) * 0.5
}
