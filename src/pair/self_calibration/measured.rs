//! What the matches of one pair are to its self-calibration.

use crate::orientation::MODES;

/// Matches of one pair: positions in px, their weights, and the standard error of a coordinate of weight 1 in focal lengths.
pub struct Measured<'a> {
    pub positions: &'a [[f64; 4]],
    pub weights: &'a [f64],
    pub sigma: f64,
    /// Standard deviation of each mode of the y-parallax that they share, in standard errors of a coordinate.
    pub shared_parallax: [f64; MODES],
    /// Side of a cell in which matches share errors, in focal lengths.
    pub neighbourhood: f64,
}
