//! The rotation matrix of a photo and its angles.

use nalgebra::Matrix3;

/// Rotation M = M3(κ)·M2(φ)·M1(ω) from object space to photo space, angles in radians: photo = M·(X - X_L).
///
/// ω turns about x, φ about y, κ about z, in this order, each about the axis as the previous ones left it; positive angles turn the photo
/// axes counterclockwise seen against the axis.
pub fn rotation_from_angles(omega: f64, phi: f64, kappa: f64) -> Matrix3<f64> {
    let (so, co) = (libm::sin(omega), libm::cos(omega));
    let (sp, cp) = (libm::sin(phi), libm::cos(phi));
    let (sk, ck) = (libm::sin(kappa), libm::cos(kappa));
    Matrix3::new(
        cp * ck,
        co * sk + so * sp * ck,
        so * sk - co * sp * ck,
        -cp * sk,
        co * ck - so * sp * sk,
        so * ck + co * sp * sk,
        sp,
        -so * cp,
        co * cp,
    )
}

/// The angles `[ω, φ, κ]` in radians of a rotation matrix M = M3(κ)·M2(φ)·M1(ω); φ in -π/2..π/2, ω and κ in -π..π.
///
/// At φ = ±π/2 only the sum or the difference of ω and κ is determined; ω is then what rounding leaves.
pub fn angles_from_rotation(m: &Matrix3<f64>) -> [f64; 3] {
    let omega = libm::atan2(-m[(2, 1)], m[(2, 2)]);
    let cos_phi = (m[(0, 0)] * m[(0, 0)] + m[(1, 0)] * m[(1, 0)]).sqrt();
    let phi = libm::atan2(m[(2, 0)], cos_phi);
    let kappa = libm::atan2(-m[(1, 0)], m[(0, 0)]);
    [omega, phi, kappa]
}

/// The rotation nearest to a matrix of positive determinant.
pub(crate) fn nearest_rotation(matrix: &Matrix3<f64>) -> Option<Matrix3<f64>> {
    if !matrix.iter().all(|v| v.is_finite()) {
        return None;
    }
    let svd = matrix.svd(true, true);
    let rotation = svd.u? * svd.v_t?;
    (rotation.determinant() > 0.0).then_some(rotation)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn about_axes(omega: f64, phi: f64, kappa: f64) -> Matrix3<f64> {
        let (so, co) = (omega.sin(), omega.cos());
        let (sp, cp) = (phi.sin(), phi.cos());
        let (sk, ck) = (kappa.sin(), kappa.cos());
        let m1 = Matrix3::new(1.0, 0.0, 0.0, 0.0, co, so, 0.0, -so, co);
        let m2 = Matrix3::new(cp, 0.0, -sp, 0.0, 1.0, 0.0, sp, 0.0, cp);
        let m3 = Matrix3::new(ck, sk, 0.0, -sk, ck, 0.0, 0.0, 0.0, 1.0);
        m3 * m2 * m1
    }

    #[test]
    fn the_matrix_is_the_product_of_the_three_turns() {
        for (omega, phi, kappa) in [(0.1, -0.2, 0.3), (-1.2, 0.9, 3.0), (0.0, 0.0, 3.1), (2.5, -1.5, -2.0)] {
            let difference = rotation_from_angles(omega, phi, kappa) - about_axes(omega, phi, kappa);
            assert!(difference.amax() < 1e-15, "{omega} {phi} {kappa}: {difference}");
        }
    }

    #[test]
    fn angles_come_back() {
        for (omega, phi, kappa) in [(0.1, -0.2, 0.3), (-1.2, 0.9, 3.0), (0.0, 0.0, -3.1), (2.5, -1.5, -2.0)] {
            let back = angles_from_rotation(&rotation_from_angles(omega, phi, kappa));
            for (got, wanted) in back.iter().zip([omega, phi, kappa]) {
                assert!((got - wanted).abs() < 1e-14, "{back:?}, wanted {omega} {phi} {kappa}");
            }
        }
    }
}
