//! Where a text is no JSON.

use crate::message::messages;
use serde::{Deserialize, Serialize};

messages! {
    /// What stands where it may not, or is missing, in a text that should be JSON.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(rename_all = "snake_case")]
    pub enum JsonSyntax as "json_syntax" {
        /// The text ends before its value does.
        Ended,
        /// More text follows the value.
        Continued,
        NoValue,
        /// A field whose name is no text.
        NoName,
        /// Nothing stands between the name of a field and its value.
        NoColon,
        /// Nothing stands between the items of a list.
        NoCommaInList,
        /// Nothing stands between the fields of an object.
        NoCommaInObject,
        LastComma,
        Number,
        /// Larger than numbers of a computer.
        LargeNumber,
        /// A backslash with what may not follow it.
        Escape,
        /// A line break, or another character without a picture, in a text.
        ControlCharacter,
        Deep,
    }
}

impl JsonSyntax {
    /// By the words of the library that reads JSON, which are stable and in no other form.
    pub(super) fn of(words: &str) -> Option<Self> {
        Some(match words {
            _ if words.starts_with("EOF while parsing") => Self::Ended,
            "trailing characters" => Self::Continued,
            "expected value" | "expected ident" => Self::NoValue,
            "key must be a string" | "expected `\"`" => Self::NoName,
            "expected `:`" => Self::NoColon,
            "expected `,` or `]`" => Self::NoCommaInList,
            "expected `,` or `}`" => Self::NoCommaInObject,
            "trailing comma" => Self::LastComma,
            "invalid number" => Self::Number,
            "number out of range" => Self::LargeNumber,
            "invalid escape" | "invalid unicode code point" | "lone leading surrogate in hex escape" | "unexpected end of hex escape" => {
                Self::Escape
            }
            _ if words.starts_with("control character") => Self::ControlCharacter,
            "recursion limit exceeded" => Self::Deep,
            _ => return None,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::json::{JsonFault, from_text};
    use serde_json::Value;

    #[test]
    fn whatever_is_wrong_with_a_text_is_known_by_its_kind() {
        let deep = "[".repeat(200);
        for (text, expected) in [
            ("", JsonSyntax::Ended),
            ("{\"a\": [1, 2", JsonSyntax::Ended),
            ("{\"a\": \"b", JsonSyntax::Ended),
            ("{} 3", JsonSyntax::Continued),
            ("{\"a\": }", JsonSyntax::NoValue),
            ("[nul]", JsonSyntax::NoValue),
            ("{a: 1}", JsonSyntax::NoName),
            ("{\"a\" 1}", JsonSyntax::NoColon),
            ("[1 2]", JsonSyntax::NoCommaInList),
            ("{\"a\": 1 \"b\": 2}", JsonSyntax::NoCommaInObject),
            ("[1,]", JsonSyntax::LastComma),
            ("{\"a\": 1,}", JsonSyntax::LastComma),
            ("[01]", JsonSyntax::Number),
            ("[1.]", JsonSyntax::Number),
            ("[\"\\x\"]", JsonSyntax::Escape),
            ("[\"\\u12\"]", JsonSyntax::Escape),
            ("[\"a\nb\"]", JsonSyntax::ControlCharacter),
            (&deep[..], JsonSyntax::Deep),
        ] {
            match from_text::<Value>(text).unwrap_err() {
                JsonFault::Syntax { json_syntax, line: Some(_), column: Some(_) } => assert_eq!(json_syntax, expected, "{text}"),
                fault => panic!("{text}: {fault:?}"),
            }
        }
    }
}
