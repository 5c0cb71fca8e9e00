//! Why a JSON text was refused, in words: what was got, and what is allowed.

use crate::text::shorten;
use serde_json::error::Category;

/// The reason, without its place.
pub(crate) fn reason(error: &serde_json::Error) -> String {
    worded(error, "")
}

/// The reason with its line and column, counted from 1.
pub(crate) fn reason_in_text(error: &serde_json::Error) -> String {
    // Before its first character a text has neither.
    match (error.line(), error.column()) {
        (0, _) => worded(error, ""),
        (line, 0) => worded(error, &format!(" in line {line}")),
        (line, column) => worded(error, &format!(" in line {line}, column {column}")),
    }
}

fn worded(error: &serde_json::Error, place: &str) -> String {
    let text = error.to_string();
    let told = text.rsplit_once(" at line ").map_or(&text[..], |(told, _)| told);
    match error.classify() {
        Category::Eof => format!("it ends{place} before it is complete; allowed: one JSON object"),
        Category::Syntax | Category::Io => format!("it is no JSON{place}: {told}"),
        Category::Data => match told.split_once(", expected ") {
            Some((wrong, expected)) => {
                format!("{}{place}; allowed: {}", got(wrong).map_or_else(|| wrong.into(), |got| format!("got {got}")), allowed(expected))
            }
            None => format!("{told}{place}"),
        },
    }
}

/// What a value is in the words of JSON; `None` where the message is about a name.
fn got(wrong: &str) -> Option<String> {
    if let Some(length) = wrong.strip_prefix("invalid length ") {
        return Some(format!("a list of {length}"));
    }
    let value = wrong.strip_prefix("invalid type: ").or_else(|| wrong.strip_prefix("invalid value: "))?;
    let quoted = |kind: &str| value.strip_prefix(kind).map(|rest| rest.trim_matches('`').to_string());
    let number = || quoted("integer ").or_else(|| quoted("floating point ")).or_else(|| quoted("boolean "));
    let text = || value.strip_prefix("string ").map(|text| format!("the text {}", shorten(text)));
    Some(number().or_else(text).unwrap_or_else(|| match value {
        "map" => "an object".into(),
        "sequence" => "a list".into(),
        other => shorten(other),
    }))
}

fn allowed(expected: &str) -> String {
    const NUMBERS: [(&[&str], &str); 3] = [
        (&["f32", "f64"], "a number"),
        (&["u8", "u16", "u32", "u64", "usize"], "a whole number of 0 or more"),
        (&["i8", "i16", "i32", "i64", "isize"], "a whole number"),
    ];
    if let Some((_, words)) = NUMBERS.iter().find(|(names, _)| names.contains(&expected)) {
        return (*words).into();
    }
    match expected {
        "a string" | "string" => "a text".into(),
        "a boolean" => "true or false".into(),
        "a sequence" => "a list".into(),
        "a map" => "an object".into(),
        _ if expected.starts_with("struct ") || expected.contains("tagged enum") => "an object".into(),
        _ => match expected.strip_prefix("an array of length ") {
            Some(length) => format!("a list of {length}"),
            None => expected.into(),
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde::Deserialize;

    #[derive(Debug, Deserialize)]
    #[serde(deny_unknown_fields)]
    #[allow(dead_code, reason = "only their types are read")]
    struct Values {
        number: f64,
        count: usize,
        name: String,
        place: [f64; 2],
        is_fixed: bool,
        list: Vec<f64>,
    }

    #[test]
    fn no_message_names_a_type_of_the_program() {
        let whole = r#"{"number": 1.5, "count": 2, "name": "a", "place": [1, 2], "is_fixed": true, "list": []}"#;
        serde_json::from_str::<Values>(whole).unwrap();
        for (from, to, told) in [
            ("1.5", "\"1,5\"", "got the text \"1,5\" in line 1, column 16; allowed: a number"),
            ("1.5", "null", "got null in line 1, column 15; allowed: a number"),
            ("1.5", "[1]", "got a list in line 1, column 11; allowed: a number"),
            ("\"count\": 2", "\"count\": -2", "got -2 in line 1, column 27; allowed: a whole number of 0 or more"),
            ("\"count\": 2", "\"count\": 2.5", "got 2.5 in line 1, column 28; allowed: a whole number of 0 or more"),
            ("\"a\"", "7", "got 7 in line 1, column 37; allowed: a text"),
            ("[1, 2]", "[1]", "got a list of 1 in line 1, column 53; allowed: a list of 2"),
            ("true", "1", "got 1 in line 1, column 71; allowed: true or false"),
            ("[]}", "{}}", "got an object in line 1, column 84; allowed: a list"),
            ("\"name\"", "\"nam\"", "unknown field `nam` in line 1, column 33; allowed: one of `number`, `count`"),
            ("\"name\": \"a\", ", "", "missing field `name` in line 1, column 74"),
            (whole, "", "it ends in line 1 before it is complete; allowed: one JSON object"),
            ("true,", "true", "it is no JSON in line 1, column 76: expected `,` or `}`"),
            (whole, "[]", "got a list of 0 in line 1, column 2; allowed: an object"),
            (whole, "3", "got 3 in line 1, column 1; allowed: an object"),
        ] {
            let text = whole.replacen(from, to, 1);
            let error = serde_json::from_str::<Values>(&text).unwrap_err();
            assert!(reason_in_text(&error).starts_with(told), "{told}: {}", reason_in_text(&error));
            assert!(!reason(&error).contains("line"), "{}", reason(&error));
        }
    }
}
