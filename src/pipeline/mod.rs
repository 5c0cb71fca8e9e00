//! The run of a block, without input and output of its own: hosts execute its jobs and keep bytes.

mod remark;
mod result;

pub use remark::{Failure, Remark};
pub use result::{BlockRun, InitialCamera, JoinedPoints, RefinedObservation, RefinementTable, RunImage, SkippedImage};
