//! A plane cut into square cells, each with the list of the things that touch it.

/// An axis-aligned rectangle `[x_min, y_min, x_max, y_max]`.
pub(super) type Rectangle = [f64; 4];

/// Lists of indices by cell, in rising order.
pub(super) struct Buckets {
    origin: [f64; 2],
    cells_per_unit: f64,
    cols: usize,
    rows: usize,
    /// Where each cell's list starts in `items`; one more than there are cells.
    starts: Vec<u32>,
    items: Vec<u32>,
}

impl Buckets {
    /// Sorts the things with the given extents into the cells of `area`. What lies outside is in no list.
    pub(super) fn new(area: Rectangle, cell: f64, extents: &[Rectangle]) -> Self {
        let count = |low: f64, high: f64| (((high - low) / cell).ceil() as usize).max(1);
        let (cols, rows) = (count(area[0], area[2]), count(area[1], area[3]));
        let mut buckets = Self {
            origin: [area[0], area[1]],
            cells_per_unit: 1.0 / cell,
            cols,
            rows,
            starts: vec![0; cols * rows + 1],
            items: Vec::new(),
        };
        buckets.fill(extents);
        buckets
    }

    /// Counting sort: lengths, then starts, then the lists.
    fn fill(&mut self, extents: &[Rectangle]) {
        for extent in extents {
            self.each_cell(extent, |starts, cell| starts[cell + 1] += 1);
        }
        for cell in 1..self.starts.len() {
            self.starts[cell] += self.starts[cell - 1];
        }
        let mut items = vec![0; self.starts[self.starts.len() - 1] as usize];
        let mut next = self.starts.clone();
        for (index, extent) in extents.iter().enumerate() {
            self.each_cell(extent, |_, cell| {
                items[next[cell] as usize] = index as u32;
                next[cell] += 1;
            });
        }
        self.items = items;
    }

    fn each_cell(&mut self, extent: &Rectangle, mut act: impl FnMut(&mut [u32], usize)) {
        let place = |value: f64, axis: usize| (value - self.origin[axis]) * self.cells_per_unit;
        let span = |low: f64, high: f64, count: usize| {
            let outside = high < 0.0 || low >= count as f64;
            if outside { 0..0 } else { low.max(0.0) as usize..(high as usize).min(count - 1) + 1 }
        };
        let cols = span(place(extent[0], 0), place(extent[2], 0), self.cols);
        let rows = span(place(extent[1], 1), place(extent[3], 1), self.rows);
        for row in rows {
            for col in cols.clone() {
                act(&mut self.starts, row * self.cols + col);
            }
        }
    }

    /// The things that touch the cell of a place; none outside the area.
    pub(super) fn at(&self, x: f64, y: f64) -> &[u32] {
        let (col, row) = ((x - self.origin[0]) * self.cells_per_unit, (y - self.origin[1]) * self.cells_per_unit);
        if !(col >= 0.0 && row >= 0.0 && col < self.cols as f64 && row < self.rows as f64) {
            return &[];
        }
        let cell = row as usize * self.cols + col as usize;
        &self.items[self.starts[cell] as usize..self.starts[cell + 1] as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_lists_all_that_covers_it() {
        let things = [[0.0, 0.0, 3.0, 1.0], [2.5, 0.5, 2.6, 0.6], [-9.0, -9.0, 99.0, 99.0], [20.0, 20.0, 30.0, 30.0]];
        let buckets = Buckets::new([0.0, 0.0, 10.0, 5.0], 2.0, &things);
        assert_eq!(buckets.at(2.55, 0.55), [0, 1, 2]);
        assert_eq!(buckets.at(9.99, 4.99), [2]);
        for (x, y) in [(-0.1, 1.0), (1.0, 6.1), (f64::NAN, 1.0)] {
            assert!(buckets.at(x, y).is_empty(), "{x} {y} is outside");
        }
    }
}
