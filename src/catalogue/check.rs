//! The errors of values outside their ranges.

use crate::error::refuse as refuse_input;
use crate::{Allowed, Error, Input, Location, Refusal};
use std::ops::RangeInclusive;

/// The error of an option outside its range.
pub(crate) fn refuse(field: &'static str, got: impl ToString, allowed: Allowed) -> Error {
    Error::InvalidOption { field, got: Some(got.to_string()), allowed }
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
