//! Cholesky factor of a sparse matrix, column by column, and solutions by it.

use super::block::{N, cholesky, divide_by_transposed, subtract_product};
use super::pattern::{Pattern, SparseMatrix};

/// L of a matrix L Lᵀ.
pub(in crate::adjustment) struct Factor(pub(super) SparseMatrix);

/// Where the factorisation found nothing left but rounding: the node, and which of its six unknowns.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::adjustment) struct Refused {
    pub node: usize,
    pub unknown: usize,
}

/// Below this share of its own diagonal, a pivot is rounding.
const LEAST_SHARE: f64 = 1e-13;

const NONE: u32 = u32::MAX;

impl Factor {
    /// Factors a matrix, in place. A pivot counts by the diagonal `scale` (per place) that the matrix had before points were eliminated.
    ///
    /// # Source
    /// George & Liu 1981, Computer Solution of Large Sparse Positive Definite Systems, 5.4 (left-looking, columns linked by their next row).
    pub fn new(pattern: &Pattern, mut matrix: SparseMatrix, scale: &[[f64; N]]) -> Result<Self, Refused> {
        let size = pattern.size();
        // For each row the columns that reach it next, linked; and how far each column has come.
        let (mut head, mut next) = (vec![NONE; size], vec![NONE; size]);
        let mut reached = pattern.start[..size].to_vec();
        let mut slot = vec![NONE; size];
        for column in 0..size {
            let own = pattern.start[column]..pattern.start[column + 1];
            own.clone().for_each(|at| slot[pattern.rows[at] as usize] = at as u32);
            let mut earlier = head[column];
            while earlier != NONE {
                let (k, following) = (earlier as usize, next[earlier as usize]);
                let (at, end) = (reached[k], pattern.start[k + 1]);
                let factor = matrix.below[at];
                subtract_product(&mut matrix.diagonal[column], &factor, &factor);
                for from in at + 1..end {
                    let target = slot[pattern.rows[from] as usize] as usize;
                    // The target's column comes after that of the source, so that its blocks lie behind.
                    let (sources, targets) = matrix.below.split_at_mut(own.start);
                    subtract_product(&mut targets[target - own.start], &sources[from], &factor);
                }
                reached[k] += 1;
                link(pattern, k, &reached, &mut head, &mut next);
                earlier = following;
            }
            let refused = |unknown| Refused { node: pattern.node[column] as usize, unknown };
            cholesky(&mut matrix.diagonal[column], &scale[column], LEAST_SHARE).map_err(refused)?;
            for at in own.clone() {
                divide_by_transposed(&mut matrix.below[at], &matrix.diagonal[column]);
            }
            link(pattern, column, &reached, &mut head, &mut next);
        }
        Ok(Self(matrix))
    }

    /// x becomes L⁻¹ x; six numbers for each place.
    pub fn forward(&self, pattern: &Pattern, x: &mut [f64]) {
        for column in 0..pattern.size() {
            let l = &self.0.diagonal[column];
            let mut own: [f64; N] = std::array::from_fn(|r| x[column * N + r]);
            for k in 0..N {
                own[k] /= l[k * N + k];
                for r in k + 1..N {
                    own[r] -= l[k * N + r] * own[k];
                }
            }
            x[column * N..][..N].copy_from_slice(&own);
            for at in pattern.start[column]..pattern.start[column + 1] {
                let block = &self.0.below[at];
                let target = &mut x[pattern.rows[at] as usize * N..][..N];
                for k in 0..N {
                    for r in 0..N {
                        target[r] -= block[k * N + r] * own[k];
                    }
                }
            }
        }
    }

    /// x becomes L⁻ᵀ x.
    pub fn backward(&self, pattern: &Pattern, x: &mut [f64]) {
        for column in (0..pattern.size()).rev() {
            let mut own: [f64; N] = std::array::from_fn(|r| x[column * N + r]);
            for at in pattern.start[column]..pattern.start[column + 1] {
                let block = &self.0.below[at];
                let source = &x[pattern.rows[at] as usize * N..][..N];
                for k in 0..N {
                    for r in 0..N {
                        own[k] -= block[k * N + r] * source[r];
                    }
                }
            }
            let l = &self.0.diagonal[column];
            for k in (0..N).rev() {
                for r in k + 1..N {
                    own[k] -= l[k * N + r] * own[r];
                }
                own[k] /= l[k * N + k];
            }
            x[column * N..][..N].copy_from_slice(&own);
        }
    }
}

/// Links a column to the row that it has reached, where there is one left.
fn link(pattern: &Pattern, column: usize, reached: &[usize], head: &mut [u32], next: &mut [u32]) {
    if reached[column] < pattern.start[column + 1] {
        let row = pattern.rows[reached[column]] as usize;
        next[column] = head[row];
        head[row] = column as u32;
    }
}
