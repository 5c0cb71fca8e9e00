//! The cameras of a pair that are not known without error: their constants have prior standard deviations, which reach the total standard errors of
//! ω φ κ by bz. Where the focal length is hardly known, the constants enter the adjustment as unknowns with that prior information.
//!
//! By the inverse of a partitioned matrix, the covariance of the pose in the adjustment of all unknowns is that of the pose with
//! fixed cameras and what the covariance of the cameras adds to it.

mod adjustment;
mod as_given;
mod causes;
mod constants;
mod decentring;
mod measured;
mod result;

pub(super) use adjustment::calibrated;
pub(super) use as_given::{cameras_as_given, errors_as_given};
pub(super) use constants::{is_calibrated, tells_more};
pub(super) use measured::Measured;
