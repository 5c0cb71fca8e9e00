//! Why JSON is refused.

use super::JsonSyntax;
use crate::message::messages;
use serde::{Deserialize, Serialize};
use serde_json::Value;

messages! {
    /// Why a JSON text is refused; line and column count from 1, and are absent where there is no text to look them up in.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
    pub enum JsonFault as "json_fault" {
        /// A value; a field by its path, absent for the whole.
        Value { field: Option<String>, json_slip: Box<JsonSlip>, line: Option<usize>, column: Option<usize> },
        /// The text is no JSON.
        Syntax { json_syntax: JsonSyntax, line: Option<usize>, column: Option<usize> },
        /// A field by its path, in words of who read it.
        Field { field: String, words: String, line: Option<usize>, column: Option<usize> },
        /// The whole, in words of who read it.
        Text { words: String, line: Option<usize>, column: Option<usize> },
    }
}

impl std::error::Error for JsonFault {}

impl From<serde_json::Error> for JsonFault {
    /// The reader appends line and column to its words where it read a text, and gives these in no other way.
    fn from(error: serde_json::Error) -> Self {
        let (said, line, column) = (error.to_string(), error.line(), error.column());
        let (words, line, column) = match said.strip_suffix(&format!(" at line {line} column {column}")) {
            Some(words) => (words, Some(line), Some(column)),
            None => (&said[..], None, None),
        };
        match JsonSyntax::of(words) {
            Some(json_syntax) => Self::Syntax { json_syntax, line, column },
            None => Self::Text { words: words.into(), line, column },
        }
    }
}

messages! {
    /// What is wrong with a value.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
    pub enum JsonSlip as "json_slip" {
        OtherKind { json_kind: JsonKind, json_wanted: JsonWanted },
        /// A number, a short text or another single value as JSON writes it.
        OtherValue { value: String, json_wanted: JsonWanted },
        /// A list of so many items; how many are wanted is not always known.
        OtherLength { items: usize, wanted_items: Option<usize> },
        /// A field that nobody reads; names of those that are read, with commas between.
        UnknownField { known: Option<String> },
        Missing,
        Twice,
        /// Lists and objects in each other.
        Deep { most: usize },
        /// A value of JavaScript that JSON does not have, by its kind.
        NotInJson { value_kind: String },
    }
}

messages! {
    /// What is wanted in place of a value.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
    pub enum JsonWanted as "json_wanted" {
        OfKind { json_kind: JsonKind },
        Whole { min: f64, max: f64 },
        /// A match of a pair, by its number or its place.
        Match,
        /// One of these, with commas between.
        Words { words: String },
        /// What its reader does not say in a form of ours.
        Other,
    }
}

messages! {
    /// What a value of JSON is.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(rename_all = "snake_case")]
    pub enum JsonKind as "json_kind" {
        Null,
        Boolean,
        Number,
        Text,
        List,
        Object,
    }
}

impl JsonKind {
    pub(crate) fn of(value: &Value) -> Self {
        match value {
            Value::Null => Self::Null,
            Value::Bool(_) => Self::Boolean,
            Value::Number(_) => Self::Number,
            Value::String(_) => Self::Text,
            Value::Array(_) => Self::List,
            Value::Object(_) => Self::Object,
        }
    }
}
