//! A river through the town: smooth, dark, and never twice the same.

use super::super::buckets::Rectangle;
use super::super::lattice::fractal;
use super::super::random::Random;
use super::axes::Axes;
use super::moment::Moment;

/// A winding band of water.
pub(super) struct River {
    /// u runs downstream.
    axes: Axes,
    half_width_m: f64,
    /// Amplitude and length of a bend in m.
    swing_m: f64,
    bend_m: f64,
}

impl River {
    /// A river of a width through the middle of an area.
    pub(super) fn new(area: Rectangle, width_m: f64, random: &mut Random) -> Self {
        let middle = [0.5 * (area[0] + area[2]), 0.5 * (area[1] + area[3])];
        let axes = Axes::new(middle, random.between(0.9, 2.2));
        Self { axes, half_width_m: 0.5 * width_m, swing_m: random.between(15.0, 40.0), bend_m: random.between(180.0, 320.0) }
    }

    /// Distance in m of a place from the bank, negative in the water.
    pub(super) fn bank_distance_m(&self, x: f64, y: f64) -> f64 {
        let [u, v] = self.axes.to_local(x, y);
        (v - self.swing_m * libm::sin(u / self.bend_m * std::f64::consts::TAU)).abs() - self.half_width_m
    }

    /// Whether a place lies in the water.
    pub(super) fn holds(&self, x: f64, y: f64) -> bool {
        self.bank_distance_m(x, y) < 0.0
    }
}

/// Grey of the water in full sun: dark, with ripples that no other exposure shows.
pub(super) fn tone(x: f64, y: f64, moment: Moment) -> f64 {
    let seed = if moment == Moment::First { 0x31 } else { 0x77 };
    let ripples = fractal(x, y, 9.0, 3, 0.8, seed);
    48.0 + 16.0 * ripples + if ripples > 0.55 { 90.0 } else { 0.0 }
}
