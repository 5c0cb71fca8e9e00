//! Dominant directions of the gradients around a point: the datum of its descriptor.

use super::direction::octants;
use crate::math::Lanes;
use crate::points::Level;
use std::f64::consts::PI;

/// Bins of a full turn.
const BINS: usize = 36;

/// Standard deviation of the window's weights in scales of the point.
const WINDOW: f64 = 2.0;

/// How far the window reaches, in these standard deviations.
const REACH: f64 = 2.25;

/// Another direction counts where its bin has at least this share of the highest.
const SHARE: f32 = 0.8;

/// The directions around a point, the strongest first and `most` of them at the most; rad from x towards y, 0 to 2π.
///
/// `x` and `y` are in pixels of the level with the centre of the top-left one at (0, 0), `scale` is in its pixels as well.
///
/// # Source
/// Lowe 2004, Distinctive image features from scale-invariant keypoints, section 5.
pub(super) fn dominant(level: &Level, x: f64, y: f64, scale: f64, most: usize) -> Vec<f64> {
    let smooth = histogram(level, x, y, scale);
    let before = |k: usize| smooth[(k + BINS - 1) % BINS];
    let after = |k: usize| smooth[(k + 1) % BINS];
    let highest = smooth.iter().fold(0.0, |a: f32, b| a.max(*b));
    let is_peak = |k: &usize| smooth[*k] >= SHARE * highest && smooth[*k] > before(*k) && smooth[*k] >= after(*k);
    let mut peaks: Vec<usize> = (0..BINS).filter(is_peak).collect();
    peaks.sort_by(|a, b| smooth[*b].total_cmp(&smooth[*a]));
    peaks.truncate(most);
    let angle = |k: usize| {
        let [a, b, c] = [before(k), smooth[k], after(k)].map(f64::from);
        let bin = k as f64 + (a - c) / (2.0 * (a - 2.0 * b + c));
        (bin + BINS as f64) % BINS as f64 * (2.0 * PI / BINS as f64)
    };
    peaks.into_iter().map(angle).collect()
}

/// The gradients' magnitudes by direction, weighted by distance, smoothed over neighbouring bins.
fn histogram(level: &Level, x: f64, y: f64, scale: f64) -> [f32; BINS] {
    let sigma = WINDOW * scale;
    let (cols, rows) = (Fall::new(x, sigma, level.width()), Fall::new(y, sigma, level.height()));
    let (stride, data) = (level.stride(), level.data());
    let least = Lanes::splat(libm::exp(-REACH * REACH / 2.0) as f32);
    let mut bins = [0f32; BINS + 2];
    for (row, wy) in rows.weights[..rows.number].iter().enumerate() {
        let line = (rows.first + row) * stride + cols.first;
        for (col, wx) in cols.weights.chunks_exact(4).enumerate() {
            let place = line + 4 * col;
            let four = |place: usize| Lanes::load_whole(&data[place..]);
            let (gx, gy) = (four(place + 1) - four(place - 1), four(place + stride) - four(place - stride));
            // Falls to zero at the reach, beyond which nothing counts.
            let weight = (Lanes::load(wx) * Lanes::splat(*wy) - least).max(Lanes::splat(0.0));
            let amount = ((gx * gx + gy * gy).sqrt() * weight).to_array();
            let bin = (octants(gx, gy) * Lanes::splat(BINS as f32 / 8.0)).to_array();
            for k in 0..4 {
                let lower = bin[k] as usize;
                let upper = amount[k] * (bin[k] - lower as f32);
                bins[lower] += amount[k] - upper;
                bins[lower + 1] += upper;
            }
        }
    }
    (bins[0], bins[1]) = (bins[0] + bins[BINS], bins[1] + bins[BINS + 1]);
    let at = |k: usize, by: usize| bins[(k + BINS + by - 2) % BINS];
    std::array::from_fn(|k| (at(k, 0) + at(k, 4)) * 0.0625 + (at(k, 1) + at(k, 3)) * 0.25 + at(k, 2) * 0.375)
}

/// Gaussian weights of the pixels around a place along a row or column; pixels at the border have no gradient.
struct Fall {
    first: usize,
    number: usize,
    /// Filled up with zeros to a multiple of four.
    weights: Vec<f32>,
}

impl Fall {
    fn new(centre: f64, sigma: f64, length: usize) -> Self {
        let first = libm::ceil(centre - REACH * sigma).max(1.0);
        let last = libm::floor(centre + REACH * sigma).min(length as f64 - 2.0);
        let number = if last >= first { (last - first) as usize + 1 } else { 0 };
        let mut weights = vec![0.0; number.next_multiple_of(4)];
        // From one pixel to the next the weight changes by a factor, and that by another.
        let (d, variance) = (first - centre, sigma * sigma);
        let (mut weight, mut factor) = (libm::exp(-d * d / (2.0 * variance)), libm::exp(-(2.0 * d + 1.0) / (2.0 * variance)));
        let change = libm::exp(-1.0 / variance);
        for w in &mut weights[..number] {
            *w = weight as f32;
            (weight, factor) = (weight * factor, factor * change);
        }
        Self { first: first as usize, number, weights }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{GreyImage, MultiscaleOptions, multiscale_points};

    #[test]
    fn a_ramp_has_the_direction_in_which_it_rises() {
        for (k, [a, b]) in [[2.0, 0.0], [1.4, 1.4], [0.0, 2.0], [-1.0, 1.5], [-2.0, -0.5], [0.3, -1.9]].into_iter().enumerate() {
            let grey = |col: usize, row: usize| (128.0 + a * (col as f64 - 30.0) + b * (row as f64 - 30.0)) as u8;
            let image = GreyImage::from_fn(60, 60, grey).unwrap();
            let (_, space) = multiscale_points(image.view(), None, &MultiscaleOptions::default()).unwrap();
            let found = dominant(space.nearest(2.0).level, 30.2, 29.7, 2.0, 4);
            let wanted = (libm::atan2(b, a) + 2.0 * PI) % (2.0 * PI);
            let miss = (found[0] - wanted + 3.0 * PI) % (2.0 * PI) - PI;
            assert!(found.len() == 1 && miss.abs() < 0.06, "{k}: {found:?} for {wanted}");
        }
    }

    #[test]
    fn a_flat_window_has_no_direction() {
        let image = GreyImage::from_fn(40, 40, |_, _| 77).unwrap();
        let (_, space) = multiscale_points(image.view(), None, &MultiscaleOptions::default()).unwrap();
        assert!(dominant(space.nearest(2.0).level, 20.0, 20.0, 2.0, 1).is_empty());
    }
}
