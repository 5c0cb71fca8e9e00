//! What the user chooses of the relative orientation.

use super::significance::significance_of_test;
use crate::catalogue::{choices, options, refuse};
use crate::math::detectable_shift;
use crate::{Allowed, Error};

choices! {
    /// What is minimised.
    pub enum OrientationMethod {
        /// The corrections of all four photo coordinates (Gauss-Helmert).
        Rigorous = "rigorous",
        /// The coplanarity determinants, unweighted (the short textbook form).
        Determinant = "determinant",
    }
}

choices! {
    /// How observations that survived the rejection are weighted down for their residuals.
    pub enum Weighting {
        /// By nothing: least squares.
        None = "none",
        /// By 1.5 / |w| where the standardised residual |w| exceeds 1.5 (Huber 1964).
        Huber = "huber" ("Huber"),
        /// By exp(0.05 (2³ - |w|³)) where |w| exceeds 2 (Krarup, Juhl & Kubik 1980, made continuous).
        Danish = "danish" ("Danish"),
    }
}

options! {
    /// Options of [`orient_relative`](crate::orient_relative).
    pub struct OrientationOptions in "orientation" {
        section "Relative orientation";

        /// Rigorous: all four photo coordinates are observed. Determinant: the textbook form with unweighted determinants.
        method: OrientationMethod = OrientationMethod::Rigorous, "Method";

        /// Starts from the consensus of minimal samples and rejects gross errors; without it one blunder can carry the solution away.
        robust: bool = true, "Robust";

        /// The share of good matches that data snooping rejects by mistake: higher rejects more; 0.001 rejects beyond 3.29 standard errors
        /// (Baarda 1968).
        alpha0: f64 = 0.001, "Significance α₀", 0.000001..=0.2;

        /// The probability with which a blunder of the minimal detectable size is found: higher makes that size larger.
        beta0: f64 = 0.8, "Power β₀", 0.5..=0.999;

        /// Weighs matches with large residuals down, in addition to their rejection.
        weighting: Weighting = Weighting::None, "Robust weights";

        /// The standard error of a photo coordinate that is known before: standard errors and tests use it, a global test compares it with the
        /// residuals, and a larger one rejects fewer matches.
        sigma0_mm: Option<f64> = None, "σ₀ a priori", in "mm", 0.0000001..=100, absent "estimated from the residuals";

        /// The start of the random numbers of the consensus: the same seed gives the same result.
        seed: u32 = 1, "Seed", 0..=4294967295.0, acts "orientation.robust is true";

        /// The length b of the base at photo scale, not 0, by which by and bz grow in proportion; its sign is that of the geometry, so that a
        /// minus changes nothing.
        base_mm: Option<f64> = None, "Photo base", in "mm", -1e6..=1e6, absent "the median x-parallax of the matches";
    }
}

impl OrientationOptions {
    /// Refuses values outside their ranges.
    pub(crate) fn check(&self) -> Result<(), Error> {
        match self.base_mm {
            Some(base_mm) if base_mm == 0.0 => Err(refuse("orientation.base_mm", base_mm, Allowed::ButZero { min: -1e6, max: 1e6 })),
            _ => self.check_ranges(),
        }
    }

    /// δ₀: the shift of a standardised residual that exceeds its limit with the probability β₀: of a σ that `freedom` degrees of freedom
    /// estimate, or of a known one.
    pub(super) fn noncentrality(&self, freedom: Option<usize>) -> f64 {
        let alpha = freedom.map_or(self.alpha0, |freedom| significance_of_test(self.alpha0, freedom));
        detectable_shift(alpha, self.beta0, freedom)
    }
}
