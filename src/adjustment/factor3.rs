//! The factor L of the equations of a point, V = L Lᵀ, and what it is multiplied with.

/// Least share 1 - R² of a point's coordinate that its rays must leave: rays within a millionth of parallel do not meet anywhere.
const LEAST_SHARE: f64 = 1e-12;

/// L of a symmetric matrix, both as its lower rows. `None` where a pivot is rounding.
pub(super) fn factor3(v: &[f64; 6]) -> Option<[f64; 6]> {
    let pivot = |rest: f64, own: f64| (rest > LEAST_SHARE * own).then(|| rest.sqrt());
    let l00 = pivot(v[0], v[0])?;
    let l10 = v[1] / l00;
    let l11 = pivot(v[2] - l10 * l10, v[2])?;
    let l20 = v[3] / l00;
    let l21 = (v[4] - l20 * l10) / l11;
    let l22 = pivot(v[5] - l20 * l20 - l21 * l21, v[5])?;
    Some([l00, l10, l11, l20, l21, l22])
}

/// L⁻¹ x.
pub(super) fn forward3(l: &[f64; 6], x: [f64; 3]) -> [f64; 3] {
    let a = x[0] / l[0];
    let b = (x[1] - l[1] * a) / l[2];
    [a, b, (x[2] - l[3] * a - l[4] * b) / l[5]]
}

/// L⁻ᵀ x.
pub(super) fn backward3(l: &[f64; 6], x: [f64; 3]) -> [f64; 3] {
    let c = x[2] / l[5];
    let b = (x[1] - l[4] * c) / l[2];
    [(x[0] - l[1] * b - l[3] * c) / l[0], b, c]
}
