//! What the control points of a block are: surveyed ones, places of an orthophoto on which it lies, or both.

use super::result::SurveyedPoint;
use crate::ControlRole;
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
    /// Of those of the points that take part as control points. `is_place`: whether a name is that of a place of an orthophoto.
    pub(crate) fn of(points: &[SurveyedPoint], is_place: impl Fn(&str) -> bool) -> Self {
        let control = || points.iter().filter(|point| point.role == ControlRole::Control);
        let (places, all) = (control().filter(|point| is_place(&point.name)).count(), control().count());
        match places {
            0 => Self::Surveyed,
            _ if places == all => Self::Places,
            _ => Self::Both,
        }
    }
}
