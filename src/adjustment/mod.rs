//! Bundle adjustment: all images, cameras and points of a block at once, with what the result is worth.
//!
//! Data flow: [`Block`] → `network` (rays in order) → `reduced` (normal equations without the points) → `solution` (sparse factor, step) →
//! `gauss_newton` (iteration) → `precision`, `reliability` (cofactors; `covariance`: those of any unknowns) → `snooping` (rounds that reject gross errors of rays and positions; `robust_similarity`: those of positions at the start;
//! `systematic`, `strips`: errors that positions share, with `datum_part` and `significance`, which say what is estimated of them) → [`AdjustmentResult`].

mod adjust;
mod adjusted_equations;
mod axis;
mod block;
mod calibration;
mod check;
mod collinearity;
mod common_offset;
mod components;
mod confidence;
mod covariance;
mod datum;
mod datum_part;
mod factor3;
mod gauss_newton;
mod gradients;
mod left_out;
mod line;
mod loss;
mod network;
mod options;
mod part;
mod precision;
mod reduced;
mod reliability;
mod result;
mod robust_similarity;
mod scale;
mod shared;
mod significance;
mod similarity;
mod snooping;
mod solution;
mod sparse;
mod squares;
mod start;
mod state;
mod statistics;
mod strip_trend;
mod strips;
mod systematic;
mod systematic_equations;
mod systematic_result;
mod weighted;

pub use adjust::adjust_block;
pub use block::{AxisPrior, Block, BlockImage, BlockObservation, CameraPrior, ControlPoint, PositionPrior};
pub(crate) use collinearity::{linearise, project};
pub use confidence::{Factors95, ellipsoid_semi_axes};
pub(crate) use covariance::{Part, PartCovariances, Unknown};
pub(crate) use datum::far_control;
pub use left_out::LeftOut;
pub use options::{AdjustmentOptions, Datum, Loss};
pub(crate) use precision::image_errors;
pub use result::{
    AdjustmentResult, CameraStatistics, FixedParameter, GroupWeighting, ImageStatistics, ObjectPointStatistics, ObservationGroup,
    ObservationStatistics, ObservationVerdict, PriorStatistics, RayCountRmse, VarianceComponent,
};
pub use similarity::Similarity;
pub(crate) use similarity::relative_width;
pub(crate) use start::{Start, adjust_start};
pub use strips::Strip;
pub use systematic_result::{SystematicError, SystematicResult, SystematicStatistics, SystematicVerdict};
