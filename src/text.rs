//! Text that people and spreadsheets write: its records with their lines, and its pieces in messages.

mod digits;
mod head;
mod separator;

use crate::error::refuse;
use crate::{Error, Input, Refusal};
use csv::{Reader, ReaderBuilder, StringRecord, Trim, WriterBuilder};
use digits::in_ascii;
pub(crate) use head::Headed;
use separator::{has_thousands, is_clearly_decimal, is_data, is_decimal_comma, of_line};
use std::borrow::Cow;
#[cfg(not(target_arch = "wasm32"))]
use std::cmp::Ordering;
use std::fmt::Display;

/// What a line begins with that is no record.
const COMMENT: u8 = b'#';

/// A record with its line, counted from 1.
pub(crate) type NumberedRecord = (usize, StringRecord);

/// The records of a text, and how its numbers are written.
#[derive(Debug)]
pub(crate) struct Records {
    pub rows: Vec<NumberedRecord>,
    /// The comment directly above them, as fields.
    above: Vec<StringRecord>,
    separator: u8,
    /// Whether numbers in quotes have decimal commas between commas that separate.
    has_decimal_commas: bool,
    input: Input,
}

impl Records {
    /// A finite number. Where commas do not separate, a lone one is the decimal point, as spreadsheets of many languages write it; one that also has a point
    /// may be thousands, and is none. In quotes it is where any number of the table shows that: `"1,234"` alone may be thousands.
    pub(crate) fn number(&self, field: &str) -> Option<f64> {
        let may_have = self.separator != b',' || self.has_decimal_commas;
        let has_decimal_comma = may_have && !field.contains('.') && field.matches(',').count() == 1;
        let number = if has_decimal_comma { field.replace(',', ".").parse() } else { field.parse() };
        number.ok().filter(|number: &f64| number.is_finite())
    }

    /// What the table is.
    pub(crate) fn input(&self) -> Input {
        self.input
    }

    /// Whether commas separate, so that decimal commas would, too.
    fn has_commas(&self) -> bool {
        self.separator == b','
    }

    /// Whether commas may have cut numbers in two, being meant as decimal commas: none of these has a point.
    pub(crate) fn may_be_cut(&self, numbers: &[&str]) -> bool {
        self.has_commas() && numbers.iter().all(|field| !field.contains(['.', ',']))
    }

    /// Why a field is no number, where it has signs before thousands.
    pub(crate) fn refused_thousands(&self, field: &str, column: &str, line: usize) -> Option<Error> {
        let refusal = || Refusal::Thousands { input: self.input, word: shorten(field), column: column.into(), line };
        has_thousands(field).then(|| refusal().into_error())
    }

    /// Refuses numbers with commas all of which may stand before thousands, between tabs, blanks and commas: semicolons separate where commas are decimal ones.
    /// `columns`: those whose numbers are read; a code or a remark beside them says nothing of these.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] with the first such row.
    pub(crate) fn check_thousands(&self, rows: &[NumberedRecord], columns: &[usize]) -> Result<(), Error> {
        let with_commas = |record: &StringRecord| columns.iter().filter_map(|column| record.get(*column)).any(is_decimal_comma);
        let is_clear = |record: &StringRecord| columns.iter().filter_map(|column| record.get(*column)).any(is_clearly_decimal);
        let first = rows.iter().find(|(_, record)| with_commas(record));
        // Between commas, in quotes, none is read as decimal unless any number of the table shows that.
        let are_read = !self.has_commas() || self.has_decimal_commas;
        let may_be = are_read && self.separator != b';' && !rows.iter().any(|(_, record)| is_clear(record));
        match first.filter(|_| may_be) {
            Some((line, record)) => refuse(Refusal::ThousandsCommas { input: self.input, record: self.shown(record), line: *line }),
            None => Ok(()),
        }
    }

    /// Whether blanks separate.
    pub(crate) fn has_blanks(&self) -> bool {
        self.separator == b' '
    }

    /// A record as its line has it, for a message.
    pub(crate) fn shown(&self, record: &StringRecord) -> String {
        let separator = if self.separator == b'\t' { " ".into() } else { char::from(self.separator).to_string() };
        shorten(&record.iter().collect::<Vec<_>>().join(&separator))
    }
}

/// The records of a text: fields between semicolons, tabs, commas or blanks, whichever of them the first line has, in this order, that has fields enough
/// for a table. Tabs beside commas only align what these separate. A lone carriage return ends a line, too. Blank lines, lines of separators alone as spreadsheets leave them, and lines that begin
/// with `#` are skipped, and so are those with `//` above the first record that hold no numbers. Text that [`Row::text`] has guarded reads back as it was.
///
/// # Errors
/// [`Error::InvalidInput`] of `input`, where no records can be told, and for a field in quotes that goes on in the next line: a quote that nothing closes
/// would take the lines below into it.
pub(crate) fn records(input: Input, text: &str) -> Result<Records, Error> {
    let text = &*plain(text.trim_start_matches('\u{feff}'));
    let separator = separator::separator(text);
    let mut found = Records { rows: Vec::new(), above: Vec::new(), separator, has_decimal_commas: false, input };
    let mut reader = reader_of(text, separator);
    let mut lines = Lines { text, place: 0, line: 1 };
    for record in reader.records() {
        let record = record.map_err(|error| Refusal::NoRecords { input, words: error.to_string() }.into_error())?;
        let line = lines.of(&record);
        if record.iter().any(|field| field.contains('\n')) {
            return refuse(Refusal::QuotedLines { input, record: found.shown(&record), line });
        }
        let is_comment = found.rows.is_empty()
            && record.get(0).is_some_and(|first| first.starts_with("//"))
            && record.iter().all(|field| found.number(field).is_none());
        let is_empty = record.iter().all(str::is_empty);
        if !is_comment && !is_empty {
            let fields = record.iter().filter(|field| separator != b' ' || !field.is_empty());
            found.rows.push((line, fields.map(unguarded).map(in_ascii).collect()));
        }
    }
    let clear = |(_, record): &(usize, StringRecord)| record.iter().any(is_clearly_decimal);
    found.has_decimal_commas = separator == b',' && found.rows.iter().any(clear);
    found.above = found.rows.first().map_or_else(Vec::new, |(line, _)| above(text, *line, separator));
    Ok(found)
}

/// A text whose lines end with a line feed alone, and whose fields are between signs of ASCII: those of older spreadsheets end with a carriage return, and
/// Arabic commas and semicolons may stand between fields, where the first line of a table has no others.
fn plain(text: &str) -> Cow<'_, str> {
    let lines = if text.contains('\r') { Cow::from(text.replace("\r\n", "\n").replace('\r', "\n")) } else { text.into() };
    let first = lines.lines().find(|line| is_data(line)).unwrap_or("");
    let arabic = ARABIC.into_iter().find(|sign| first.contains(*sign) && !first.contains([';', '\t']));
    arabic.map_or_else(|| lines.clone(), |sign| lines.replace(sign, ";").into())
}

/// The Arabic semicolon and comma.
const ARABIC: [char; 2] = ['\u{61b}', '\u{60c}'];

/// Whether a cell of numbers holds none: it is empty, or has a dash for that.
pub(crate) fn is_none(field: &str) -> bool {
    matches!(field, "" | "-" | "–" | "—")
}

/// How many fields a record has up to the last one that holds something: spreadsheets write empty ones behind it.
pub(crate) fn filled(record: &StringRecord) -> usize {
    (0..record.len()).rev().find(|column| !record[*column].is_empty()).map_or(0, |last| last + 1)
}

/// The last comment above a line, as fields between what separates the records and between what it has itself.
fn above(text: &str, line: usize, separator: u8) -> Vec<StringRecord> {
    let comment = text.lines().take(line - 1).filter(|line| !line.trim().is_empty()).last();
    let is_comment = |line: &&str| line.starts_with('#') || line.starts_with("//");
    let Some(comment) = comment.filter(is_comment).map(|line| line.trim_start_matches(['#', '/', ' ', '\t'])) else { return Vec::new() };
    let own = Some(of_line(comment)).filter(|own| *own != separator);
    let fields = |separator: u8| {
        let record = reader_of(comment, separator).records().next().and_then(Result::ok)?;
        Some(record.iter().filter(|field| separator != b' ' || !field.is_empty()).collect())
    };
    std::iter::once(separator).chain(own).filter_map(fields).collect()
}

fn reader_of(text: &str, separator: u8) -> Reader<&[u8]> {
    ReaderBuilder::new()
        .delimiter(separator)
        .comment(Some(COMMENT))
        .trim(Trim::All)
        .flexible(true)
        .has_headers(false)
        .from_reader(text.as_bytes())
}

/// The cells of one row of a table.
#[derive(Debug, Default)]
pub(crate) struct Row(Vec<String>);

impl Row {
    /// Appends a text. One that a spreadsheet would run as a formula gets an apostrophe in front, by which spreadsheets know a text.
    ///
    /// # Source
    /// OWASP, CSV injection.
    pub(crate) fn text(mut self, text: &str) -> Self {
        self.0.push(guarded(text));
        self
    }

    /// Appends a number, as the shortest text that reads back as the same number.
    pub(crate) fn number(mut self, number: impl Display) -> Self {
        self.0.push(number.to_string());
        self
    }

    /// Appends a number, or an empty cell.
    pub(crate) fn known(mut self, number: Option<impl Display>) -> Self {
        self.0.push(number.map_or_else(String::new, |number| number.to_string()));
        self
    }

    /// Appends numbers, or as many empty cells.
    pub(crate) fn numbers<const N: usize>(self, numbers: Option<[f64; N]>) -> Self {
        (0..N).fold(self, |row, k| row.known(numbers.map(|numbers| numbers[k])))
    }
}

/// A table between commas under a line of column names.
///
/// # Source
/// RFC 4180.
pub(crate) fn table(columns: &[&str], rows: impl IntoIterator<Item = Row>) -> String {
    // A name that begins as a comment does is one in quotes.
    let mut writer = WriterBuilder::new().flexible(true).comment(Some(COMMENT)).from_writer(Vec::new());
    // A vector takes all that is written.
    let written = writer.write_record(columns).and_then(|()| rows.into_iter().try_for_each(|Row(cells)| writer.write_record(cells)));
    let bytes = writer.into_inner().unwrap_or_default();
    debug_assert!(written.is_ok(), "{written:?}");
    String::from_utf8(bytes).unwrap_or_default()
}

/// Whether a spreadsheet may run a text, or this module would read it back as another one: apostrophes count as far as they stand before
/// what would be run.
fn is_formula(text: &str) -> bool {
    text.trim_start_matches('\'').starts_with(['=', '+', '-', '@', '\t', '\r'])
}

/// A text as a cell or a head holds it: with an apostrophe in front where a spreadsheet would run it.
pub(crate) fn guarded(text: &str) -> String {
    if is_formula(text) { format!("'{text}") } else { text.into() }
}

/// The text that [`Row::text`] has guarded.
fn unguarded(cell: &str) -> &str {
    cell.strip_prefix('\'').filter(|text| is_formula(text)).unwrap_or(cell)
}

/// The beginning of a text, for a message of one line.
pub(crate) fn shorten(text: &str) -> String {
    const LONGEST: usize = 60;
    let printable = text.chars().map(|c| if c.is_control() { ' ' } else { c });
    if text.chars().count() <= LONGEST { printable.collect() } else { printable.take(LONGEST).chain("…".chars()).collect() }
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
        let records = records(Input::Text, text).unwrap();
        records.rows.iter().map(|(line, record)| (*line, record.iter().map(String::from).collect())).collect()
    }

    #[test]
    fn records_know_their_lines_among_comments_and_blanks() {
        let wanted = [(3, vec!["a".to_string(), "b".into()]), (7, vec!["c".into(), "d".into()])];
        assert_eq!(lines("\u{feff}# one\r\n\r\na,b\r\n \r\n#\r\n,,\r\nc , d"), wanted);
        assert!(lines("").is_empty());
    }

    #[test]
    fn no_cell_of_a_table_runs_as_a_formula() {
        let texts = ["=1+1", "+1", "-1", "@SUM(1)", "\tx", "'=1", "''-1", "'a", "a=1", "=a, \"b\"", "the \"a\"", "", "7"];
        let rows = texts.iter().enumerate().map(|(i, text)| Row::default().number(-0.5 - i as f64).text(text).known(None::<f64>));
        let written = table(&["number", "text", "none"], rows);
        assert!(written.starts_with("number,text,none\n-0.5,'=1+1,\n-1.5,'+1,\n-2.5,'-1,\n-3.5,'@SUM(1),\n"), "{written}");
        assert!(written.contains("-8.5,a=1,\n-9.5,\"'=a, \"\"b\"\"\",\n-10.5,\"the \"\"a\"\"\",\n"), "{written}");
        let read = lines(&written);
        assert_eq!(read.iter().skip(1).map(|(_, cells)| &cells[1][..]).collect::<Vec<_>>(), texts);
        assert_eq!(read[1].1[0], "-0.5");
        assert!(table(&["text"], [Row::default().text("\rx")]).contains("'\rx"));
    }

    #[test]
    fn names_that_begin_as_a_comment_does_read_back() {
        let names = ["#1", "#", "# a, b", "//nas/a"];
        let written = table(&["name", "x"], names.iter().map(|name| Row::default().text(name).number(1)));
        assert_eq!(lines(&written).iter().skip(1).map(|(_, cells)| &cells[0][..]).collect::<Vec<_>>(), names);
        assert_eq!(lines("\"#1\",1\n#2,2\n").len(), 1);
    }

    #[test]
    fn a_carriage_return_ends_a_line_also_one_of_a_comment() {
        assert_eq!(lines("# one\ra,b\rc,d\r"), [(2, vec!["a".to_string(), "b".into()]), (3, vec!["c".into(), "d".into()])]);
    }

    #[test]
    fn a_quote_that_nothing_closes_takes_no_lines_into_its_field() {
        let refused = records(Input::Text, "name,x\nP1,1\n\n# one\nP4,\"bolt\nP5,1\nP6,1\n").unwrap_err().to_string();
        assert!(refused.contains("'P4,bolt P5,1 P6,1'") && refused.contains("from line 5 on"), "{refused}");
        assert!(records(Input::Text, "name,x\nP1,\"two\nlines\"\n").unwrap_err().to_string().contains("from line 2 on"));
        assert_eq!(lines("P4,\"bolt, M8\"\n")[0].1[1], "bolt, M8");
    }

    #[test]
    fn the_first_record_tells_what_separates() {
        for (text, wanted) in [
            ("# a,b\nx;1,5", &["x", "1,5"][..]),
            ("x\t1,5\t2,5", &["x", "1,5", "2,5"]),
            ("x,\t1.5,\t2.5", &["x", "1.5", "2.5"]),
            ("x\t,1.5", &["x", "1.5"]),
            ("x,1.5", &["x", "1.5"]),
            ("x\u{60c}1,5\u{60c}2", &["x", "1,5", "2"]),
            ("x\u{61b}1\u{60c}5\u{61b}2", &["x", "1\u{60c}5", "2"]),
            ("x;a\u{60c}b", &["x", "a\u{60c}b"]),
        ] {
            assert_eq!(lines(text)[0].1, wanted, "{text}");
        }
    }

    #[test]
    fn a_lone_comma_is_a_decimal_point_where_commas_do_not_separate() {
        let number = |separates: &str, field: &str| records(Input::Text, separates).unwrap().number(field);
        for separates in ["a;b", "a\tb"] {
            assert_eq!(number(separates, "-5539031,141"), Some(-5_539_031.141));
            assert_eq!(number(separates, "1,5e2"), Some(150.0));
            assert_eq!(number(separates, "1.5"), Some(1.5));
            for none in ["1,000,000", "1.234,5", "1,234.5", "a,b", "", "inf"] {
                assert_eq!(number(separates, none), None, "{none}");
            }
        }
        assert_eq!(number("a,b", "1,5"), None);
        let shown = |text: &str| {
            let records = records(Input::Text, text).unwrap();
            records.shown(&records.rows[0].1)
        };
        assert_eq!(["P 1;1,5", "P 1\t1,5", "P 1, 1.5"].map(shown), ["P 1;1,5", "P 1 1,5", "P 1,1.5"]);
    }

    #[test]
    fn numbers_in_arabic_digits_and_with_other_minus_signs_are_read() {
        let found = records(Input::Text, "P١;٤٤٦٨٣٣٫٢٥;−98,5;۱۲;−\n").unwrap();
        let row = &found.rows[0].1;
        assert_eq!([1, 2, 3].map(|column| found.number(&row[column])), [Some(446_833.25), Some(-98.5), Some(12.0)]);
        assert!(&row[0] == "P١" && is_none(&row[4]), "{row:?}");
    }

    #[test]
    fn messages_are_short_and_printable() {
        assert_eq!(shorten("a\tb"), "a b");
        assert_eq!(shorten(&"x".repeat(100)).chars().count(), 61);
    }
}
