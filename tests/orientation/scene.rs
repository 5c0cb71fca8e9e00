//! Photos of generated ground: points are projected by the collinearity equations, written here once more.

use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;
use tiepoint::{Observation, OrientationOptions, RelativeOrientation, rotation_from_angles};

pub const FOCAL_MM: f64 = 153.38;

/// Uniform and normal random numbers.
pub struct Dice(Pcg32);

impl Dice {
    pub fn new(seed: u64) -> Self {
        Self(Pcg32::new(seed, 77))
    }

    pub fn uniform(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (f64::from(self.0.next_u32()) + 0.5) / 4_294_967_296.0
    }

    pub fn normal(&mut self) -> f64 {
        (-2.0 * self.uniform(0.0, 1.0).ln()).sqrt() * (std::f64::consts::TAU * self.uniform(0.0, 1.0)).cos()
    }
}

/// A pair of photos over some ground: the left photo at the origin without rotation, base and ground at photo scale (mm).
#[derive(Clone, Copy)]
pub struct Pair {
    /// ω φ κ in degrees.
    pub angles_deg: [f64; 3],
    pub base: [f64; 3],
    /// Heights above the mean ground, as a share of the flying height: ±relief.
    pub relief: f64,
    /// Tilt of the ground against the left photo: an oblique pair.
    pub ground_slope: f64,
}

pub const NADIR: Pair = Pair { angles_deg: [0.3, -0.2, 0.15], base: [92.0, 1.2, -0.4], relief: 0.08, ground_slope: 0.0 };
pub const OBLIQUE: Pair = Pair { angles_deg: [4.0, -12.0, 8.0], base: [70.0, 25.0, 15.0], relief: 0.1, ground_slope: 0.6 };
pub const UPSIDE_DOWN: Pair = Pair { angles_deg: [1.5, -2.0, 179.2], ..NADIR };
pub const ALONG_Y: Pair = Pair { angles_deg: [1.0, 0.5, -3.0], base: [6.0, 80.0, -2.0], relief: 0.1, ground_slope: 0.0 };
pub const TO_THE_LEFT: Pair = Pair { angles_deg: [-0.5, 1.0, 12.0], base: [-85.0, 4.0, 3.0], relief: 0.08, ground_slope: 0.0 };
pub const PLANE: Pair = Pair { relief: 0.0, ..NADIR };

impl Pair {
    pub fn see(&self, dice: &mut Dice) -> Observation {
        let m = rotation_from_angles(self.angles_deg[0].to_radians(), self.angles_deg[1].to_radians(), self.angles_deg[2].to_radians());
        loop {
            let (x, y) = (dice.uniform(-115.0, 115.0), dice.uniform(-115.0, 115.0));
            let depth = FOCAL_MM * (1.0 + self.relief * dice.uniform(-1.0, 1.0)) / (1.0 - self.ground_slope * y / FOCAL_MM);
            let point = [x * depth / FOCAL_MM, y * depth / FOCAL_MM, -depth];
            let from_right = nalgebra::Vector3::new(point[0] - self.base[0], point[1] - self.base[1], point[2] - self.base[2]);
            let seen = m * from_right;
            let right = [-FOCAL_MM * seen.x / seen.z, -FOCAL_MM * seen.y / seen.z];
            if seen.z < 0.0 && right.iter().all(|v| v.abs() < 115.0) {
                return Observation::new([x, y], right);
            }
        }
    }

    pub fn observe(&self, count: usize, sigma_mm: f64, seed: u64) -> Vec<Observation> {
        let mut dice = Dice::new(seed);
        let mut observations = Vec::with_capacity(count);
        for _ in 0..count {
            let mut o = self.see(&mut dice);
            o.left.iter_mut().chain(&mut o.right).for_each(|v| *v += sigma_mm * dice.normal());
            observations.push(o);
        }
        observations
    }

    pub fn options(&self) -> OrientationOptions {
        OrientationOptions { base_mm: Some(self.base[0]), ..OrientationOptions::default() }
    }

    /// Differences from the truth: degrees, mm.
    pub fn errors(&self, found: &RelativeOrientation) -> [f64; 5] {
        let turn = |got: f64, wanted: f64| (got - wanted + 540.0).rem_euclid(360.0) - 180.0;
        let p = &found.parameters;
        [
            turn(p.omega_deg, self.angles_deg[0]),
            turn(p.phi_deg, self.angles_deg[1]),
            turn(p.kappa_deg, self.angles_deg[2]),
            p.by_mm - self.base[1],
            p.bz_mm - self.base[2],
        ]
    }
}

/// Replaces every observation below `share` of the way by one whose right point lies anywhere within ±12 px of 0.254 mm.
pub fn spoil(observations: &mut [Observation], share: f64, seed: u64) -> Vec<usize> {
    let mut dice = Dice::new(seed);
    let count = (share * observations.len() as f64) as usize;
    let spoiled: Vec<usize> = (0..count).map(|k| k * observations.len() / count.max(1)).collect();
    for &index in &spoiled {
        observations[index].right.iter_mut().for_each(|v| *v += dice.uniform(-12.0 * 0.254, 12.0 * 0.254));
    }
    spoiled
}

pub fn standard_errors(found: &RelativeOrientation) -> [f64; 5] {
    let s = found.standard_errors.expect("there is redundancy");
    [s.omega_deg, s.phi_deg, s.kappa_deg, s.by_mm, s.bz_mm]
}
