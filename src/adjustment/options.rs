//! What the user chooses of the bundle adjustment.

use crate::GnssErrors;
use crate::catalogue::{choices, options};
use crate::math::{detectable_shift, normal_quantile};

choices! {
    /// What says where the block lies in object space.
    pub enum Datum {
        /// The approximate values: a free network with seven inner constraints on the orientations of all images.
        Free = "free",
        /// The images' GNSS positions.
        Gnss = "gnss",
        /// The control points.
        Control = "control",
        /// Both.
        GnssAndControl = "gnss_and_control",
    }
}

choices! {
    /// How observations with large residuals are weighted down until the gross errors are found.
    pub enum Loss {
        /// Not at all: least squares.
        Squares = "squares",
        /// In proportion beyond two standard errors (Huber 1964).
        Huber = "huber",
        /// By 1 / (1 + (v/3σ)²): gross errors lose all influence.
        Cauchy = "cauchy",
    }
}

options! {
    /// Options of [`adjust_block`](crate::adjust_block).
    pub struct AdjustmentOptions in "adjustment" {
        section "Bundle block adjustment";

        /// What says where the block lies: its approximate values (free network), GNSS positions, control points.
        datum: Datum = Datum::Free, "Datum";

        /// How large residuals are weighted down until the gross errors are found.
        loss: Loss = Loss::Cauchy, "Robust loss";

        /// Rejects gross errors by the tests of their residuals.
        snooping: bool = true, "Data snooping";

        /// The probability with which data snooping rejects a good coordinate: higher rejects more; 0.001 rejects beyond 3.29 standard errors
        /// (Baarda 1968).
        alpha0: f64 = 0.001, "Significance α₀", 1e-6..=0.1;

        /// The standard error of an image coordinate of weight 1 that is known before: a larger one rejects fewer observations.
        sigma0_px: Option<f64> = None, "σ₀ a priori", in "px", 1e-6..=1000, absent "estimated from the residuals";

        /// A free camera parameter is fixed where its standard error moves an observation at the edge of the image by more than this: higher
        /// estimates more parameters.
        calibration_limit_px: f64 = 2.0, "Limit of self-calibration", in "px", 0.01..=1000;

        /// Estimates how much larger or smaller the errors of image measurements, GNSS positions and control points are than stated, and weights
        /// them by it where that is certain.
        variance_components: bool = false, "Variance components";

        /// The offset of GNSS positions that is estimated: one of all, or one of each strip, alone or with a drift that is linear along it. It is kept
        /// where it differs from zero by more than chance, at the significance α₀.
        gnss_errors: GnssErrors = GnssErrors::None, "Offsets of GNSS positions", acts "adjustment.datum is gnss, gnss_and_control";

        /// Estimates the lever arm of each camera, from its projection centre to the antenna of GNSS; it is kept where it differs from zero by more
        /// than chance.
        gnss_lever_arm: bool = false, "Lever arm", acts "adjustment.datum is gnss, gnss_and_control";

        /// The standard deviation, in standard errors of an observation, of errors that the observations of an image share, as those of matches do:
        /// standard errors hold it. 0: observations are independent.
        shared_errors: f64 = 0.0, "Shared errors", 0..=10;

        /// The maximum number of iterations of one adjustment.
        max_iterations: usize = 100, "Iterations", 1..=10000;

        /// Computes standard errors, redundancies and tests, which data snooping needs; they take about as long as the adjustment.
        statistics: bool = true, "Statistics";
    }
}

/// The probability with which an error that is called detectable is found.
const POWER: f64 = 0.8;

impl AdjustmentOptions {
    /// The standardised residual beyond which a coordinate is a gross error.
    pub(crate) fn limit(&self) -> f64 {
        normal_quantile(1.0 - 0.5 * self.alpha0)
    }

    /// The error that a test finds with a probability of 0.80, in standard errors of a residual: what is called detectable.
    pub(crate) fn detectable_shift(&self, degrees_of_freedom: usize) -> f64 {
        detectable_shift(self.alpha0, POWER, self.sigma0_px.is_none().then_some(degrees_of_freedom))
    }
}

impl Datum {
    pub(crate) fn uses_gnss(self) -> bool {
        matches!(self, Self::Gnss | Self::GnssAndControl)
    }

    pub(crate) fn uses_control(self) -> bool {
        matches!(self, Self::Control | Self::GnssAndControl)
    }
}
