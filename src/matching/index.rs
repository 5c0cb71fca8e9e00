//! Looking points up by position.

/// Positions sorted into strips one pixel high and some pixels wide; larger ones where the positions lie far apart.
pub(super) struct PositionIndex {
    /// Index of the point, x, y; by row, then strip, then the order they came in.
    entries: Vec<(u32, f64, f64)>,
    /// Where each strip of each row starts in `entries`.
    starts: Vec<u32>,
    strips: usize,
    top: f64,
    left: f64,
    /// Width and height of a strip in px.
    strip: [f64; 2],
}

/// Width and height of a strip in px, where not more than `MOST_STRIPS` are needed.
const STRIP: [f64; 2] = [16.0, 1.0];
const MOST_STRIPS: f64 = 4e6;

impl PositionIndex {
    /// Takes points as index, x, y; positions are finite.
    pub fn new(points: impl Iterator<Item = (usize, f64, f64)> + Clone) -> Self {
        Self::of_strips(points, |_, _| STRIP)
    }

    /// As [`Self::new`], of squares that hold about one point each: for what crosses the image in any direction.
    pub fn of_squares(points: impl Iterator<Item = (usize, f64, f64)> + Clone) -> Self {
        Self::of_strips(points, |count, [width, height]| [((width * height / count).sqrt()).max((width.max(height)) / count).max(1.0); 2])
    }

    /// `strip`: width and height in px by the number of points and the size of the rectangle that holds them.
    fn of_strips(points: impl Iterator<Item = (usize, f64, f64)> + Clone, strip: impl Fn(f64, [f64; 2]) -> [f64; 2]) -> Self {
        let bounds = points.clone().fold([f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY], |b, (_, x, y)| {
            [b[0].min(x), b[1].min(y), b[2].max(x), b[3].max(y)]
        });
        let mut index = Self { entries: Vec::new(), starts: vec![0, 0], strips: 1, top: 0.0, left: 0.0, strip: STRIP };
        if bounds[2] < bounds[0] {
            return index;
        }
        (index.left, index.top) = (bounds[0].floor(), bounds[1].floor());
        let strip = strip(points.clone().count() as f64, [bounds[2] - index.left, bounds[3] - index.top]);
        let needed = [(bounds[2] - index.left) / strip[0] + 1.0, (bounds[3] - index.top) / strip[1] + 1.0];
        let enlarged = (needed[0] * needed[1] / MOST_STRIPS).max(1.0);
        index.strip = strip.map(|side| side * enlarged);
        index.strips = ((bounds[2] - index.left) / index.strip[0]) as usize + 1;
        let rows = ((bounds[3] - index.top) / index.strip[1]) as usize + 1;
        let cell =
            |x: f64, y: f64| ((y - index.top) / index.strip[1]) as usize * index.strips + ((x - index.left) / index.strip[0]) as usize;
        let mut starts = vec![0u32; rows * index.strips + 1];
        points.clone().for_each(|(_, x, y)| starts[cell(x, y) + 1] += 1);
        (1..starts.len()).for_each(|k| starts[k] += starts[k - 1]);
        let mut next = starts.clone();
        index.entries = vec![(0, 0.0, 0.0); starts[starts.len() - 1] as usize];
        points.for_each(|(point, x, y)| {
            let slot = &mut next[cell(x, y)];
            index.entries[*slot as usize] = (point as u32, x, y);
            *slot += 1;
        });
        index.starts = starts;
        index
    }

    /// Gives the points with |x - `x`| and |y - `y`| up to `reach`, row by row.
    pub fn within(&self, x: f64, y: f64, reach: f64, mut visit: impl FnMut(usize)) {
        self.around([x - reach, y - reach, x + reach, y + reach], |point, px, py| {
            if (px - x).abs() <= reach && (py - y).abs() <= reach {
                visit(point);
            }
        });
    }

    /// Gives the points of a band that crosses the index, and some around it, with their positions: `band` gives its least and largest y
    /// between two x (`flat`), or its least and largest x between two y.
    pub fn across(&self, flat: bool, band: impl Fn(f64, f64) -> [f64; 2], mut visit: impl FnMut(usize, f64, f64)) {
        let rows = (self.starts.len() - 1) / self.strips;
        let [width, height] = self.strip;
        let (steps, origin, side) = if flat { (self.strips, self.left, width) } else { (rows, self.top, height) };
        let (cells, cells_origin, cells_side) = if flat { (rows, self.top, height) } else { (self.strips, self.left, width) };
        for step in 0..steps {
            let start = origin + step as f64 * side;
            let [first, last] = band(start, start + side).map(|v| ((v - cells_origin) / cells_side).floor());
            if !(last >= 0.0 && first < cells as f64) {
                continue;
            }
            let (first, last) = (first.max(0.0) as usize, (last as usize).min(cells - 1));
            let mut give = |from: usize, to: usize| {
                for (point, x, y) in &self.entries[self.starts[from] as usize..self.starts[to] as usize] {
                    visit(*point as usize, *x, *y);
                }
            };
            if flat {
                (first..=last).for_each(|row| give(row * self.strips + step, row * self.strips + step + 1));
            } else {
                give(step * self.strips + first, step * self.strips + last + 1);
            }
        }
    }

    /// Gives the points of a rectangle `[left, top, right, bottom]` and some around it with their positions, row by row.
    pub fn around(&self, [left, top, right, bottom]: [f64; 4], mut visit: impl FnMut(usize, f64, f64)) {
        let rows = (self.starts.len() - 1) / self.strips;
        let [width, height] = self.strip;
        let first_row = ((top - self.top) / height).floor().max(0.0) as usize;
        let first_strip = ((left - self.left) / width).floor().max(0.0) as usize;
        let (last_row, last_strip) = (((bottom - self.top) / height).floor(), ((right - self.left) / width).floor());
        if !(last_row >= 0.0 && last_strip >= 0.0) || first_strip >= self.strips {
            return;
        }
        let last_strip = (last_strip as usize).min(self.strips - 1);
        for row in first_row..(last_row as usize + 1).min(rows) {
            let cells = row * self.strips;
            let (start, end) = (self.starts[cells + first_strip], self.starts[cells + last_strip + 1]);
            for (point, px, py) in &self.entries[start as usize..end as usize] {
                visit(*point as usize, *px, *py);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_what_the_definition_finds() {
        let points: Vec<(usize, f64, f64)> =
            (0..500).map(|k| (k, ((k * 7919) % 1000) as f64 / 7.0 - 20.0, ((k * 104_729) % 1000) as f64 / 9.0 + 3.0)).collect();
        for index in [PositionIndex::new(points.iter().copied()), PositionIndex::of_squares(points.iter().copied())] {
            for (x, y, reach) in [(30.0, 40.0, 12.0), (-25.0, 0.0, 8.0), (125.0, 115.0, 30.0), (500.0, 500.0, 12.0), (50.0, 50.0, 1000.0)] {
                let mut found = Vec::new();
                index.within(x, y, reach, |k| found.push(k));
                found.sort_unstable();
                let expected: Vec<usize> =
                    points.iter().filter(|p| (p.1 - x).abs() <= reach && (p.2 - y).abs() <= reach).map(|p| p.0).collect();
                assert_eq!(found, expected);
            }
        }
    }

    #[test]
    fn positions_far_apart_need_no_large_index() {
        let index = PositionIndex::new([(0, -1e6, -1e6), (1, 1e6, 1e6), (2, 1e6, 1e6 - 5.0)].into_iter());
        assert!(index.starts.len() < 10_000_000);
        let mut found = Vec::new();
        index.within(1e6, 1e6, 6.0, |k| found.push(k));
        found.sort_unstable();
        assert_eq!(found, [1, 2]);
    }

    #[test]
    fn an_empty_index_finds_nothing() {
        PositionIndex::new(std::iter::empty()).within(0.0, 0.0, 10.0, |_| panic!("nothing is there"));
    }
}
