//! JSON texts and values read into plain data; where one is refused, the field is named.
//!
//! All goes through one reader of texts: for each other one the module would hold the code of every type once more.

use serde::de::{DeserializeOwned, Error};
use serde::{Deserialize, Deserializer};
use serde_json::Value;
use serde_path_to_error::Track;
use std::collections::BTreeSet;
use std::sync::{Mutex, PoisonError};

/// Reads a JSON text; or says which field is wrong, and why.
pub(crate) fn from_text<T: DeserializeOwned>(text: &str) -> Result<T, String> {
    read(text).map_err(in_words)
}

/// Reads a JSON value that stands in no text: nobody could look up the place of what is refused.
pub(crate) fn from_value<T: DeserializeOwned>(value: &Value) -> Result<T, String> {
    read(&value.to_string()).map_err(|error| {
        let place = format!(" at line {} column {}", error.inner().line(), error.inner().column());
        let reason = in_words(error);
        reason.strip_suffix(&place).map_or(reason.clone(), str::to_string)
    })
}

fn read<T: DeserializeOwned>(text: &str) -> Result<T, serde_path_to_error::Error<serde_json::Error>> {
    let mut deserializer = serde_json::Deserializer::from_str(text);
    let mut track = Track::new();
    let read = T::deserialize(serde_path_to_error::Deserializer::new(&mut deserializer, &mut track));
    read.and_then(|read| deserializer.end().map(|()| read)).map_err(|error| serde_path_to_error::Error::new(track.path(), error))
}

fn in_words(error: serde_path_to_error::Error<serde_json::Error>) -> String {
    match error.path().iter().next() {
        Some(_) => error.to_string(),
        None => error.into_inner().to_string(),
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
            ("}]}", "}]} 3", "trailing characters"),
        ] {
            let reason = from_text::<File>(&whole.replacen(from, to, 1)).unwrap_err();
            assert!(reason.starts_with(told), "{told}: {reason}");
        }
        let reason = from_value::<File>(&serde_json::json!({"cameras": [{"name": "a", "place": [1, null], "reach": 3}]})).unwrap_err();
        assert_eq!(reason, "cameras[0].place[1]: invalid type: null, expected f64");
    }
}
