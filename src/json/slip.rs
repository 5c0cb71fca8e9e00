//! The error of the reader: what is wrong, and the path to it.

use super::{JsonFault, JsonKind, JsonSlip, JsonWanted};
use serde::de::{Error, Expected, Unexpected};
use serde_json::Value;
use std::fmt::{self, Display, Formatter};

/// What is wrong with a value, and where it stands.
#[derive(Debug)]
pub(super) struct Slip(Box<Found>);

#[derive(Debug)]
struct Found {
    what: What,
    /// From the innermost.
    path: Vec<Segment>,
    /// The byte at which the value begins.
    at: Option<usize>,
    /// What was got, where nobody has said yet where it stands.
    sought: Option<Value>,
}

#[derive(Debug)]
enum What {
    Slip(JsonSlip),
    /// In words of who reads the value.
    Words(String),
}

#[derive(Debug, Clone)]
pub(super) enum Segment {
    Field(String),
    Item(usize),
}

/// The longest single value that is repeated to who gave it, in bytes.
const LONGEST: usize = 60;

impl Slip {
    pub fn of(slip: JsonSlip) -> Self {
        Self::new(What::Slip(slip))
    }

    /// Of a value, as JSON writes it where it is a single one.
    pub fn other(kind: JsonKind, single: &str, json_wanted: JsonWanted) -> Self {
        let is_said = !matches!(kind, JsonKind::List | JsonKind::Object) && single.len() <= LONGEST;
        Self::of(match is_said {
            true => JsonSlip::OtherValue { value: single.into(), json_wanted },
            false => JsonSlip::OtherKind { json_kind: kind, json_wanted },
        })
    }

    fn new(what: What) -> Self {
        Self(Box::new(Found { what, path: Vec::new(), at: None, sought: None }))
    }

    fn seeking(mut self, value: Value) -> Self {
        self.0.sought = Some(value);
        self
    }

    pub fn within(mut self, segment: Segment) -> Self {
        self.0.path.push(segment);
        self
    }

    /// That it stands at a byte, where nobody has said so.
    pub fn at(mut self, start: usize) -> Self {
        self.0.at.get_or_insert(start);
        self
    }

    /// The same of a list of which so many items are wanted.
    pub fn of_list(mut self, wanted: usize) -> Self {
        if let (What::Slip(JsonSlip::OtherLength { wanted_items: items @ None, .. }), true) = (&mut self.0.what, self.0.path.is_empty()) {
            *items = Some(wanted);
            self.0.sought = None;
        }
        self
    }

    /// Enums that are told apart by a field are read whole before their fields are: of these it is found again what was got, where it stands
    /// in one place only.
    pub fn found_in(mut self, text: &str) -> Self {
        if let Some(sought) = self.0.sought.take() {
            let mut places = Vec::new();
            search(&serde_json::from_str(text).unwrap_or_default(), &sought, &mut Vec::new(), &mut places);
            if let [place] = &mut places[..] {
                place.reverse();
                self.0.path.splice(0..0, place.drain(..));
            }
        }
        self
    }

    /// The fault, with its place in the text that was read.
    pub fn fault(self, text: &str) -> JsonFault {
        let Found { what, path, at, .. } = *self.0;
        let before = at.and_then(|at| text.get(..at));
        let line = before.map(|before| before.matches('\n').count() + 1);
        let column = before.map(|before| before.chars().rev().take_while(|c| *c != '\n').count() + 1);
        let mut field = String::new();
        for segment in path.iter().rev() {
            match segment {
                Segment::Field(name) if field.is_empty() => field.push_str(name),
                Segment::Field(name) => field.extend([".", name]),
                Segment::Item(index) => field.push_str(&format!("[{index}]")),
            }
        }
        let field = Some(field).filter(|field| !field.is_empty());
        match (what, field) {
            (What::Slip(json_slip), field) => JsonFault::Value { field, json_slip: Box::new(json_slip), line, column },
            (What::Words(words), Some(field)) => JsonFault::Field { field, words, line, column },
            (What::Words(words), None) => JsonFault::Text { words, line, column },
        }
    }
}

/// The paths to what was got, from the outermost.
fn search(value: &Value, sought: &Value, path: &mut Vec<Segment>, places: &mut Vec<Vec<Segment>>) {
    let is_it = match (value, sought) {
        // Of these only the number of items is known, or nothing.
        (Value::Array(items), Value::Array(wanted)) => wanted.is_empty() || items.len() == wanted.len(),
        (Value::Object(_), Value::Object(_)) => !path.is_empty(),
        _ => value == sought,
    };
    if is_it {
        places.push(path.clone());
    }
    let mut inside = |segment: Segment, value: &Value| {
        path.push(segment);
        search(value, sought, path, places);
        path.pop();
    };
    match value {
        Value::Array(items) => items.iter().enumerate().for_each(|(index, item)| inside(Segment::Item(index), item)),
        Value::Object(fields) => fields.iter().for_each(|(name, value)| inside(Segment::Field(name.clone()), value)),
        _ => {}
    }
}

/// What the reader of a match of a pair says that it wants.
pub(crate) const MATCH: &str = "a match of a pair";

/// What a reader of the standard types wants, by the name that it gives it.
fn wanted(expected: &dyn Expected) -> JsonWanted {
    let kind = |json_kind| JsonWanted::OfKind { json_kind };
    let whole = |min: f64, max: f64| JsonWanted::Whole { min, max };
    match &expected.to_string()[..] {
        "f32" | "f64" => kind(JsonKind::Number),
        "u8" => whole(0.0, u8::MAX.into()),
        "u16" => whole(0.0, u16::MAX.into()),
        "u32" | "usize" => whole(0.0, u32::MAX.into()),
        "u64" => whole(0.0, u64::MAX as f64),
        "i32" => whole(i32::MIN.into(), i32::MAX.into()),
        "i64" | "isize" => whole(i64::MIN as f64, i64::MAX as f64),
        "a string" | "a borrowed string" => kind(JsonKind::Text),
        "a boolean" => kind(JsonKind::Boolean),
        "a sequence" => kind(JsonKind::List),
        "a map" => kind(JsonKind::Object),
        "unit" => kind(JsonKind::Null),
        MATCH => JsonWanted::Match,
        name if name.starts_with("an array of length ") || name.starts_with("a tuple of size ") => kind(JsonKind::List),
        name if name.starts_with("struct ") => kind(JsonKind::Object),
        _ => JsonWanted::Other,
    }
}

/// What was got; of a list and an object only that it is one.
fn got(unexpected: Unexpected) -> Value {
    match unexpected {
        Unexpected::Bool(is) => is.into(),
        Unexpected::Unsigned(number) => number.into(),
        Unexpected::Signed(number) => number.into(),
        Unexpected::Float(number) => number.into(),
        Unexpected::Char(letter) => letter.to_string().into(),
        Unexpected::Str(text) => text.into(),
        Unexpected::Seq | Unexpected::Bytes(_) | Unexpected::TupleVariant => Value::Array(Vec::new()),
        Unexpected::Map | Unexpected::StructVariant | Unexpected::NewtypeVariant => Value::Object(serde_json::Map::new()),
        _ => Value::Null,
    }
}

impl Error for Slip {
    fn custom<T: Display>(words: T) -> Self {
        Self::new(What::Words(words.to_string()))
    }

    fn invalid_type(unexpected: Unexpected, expected: &dyn Expected) -> Self {
        let got = got(unexpected);
        Self::other(JsonKind::of(&got), &got.to_string(), wanted(expected)).seeking(got)
    }

    fn invalid_value(unexpected: Unexpected, expected: &dyn Expected) -> Self {
        Self::invalid_type(unexpected, expected)
    }

    fn invalid_length(items: usize, _: &dyn Expected) -> Self {
        Self::of(JsonSlip::OtherLength { items, wanted_items: None }).seeking(vec![Value::Null; items].into())
    }

    fn unknown_variant(variant: &str, known: &'static [&'static str]) -> Self {
        let word = Value::from(variant);
        Self::other(JsonKind::Text, &word.to_string(), JsonWanted::Words { words: known.join(", ") }).seeking(word)
    }

    fn unknown_field(field: &str, known: &'static [&'static str]) -> Self {
        let known = Some(known.join(", ")).filter(|known| !known.is_empty());
        Self::of(JsonSlip::UnknownField { known }).within(Segment::Field(field.into()))
    }

    fn missing_field(field: &'static str) -> Self {
        Self::of(JsonSlip::Missing).within(Segment::Field(field.into()))
    }

    fn duplicate_field(field: &'static str) -> Self {
        Self::of(JsonSlip::Twice).within(Segment::Field(field.into()))
    }
}

impl Display for Slip {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match &self.0.what {
            What::Slip(slip) => slip.fmt(f),
            What::Words(words) => f.write_str(words),
        }
    }
}

impl std::error::Error for Slip {}
