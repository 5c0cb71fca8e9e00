//! Text that people and spreadsheets write: its records with their lines, and its pieces in messages.

use crate::Error;
use csv::{ReaderBuilder, StringRecord, Trim};
#[cfg(not(target_arch = "wasm32"))]
use std::cmp::Ordering;

/// The records of a text and the line of each, counted from 1: fields between semicolons, commas or tabs, whichever of them the first record
/// has, in this order. Blank lines, lines of separators alone as spreadsheets leave them, and lines that begin with `#` are skipped.
///
/// # Errors
/// [`Error::InvalidInput`] of `what`, where no records can be told.
pub(crate) fn records(what: &'static str, text: &str) -> Result<Vec<(usize, StringRecord)>, Error> {
    let text = text.trim_start_matches('\u{feff}');
    let first = text.lines().find(|line| is_data(line)).unwrap_or("");
    let delimiter = *[b';', b',', b'\t'].iter().find(|byte| first.as_bytes().contains(byte)).unwrap_or(&b',');
    let mut reader = ReaderBuilder::new()
        .delimiter(delimiter)
        .comment(Some(b'#'))
        .trim(Trim::All)
        .flexible(true)
        .has_headers(false)
        .from_reader(text.as_bytes());
    let mut records = Vec::new();
    let mut lines = Lines { text, place: 0, line: 1 };
    for record in reader.records() {
        let record = record.map_err(|error| Error::InvalidInput {
            what,
            got: error.to_string(),
            allowed: "lines of fields between commas, semicolons or tabs".into(),
        })?;
        let line = lines.of(&record);
        if record.iter().any(|field| !field.is_empty()) {
            records.push((line, record));
        }
    }
    Ok(records)
}

/// The beginning of a text, for a message of one line.
pub(crate) fn shorten(text: &str) -> String {
    const LONGEST: usize = 60;
    let printable = text.chars().map(|c| if c.is_control() { ' ' } else { c });
    if text.chars().count() <= LONGEST { printable.collect() } else { printable.take(LONGEST).chain("…".chars()).collect() }
}

fn is_data(line: &str) -> bool {
    !line.trim().is_empty() && !line.starts_with('#')
}

/// Counts lines up to one record after the other; the reader's own position is that of the blank lines and comments before a record.
struct Lines<'a> {
    text: &'a str,
    place: usize,
    line: usize,
}

impl Lines<'_> {
    fn of(&mut self, record: &StringRecord) -> usize {
        let start = record.position().map_or(0, |position| position.byte() as usize).clamp(self.place, self.text.len());
        self.line += self.text.as_bytes()[self.place..start].iter().filter(|byte| **byte == b'\n').count();
        self.place = start;
        let skipped = self.text.get(start..).unwrap_or("").lines().take_while(|line| !is_data(line)).count();
        self.line + skipped
    }
}

/// The order of names by their letters and by the numbers in them: `photo_9` comes before `photo_10`.
#[cfg(not(target_arch = "wasm32"))]
pub fn by_numbers(a: &str, b: &str) -> Ordering {
    let parts = |text: &str| -> Vec<String> {
        let mut parts: Vec<String> = Vec::new();
        let mut was_digit = None;
        for c in text.chars() {
            let is_digit = c.is_ascii_digit();
            match parts.last_mut().filter(|_| was_digit == Some(is_digit)) {
                Some(part) => part.push(c),
                None => parts.push(c.into()),
            }
            was_digit = Some(is_digit);
        }
        parts
    };
    let (left, right) = (parts(a), parts(b));
    // Numbers of any length: of two without leading zeros the longer one is larger.
    let is_number = |part: &str| part.starts_with(|c: char| c.is_ascii_digit());
    let bare = |part: &str| {
        let zeros = if is_number(part) { part.bytes().take(part.len() - 1).take_while(|byte| *byte == b'0').count() } else { 0 };
        part[zeros..].to_string()
    };
    let compared = left.iter().zip(&right).map(|(one, other)| {
        let length = if is_number(one) && is_number(other) { bare(one).len().cmp(&bare(other).len()) } else { Ordering::Equal };
        length.then(bare(one).cmp(&bare(other)))
    });
    compared.fold(Ordering::Equal, Ordering::then).then(left.len().cmp(&right.len())).then(a.cmp(b))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lines(text: &str) -> Vec<(usize, Vec<String>)> {
        let records = records("the text", text).unwrap();
        records.iter().map(|(line, record)| (*line, record.iter().map(String::from).collect())).collect()
    }

    #[test]
    fn records_know_their_lines_among_comments_and_blanks() {
        let wanted = [(3, vec!["a".to_string(), "b".into()]), (7, vec!["c".into(), "d".into()])];
        assert_eq!(lines("\u{feff}# one\r\n\r\na,b\r\n \r\n#\r\n,,\r\nc , d"), wanted);
        assert!(lines("").is_empty());
    }

    #[test]
    fn the_first_record_tells_what_separates() {
        for text in ["# a,b\nx;1,5", "x\t1,5"] {
            let fields = &lines(text)[0].1;
            assert_eq!(fields.len(), 2, "{text}: {fields:?}");
        }
    }

    #[test]
    fn messages_are_short_and_printable() {
        assert_eq!(shorten("a\tb"), "a b");
        assert_eq!(shorten(&"x".repeat(100)).chars().count(), 61);
    }
}
