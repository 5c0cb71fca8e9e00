//! Points that are salient in position and in scale: maxima of the response over 3 x 3 x 3 neighbours.

use super::blur::LANES;
use super::quadratic;
use super::response::determinants;
use crate::math::Lanes;

/// Pixels of a level at its border in which no point is sought.
const BORDER: usize = 4;

/// A maximum, by its place in its octave.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Extremum {
    /// Number of the level in the octave.
    pub level: usize,
    pub col: usize,
    pub row: usize,
    /// Between the samples: in x, y and level.
    pub offset: [f64; 3],
    pub response: f64,
}

/// The rows of responses at work and what was found so far.
pub(super) struct Search {
    width: usize,
    height: usize,
    sigmas: Vec<f64>,
    least: f32,
    levels: Vec<Responses>,
    /// By row, then level, then column.
    pub found: Vec<Extremum>,
}

/// The last three rows of responses of a level.
struct Responses {
    /// Row y lies in slot y mod 3; column x lies at x - 1.
    rows: [Vec<f32>; 3],
    /// The largest of each column over the three rows.
    columns: Vec<f32>,
}

impl Responses {
    fn new(stride: usize) -> Self {
        Self { rows: std::array::from_fn(|_| vec![0.0; stride]), columns: vec![0.0; stride] }
    }

    fn update_columns(&mut self) {
        let [a, b, c] = &self.rows;
        let rows = a.chunks_exact(LANES).zip(b.chunks_exact(LANES)).zip(c.chunks_exact(LANES));
        for (out, ((a, b), c)) in self.columns.chunks_exact_mut(LANES).zip(rows) {
            Lanes::load(a).max(Lanes::load(b)).max(Lanes::load(c)).store(out);
        }
    }
}

impl Search {
    /// `sigmas` are the blurs of all levels in px; those between the first and the last have extrema.
    pub fn new(width: usize, height: usize, sigmas: Vec<f64>, least: f32) -> Self {
        let stride = width.next_multiple_of(8);
        let levels = sigmas.iter().map(|_| Responses::new(stride)).collect();
        Self { width, height, sigmas, least, levels, found: Vec::new() }
    }

    /// Takes the next row, from 1 on, of all levels; `grey(level, row)` gives this row, the one above and the one below.
    pub fn push<'r>(&mut self, row: usize, grey: impl Fn(usize, usize) -> &'r [f32]) {
        for (k, (responses, sigma)) in self.levels.iter_mut().zip(&self.sigmas).enumerate() {
            determinants([row - 1, row, row + 1].map(|row| grey(k, row)), *sigma, &mut responses.rows[row % 3]);
            responses.update_columns();
        }
        if row > BORDER && row + BORDER <= self.height {
            (1..self.levels.len() - 1).for_each(|level| self.scan(level, row - 1));
        }
    }

    /// Looks for maxima in the row before the last that was pushed.
    fn scan(&mut self, level: usize, row: usize) {
        let three = &self.levels[level - 1..=level + 1];
        let line = &three[1].rows[row % 3];
        let least = Lanes::splat(self.least);
        // Column x lies at x - 1; a block's window holds the columns beside it as well.
        let blocks = line.windows(LANES + 2).enumerate().skip(BORDER - 2).step_by(LANES);
        for (x, window) in blocks {
            let here = Lanes::load(&window[1..]);
            if here.not_below(least) == 0 {
                continue;
            }
            let around = three.iter().fold(least, |most, responses| {
                let c = &responses.columns[x..][..LANES + 2];
                most.max(Lanes::load(c).max(Lanes::load(&c[1..])).max(Lanes::load(&c[2..])))
            });
            let found = here.not_below(around);
            for lane in (0..LANES).filter(|lane| found >> lane & 1 == 1) {
                let col = x + 2 + lane;
                if col + BORDER >= self.width {
                    continue;
                }
                let cube = three_by_three(three, col, row);
                if !is_first_of_equals(&cube) {
                    continue;
                }
                let Some(offset) = quadratic::offset(&cube) else { continue };
                self.found.push(Extremum { level, col, row, offset, response: f64::from(cube[1][1][1]) });
            }
        }
    }
}

/// The responses around a place, by level, row and column.
fn three_by_three(three: &[Responses], col: usize, row: usize) -> [[[f32; 3]; 3]; 3] {
    std::array::from_fn(|level| {
        std::array::from_fn(|r| {
            let line = &three[level].rows[(row + r + 2) % 3];
            [line[col - 2], line[col - 1], line[col]]
        })
    })
}

/// Whether no neighbour before the centre, by level, row and column, has the same response.
fn is_first_of_equals(cube: &[[[f32; 3]; 3]; 3]) -> bool {
    let flat = cube.as_flattened().as_flattened();
    flat[..13].iter().all(|before| *before < flat[13])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn maxima_agree_with_the_definition() {
        let (width, height, sigmas) = (83usize, 51usize, vec![1.0, 1.2, 1.5, 1.9]);
        let stride = width.next_multiple_of(8) + 8;
        let grey =
            |level: usize, col: usize, row: usize| (((col * 7919 + row * 104_729 + level * 15_485_863) * 2_654_435) as u32 % 97) as f32;
        let rows: Vec<Vec<Vec<f32>>> =
            (0..4).map(|k| (0..height).map(|row| (0..stride).map(|col| grey(k, col, row)).collect()).collect()).collect();
        let least = 500.0;
        let mut search = Search::new(width, height, sigmas.clone(), least);
        (1..height - 1).for_each(|row| search.push(row, |level, row| &rows[level][row][..]));

        let response = |k: usize, col: usize, row: usize| {
            let mut out = vec![0.0; stride - 8];
            determinants([row - 1, row, row + 1].map(|row| &rows[k][row][..]), sigmas[k], &mut out);
            out[col - 1]
        };
        let responses: Vec<Vec<Vec<f32>>> =
            (0..4).map(|k| (1..height - 1).map(|row| (1..width - 1).map(|col| response(k, col, row)).collect()).collect()).collect();
        let at = |k: usize, col: usize, row: usize| responses[k][row - 1][col - 1];
        let mut expected = Vec::new();
        for row in BORDER..height - BORDER {
            for k in 1..3 {
                for col in BORDER..width - BORDER {
                    let here = at(k, col, row);
                    let cube: [[[f32; 3]; 3]; 3] =
                        std::array::from_fn(|l| std::array::from_fn(|r| std::array::from_fn(|c| at(k + l - 1, col + c - 1, row + r - 1))));
                    let greatest = cube.as_flattened().as_flattened().iter().filter(|v| **v >= here).count() == 1;
                    if here >= least && greatest && quadratic::offset(&cube).is_some() {
                        expected.push((k, col, row));
                    }
                }
            }
        }
        assert!(expected.len() > 20, "{} maxima", expected.len());
        let found: Vec<_> = search.found.iter().map(|e| (e.level, e.col, e.row)).collect();
        assert_eq!(found, expected);
    }

    #[test]
    fn the_first_of_equal_neighbours_counts() {
        let mut cube = [[[1.0; 3]; 3]; 3];
        cube[1][1][1] = 2.0;
        cube[1][1][2] = 2.0;
        assert!(is_first_of_equals(&cube));
        cube[0][2][2] = 2.0;
        assert!(!is_first_of_equals(&cube));
    }
}
