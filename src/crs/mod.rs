//! Coordinate reference systems: what an EPSG code, PROJ text or WKT names, the way from its coordinates to WGS 84 and back, and where its heights
//! count from, and the directions of its axes at a place.
//!
//! Projections and datum shifts are those of the `proj-core` library. It computes with the sine of the platform, so that its last bits may differ
//! between native code and WebAssembly: what leaves this module is rounded (`rounding`).

mod definition;
mod described;
mod geoid;
mod height_zero;
mod operation;
mod positions;
mod rounding;
mod spelling;
mod system;
mod vertical;
mod zones;

pub(crate) use definition::{Definition, HeightReference};
pub(crate) use described::{Described, Projection};
pub use geoid::Geoid;
pub use height_zero::HeightZero;
pub(crate) use positions::middle;
pub use positions::{coordinates_in_system, places_of_coordinates};
pub(crate) use system::CoordinateSystem;
pub(crate) use vertical::Vertical;
pub(crate) use zones::{beside as beside_in_utm, prefixed_code, zone_of};
