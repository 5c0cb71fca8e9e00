//! Images that differ by a shift, a turn and a scale alone: one photograph twice, or parts of one image.
//!
//! Such images differ from a similarity by the errors of matching, and these are independent. What a second photograph moves, its relief, its
//! tilts and its lens, it moves for neighbours together, however little that is: so the residuals of neighbours tell, not their size.

use super::no_orientation::NoOrientation;
use crate::math::median;

/// Correlation of the residuals of neighbours. Copies of photographs, compressed, resized, turned and cropped, had up to 0.03; whole pairs of real ones
/// had 0.95 and more, but for scans of flat ground with 0.24. Where a small part is common to both, real ones have less, too.
const MOST_CORRELATION: f64 = 0.2;
/// Fewer matches do not tell that correlation.
const LEAST_MATCHES: usize = 100;
/// Matches whose neighbours are looked for.
const PROBES: usize = 1000;
/// Nearer ones may see the same pixels, and have their errors in common, px.
const NEAREST_PX: f64 = 12.0;
/// Positions are not measured finer: what is below is how they were rounded, px.
const FINEST_PX: f64 = 0.02;
/// Median of the residuals of a copy, in px of the coarser image: up to 0.3 after the strongest compression.
const MOST_MEDIAN_PX: f64 = 0.6;
/// Matches that are this many medians off, and this many px, are wrong: at most a tenth.
const MOST_MEDIANS: f64 = 4.0;
const LEAST_OFF_PX: f64 = 0.2;
const SHARE: f64 = 0.9;
/// Rounds in which they leave the fit.
const ROUNDS: usize = 5;
/// Sides of a resized image are whole px: that stretches it by some tenths of a px, root mean square of the matches.
const MOST_STRETCH_PX: f64 = 0.5;
/// How far the frames of one photograph, saved again in another size or turned, lie apart, as a share of the diagonal.
const SAME_FRAME: f64 = 0.01;

/// What two images are of one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OneImage {
    /// One photo twice.
    Twice,
    Parts,
}

impl OneImage {
    /// What images of these sizes are of one by their matches `[x left, y left, x right, y right]`, px; `None` where these ask for more than a
    /// similarity, or are too few to tell.
    pub fn of(matches: &[[f64; 4]], sizes: [(usize, usize); 2]) -> Option<Self> {
        if matches.len() < LEAST_MATCHES {
            return None;
        }
        let [left, right] = sizes.map(|(width, height)| [width as f64, height as f64]);
        let mut near: Vec<&[f64; 4]> = matches.iter().collect();
        let (mut map, mut most_px) = (Map::fitted(&near)?, 0.0);
        for _ in 0..ROUNDS {
            let middle = median(&mut matches.iter().map(|m| length(map.residual_px(m))).collect::<Vec<_>>())?;
            most_px = (MOST_MEDIANS * middle).max(LEAST_OFF_PX);
            near = matches.iter().filter(|m| length(map.residual_px(m)) <= most_px).collect();
            map = Map::fitted(&near)?;
        }
        let is_one = most_px <= MOST_MEDIANS * MOST_MEDIAN_PX * map.scale().max(1.0)
            && near.len() as f64 >= SHARE * matches.len() as f64
            && map.stretch_px(&near) <= MOST_STRETCH_PX
            && correlation(&map, &near)? <= MOST_CORRELATION;
        is_one.then(|| if map.is_of_frames(left, right) { Self::Twice } else { Self::Parts })
    }

    /// Why there is no orientation.
    pub fn reason(self) -> NoOrientation {
        match self {
            Self::Twice => NoOrientation::OnePhoto,
            Self::Parts => NoOrientation::PartsOfOneImage,
        }
    }
}

/// Where positions of the left image lie in the right one: an affine map, which is a similarity but for a stretch.
struct Map {
    /// Of the matches in the left image and in the right one, px.
    middles: [[f64; 2]; 2],
    /// By row.
    matrix: [[f64; 2]; 2],
    /// The similarity nearest to it at the matches, as a complex number.
    similarity: [f64; 2],
}

impl Map {
    /// By least squares; `None` where the matches lie on a line.
    fn fitted(matches: &[&[f64; 4]]) -> Option<Self> {
        let mean = [0, 1, 2, 3].map(|k| matches.iter().map(|m| m[k]).sum::<f64>() / matches.len() as f64);
        let sum = |j: usize, k: usize| matches.iter().map(|m| (m[j] - mean[j]) * (m[k] - mean[k])).sum::<f64>();
        let [xx, xy, yy] = [sum(0, 0), sum(0, 1), sum(1, 1)];
        let determinant = xx * yy - xy * xy;
        let row = |k: usize| {
            let [x, y] = [sum(0, k), sum(1, k)];
            [(yy * x - xy * y) / determinant, (xx * y - xy * x) / determinant]
        };
        let similarity = [(sum(0, 2) + sum(1, 3)) / (xx + yy), (sum(0, 3) - sum(1, 2)) / (xx + yy)];
        let middles = [[mean[0], mean[1]], [mean[2], mean[3]]];
        (determinant > 0.0).then(|| Self { middles, matrix: [row(2), row(3)], similarity })
    }

    fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [[x0, y0], [u0, v0]] = self.middles;
        let [[a, b], [c, d]] = self.matrix;
        [u0 + a * (x - x0) + b * (y - y0), v0 + c * (x - x0) + d * (y - y0)]
    }

    /// From where the left position lies to the right one.
    fn residual_px(&self, [x, y, u, v]: &[f64; 4]) -> [f64; 2] {
        let [place_u, place_v] = self.place([*x, *y]);
        [u - place_u, v - place_v]
    }

    fn scale(&self) -> f64 {
        length(self.similarity)
    }

    /// Root mean square of how far it takes matches from where the similarity takes them.
    fn stretch_px(&self, matches: &[&[f64; 4]]) -> f64 {
        let ([[x0, y0], _], [[a, b], [c, d]], [e, f]) = (self.middles, self.matrix, self.similarity);
        let square = |m: &&[f64; 4]| {
            let [x, y] = [m[0] - x0, m[1] - y0];
            let [u, v] = [(a - e) * x + (b + f) * y, (c - f) * x + (d - e) * y];
            u * u + v * v
        };
        (matches.iter().map(square).sum::<f64>() / matches.len() as f64).sqrt()
    }

    /// Whether it takes the frame of the left image to that of the right one.
    fn is_of_frames(&self, left: [f64; 2], right: [f64; 2]) -> bool {
        let [x, y] = self.place(left.map(|side| 0.5 * side));
        let off = libm::hypot(x - 0.5 * right[0], y - 0.5 * right[1]) / length(right);
        off <= SAME_FRAME && (self.scale() * length(left) / length(right) - 1.0).abs() <= SAME_FRAME
    }
}

fn length([x, y]: [f64; 2]) -> f64 {
    libm::hypot(x, y)
}

/// Correlation of the residuals of neighbours; `None` where no match has one.
fn correlation(map: &Map, matches: &[&[f64; 4]]) -> Option<f64> {
    let square = |a: &[f64; 4], b: &[f64; 4]| (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);
    let neighbour = |m: &[f64; 4]| {
        let apart = matches.iter().map(|other| (square(m, other), other)).filter(|(distance, _)| *distance >= NEAREST_PX * NEAREST_PX);
        apart.min_by(|(one, _), (other, _)| one.total_cmp(other)).map(|(_, other)| map.residual_px(other))
    };
    let (mut products, mut squares) = (0.0, 0.0);
    for m in matches.iter().step_by(matches.len().div_ceil(PROBES)) {
        let ([x, y], [u, v]) = (map.residual_px(m), neighbour(m)?);
        products += x * u + y * v;
        squares += x * x + y * y + FINEST_PX * FINEST_PX;
    }
    Some(products / squares)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Random;

    const SIZE: (usize, usize) = (1600, 1200);

    /// Matches of points all over an image, which lie at `map` of them in the other one but for errors of this many px.
    fn matches(noise_px: f64, map: impl Fn([f64; 2]) -> [f64; 2]) -> Vec<[f64; 4]> {
        let mut random = Random::new(7);
        let mut uniform = |most: f64| most * random.below(100_000) as f64 * 1e-5;
        (0..400)
            .map(|_| {
                let at = [uniform(1600.0), uniform(1200.0)];
                let [x, y] = map(at).map(|v| v + uniform(2.0 * noise_px) - noise_px);
                [at[0], at[1], x, y]
            })
            .collect()
    }

    #[test]
    fn one_photo_is_found_in_another_size_and_turned() {
        let exact = matches(0.0, |at| at);
        let saved_again = matches(0.5, |at| at);
        // Its sides are 801 x 600 px.
        let half = matches(0.1, |[x, y]| [801.0 / 1600.0 * x, 0.5 * y]);
        let quarter_turn = matches(0.1, |[x, y]| [1200.0 - y, x]);
        for (right, size) in [(exact, SIZE), (saved_again, SIZE), (half, (801, 600)), (quarter_turn, (1200, 1600))] {
            assert_eq!(OneImage::of(&right, [SIZE, size]), Some(OneImage::Twice), "{size:?}");
        }
    }

    #[test]
    fn parts_are_told_from_photographs() {
        let shifted = matches(0.2, |[x, y]| [x - 500.0, y + 1.0]);
        assert_eq!(OneImage::of(&shifted, [SIZE; 2]), Some(OneImage::Parts));
        // Halves of one scan have a strip in common.
        let strip: Vec<[f64; 4]> = matches(0.5, |[x, y]| [x - 1500.0, y])
            .into_iter()
            .map(|[x, y, u, v]| [1500.0 + x / 20.0, y, u + 1500.0 - 19.0 * x / 20.0, v])
            .take(200)
            .collect();
        assert_eq!(OneImage::of(&strip, [SIZE; 2]), Some(OneImage::Parts));
        // Some matches are wrong.
        let mut some_wrong = shifted.clone();
        some_wrong.iter_mut().take(20).for_each(|m| m[2] += 40.0);
        assert_eq!(OneImage::of(&some_wrong, [SIZE; 2]), Some(OneImage::Parts));
        // Relief, a tilt or the lens of another photo move neighbours together, by less than a pixel too.
        let relief = matches(0.2, |[x, y]| [x - 500.0 + 0.4 * libm::sin(0.01 * y), y]);
        let tilted = matches(0.2, |[x, y]| [x, y].map(|v| v / (1.0 + 2e-6 * x)));
        let lens = matches(0.2, |[x, y]| [x - 500.0 + 0.4 * libm::sin(0.005 * x), y]);
        for photographs in [relief, tilted, lens, shifted[..30].to_vec()] {
            assert_eq!(OneImage::of(&photographs, [SIZE; 2]), None);
        }
    }
}
