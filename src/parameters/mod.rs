//! Every tunable with its label, unit, range and help: the page, the command and the checks read them from here.

mod adjustment;
mod block;
mod features;
mod flight;
mod geometry;
mod pair;

pub use adjustment::{ADJUSTMENT_PARAMETERS, NETWORK_PARAMETERS, RECONSTRUCTION_PARAMETERS};
pub use block::{BLOCK_FLIGHT_PARAMETERS, BLOCK_PARAMETERS};
pub use features::FEATURE_PARAMETERS;
pub use flight::FLIGHT_PARAMETERS;
pub use geometry::GEOMETRY_PARAMETERS;
pub use pair::PARAMETERS;

use crate::Error;
use serde::Serialize;
use std::ops::RangeInclusive;

/// Focal lengths of cameras in px.
pub(crate) const FOCAL_PX: RangeInclusive<f64> = 1.0..=1e7;

/// What values a parameter takes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum ParameterKind {
    /// Whole numbers from `min` to `max`; odd ones only where `odd`.
    Integer { min: f64, max: f64, odd: bool },
    /// Numbers from `min` to `max`, both included.
    Real { min: f64, max: f64 },
    /// One of these words.
    Choice { values: &'static [&'static str] },
    /// Yes or no.
    Flag,
}

/// One tunable.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Parameter {
    /// Its place in the settings, as [`PairSettings`](crate::PairSettings): `group.field`.
    pub key: &'static str,
    pub label: &'static str,
    /// Empty where it has none.
    pub unit: &'static str,
    #[serde(flatten)]
    pub kind: ParameterKind,
    /// What it does and what to try.
    pub help: &'static str,
}

const fn parameter(key: &'static str, label: &'static str, unit: &'static str, kind: ParameterKind, help: &'static str) -> Parameter {
    Parameter { key, label, unit, kind, help }
}

const fn integer(min: f64, max: f64) -> ParameterKind {
    ParameterKind::Integer { min, max, odd: false }
}

const fn odd(min: f64, max: f64) -> ParameterKind {
    ParameterKind::Integer { min, max, odd: true }
}

const fn real(min: f64, max: f64) -> ParameterKind {
    ParameterKind::Real { min, max }
}

const fn choice(values: &'static [&'static str]) -> ParameterKind {
    ParameterKind::Choice { values }
}

/// Finds a parameter by its key.
pub(crate) fn parameter_of(key: &str) -> &'static Parameter {
    let groups = [PARAMETERS, FEATURE_PARAMETERS, GEOMETRY_PARAMETERS, BLOCK_PARAMETERS, ADJUSTMENT_PARAMETERS, RECONSTRUCTION_PARAMETERS];
    groups.into_iter().flatten().find(|p| p.key == key).unwrap_or_else(|| unreachable!("no parameter {key}"))
}

/// Refuses a number outside the range of its parameter.
pub(crate) fn check(key: &'static str, value: f64) -> Result<(), Error> {
    check_by(parameter_of(key), value)
}

/// As [`check`], for a parameter at hand.
pub(crate) fn check_by(parameter: &'static Parameter, value: f64) -> Result<(), Error> {
    let (within, allowed) = match parameter.kind {
        ParameterKind::Integer { min, max, odd } => {
            let whole = value.fract() == 0.0 && value >= min && value <= max;
            (whole && (!odd || value % 2.0 == 1.0), format!("{}whole numbers from {min} to {max}", if odd { "odd " } else { "" }))
        }
        ParameterKind::Real { min, max } => (value >= min && value <= max, format!("{min} to {max}")),
        ParameterKind::Choice { .. } | ParameterKind::Flag => unreachable!("{} is no number", parameter.key),
    };
    if within { Ok(()) } else { Err(refuse(parameter.key, value, allowed)) }
}

/// The error of an option outside its range.
pub(crate) fn refuse(field: &'static str, got: impl ToString, allowed: impl Into<String>) -> Error {
    Error::InvalidOption { field, got: got.to_string(), allowed: allowed.into() }
}

/// Refuses values outside a range; `place` says where they stand.
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
