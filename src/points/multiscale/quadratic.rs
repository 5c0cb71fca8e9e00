//! Position and scale between the samples: the maximum of a quadratic through 27 responses.

/// The offsets in x, y and level of the maximum of the quadratic that has the central differences of `cube` (by level, row, column).
///
/// `None` where the quadratic has no single stationary point or this is more than 1 sample off in position or scale.
///
/// # Source
/// Brown & Lowe 2002, Invariant features from interest point groups, eq. 3.
pub(super) fn offset(cube: &[[[f32; 3]; 3]; 3]) -> Option<[f64; 3]> {
    let at = |x: usize, y: usize, s: usize| f64::from(cube[s][y][x]);
    let gradient = [at(2, 1, 1) - at(0, 1, 1), at(1, 2, 1) - at(1, 0, 1), at(1, 1, 2) - at(1, 1, 0)].map(|d| d / 2.0);
    let centre = 2.0 * at(1, 1, 1);
    let [xx, yy, ss] = [at(2, 1, 1) + at(0, 1, 1) - centre, at(1, 2, 1) + at(1, 0, 1) - centre, at(1, 1, 2) + at(1, 1, 0) - centre];
    let xy = (at(2, 2, 1) + at(0, 0, 1) - at(0, 2, 1) - at(2, 0, 1)) / 4.0;
    let xs = (at(2, 1, 2) + at(0, 1, 0) - at(0, 1, 2) - at(2, 1, 0)) / 4.0;
    let ys = (at(1, 2, 2) + at(1, 0, 0) - at(1, 0, 2) - at(1, 2, 0)) / 4.0;
    let cofactors = [
        [yy * ss - ys * ys, xs * ys - xy * ss, xy * ys - xs * yy],
        [xs * ys - xy * ss, xx * ss - xs * xs, xy * xs - xx * ys],
        [xy * ys - xs * yy, xy * xs - xx * ys, xx * yy - xy * xy],
    ];
    let determinant = xx * cofactors[0][0] + xy * cofactors[0][1] + xs * cofactors[0][2];
    let offset = cofactors.map(|row| -(row[0] * gradient[0] + row[1] * gradient[1] + row[2] * gradient[2]) / determinant);
    offset.iter().all(|d| d.abs() <= 1.0).then_some(offset)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_top_of_a_quadratic_is_found() {
        let top = [0.3, -0.4, 0.2];
        let value = |x: f64, y: f64, s: f64| {
            let [dx, dy, ds] = [x - top[0], y - top[1], s - top[2]];
            9.0 - 2.0 * dx * dx - 1.5 * dy * dy - ds * ds + 0.5 * dx * dy - 0.25 * dy * ds + 0.125 * dx * ds
        };
        let cube: [[[f32; 3]; 3]; 3] = std::array::from_fn(|s| {
            std::array::from_fn(|y| std::array::from_fn(|x| value(x as f64 - 1.0, y as f64 - 1.0, s as f64 - 1.0) as f32))
        });
        let found = offset(&cube).unwrap();
        assert!((0..3).all(|k| (found[k] - top[k]).abs() < 1e-6), "{found:?}");
    }

    #[test]
    fn a_constant_has_no_top() {
        assert_eq!(offset(&[[[5.0; 3]; 3]; 3]), None);
    }
}
