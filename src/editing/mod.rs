//! Changes by hand: of a finished block (observations, points, images and pairs rejected and restored, measured and added), and of the matches of a pair.
//!
//! Edits are a list that is applied to what was found: a pure function. Undoing one is the list without it.

mod apply;
mod draft;
mod edit;
mod pair_edit;
mod rejected_pairs;

pub(crate) use apply::{edited_model, in_edit};
pub(crate) use draft::FoundBlock;
pub use edit::{BlockEdit, HandMeasurement, MeasuredBy, PointImage};
pub use pair_edit::{EditedMatch, PairEdit};
pub(crate) use rejected_pairs::{ascending, rejected_pairs};
