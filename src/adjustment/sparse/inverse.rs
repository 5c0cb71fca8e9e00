//! The inverse of a sparse matrix at the places of its factor.

use super::block::{Block6, N, divide_by, inverse_of_factor, subtract_plain_product, transposed};
use super::cholesky::Factor;
use super::pattern::{Pattern, SparseMatrix};

/// Blocks of the inverse where the factor has blocks: all that couple two images with a common point are among them.
pub(in crate::adjustment) struct Inverse(pub SparseMatrix);

/// Computes the inverse at the places of the factor, from the last column to the first.
///
/// # Source
/// Takahashi, Fagan & Chin 1973, Formation of a sparse bus impedance matrix and its application to short circuit study.
pub(in crate::adjustment) fn inverse(pattern: &Pattern, factor: &Factor) -> Inverse {
    let Factor(l) = factor;
    let mut z = SparseMatrix::zeros(pattern);
    let mut slot = vec![usize::MAX; pattern.size()];
    let (mut shares, mut sums): (Vec<Block6>, Vec<Block6>) = (Vec::new(), Vec::new());
    for column in (0..pattern.size()).rev() {
        let own = pattern.start[column]..pattern.start[column + 1];
        let rows = &pattern.rows[own.clone()];
        rows.iter().enumerate().for_each(|(k, row)| slot[*row as usize] = k);
        // Y = L_Rj L_jj⁻¹ and Z_Rj = -Z_RR Y.
        shares.clear();
        shares.extend(own.clone().map(|at| {
            let mut share = l.below[at];
            divide_by(&mut share, &l.diagonal[column]);
            share
        }));
        sums.clear();
        sums.resize(rows.len(), [0.0; N * N]);
        for (k, &row) in rows.iter().enumerate() {
            let row = row as usize;
            subtract_plain_product(&mut sums[k], &z.diagonal[row], &shares[k]);
            for at in pattern.start[row]..pattern.start[row + 1] {
                let i = slot[pattern.rows[at] as usize];
                if i != usize::MAX {
                    subtract_plain_product(&mut sums[i], &z.below[at], &shares[k]);
                    subtract_plain_product(&mut sums[k], &transposed(&z.below[at]), &shares[i]);
                }
            }
        }
        let mut diagonal = inverse_of_factor(&l.diagonal[column]);
        for (share, sum) in shares.iter().zip(&sums) {
            subtract_plain_product(&mut diagonal, &transposed(share), sum);
        }
        // Rounding is kept out of what is symmetric.
        let turned = transposed(&diagonal);
        diagonal.iter_mut().zip(turned).for_each(|(a, b)| *a = 0.5 * (*a + b));
        z.diagonal[column] = diagonal;
        z.below[own].copy_from_slice(&sums);
        rows.iter().for_each(|row| slot[*row as usize] = usize::MAX);
    }
    Inverse(z)
}

impl Inverse {
    /// The block of two nodes, its rows those of the first. `None` where the factor has none there.
    pub fn block(&self, pattern: &Pattern, first: usize, second: usize) -> Option<Block6> {
        let (row, column) = (pattern.place[first] as usize, pattern.place[second] as usize);
        match row.cmp(&column) {
            std::cmp::Ordering::Equal => Some(self.0.diagonal[row]),
            std::cmp::Ordering::Greater => pattern.find(row, column).map(|at| self.0.below[at]),
            std::cmp::Ordering::Less => pattern.find(column, row).map(|at| transposed(&self.0.below[at])),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::adjustment::sparse::{DenseFactor, Refused};

    /// Blocks on a ring with two chords, made positive definite by their diagonal.
    fn example() -> (Pattern, Vec<f64>, SparseMatrix) {
        let nodes = 9;
        let pairs: Vec<(usize, usize)> = (0..nodes).map(|k| (k, (k + 1) % nodes)).chain([(0, 4), (2, 7)]).collect();
        let mut neighbours = vec![Vec::new(); nodes];
        for &(a, b) in &pairs {
            neighbours[a].push(b as u32);
            neighbours[b].push(a as u32);
        }
        neighbours.iter_mut().for_each(|list| list.sort_unstable());
        let pattern = Pattern::of(neighbours, &[[0.0; 3]; 9]);
        let mut dense = vec![0.0; nodes * N * nodes * N];
        let mut matrix = SparseMatrix::zeros(&pattern);
        let side = nodes * N;
        let mut put = |a: usize, b: usize, block: Block6| {
            let (a, b) = (pattern.place[a] as usize, pattern.place[b] as usize);
            let (row, column, block) = if a >= b { (a, b, block) } else { (b, a, transposed(&block)) };
            if row == column {
                matrix.diagonal[row] = block
            } else {
                matrix.below[pattern.find(row, column).unwrap()] = block
            }
            for c in 0..N {
                for r in 0..N {
                    dense[(row * N + r) * side + column * N + c] = block[c * N + r];
                    dense[(column * N + c) * side + row * N + r] = block[c * N + r];
                }
            }
        };
        for (k, &(a, b)) in pairs.iter().enumerate() {
            put(a, b, std::array::from_fn(|i| ((i * i + 7 * k + 3 * i * k) as f64 * 0.37).sin()));
        }
        for node in 0..nodes {
            put(node, node, std::array::from_fn(|i| if i % N == i / N { 12.0 + node as f64 } else { 0.3 }));
        }
        (pattern, dense, matrix)
    }

    #[test]
    fn solutions_and_inverse_are_those_of_the_dense_matrix() {
        let (pattern, dense, matrix) = example();
        let side = pattern.size() * N;
        let scale: Vec<[f64; N]> = matrix.diagonal.iter().map(|d| std::array::from_fn(|k| d[k * N + k])).collect();
        let factor = Factor::new(&pattern, matrix, &scale).unwrap();
        let wanted = DenseFactor::new(dense, side, &vec![1.0; side]).unwrap();
        let right: Vec<f64> = (0..side).map(|k| (k as f64 * 0.7).cos()).collect();
        let (mut x, mut y) = (right.clone(), right);
        factor.forward(&pattern, &mut x);
        factor.backward(&pattern, &mut x);
        wanted.forward(&mut y);
        wanted.backward(&mut y);
        assert!(x.iter().zip(&y).all(|(a, b)| (a - b).abs() < 1e-13));
        let all = wanted.inverse();
        let Inverse(z) = inverse(&pattern, &factor);
        let close = |block: &Block6, row: usize, column: usize| {
            (0..N * N).all(|k| (block[k] - all[(row * N + k % N) * side + column * N + k / N]).abs() < 1e-13)
        };
        for column in 0..pattern.size() {
            assert!(close(&z.diagonal[column], column, column));
            for at in pattern.start[column]..pattern.start[column + 1] {
                assert!(close(&z.below[at], pattern.rows[at] as usize, column));
            }
        }
    }

    #[test]
    fn a_singular_matrix_is_refused_by_its_node() {
        let (pattern, _, mut matrix) = example();
        let scale = vec![[1.0; N]; pattern.size()];
        let place = pattern.place[3] as usize;
        (0..N).for_each(|k| {
            matrix.diagonal[place][4 * N + k] = 0.0;
            matrix.diagonal[place][k * N + 4] = 0.0;
        });
        let refused = Factor::new(&pattern, matrix, &scale).err().unwrap();
        assert_eq!(refused, Refused { node: 3, unknown: 4 });
    }
}
