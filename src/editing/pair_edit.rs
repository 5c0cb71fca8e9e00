//! What may be changed by hand of the matches of a pair. Places are column and row in the left, column and row in the right image, px.

use serde::{Deserialize, Serialize};

/// A match that an edit is about.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(untagged, expecting = "allowed: the number of a match, or a list of four numbers")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum EditedMatch {
    /// The number that it got when it was measured by hand.
    Measured(u32),
    /// Where the matching found it.
    Found([f64; 4]),
}

/// A change of the matches of a pair by hand.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum PairEdit {
    /// They take no part in the orientation.
    Reject { of: Vec<EditedMatch> },
    /// They are used again.
    Restore { of: Vec<EditedMatch> },
    /// A match that was measured by hand, with a number that no other has.
    Add { id: u32, at: [f64; 4] },
    /// Another place of a match.
    Move { of: EditedMatch, to: [f64; 4] },
}

impl PairEdit {
    /// All places that it names.
    pub(crate) fn places(&self) -> Vec<[f64; 4]> {
        let found = |of: &EditedMatch| match of {
            EditedMatch::Found(place) => Some(*place),
            EditedMatch::Measured(_) => None,
        };
        match self {
            Self::Reject { of } | Self::Restore { of } => of.iter().filter_map(found).collect(),
            Self::Add { at, .. } => vec![*at],
            Self::Move { of, to } => found(of).into_iter().chain([*to]).collect(),
        }
    }
}
