//! The coefficients of a search, and their best peak.

/// A peak that is a rival of the best one lies at least so many px from it in x or in y.
const RIVAL_DISTANCE: usize = 2;

/// Correlation coefficients, -1..1, at whole-pixel positions.
#[derive(Debug, Clone, Default)]
pub(crate) struct Surface {
    /// Column and row of the first position.
    first: [usize; 2],
    width: usize,
    height: usize,
    /// Row by row, with a frame one position wide that has no coefficients.
    values: Vec<f64>,
}

/// The best position of a search.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Peak {
    /// The pixel on which the found window is centred.
    pub pixel: [usize; 2],
    /// The peak to a fraction of a pixel, in px; the centre of the top-left pixel is (0.5, 0.5).
    pub position: [f64; 2],
    /// At the whole pixel.
    pub coefficient: f64,
    /// The highest coefficient of the other local maxima 2 px or more away from the best; absent where there is none.
    pub second: Option<f64>,
    /// Whether, in x and in y, a neighbour of the best has no coefficient: it lies on the edge of what was searched.
    pub on_edge: [bool; 2],
}

impl Surface {
    /// In the place of a coefficient where there is none: below all of them.
    pub(super) const NONE: f64 = f64::NEG_INFINITY;

    /// Makes it empty.
    pub(super) fn reset(&mut self, first: [usize; 2], [width, height]: [usize; 2]) {
        (self.first, self.width, self.height) = (first, width, height);
        self.values.clear();
        self.values.resize((width + 2) * (height + 2), Self::NONE);
    }

    /// A row of positions.
    pub(super) fn row_mut(&mut self, y: usize) -> &mut [f64] {
        let start = (y + 1) * (self.width + 2) + 1;
        &mut self.values[start..][..self.width]
    }

    /// The coefficient of the window centred on a pixel; `None` where it was not searched or is constant.
    #[cfg(test)]
    pub fn at(&self, col: usize, row: usize) -> Option<f64> {
        let (x, y) = (col.checked_sub(self.first[0])?, row.checked_sub(self.first[1])?);
        (x < self.width && y < self.height).then(|| self.values[self.place(x, y)]).filter(|c| *c != Self::NONE)
    }

    fn place(&self, x: usize, y: usize) -> usize {
        (y + 1) * (self.width + 2) + x + 1
    }

    /// The highest coefficient, of equal ones the first row by row; `None` where no position has one.
    pub fn peak(&self) -> Option<Peak> {
        // Four running maxima: a single one would wait for each comparison.
        let highest = self
            .values
            .chunks(4)
            .fold([Self::NONE; 4], |most, four| std::array::from_fn(|k| higher(most[k], *four.get(k).unwrap_or(&Self::NONE))));
        let coefficient = highest.into_iter().fold(Self::NONE, higher);
        if coefficient == Self::NONE {
            return None;
        }
        let place = self.values.iter().position(|c| *c == coefficient)?;
        let [x, y] = [place % (self.width + 2) - 1, place / (self.width + 2) - 1];
        let around = self.around(x, y);
        let on_edge = [[around[1][0], around[1][2]], [around[0][1], around[2][1]]].map(|ends| ends.contains(&Self::NONE));
        let shift = vertex(&around);
        let pixel = [self.first[0] + x, self.first[1] + y];
        Some(Peak {
            pixel,
            position: [0, 1].map(|axis| pixel[axis] as f64 + 0.5 + shift[axis]),
            coefficient: coefficient.min(1.0),
            second: self.second(x, y),
            on_edge,
        })
    }

    fn second(&self, best_x: usize, best_y: usize) -> Option<f64> {
        let mut second = Self::NONE;
        for y in 0..self.height {
            let near_in_y = y.abs_diff(best_y) < RIVAL_DISTANCE;
            let [above, row, below] = [0, 1, 2].map(|r| &self.values[(y + r) * (self.width + 2)..][..self.width + 2]);
            for (x, ((a, c), b)) in above.windows(3).zip(row.windows(3)).zip(below.windows(3)).enumerate() {
                // Most positions fail at once, along the row.
                let highest = c[1] > second && c[0] <= c[1] && c[2] <= c[1] && a.iter().chain(b).all(|v| *v <= c[1]);
                if highest && !(near_in_y && x.abs_diff(best_x) < RIVAL_DISTANCE) {
                    second = c[1];
                }
            }
        }
        (second != Self::NONE).then(|| second.min(1.0))
    }

    /// The coefficients of a position and its neighbours, row by row.
    fn around(&self, x: usize, y: usize) -> [[f64; 3]; 3] {
        let stride = self.width + 2;
        let corner = self.place(x, y) - stride - 1;
        std::array::from_fn(|r| std::array::from_fn(|c| self.values[corner + r * stride + c]))
    }
}

fn higher(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}

/// Where the quadratic surface with the central differences of the 3 x 3 coefficients about the best has its maximum, in px from it.
///
/// On shifts of band-limited texture that are known (tests below) its error is half to nine tenths of that of separate parabolas, and never
/// above that of the least-squares surface through all nine. Where a corner is missing, or that surface has no maximum within a pixel, each
/// axis by its own parabola; 0 along an axis without both neighbours.
fn vertex(around: &[[f64; 3]; 3]) -> [f64; 2] {
    of_surface(around).unwrap_or([around[1], [around[0][1], around[1][1], around[2][1]]].map(of_parabola))
}

fn of_surface(z: &[[f64; 3]; 3]) -> Option<[f64; 2]> {
    let (x, y) = ((z[1][2] - z[1][0]) / 2.0, (z[2][1] - z[0][1]) / 2.0);
    let (xx, yy) = (z[1][0] - 2.0 * z[1][1] + z[1][2], z[0][1] - 2.0 * z[1][1] + z[2][1]);
    let xy = (z[0][0] - z[0][2] - z[2][0] + z[2][2]) / 4.0;
    let determinant = xx * yy - xy * xy;
    let shift = [(xy * y - yy * x) / determinant, (xy * x - xx * y) / determinant];
    (xx < 0.0 && determinant > 0.0 && shift.iter().all(|s| s.abs() <= 1.0)).then_some(shift)
}

/// Where the parabola through three equidistant values has its maximum, from the middle one, which is the highest: -0.5..0.5.
pub(super) fn of_parabola([before, middle, after]: [f64; 3]) -> f64 {
    let curvature = before - 2.0 * middle + after;
    let vertex = 0.5 * (before - after) / curvature;
    if curvature < 0.0 && vertex.is_finite() { vertex.clamp(-0.5, 0.5) } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn surface(width: usize, height: usize, value: impl Fn(usize, usize) -> f64) -> Surface {
        let mut surface = Surface::default();
        surface.reset([10, 20], [width, height]);
        for y in 0..height {
            surface.row_mut(y).iter_mut().enumerate().for_each(|(x, v)| *v = value(x, y));
        }
        surface
    }

    fn hill(x: usize, y: usize, [top_x, top_y]: [f64; 2]) -> f64 {
        let (u, v) = (x as f64 - top_x, y as f64 - top_y);
        -(0.01 * u * u + 0.02 * v * v + 0.012 * u * v)
    }

    #[test]
    fn the_vertex_of_a_tilted_quadratic_is_exact() {
        for top in [[4.0, 3.0], [4.3, 2.8], [3.6, 3.45]] {
            let peak = surface(9, 7, |x, y| 0.9 + hill(x, y, top)).peak().unwrap();
            assert!((peak.position[0] - 10.5 - top[0]).abs() < 1e-12 && (peak.position[1] - 20.5 - top[1]).abs() < 1e-12, "{peak:?}");
            assert_eq!((peak.on_edge, peak.second), ([false; 2], None));
        }
    }

    #[test]
    fn the_second_peak_is_a_local_maximum_away_from_the_best() {
        let best = |x, y| 0.9 + hill(x, y, [4.0, 3.0]);
        let with =
            |at: [usize; 2], value: f64| surface(20, 20, move |x, y| if [x, y] == at { value } else { best(x, y) }).peak().unwrap().second;
        assert_eq!(with([12, 12], 0.8), Some(0.8));
        assert_eq!(with([6, 3], 0.89), Some(0.89));
        // A neighbour of the best is none, nor is a lower place on a slope; a corner of the area may be one.
        assert_eq!(with([5, 3], 0.895), None);
        assert_eq!(with([12, 12], best(12, 12)), None);
        assert_eq!(with([19, 19], 0.5), Some(0.5));
    }

    #[test]
    fn a_peak_on_the_edge_is_told_along_each_axis() {
        let edge = |top| surface(9, 7, |x, y| 0.9 + hill(x, y, top)).peak().unwrap();
        assert_eq!(edge([0.0, 3.0]).on_edge, [true, false]);
        assert_eq!(edge([4.0, 6.0]).on_edge, [false, true]);
        assert_eq!(edge([8.0, 0.0]).on_edge, [true, true]);
        // Along the edge the parabola still counts; across it there is none.
        assert_eq!(edge([0.0, 3.25]).position[0], 10.5);
        assert!((edge([0.0, 3.25]).position[1] - 23.75).abs() < 1e-9);
    }

    #[test]
    fn positions_without_coefficients_are_no_peaks() {
        assert_eq!(surface(5, 4, |_, _| Surface::NONE).peak(), None);
        let single = surface(5, 4, |x, y| if (x, y) == (2, 2) { 0.3 } else { Surface::NONE });
        let peak = single.peak().unwrap();
        assert_eq!((peak.pixel, peak.position, peak.on_edge), ([12, 22], [12.5, 22.5], [true, true]));
        assert_eq!((single.at(12, 22), single.at(11, 22), single.at(9, 22), single.at(15, 22)), (Some(0.3), None, None, None));
    }

    #[test]
    fn of_equal_coefficients_the_first_is_the_best() {
        let plateau = surface(6, 6, |_, _| 0.5).peak().unwrap();
        assert_eq!((plateau.pixel, plateau.second, plateau.position), ([10, 20], Some(0.5), [10.5, 20.5]));
    }
}
