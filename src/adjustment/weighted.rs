//! Observed positions, by their weights.

use super::block::{Block, PositionPrior};
use super::options::Datum;

/// An observed position with the weights of its coordinates; 0 for one that was not observed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Weighted {
    pub position: [f64; 3],
    pub weight: [f64; 3],
}

impl Weighted {
    fn new(prior: &PositionPrior, sigma0: f64) -> Self {
        let weight = prior.sigma.map(|sigma| sigma.map_or(0.0, |sigma| sigma0 / sigma * (sigma0 / sigma)));
        Self { position: [0, 1, 2].map(|k| if weight[k] > 0.0 { prior.position[k] } else { 0.0 }), weight }
    }

    /// Number of its coordinates.
    pub fn observed(&self) -> usize {
        self.weight.iter().filter(|weight| **weight > 0.0).count()
    }

    /// Standard error of its length, for standard errors that were weighted by 1; `None` where a coordinate was not observed.
    pub fn length_error(&self) -> Option<f64> {
        (self.observed() == 3).then(|| self.weight.iter().map(|weight| 1.0 / weight).sum::<f64>().sqrt())
    }
}

/// What a datum observes, for a standard error `sigma0` of a ray of weight 1: images, then points.
pub(super) fn observed(block: &Block, datum: Datum, sigma0: f64) -> (Vec<Option<Weighted>>, Vec<Option<Weighted>>) {
    let gnss = block.images.iter().map(|i| i.gnss.filter(|_| datum.uses_gnss()).map(|prior| Weighted::new(&prior, sigma0))).collect();
    let mut control = vec![None; block.points.len()];
    for c in block.control.iter().filter(|_| datum.uses_control()) {
        control[c.point] = Some(Weighted::new(&PositionPrior { position: c.position, sigma: c.sigma.map(Some) }, sigma0));
    }
    (gnss, control)
}
