//! Rounding of what was converted, so that native code and WebAssembly give the same numbers.
//!
//! Conversions differ by some 1e-9 m between them: one of 100,000 coordinates lies near enough to half a unit of the last digit to be rounded
//! another way.

/// Digits after the point of coordinates in m.
const METRE_DIGITS: i32 = 4;
/// Of longitudes and latitudes: 0.1 mm.
const DEGREE_DIGITS: i32 = 9;
/// Of components of unit vectors: 0.0002".
const DIRECTION_DIGITS: i32 = 9;

fn rounded(value: f64, digits: i32) -> f64 {
    let unit = 10f64.powi(digits);
    // -0 becomes 0.
    (value * unit).round() / unit + 0.0
}

pub(super) fn metres(value: f64) -> f64 {
    rounded(value, METRE_DIGITS)
}

pub(super) fn degrees(value: f64) -> f64 {
    rounded(value, DEGREE_DIGITS)
}

pub(super) fn direction(vector: [f64; 3]) -> [f64; 3] {
    vector.map(|value| rounded(value, DIRECTION_DIGITS))
}
