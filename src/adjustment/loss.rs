//! Robust loss: what a squared residual costs, and the weight that is left to it.

use super::options::Loss;

/// Where the weights begin to fall, in standard errors of a coordinate; the length of a ray's residual is compared.
const HUBER: f64 = 2.0;
const CAUCHY: f64 = 3.0;

/// A loss with its scale.
#[derive(Debug, Clone, Copy)]
pub(super) struct Robust {
    loss: Loss,
    /// Square of the length at which weights begin to fall.
    width2: f64,
}

impl Robust {
    /// For residuals whose coordinates have the standard error `sigma`.
    pub fn new(loss: Loss, sigma: f64) -> Self {
        let width = sigma
            * match loss {
                Loss::Squares => 1.0,
                Loss::Huber => HUBER,
                Loss::Cauchy => CAUCHY,
            };
        Self { loss, width2: (width * width).max(f64::MIN_POSITIVE) }
    }

    pub fn squares() -> Self {
        Self { loss: Loss::Squares, width2: 1.0 }
    }

    /// What a squared, weighted residual costs.
    pub fn cost(self, square: f64) -> f64 {
        match self.loss {
            Loss::Squares => square,
            Loss::Huber if square <= self.width2 => square,
            Loss::Huber => 2.0 * (self.width2 * square).sqrt() - self.width2,
            Loss::Cauchy => self.width2 * libm::log1p(square / self.width2),
        }
    }

    /// The factor of its weight: the derivative of the cost.
    pub fn factor(self, square: f64) -> f64 {
        match self.loss {
            Loss::Squares => 1.0,
            Loss::Huber if square <= self.width2 => 1.0,
            Loss::Huber => (self.width2 / square).sqrt(),
            Loss::Cauchy => 1.0 / (1.0 + square / self.width2),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn factors_are_the_derivatives_of_the_costs() {
        for loss in [Loss::Squares, Loss::Huber, Loss::Cauchy] {
            let robust = Robust::new(loss, 0.7);
            for square in [0.1, 1.0, 1.9, 5.0, 400.0] {
                let h = 1e-5 * square;
                let numeric = (robust.cost(square + h) - robust.cost(square - h)) / (2.0 * h);
                assert!((robust.factor(square) - numeric).abs() < 1e-7, "{loss:?} {square}: {numeric}");
            }
        }
    }
}
