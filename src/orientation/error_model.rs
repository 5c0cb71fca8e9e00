//! What is known of the errors of observations beside the independent part that their weights describe.

use super::shared::SharedErrors;
use crate::catalogue::refuse;
use crate::error::refuse as refuse_input;
use crate::{Error, Refusal};

/// How the errors of observations depend on each other, and how small they can be.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ErrorModel {
    /// Errors that all observations share.
    pub shared: Vec<SharedErrors>,
    /// Standard deviation of each of the modes 1, x, y, xy, x², y² (1 at the largest coordinate of the left photo) of a y-parallax that matches share,
    /// in standard errors of a coordinate; 0: none.
    pub shared_parallax: f64,
    /// Points nearer to each other than this in the left photo, in mm, have errors that depend on each other, as matches whose windows
    /// overlap; 0: none have.
    pub neighbourhood_mm: f64,
    /// The standard error that the resolution of the coordinates alone gives, in mm: 0.29 px where they are whole pixels; 0: not known.
    pub resolution_mm: f64,
}

impl ErrorModel {
    /// Refuses what does not fit the observations.
    pub(super) fn check(&self, observations: usize) -> Result<(), Error> {
        let values =
            [("shared_parallax", self.shared_parallax), ("neighbourhood_mm", self.neighbourhood_mm), ("resolution_mm", self.resolution_mm)];
        for (name, value) in values {
            if !(value >= 0.0 && value.is_finite()) {
                return Err(refuse(name, value, "0 or more"));
            }
        }
        match self.shared.iter().find(|group| group.effects.len() != observations) {
            None => Ok(()),
            Some(group) => refuse_input(Refusal::SharedErrors { effects: group.effects.len(), observations }),
        }
    }
}
