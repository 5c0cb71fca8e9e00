//! The cameras of a pair as it calibrates them, and what their errors do to its observations.

use super::constants::{CAMERA, cameras_of, effects, priors, rays};
use super::measured::Measured;
use super::modes::{MODES, extent, modes};
use crate::orientation::{Ray, RelativePose};
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
    /// Largest coordinate of a ray, by which those of the modes are divided.
    pub extent: f64,
}

impl SelfCalibration {
    /// The cameras as given, with their priors alone: where the matches cannot tell more.
    pub fn of_priors(given: &PairInterior, measured: &Measured<'_>, pose: RelativePose) -> Self {
        let cameras = cameras_of(given);
        let priors = priors(given, cameras, measured.sigma);
        let covariance = DMatrix::from_diagonal(&priors.component_mul(&priors));
        let extent = extent(&rays(measured.positions, given));
        Self { interior: *given, given: *given, values: DVector::zeros(priors.len()), pose, covariance, cameras, extent }
    }

    /// What the errors of the cameras, and those that matches share, do to the observations: along the principal axes of their covariance,
    /// which are independent.
    pub fn shared_errors(&self, positions: &[[f64; 4]]) -> Vec<SharedErrors> {
        let axes = self.covariance.clone().symmetric_eigen();
        let causes: Vec<DVector<f64>> =
            axes.eigenvalues.iter().zip(axes.eigenvectors.column_iter()).map(|(variance, axis)| axis * variance.max(0.0).sqrt()).collect();
        let focal_mm = self.interior.focal_mm;
        let by_constants = effects(positions, &self.given, &self.values, self.cameras);
        let rays = rays(positions, &self.interior);
        let of = |index: usize, cause: Option<&DVector<f64>>| -> [f64; 4] {
            let Some(cause) = cause else { return [0.0; 4] };
            let modes = self.modes_across(&rays[index]);
            let effects = by_constants.iter().map(|effect| effect[index]).chain(modes);
            effects
                .zip(cause.iter())
                .fold([0.0; 4], |sum, (effect, change)| std::array::from_fn(|c| sum[c] + focal_mm * effect[c] * change))
        };
        causes
            .chunks(3)
            .map(|three| SharedErrors {
                effects: (0..positions.len()).map(|index| std::array::from_fn(|k| of(index, three.get(k)))).collect(),
                covariance: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            })
            .collect()
    }

    /// The change of the coordinates of a ray by each mode, which lies across the epipolar line.
    fn modes_across(&self, ray: &Ray) -> [[f64; 4]; MODES] {
        let across = self.pose.linearise(&self.pose.tangents(), ray, ray).map_or([0.0; 4], |line| line.by_coordinates);
        modes(ray, self.extent).map(|mode| across.map(|v| mode * v))
    }

    /// What is known of the left and the right camera now.
    pub fn cameras(&self) -> [EstimatedCamera; 2] {
        let right = if self.cameras == 1 { 0 } else { CAMERA };
        // The right photo is computed at the focal length estimated for the left one; what is told of it is in the photo coordinates that were given.
        let own = self.interior.right.scaled(libm::exp(self.values[right] - self.values[0]));
        [(&self.interior.left, 0), (&own, right)].map(|(side, first)| {
            let error = |k: usize| self.covariance[(first + k, first + k)].max(0.0).sqrt();
            let focal_mm = self.given.focal_mm * libm::exp(self.values[first]);
            EstimatedCamera {
                focal_mm,
                focal_standard_error_mm: focal_mm * error(0),
                principal_point_mm: side.principal_point_mm,
                principal_point_standard_errors_mm: [focal_mm * error(1), focal_mm * error(2)],
                k1_per_mm2: side.radial_distortion[0],
                k1_standard_error_per_mm2: error(3) / (focal_mm * focal_mm),
            }
        })
    }
}
