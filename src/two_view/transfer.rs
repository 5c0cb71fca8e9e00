//! The two conditions that a homography maps a left point to its right point.
//!
//! With (a, b, c) = G (x, y, -1) they are x' c + a = 0 and y' c + b = 0 for the right coordinates x', y'.

use super::refine::Lines;
use crate::orientation::Ray;
use nalgebra::Matrix3;

/// The coefficients by which the entries of G, row by row, enter both conditions.
pub(super) fn dlt_rows(&[x, y, u, v]: &Ray) -> [[f64; 9]; 2] {
    [[x, y, -1.0, 0.0, 0.0, 0.0, u * x, u * y, -u], [0.0, 0.0, 0.0, x, y, -1.0, v * x, v * y, -v]]
}

/// Both misclosures, and their cofactors `[first, mixed, second]` for coordinates of the same precision.
#[inline(always)]
fn misclosures(g: &Matrix3<f64>, &[x, y, u, v]: &Ray) -> ([f64; 2], [f64; 3]) {
    let (a, b) = (g[(0, 0)] * x + g[(0, 1)] * y - g[(0, 2)], g[(1, 0)] * x + g[(1, 1)] * y - g[(1, 2)]);
    let c = g[(2, 0)] * x + g[(2, 1)] * y - g[(2, 2)];
    let (first_x, first_y) = (u * g[(2, 0)] + g[(0, 0)], u * g[(2, 1)] + g[(0, 1)]);
    let (second_x, second_y) = (v * g[(2, 0)] + g[(1, 0)], v * g[(2, 1)] + g[(1, 1)]);
    let first = c * c + first_x * first_x + first_y * first_y;
    let second = c * c + second_x * second_x + second_y * second_y;
    ([u * c + a, v * c + b], [first, first_x * second_x + first_y * second_y, second])
}

/// Square of the distance of the four coordinates from both conditions, to first order.
///
/// # Source
/// Chum, Pajdla & Sturm 2005, The geometric error for homographies, CVIU 97(1) (Sampson's approximation).
#[inline(always)]
pub(super) fn square_transfer(g: &Matrix3<f64>, ray: &Ray) -> f64 {
    let ([first, second], [p, r, s]) = misclosures(g, ray);
    (s * first * first - 2.0 * r * first * second + p * second * second) / (p * s - r * r)
}

/// Both conditions, made independent and as precise as a coordinate.
pub(super) fn lines(g: &Matrix3<f64>, ray: &Ray) -> Option<Lines> {
    let ([first, second], [p, r, s]) = misclosures(g, ray);
    let [row, other] = dlt_rows(ray);
    // The inverse of the Cholesky factor of the cofactors.
    let l11 = p.sqrt();
    let l21 = r / l11;
    let l22 = (s - l21 * l21).sqrt();
    if !(l11 > 0.0 && l22 > 0.0) {
        return None;
    }
    let own = row.map(|v| v / l11);
    let independent = std::array::from_fn(|k| (other[k] - l21 * own[k]) / l22);
    let misclosure = first / l11;
    Some(([own, independent], [misclosure, (second - l21 * misclosure) / l22]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_distance_is_that_of_small_shifts_of_the_coordinates() {
        let g = Matrix3::new(0.9, 0.2, 0.1, -0.15, 1.1, -0.2, 0.05, -0.08, 1.0);
        let seen = g * nalgebra::Vector3::new(0.3, -0.4, -1.0);
        let exact: Ray = [0.3, -0.4, -seen.x / seen.z, -seen.y / seen.z];
        assert!(square_transfer(&g, &exact) < 1e-28);
        // Along a tangent of the map the distance stays 0 to first order; across it is the shift itself.
        let h = 1e-5;
        let shifted = |dx: f64| {
            let seen = g * nalgebra::Vector3::new(0.3 + dx, -0.4, -1.0);
            [0.3 + dx, -0.4, -seen.x / seen.z, -seen.y / seen.z]
        };
        assert!(square_transfer(&g, &shifted(h)) < 1e-18);
        let mut best = f64::INFINITY;
        let wrong = [exact[0], exact[1], exact[2] + h, exact[3]];
        for i in -200..=200 {
            for j in -200..=200 {
                let (x, y) = (0.3 + f64::from(i) * h / 200.0, -0.4 + f64::from(j) * h / 200.0);
                let seen = g * nalgebra::Vector3::new(x, y, -1.0);
                let on = [x, y, -seen.x / seen.z, -seen.y / seen.z];
                best = f64::min(best, (0..4).map(|k| (on[k] - wrong[k]) * (on[k] - wrong[k])).sum());
            }
        }
        assert!((square_transfer(&g, &wrong) / best - 1.0).abs() < 1e-3, "{} {best}", square_transfer(&g, &wrong));
        let (_, [a, b]) = lines(&g, &wrong).unwrap();
        assert!(((a * a + b * b) / square_transfer(&g, &wrong) - 1.0).abs() < 1e-9);
    }
}
