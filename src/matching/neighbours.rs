//! The nearest of many positions.

/// Positions sorted into square cells that hold about two each.
pub(super) struct Neighbours<'p> {
    positions: &'p [[f64; 2]],
    /// Indices of the positions, cell by cell, row by row.
    order: Vec<u32>,
    /// Where each cell starts in `order`.
    starts: Vec<u32>,
    columns: usize,
    rows: usize,
    origin: [f64; 2],
    cell: f64,
}

impl<'p> Neighbours<'p> {
    /// Takes finite positions.
    pub fn new(positions: &'p [[f64; 2]]) -> Self {
        let bound = |axis: usize, pick: fn(f64, f64) -> f64, start| positions.iter().map(|p| p[axis]).fold(start, pick);
        let origin = [bound(0, f64::min, f64::MAX), bound(1, f64::min, f64::MAX)];
        let extent = [0, 1].map(|axis| (bound(axis, f64::max, f64::MIN) - origin[axis]).max(1e-9));
        let cells = (positions.len() as f64 / 2.0).max(1.0);
        // Along a line one side is nearly 0: then the cells are set by the longer side alone.
        let cell = (extent[0] * extent[1] / cells).sqrt().max(extent[0].max(extent[1]) / cells);
        let [columns, rows] = extent.map(|e| (e / cell) as usize + 1);
        let mut index = Self {
            positions,
            order: (0..positions.len() as u32).collect(),
            starts: vec![0; columns * rows + 1],
            columns,
            rows,
            origin,
            cell,
        };
        let cells: Vec<usize> = positions.iter().map(|p| index.row_of(p[1]) * columns + index.column_of(p[0])).collect();
        index.order.sort_by_key(|k| cells[*k as usize]);
        cells.iter().for_each(|cell| index.starts[cell + 1] += 1);
        (1..index.starts.len()).for_each(|k| index.starts[k] += index.starts[k - 1]);
        index
    }

    /// Writes the up to `number` positions nearest to that of `index` of those that `counts` lets count, itself left out; of equally
    /// distant ones the lower indices. They come in no order.
    pub fn nearest(&self, index: usize, number: usize, counts: impl Fn(usize) -> bool, found: &mut Vec<usize>) {
        self.nearest_to(self.positions[index], number, |other| other != index && counts(other), found);
    }

    /// The same of any position.
    pub fn nearest_to(&self, at: [f64; 2], number: usize, counts: impl Fn(usize) -> bool, found: &mut Vec<usize>) {
        let mut near = Vec::with_capacity(64);
        let mut radius = 2.5 * self.cell;
        loop {
            near.clear();
            let all = self.within(at, radius, &counts, &mut near);
            if near.len() >= number || all {
                break;
            }
            radius *= 2.0;
        }
        if near.len() > number {
            near.select_nth_unstable_by(number, by_distance);
            near.truncate(number);
        }
        found.clear();
        found.extend(near.iter().map(|(_, k)| *k as usize));
    }

    /// Collects squared distance and index of the positions up to `radius` away; tells whether no position lies beyond the cells searched.
    fn within(&self, [x, y]: [f64; 2], radius: f64, counts: impl Fn(usize) -> bool, near: &mut Vec<(f64, u32)>) -> bool {
        let (first_column, last_column) = (self.column_of(x - radius), self.column_of(x + radius));
        let (first_row, last_row) = (self.row_of(y - radius), self.row_of(y + radius));
        let all = (first_column, first_row, last_column + 1, last_row + 1) == (0, 0, self.columns, self.rows);
        for row in first_row..=last_row {
            let cells = row * self.columns;
            let range = self.starts[cells + first_column] as usize..self.starts[cells + last_column + 1] as usize;
            for k in &self.order[range] {
                let other = *k as usize;
                let (dx, dy) = (self.positions[other][0] - x, self.positions[other][1] - y);
                let distance = dx * dx + dy * dy;
                if (distance <= radius * radius || all) && counts(other) {
                    near.push((distance, *k));
                }
            }
        }
        all
    }

    fn column_of(&self, x: f64) -> usize {
        (((x - self.origin[0]) / self.cell).max(0.0) as usize).min(self.columns - 1)
    }

    fn row_of(&self, y: f64) -> usize {
        (((y - self.origin[1]) / self.cell).max(0.0) as usize).min(self.rows - 1)
    }
}

fn by_distance(a: &(f64, u32), b: &(f64, u32)) -> std::cmp::Ordering {
    a.0.total_cmp(&b.0).then(a.1.cmp(&b.1))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn by_definition(positions: &[[f64; 2]], index: usize, number: usize, counts: fn(usize) -> bool) -> Vec<usize> {
        let distance = |k: usize| (positions[k][0] - positions[index][0]).powi(2) + (positions[k][1] - positions[index][1]).powi(2);
        let mut order: Vec<(f64, usize)> = (0..positions.len()).filter(|k| *k != index && counts(*k)).map(|k| (distance(k), k)).collect();
        order.sort_by(|a, b| a.partial_cmp(b).unwrap());
        let mut nearest: Vec<usize> = order.into_iter().take(number).map(|(_, k)| k).collect();
        nearest.sort_unstable();
        nearest
    }

    fn check(positions: &[[f64; 2]], number: usize) {
        let neighbours = Neighbours::new(positions);
        let mut found = Vec::new();
        for counts in [|_| true, |k: usize| !k.is_multiple_of(3)] {
            for index in 0..positions.len() {
                neighbours.nearest(index, number, counts, &mut found);
                found.sort_unstable();
                assert_eq!(found, by_definition(positions, index, number, counts), "of {index}");
            }
        }
    }

    #[test]
    fn finds_what_the_definition_finds() {
        let scattered: Vec<[f64; 2]> = (0..300).map(|k| [((k * 7919) % 997) as f64 / 3.0, ((k * 104_729) % 499) as f64]).collect();
        check(&scattered, 12);
        let clustered: Vec<[f64; 2]> = scattered.iter().map(|p| [p[0] * p[0] / 300.0, p[1] * p[1] / 500.0]).collect();
        check(&clustered, 5);
        let line: Vec<[f64; 2]> = (0..50).map(|k| [k as f64 * 3.0, 7.0]).collect();
        check(&line, 4);
        let same = vec![[1.0, 1.0]; 9];
        check(&same, 3);
    }

    #[test]
    fn fewer_positions_than_wanted_give_all_the_others() {
        check(&[[0.0, 0.0], [1.0, 0.0], [0.0, 2.0]], 12);
        check(&[[4.0, 5.0]], 12);
        check(&[], 12);
    }
}
