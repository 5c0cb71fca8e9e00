//! What is known of the errors of observations beside the independent part that their weights describe.

use super::parallax_modes::MODES;
use super::shared::SharedErrors;
use crate::catalogue::refuse;
use crate::error::refuse as refuse_input;
use crate::{Allowed, Error, Refusal};

/// How the errors of observations depend on each other, and how small they can be.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ErrorModel {
    /// Errors that all observations share.
    pub shared: Vec<SharedErrors>,
    /// Standard deviation of each of the modes 1, x, y, xy, x², y² of a y-parallax that matches share, in standard errors of a coordinate (σ₀
    /// a priori where it is given and the residuals do not contradict it); 0: none.
    /// x and y count from the middle of the matches in the left photo; 1 is half the longer side of what they cover.
    pub shared_parallax: [f64; MODES],
    /// Points nearer to each other than this in the left photo, in mm, have errors that depend on each other, as matches whose windows
    /// overlap; 0: none have.
    pub neighbourhood_mm: f64,
    /// The standard error that the resolution of the coordinates alone gives, in mm: 0.29 px where they are whole pixels; 0: not known.
    pub resolution_mm: f64,
}

impl ErrorModel {
    /// Refuses what does not fit the observations.
    pub(super) fn check(&self, observations: usize) -> Result<(), Error> {
        let lengths = [("neighbourhood_mm", self.neighbourhood_mm), ("resolution_mm", self.resolution_mm)];
        for (name, value) in self.shared_parallax.map(|deviation| ("shared_parallax", deviation)).into_iter().chain(lengths) {
            if !(value >= 0.0 && value.is_finite()) {
                return Err(refuse(name, value, Allowed::AtLeast { min: 0.0 }));
            }
        }
        match self.shared.iter().find(|group| group.effects.len() != observations) {
            None => Ok(()),
            Some(group) => refuse_input(Refusal::SharedErrors { effects: group.effects.len(), observations }),
        }
    }
}
