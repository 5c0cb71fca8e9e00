//! From light to grey values: gain, offset, noise, 8 bits.

use super::random::Random;
use crate::{Error, GreyImage};

/// How a camera and its scanner turn light into grey values.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sensor {
    pub(super) gain: f64,
    pub(super) offset_grey: f64,
    pub(super) noise_grey: f64,
}

impl Sensor {
    /// Records rendered light, row by row; what leaves 0..255 is clipped.
    pub(super) fn record(&self, light: &[f64], width: usize, height: usize, random: &mut Random) -> Result<GreyImage, Error> {
        let mut data = Vec::with_capacity(light.len());
        for pair in light.chunks(2) {
            let noise = random.normal_pair();
            data.extend(pair.iter().zip(noise.iter()).map(|(light, noise)| {
                let grey = self.gain * light + self.offset_grey + self.noise_grey * noise;
                grey.round().clamp(0.0, 255.0) as u8
            }));
        }
        GreyImage::new(width, height, data)
    }
}
