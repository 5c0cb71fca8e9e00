//! The texts of messages in one language, from a catalogue in the syntax of Project Fluent.

use super::family::Message;
use fluent_bundle::concurrent::FluentBundle;
use fluent_bundle::{FluentArgs, FluentResource, FluentValue};
use serde_json::Value;
use std::sync::OnceLock;

/// Lists are named one by one up to so many.
const NAMED: usize = 5;

/// Fields that are messages themselves: the names of their families.
pub(super) const NESTED: [&str; 49] = [
    "allowed",
    "axis",
    "block_warning",
    "camera",
    "camera_caution",
    "camera_parameter",
    "cause",
    "computation",
    "control_apart",
    "damage",
    "described",
    "document",
    "element",
    "error",
    "failure",
    "few",
    "file_fault",
    "file_kind",
    "file_place",
    "image_fault",
    "image_operation",
    "input",
    "interruption",
    "json_fault",
    "json_kind",
    "json_slip",
    "json_syntax",
    "json_wanted",
    "location",
    "mistake",
    "no_geometry",
    "no_orientation",
    "not_linked",
    "not_placed",
    "observed",
    "place_slip",
    "outcome",
    "overview_warning",
    "placing_weakness",
    "point_name",
    "refusal",
    "remark",
    "rule",
    "side",
    "unit",
    "unoriented",
    "unsettled",
    "unsupported",
    "warning",
];

/// The texts of one language.
///
/// What a language has no text for is given in English.
pub struct Texts {
    bundle: FluentBundle<FluentResource>,
}

const ENGLISH: &str = concat!(include_str!("../catalogue/en.ftl"), include_str!("../catalogue/en-report.ftl"));
/// Options have their English where they are declared.
const ARABIC: &str =
    concat!(include_str!("../catalogue/ar.ftl"), include_str!("../catalogue/ar-report.ftl"), include_str!("../catalogue/ar-options.ftl"));

impl Texts {
    /// Of English.
    pub fn english() -> &'static Self {
        static TEXTS: OnceLock<Texts> = OnceLock::new();
        TEXTS.get_or_init(|| Self::new("en", ENGLISH))
    }

    /// Of Arabic. What a text writes is set apart by marks of direction: names, units and signs keep theirs among words from right to left.
    pub fn arabic() -> &'static Self {
        static TEXTS: OnceLock<Texts> = OnceLock::new();
        TEXTS.get_or_init(|| {
            let mut texts = Self::new("ar", ARABIC);
            texts.bundle.set_use_isolating(true);
            texts
        })
    }

    /// Of the language of a tag; English where there is no catalogue of it.
    pub fn of(language: &str) -> &'static Self {
        match language.split(['-', '_']).next() {
            Some(tag) if tag.eq_ignore_ascii_case("ar") => Self::arabic(),
            _ => Self::english(),
        }
    }

    /// Of the language of a tag (`de`, `pt-BR`), from its catalogue. Entries that cannot be read are skipped. A tag that is none has the
    /// plurals of English.
    pub fn new(language: &str, catalogue: &str) -> Self {
        let tag = language.parse().or_else(|_| "en".parse()).expect("a tag of a language");
        let mut bundle = FluentBundle::new_concurrent(vec![tag]);
        // Terminals and tables take no marks of direction.
        bundle.set_use_isolating(false);
        let resource = FluentResource::try_new(catalogue.into()).unwrap_or_else(|(readable, _)| readable);
        bundle.add_resource_overriding(resource);
        for (name, format) in FORMATS {
            bundle.add_function(name, move |given, named| formatted(given, named, format)).expect("each name once");
        }
        bundle.add_function("LIKE", like).expect("each name once");
        Self { bundle }
    }

    /// The text of a message.
    pub fn text<M: Message + ?Sized>(&self, message: &M) -> String {
        self.text_of(M::FAMILY, &serde_json::to_value(message).unwrap_or_default(), None)
    }

    /// What a list or a legend calls a message.
    pub(crate) fn label<M: Message>(&self, message: &M) -> String {
        self.text_of(M::FAMILY, &serde_json::to_value(message).unwrap_or_default(), Some("label"))
    }

    /// The text of a message of a family, or an attribute of it, from its JSON form.
    pub(crate) fn text_of(&self, family: &str, message: &Value, attribute: Option<&str>) -> String {
        let id = Self::id_of(family, message);
        let mut figures = FluentArgs::new();
        for (name, value) in message.as_object().into_iter().flatten() {
            self.add(&mut figures, &id, name, value);
        }
        self.entry(&id, attribute, &figures)
    }

    /// What catalogues call a message of a family, by its JSON form.
    pub(crate) fn id_of(family: &str, message: &Value) -> String {
        let kind = message.as_str().or_else(|| message.get("kind")?.as_str());
        kind.map_or_else(|| family.to_string(), |kind| format!("{family}-{kind}")).replace('_', "-")
    }

    /// Whether there is a text of a message, or an attribute of it.
    pub(crate) fn has(&self, id: &str, attribute: Option<&str>) -> bool {
        let entry = self.bundle.get_message(id);
        entry.is_some_and(|entry| match attribute {
            None => entry.value().is_some(),
            Some(name) => entry.get_attribute(name).is_some(),
        })
    }

    /// Whether this language or English has a text of a message of a family.
    fn knows(&self, family: &str, message: &Value) -> bool {
        let id = Self::id_of(family, message);
        self.has(&id, None) || Self::english().has(&id, None)
    }

    pub(super) fn entry(&self, id: &str, attribute: Option<&str>, figures: &FluentArgs) -> String {
        let entry = self.bundle.get_message(id);
        let pattern = entry.and_then(|entry| match attribute {
            None => entry.value(),
            Some(name) => entry.get_attribute(name).map(|attribute| attribute.value()),
        });
        match pattern {
            Some(pattern) => self.bundle.format_pattern(pattern, Some(figures), &mut Vec::new()).into_owned(),
            None if std::ptr::eq(self, Self::english()) => id.into(),
            None => Self::english().entry(id, attribute, figures),
        }
    }

    /// A list gives its first items, `name_more` of them unnamed and `name_count` in all; items with fields have their text in the attribute
    /// of the list's name.
    fn add(&self, figures: &mut FluentArgs, id: &str, name: &str, value: &Value) {
        let text = match value {
            Value::Null => "none".into(),
            Value::Bool(is) => is.to_string(),
            Value::Number(number) => return figures.set(name.to_string(), number.as_f64().unwrap_or(f64::NAN)),
            _ if NESTED.contains(&name) && self.knows(name, value) => self.text_of(name, value, None),
            // Of another build, which names it otherwise.
            Value::Object(_) if NESTED.contains(&name) => "none".into(),
            Value::String(text) => text.clone(),
            Value::Array(items) => {
                figures.set(format!("{name}_count"), items.len());
                figures.set(format!("{name}_more"), items.len().saturating_sub(NAMED));
                items.iter().take(NAMED).map(|item| self.item(id, name, item)).collect::<Vec<_>>().join(", ")
            }
            Value::Object(_) => self.item(id, name, value),
        };
        figures.set(name.to_string(), text);
    }

    fn item(&self, id: &str, name: &str, item: &Value) -> String {
        match item {
            Value::String(text) => text.clone(),
            // A place or a size. JSON has null for what is no number.
            Value::Array(numbers) => {
                format!("({})", numbers.iter().map(|number| self.item(id, name, number)).collect::<Vec<_>>().join(", "))
            }
            Value::Null => "NaN".into(),
            Value::Object(fields) => {
                let mut figures = FluentArgs::new();
                fields.iter().for_each(|(field, value)| self.add(&mut figures, id, field, value));
                self.entry(id, Some(name), &figures)
            }
            other => other.to_string(),
        }
    }
}

/// How a number is written, by its digits.
type Format = fn(f64, usize) -> String;

/// The functions of catalogues beside [`like`]: the number of what is counted from 0, as people count it; hexadecimal digits; digits after the point, the same without a sign, significant digits, and powers of ten;
/// a share in per cent; `minus` or `plus`, for texts that have a word for each.
pub(super) const FORMATS: [(&str, Format); 8] = [
    ("NTH", |value, _| format!("{:.0}", value + 1.0)),
    ("HEX", |value, digits| format!("{:0digits$x}", value as u64)),
    ("FIXED", fixed),
    ("AMOUNT", |value, digits| format!("{:.digits$}", value.abs())),
    ("SIGNIFICANT", significant),
    ("POWER", power),
    ("PERCENT", |value, digits| format!("{:.digits$} %", 100.0 * value)),
    ("SIGN", |value, _| if value < 0.0 { "minus".into() } else { "plus".into() }),
];

/// What rounds to zero has no sign.
fn fixed(value: f64, digits: usize) -> String {
    let text = format!("{value:.digits$}");
    match text.strip_prefix('-') {
        Some(zero) if zero.bytes().all(|byte| matches!(byte, b'0' | b'.')) => zero.into(),
        _ => text,
    }
}

/// Numbers of people's everyday as they write them.
fn power(value: f64, digits: usize) -> String {
    if (0.01..1000.0).contains(&value.abs()) { significant(value, digits + 1) } else { format!("{value:.digits$e}") }
}

fn significant(value: f64, digits: usize) -> String {
    let power = format!("{value:.*e}", digits.max(1) - 1);
    let (rounded, exponent) =
        power.split_once('e').map_or((value, 0), |(_, exponent)| (power.parse().unwrap_or(value), exponent.parse().unwrap_or(0)));
    format!("{rounded:.*}", usize::try_from(digits as i64 - 1 - exponent).unwrap_or(0))
}

/// A value with as many decimals as its error has, which is written with so many significant digits.
fn like<'a>(given: &[FluentValue<'a>], named: &FluentArgs) -> FluentValue<'a> {
    match given {
        [FluentValue::Number(value), FluentValue::Number(error)] if value.value.is_finite() && error.value.is_finite() => {
            let error = significant(error.value, digits_of(named));
            let decimals = error.split_once('.').map_or(0, |(_, decimals)| decimals.len());
            fixed(value.value, decimals).into()
        }
        _ => "–".into(),
    }
}

fn digits_of(named: &FluentArgs) -> usize {
    match named.get("digits") {
        Some(FluentValue::Number(digits)) => digits.value as usize,
        _ => 0,
    }
}

fn formatted<'a>(given: &[FluentValue<'a>], named: &FluentArgs, format: Format) -> FluentValue<'a> {
    let digits = digits_of(named);
    match given.first() {
        Some(FluentValue::Number(number)) if number.value.is_finite() => format(number.value, digits).into(),
        // Where there is no number, as where JSON has null for one that is not finite.
        _ => "–".into(),
    }
}
