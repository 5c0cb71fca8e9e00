//! JSON texts and values read into plain data; where one is refused, the field is named.
//!
//! All goes through one reader of texts: for each other one the module would hold the code of every type once more.

mod fault;
mod key;
mod reader;
mod slip;
mod syntax;
mod tokens;

pub use fault::{JsonFault, JsonKind, JsonSlip, JsonWanted};
pub use syntax::JsonSyntax;

pub(crate) use slip::MATCH;

use reader::Reader;
use serde::de::{DeserializeOwned, Error, IgnoredAny};
use serde::{Deserialize, Deserializer};
use serde_json::Value;
use std::collections::BTreeSet;
use std::marker::PhantomData;
use std::sync::{Mutex, PoisonError};
use tokens::Tokens;

/// Reads a JSON text; or says which field is wrong, and why.
pub(crate) fn from_text<T: DeserializeOwned>(text: &str) -> Result<T, JsonFault> {
    // What follows reads a text that is JSON.
    if let Err(error) = serde_json::from_str::<IgnoredAny>(text) {
        // Of a value the library says more of what is wrong.
        return Err(serde_json::from_str::<Value>(text).err().unwrap_or(error).into());
    }
    Reader::of(&mut Tokens::of(text)).value(PhantomData).map_err(|slip| slip.fault(text))
}

/// Reads a JSON value that stands in no text: nobody could look up the place of what is refused.
pub(crate) fn from_value<T: DeserializeOwned>(value: &Value) -> Result<T, JsonFault> {
    from_text(&value.to_string()).map_err(|fault| match fault {
        JsonFault::Value { field, json_slip, .. } => JsonFault::Value { field, json_slip, line: None, column: None },
        JsonFault::Syntax { json_syntax, .. } => JsonFault::Syntax { json_syntax, line: None, column: None },
        JsonFault::Field { field, words, .. } => JsonFault::Field { field, words, line: None, column: None },
        JsonFault::Text { words, .. } => JsonFault::Text { words, line: None, column: None },
    })
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
    use serde::de::{Error, Unexpected};
    use serde::{Deserialize, Deserializer, Serializer};
    use serde_json::Value;

    pub(crate) fn serialize<S: Serializer>(value: &f64, to: S) -> Result<S::Ok, S::Error> {
        if value.is_finite() { to.serialize_f64(*value) } else { to.collect_str(value) }
    }

    pub(crate) fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<f64, D::Error> {
        let value = Value::deserialize(from)?;
        let number = value.as_f64().or_else(|| value.as_str()?.parse().ok());
        number.ok_or_else(|| D::Error::invalid_type(Unexpected::Other("no number"), &"f64"))
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
    use std::collections::BTreeMap;

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
            ("\"a\"", "7", "cameras[0].name: got 7; allowed: a text at line 1 column 23"),
            ("2]", "\"2\"]", "cameras[0].place[1]: got \"2\"; allowed: a number at line 1 column "),
            ("[1, 2]", "[1, 2, 3]", "cameras[0].place: got a list of 3; allowed: a list of 2 at line 1 column "),
            ("[1, 2]", "[1]", "cameras[0].place: got a list of 1; allowed: a list of 2 at line 1 column "),
            ("[1, 2]", "{}", "cameras[0].place: got an object; allowed: a list at line 1 column "),
            ("\"name\"", "\"nam\"", "cameras[0].nam: unknown field; allowed: name, place, reach at line 1 column 15"),
            ("\"name\": \"a\", ", "", "cameras[0].name: missing at line 1 column 14"),
            ("\"reach\": 3", "\"reach\": 3, \"reach\": 3", "cameras[0].reach: given twice at line 1 column "),
            ("3}", "1e999}", "cameras[0].reach: got 1e999; allowed: a number at line 1 column "),
            (whole, "", "the text ends before its value does at line 1 column "),
            (": [{\"name\": \"a\", \"place\": [1, 2], \"reach\": 3}]}", "", "the text ends before its value does at line 1 column "),
            (", \"reach\": 3}]}", ", ", "the text ends before its value does at line 1 column "),
            ("}]}", "}]} 3", "more text follows the value"),
        ] {
            let reason = from_text::<File>(&whole.replacen(from, to, 1)).unwrap_err().to_string();
            assert!(reason.starts_with(told), "{told}: {reason}");
        }
        let reason = from_value::<File>(&serde_json::json!({"cameras": [{"name": "a", "place": [1, null], "reach": 3}]})).unwrap_err();
        assert_eq!(reason.to_string(), "cameras[0].place[1]: got null; allowed: a number");
        let reason = from_text::<File>("{\"cameras\":\n  [true]}").unwrap_err();
        assert_eq!(reason.to_string(), "cameras[0]: got true; allowed: an object at line 2 column 4");
    }

    /// Readers of libraries fill the fields of an object from a list, in an order that nobody wrote down.
    #[test]
    fn a_list_is_no_object() {
        for (given, told) in [
            ("[[]]", "got a list; allowed: an object at line 1 column 1"),
            ("{\"cameras\": [[\"a\", [1, 2], 3]]}", "cameras[0]: got a list; allowed: an object at line 1 column 14"),
        ] {
            assert_eq!(from_text::<File>(given).unwrap_err().to_string(), told);
        }
    }

    #[derive(Debug, PartialEq, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
    enum Edit {
        Move { point: u32, to: [f64; 2] },
        Name { text: String, of: BTreeMap<String, i8>, form: Form },
    }

    #[derive(Debug, PartialEq, Deserialize)]
    #[serde(rename_all = "kebab-case")]
    enum Form {
        Plain,
        WithSize { size: Option<u8> },
    }

    #[test]
    fn fields_of_enums_that_are_told_apart_by_a_field_are_named() {
        for (given, told) in [
            (r#"[{"kind": "move", "point": "4", "to": [1, 2]}]"#, "[0].point: got \"4\"; allowed: whole numbers from 0 to 4294967295"),
            (r#"[{"kind": "move", "point": 4, "to": [1, "2"]}]"#, "[0].to[1]: got \"2\"; allowed: a number"),
            (r#"[{"kind": "move", "point": 4, "to": [1]}]"#, "[0].to: got a list of 1"),
            (r#"[{"kind": "move", "point": 4.5, "to": [1, 2]}]"#, "[0].point: got 4.5; allowed: whole numbers from 0 to 4294967295"),
            (r#"[{"kind": "move", "point": 4, "to": {}}]"#, "[0].to: got an object; allowed: a list"),
            (r#"[{"kind": "go", "point": 4}]"#, "[0].kind: got \"go\"; allowed: move, name"),
            (r#"[{"kind": "move", "to": [1, 2]}]"#, "[0].point: missing"),
            (r#"[{"kind": "move", "point": 4, "at": 1}]"#, "[0].at: unknown field; allowed: point, to"),
            (r#"[{"point": 4, "to": [1, 2]}]"#, "[0].kind: missing"),
            (r#"[4]"#, "[0]: got 4; allowed: "),
        ] {
            let reason = from_text::<Vec<Edit>>(given).unwrap_err().to_string();
            assert!(reason.starts_with(told), "{told}: {reason}");
        }
    }

    #[test]
    fn a_variant_is_named_by_its_word_and_what_it_holds_by_its_fields() {
        for (given, told) in [
            ("\"bare\"", "got \"bare\"; allowed: plain, with-size at line 1 column 1"),
            ("7", "got 7; allowed: plain, with-size at line 1 column 1"),
            ("{}", "got an object; allowed: plain, with-size at line 1 column 1"),
            (r#"{"with-size": {"size": 256}}"#, "with-size.size: got 256; allowed: whole numbers from 0 to 255 at line 1 column 24"),
            (r#"{"with-size": [256]}"#, "with-size: got a list; allowed: an object at line 1 column 15"),
        ] {
            assert_eq!(from_text::<Form>(given).unwrap_err().to_string(), told);
        }
        assert_eq!(from_text::<Form>("\"plain\"").unwrap(), Form::Plain);
        assert_eq!(from_text::<Form>(r#"{"with-size": {"size": null}}"#).unwrap(), Form::WithSize { size: None });
    }

    #[test]
    fn what_is_written_is_read_as_it_was() {
        let text = r#" {"kind" : "name","text":"a\"b\\ \u00e9é", "of":{"3":-4 , "5":6}, "form" : {"with-size":{"size":255}}} "#;
        let of = BTreeMap::from([("3".into(), -4), ("5".into(), 6)]);
        assert_eq!(from_text::<Edit>(text).unwrap(), Edit::Name { text: "a\"b\\ éé".into(), of, form: Form::WithSize { size: Some(255) } });
        let numbers = "[0.1, -0, -0.0, 1e-7, 123456789012345678901234567890, 9007199254740993, 5e-324, 18446744073709551615]";
        let plain: Vec<f64> = serde_json::from_str(numbers).unwrap();
        let read: Vec<f64> = from_text(numbers).unwrap();
        assert_eq!(read.iter().map(|x| x.to_bits()).collect::<Vec<_>>(), plain.iter().map(|x| x.to_bits()).collect::<Vec<_>>());
        let any = r#"{"a":[1,-2,0.5,{"b":[]},[[]],{}],"c":null,"d":true,"e":"\n","f":{"g":{}}}"#;
        assert_eq!(from_text::<Value>(any).unwrap(), serde_json::from_str::<Value>(any).unwrap());
    }

    #[test]
    fn a_text_that_nests_without_end_is_refused() {
        let reason = from_text::<Value>(&("[".repeat(100_000) + &"]".repeat(100_000))).unwrap_err().to_string();
        assert!(reason.contains("allowed: up to 128 levels"), "{}", &reason[reason.len().saturating_sub(200)..]);
    }
}
