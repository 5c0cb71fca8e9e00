//! The object points of an oriented pair with their precision.

use super::result::{FiveParameters, Observation, RelativeOrientation};
use crate::camera::rotation_from_angles;
use crate::catalogue::{LENGTH, check_values};
use crate::error::refuse;
use crate::{Error, Input, Location, Refusal};
use nalgebra::{Matrix3, Matrix3x5, Matrix4x3, Matrix4x5, Matrix5, SMatrix, Vector3};

/// An object point of a pair, in the left photo's system: x and y along the photo's axes, the viewing direction is -z.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ModelPoint {
    /// X, Y, Z in the unit of the base.
    pub position: [f64; 3],
    /// Standard errors of these, those of the orientation included; absent where the orientation has none.
    pub errors: Option<[f64; 3]>,
    /// Whether the observation took part in the orientation: others are gross errors, and tell nothing of the object.
    pub accepted: bool,
}

/// The object points of an oriented pair, one for each observation; absent where its rays are parallel.
///
/// `observations` are those that were oriented. `base`: the length of the base, from projection centre to projection centre, in the unit
/// that the points shall have; 1: the base is the unit. It counts as known without error.
///
/// Errors of observations count as independent, as in [`RelativeOrientation::standard_errors`]; those that neighbouring matches share, or the
/// interior orientation has, are not in the standard errors.
///
/// # Errors
/// [`Error::InvalidInput`] for a base that is not above 0, and for another number of observations than were oriented.
///
/// # Source
/// Förstner & Wrobel 2016, Photogrammetric Computer Vision, 13.4 and 15.3: with the points' own normal equations N and their coupling C with
/// the pose, whose covariance is Q, that of a point is σ² (N⁻¹ + N⁻¹ C Q Cᵀ N⁻¹).
pub fn model_points(orientation: &RelativeOrientation, observations: &[Observation], base: f64) -> Result<Vec<Option<ModelPoint>>, Error> {
    check_values(Input::Base, &[base], LENGTH, || Location::Pair)?;
    if observations.len() != orientation.points.len() {
        return refuse(Refusal::OrientedObservations { observations: observations.len(), oriented: orientation.points.len() });
    }
    let pose = Pose::of(orientation, base);
    Ok(orientation
        .points
        .iter()
        .zip(observations)
        .map(|(point, observation)| {
            let point = point.as_ref()?;
            let accepted = point.weight > 0.0;
            let weight = if accepted { point.weight } else { observation.weight };
            let model = Vector3::from(point.model_mm?);
            Some(ModelPoint { position: (model * pose.scale).into(), errors: pose.errors(&model, weight), accepted })
        })
        .collect())
}

/// The orientation as points follow from it.
struct Pose {
    rotation: Matrix3<f64>,
    base_mm: Vector3<f64>,
    focal_mm: f64,
    /// About which ω, φ and κ turn, in the model's system.
    axes: [Vector3<f64>; 3],
    cofactors: Matrix5<f64>,
    /// Standard error of a photo coordinate of weight 1.
    sigma_mm: Option<f64>,
    /// From mm at photo scale to the unit of the base.
    scale: f64,
}

impl Pose {
    fn of(orientation: &RelativeOrientation, base: f64) -> Self {
        let FiveParameters { omega_deg, phi_deg, kappa_deg, by_mm, bz_mm } = orientation.parameters;
        let omega = omega_deg.to_radians();
        let rotation = rotation_from_angles(omega, phi_deg.to_radians(), kappa_deg.to_radians());
        let base_mm = Vector3::new(orientation.base_mm, by_mm, bz_mm);
        let cofactors = Matrix5::from_fn(|row, column| orientation.cofactors[row][column]);
        // As the standard errors have it: a priori, or estimated.
        let sigma_mm = orientation.standard_errors.map(|errors| errors.by_mm / cofactors[(3, 3)].sqrt()).filter(|sigma| sigma.is_finite());
        let axes = [Vector3::x(), Vector3::new(0.0, libm::cos(omega), libm::sin(omega)), rotation.row(2).transpose()];
        Self { rotation, base_mm, focal_mm: orientation.focal_mm, axes, cofactors, sigma_mm, scale: base / base_mm.norm() }
    }

    /// Standard errors of a point, given in mm at photo scale, in the unit of the base.
    fn errors(&self, point: &Vector3<f64>, weight: f64) -> Option<[f64; 3]> {
        let (by_point, by_pose) = self.derivatives(point);
        let own = (by_point.transpose() * by_point * weight).try_inverse()?;
        // How the point follows the pose, and the scale by by and bz, since the base is as long as it is.
        let mut follows: Matrix3x5<f64> = -own * by_point.transpose() * by_pose * weight;
        let square = self.base_mm.norm_squared();
        for (column, component) in [(3, self.base_mm.y), (4, self.base_mm.z)] {
            let shrunk = follows.column(column) - point * (component / square);
            follows.set_column(column, &shrunk);
        }
        let covariance = own + follows * self.cofactors * follows.transpose();
        let sigma = self.sigma_mm? * self.scale;
        Some([0, 1, 2].map(|k| sigma * covariance[(k, k)].max(0.0).sqrt())).filter(|errors| errors.iter().all(|error| error.is_finite()))
    }

    /// Derivatives of the photo coordinates, left and right, by the point and by ω φ κ by bz.
    fn derivatives(&self, point: &Vector3<f64>) -> (Matrix4x3<f64>, Matrix4x5<f64>) {
        let from_right = point - self.base_mm;
        let (left, right) = (self.perspective(point), self.perspective(&(self.rotation * from_right)));
        let by_right = right * self.rotation;
        let mut by_point = Matrix4x3::zeros();
        by_point.fixed_rows_mut::<2>(0).copy_from(&left);
        by_point.fixed_rows_mut::<2>(2).copy_from(&by_right);
        let mut by_pose = Matrix4x5::zeros();
        for (column, axis) in self.axes.iter().enumerate() {
            by_pose.fixed_view_mut::<2, 1>(2, column).copy_from(&(-by_right * axis.cross(&from_right)));
        }
        for (column, axis) in [(3, 1), (4, 2)] {
            by_pose.fixed_view_mut::<2, 1>(2, column).copy_from(&-by_right.column(axis));
        }
        (by_point, by_pose)
    }

    /// Derivatives of x = -f u/w, y = -f v/w by u, v, w.
    fn perspective(&self, seen: &Vector3<f64>) -> SMatrix<f64, 2, 3> {
        let (f, w) = (self.focal_mm, seen.z);
        SMatrix::<f64, 2, 3>::new(-f / w, 0.0, f * seen.x / (w * w), 0.0, -f / w, f * seen.y / (w * w))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector4;

    #[test]
    fn derivatives_are_those_of_small_differences() {
        let pose = |p: [f64; 5]| {
            let rotation = rotation_from_angles(p[0], p[1], p[2]);
            let axes = [Vector3::x(), Vector3::new(0.0, libm::cos(p[0]), libm::sin(p[0])), rotation.row(2).transpose()];
            let base_mm = Vector3::new(90.0, p[3], p[4]);
            Pose { rotation, base_mm, focal_mm: 150.0, axes, cofactors: Matrix5::identity(), sigma_mm: None, scale: 1.0 }
        };
        let at = |p: [f64; 5], point: &Vector3<f64>| {
            let pose = pose(p);
            let seen = pose.rotation * (point - pose.base_mm);
            Vector4::new(point.x / point.z, point.y / point.z, seen.x / seen.z, seen.y / seen.z) * -pose.focal_mm
        };
        let (p, point) = ([0.2, -0.3, 1.4, 5.0, -3.0], Vector3::new(40.0, -20.0, -160.0));
        let (by_point, by_pose) = pose(p).derivatives(&point);
        let h = 1e-6;
        for k in 0..5 {
            let moved = |sign: f64| std::array::from_fn(|i| if i == k { p[i] + sign * h } else { p[i] });
            let numeric = (at(moved(1.0), &point) - at(moved(-1.0), &point)) / (2.0 * h);
            assert!((by_pose.column(k) - numeric).norm() < 1e-5, "{k}: {} {numeric}", by_pose.column(k));
        }
        for k in 0..3 {
            let step = Vector3::from_fn(|i, _| if i == k { h } else { 0.0 });
            let numeric = (at(p, &(point + step)) - at(p, &(point - step))) / (2.0 * h);
            assert!((by_point.column(k) - numeric).norm() < 1e-5, "{k}");
        }
    }
}
