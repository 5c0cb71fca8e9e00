//! Relative orientation: coplanarity, consensus of minimal samples, rigorous adjustment.

mod adjustment;
mod consensus;
mod coplanarity;
mod determinant;
mod five_point;
mod normals;
mod options;
mod precision;
mod refusal;
mod rejection;
mod relative;
mod result;

pub use options::{OrientationMethod, OrientationOptions};
pub use relative::orient_relative;
pub use result::{FiveParameters, Observation, RelativeOrientation};
