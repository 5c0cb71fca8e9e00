//! The cameras of a pair as it calibrates them, and what their errors do to its observations.

use super::causes::in_threes;
use super::constants::{CAMERA, effects, rays};
use super::decentring::decentring_errors;
use crate::orientation::{Extent, MODES, Ray, RelativePose};
use crate::pair::geometry::PairInterior;
use crate::{EstimatedCamera, SharedErrors};
use nalgebra::{DMatrix, DVector};

/// The cameras of a pair as it calibrates them.
pub struct SelfCalibration {
    pub interior: PairInterior,
    pub given: PairInterior,
    /// Of the constants and the modes.
    pub values: DVector<f64>,
    pub pose: RelativePose,
    /// Of the values: those of the left and the right camera, once where they are one camera, and of the modes.
    pub covariance: DMatrix<f64>,
    pub cameras: usize,
    /// Of the matches, for the modes.
    pub extent: Extent,
}

impl SelfCalibration {
    /// What the errors of the cameras, and those that matches share, do to the observations: along the principal axes of their covariance,
    /// which are independent.
    pub fn shared_errors(&self, positions: &[[f64; 4]]) -> Vec<SharedErrors> {
        let axes = self.covariance.clone().symmetric_eigen();
        let causes: Vec<DVector<f64>> =
            axes.eigenvalues.iter().zip(axes.eigenvectors.column_iter()).map(|(variance, axis)| axis * variance.max(0.0).sqrt()).collect();
        let focal_mm = self.interior.focal_mm;
        let by_constants = effects(positions, &self.given, &self.values, self.cameras);
        let rays = rays(positions, &self.interior);
        let of = |index: usize, cause: &DVector<f64>| -> [f64; 4] {
            let modes = self.modes_across(&rays[index]);
            let effects = by_constants.iter().map(|effect| effect[index]).chain(modes);
            effects
                .zip(cause.iter())
                .fold([0.0; 4], |sum, (effect, change)| std::array::from_fn(|c| sum[c] + focal_mm * effect[c] * change))
        };
        let mut errors = in_threes(positions.len(), causes.len(), |index, cause| of(index, &causes[cause]));
        errors.extend(decentring_errors(&self.interior, positions, self.cameras));
        errors
    }

    /// The change of the coordinates of a ray by each mode, which lies across the epipolar line.
    fn modes_across(&self, ray: &Ray) -> [[f64; 4]; MODES] {
        let across = self.pose.linearise(&self.pose.tangents(), ray, ray).map_or([0.0; 4], |line| line.by_coordinates);
        self.extent.modes(ray).map(|mode| across.map(|v| mode * v))
    }

    /// What is known of the left and the right camera now.
    pub fn cameras(&self) -> [EstimatedCamera; 2] {
        let values = self.values.rows(0, self.cameras * CAMERA);
        let errors: Vec<f64> = (0..values.len()).map(|k| self.covariance[(k, k)].max(0.0).sqrt()).collect();
        cameras_with(&self.given, &self.interior, values.as_slice(), &errors)
    }
}

/// The left and the right camera whose constants are `values` from those given and have these standard errors; `interior`: with these constants.
pub fn cameras_with(given: &PairInterior, interior: &PairInterior, values: &[f64], errors: &[f64]) -> [EstimatedCamera; 2] {
    let right = values.len() - CAMERA;
    // The right photo is computed at the focal length estimated for the left one; what is told of it is in the photo coordinates that were given.
    let own = interior.right.scaled(libm::exp(values[right] - values[0]));
    [(&interior.left, 0), (&own, right)].map(|(side, first)| {
        let focal_mm = given.focal_mm * libm::exp(values[first]);
        EstimatedCamera {
            focal_mm,
            focal_standard_error_mm: focal_mm * errors[first],
            principal_point_mm: side.principal_point_mm,
            principal_point_standard_errors_mm: [focal_mm * errors[first + 1], focal_mm * errors[first + 2]],
            k1_per_mm2: side.radial_distortion[0],
            k1_standard_error_per_mm2: errors[first + 3] / (focal_mm * focal_mm),
        }
    })
}
