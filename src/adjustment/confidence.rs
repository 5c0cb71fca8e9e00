//! Regions that hold what was adjusted with a probability of 95 %: intervals, ellipses and ellipsoids.

use super::result::AdjustmentResult;
use crate::math::joint_limit;
use serde::Serialize;

/// The probability that a region leaves out.
const OUTSIDE: f64 = 0.05;

/// By what standard errors grow for a region to hold the truth with a probability of 95 %.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Factors95 {
    /// Of one unknown: the half-width of its interval by its standard error.
    pub interval: f64,
    /// Of two unknowns that belong together: their ellipse by the standard error ellipse.
    pub ellipse: f64,
    /// Of three: their ellipsoid by the standard error ellipsoid.
    pub ellipsoid: f64,
}

impl Factors95 {
    /// `freedom`: degrees of freedom of the σ₀ by which standard errors are; `None` where it is known.
    pub(crate) fn of(freedom: Option<usize>) -> Self {
        let [interval, ellipse, ellipsoid] = [1, 2, 3].map(|unknowns| joint_limit(OUTSIDE, unknowns, freedom));
        Self { interval, ellipse, ellipsoid }
    }
}

impl AdjustmentResult {
    /// By what its standard errors grow for 95 %: Student's and the F distribution of its degrees of freedom, the normal and the χ² distribution
    /// where σ₀ was given. Absent where there are no standard errors, σ₀ being neither given nor estimated.
    pub fn factors_95(&self) -> Option<Factors95> {
        let freedom = self.sigma0_a_priori_px.is_none().then_some(self.degrees_of_freedom);
        (freedom != Some(0)).then(|| Factors95::of(freedom))
    }
}

/// The semi-axes of the standard error ellipsoid of three coordinates, the longest first, by their standard errors and the correlations of the first
/// with the second, of the first with the third, of the second with the third.
pub fn ellipsoid_semi_axes(errors: [f64; 3], [xy, xz, yz]: [f64; 3]) -> [f64; 3] {
    let correlations = nalgebra::Matrix3::new(1.0, xy, xz, xy, 1.0, yz, xz, yz, 1.0);
    let covariance = nalgebra::Matrix3::from_fn(|row, column| errors[row] * correlations[(row, column)] * errors[column]);
    let mut variances: [f64; 3] = covariance.symmetric_eigenvalues().into();
    variances.sort_by(|a, b| b.total_cmp(a));
    variances.map(|variance| variance.max(0.0).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn semi_axes_are_those_of_the_covariance() {
        let close = |got: [f64; 3], wanted: [f64; 3]| got.iter().zip(wanted).all(|(got, wanted)| (got - wanted).abs() < 1e-9);
        assert!(close(ellipsoid_semi_axes([1.0, 3.0, 2.0], [0.0; 3]), [3.0, 2.0, 1.0]));
        // Axes of 5 and 1 in the plane of X and Z, at 30°.
        let (sin, cos) = (0.5, 0.75_f64.sqrt());
        let [x, z, xz] = [25.0 * cos * cos + sin * sin, 25.0 * sin * sin + cos * cos, 24.0 * sin * cos];
        let got = ellipsoid_semi_axes([x.sqrt(), 2.0, z.sqrt()], [0.0, xz / (x * z).sqrt(), 0.0]);
        assert!(close(got, [5.0, 2.0, 1.0]), "{got:?}");
        // Two coordinates that are one.
        assert!(close(ellipsoid_semi_axes([1.0, 1.0, 0.0], [1.0, 0.0, 0.0]), [2.0_f64.sqrt(), 0.0, 0.0]));
    }
}
