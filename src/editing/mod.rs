//! Changes of a finished block by hand: observations, points and images rejected and restored, measured and added.
//!
//! Edits are a list that is applied to the block as it was found: a pure function. Undoing one is the list without it.

mod apply;
mod edit;

pub(crate) use apply::edited_model;
pub use edit::{BlockEdit, HandMeasurement, MeasuredBy, PointImage};
