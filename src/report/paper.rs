//! What Zahran's paper printed for its own pair.

use crate::FiveParameters;

/// Left and right counts of Table 1: after the operator, after suppression, after matching.
pub const TABLE_1: [[usize; 2]; 3] = [[46_695, 43_230], [10_761, 9_681], [1_325, 1_325]];

/// Table 2: standard errors of the proposed method.
pub const TABLE_2: FiveParameters = five(0.0477, 0.0688, 0.0202, 0.1373, 0.0746);

/// Table 3: the orientation by correlation, by least squares matching and by the proposed method (moments).
pub const TABLE_3: [(&str, FiveParameters); 3] = [
    ("correlation", five(0.8903, 0.0260, 0.4951, -1.9333, 0.0100)),
    ("least squares", five(0.8889, 0.0108, 0.4975, -1.9274, 0.0403)),
    ("proposed (moments)", five(0.9137, 0.0187, 0.3708, -2.2811, 0.0605)),
];

/// Standard error of unit weight in mm, 0.6 of its pixels of 254 µm.
pub const SIGMA0_MM: f64 = 0.150;
pub const PIXEL_MM: f64 = 0.254;

const fn five(omega_deg: f64, phi_deg: f64, kappa_deg: f64, by_mm: f64, bz_mm: f64) -> FiveParameters {
    FiveParameters { omega_deg, phi_deg, kappa_deg, by_mm, bz_mm }
}
