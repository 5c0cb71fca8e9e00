//! Seeded random numbers: one independent stream a purpose, so that a change in one part leaves the others as they were.

use nalgebra::Vector2;
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;

/// The seed of the built-in sample.
pub const SAMPLE_SEED: u32 = 1;

/// What random numbers are drawn for.
#[derive(Debug, Clone, Copy)]
pub(super) enum Stream {
    Relief,
    Streets,
    Blocks,
    Buildings,
    Trees,
    LeftScan,
    RightScan,
    Cut,
    LeftNoise,
    RightNoise,
    LeftGrain,
    RightGrain,
    River,
    BlockFlight,
    BlockGround,
    BlockFeatures,
    BlockMatches,
    NetworkOrientations,
    NetworkPoints,
    NetworkNoise,
    NetworkApproximations,
    BlockReceiver,
    BlockNoise,
}

/// A stream of random numbers.
pub(super) struct Random(Pcg32);

impl Random {
    pub(super) fn new(seed: u32, stream: Stream) -> Self {
        Self(Pcg32::new(u64::from(seed), stream as u64))
    }

    pub(super) fn bits(&mut self) -> u32 {
        self.0.next_u32()
    }

    /// Uniform in [0, 1).
    pub(super) fn uniform(&mut self) -> f64 {
        f64::from(self.bits()) / 4_294_967_296.0
    }

    /// Uniform in [low, high).
    pub(super) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.uniform()
    }

    /// True with the given probability.
    pub(super) fn chance(&mut self, probability: f64) -> bool {
        self.uniform() < probability
    }

    /// One of the values of a list that is not empty.
    pub(super) fn pick(&mut self, values: &[f64]) -> f64 {
        values[((self.uniform() * values.len() as f64) as usize).min(values.len() - 1)]
    }

    /// Two independent numbers of the standard normal distribution.
    ///
    /// # Source
    /// Box & Muller 1958.
    pub(super) fn normal_pair(&mut self) -> Vector2<f64> {
        let radius = (-2.0 * libm::log(1.0 - self.uniform())).sqrt();
        let (sin, cos) = libm::sincos(2.0 * std::f64::consts::PI * self.uniform());
        Vector2::new(radius * cos, radius * sin)
    }
}
