//! From light to grey values: haze, gain, offset, grain, noise, 8 bits.

use super::random::Random;
use crate::{Error, GreyImage};

/// How a camera and its scanner turn light into grey values.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sensor {
    pub(super) gain: f64,
    pub(super) offset_grey: f64,
    pub(super) noise_grey: f64,
    pub(super) grain_grey: f64,
    pub(super) grain_px: f64,
    pub(super) haze: f64,
}

/// Grey of the haze itself.
const VEIL_GREY: f64 = 190.0;

impl Sensor {
    /// Records rendered light, row by row; what leaves 0..255 is clipped. Noise and grain each have random numbers of their own.
    pub(super) fn record(&self, light: &[f64], width: usize, height: usize, random: [Random; 2]) -> Result<GreyImage, Error> {
        let [mut noise_random, mut grain_random] = random;
        let grain = if self.grain_grey > 0.0 { grain(width, height, self.grain_px, &mut grain_random) } else { Vec::new() };
        let mut data = Vec::with_capacity(light.len());
        for (index, pair) in light.chunks(2).enumerate() {
            let noise = noise_random.normal_pair();
            data.extend(pair.iter().zip(noise.iter()).enumerate().map(|(k, (light, noise))| {
                let seen = if self.haze > 0.0 { light + self.haze * (VEIL_GREY - light) } else { *light };
                let grained = grain.get(2 * index + k).map_or(0.0, |grain| self.grain_grey * grain);
                let grey = self.gain * seen + self.offset_grey + self.noise_grey * noise + grained;
                grey.round().clamp(0.0, 255.0) as u8
            }));
        }
        GreyImage::new(width, height, data)
    }
}

/// Noise of standard deviation 1 that neighbours share: independent noise spread by a Gauss function of `spread_px`.
fn grain(width: usize, height: usize, spread_px: f64, random: &mut Random) -> Vec<f64> {
    let reach = (3.0 * spread_px).ceil() as usize;
    let mut kernel: Vec<f64> =
        (0..=2 * reach).map(|k| k as f64 - reach as f64).map(|d| libm::exp(-0.5 * d * d / (spread_px * spread_px))).collect();
    let size = kernel.iter().map(|k| k * k).sum::<f64>().sqrt();
    kernel.iter_mut().for_each(|k| *k /= size);
    let (wide, high) = (width + 2 * reach, height + 2 * reach);
    let independent: Vec<f64> = (0..(wide * high).div_ceil(2)).flat_map(|_| <[f64; 2]>::from(random.normal_pair())).collect();
    let along = |row: usize, col: usize| kernel.iter().zip(&independent[row * wide + col..]).map(|(k, v)| k * v).sum::<f64>();
    let spread: Vec<f64> = (0..high).flat_map(|row| (0..width).map(move |col| (row, col))).map(|(row, col)| along(row, col)).collect();
    let down = |row: usize, col: usize| kernel.iter().enumerate().map(|(k, weight)| weight * spread[(row + k) * width + col]).sum::<f64>();
    (0..height).flat_map(|row| (0..width).map(move |col| (row, col))).map(|(row, col)| down(row, col)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simulate::random::Stream;

    #[test]
    fn grain_is_as_strong_and_as_wide_as_wanted() {
        let (width, height, spread) = (200, 150, 1.5);
        let grain = grain(width, height, spread, &mut Random::new(4, Stream::LeftGrain));
        let mean = |step: usize| {
            let pairs = (0..height).flat_map(|row| (0..width - step).map(move |col| row * width + col));
            let products: Vec<f64> = pairs.map(|k| grain[k] * grain[k + step]).collect();
            products.iter().sum::<f64>() / products.len() as f64
        };
        assert!((mean(0) - 1.0).abs() < 0.1, "variance {}", mean(0));
        for step in [1, 2, 4] {
            let wanted = (-((step * step) as f64) / (4.0 * spread * spread)).exp();
            assert!((mean(step) / mean(0) - wanted).abs() < 0.06, "{step} px apart: {}", mean(step) / mean(0));
        }
    }
}
