//! From the pose and its cofactors to ω φ κ by bz and theirs.

use super::coplanarity::{RelativePose, Unknowns};
use super::normals::Matrix5;
use super::result::FiveParameters;
use crate::camera::angles_from_rotation;
use crate::{Cause, Computation, Error};
use nalgebra::{Matrix3, Vector3};

/// Least share of the base along x; below it by and bz in units of b mean nothing.
const LEAST_ALONG_X: f64 = 1e-3;

/// Least cosine of φ; below it ω and κ turn about the same axis.
const LEAST_COSINE: f64 = 1e-4;

/// The base component b, with the sign of the base: positive where the right photo lies to the right.
pub(super) fn signed_base(pose: &RelativePose, base_mm: f64) -> f64 {
    if pose.base.x < 0.0 { -base_mm.abs() } else { base_mm.abs() }
}

/// ω φ κ by bz of a pose: the base is t·b/t_x.
pub(super) fn parameters(pose: &RelativePose, base_mm: f64) -> FiveParameters {
    let [omega, phi, kappa] = angles_from_rotation(&pose.rotation);
    let scale = base_mm / pose.base.x;
    FiveParameters {
        omega_deg: omega.to_degrees(),
        phi_deg: phi.to_degrees(),
        kappa_deg: kappa.to_degrees(),
        by_mm: scale * pose.base.y,
        bz_mm: scale * pose.base.z,
    }
}

/// Cofactors of ω φ κ (radians) and by bz (mm) from those of the small turns and shifts.
pub(super) fn propagated(pose: &RelativePose, base_mm: f64, cofactors: &Matrix5) -> Matrix5 {
    let jacobian = derivatives(pose, base_mm);
    let product = jacobian * cofactors * jacobian.transpose();
    (product + product.transpose()) * 0.5
}

/// Refuses poses that ω φ κ by bz do not describe.
pub(super) fn check_describable(pose: &RelativePose) -> Result<(), Error> {
    let along_x = pose.base.x.abs();
    if !(along_x >= LEAST_ALONG_X) {
        let cause = Cause::BaseAcrossX { along_x, least: LEAST_ALONG_X };
        return Err(Error::Degenerate { computation: Computation::ByAndBz, cause });
    }
    let cosine = (pose.rotation[(0, 0)] * pose.rotation[(0, 0)] + pose.rotation[(1, 0)] * pose.rotation[(1, 0)]).sqrt();
    if !(cosine >= LEAST_COSINE) {
        return Err(Error::Degenerate { computation: Computation::OmegaAndKappa, cause: Cause::GimbalLock });
    }
    Ok(())
}

/// Derivatives of ω φ κ by bz by the small turns and shifts.
pub(super) fn derivatives(pose: &RelativePose, base_mm: f64) -> Matrix5 {
    let [omega, ..] = angles_from_rotation(&pose.rotation);
    let (sin, cos) = (libm::sin(omega), libm::cos(omega));
    // The axes about which ω, φ and κ turn, in model space: e₁, M₁ᵀe₂, Mᵀe₃.
    let axes = Matrix3::from_columns(&[Vector3::x(), Vector3::new(0.0, cos, sin), pose.rotation.row(2).transpose()]);
    let by_turns = axes.try_inverse().unwrap_or_else(Matrix3::zeros);
    let tangents = pose.tangents();
    let t = pose.base;
    let shifted = |axis: usize, k: usize| base_mm * (tangents[k][axis] / t.x - t[axis] * tangents[k].x / (t.x * t.x));
    Matrix5::from_fn(|row, column| match (row < 3, column < 3) {
        (true, true) => by_turns[(row, column)],
        (false, false) => shifted(row - 2, column - 3),
        _ => 0.0,
    })
}

/// Standard errors of ω φ κ by bz for the standard error `sigma` of a photo coordinate in the unit of the cofactors.
pub(super) fn standard_errors(cofactors: &Matrix5, sigma: f64) -> FiveParameters {
    in_degrees(&Unknowns::from_fn(|k, _| sigma * cofactors[(k, k)].max(0.0).sqrt()))
}

/// ω φ κ (radians), by bz (mm), with angles in degrees.
pub(super) fn in_degrees(unknowns: &Unknowns) -> FiveParameters {
    FiveParameters {
        omega_deg: unknowns[0].to_degrees(),
        phi_deg: unknowns[1].to_degrees(),
        kappa_deg: unknowns[2].to_degrees(),
        by_mm: unknowns[3],
        bz_mm: unknowns[4],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::camera::rotation_from_angles;

    #[test]
    fn derivatives_are_those_of_small_differences() {
        let pose = RelativePose { rotation: rotation_from_angles(0.2, -0.4, 2.5), base: Vector3::new(-0.7, 0.5, 0.2).normalize() };
        let base_mm = signed_base(&pose, 92.0);
        assert_eq!(base_mm, -92.0);
        let jacobian = derivatives(&pose, base_mm);
        let h = 1e-6;
        for column in 0..5 {
            let at = |sign: f64| {
                let p = parameters(&pose.moved(&Unknowns::from_fn(|k, _| if k == column { sign * h } else { 0.0 })), base_mm);
                [p.omega_deg.to_radians(), p.phi_deg.to_radians(), p.kappa_deg.to_radians(), p.by_mm, p.bz_mm]
            };
            let (plus, minus) = (at(1.0), at(-1.0));
            for row in 0..5 {
                let numeric = (plus[row] - minus[row]) / (2.0 * h);
                assert!((jacobian[(row, column)] - numeric).abs() < 1e-6, "{row} {column}: {} {numeric}", jacobian[(row, column)]);
            }
        }
    }
}
