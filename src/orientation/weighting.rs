//! Robust weights: what the residuals of an adjustment make of the weights of the next.

use super::adjusted::Adjusted;
use super::adjustment::{self, adjust};
use super::coplanarity::Ray;
use super::in_twos::{linearised, projected};
use super::options::Weighting;
use super::rejection::share_of_unknowns;
use crate::Error;

/// Where Huber's weights begin to fall, in standard errors.
const HUBER: f64 = 1.5;
/// Where the Danish weights begin to fall, and how fast; from there on, so that no weight jumps.
const DANISH: f64 = 2.0;
const DANISH_FALL: f64 = 0.05;

/// Rounds of reweighting; each weight then changes by less than `SETTLED`.
const MAX_ROUNDS: usize = 30;
const SETTLED: f64 = 1e-4;

impl Weighting {
    /// The factor of an observation's weight at a standardised residual.
    fn factor(self, w: f64) -> f64 {
        let w = w.abs();
        match self {
            Self::None => 1.0,
            Self::Huber => (HUBER / w).min(1.0),
            Self::Danish if w <= DANISH => 1.0,
            Self::Danish => libm::exp(DANISH_FALL * (DANISH * DANISH * DANISH - w * w * w)),
        }
    }

    /// The derivative of w · factor(w).
    fn slope(self, w: f64) -> f64 {
        let w = w.abs();
        match self {
            Self::None => 1.0,
            Self::Huber => f64::from(u8::from(w <= HUBER)),
            Self::Danish if w <= DANISH => 1.0,
            Self::Danish => (1.0 - 3.0 * DANISH_FALL * w * w * w) * self.factor(w),
        }
    }
}

/// Adjusts again with weights that follow from the residuals, until they settle; gives the factors of the weights too.
///
/// `adjusted` is the adjustment of the observations with their own weights; `sigma` standardises the residuals. The cofactors are those of
/// the weighted normal equations; the precision is that of least squares times the ratio of the variances of both estimates.
///
/// # Errors
/// Those of [`adjust`].
///
/// # Source
/// Huber 1981, Robust Statistics, 7.6 (cofactors of an M-estimate).
pub(super) fn reweight(
    rays: &[Ray],
    weights: &[f64],
    adjusted: Adjusted,
    sigma: f64,
    weighting: Weighting,
) -> Result<(Adjusted, Vec<f64>), Error> {
    let mut factors = vec![1.0; rays.len()];
    if weighting == Weighting::None || !(sigma > 0.0) {
        return Ok((adjusted, factors));
    }
    let mut current = adjusted.clone();
    for _ in 0..MAX_ROUNDS {
        let standardised = standardised(rays, weights, &current, &adjusted, sigma);
        let next: Vec<f64> = standardised.iter().map(|w| weighting.factor(*w)).collect();
        let change = next.iter().zip(&factors).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        factors = next;
        if change < SETTLED {
            break;
        }
        let products: Vec<f64> = weights.iter().zip(&factors).map(|(weight, factor)| weight * factor).collect();
        current = adjust(rays, &products, current.pose, adjustment::SETTLED, |_| Ok(()))?;
    }
    let standardised = standardised(rays, weights, &current, &adjusted, sigma);
    let number = rays.len() as f64;
    let influence = standardised
        .iter()
        .map(|w| {
            let psi = w * weighting.factor(*w);
            psi * psi
        })
        .sum::<f64>()
        / number;
    let slope = standardised.iter().map(|w| weighting.slope(*w)).sum::<f64>() / number;
    // What few observations add (Huber's K).
    let spread = standardised.iter().map(|w| weighting.slope(*w) - slope).map(|d| d * d).sum::<f64>() / number;
    let few = 1.0 + 5.0 / number * spread / (slope * slope);
    let ratio = few * few * influence / (slope * slope);
    let (precision, sensitivity) = (adjusted.precision * ratio, adjusted.sensitivity / slope);
    let result = Adjusted { precision, sensitivity, sigma: adjusted.sigma, variance_left: adjusted.variance_left, ..current };
    Ok((result, factors))
}

/// Residuals at the pose of one adjustment by the standard errors that another gave them.
fn standardised(rays: &[Ray], weights: &[f64], at: &Adjusted, of: &Adjusted, sigma: f64) -> Vec<f64> {
    let (places, distances) = projected(&at.pose, rays);
    let mut all = Vec::with_capacity(rays.len());
    linearised(&of.pose, rays, &places, |k, line| {
        let cofactor = line.map_or(0.0, |line| 1.0 / weights[k] - share_of_unknowns(&line, of));
        all.push(if cofactor * weights[k] > 1e-6 { distances[k] / (cofactor.sqrt() * sigma) } else { 0.0 });
    });
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slopes_are_the_derivatives() {
        for weighting in [Weighting::None, Weighting::Huber, Weighting::Danish] {
            for w in [-4.0, -1.2, 0.3, 1.4, 1.7, 2.6, 5.0] {
                let h = 1e-6;
                let numeric = ((w + h) * weighting.factor(w + h) - (w - h) * weighting.factor(w - h)) / (2.0 * h);
                assert!((weighting.slope(w) - numeric).abs() < 1e-6, "{weighting:?} {w}: {numeric}");
            }
        }
    }
}
