//! What least-squares matching of a window is asked for, and what comes of it.

/// Limits of the iteration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct LeastSquaresOptions {
    /// Whether the deformation is unknown; otherwise only the shift, with gain and offset.
    pub affine: bool,
    /// Iterations at most.
    pub most_iterations: usize,
    /// Step in px below which the position is final.
    pub convergence_px: f64,
    /// Px from the start that the position may move.
    pub farthest_px: f64,
    /// Correlation with the found window at least, -1..1.
    pub least_correlation: f64,
    /// The same once the shift alone had its iterations: windows that are still less alike are given up.
    pub least_promising: f64,
}

impl Default for LeastSquaresOptions {
    fn default() -> Self {
        Self { affine: true, most_iterations: 15, convergence_px: 0.005, farthest_px: 3.0, least_correlation: 0.7, least_promising: -1.0 }
    }
}

/// A matched window. Positions are in px; the centre of the top-left pixel is (0.5, 0.5).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Fit {
    /// The right position of the window's centre.
    pub position: [f64; 2],
    /// Rows of the matrix that takes a px from the centre of the left window to px from the right position.
    pub affine: [[f64; 2]; 2],
    /// Right grey value = `gain` · left + `offset`.
    pub gain: f64,
    pub offset: f64,
    /// Of the left window with the right one as it was resampled before the last step, the shortest.
    pub correlation: f64,
    /// xx, xy and yy of the right position in px²: the residuals' variance times the inverse normal matrix.
    ///
    /// The residuals hold the noise of both images. Resampling makes that of the right one a little smaller and correlated between
    /// neighbours; the errors' true variance is about 1.1 of this one where
    /// noise dominates.
    pub covariance: [f64; 3],
    pub iterations: usize,
}

/// Why a window was not matched.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Refusal {
    /// Steps did not become short enough, or the deformation ran away.
    NotConverged,
    /// A window leaves its image (the left one with a frame of 1 px, the right one of 2 px), or a position is not finite.
    LeftImage,
    /// The position moved further from the start than allowed.
    MovedTooFar,
    /// The windows correlate less than asked.
    LowCorrelation,
    /// The left window has no texture, only an edge, or, where the deformation is unknown, too little to determine it.
    Degenerate,
}
