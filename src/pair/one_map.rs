//! Whether two images differ by a similarity alone, as far as their matches tell.
//!
//! Such images differ from it by the errors of matching, which are independent. What a second photograph moves, its relief, its tilts and its lens, it
//! moves for neighbours together, however little that is: then a cubic map fits the matches better than errors allow, and neighbours have similar
//! residuals. The sizes of residuals do not tell.

use crate::math::median;
use nalgebra::{SMatrix, SVector};

/// Fewer matches do not tell.
const LEAST_MATCHES: usize = 100;
/// Matches of one cell of this side may see the same pixels, and have their errors in common: one of them counts. Residuals of true copies, matched by
/// gradients or by windows no wider than this, have the distribution of independent ones then; of all matches their ratio of variances is half as large
/// again. Those of wider windows correlate farther, and copies may pass as photographs. In px of the coarser image.
const CELL_PX: f64 = 12.0;
/// Cells with matches that tell: the cubic map has ten terms.
const LEAST_CELLS: usize = 60;
/// Matches whose neighbours are looked for.
const PROBES: usize = 1000;
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

/// Terms of a cubic map of a coordinate, and those that an affine one has of them.
const CUBIC: usize = 10;
const AFFINE: usize = 3;

/// What speaks for another map than the similarity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Evidence {
    /// What the cubic map explains beside the affine one, by what it leaves, each by its degrees of freedom: F of 14 and many degrees of freedom where
    /// errors are independent.
    pub variance_ratio: f64,
    /// Correlation of the residuals of neighbours.
    pub correlation: f64,
}

/// The map by which images differ that a similarity takes to each other.
#[derive(Debug, Clone)]
pub(super) struct OneMap {
    /// By how much positions of either image are reduced to px of the coarser one, in which the map is.
    reductions: [f64; 2],
    map: Map,
    /// The matches that it fits, in px of the coarser image.
    matches: Vec<[f64; 4]>,
    pub evidence: Evidence,
}

impl OneMap {
    /// Of matches `[x left, y left, x right, y right]`, px; `None` where they ask for more than a similarity by the sizes of their residuals, or are too
    /// few to tell.
    pub(super) fn of(matches: &[[f64; 4]]) -> Option<Self> {
        if matches.len() < LEAST_MATCHES {
            return None;
        }
        let scale = Map::fitted(matches)?.scale();
        let reductions = [scale.min(1.0), 1.0 / scale.max(1.0)];
        let all: Vec<[f64; 4]> = matches.iter().map(|m| std::array::from_fn(|k| m[k] * reductions[k / 2])).collect();
        let (mut near, mut map, mut most_px) = (all.clone(), Map::fitted(&all)?, 0.0);
        for _ in 0..ROUNDS {
            let middle = median(&mut all.iter().map(|m| length(map.residual_px(m))).collect::<Vec<_>>())?;
            most_px = (MOST_MEDIANS * middle).max(LEAST_OFF_PX);
            near = all.iter().filter(|m| length(map.residual_px(m)) <= most_px).copied().collect();
            map = Map::fitted(&near)?;
        }
        let is_small = most_px <= MOST_MEDIANS * MOST_MEDIAN_PX
            && near.len() as f64 >= SHARE * all.len() as f64
            && map.stretch_px(&near) <= MOST_STRETCH_PX;
        let evidence = if is_small { Evidence::of(&near)? } else { return None };
        Some(Self { reductions, map, matches: near, evidence })
    }

    /// The sides of an image (0 left, 1 right) in px of the coarser one.
    pub(super) fn reduced(&self, side: usize, size: (usize, usize)) -> [f64; 2] {
        [size.0 as f64 * self.reductions[side], size.1 as f64 * self.reductions[side]]
    }

    /// How many px of the right image one of the left image has.
    pub(super) fn scale(&self) -> f64 {
        self.map.scale() * self.reductions[0] / self.reductions[1]
    }

    /// Where a position of the left image (side 0) lies in the right one, or one of the right image (side 1) in the left one, in px of the coarser image.
    pub(super) fn place(&self, side: usize, at: [f64; 2]) -> [f64; 2] {
        if side == 0 { self.map.place(at) } else { self.map.source(at) }
    }

    /// Positions of the matches in an image, in px of the coarser one.
    pub(super) fn positions(&self, side: usize) -> impl Iterator<Item = [f64; 2]> + '_ {
        self.matches.iter().map(move |m| [m[2 * side], m[2 * side + 1]])
    }
}

impl Evidence {
    /// Of matches that an affine map fits, in px of the coarser image; `None` where too few are apart.
    fn of(matches: &[[f64; 4]]) -> Option<Self> {
        let apart = one_a_cell(matches);
        let map = Map::fitted(&apart).filter(|_| apart.len() >= LEAST_CELLS)?;
        let residuals: Vec<[f64; 2]> = apart.iter().map(|m| map.residual_px(m)).collect();
        Some(Self { variance_ratio: variance_ratio(&apart, &residuals)?, correlation: correlation(&apart, &residuals)? })
    }
}

/// The similarity nearest to matches `[x left, y left, x right, y right]`, as a complex number; `None` where they lie on a line.
pub(super) fn similarity_of(matches: &[[f64; 4]]) -> Option<[f64; 2]> {
    Map::fitted(matches).map(|map| map.similarity)
}

/// The first match of each cell, in the order of the matches.
fn one_a_cell(matches: &[[f64; 4]]) -> Vec<[f64; 4]> {
    let cell = |v: f64| libm::floor(v / CELL_PX) as i64;
    let mut taken = std::collections::BTreeSet::new();
    matches.iter().filter(|m| taken.insert([cell(m[0]), cell(m[1])])).copied().collect()
}

/// By the residuals of the affine map: the cubic one is of these residuals.
fn variance_ratio(matches: &[[f64; 4]], residuals: &[[f64; 2]]) -> Option<f64> {
    let count = matches.len() as f64;
    let mean = |k: usize| matches.iter().map(|m| m[k]).sum::<f64>() / count;
    let middle = [mean(0), mean(1)];
    let sum = |j: usize, k: usize| matches.iter().map(|m| (m[j] - middle[j]) * (m[k] - middle[k])).sum::<f64>();
    // Uncorrelated coordinates of unit variance: the terms are well apart on strips of any direction, too.
    let slope = sum(0, 1) / sum(0, 0);
    let unit = |m: &[f64; 4]| {
        let x = m[0] - middle[0];
        [x, m[1] - middle[1] - slope * x]
    };
    let sigma = [0, 1].map(|k| libm::sqrt(matches.iter().map(|m| unit(m)[k] * unit(m)[k]).sum::<f64>() / count));
    let mut normal = SMatrix::<f64, CUBIC, CUBIC>::zeros();
    let mut sides = SMatrix::<f64, CUBIC, 2>::zeros();
    for (m, residual) in matches.iter().zip(residuals) {
        let [u, v] = unit(m);
        let terms = cubic_terms(u / sigma[0], v / sigma[1]);
        normal += terms * terms.transpose();
        sides += terms * SMatrix::<f64, 1, 2>::from(*residual);
    }
    let explained = normal.cholesky()?.solve(&sides).dot(&sides);
    let all = residuals.iter().map(|[x, y]| x * x + y * y + FINEST_PX * FINEST_PX).sum::<f64>();
    let freedom = 2.0 * (count - CUBIC as f64);
    Some(explained / (2 * (CUBIC - AFFINE)) as f64 / ((all - explained).max(0.0) / freedom))
}

fn cubic_terms(u: f64, v: f64) -> SVector<f64, CUBIC> {
    SVector::from([1.0, u, v, u * u, u * v, v * v, u * u * u, u * u * v, u * v * v, v * v * v])
}

/// `None` where no match has a neighbour.
fn correlation(matches: &[[f64; 4]], residuals: &[[f64; 2]]) -> Option<f64> {
    let square = |a: &[f64; 4], b: &[f64; 4]| (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);
    let neighbour = |m: &[f64; 4]| {
        let apart = matches.iter().zip(residuals).map(|(other, residual)| (square(m, other), residual));
        let apart = apart.filter(|(distance, _)| *distance >= CELL_PX * CELL_PX);
        apart.min_by(|(one, _), (other, _)| one.total_cmp(other)).map(|(_, residual)| *residual)
    };
    let (mut products, mut squares) = (0.0, 0.0);
    for (m, [x, y]) in matches.iter().zip(residuals).step_by(matches.len().div_ceil(PROBES)) {
        let [u, v] = neighbour(m)?;
        products += x * u + y * v;
        squares += x * x + y * y + FINEST_PX * FINEST_PX;
    }
    Some(products / squares)
}

/// Where positions of the left image lie in the right one: an affine map, which is a similarity but for a stretch.
#[derive(Debug, Clone, Copy)]
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
    fn fitted(matches: &[[f64; 4]]) -> Option<Self> {
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
        let map = Self { middles, matrix: [row(2), row(3)], similarity };
        (determinant > 0.0 && map.scale() > 0.0).then_some(map)
    }

    fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [[x0, y0], [u0, v0]] = self.middles;
        let [[a, b], [c, d]] = self.matrix;
        [u0 + a * (x - x0) + b * (y - y0), v0 + c * (x - x0) + d * (y - y0)]
    }

    /// Where a position of the right image lies in the left one, by the similarity.
    fn source(&self, [u, v]: [f64; 2]) -> [f64; 2] {
        let ([[x0, y0], [u0, v0]], [e, f]) = (self.middles, self.similarity);
        let (u, v, square) = (u - u0, v - v0, e * e + f * f);
        [x0 + (e * u + f * v) / square, y0 + (e * v - f * u) / square]
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
    fn stretch_px(&self, matches: &[[f64; 4]]) -> f64 {
        let ([[x0, y0], _], [[a, b], [c, d]], [e, f]) = (self.middles, self.matrix, self.similarity);
        let square = |m: &[f64; 4]| {
            let [x, y] = [m[0] - x0, m[1] - y0];
            let [u, v] = [(a - e) * x + (b + f) * y, (c - f) * x + (d - e) * y];
            u * u + v * v
        };
        (matches.iter().map(square).sum::<f64>() / matches.len() as f64).sqrt()
    }
}

pub(super) fn length([x, y]: [f64; 2]) -> f64 {
    libm::hypot(x, y)
}
