//! What Zahran's paper printed for its own pair: the report and the page set it beside their results.

use crate::FiveParameters;
use serde::Serialize;

/// Printed values.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Paper {
    /// Left and right counts of Table 1: after the operator, after suppression, after matching.
    pub points: [[usize; 2]; 3],
    /// Of the operator.
    pub threshold: f64,
    /// Table 2: standard errors of the proposed method.
    pub standard_errors: FiveParameters,
    /// Table 3: the orientation by correlation, by least squares matching and by the proposed method (moments).
    pub orientations: [PrintedOrientation; 3],
    /// Standard error of unit weight in mm, 0.6 of its pixels.
    pub sigma0_mm: f64,
    pub pixel_mm: f64,
}

/// A column of Table 3.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct PrintedOrientation {
    /// By which way: `correlation`, `least-squares` or `moments`.
    pub name: &'static str,
    pub values: FiveParameters,
}

pub const PAPER: Paper = Paper {
    points: [[46_695, 43_230], [10_761, 9_681], [1_325, 1_325]],
    threshold: 40.0,
    standard_errors: five(0.0477, 0.0688, 0.0202, 0.1373, 0.0746),
    orientations: [
        PrintedOrientation { name: "correlation", values: five(0.8903, 0.0260, 0.4951, -1.9333, 0.0100) },
        PrintedOrientation { name: "least-squares", values: five(0.8889, 0.0108, 0.4975, -1.9274, 0.0403) },
        PrintedOrientation { name: "moments", values: five(0.9137, 0.0187, 0.3708, -2.2811, 0.0605) },
    ],
    sigma0_mm: 0.150,
    pixel_mm: 0.254,
};

const fn five(omega_deg: f64, phi_deg: f64, kappa_deg: f64, by_mm: f64, bz_mm: f64) -> FiveParameters {
    FiveParameters { omega_deg, phi_deg, kappa_deg, by_mm, bz_mm }
}
