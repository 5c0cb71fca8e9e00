//! Points of the ground below a block: even chance over an area, heights of a rolling relief.

use crate::simulate::random::Random;

/// The ground below a block, in squares, so that the points below a photo are found without looking at all.
pub(super) struct Ground {
    pub points: Vec<[f64; 3]>,
    low: [f64; 2],
    side: f64,
    shape: [usize; 2],
    /// The first point of each square, and the number of all; points stand square by square.
    starts: Vec<u32>,
}

impl Ground {
    /// `count` points in the rectangle from `low` to `high`, in m.
    pub(super) fn new(random: &mut Random, low: [f64; 2], high: [f64; 2], count: usize, relief_m: f64) -> Self {
        let span = [high[0] - low[0], high[1] - low[1]];
        let side = (span[0] * span[1] * 8.0 / count.max(1) as f64).sqrt().max(1e-3);
        let shape = span.map(|length| (length / side) as usize + 1);
        let mut points: Vec<[f64; 3]> = (0..count)
            .map(|_| {
                let [x, y] = [random.between(low[0], high[0]), random.between(low[1], high[1])];
                [x, y, height(x, y, relief_m)]
            })
            .collect();
        let square = |p: &[f64; 3]| place(p[1], low[1], side, shape[1]) * shape[0] + place(p[0], low[0], side, shape[0]);
        points.sort_by_key(square);
        let mut starts = vec![0_u32; shape[0] * shape[1] + 1];
        points.iter().for_each(|p| starts[square(p) + 1] += 1);
        for index in 1..starts.len() {
            starts[index] += starts[index - 1];
        }
        Self { points, low, side, shape, starts }
    }

    /// The points of all squares that a rectangle touches.
    pub(super) fn near(&self, low: [f64; 2], high: [f64; 2]) -> impl Iterator<Item = u32> {
        let of = |at: [f64; 2]| [0, 1].map(|axis| place(at[axis], self.low[axis], self.side, self.shape[axis]));
        let ([left, bottom], [right, top]) = (of(low), of(high));
        (bottom..=top).flat_map(move |row| self.starts[row * self.shape[0] + left]..self.starts[row * self.shape[0] + right + 1])
    }
}

fn place(at: f64, low: f64, side: f64, squares: usize) -> usize {
    (((at - low) / side).max(0.0) as usize).min(squares - 1)
}

/// Three waves of different length and direction; their sum stays within half the relief.
fn height(x: f64, y: f64, relief_m: f64) -> f64 {
    let wave = |along: f64, across: f64, length: f64| libm::sin((along * x + across * y) / length);
    relief_m * (0.25 * wave(0.8, 0.6, 210.0) + 0.15 * wave(-0.6, 0.8, 90.0) + 0.1 * wave(0.3, 0.95, 37.0))
}
