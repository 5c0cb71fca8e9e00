//! Position between the pixels: the maximum of the response on a grid finer than the level's.
//!
//! A quadratic through responses one pixel apart is drawn towards the pixels, since the response falls faster than it. Half a pixel apart
//! it is not: the level is blurred enough for its grey values there to follow from the pixels.

use super::level::Level;
use crate::math::Lanes;

/// Samples in a pixel.
const FINER: f64 = 2.0;

/// Samples a side: those of 3 x 3 responses with their neighbours a pixel away.
const SIDE: usize = 7;

/// Samples that make a pixel: the distance over which derivatives are differences.
const PIXEL: usize = 2;

/// Steps towards the maximum; more change nothing.
const STEPS: usize = 2;

/// A maximum that is farther in pixels from where the search began is that of another point.
const FARTHEST: f64 = 1.0;

/// The maximum of the response near a place, in pixels of the level with the centre of the top-left one at (0, 0).
///
/// `None` at the border and where no maximum is within a pixel.
pub(super) fn maximum(level: &Level, start: [f64; 2]) -> Option<[f64; 2]> {
    let mut place = start;
    for _ in 0..STEPS {
        let [dx, dy] = top(&responses(level, place)?)?;
        place = [place[0] + dx / FINER, place[1] + dy / FINER];
        if !place.iter().zip(start).all(|(found, from)| (found - from).abs() <= FARTHEST) {
            return None;
        }
    }
    Some(place)
}

/// The determinants of the Hessian at a place and around it, by row and column; `None` at the border.
fn responses(level: &Level, [x, y]: [f64; 2]) -> Option<[[f64; 3]; 3]> {
    let grey = samples(level, &Taps::around(x, level.width())?, &Taps::around(y, level.height())?);
    let determinant = |i: usize, j: usize| {
        let twice = 2.0 * grey[j][i];
        let xx = grey[j][i + PIXEL] + grey[j][i - PIXEL] - twice;
        let yy = grey[j + PIXEL][i] + grey[j - PIXEL][i] - twice;
        let mixed = |j: usize| grey[j][i + PIXEL] - grey[j][i - PIXEL];
        let xy = 0.25 * (mixed(j + PIXEL) - mixed(j - PIXEL));
        f64::from(xx * yy - xy * xy)
    };
    Some(std::array::from_fn(|j| std::array::from_fn(|i| determinant(i + PIXEL, j + PIXEL))))
}

/// Grey values half a pixel apart, by row and column, less that of a pixel near the middle, so that their differences keep their decimals.
fn samples(level: &Level, cols: &Taps, rows: &Taps) -> [[f32; SIDE]; SIDE] {
    let (stride, data) = (level.stride(), level.data());
    let middle = Lanes::splat(f32::from(data[(rows.first + SIDE / 2) * stride + cols.first + SIDE / 2]));
    // Of each row of pixels, the samples a whole number of pixels from the first, then those between.
    let along: [[Lanes; 2]; SIDE] = std::array::from_fn(|r| {
        let line = (rows.first + r) * stride + cols.first;
        std::array::from_fn(|between| {
            let four = |c: usize| Lanes::load_whole(&data[line + cols.skipped[between] + c..]) - middle;
            weighted(cols.weights[between], four)
        })
    });
    std::array::from_fn(|j| {
        let (between, r) = (j % PIXEL, rows.skipped[j % PIXEL] + j / PIXEL);
        let [whole, halves] = [0, 1].map(|of| weighted(rows.weights[between], |k| along[r + k][of]).to_array());
        std::array::from_fn(|i| if i % PIXEL == 0 { whole[i / PIXEL] } else { halves[i / PIXEL] })
    })
}

#[inline(always)]
fn weighted(weights: [f32; 4], of: impl Fn(usize) -> Lanes) -> Lanes {
    let product = |k: usize| of(k) * Lanes::splat(weights[k]);
    (product(0) + product(1)) + (product(2) + product(3))
}

/// The pixels along an axis from which the samples follow.
struct Taps {
    /// The first pixel of all.
    first: usize,
    /// For the samples a whole number of pixels from the first one and for those between: the pixels before the four of their first, and
    /// the weights of four.
    skipped: [usize; 2],
    weights: [[f32; 4]; 2],
}

impl Taps {
    fn around(centre: f64, length: usize) -> Option<Self> {
        let reach = (SIDE / 2) as f64 / FINER;
        let (start, end) = (centre - reach, centre + reach);
        if !(start >= 1.0 && end < length as f64 - 2.0) {
            return None;
        }
        let places = [start, start + 1.0 / FINER];
        let pixels = places.map(|place| place as usize);
        let weights = [0, 1].map(|k| cubic(places[k] - pixels[k] as f64).map(|weight| weight as f32));
        Some(Self { first: pixels[0] - 1, skipped: [0, pixels[1] - pixels[0]], weights })
    }
}

/// The weights of four pixels for a place `t` of the way from the second to the third: of the cubic through them (Lagrange).
fn cubic(t: f64) -> [f64; 4] {
    let (before, after, last) = (t + 1.0, t - 1.0, t - 2.0);
    [-t * after * last / 6.0, before * after * last / 2.0, -before * t * last / 2.0, before * t * after / 6.0]
}

/// The top of the quadratic that has the central differences of nine values; `None` where it has none within a sample of the middle.
fn top(v: &[[f64; 3]; 3]) -> Option<[f64; 2]> {
    let (x, y) = (0.5 * (v[1][2] - v[1][0]), 0.5 * (v[2][1] - v[0][1]));
    let (xx, yy) = (v[1][2] + v[1][0] - 2.0 * v[1][1], v[2][1] + v[0][1] - 2.0 * v[1][1]);
    let xy = 0.25 * (v[2][2] + v[0][0] - v[0][2] - v[2][0]);
    let determinant = xx * yy - xy * xy;
    let offset = [(xy * y - yy * x) / determinant, (xy * x - xx * y) / determinant];
    (xx < 0.0 && determinant > 0.0 && offset.iter().all(|d| d.abs() <= FINER)).then_some(offset)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn spot(sigma: f64, [x, y]: [f64; 2]) -> Level {
        let mut level = Level::new(32, 32);
        (0..32).for_each(|row| {
            let grey = |col: usize| {
                let (dx, dy) = (col as f64 - x, row as f64 - y);
                (100.0 * libm::exp(-(dx * dx + dy * dy) / (2.0 * sigma * sigma))) as f32
            };
            level.set_row(row, &(0..32).map(grey).collect::<Vec<_>>());
        });
        level
    }

    #[test]
    fn spots_are_found_wherever_they_lie_between_the_pixels() {
        for k in 0..25 {
            let place = [15.5 + 0.25 * f64::from(k % 5), 15.5 + 0.25 * f64::from(k / 5)];
            for sigma in [1.6, 2.2, 3.0] {
                let [x, y] = maximum(&spot(sigma, place), [16.0, 16.0]).unwrap();
                assert!((x - place[0]).abs() < 0.02 && (y - place[1]).abs() < 0.02, "{x}, {y} for {place:?}, sigma {sigma}");
            }
        }
    }

    #[test]
    fn the_border_and_what_has_no_top_are_told() {
        let level = spot(2.0, [16.0, 16.0]);
        assert_eq!(maximum(&level, [2.0, 16.0]), None);
        assert_eq!(maximum(&level, [16.0, 29.5]), None);
        assert_eq!(maximum(&Level::new(32, 32), [16.0, 16.0]), None);
        assert_eq!(maximum(&level, [f64::NAN, 16.0]), None);
    }
}
