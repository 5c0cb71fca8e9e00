//! Scenes whose two-view geometry is known, seen by two cameras.

use nalgebra::{Matrix3, Vector3};
use tiepoint::{Pinhole, TwoViewOptions, rotation_from_angles};

pub const SIZE: [f64; 2] = [4000.0, 3000.0];
pub const FOCAL: f64 = 3500.0;
pub const PRINCIPAL: [f64; 2] = [2000.0, 1500.0];

/// Uniform and normal numbers from a seed.
pub struct Dice(u64);

impl Dice {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x1234_5678_9abc_def1)
    }

    pub fn uniform(&mut self, low: f64, high: f64) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        low + (high - low) * (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn normal(&mut self) -> f64 {
        (0..12).map(|_| self.uniform(0.0, 1.0)).sum::<f64>() - 6.0
    }
}

/// Two cameras and the ground they see.
#[derive(Clone, Copy)]
pub struct Scene {
    pub angles: [f64; 3],
    /// Base in units of the flying height.
    pub base: [f64; 3],
    /// Heights above the mean ground are from -relief to relief, in flying heights.
    pub relief: f64,
    /// Share of the points that have a height at all.
    pub raised: f64,
    /// Slope of the ground.
    pub slope: [f64; 2],
}

pub const RELIEF: Scene = Scene { angles: [0.05, -0.08, 0.3], base: [0.4, 0.05, 0.02], relief: 0.15, raised: 1.0, slope: [0.0, 0.0] };
pub const FLAT: Scene = Scene { relief: 0.0, raised: 0.0, ..RELIEF };
pub const TOWN: Scene = Scene { relief: 0.15, raised: 0.2, ..RELIEF };
pub const TURNED: Scene = Scene { angles: [0.1, 0.35, -0.4], base: [0.0, 0.0, 0.0], ..RELIEF };
/// Looking across each other, tilted: the focal length can be told.
pub const CONVERGENT: Scene = Scene { angles: [-0.35, 0.4, 0.2], base: [0.6, 0.5, 0.25], relief: 0.3, raised: 1.0, slope: [0.3, 0.1] };

impl Scene {
    pub fn rotation(&self) -> Matrix3<f64> {
        rotation_from_angles(self.angles[0], self.angles[1], self.angles[2])
    }

    fn see(&self, dice: &mut Dice) -> [f64; 4] {
        for _ in 0..1000 {
            let (x, y) = (dice.uniform(0.0, SIZE[0]), dice.uniform(0.0, SIZE[1]));
            let ray = Vector3::new((x - PRINCIPAL[0]) / FOCAL, (PRINCIPAL[1] - y) / FOCAL, -1.0);
            let height = if dice.uniform(0.0, 1.0) < self.raised { dice.uniform(-self.relief, self.relief) } else { 0.0 };
            // Where the ray meets the ground z = -1 + height + slope · (x, y).
            let depth = (1.0 - height) / (1.0 + self.slope[0] * ray.x + self.slope[1] * ray.y);
            let right = self.rotation() * (ray * depth - Vector3::from(self.base));
            let (u, v) = (PRINCIPAL[0] - FOCAL * right.x / right.z, PRINCIPAL[1] + FOCAL * right.y / right.z);
            if right.z < 0.0 && (0.0..SIZE[0]).contains(&u) && (0.0..SIZE[1]).contains(&v) {
                return [x, y, u, v];
            }
        }
        panic!("the images do not overlap");
    }

    /// Matches with normal errors of `sigma_px`; of `count` a share has right points anywhere. The wrong ones come first.
    pub fn matches(&self, count: usize, sigma_px: f64, wrong: f64, seed: u64) -> Vec<[f64; 4]> {
        let mut dice = Dice::new(seed);
        (0..count)
            .map(|k| {
                let mut p = self.see(&mut dice);
                p.iter_mut().for_each(|v| *v += sigma_px * dice.normal());
                if (k as f64) < wrong * count as f64 {
                    (p[2], p[3]) = (dice.uniform(0.0, SIZE[0]), dice.uniform(0.0, SIZE[1]));
                }
                p
            })
            .collect()
    }

    /// Angle between rotations and between base directions in radians.
    pub fn errors(&self, rotation: &[[f64; 3]; 3], base: &[f64; 3]) -> [f64; 2] {
        let found = Matrix3::from_fn(|i, j| rotation[i][j]);
        let turn = found * self.rotation().transpose();
        let half = (turn - turn.transpose()).norm() / 8f64.sqrt();
        let (base, truth) = (Vector3::from(*base), Vector3::from(self.base).normalize());
        [half.min(1.0).asin(), base.cross(&truth).norm().min(1.0).asin() + if base.dot(&truth) < 0.0 { 3.0 } else { 0.0 }]
    }
}

/// Both cameras known, or their principal points alone.
pub fn cameras(focal_px: Option<f64>) -> TwoViewOptions {
    let camera = Some(Pinhole { focal_px, principal_px: PRINCIPAL });
    TwoViewOptions { left: camera, right: camera, ..TwoViewOptions::default() }
}
