//! A block: its cameras, images, object points with their image observations, GNSS positions and ground control points.
//!
//! [`BlockDescription`] is what is known before the orientation, [`BlockModel`] what the orientation gives and files hold, [`Remark`] what is to be said of what was given.

mod block;
mod check;
mod control;
mod description;
mod gnss;
mod remark;

#[cfg(test)]
pub(crate) use block::tiny_block;
pub use block::{BlockModel, GeographicOrigin, ImageObservation, ModelImage, ObjectPoint};
pub use control::{ControlRole, GroundControlPoint, ObservedPosition};
pub use description::{BlockDescription, KnownCamera, KnownImage, NamedCamera};
pub use gnss::GnssErrors;
pub use remark::{ImpossiblePosition, PlaceSlip, Remark};
