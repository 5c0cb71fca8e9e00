//! Which line names the columns of a table.

use super::{Records, filled};
use crate::error::refuse;
use crate::{Error, Input, Refusal};
use csv::StringRecord;

/// Lines among which the names are looked for: titles stand above them.
const LOOKED_AT: usize = 10;
/// Numbers that a line of values has, and no title.
const LEAST_NUMBERS: usize = 2;

/// What a column of numbers of rows is called.
const NUMBER: &str = "#";

/// A table with its head, if any.
#[derive(Debug)]
pub(crate) struct Headed<'a> {
    /// The names of the columns, each with the unit from a line below; absent where no line names all that are needed.
    pub names: Option<StringRecord>,
    /// The rows below, each with its line.
    pub rows: &'a [(usize, StringRecord)],
    /// A comment directly above a table without names, that names some columns elsewhere than in order.
    pub misplaced: Option<StringRecord>,
}

impl Records {
    /// The head of a table and its rows. The head is the first line, or one below titles without numbers; or a comment directly above rows of numbers.
    /// `find`: where the columns stand that are needed, as a line names them. `units`: those of a line of units below the names, in small letters.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for rows whose fields cannot be told: between commas more than there are columns, between blanks as many more or less.
    pub(crate) fn headed<const N: usize>(
        &self,
        find: impl Fn(&StringRecord) -> [Option<usize>; N],
        units: &[&str],
    ) -> Result<Headed<'_>, Error> {
        let names_all = |record: &StringRecord| find(record).iter().all(Option::is_some);
        let above_values = self.rows.iter().take(LOOKED_AT).take_while(|(_, record)| self.numbers(record) < LEAST_NUMBERS);
        let own = above_values.enumerate().find(|(_, (_, record))| names_all(record)).map(|(row, (_, record))| (row + 1, record.clone()));
        let is_of_values = |record: &StringRecord| self.numbers(record) >= LEAST_NUMBERS;
        // Other programs list images and points without coordinates first.
        let has_values = self.rows.iter().any(|(_, record)| is_of_values(record));
        let width = self.rows.iter().map(|(_, record)| filled(record)).max().unwrap_or(0);
        let comments: Vec<StringRecord> =
            self.above.iter().filter(|_| own.is_none() && has_values).map(|names| self.numbered(names, &find)).collect();
        let is_elsewhere = |names: &StringRecord| find(names).iter().enumerate().any(|(place, is)| is.is_some_and(|is| is != place));
        // Fewer names than columns, in order, say no more than the order does, unless that takes what stands behind for something.
        let says_all = |names: &StringRecord| names.len() >= width || self.input == Input::PositionTable;
        let is_head = |names: &&StringRecord| names_all(names) && (says_all(names) || is_elsewhere(names));
        let commented = comments.iter().find(is_head).map(|names| (0, names.clone()));
        let is_misplaced = |names: &&StringRecord| is_elsewhere(names) && find(names).iter().flatten().count() >= 2;
        let misplaced = comments.iter().find(is_misplaced).filter(|_| commented.is_none()).cloned();
        let Some((below, mut names)) = own.or(commented) else {
            let headed = Headed { names: None, rows: &self.rows, misplaced };
            if let Some((_, first)) = self.rows.first().filter(|(_, first)| is_of_values(first)) {
                self.check_widths(headed.rows, first.len(), false)?;
            }
            return Ok(headed);
        };
        let mut rows = &self.rows[below..];
        self.check_widths(rows, names.len(), true)?;
        if let Some(with_units) = rows.first().and_then(|(_, record)| with_units(&names, record, units)) {
            (names, rows) = (with_units, &rows[1..]);
        }
        Ok(Headed { names: Some(names), rows, misplaced: None })
    }

    /// Of the first lines that which names most of the columns that are needed: a message shows it where none names them all.
    pub(crate) fn likely_head<const N: usize>(&self, find: impl Fn(&StringRecord) -> [Option<usize>; N]) -> Option<&StringRecord> {
        let (_, first) = self.rows.first()?;
        let above_values = self.rows.iter().take(LOOKED_AT).take_while(|(_, record)| self.numbers(record) < LEAST_NUMBERS);
        let found = |record: &StringRecord| find(record).iter().flatten().count();
        Some(above_values.map(|(_, record)| record).fold(first, |best, record| if found(record) > found(best) { record } else { best }))
    }

    /// The names of a comment, whose first sign is itself the name of a column where one is lacking.
    fn numbered<const N: usize>(&self, names: &StringRecord, find: impl Fn(&StringRecord) -> [Option<usize>; N]) -> StringRecord {
        let lacks_name = find(names)[0].is_none();
        let lacks_one = lacks_name && self.rows.iter().all(|(_, record)| record.len() == names.len() + 1);
        let named = names.iter().enumerate().map(|(column, name)| if lacks_name && column == 0 && name.is_empty() { NUMBER } else { name });
        Some(NUMBER).filter(|_| lacks_one).into_iter().chain(named).collect()
    }

    fn numbers(&self, record: &StringRecord) -> usize {
        record.iter().filter(|field| self.number(field).is_some()).count()
    }

    fn check_widths(&self, rows: &[(usize, StringRecord)], columns: usize, is_named: bool) -> Result<(), Error> {
        let input = self.input;
        for (line, record) in rows {
            match self.separator {
                b' ' if record.len() != columns => {
                    let record = self.shown(record);
                    return refuse(Refusal::BlankFields { input, record, line: *line, columns });
                }
                b',' if is_named && filled(record) > columns => {
                    let record = self.shown(record);
                    return refuse(Refusal::MoreFields { input, record, line: *line, columns });
                }
                _ => {}
            }
        }
        Ok(())
    }
}

/// Names with the units that a line below has; none where it is no such line.
fn with_units(names: &StringRecord, below: &StringRecord, units: &[&str]) -> Option<StringRecord> {
    let unit = |column: usize| {
        let cell = below.get(column).unwrap_or("").to_lowercase();
        let bare = cell.trim_start_matches(['(', '[']).trim_end_matches([')', ']']).trim();
        units.iter().find(|unit| **unit == bare).copied()
    };
    let is_empty = |column: usize| matches!(below.get(column), None | Some("" | "-" | "[-]"));
    let is_of_units = (1..below.len()).all(|column| is_empty(column) || unit(column).is_some());
    if !is_of_units || (1..below.len()).filter(|column| unit(*column).is_some()).count() < 2 || below.len() > names.len() {
        return None;
    }
    let with_unit = |(column, name): (usize, &str)| match unit(column).filter(|_| column > 0 && !name.ends_with([')', ']'])) {
        Some(unit) => format!("{name} ({unit})"),
        None => name.to_string(),
    };
    Some(names.iter().enumerate().map(with_unit).collect())
}
