//! What the result of a pair is worth, in one sentence with the figures that decided.

use super::match_pair::PairResult;
use super::no_orientation::NoOrientation;
use super::weakness::base_half_width_deg;
use crate::message::messages;
use crate::{RelativeOrientation, Side, Warning};
use serde::{Deserialize, Serialize};

/// Photographs that are meant to be vertical differ by less.
const CONVERGENT_DEG: f64 = 5.0;

/// The angle, or the direction of the base, with the widest interval.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum KnownWorst {
    Omega,
    Phi,
    #[default]
    Kappa,
    Base,
}

messages! {
    /// What the result of a pair is worth.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum PairVerdict as "pair_verdict" {
        /// The orientation is right within its intervals. `points`: matches that took part; `half_width_deg`: of the interval of 95 % of κ;
        /// `worst_half_width_deg`: of what is known worst.
        Oriented {
            points: usize,
            /// Absent where observations are measured in mm, of pixels that nobody knows.
            sigma0_px: Option<f64>,
            /// In its place then.
            #[serde(default)]
            sigma0_um: Option<f64>,
            kappa_deg: f64,
            #[serde(with = "crate::json::infinite")]
            half_width_deg: f64,
            /// The angle between the camera axes, where they are not near parallel.
            #[serde(default)]
            axes_deg: Option<f64>,
            #[serde(default)]
            worst: KnownWorst,
            #[serde(default, with = "crate::json::infinite")]
            worst_half_width_deg: f64,
        },
        /// There is an orientation, which may be wrong or too poor to be used, for this reason.
        Weak { points: usize, warning: Warning },
        NotOriented { no_orientation: NoOrientation },
    }
}

impl PairVerdict {
    /// The verdict on an orientation of matches; `pixel_mm`: the pixel's size at photo scale.
    pub fn of(orientation: &RelativeOrientation, pixel_mm: f64) -> Self {
        Self::with(orientation, [Some(orientation.sigma0_mm.unwrap_or(0.0) / pixel_mm), None])
    }

    /// The verdict on an orientation of observations in mm.
    pub fn of_observations(orientation: &RelativeOrientation) -> Self {
        Self::with(orientation, [None, Some(1000.0 * orientation.sigma0_mm.unwrap_or(0.0))])
    }

    fn with(orientation: &RelativeOrientation, [sigma0_px, sigma0_um]: [Option<f64>; 2]) -> Self {
        let of_copies = |warning: &Warning| if let Warning::Identical { copies, rejected } = warning { copies - rejected } else { 0 };
        let copies: usize = orientation.warnings.iter().map(of_copies).sum();
        let points = orientation.residuals_mm.len() - orientation.rejected.len() - copies;
        match orientation.warnings.iter().find(|warning| warning.is_weakness()) {
            Some(warning) => Self::Weak { points, warning: *warning },
            None => {
                let (worst, worst_half_width_deg) = worst_of(orientation);
                Self::Oriented {
                    points,
                    sigma0_px,
                    sigma0_um,
                    kappa_deg: orientation.parameters.kappa_deg,
                    axes_deg: Some(angle_of_axes_deg(orientation)).filter(|angle| *angle > CONVERGENT_DEG),
                    half_width_deg: orientation.half_widths_95.map_or(f64::INFINITY, |half| half.kappa_deg),
                    worst,
                    worst_half_width_deg,
                }
            }
        }
    }
}

/// The cameras of a pair look into directions that differ by ω and φ: Z of the right one in the left.
fn angle_of_axes_deg(orientation: &RelativeOrientation) -> f64 {
    let [omega, phi] = [orientation.parameters.omega_deg, orientation.parameters.phi_deg].map(f64::to_radians);
    libm::acos((libm::cos(omega) * libm::cos(phi)).clamp(-1.0, 1.0)).to_degrees()
}

/// What is known worst of an orientation, with half the width of its interval of 95 %.
fn worst_of(orientation: &RelativeOrientation) -> (KnownWorst, f64) {
    let Some(half) = orientation.half_widths_95 else { return (KnownWorst::Kappa, f64::INFINITY) };
    let widths = [
        (KnownWorst::Kappa, half.kappa_deg),
        (KnownWorst::Omega, half.omega_deg),
        (KnownWorst::Phi, half.phi_deg),
        (KnownWorst::Base, base_half_width_deg(orientation)),
    ];
    widths.into_iter().max_by(|(_, one), (_, other)| one.total_cmp(other)).unwrap_or(widths[0])
}

impl PairResult {
    /// What the result is worth.
    pub fn verdict(&self) -> PairVerdict {
        let no_orientation = match (&self.orientation, &self.interior) {
            (Ok(orientation), Some(interior)) => return PairVerdict::of(orientation, interior.left.pixel_mm()),
            (Ok(_), None) => NoOrientation::NoPixelSize { side: Side::Left },
            (Err(no_orientation), _) => no_orientation.clone(),
        };
        PairVerdict::NotOriented { no_orientation }
    }
}
