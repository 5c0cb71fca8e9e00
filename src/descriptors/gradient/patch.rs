//! Grey values on a turned grid around a point.

use crate::math::{Lanes, Whole};
use crate::points::Level;

/// Samples a side of the grid whose gradients are described.
pub(super) const SIDE: usize = 16;

/// Samples a side with those beside the grid, which its gradients need.
pub(super) const PADDED: usize = SIDE + 2;

/// Values a row, a whole number of four at once.
pub(super) const ROW: usize = PADDED.next_multiple_of(4);

/// Parts of a pixel between which samples do not differ. With these, sums stay within 30 bits.
const PARTS: i32 = 128;

/// Where the grid lies, in pixels of the level with the centre of the top-left one at (0, 0).
pub(super) struct Placement {
    pub x: f64,
    pub y: f64,
    /// Between samples.
    pub step: f64,
    /// Cosine and sine of the direction of the grid's rows, from x towards y.
    pub direction: [f64; 2],
}

/// Fills the samples, row by row, by linear interpolation, in [`PARTS`]² of the level's units; beyond the border counts what lies nearest
/// to it.
pub(super) fn sample(level: &Level, placement: &Placement, samples: &mut [[f32; ROW]; PADDED]) {
    let stride = level.stride();
    let (x, y) = (placement.x as f32, placement.y as f32);
    let (cos, sin) = ((placement.direction[0] * placement.step) as f32, (placement.direction[1] * placement.step) as f32);
    let half = (PADDED - 1) as f32 / 2.0;
    let (cols, rows) = (Axis::new(level.width()), Axis::new(level.height()));
    let line = Whole::splat(stride as i32);
    for (j, samples) in samples.iter_mut().enumerate() {
        let v = j as f32 - half;
        let (x0, y0) = (Lanes::splat(x - v * sin), Lanes::splat(y + v * cos));
        for (i, four) in samples.chunks_exact_mut(4).enumerate() {
            let u = Lanes::new(std::array::from_fn(|k| (4 * i + k) as f32 - half));
            let (col, across) = cols.split(x0 + u * Lanes::splat(cos));
            let (row, down) = rows.split(y0 + u * Lanes::splat(sin));
            let places = (row * line + col).to_array().map(|place| place as usize);
            // The shares of a pixel and of the one to its right, as a pair of 16 bits.
            let shares = Whole::splat(PARTS) + across * Whole::splat((1 << 16) - 1);
            let upper = Whole::pairs(level.data(), places).dot(shares);
            let lower = Whole::pairs(&level.data()[stride..], places).dot(shares);
            (upper * Whole::splat(PARTS) + (lower - upper) * down).to_lanes().store(four);
        }
    }
}

/// The pixels along a row or column.
struct Axis {
    last: Lanes,
    last_but_one: Whole,
}

impl Axis {
    fn new(length: usize) -> Self {
        Self { last: Lanes::splat((length - 1) as f32), last_but_one: Whole::splat(length as i32 - 2) }
    }

    /// The pixels before places, and how many [`PARTS`] these lie after them.
    #[inline(always)]
    fn split(&self, places: Lanes) -> (Whole, Whole) {
        let within = places.max(Lanes::splat(0.0)).min(self.last);
        let pixels = Whole::truncated(within).clamp(Whole::splat(0), self.last_but_one);
        (pixels, Whole::truncated((within - pixels.to_lanes()) * Lanes::splat(PARTS as f32)))
    }
}
#[cfg(test)]
mod tests {
    use super::*;
    use crate::{GreyImage, MultiscaleOptions, multiscale_points};

    #[test]
    fn samples_of_a_ramp_lie_on_the_turned_grid() {
        // Blurring leaves a ramp as it is, away from the border.
        let image = GreyImage::from_fn(80, 80, |col, row| (20 + 2 * col + row / 2) as u8).unwrap();
        let (_, space) = multiscale_points(image.view(), None, &MultiscaleOptions::default()).unwrap();
        let level = space.nearest(1.5).level;
        let direction = [0.6, 0.8];
        let mut samples = [[0.0; ROW]; PADDED];
        sample(level, &Placement { x: 40.25, y: 39.5, step: 1.5, direction }, &mut samples);
        for (j, line) in samples.iter().enumerate() {
            for (i, found) in line[..PADDED].iter().enumerate() {
                let (u, v) = (1.5 * (i as f64 - 8.5), 1.5 * (j as f64 - 8.5));
                let (x, y) = (40.25 + u * 0.6 - v * 0.8, 39.5 + u * 0.8 + v * 0.6);
                let grey = f64::from(*found) / 128.0 / f64::from(PARTS * PARTS);
                assert!((grey - (20.0 + 2.0 * x + (y - 0.5) / 2.0)).abs() < 0.3, "{grey} at {x}, {y}");
            }
        }
    }
}
