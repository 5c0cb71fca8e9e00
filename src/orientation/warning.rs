//! Figures that tell a weak orientation from a good one.

use super::coplanarity::Ray;
use super::normals::Matrix5;
use super::result::Warning;
use crate::math::median;
use nalgebra::{Matrix3, Vector3};

/// The least spread in focal lengths: a square of a tenth of the focal length has 0.04.
const LEAST_SPREAD: f64 = 0.05;
/// A vertical pair with 60 % overlap has a condition of some hundred; a critical cylinder of many thousand.
pub(super) const LARGEST_CONDITION: f64 = 2e4;
/// The least median parallax beside a rotation, in radians: uncorrected distortion alone leaves a quarter of that.
const LEAST_PARALLAX: f64 = 0.002;
/// The same in standard errors of a coordinate; a rotation alone leaves 1.7.
const LEAST_PARALLAX_SIGMAS: f64 = 6.0;

/// Largest by smallest eigenvalue of the matrix of correlations; infinite where it is singular.
pub(super) fn condition(correlations: &[[f64; 5]; 5]) -> f64 {
    let eigenvalues = Matrix5::from_fn(|i, j| correlations[i][j]).symmetric_eigenvalues();
    let (least, most) = (eigenvalues.min(), eigenvalues.max());
    if least > 0.0 { most / least } else { f64::INFINITY }
}

/// Root mean square distance of the left points from their middle.
pub(super) fn spread(rays: &[Ray]) -> f64 {
    let number = rays.len() as f64;
    let mean = |k: usize| rays.iter().map(|ray| ray[k]).sum::<f64>() / number;
    let (x, y) = (mean(0), mean(1));
    (rays.iter().map(|ray| (ray[0] - x) * (ray[0] - x) + (ray[1] - y) * (ray[1] - y)).sum::<f64>() / number).sqrt()
}

/// What the figures say.
pub(super) fn warnings(condition: f64, plane: Option<Warning>, spread: f64, (beside_rotation, sigma): (f64, f64)) -> Vec<Warning> {
    let least_parallax = LEAST_PARALLAX.max(LEAST_PARALLAX_SIGMAS * sigma);
    let [parallax_deg, least_deg] = [beside_rotation, least_parallax].map(f64::to_degrees);
    let clustered = (spread < LEAST_SPREAD).then_some(Warning::Clustered { coverage: spread, least: LEAST_SPREAD });
    let rotation = (beside_rotation < least_parallax).then_some(Warning::Rotation { parallax_deg, least_deg });
    let conditioned = (!(condition <= LARGEST_CONDITION)).then_some(Warning::IllConditioned { condition, most: LARGEST_CONDITION });
    [plane, clustered, rotation, conditioned].into_iter().flatten().collect()
}

/// Median parallax that the best rotation leaves, in radians: what of the images' difference only a base explains.
///
/// # Source
/// Kabsch 1976, A solution for the best rotation to relate two sets of vectors.
pub(super) fn parallax_beside_rotation(rays: &[Ray]) -> f64 {
    let direction = |x: f64, y: f64| Vector3::new(x, y, -1.0).normalize();
    let directions: Vec<[Vector3<f64>; 2]> = rays.iter().map(|&[xl, yl, xr, yr]| [direction(xl, yl), direction(xr, yr)]).collect();
    let mut scatter = Matrix3::zeros();
    for [left, right] in &directions {
        scatter += right * left.transpose();
    }
    let svd = scatter.svd(true, true);
    let (Some(u), Some(v_t)) = (svd.u, svd.v_t) else { return 0.0 };
    let mirror = if (u * v_t).determinant() < 0.0 { -1.0 } else { 1.0 };
    let rotation = u * Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, mirror)) * v_t;
    let angles = directions.iter().map(|[left, right]| (rotation * left).cross(right).norm());
    median(&mut angles.collect::<Vec<_>>()).unwrap_or(0.0)
}
