//! Gradients of a turned grid by place and direction: 4 x 4 cells of 8 directions.
//!
//! A gradient is the sum of two vectors along the directions between which it lies, and their lengths are what is summed. Interpolating its
//! magnitude by angle instead differs by less than a twelfth, and takes a root, a quotient and an arctangent.

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
    /// For each row or column its shares in the two cells it lies between, times the Gaussian weight.
    shares: [[f32; 2]; SIDE],
}

/// Four numbers for each direction.
type Directions = [Lanes; DIRECTIONS];

/// Samples from the middle of a cell to that of the next.
const PER_CELL: usize = SIDE / CELLS;

impl Grid {
    pub fn new() -> Self {
        let middle = (SIDE - 1) as f64 / 2.0;
        let sigma = SIDE as f64 * FALL;
        let shares = |k: usize| {
            let fall = libm::exp(-(k as f64 - middle) * (k as f64 - middle) / (2.0 * sigma * sigma));
            let place = (k as f64 + 0.5) / PER_CELL as f64 + 0.5;
            let share = place - libm::floor(place);
            [(fall * (1.0 - share)) as f32, (fall * share) as f32]
        };
        Self { shares: std::array::from_fn(shares) }
    }

    /// The sums of the gradients' components by cell and direction, interpolated in place.
    pub fn histogram(&self, samples: &[[f32; ROW]; PADDED]) -> [f32; LENGTH] {
        // By row and column of cells, of which the first and the last take what lies outside; four directions each.
        let mut sums = [[[Lanes::splat(0.0); 2]; CELLS + 2]; CELLS];
        for block in 0..CELLS {
            let first = block * PER_CELL;
            let columns = self.columns(samples, first);
            for (sums, directions) in sums.iter_mut().zip(&columns) {
                for half in 0..2 {
                    let four = Lanes::transpose(std::array::from_fn(|k| directions[4 * half + k]));
                    for (k, column) in four.into_iter().enumerate() {
                        let cell = cell_before(first + k);
                        for (side, share) in self.shares[first + k].iter().enumerate() {
                            sums[cell + side][half] = sums[cell + side][half] + column * Lanes::splat(*share);
                        }
                    }
                }
            }
        }
        let mut histogram = [0.0; LENGTH];
        let inner = sums.iter().flat_map(|row| &row[1..=CELLS]).flatten();
        histogram.chunks_exact_mut(4).zip(inner).for_each(|(to, four)| four.store(to));
        histogram
    }

    /// Of four columns of samples the sums over the rows of each cell.
    #[inline(always)]
    fn columns(&self, samples: &[[f32; ROW]; PADDED], first: usize) -> [Directions; CELLS] {
        let mut cells = [[Lanes::splat(0.0); DIRECTIONS]; CELLS + 2];
        for (row, shares) in self.shares.iter().enumerate() {
            let at = |row: usize, col: usize| Lanes::load(&samples[row][first + col..]);
            let components = components(at(row + 1, 2) - at(row + 1, 0), at(row + 2, 1) - at(row, 1));
            let cell = cell_before(row);
            for (side, share) in shares.iter().enumerate() {
                let share = Lanes::splat(*share);
                cells[cell + side].iter_mut().zip(components).for_each(|(sum, component)| *sum = *sum + component * share);
            }
        }
        std::array::from_fn(|cell| cells[cell + 1])
    }
}

/// The first of the two cells a row or column lies between; cells are numbered from 1, so that 0 and CELLS + 1 take what lies outside.
#[inline(always)]
fn cell_before(k: usize) -> usize {
    (k + PER_CELL / 2) / PER_CELL
}

/// Gradients as sums of vectors along the two of 8 directions between which they lie: the lengths of these.
#[inline(always)]
fn components(gx: Lanes, gy: Lanes) -> Directions {
    let zero = Lanes::splat(0.0);
    let root = Lanes::splat(std::f32::consts::SQRT_2);
    let (left, up) = (zero - gx, zero - gy);
    let (across, along) = (gx.abs(), gy.abs());
    let [right_by, down_by, left_by, up_by] = [gx, gy, left, up].map(|g| g * root);
    [
        gx - along,
        right_by.min(down_by),
        gy - across,
        left_by.min(down_by),
        left - along,
        left_by.min(up_by),
        up - across,
        right_by.min(up_by),
    ]
    .map(|component| component.max(zero))
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
        let (along, diagonal) = (1.0 - slope, std::f32::consts::SQRT_2 * slope);
        assert!((sums[0] / (sums[0] + sums[1]) - along / (along + diagonal)).abs() < 1e-3, "{} {}", sums[0], sums[1]);
    }
}
