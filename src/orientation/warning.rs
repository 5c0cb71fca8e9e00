//! Figures that tell a weak orientation from a good one.

use super::coplanarity::Ray;
use super::normals::Matrix5;
use super::result::Warning;
use crate::math::median;
use nalgebra::{Matrix3, SMatrix, SVector, Vector3};

/// A plane's projective map fits to one standard error; noise alone seldom raises that to this.
const LEAST_MISFIT: f64 = 1.6;
/// The least spread in focal lengths: a square of a tenth of the focal length has 0.04.
const LEAST_SPREAD: f64 = 0.05;
/// A vertical pair with 60 % overlap has a condition of some hundred; a critical cylinder of many thousand.
pub(super) const LARGEST_CONDITION: f64 = 2e4;
/// The least median parallax beside a rotation, in radians: uncorrected distortion alone leaves a quarter of that.
const LEAST_PARALLAX: f64 = 0.002;
/// The same in standard errors of a coordinate; a rotation alone leaves 1.7.
const LEAST_PARALLAX_SIGMAS: f64 = 6.0;
/// Below this, in focal lengths, deviations from a plane are rounding: a hundred-thousandth of a pixel.
const LEAST_SIGMA: f64 = 1e-9;
/// Fewer points than this do not tell a plane from anything else.
const LEAST_POINTS: usize = 10;

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

/// How far the right points lie from where the best projective map of a plane takes the left ones, in standard errors `sigma` of a
/// coordinate: the median distance by that which noise alone has. `None` for few points, or without a map.
///
/// # Source
/// Hartley & Zisserman 2004, Multiple View Geometry, 4.1 (direct linear transformation, normalised).
pub(super) fn plane_misfit(rays: &[Ray], sigma: f64) -> Option<f64> {
    if rays.len() < LEAST_POINTS {
        return None;
    }
    // Coordinates without any error still have rounding, which the map amplifies.
    let sigma = sigma.max(LEAST_SIGMA);
    let (left, right) = (normalising(rays, 0), normalising(rays, 2));
    let mut normals = SMatrix::<f64, 9, 9>::zeros();
    for ray in rays {
        let p = left * Vector3::new(ray[0], ray[1], 1.0);
        let q = right * Vector3::new(ray[2], ray[3], 1.0);
        let first = SVector::<f64, 9>::from_row_slice(&[p.x, p.y, 1.0, 0.0, 0.0, 0.0, -q.x * p.x, -q.x * p.y, -q.x]);
        let second = SVector::<f64, 9>::from_row_slice(&[0.0, 0.0, 0.0, p.x, p.y, 1.0, -q.y * p.x, -q.y * p.y, -q.y]);
        normals += first * first.transpose() + second * second.transpose();
    }
    let eigen = normals.symmetric_eigen();
    let h = eigen.eigenvectors.column(eigen.eigenvalues.imin()).into_owned();
    let map = right.try_inverse()? * Matrix3::from_row_slice(h.as_slice()) * left;
    let mut distances: Vec<f64> = rays
        .iter()
        .map(|ray| {
            let q = map * Vector3::new(ray[0], ray[1], 1.0);
            let (dx, dy) = (ray[2] - q.x / q.z, ray[3] - q.y / q.z);
            (dx * dx + dy * dy).sqrt()
        })
        .collect();
    // Both images' noise: √2 σ in each of two directions, of which the median length is 1.177 times as long.
    median(&mut distances).map(|middle| middle / (std::f64::consts::SQRT_2 * 1.177_41 * sigma)).filter(|v| v.is_finite())
}

/// Takes the points of a photo to their middle and to a mean distance of √2.
fn normalising(rays: &[Ray], first: usize) -> Matrix3<f64> {
    let number = rays.len() as f64;
    let mean = |k: usize| rays.iter().map(|ray| ray[k]).sum::<f64>() / number;
    let (x, y) = (mean(first), mean(first + 1));
    let distance = |ray: &Ray| ((ray[first] - x) * (ray[first] - x) + (ray[first + 1] - y) * (ray[first + 1] - y)).sqrt();
    let scale = std::f64::consts::SQRT_2 * number / rays.iter().map(distance).sum::<f64>().max(f64::MIN_POSITIVE);
    Matrix3::new(scale, 0.0, -scale * x, 0.0, scale, -scale * y, 0.0, 0.0, 1.0)
}

/// What the figures say.
pub(super) fn warnings(condition: f64, plane_misfit: Option<f64>, spread: f64, (beside_rotation, sigma): (f64, f64)) -> Vec<Warning> {
    let least_parallax = LEAST_PARALLAX.max(LEAST_PARALLAX_SIGMAS * sigma);
    let [parallax_deg, least_deg] = [beside_rotation, least_parallax].map(f64::to_degrees);
    let plane = plane_misfit.filter(|misfit| *misfit < LEAST_MISFIT).map(|misfit| Warning::Plane { misfit, least: LEAST_MISFIT });
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
    let directions = |ray: &Ray| [Vector3::new(ray[0], ray[1], -1.0).normalize(), Vector3::new(ray[2], ray[3], -1.0).normalize()];
    let mut scatter = Matrix3::zeros();
    for ray in rays {
        let [left, right] = directions(ray);
        scatter += right * left.transpose();
    }
    let svd = scatter.svd(true, true);
    let (Some(u), Some(v_t)) = (svd.u, svd.v_t) else { return 0.0 };
    let mirror = if (u * v_t).determinant() < 0.0 { -1.0 } else { 1.0 };
    let rotation = u * Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, mirror)) * v_t;
    let angle = |ray: &Ray| {
        let [left, right] = directions(ray);
        (rotation * left).cross(&right).norm()
    };
    median(&mut rays.iter().map(angle).collect::<Vec<_>>()).unwrap_or(0.0)
}
