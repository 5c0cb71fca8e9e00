//! Grey values on a turned grid around a point.

use crate::math::Lanes;
use crate::points::Level;

/// Samples a side of the grid whose gradients are described.
pub(super) const SIDE: usize = 16;

/// Samples a side with those beside the grid, which its gradients need.
pub(super) const PADDED: usize = SIDE + 2;

/// Values a row, a whole number of four at once.
pub(super) const ROW: usize = PADDED.next_multiple_of(4);

/// Where the grid lies, in pixels of the level with the centre of the top-left one at (0, 0).
pub(super) struct Placement {
    pub x: f64,
    pub y: f64,
    /// Between samples.
    pub step: f64,
    /// Cosine and sine of the direction of the grid's rows, from x towards y.
    pub direction: [f64; 2],
}

/// Fills the samples, row by row, by linear interpolation; beyond the border counts what lies nearest to it.
pub(super) fn sample(level: &Level, placement: &Placement, samples: &mut [[f32; ROW]; PADDED]) {
    let (last_col, last_row, stride) = (level.width() - 2, level.height() - 2, level.stride());
    let (x, y) = (placement.x as f32, placement.y as f32);
    let (cos, sin) = ((placement.direction[0] * placement.step) as f32, (placement.direction[1] * placement.step) as f32);
    let zero = Lanes::splat(0.0);
    let (right, bottom) = (Lanes::splat((last_col + 1) as f32), Lanes::splat((last_row + 1) as f32));
    let half = (PADDED - 1) as f32 / 2.0;
    let data = level.data();
    for (j, line) in samples.iter_mut().enumerate() {
        let v = j as f32 - half;
        let (x0, y0) = (Lanes::splat(x - v * sin), Lanes::splat(y + v * cos));
        for (i, four) in line.chunks_exact_mut(4).enumerate() {
            let u = Lanes::new(std::array::from_fn(|k| (4 * i + k) as f32 - half));
            let px = (x0 + u * Lanes::splat(cos)).max(zero).min(right).to_array();
            let py = (y0 + u * Lanes::splat(sin)).max(zero).min(bottom).to_array();
            let mut corners = [[0f32; 4]; 4];
            let (mut fx, mut fy) = ([0f32; 4], [0f32; 4]);
            for k in 0..4 {
                let (col, row) = ((px[k] as usize).min(last_col), (py[k] as usize).min(last_row));
                (fx[k], fy[k]) = (px[k] - col as f32, py[k] - row as f32);
                let square = &data[row * stride + col..][..stride + 2];
                for (corner, grey) in corners.iter_mut().zip([square[0], square[1], square[stride], square[stride + 1]]) {
                    corner[k] = f32::from(grey);
                }
            }
            let [a, b, c, d] = corners.map(Lanes::new);
            let (fx, fy) = (Lanes::new(fx), Lanes::new(fy));
            let (upper, lower) = (a + fx * (b - a), c + fx * (d - c));
            (upper + fy * (lower - upper)).store(four);
        }
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
                let grey = f64::from(*found) / 64.0;
                assert!((grey - (20.0 + 2.0 * x + (y - 0.5) / 2.0)).abs() < 0.3, "{grey} at {x}, {y}");
            }
        }
    }
}
