//! What the control points of a block are: surveyed ones, places of an orthophoto on which it lies, or both.

use serde::{Deserialize, Serialize};

/// What holds a block where it lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum ControlKind {
    /// Points that were given.
    #[default]
    Surveyed,
    /// Places of an orthophoto.
    Places,
    /// Both.
    Both,
}

impl ControlKind {
    /// Of the control points with these names. `is_place`: whether one is that of a place of an orthophoto.
    pub(crate) fn of<'a>(names: impl Iterator<Item = &'a str>, is_place: impl Fn(&str) -> bool) -> Self {
        let (places, surveyed): (Vec<&str>, Vec<&str>) = names.partition(|name| is_place(name));
        match (places.is_empty(), surveyed.is_empty()) {
            (true, _) => Self::Surveyed,
            (false, true) => Self::Places,
            (false, false) => Self::Both,
        }
    }
}
