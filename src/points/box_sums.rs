//! Sums over sliding windows, row by row: what the operators of larger windows share.

/// Sums of each column over the last `height` rows that were pushed.
pub(super) struct ColumnSums {
    rows: Vec<Vec<u32>>,
    sums: Vec<u32>,
    pushed: usize,
}

impl ColumnSums {
    pub fn new(height: usize, width: usize) -> Self {
        Self { rows: vec![vec![0; width]; height], sums: vec![0; width], pushed: 0 }
    }

    /// Takes the next row, whose values `fill` writes. Sums wrap as two's complement, so that signed values may be passed as well.
    pub fn push(&mut self, fill: impl FnOnce(&mut [u32])) {
        let slot = self.pushed % self.rows.len();
        let row = &mut self.rows[slot];
        self.sums.iter_mut().zip(row.iter()).for_each(|(sum, old)| *sum = sum.wrapping_sub(*old));
        fill(row);
        self.sums.iter_mut().zip(row.iter()).for_each(|(sum, new)| *sum = sum.wrapping_add(*new));
        self.pushed += 1;
    }

    /// The sums over windows of `width` columns, from the leftmost to the right; absent until all rows of the window were pushed.
    pub fn windows(&self, width: usize) -> Option<impl Iterator<Item = u32> + '_> {
        let full = self.pushed >= self.rows.len();
        full.then(|| {
            let mut sum = self.sums[..width - 1].iter().fold(0u32, |sum, v| sum.wrapping_add(*v));
            (width - 1..self.sums.len()).map(move |last| {
                sum = sum.wrapping_add(self.sums[last]);
                let window = sum;
                sum = sum.wrapping_sub(self.sums[last + 1 - width]);
                window
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn window_sums_agree_with_the_definition() {
        let value = |col: usize, row: usize| (col * 31 + row * 17) % 23;
        let mut sums = ColumnSums::new(3, 8);
        for row in 0..5 {
            assert_eq!(sums.windows(4).is_some(), row >= 3);
            sums.push(|line| line.iter_mut().enumerate().for_each(|(col, v)| *v = value(col, row) as u32));
        }
        let expected = (0..5).map(|col| (2..5).flat_map(|r| (col..col + 4).map(move |c| value(c, r) as u32)).sum::<u32>());
        assert!(sums.windows(4).unwrap().eq(expected));
    }
}
