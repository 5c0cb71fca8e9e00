//! Errors of neighbouring points depend on each other: what that does to the result.

use super::adjustment::Adjusted;
use super::coplanarity::{Ray, Unknowns};
use super::normals::Matrix5;
use super::precision::derivatives;
use std::collections::BTreeMap;

/// Fewer groups than this tell too little of a covariance.
const LEAST_GROUPS: usize = 30;

/// Covariance of ω φ κ (radians), by bz (mm) as the residuals show it, in units of σ = 1 focal length: points in one cell of the left photo,
/// of this side in focal lengths, are taken together, so that errors which they share count as often as they occur. `None` where the
/// points lie in few cells.
///
/// `rays`, `weights` and `factors` are those of the accepted observations.
///
/// # Source
/// Liang & Zeger 1986, Longitudinal data analysis using generalized linear models (the sandwich over groups); Conley 1999, GMM estimation
/// with cross sectional dependence (groups by place).
pub(super) fn covariance_of(
    adjusted: &Adjusted,
    rays: &[Ray],
    weights: &[f64],
    factors: &[f64],
    side: f64,
    base_mm: f64,
) -> Option<Matrix5> {
    let pose = &adjusted.pose;
    let tangents = pose.tangents();
    let mut cells: BTreeMap<[i64; 2], Unknowns> = BTreeMap::new();
    for ((ray, weight), factor) in rays.iter().zip(weights).zip(factors) {
        let (at, distance) = pose.project(ray);
        let Some(line) = pose.linearise(&tangents, ray, &at) else { continue };
        let cell = [ray[0], ray[1]].map(|v| libm::floor(v / side) as i64);
        *cells.entry(cell).or_insert_with(Unknowns::zeros) += line.by_unknowns * (weight * factor * distance);
    }
    if cells.len() < LEAST_GROUPS {
        return None;
    }
    let groups = cells.len() as f64;
    let meat = cells.values().fold(Matrix5::zeros(), |sum, s| sum + s * s.transpose()) * (groups / (groups - 5.0));
    let to_parameters = derivatives(pose, base_mm) * adjusted.sensitivity;
    let covariance = to_parameters * meat * to_parameters.transpose();
    Some((covariance + covariance.transpose()) * 0.5)
}
