//! Where a sparse matrix and its factor have blocks.

use super::block::{Block6, N};
use super::dissection::turns;
use super::ordering::minimum_degree;

/// The blocks of a factor: for each column, in the order of elimination, the rows below the diagonal.
pub(in crate::adjustment) struct Pattern {
    /// The place in the order of elimination of each node.
    pub place: Vec<u32>,
    /// The node at each place.
    pub node: Vec<u32>,
    /// Where each column begins in `rows`, and where the last one ends.
    pub start: Vec<usize>,
    /// Places, ascending in each column.
    pub rows: Vec<u32>,
    /// Couplings that it was made for.
    couplings: usize,
}

/// A pattern that has this share of couplings too many is still worth keeping.
const SPARE: f64 = 0.02;
/// Mean column of the factor, weighted by its length, from which on a factorisation takes many times as long as a solution.
const LONG_COLUMN: usize = 40;

impl Pattern {
    /// The pattern of the factor of a matrix that couples each node with its `neighbours` (sorted, without itself); `places` are where the
    /// nodes lie in space.
    pub fn of(neighbours: Vec<Vec<u32>>, places: &[[f64; 3]]) -> Self {
        let couplings = neighbours.iter().map(Vec::len).sum();
        let turns = turns(&neighbours, places);
        let elimination = minimum_degree(neighbours, &turns);
        let node = elimination.order;
        let mut place = vec![0; node.len()];
        node.iter().enumerate().for_each(|(at, node)| place[*node as usize] = at as u32);
        let mut start = vec![0];
        let mut rows = Vec::with_capacity(elimination.columns.iter().map(Vec::len).sum());
        for column in elimination.columns {
            let first = rows.len();
            rows.extend(column.iter().map(|node| place[*node as usize]));
            rows[first..].sort_unstable();
            start.push(rows.len());
        }
        Self { place, node, start, rows, couplings }
    }

    /// Whether it serves for these neighbours, too: it has all their couplings and few others.
    pub fn serves(&self, neighbours: &[Vec<u32>]) -> bool {
        let couplings: usize = neighbours.iter().map(Vec::len).sum();
        let has = |(node, other): (usize, u32)| {
            let (a, b) = (self.place[node] as usize, self.place[other as usize] as usize);
            a < b || self.find(a, b).is_some()
        };
        let mut pairs = neighbours.iter().enumerate().flat_map(|(node, list)| list.iter().map(move |other| (node, *other)));
        neighbours.len() == self.size() && couplings as f64 >= (1.0 - SPARE) * self.couplings as f64 && pairs.all(has)
    }

    /// Whether a factorisation takes many times as long as a solution by the factor.
    pub fn is_heavy(&self) -> bool {
        let square: usize = self.start.windows(2).map(|w| (w[1] - w[0]) * (w[1] - w[0])).sum();
        square > LONG_COLUMN * self.rows.len()
    }

    pub fn size(&self) -> usize {
        self.node.len()
    }

    /// The rows of a column.
    pub fn column(&self, column: usize) -> &[u32] {
        &self.rows[self.start[column]..self.start[column + 1]]
    }

    /// Where the block of a row and an earlier column lies among the blocks below the diagonal.
    pub fn find(&self, row: usize, column: usize) -> Option<usize> {
        self.column(column).binary_search(&(row as u32)).ok().map(|k| self.start[column] + k)
    }
}

/// A symmetric matrix, or a factor, in the order of elimination; of a symmetric one only the lower part counts.
pub(in crate::adjustment) struct SparseMatrix {
    pub diagonal: Vec<Block6>,
    /// One for each of the pattern's rows.
    pub below: Vec<Block6>,
}

impl SparseMatrix {
    /// y += A x; six numbers for each place.
    pub fn add_product(&self, pattern: &Pattern, x: &[f64], y: &mut [f64]) {
        for column in 0..pattern.size() {
            let own: [f64; N] = std::array::from_fn(|k| x[column * N + k]);
            let mut sum: [f64; N] = std::array::from_fn(|k| y[column * N + k]);
            for (diagonal, factor) in self.diagonal[column].as_chunks::<N>().0.iter().zip(own) {
                (0..N).for_each(|r| sum[r] += diagonal[r] * factor);
            }
            for at in pattern.start[column]..pattern.start[column + 1] {
                let row = pattern.rows[at] as usize * N;
                for (k, below) in self.below[at].as_chunks::<N>().0.iter().enumerate() {
                    for r in 0..N {
                        y[row + r] += below[r] * own[k];
                        sum[k] += below[r] * x[row + r];
                    }
                }
            }
            y[column * N..][..N].copy_from_slice(&sum);
        }
    }

    pub fn zeros(pattern: &Pattern) -> Self {
        Self { diagonal: vec![[0.0; N * N]; pattern.size()], below: vec![[0.0; N * N]; pattern.rows.len()] }
    }
}
