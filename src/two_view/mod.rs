//! The geometry of two views from matches with gross errors: calibrated or not, over relief, over a plane, from one place.

mod chance;
mod direct;
mod focal;
mod frame;
mod fundamental;
mod homography;
mod known;
mod options;
mod parallax;
mod plane_pose;
mod refine;
mod result;
mod rotation;
mod scale;
mod support;
mod transfer;
mod two_view;

pub use direct::{fundamental_eight_point, fundamental_seven_point, homography_direct};
pub(crate) use known::two_view_from;
pub use options::{Pinhole, TwoViewOptions};
pub use result::{Degeneracy, FocalEstimate, NoGeometry, TwoView, TwoViewModel};
pub use two_view::two_view;

use nalgebra::{Matrix3, SMatrix};

/// The direction in which a sum of squares, given by its upper triangle, is least; `None` where a second one is as good.
fn least_direction(mut sums: SMatrix<f64, 9, 9>) -> Option<[f64; 9]> {
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
fn by_rows(matrix: &Matrix3<f64>) -> [f64; 9] {
    std::array::from_fn(|k| matrix[(k / 3, k % 3)])
}
