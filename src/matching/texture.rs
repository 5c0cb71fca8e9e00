//! For tests: a band-limited texture given by a formula, so that an image of it under any map is true without interpolation.

use crate::GreyImage;
use crate::math::Random;

/// A sum of 60 waves in random directions; mean 128, standard deviation 35 grey values.
pub(crate) struct Texture(Vec<Wave>);

struct Wave {
    /// Angular frequency in x and y, per px.
    frequency: [f64; 2],
    phase: f64,
    amplitude: f64,
}

impl Texture {
    /// Wavelengths are between the two in px; the longer, the stronger.
    pub fn new(seed: u32, shortest: f64, longest: f64) -> Self {
        let mut random = Random::new(seed);
        let mut waves: Vec<Wave> = (0..60)
            .map(|_| {
                let length = shortest * libm::pow(longest / shortest, unit(&mut random));
                let direction = std::f64::consts::TAU * unit(&mut random);
                let angular = std::f64::consts::TAU / length;
                let frequency = [angular * libm::cos(direction), angular * libm::sin(direction)];
                Wave { frequency, phase: std::f64::consts::TAU * unit(&mut random), amplitude: length.sqrt() }
            })
            .collect();
        let deviation = waves.iter().map(|w| 0.5 * w.amplitude * w.amplitude).sum::<f64>().sqrt();
        waves.iter_mut().for_each(|w| w.amplitude *= 35.0 / deviation);
        Self(waves)
    }

    fn at(&self, [x, y]: [f64; 2]) -> f64 {
        128.0 + self.0.iter().map(|w| w.amplitude * libm::cos(w.frequency[0] * x + w.frequency[1] * y + w.phase)).sum::<f64>()
    }

    /// An image of `gain` · texture + `offset` + noise of standard deviation `noise`, rounded to 8 bits; `place` gives the place in the
    /// texture of a position in px.
    pub fn image(&self, side: usize, place: impl Fn([f64; 2]) -> [f64; 2], [gain, offset, noise]: [f64; 3], seed: u32) -> GreyImage {
        let mut random = Random::new(seed);
        let data = (0..side * side).map(|k| {
            // A sum of 12 uniform numbers has variance 1.
            let normal = (0..12).map(|_| unit(&mut random)).sum::<f64>() - 6.0;
            let light = self.at(place([(k % side) as f64 + 0.5, (k / side) as f64 + 0.5]));
            libm::round(gain * light + offset + noise * normal).clamp(0.0, 255.0) as u8
        });
        GreyImage::new(side, side, data.collect()).unwrap()
    }

    /// The texture as it is.
    pub fn plain(&self, side: usize, noise: f64, seed: u32) -> GreyImage {
        self.image(side, |p| p, [1.0, 0.0, noise], seed)
    }
}

fn unit(random: &mut Random) -> f64 {
    (random.below(1 << 30) as f64 + 0.5) / (1u64 << 30) as f64
}
