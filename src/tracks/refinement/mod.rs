//! Rays of chosen points, matched by least squares to a reference ray of their point.
//!
//! Data flow: an image → [`ray_windows`] → windows of its rays → [`PointRefiner`] → [`RefinedPoint`].

mod options;
mod outcome;
mod point;
mod reference;
mod windows;

pub use options::{RefinementMethod, RefinementOptions};
pub use outcome::{RayOutcome, RefinedPoint, RefinedRay};
pub use point::{PointRefiner, WindowedRay};
pub use windows::{RayPlace, RayWindow, RayWindows, ray_windows};
