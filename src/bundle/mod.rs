//! Bundle adjustment: all images, cameras and points of a block at once, with what the result is worth.
//!
//! Data flow: [`Block`] → `network` (rays in order) → `reduced` (normal equations without the points) → `solution` (sparse factor, step) →
//! `adjustment` (iteration) → `precision`, `reliability` (cofactors) → `snooping` (gross errors) → [`BundleResult`].

mod adjust;
mod adjustment;
mod block;
mod calibration;
mod check;
mod collinearity;
mod datum;
mod loss;
mod network;
mod options;
mod precision;
mod reduced;
mod reliability;
mod result;
mod similarity;
mod snooping;
mod solution;
mod sparse;
mod state;
mod statistics;

pub use adjust::adjust_block;
pub use block::{Block, BlockCamera, BlockImage, BlockPoint, ControlPoint, FreeParameters, PositionPrior, Ray};
pub use options::{BundleOptions, Datum, Loss};
pub use result::{
    BundleResult, CameraParameter, CameraStatistics, FixedParameter, ImageStatistics, ObjectPointStatistics, PriorStatistics, RayCountRmse,
    RayStatistics, RayVerdict,
};
