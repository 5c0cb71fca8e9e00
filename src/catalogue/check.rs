//! The errors of values outside their ranges.

use crate::error::refuse as refuse_input;
use crate::{Allowed, Error, Input, Location, Refusal};
use std::ops::RangeInclusive;

/// The error of an option outside its range.
pub(crate) fn refuse(field: &'static str, got: impl ToString, allowed: Allowed) -> Error {
    Error::InvalidOption { field, got: Some(shown(got.to_string())), allowed }
}

/// The longest number that is written with all of its digits.
const LONGEST_NUMBER: usize = 24;

/// What was got, in words: a very large or very small number with its power of ten in place of hundreds of digits.
pub(crate) fn shown(got: String) -> String {
    match got.parse::<f64>() {
        Ok(number) if got.len() > LONGEST_NUMBER => format!("{number:e}"),
        _ => got,
    }
}

/// The error of an option that is absent where it is needed.
pub(crate) fn refuse_absent(field: &'static str, allowed: Allowed) -> Error {
    Error::InvalidOption { field, got: None, allowed }
}

/// Rejects values outside a range; `place` says where they stand.
pub(crate) fn check_values(
    input: Input,
    values: &[f64],
    allowed: RangeInclusive<f64>,
    location: impl Fn() -> Location,
) -> Result<(), Error> {
    match values.iter().find(|v| !allowed.contains(v)) {
        Some(&value) => refuse_input(Refusal::Value { input, value, location: location(), low: *allowed.start(), high: *allowed.end() }),
        None => Ok(()),
    }
}
