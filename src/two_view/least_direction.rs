//! Matrices of homogeneous positions as their nine entries, and the entries that fulfil linear conditions best.

use nalgebra::{Matrix3, SMatrix};

/// The direction in which a sum of squares, given by its upper triangle, is least; `None` where a second one is as good.
pub(super) fn least_direction(mut sums: SMatrix<f64, 9, 9>) -> Option<[f64; 9]> {
    sums.fill_lower_triangle_with_upper_triangle();
    if !sums.iter().all(|v| v.is_finite()) {
        return None;
    }
    let eigen = sums.symmetric_eigen();
    let mut order: [usize; 9] = std::array::from_fn(|k| k);
    order.sort_by(|a, b| eigen.eigenvalues[*a].total_cmp(&eigen.eigenvalues[*b]));
    let [_, second, .., largest] = order.map(|k| eigen.eigenvalues[k]);
    (second > 1e-13 * largest).then(|| std::array::from_fn(|k| eigen.eigenvectors[(k, order[0])]))
}

/// The entries of a matrix, row by row.
pub(super) fn by_rows(matrix: &Matrix3<f64>) -> [f64; 9] {
    std::array::from_fn(|k| matrix[(k / 3, k % 3)])
}
