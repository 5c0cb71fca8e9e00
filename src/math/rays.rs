//! Where rays meet.

use nalgebra::{Matrix3, Vector3};

/// Rays that make a smaller angle meet nowhere: that of two is 0.08°, as the least eigenvalue of their normal matrix has it.
const LEAST_EIGENVALUE: f64 = 1e-6;

/// The place with the least sum of squared distances from rays, each by where it begins and its direction; absent where they are parallel, or fewer than two.
pub(crate) fn nearest_to_rays(rays: impl IntoIterator<Item = ([f64; 3], [f64; 3])>) -> Option<[f64; 3]> {
    let (mut normal, mut right) = (Matrix3::<f64>::zeros(), Vector3::<f64>::zeros());
    for (from, direction) in rays {
        let along = Vector3::from(direction).normalize();
        let across = Matrix3::identity() - along * along.transpose();
        normal += across;
        right += across * Vector3::from(from);
    }
    let meet = normal.symmetric_eigenvalues().min() > LEAST_EIGENVALUE;
    normal.cholesky().filter(|_| meet).map(|normal| normal.solve(&right).into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rays_meet_where_they_are_nearest() {
        let place = nearest_to_rays([([0.0, 0.0, 1.0], [1.0, 0.0, 0.0]), ([4.0, -3.0, 3.0], [0.0, -2.0, 0.0])]).unwrap();
        assert!(place.iter().zip([4.0, 0.0, 2.0]).all(|(got, wanted)| (got - wanted).abs() < 1e-12), "{place:?}");
    }

    #[test]
    fn one_ray_meets_nothing_and_parallel_ones_nothing() {
        assert_eq!(nearest_to_rays([]), None);
        assert_eq!(nearest_to_rays([([0.0; 3], [0.0, 0.0, 1.0])]), None);
        assert_eq!(nearest_to_rays([([0.0; 3], [0.0, 0.0, 1.0]), ([5.0, 0.0, 0.0], [0.0, 1e-4, 1.0])]), None);
    }
}
