//! What may be changed by hand of the matches of a pair. Places are column and row in the left, column and row in the right image, px.

use crate::json;
use serde::de::value::SeqAccessDeserializer;
use serde::de::{Error, SeqAccess, Unexpected, Visitor};
use serde::{Deserialize, Deserializer, Serialize};
use std::fmt::{self, Formatter};

/// A match that an edit is about.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(untagged)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum EditedMatch {
    /// The number that it got when it was measured by hand.
    Measured(u32),
    /// Where the matching found it.
    Found([f64; 4]),
}

/// By whether it is a number or a list: what is wrong with it is then said of what it is.
impl<'de> Deserialize<'de> for EditedMatch {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        struct Either;
        impl<'de> Visitor<'de> for Either {
            type Value = EditedMatch;

            fn expecting(&self, f: &mut Formatter<'_>) -> fmt::Result {
                f.write_str(json::MATCH)
            }

            fn visit_u64<E: Error>(self, number: u64) -> Result<EditedMatch, E> {
                let wrong = |_| E::invalid_value(Unexpected::Unsigned(number), &self);
                u32::try_from(number).map(EditedMatch::Measured).map_err(wrong)
            }

            fn visit_seq<A: SeqAccess<'de>>(self, place: A) -> Result<EditedMatch, A::Error> {
                Deserialize::deserialize(SeqAccessDeserializer::new(place)).map(EditedMatch::Found)
            }
        }
        from.deserialize_any(Either)
    }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Texts;

    #[test]
    fn a_match_is_a_number_or_a_place_and_what_is_neither_is_said_in_each_language() {
        let read = json::from_text::<Vec<PairEdit>>;
        let edits = read(r#"[{"kind": "reject", "of": [3, [1, 2.5, 3, 4]]}, {"kind": "move", "of": 4, "to": [1, 2, 3, 4]}]"#).unwrap();
        let of = vec![EditedMatch::Measured(3), EditedMatch::Found([1.0, 2.5, 3.0, 4.0])];
        assert_eq!(edits, [PairEdit::Reject { of }, PairEdit::Move { of: EditedMatch::Measured(4), to: [1.0, 2.0, 3.0, 4.0] }]);
        for (given, told) in [
            (r#""three""#, r#"[0].of: got "three"; allowed: the number of a match, or a list of four numbers, its place"#),
            ("-1", "[0].of: got -1; allowed: the number of a match, or a list of four numbers, its place"),
            ("4294967296", "[0].of: got 4294967296; allowed: the number of a match, or a list of four numbers, its place"),
            ("[1, 2, 3]", "[0].of: got a list of 3"),
            (r#"[1, 2, 3, "4"]"#, r#"[0].of[3]: got "4"; allowed: a number"#),
        ] {
            let fault = read(&format!(r#"[{{"kind": "move", "of": {given}, "to": [1, 2, 3, 4]}}]"#)).unwrap_err();
            assert!(fault.to_string().starts_with(told), "{told}: {fault}");
            assert!(!Texts::arabic().text(&fault).contains("allowed"), "{fault}");
        }
    }
}
