//! Gradients of a turned grid by place and direction: 4 x 4 cells of 8 directions.

use super::direction::octants;
use super::patch::{PADDED, ROW, SIDE};
use crate::math::Lanes;

/// Cells a side.
const CELLS: usize = 4;
/// Directions a cell.
const DIRECTIONS: usize = 8;
/// Numbers of a descriptor.
pub(super) const LENGTH: usize = CELLS * CELLS * DIRECTIONS;

/// Standard deviation of the Gaussian weight in sides of the grid.
const FALL: f64 = 0.35;

/// What a grid's samples have in common: their weights by place.
pub(super) struct Grid {
    /// Gaussian weight by row or column.
    fall: [f32; SIDE],
    /// For each row or column, the first of the two cells it lies between (-1 and 3: half outside), and the shares of both.
    first: [usize; SIDE],
    shares: [[f32; 2]; SIDE],
}

impl Grid {
    pub fn new() -> Self {
        let middle = (SIDE - 1) as f64 / 2.0;
        let sigma = SIDE as f64 * FALL;
        let per_cell = (SIDE / CELLS) as f64;
        // Cells are numbered from 1, so that 0 and CELLS + 1 take what lies outside.
        let place = |k: usize| (k as f64 + 0.5) / per_cell + 0.5;
        Self {
            fall: std::array::from_fn(|k| libm::exp(-(k as f64 - middle) * (k as f64 - middle) / (2.0 * sigma * sigma)) as f32),
            first: std::array::from_fn(|k| place(k) as usize),
            shares: std::array::from_fn(|k| {
                let share = (place(k) - libm::floor(place(k))) as f32;
                [1.0 - share, share]
            }),
        }
    }

    /// The sums of the gradients' magnitudes by cell and direction, interpolated in place and direction.
    pub fn histogram(&self, samples: &[[f32; ROW]; PADDED]) -> [f32; LENGTH] {
        const AROUND: usize = CELLS + 2;
        let mut sums = [[[0f32; DIRECTIONS]; AROUND]; AROUND];
        for row in 0..SIDE {
            let mut line = [[0f32; DIRECTIONS]; AROUND];
            for four in (0..SIDE).step_by(4) {
                let at = |row: usize, col: usize| Lanes::load(&samples[row][col + four..]);
                let gx = at(row + 1, 2) - at(row + 1, 0);
                let gy = at(row + 2, 1) - at(row, 1);
                let magnitude = (gx * gx + gy * gy).sqrt() * Lanes::load(&self.fall[four..]);
                let (magnitude, direction) = (magnitude.to_array(), octants(gx, gy).to_array());
                for k in 0..4 {
                    let bin = direction[k] as usize;
                    let share = direction[k] - bin as f32;
                    let (a, b) = (bin % DIRECTIONS, (bin + 1) % DIRECTIONS);
                    let (upper, lower) = (magnitude[k] * share, magnitude[k] - magnitude[k] * share);
                    let cell = self.first[four + k];
                    let [s, t] = self.shares[four + k];
                    line[cell][a] += s * lower;
                    line[cell][b] += s * upper;
                    line[cell + 1][a] += t * lower;
                    line[cell + 1][b] += t * upper;
                }
            }
            let cell = self.first[row];
            for (which, share) in self.shares[row].iter().enumerate() {
                let weight = share * self.fall[row];
                let to = sums[cell + which].as_flattened_mut();
                to.iter_mut().zip(line.as_flattened()).for_each(|(to, from)| *to += weight * from);
            }
        }
        std::array::from_fn(|k| sums[k / 32 + 1][k / 8 % 4 + 1][k % 8])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ramp_has_one_direction_in_all_cells() {
        // Grey values grow towards the direction of 3 eighths of a turn.
        let samples: [[f32; ROW]; PADDED] = std::array::from_fn(|row| std::array::from_fn(|col| 10.0 * (row as f32 - col as f32)));
        let sums = Grid::new().histogram(&samples);
        for (k, sum) in sums.iter().enumerate() {
            assert!(if k % DIRECTIONS == 3 { *sum > 1.0 } else { *sum < 1e-3 }, "{k}: {sum}");
        }
        let cell = |row: usize, col: usize| sums[(row * CELLS + col) * DIRECTIONS + 3];
        assert!(cell(1, 1) > 1.5 * cell(0, 1) && cell(0, 1) > 1.5 * cell(0, 0), "weights fall from the middle");
        assert!((cell(0, 1) - cell(3, 2)).abs() < 1e-3 * cell(0, 1) && (cell(0, 1) - cell(1, 0)).abs() < 1e-3 * cell(0, 1));
    }

    #[test]
    fn between_two_directions_both_have_their_share() {
        // The direction of a quarter of an eighth after that of x.
        let slope = libm::tan(0.25 * std::f64::consts::PI / 4.0) as f32;
        let samples: [[f32; ROW]; PADDED] = std::array::from_fn(|row| std::array::from_fn(|col| 10.0 * (col as f32 + slope * row as f32)));
        let sums = Grid::new().histogram(&samples);
        assert!((sums[0] / (sums[0] + sums[1]) - 0.75).abs() < 1e-3, "{} {}", sums[0], sums[1]);
    }
}
