//! What a plane leaves open: how well its projective map fits the observations, and how well the other pose does that it allows.

use super::adjustment::{SETTLED, adjust};
use super::coplanarity::{Ray, RelativePose};
use super::observed::Weighted;
use super::plane_pose::poses_of_plane;
use super::result::Warning;
use crate::math::median;
use nalgebra::{Matrix3, SMatrix, SVector, Vector3};

/// Below this, in focal lengths, deviations from a plane are rounding: a hundred-thousandth of a pixel.
const LEAST_SIGMA: f64 = 1e-9;
/// Fewer points than this do not tell a plane from anything else.
const LEAST_POINTS: usize = 10;
/// The map of a plane fits to one standard error. From this misfit on, points off the plane tell its poses apart whatever their number.
const LARGEST_MISFIT: f64 = 1.6;
/// Standard errors beyond which the variances that two poses leave are different: one in a thousand.
const DIFFERENT: f64 = 3.09;
/// What errors that matches share may do to the ratio of the variances, whatever the number of points.
const SHARED: f64 = 0.05;
/// Poses nearer to each other than this, in radians, are one.
const APART: f64 = 1e-4;

/// How far the right points lie from where a map takes the left ones.
pub(super) struct PlaneFit {
    map: Matrix3<f64>,
    /// The median distance by that which noise alone has.
    pub misfit: f64,
}

impl PlaneFit {
    /// The best projective map of a plane, for coordinates of the standard error `sigma`. `None` for few points, or without a map.
    ///
    /// # Source
    /// Hartley & Zisserman 2004, Multiple View Geometry, 4.1 (direct linear transformation, normalised).
    pub(super) fn of(rays: &[Ray], sigma: f64) -> Option<Self> {
        if rays.len() < LEAST_POINTS {
            return None;
        }
        let map = map_of_plane(rays)?;
        // Coordinates without any error still have rounding, which the map amplifies.
        let sigma = sigma.max(LEAST_SIGMA);
        let distance = |ray: &Ray| {
            let q = map * Vector3::new(ray[0], ray[1], 1.0);
            let (dx, dy) = (ray[2] - q.x / q.z, ray[3] - q.y / q.z);
            (dx * dx + dy * dy).sqrt()
        };
        // Both images' noise: √2 σ in each of two directions, of which the median length is 1.177 times as long.
        let middle = median(&mut rays.iter().map(distance).collect::<Vec<_>>())?;
        let misfit = middle / (std::f64::consts::SQRT_2 * 1.177_41 * sigma);
        misfit.is_finite().then_some(Self { map, misfit })
    }

    /// The warning that the other pose of the plane fits nearly as well as one that leaves the standard error `sigma`.
    pub(super) fn warning(&self, observed: Weighted<'_>, pose: &RelativePose, sigma: f64) -> Option<Warning> {
        if self.misfit >= LARGEST_MISFIT {
            return None;
        }
        // Parallaxes across the lines of either pose are different parts of the noise: the ratio of their variances follows F, whose logarithm
        // is nearly normal.
        let freedom = observed.rays.len().saturating_sub(5).max(1) as f64;
        let least = (libm::exp(DIFFERENT * 2.0 / freedom.sqrt()) + SHARED).sqrt();
        let ratio = self.sigma_of_other(observed, pose)? / sigma.max(LEAST_SIGMA);
        (ratio < least).then_some(Warning::Plane { ratio, least })
    }

    /// The standard error of a coordinate that the other pose leaves. `None` where there is none: the camera moves along the plane's normal.
    fn sigma_of_other(&self, observed: Weighted<'_>, pose: &RelativePose) -> Option<f64> {
        // Rays have z = -1.
        let flip = Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, -1.0));
        let apart = |other: &RelativePose| (3.0 - (pose.rotation.transpose() * other.rotation).trace()).max(0.0).sqrt();
        let other = poses_of_plane(&(flip * self.map * flip)).into_iter().reduce(|a, b| if apart(&b) > apart(&a) { b } else { a })?;
        let adjusted = adjust(observed.rays, observed.weights, other, SETTLED, |_| Ok(())).ok()?;
        (apart(&adjusted.pose) > APART).then_some(adjusted.sigma)
    }
}

/// The map of homogeneous left coordinates to right ones.
fn map_of_plane(rays: &[Ray]) -> Option<Matrix3<f64>> {
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
    Some(right.try_inverse()? * Matrix3::from_row_slice(h.as_slice()) * left)
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::camera::rotation_from_angles;

    /// A pair over ground whose height changes by `relief` of the flying height, with rounding for noise.
    fn rays(pose: &RelativePose, relief: f64) -> Vec<Ray> {
        let step = |k: usize, of: usize| (k * 7919 % of) as f64 / of as f64 - 0.5;
        (0..400)
            .map(|k| {
                let ground = Vector3::new(2.0 * step(k, 97), 1.5 * step(k, 89), -1.0 + relief * step(k, 53));
                let right = pose.rotation * (ground - pose.base);
                let noise = |j: usize| 1e-4 * (step(k * 4 + j, 101) + step(k * 4 + j, 103) + step(k * 4 + j, 107));
                [
                    -ground.x / ground.z + noise(0),
                    -ground.y / ground.z + noise(1),
                    -right.x / right.z + noise(2),
                    -right.y / right.z + noise(3),
                ]
            })
            .collect()
    }

    #[test]
    fn the_other_pose_of_a_plane_fits_until_there_is_relief() {
        let pose = RelativePose { rotation: rotation_from_angles(0.02, -0.03, 0.1), base: Vector3::new(0.6, 0.05, 0.02) };
        let warning = |relief: f64| {
            let rays = rays(&pose, relief);
            let weights = vec![1.0; rays.len()];
            let adjusted = adjust(&rays, &weights, pose, SETTLED, |_| Ok(())).unwrap();
            let plane = PlaneFit::of(&rays, adjusted.sigma).unwrap();
            plane.warning(Weighted { rays: &rays, weights: &weights }, &adjusted.pose, adjusted.sigma)
        };
        assert!(matches!(warning(0.0), Some(Warning::Plane { ratio, .. }) if (0.9..1.1).contains(&ratio)), "{:?}", warning(0.0));
        assert_eq!(warning(0.1), None);
    }
}
