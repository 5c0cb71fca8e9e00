//! An observed position without itself: where all other observations have its point, found without a new adjustment.
//!
//! With the cofactors Q of the adjusted point and the weights P of its observed coordinates, which took part, the other observations alone
//! have cofactors (I - QP)⁻¹Q and lie (I - QP)⁻¹v from the observed place, where v is the residual (observed minus adjusted). It is exact for
//! linear equations and weights that stay as they are. Errors that the rays of an image share move it by (I - QP)⁻¹ of what they move the
//! adjusted point by.
//!
//! # Source
//! Allen 1974, The relationship between variable selection and data augmentation (leave-one-out residuals); Förstner & Wrobel 2016, 4.6.

use super::precision::Matrix3;
use super::weighted::Weighted;
use serde::{Deserialize, Serialize};

/// An observed position beside where its point is without it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct LeftOut {
    /// Adjusted without it minus observed.
    pub difference: [f64; 3],
    /// Standard errors of that difference.
    pub standard_errors: [f64; 3],
}

/// The share of each direction that the other observations must hold: with less, its place without the point is that of rounding errors.
const LEAST_SHARE: f64 = 1e-6;

/// Cofactors of an adjusted point: those of the adjustment, and what errors add that the rays of an image share.
pub(super) struct Known {
    pub cofactors: Matrix3,
    pub shared: Matrix3,
}

/// Of a position whose three coordinates took part with weights for the standard error `sigma`; `unit_error`: that of what is estimated by the
/// other observations. `None` where these do not determine the point.
pub(super) fn left_out(prior: &Weighted, at: &[f64; 3], known: &Known, sigma: f64, unit_error: f64) -> Option<LeftOut> {
    if prior.weight.iter().any(|weight| !(*weight > 0.0)) {
        return None;
    }
    let symmetric = |of: &Matrix3| nalgebra::Matrix3::from_fn(|row, column| 0.5 * (of[row][column] + of[column][row]));
    let q = symmetric(&known.cofactors);
    let root = nalgebra::Matrix3::from_diagonal(&prior.weight.map(f64::sqrt).into());
    // I - √P Q √P has the eigenvalues of I - QP: all must exceed the least share.
    let shares = nalgebra::Matrix3::identity() - root * q * root;
    (shares - nalgebra::Matrix3::identity() * LEAST_SHARE).cholesky()?;
    let inverse = (nalgebra::Matrix3::identity() - q * root * root).try_inverse()?;
    let residual = nalgebra::Vector3::from_fn(|k, _| prior.position[k] - at[k]);
    let (difference, others) = (-(inverse * residual), inverse * q);
    let shared = inverse * symmetric(&known.shared) * inverse.transpose();
    let variance = |k: usize| sigma * sigma / prior.weight[k] + unit_error * unit_error * (others[(k, k)] + shared[(k, k)]);
    let standard_errors = [0, 1, 2].map(|k| variance(k).sqrt());
    let is_known = standard_errors.iter().all(|error| error.is_finite()) && (0..3).all(|k| others[(k, k)] >= 0.0);
    is_known.then(|| LeftOut { difference: difference.into(), standard_errors })
}
