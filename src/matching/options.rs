//! What the user chooses of the matching.

use crate::parameters::check;
use crate::{Error, Measure};
use serde::{Deserialize, Serialize};

/// How the right point of a left one is found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Strategy {
    /// The right interest point of the least dissimilarity of normalised moments (DM, eq. 16).
    Moments,
    /// The same with the seven invariants (DI, eq. 15).
    Invariants,
    /// The place of the highest normalised cross-correlation in the search window, to a fraction of a pixel.
    Correlation,
    /// Least squares matching from coarse to fine.
    LeastSquares,
    /// The right interest point of the nearest gradient descriptor, wherever it lies; what fits no geometry of the two views is refused.
    Gradient,
}

impl Strategy {
    /// The moments by which the strategy compares interest points; absent where it compares something else.
    pub fn measure(self) -> Option<Measure> {
        match self {
            Self::Moments => Some(Measure::Dm),
            Self::Invariants => Some(Measure::Di),
            Self::Correlation | Self::LeastSquares | Self::Gradient => None,
        }
    }

    /// Whether the strategy looks for the right point near an expected place.
    pub fn needs_offset(self) -> bool {
        self != Self::Gradient
    }

    /// The share of the second best measure that the best may have, where none is chosen: the paper's, and Lowe's.
    pub const fn default_ambiguity(self) -> f64 {
        match self {
            Self::Gradient => 0.8,
            _ => 0.9,
        }
    }
}

/// What is done to the matches of any strategy.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Refinement {
    None,
    /// Each right position is moved to where least squares matching finds it.
    LeastSquares,
}

/// What the difference of two moments is divided by.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Denominator {
    /// The larger magnitude of the two.
    Maxabs,
    /// The larger magnitude of the two, and at least the median magnitude of that moment over all points of both images.
    Floor,
}

/// Options of the matching.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct MatchOptions {
    pub strategy: Strategy,
    pub refine: Refinement,
    /// Once the pair is oriented, matches again along the epipolar lines, until nothing changes; gradients always do, once.
    pub epipolar: bool,
    pub denominator: Denominator,
    /// Side of the search window in px, odd.
    pub search: usize,
    /// The best measure must be below this.
    pub max_measure: f64,
    /// Refused when the best measure exceeds this share of the second best, 0..1; absent: 0.9, for gradients 0.8.
    pub ambiguity: Option<f64>,
    /// Number of nearest matches that give the expected y-parallax; 0 switches the rule off.
    pub parallax_neighbours: usize,
    /// Least deviation of the y-parallax that is refused, in px.
    pub parallax_tolerance: f64,
    /// Side of the window whose grey values are compared by correlation and least squares matching, in px, odd.
    pub template: usize,
    /// Least correlation coefficient of a match by grey values, -1..1.
    pub min_correlation: f64,
    /// Refuses a match whose right window correlates better with another place in the left image, or whose right descriptor is nearer to
    /// another left one.
    pub left_right: bool,
    /// Largest standard error of a right position found by least squares matching, in px.
    pub max_standard_error: f64,
    /// Gradients: leaves out what lies at the same place of both frames, as the film's border, fiducial marks and data strip.
    pub without_frame: bool,
}

impl Default for MatchOptions {
    fn default() -> Self {
        Self {
            strategy: Strategy::Moments,
            refine: Refinement::None,
            epipolar: false,
            denominator: Denominator::Maxabs,
            search: 25,
            max_measure: 3.0,
            ambiguity: None,
            parallax_neighbours: 12,
            parallax_tolerance: 1.0,
            template: 13,
            min_correlation: 0.7,
            left_right: true,
            max_standard_error: 0.2,
            without_frame: true,
        }
    }
}

impl MatchOptions {
    /// Whether the second best is too nearly as good as the best. Two that are exactly as good, as in a repeated pattern, are ambiguous by
    /// any ratio but 1, which switches the rule off.
    pub(super) fn is_ambiguous(&self, best: f64, second: f64) -> bool {
        let ambiguity = self.ambiguity();
        ambiguity < 1.0 && second.is_finite() && best >= ambiguity * second
    }

    /// The share of the second best measure that the best may have: as chosen, or the strategy's own.
    pub fn ambiguity(&self) -> f64 {
        self.ambiguity.unwrap_or(self.strategy.default_ambiguity())
    }

    /// Refuses values outside their ranges.
    pub(crate) fn check(&self) -> Result<(), Error> {
        check("matching.search", self.search as f64)?;
        check("matching.max_measure", self.max_measure)?;
        check("matching.ambiguity", self.ambiguity())?;
        check("matching.parallax_neighbours", self.parallax_neighbours as f64)?;
        check("matching.parallax_tolerance", self.parallax_tolerance)?;
        check("matching.template", self.template as f64)?;
        check("matching.min_correlation", self.min_correlation)?;
        check("matching.max_standard_error", self.max_standard_error)
    }
}
