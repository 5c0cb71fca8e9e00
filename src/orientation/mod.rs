//! Relative orientation: coplanarity, consensus of minimal samples, rigorous adjustment.

mod adjusted;
mod adjustment;
mod agreement;
mod coplanarity;
mod determinant;
mod error_model;
mod field;
mod five_point;
mod focal;
mod identical;
mod neighbours;
mod normals;
mod observed;
mod options;
mod plane;
mod plane_pose;
mod precision;
mod refusal;
mod rejection;
mod relative;
mod reliability;
mod result;
mod robust_start;
mod shared;
mod warning;
mod weighting;

pub(crate) use coplanarity::{Ray, RelativePose, condition};
pub use error_model::ErrorModel;
pub(crate) use field::{Field, square_distance};
pub(crate) use normals::Normals;
pub use options::{OrientationMethod, OrientationOptions, Weighting};
pub(crate) use plane_pose::poses_of_plane;
pub use relative::{orient_relative, orient_relative_with};
pub use result::{ErrorEllipse, EstimatedCamera, FiveParameters, GlobalTest, Observation, PointStatistics, RelativeOrientation, Warning};
pub(crate) use robust_start::Poses;
pub use shared::SharedErrors;
