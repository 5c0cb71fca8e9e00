//! Every tunable with its label, unit, range and help: the page, the command and the checks read them from here.

use crate::Error;
use serde::Serialize;

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
    /// Its place in [`PairSettings`](crate::PairSettings): `group.field`.
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

/// All tunables, in the order of the pipeline.
pub const PARAMETERS: &[Parameter] = &[
    parameter(
        "points.operator",
        "Operator",
        "",
        choice(&["ground2", "ground1", "forstner", "moravec"]),
        "The interest operator. Ground 2 is the paper's choice: contrast to the neighbours, then roundness.",
    ),
    parameter(
        "points.threshold",
        "Threshold",
        "",
        real(0.0, 1e9),
        "Ground: least grey difference (paper: 40). Förstner: factor of the mean weight (0.5 to 1.5). Moravec: sum of squared grey differences. Higher finds fewer points. Empty: the operator's default, lowered where it would leave less than 5 % of the pixels as candidates.",
    ),
    parameter(
        "points.fraction",
        "Fraction of candidates",
        "",
        real(0.000001, 1.0),
        "In place of a threshold: the share of all pixels that become candidates, set for each image (paper: 0.148). It survives a change of contrast.",
    ),
    parameter(
        "points.roundness",
        "Roundness q",
        "",
        real(0.0, 1.0),
        "Least roundness of the error ellipse: 1 is a corner or spot, 0 an edge (ground 2: 0.32 to 0.5, Förstner: 0.5 to 0.75).",
    ),
    parameter(
        "points.operator_window",
        "Operator window",
        "px",
        integer(2.0, 31.0),
        "Side of the operator's window: Moravec 4 or 8, Förstner 5 or 7. The ground operators always use 3.",
    ),
    parameter(
        "points.tiled",
        "Windows side by side",
        "",
        ParameterKind::Flag,
        "Moravec: windows side by side, as first published, in place of one at each pixel.",
    ),
    parameter(
        "points.suppression_window",
        "Suppression window",
        "px",
        odd(1.0, 255.0),
        "A point falls if a greater value lies in this window around it (paper: 3). 1 suppresses nothing; larger windows leave fewer, better spread points.",
    ),
    parameter(
        "points.ties",
        "Equal values",
        "",
        choice(&["keep", "first"]),
        "Whether all of several equal values in the suppression window survive, or the first in raster order.",
    ),
    parameter("window.side", "Moment window", "px", odd(3.0, 63.0), "Side of the window whose moments describe a point (paper: 11)."),
    parameter(
        "window.shape",
        "Window shape",
        "",
        choice(&["square", "circle"]),
        "A circular window does not change when the image is rotated; a square one does.",
    ),
    parameter(
        "window.brightness",
        "Brightness",
        "",
        choice(&["sum", "range", "unit"]),
        "How grey values become weights: sum and range do not change with gain and offset; unit is grey / 255.",
    ),
    parameter(
        "matching.measure",
        "Measure",
        "",
        choice(&["dm", "di"]),
        "DM compares the seven normalised moments; DI the seven rotation invariants, for rotated images.",
    ),
    parameter(
        "matching.denominator",
        "Denominator",
        "",
        choice(&["maxabs", "floor"]),
        "What a difference is divided by: the larger magnitude, or at least the median magnitude over all points, which keeps small moments from dominating.",
    ),
    parameter(
        "matching.search",
        "Search window",
        "px",
        odd(1.0, 1023.0),
        "Side of the window, around the expected position, in which right points are candidates (paper: 25).",
    ),
    parameter(
        "matching.max_measure",
        "Largest measure",
        "",
        real(0.0, 14.0),
        "A best candidate whose measure is not below this is refused (paper: 3).",
    ),
    parameter(
        "matching.ambiguity",
        "Ambiguity ratio",
        "",
        real(0.0, 1.0),
        "Refused as ambiguous when the best measure exceeds this share of the second best. 1 switches the rule off.",
    ),
    parameter(
        "matching.parallax_neighbours",
        "Parallax neighbours",
        "",
        integer(0.0, 100.0),
        "How many nearest matches give the expected y-parallax. 0 switches the rule off.",
    ),
    parameter(
        "matching.parallax_tolerance",
        "Parallax tolerance",
        "px",
        real(0.0, 1000.0),
        "Least deviation from the neighbours' median y-parallax that is refused; where the neighbours scatter more, 3 times their scatter.",
    ),
    parameter(
        "orientation.method",
        "Method",
        "",
        choice(&["rigorous", "determinant"]),
        "Rigorous: all four photo coordinates are observed. Determinant: the textbook form with unweighted determinants.",
    ),
    parameter(
        "orientation.robust",
        "Robust",
        "",
        ParameterKind::Flag,
        "Start from the consensus of minimal samples and reject gross errors. Without it one blunder can carry the solution away.",
    ),
    parameter(
        "orientation.rejection",
        "Rejection limit",
        "",
        real(2.0, 10.0),
        "Matches whose standardised residual exceeds this are rejected. 3.29 rejects one good match in a thousand (Baarda).",
    ),
    parameter(
        "orientation.seed",
        "Seed",
        "",
        integer(0.0, 4294967295.0),
        "Start of the random numbers of the consensus: the same seed gives the same result.",
    ),
    parameter(
        "orientation.base_mm",
        "Photo base",
        "mm",
        real(-1e6, 1e6),
        "Length b of the base at photo scale; it scales by and bz only. Empty: the median x-parallax of the matches.",
    ),
];

/// Finds a parameter by its key.
pub(crate) fn parameter_of(key: &str) -> &'static Parameter {
    PARAMETERS.iter().find(|p| p.key == key).unwrap_or_else(|| unreachable!("no parameter {key}"))
}

/// Refuses a number outside the range of its parameter.
pub(crate) fn check(key: &'static str, value: f64) -> Result<(), Error> {
    let (within, allowed) = match parameter_of(key).kind {
        ParameterKind::Integer { min, max, odd } => {
            let whole = value.fract() == 0.0 && value >= min && value <= max;
            (whole && (!odd || value % 2.0 == 1.0), format!("{}whole numbers from {min} to {max}", if odd { "odd " } else { "" }))
        }
        ParameterKind::Real { min, max } => (value >= min && value <= max, format!("{min} to {max}")),
        ParameterKind::Choice { .. } | ParameterKind::Flag => unreachable!("{key} is no number"),
    };
    if within { Ok(()) } else { Err(refuse(key, value, allowed)) }
}

/// The error of an option outside its range.
pub(crate) fn refuse(field: &'static str, got: impl ToString, allowed: impl Into<String>) -> Error {
    Error::InvalidOption { field, got: got.to_string(), allowed: allowed.into() }
}
