//! Errors that many observations share, as those of the interior orientation.

/// Three causes of error that act on all observations, as the parameters of a row of an affine transformation.
#[derive(Debug, Clone, PartialEq)]
pub struct SharedErrors {
    /// For each observation the change of its `[x_left, y_left, x_right, y_right]` in mm by a unit of each cause.
    pub effects: Vec<[[f64; 4]; 3]>,
    /// Covariance of the causes.
    pub covariance: [[f64; 3]; 3],
    /// Degrees of freedom of the σ₀ by which the covariance is; absent where that is known.
    pub degrees_of_freedom: Option<usize>,
}
