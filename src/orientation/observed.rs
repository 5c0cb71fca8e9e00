//! What an adjustment is given: observations with their weights, and by what they are judged.

use super::coplanarity::Ray;
use super::significance::significance_of_test;
use crate::math::{normal_outside, normal_quantile};

/// Observations with their weights.
#[derive(Debug, Clone, Copy)]
pub(super) struct Weighted<'a> {
    pub rays: &'a [Ray],
    pub weights: &'a [f64],
}

impl Weighted<'_> {
    /// The rays and weights of those that are kept.
    pub fn kept(&self, accepted: &[bool]) -> (Vec<Ray>, Vec<f64>) {
        let all = self.rays.iter().zip(self.weights).zip(accepted);
        all.filter(|(_, kept)| **kept).map(|((ray, weight), _)| (*ray, *weight)).unzip()
    }
}

/// Below this (in units of the focal length) residuals are rounding, and none is a gross error.
const LEAST_SCALE: f64 = 1e-11;

/// What is known of σ before, and how often a good observation may be rejected.
#[derive(Debug, Clone, Copy)]
pub(super) struct Limits {
    /// The share of good observations that is rejected by mistake.
    pub alpha0: f64,
    /// σ as it was known before, in units of the focal length: tests use it in place of the estimated one.
    pub known_sigma: Option<f64>,
    /// σ is at least this: what the resolution of the coordinates gives; 0 where that is not known.
    pub resolution: f64,
}

impl Limits {
    /// The limit of a standardised residual by a σ that is known.
    pub fn normal(&self) -> f64 {
        normal_quantile(1.0 - 0.5 * self.alpha0)
    }

    /// Hardly ever more than so many of `number` good observations are rejected by mistake: their expected number, and as many of its standard
    /// deviations as the limit of a residual has.
    pub fn most_by_mistake(&self, number: usize) -> usize {
        let expected = self.alpha0 * number as f64;
        (expected + self.normal() * expected.sqrt()) as usize
    }

    /// The logarithm of the probability with which two good observations are rejected by mistake.
    pub fn beyond_doubt(&self) -> f64 {
        2.0 * libm::log(self.alpha0)
    }

    /// σ is at least this.
    pub fn least_sigma(&self) -> f64 {
        self.known_sigma.unwrap_or(0.0).max(self.resolution).max(LEAST_SCALE)
    }

    /// The share of good observations that the limit rejects in an adjustment of so many degrees of freedom: less where it is by the least σ rather than
    /// by the estimated one.
    pub fn share_beyond(&self, estimated: f64, freedom: usize) -> f64 {
        let wider = (self.least_sigma() / estimated.max(f64::MIN_POSITIVE)).max(1.0);
        match self.known_sigma {
            _ if wider > 1.0 => normal_outside(self.normal() * wider),
            Some(_) => self.alpha0,
            None => significance_of_test(self.alpha0, freedom),
        }
    }

    /// σ² is at least this.
    pub fn least_square(&self) -> f64 {
        self.least_sigma() * self.least_sigma()
    }
}
