//! Whole numbers between commas, which may be halves of numbers with decimal commas.

use crate::error::refuse;
use crate::text::{NumberedRecord, Records};
use crate::{Error, Refusal};
use csv::StringRecord;
use std::collections::BTreeSet;

/// Standard errors from here on, in m, and other whole numbers where only they stand, are rather the figures behind a decimal comma.
pub(super) const LEAST_FIGURES: f64 = 10.0;

/// Nothing on the earth is so high, in m or ft: it is rather the whole part of a coordinate.
const NO_HEIGHT: f64 = 30_000.0;

/// The columns of a table that a line names, as far as decimal commas would have shifted what they hold.
pub(super) struct NumberColumns {
    /// Those of coordinates that are read.
    pub read: Vec<usize>,
    /// That of heights among them.
    pub height: Option<usize>,
    /// Those of standard errors that are read, with their units in m.
    pub errors: Vec<(usize, f64)>,
    /// Those of names and words, whose numbers are none.
    pub texts: Vec<usize>,
    /// How many columns the line names; absent where whole numbers are unlikely, as those of degrees.
    pub named: Option<usize>,
}

impl NumberColumns {
    /// Refuses numbers of these columns whose commas may stand before thousands.
    ///
    /// # Errors
    /// As [`Records::check_thousands`].
    pub fn check_thousands(&self, records: &Records, rows: &[NumberedRecord]) -> Result<(), Error> {
        let columns: Vec<usize> = self.read.iter().copied().chain(self.errors.iter().map(|(column, _)| *column)).collect();
        records.check_thousands(rows, &columns)
    }

    /// Refuses a table between commas none of whose numbers has a point, where a row of it has more of them than are read, as `8,25,50,5,171,5` has below
    /// `lon,lat,alt,yaw,pitch,roll`; one that begins with a zero, as `069`; or a standard error of 10 m or more. More numbers than are read are no sign of
    /// decimal commas where each row has as many fields as there are names, and a height: with decimals it would have more.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] with the first such row.
    pub fn check(&self, records: &Records, rows: &[NumberedRecord]) -> Result<(), Error> {
        let first = self.read.iter().copied().min().unwrap_or(0);
        let numbers = |record: &'_ StringRecord| -> Vec<String> {
            let columns = (first..record.len()).filter(|column| !self.texts.contains(column));
            columns.map(|column| &record[column]).filter(|field| records.number(field).is_some()).map(String::from).collect()
        };
        let may_be_cut = |record: &StringRecord| records.may_be_cut(&numbers(record).iter().map(String::as_str).collect::<Vec<_>>());
        if !rows.iter().all(|(_, record)| may_be_cut(record)) {
            return Ok(());
        }
        let begins_with_zero = |record: &StringRecord| {
            self.read
                .iter()
                .any(|column| record.get(*column).is_some_and(|field| has_leading_zero(field) && records.number(field).is_some()))
        };
        let number = |record: &StringRecord, column: usize| record.get(column).and_then(|field| records.number(field)).unwrap_or(0.0);
        let is_large = |record: &StringRecord| self.errors.iter().any(|(column, unit_m)| unit_m * number(record, *column) >= LEAST_FIGURES);
        let read: BTreeSet<usize> = self.read.iter().copied().chain(self.errors.iter().map(|(column, _)| *column)).collect();
        let is_whole = |record: &StringRecord| {
            let is_high = self.height.is_some_and(|height| number(record, height).abs() >= NO_HEIGHT);
            self.named == Some(record.len()) && !is_high
        };
        let are_whole = rows.iter().all(|(_, record)| is_whole(record));
        let is_more = |record: &StringRecord| !are_whole && numbers(record).len() > read.len();
        let is_cut = |record: &StringRecord| is_more(record) || begins_with_zero(record) || is_large(record);
        let cut = rows.iter().find(|(_, record)| is_cut(record));
        let Some((line, record)) = cut else { return Ok(()) };
        refuse(Refusal::DecimalCommas { input: records.input(), record: records.shown(record), line: *line })
    }
}

/// Whether a number begins as the figures behind a decimal point may, and no whole number does.
pub(super) fn has_leading_zero(field: &str) -> bool {
    field.len() > 1 && field.starts_with('0') && !field.starts_with("0.")
}
