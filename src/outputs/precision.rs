//! Standard errors of the images and points of the model that is written, with respect to its datum and in its units.

use crate::{AdjustmentResult, BlockRun, ObjectPointStatistics, ReconstructedModel};

/// The model that is written, as it was adjusted; absent without a reconstruction.
pub(super) fn written(run: &BlockRun) -> Option<&ReconstructedModel> {
    run.reconstruction.as_ref().ok()?.models.first()
}

/// Precision of a position.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct CoordinateErrors {
    /// Standard errors of X, Y, Z.
    pub errors: [f64; 3],
    /// Of X with Y, of X with Z, of Y with Z; absent in older projects.
    pub correlations: Option<[f64; 3]>,
}

/// Precision of an image.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct ImageErrors {
    /// Of X₀, Y₀, Z₀.
    pub position: Option<CoordinateErrors>,
    /// Of ω, φ, κ.
    pub angles_deg: Option<[f64; 3]>,
}

/// Of each image of the block.
pub(super) fn image_errors(run: &BlockRun) -> Vec<ImageErrors> {
    let mut errors = vec![ImageErrors::default(); run.images.len()];
    if let Some(model) = written(run) {
        for (image, statistics) in model.images.iter().zip(&model.adjusted.images) {
            errors[*image] = ImageErrors {
                position: statistics
                    .position_errors
                    .map(|errors| CoordinateErrors { errors, correlations: statistics.position_correlations }),
                angles_deg: statistics.angle_errors_deg,
            };
        }
    }
    errors
}

/// Of each point of an adjusted block its index in the model that is written, which leaves out those without accepted observations.
pub(super) fn written_points(model: &ReconstructedModel) -> Vec<Option<usize>> {
    let mut next = 0..;
    model.adjusted.points.iter().map(|point| point.and_then(|_| next.next())).collect()
}

/// Of each point of the model that is written.
pub(super) fn point_errors(run: &BlockRun) -> Vec<Option<CoordinateErrors>> {
    let of_point = |point: &ObjectPointStatistics| Some(CoordinateErrors { errors: point.errors?, correlations: point.correlations });
    // The written model leaves out the points without accepted observations.
    let adjusted = |adjusted: &AdjustmentResult| adjusted.points.iter().flatten().map(of_point).collect();
    let mut errors: Vec<Option<CoordinateErrors>> = written(run).map_or(Vec::new(), |model| adjusted(&model.adjusted));
    errors.resize(run.model.points.len(), None);
    errors
}
