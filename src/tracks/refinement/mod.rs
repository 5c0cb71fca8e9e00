//! Rays of chosen points, matched by least squares to a reference ray of their point.
//!
//! Data flow: an image → [`observation_windows`] → windows of its rays → [`PointRefiner`] → [`RefinedPoint`].

mod options;
mod outcome;
mod point;
mod reference;
mod windows;

pub use options::{RefinementMethod, RefinementOptions};
pub use outcome::{ObservationRefinement, RefinedPoint, RefinementOutcome};
pub use point::PointRefiner;
pub use windows::{ObservationWindow, ObservationWindows, WindowCentre, WindowedObservation, observation_windows};
