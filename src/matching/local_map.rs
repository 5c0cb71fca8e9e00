//! Where the nearest matches foretell that a left position is seen.

use super::neighbours::Neighbours;
use crate::math::median;

/// The affine map of neighbouring matches about a left position.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct LocalMap {
    /// Where the position is seen, in px.
    pub place: [f64; 2],
    /// Rows of the matrix that takes px from the left position to px from the right one.
    pub affine: [[f64; 2]; 2],
    /// Median distance of the neighbours from their map, in px.
    pub scatter_px: f64,
}

/// A left position and where it is seen.
type Seen = ([f64; 2], [f64; 2]);

/// Neighbours that scatter more lie on both sides of a break of the surface.
const LARGEST_SCATTER_PX: f64 = 6.0;
/// Least ratio of the variances of the neighbours along their two axes: along a line they tell nothing across it.
const LEAST_SPREAD: f64 = 0.02;
/// Square of the distance from the middle of the neighbours, in their mean squares, beyond which a map is continued too far.
const FARTHEST: f64 = 4.0;
/// Least and largest change of area.
const AREA: [f64; 2] = [0.05, 20.0];

impl LocalMap {
    /// Matches that make a map: an affine map has six unknowns, of which two of each match tell.
    pub const NEIGHBOURS: usize = 8;

    /// The map of these matches, each the left and the right position; absent where they are fewer, lie along a line or scatter.
    pub fn about(position: [f64; 2], matches: impl Iterator<Item = Seen>) -> Option<Self> {
        let matches: Vec<Seen> = matches.collect();
        if matches.len() < Self::NEIGHBOURS {
            return None;
        }
        // Relative to the position, so that the constant of the map is its place.
        let from = |l: [f64; 2]| [l[0] - position[0], l[1] - position[1]];
        let mean = |of: &dyn Fn(&Seen) -> f64| matches.iter().map(of).sum::<f64>() / matches.len() as f64;
        let l = [mean(&|m| from(m.0)[0]), mean(&|m| from(m.0)[1])];
        let r = [mean(&|m| m.1[0]), mean(&|m| m.1[1])];
        let left = |m: &Seen, k: usize| from(m.0)[k] - l[k];
        let right = |m: &Seen, k: usize| m.1[k] - r[k];
        let xx = mean(&|m| left(m, 0) * left(m, 0));
        let xy = mean(&|m| left(m, 0) * left(m, 1));
        let yy = mean(&|m| left(m, 1) * left(m, 1));
        let determinant = xx * yy - xy * xy;
        let is_wide = determinant > LEAST_SPREAD * 0.25 * (xx + yy) * (xx + yy);
        if !(is_wide && l[0] * l[0] + l[1] * l[1] <= FARTHEST * (xx + yy)) {
            return None;
        }
        let affine = [0, 1].map(|k| {
            let (xr, yr) = (mean(&|m| left(m, 0) * right(m, k)), mean(&|m| left(m, 1) * right(m, k)));
            [(yy * xr - xy * yr) / determinant, (xx * yr - xy * xr) / determinant]
        });
        let place = [0, 1].map(|k| r[k] - affine[k][0] * l[0] - affine[k][1] * l[1]);
        let area = affine[0][0] * affine[1][1] - affine[0][1] * affine[1][0];
        let distance = |m: &Seen| {
            let off = [0, 1].map(|k| right(m, k) - affine[k][0] * left(m, 0) - affine[k][1] * left(m, 1));
            libm::hypot(off[0], off[1])
        };
        let scatter_px = median(&mut matches.iter().map(distance).collect::<Vec<f64>>())?;
        ((AREA[0]..=AREA[1]).contains(&area) && scatter_px <= LARGEST_SCATTER_PX).then_some(Self { place, affine, scatter_px })
    }
}

/// Matches that foretell what lies about them: left positions, and where they are seen.
pub(super) struct Foretelling<'m> {
    neighbours: Neighbours<'m>,
    left: &'m [[f64; 2]],
    right: &'m [[f64; 2]],
}

impl<'m> Foretelling<'m> {
    pub fn new(left: &'m [[f64; 2]], right: &'m [[f64; 2]]) -> Self {
        Self { neighbours: Neighbours::new(left), left, right }
    }

    /// The map of those that are nearest to a left position: of the others, where a match starts there.
    pub fn about(&self, position: [f64; 2]) -> Option<LocalMap> {
        self.within(position, f64::INFINITY)
    }

    /// The same, where all of them lie within so many px.
    pub fn within(&self, position: [f64; 2], farthest_px: f64) -> Option<LocalMap> {
        let mut near = Vec::new();
        self.neighbours.nearest_to(position, LocalMap::NEIGHBOURS, |other| self.left[other] != position, &mut near);
        // Sums are the same in one order only.
        near.sort_unstable();
        let is_far = |n: &usize| libm::hypot(self.left[*n][0] - position[0], self.left[*n][1] - position[1]) > farthest_px;
        if near.iter().any(is_far) {
            return None;
        }
        LocalMap::about(position, near.iter().map(|n| (self.left[*n], self.right[*n])))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const AROUND: [[f64; 2]; 8] = [[3.0, 1.0], [-4.0, 2.0], [1.0, -5.0], [6.0, 6.0], [-7.0, -3.0], [2.0, 8.0], [-1.0, -9.0], [9.0, -2.0]];

    fn map(at: [f64; 2], seen: impl Fn([f64; 2]) -> [f64; 2]) -> Option<LocalMap> {
        LocalMap::about(at, AROUND.iter().map(|p| [100.0 + p[0], 50.0 + p[1]]).map(|p| (p, seen(p))))
    }

    #[test]
    fn an_affine_surface_is_foretold_exactly() {
        let seen = |[x, y]: [f64; 2]| [1.2 * x - 0.3 * y + 40.0, 0.4 * x + 0.9 * y - 7.0];
        let found = map([101.0, 49.0], seen).unwrap();
        let truth = seen([101.0, 49.0]);
        assert!((0..2).all(|k| (found.place[k] - truth[k]).abs() < 1e-9) && found.scatter_px < 1e-9, "{found:?}");
        assert!((found.affine[0][0] - 1.2).abs() < 1e-9 && (found.affine[1][0] - 0.4).abs() < 1e-9, "{found:?}");
    }

    #[test]
    fn neighbours_that_foretell_nothing_make_no_map() {
        let plain = |p: [f64; 2]| p;
        assert!(map([100.0, 50.0], plain).is_some());
        assert_eq!(map([160.0, 50.0], plain), None, "far outside of them");
        assert_eq!(LocalMap::about([3.0, 3.0], (0..8).map(|k| [f64::from(k); 2]).map(|p| (p, p))), None, "along a line");
        assert_eq!(LocalMap::about([3.0, 3.0], AROUND[..7].iter().map(|p| (*p, *p))), None, "too few");
        let broken = |[x, y]: [f64; 2]| [x + if y > 50.0 { 60.0 } else { 0.0 }, y];
        assert_eq!(map([100.0, 50.0], broken), None, "on both sides of a break");
        assert_eq!(map([100.0, 50.0], |[x, y]| [-x, y]), None, "mirrored");
    }
}
