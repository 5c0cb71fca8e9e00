//! The five unknowns of a relative orientation, in their order.

use crate::FiveParameters;

/// Symbol, unit, digits.
pub const UNKNOWNS: [(&str, &str, usize); 5] = [("ω", "°", 4), ("φ", "°", 4), ("κ", "°", 4), ("by", "mm", 4), ("bz", "mm", 4)];

pub fn five(p: &FiveParameters) -> [f64; 5] {
    [p.omega_deg, p.phi_deg, p.kappa_deg, p.by_mm, p.bz_mm]
}
