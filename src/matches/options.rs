//! What the user chooses of the matching.

use crate::parameters::check;
use crate::{Error, Measure};
use serde::{Deserialize, Serialize};

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

/// Options of [`match_points`](crate::match_points).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct MatchOptions {
    pub measure: Measure,
    pub denominator: Denominator,
    /// Side of the search window in px, odd.
    pub search: usize,
    /// The best measure must be below this.
    pub max_measure: f64,
    /// Refused when the best measure exceeds this share of the second best, 0..1.
    pub ambiguity: f64,
    /// Number of nearest matches that give the expected y-parallax; 0 switches the rule off.
    pub parallax_neighbours: usize,
    /// Least deviation of the y-parallax that is refused, in px.
    pub parallax_tolerance: f64,
}

impl Default for MatchOptions {
    fn default() -> Self {
        Self {
            measure: Measure::Dm,
            denominator: Denominator::Maxabs,
            search: 25,
            max_measure: 3.0,
            ambiguity: 0.9,
            parallax_neighbours: 12,
            parallax_tolerance: 1.0,
        }
    }
}

impl MatchOptions {
    /// Refuses values outside their ranges.
    pub(crate) fn check(&self) -> Result<(), Error> {
        check("matching.search", self.search as f64)?;
        check("matching.max_measure", self.max_measure)?;
        check("matching.ambiguity", self.ambiguity)?;
        check("matching.parallax_neighbours", self.parallax_neighbours as f64)?;
        check("matching.parallax_tolerance", self.parallax_tolerance)
    }
}
