//! JSON texts and values read into plain data; where one is refused, the field is named.
//!
//! All goes through one reader of texts: for each other one the module would hold the code of every type once more.

use crate::message::messages;
use serde::de::{DeserializeOwned, Error};
use serde::{Deserialize, Deserializer, Serialize};
use serde_json::Value;
use serde_path_to_error::{Path, Segment, Track};
use std::collections::BTreeSet;
use std::sync::{Mutex, PoisonError};

messages! {
    /// Why a JSON text is refused, in the words of its reader.
    #[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
    pub enum JsonFault as "json_fault" {
        /// A field by its path; line and column count from 1, and are absent where there is no text to look them up in.
        Field { field: String, words: String, line: Option<usize>, column: Option<usize> },
        /// The whole.
        Text { words: String, line: Option<usize>, column: Option<usize> },
    }
}

impl std::error::Error for JsonFault {}

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

impl From<serde_json::Error> for JsonFault {
    fn from(error: serde_json::Error) -> Self {
        let (words, place) = words(&error);
        Self::Text { words, line: place.map(|place| place[0]), column: place.map(|place| place[1]) }
    }
}

/// Reads a JSON text; or says which field is wrong, and why.
pub(crate) fn from_text<T: DeserializeOwned>(text: &str) -> Result<T, JsonFault> {
    read(text).map_err(|error| match field_of(error.path()) {
        None => error.into_inner().into(),
        Some(field) => {
            let (words, place) = words(error.inner());
            JsonFault::Field { field, words, line: place.map(|place| place[0]), column: place.map(|place| place[1]) }
        }
    })
}

/// The field to which a path leads; none for the whole. A text that ends within an object leads to a field that has no name yet.
fn field_of(path: &Path) -> Option<String> {
    let whole = path.to_string();
    let unnamed = path.iter().filter(|segment| matches!(segment, Segment::Unknown)).count();
    let named = if unnamed == 0 { &whole } else { whole.trim_end_matches(['?', '.']) };
    (!named.is_empty() && unnamed < path.iter().count()).then(|| named.into())
}

/// Reads a JSON value that stands in no text: nobody could look up the place of what is refused.
pub(crate) fn from_value<T: DeserializeOwned>(value: &Value) -> Result<T, JsonFault> {
    from_text(&value.to_string()).map_err(|fault| match fault {
        JsonFault::Field { field, words, .. } => JsonFault::Field { field, words, line: None, column: None },
        JsonFault::Text { words, .. } => JsonFault::Text { words, line: None, column: None },
    })
}

fn read<T: DeserializeOwned>(text: &str) -> Result<T, serde_path_to_error::Error<serde_json::Error>> {
    let mut deserializer = serde_json::Deserializer::from_str(text);
    let mut track = Track::new();
    let read = T::deserialize(serde_path_to_error::Deserializer::new(&mut deserializer, &mut track));
    read.and_then(|read| deserializer.end().map(|()| read)).map_err(|error| serde_path_to_error::Error::new(track.path(), error))
}

/// What the reader says, and the line and column that it appends to that where it read a text: it gives its words in no other way.
fn words(error: &serde_json::Error) -> (String, Option<[usize; 2]>) {
    let (said, [line, column]) = (error.to_string(), [error.line(), error.column()]);
    match said.strip_suffix(&format!(" at line {line} column {column}")) {
        Some(words) => (words.into(), Some([line, column])),
        None => (said, None),
    }
}

/// A text that the program itself holds.
pub(crate) type Constant = &'static str;

/// The longest constant that is read, in bytes.
const LONGEST: usize = 200;

/// Reads a constant of the program back. Each different one is kept once, for good: they are few and short.
pub(crate) fn constant<'de, D: Deserializer<'de>>(from: D) -> Result<Constant, D::Error> {
    static READ: Mutex<BTreeSet<Constant>> = Mutex::new(BTreeSet::new());
    let text = String::deserialize(from)?;
    if text.len() > LONGEST {
        return Err(D::Error::custom(format!("a text of {} bytes; allowed: {LONGEST}", text.len())));
    }
    let mut read = READ.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(known) = read.get(&text[..]) {
        return Ok(known);
    }
    let kept: Constant = text.leak();
    read.insert(kept);
    Ok(kept)
}

/// Numbers that may be none; one that is not finite stands as its text.
pub(crate) mod number {
    use serde::de::Error;
    use serde::{Deserialize, Deserializer, Serializer};
    use serde_json::Value;

    pub(crate) fn serialize<S: Serializer>(value: &f64, to: S) -> Result<S::Ok, S::Error> {
        if value.is_finite() { to.serialize_f64(*value) } else { to.collect_str(value) }
    }

    pub(crate) fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<f64, D::Error> {
        let value = Value::deserialize(from)?;
        let number = value.as_f64().or_else(|| value.as_str()?.parse().ok());
        number.ok_or_else(|| D::Error::custom("expected a number"))
    }
}

/// Numbers that may be infinite, for which JSON has null.
pub(crate) mod infinite {
    use serde::{Deserialize, Deserializer, Serializer};

    pub(crate) fn serialize<S: Serializer>(value: &f64, to: S) -> Result<S::Ok, S::Error> {
        to.serialize_f64(*value)
    }

    pub(crate) fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<f64, D::Error> {
        Option::deserialize(from).map(|value| value.unwrap_or(f64::INFINITY))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde::Deserialize;

    #[derive(Debug, Deserialize)]
    #[serde(deny_unknown_fields)]
    #[allow(dead_code, reason = "only their types are read")]
    struct Camera {
        name: String,
        place: [f64; 2],
        reach: f64,
    }

    #[derive(Debug, Deserialize)]
    #[allow(dead_code, reason = "only their types are read")]
    struct File {
        cameras: Vec<Camera>,
    }

    #[test]
    fn what_is_refused_is_named_by_its_field_and_place() {
        let whole = r#"{"cameras": [{"name": "a", "place": [1, 2], "reach": 3}]}"#;
        from_text::<File>(whole).unwrap();
        for (from, to, told) in [
            ("\"a\"", "7", "cameras[0].name: invalid type: integer `7`, expected a string at line 1 column "),
            ("2]", "\"2\"]", "cameras[0].place[1]: invalid type: string \"2\", expected f64 at line 1 column "),
            ("\"name\"", "\"nam\"", "cameras[0].nam: unknown field `nam`"),
            ("\"name\": \"a\", ", "", "cameras[0]: missing field `name` at line 1 column "),
            (whole, "", "EOF while parsing a value at line 1 column "),
            (": [{\"name\": \"a\", \"place\": [1, 2], \"reach\": 3}]}", "", "EOF while parsing an object at line 1 column "),
            (", \"reach\": 3}]}", "", "cameras[0]: EOF while parsing an object at line 1 column "),
            (", \"reach\": 3}]}", ", ", "cameras[0]: EOF while parsing a value at line 1 column "),
            ("}]}", "}]} 3", "trailing characters"),
        ] {
            let reason = from_text::<File>(&whole.replacen(from, to, 1)).unwrap_err().to_string();
            assert!(reason.starts_with(told), "{told}: {reason}");
        }
        let reason = from_value::<File>(&serde_json::json!({"cameras": [{"name": "a", "place": [1, null], "reach": 3}]})).unwrap_err();
        assert_eq!(reason.to_string(), "cameras[0].place[1]: invalid type: null, expected f64");
    }
}
