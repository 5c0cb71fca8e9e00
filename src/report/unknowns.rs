//! The five unknowns of a relative orientation, in their order.

use crate::FiveParameters;

/// Symbol, unit.
pub const UNKNOWNS: [(&str, &str); 5] = [("ω", "°"), ("φ", "°"), ("κ", "°"), ("by", "mm"), ("bz", "mm")];

/// Digits after the point of what the paper printed, and of what has no standard error.
pub const PRINTED_DIGITS: usize = 4;

pub fn five(p: &FiveParameters) -> [f64; 5] {
    [p.omega_deg, p.phi_deg, p.kappa_deg, p.by_mm, p.bz_mm]
}
