//! The errors of values outside their ranges.

use crate::Error;
use std::ops::RangeInclusive;

/// Focal lengths of cameras in px.
pub(crate) const FOCAL_PX: RangeInclusive<f64> = 1.0..=1e7;

/// The error of an option outside its range.
pub(crate) fn refuse(field: &'static str, got: impl ToString, allowed: impl Into<String>) -> Error {
    Error::InvalidOption { field, got: got.to_string(), allowed: allowed.into() }
}

/// Rejects values outside a range; `place` says where they stand.
pub(crate) fn check_values(
    what: &'static str,
    values: &[f64],
    allowed: RangeInclusive<f64>,
    place: impl Fn() -> String,
) -> Result<(), Error> {
    match values.iter().find(|v| !allowed.contains(v)) {
        Some(wrong) => {
            let allowed = format!("{} to {}", allowed.start(), allowed.end());
            Err(Error::InvalidInput { what, got: format!("{wrong} in {}", place()), allowed })
        }
        None => Ok(()),
    }
}
