//! Where a sparse matrix and its factor have blocks.

use super::block::{Block6, N};
use super::ordering::minimum_degree;

/// The blocks of a factor: for each column, in the order of elimination, the rows below the diagonal.
pub(in crate::bundle) struct Pattern {
    /// The place in the order of elimination of each node.
    pub place: Vec<u32>,
    /// The node at each place.
    pub node: Vec<u32>,
    /// Where each column begins in `rows`, and where the last one ends.
    pub start: Vec<usize>,
    /// Places, ascending in each column.
    pub rows: Vec<u32>,
}

impl Pattern {
    /// The pattern of the factor of a matrix that couples each node with its `neighbours` (sorted, without itself).
    pub fn of(neighbours: Vec<Vec<u32>>) -> Self {
        let elimination = minimum_degree(neighbours);
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
        Self { place, node, start, rows }
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
pub(in crate::bundle) struct SparseMatrix {
    pub diagonal: Vec<Block6>,
    /// One for each of the pattern's rows.
    pub below: Vec<Block6>,
}

impl SparseMatrix {
    pub fn zeros(pattern: &Pattern) -> Self {
        Self { diagonal: vec![[0.0; N * N]; pattern.size()], below: vec![[0.0; N * N]; pattern.rows.len()] }
    }
}
