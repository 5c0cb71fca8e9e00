//! The orientations of an image by three points.

use crate::camera::Pose;
use crate::math::{MAX_DEGREE, real_roots};
use crate::math::{cross, dot3, minus};

/// Steps that make the distances exact.
const POLISHINGS: usize = 3;
/// A polished triangle fits to this share of its sides.
const FITTING: f64 = 1e-6;

/// All poses, up to four, from which `points` are seen in the `directions` of the photo's system, of length 1. None where the points or the
/// directions lie on a line.
///
/// # Source
/// Grunert 1841, Das Pothenotische Problem in erweiterter Gestalt; the quartic as Haralick, Lee, Ottenberg & Nölle 1994 print it, IJCV 13(3).
pub(super) fn p3p(directions: &[[f64; 3]; 3], points: &[[f64; 3]; 3]) -> Vec<Pose> {
    let [d1, d2, d3] = directions;
    let cosines = [dot3(d2, d3), dot3(d1, d3), dot3(d1, d2)];
    let side = |a: usize, b: usize| {
        let d = minus(&points[a], &points[b]);
        dot3(&d, &d)
    };
    let sides = [side(1, 2), side(0, 2), side(0, 1)];
    if !(sides.iter().all(|s| *s > 0.0 && s.is_finite())) {
        return Vec::new();
    }
    let distances =
        real_roots(&quartic(&cosines, &sides)).as_slice().iter().filter_map(|v| distances(*v, &cosines, &sides)).collect::<Vec<_>>();
    distances.into_iter().filter_map(|s| pose(directions, points, &s)).collect()
}

/// Coefficients in v, the third distance by the first, lowest power first.
fn quartic([ca, cb, cg]: &[f64; 3], [a2, b2, c2]: &[f64; 3]) -> [f64; MAX_DEGREE + 1] {
    let (p, q) = ((a2 - c2) / b2, (a2 + c2) / b2);
    let mut polynomial = [0.0; MAX_DEGREE + 1];
    polynomial[4] = (p - 1.0) * (p - 1.0) - 4.0 * c2 / b2 * ca * ca;
    polynomial[3] = 4.0 * (p * (1.0 - p) * cb - (1.0 - q) * ca * cg + 2.0 * c2 / b2 * ca * ca * cb);
    polynomial[2] = 2.0
        * (p * p - 1.0 + 2.0 * p * p * cb * cb + 2.0 * (b2 - c2) / b2 * ca * ca - 4.0 * q * ca * cb * cg + 2.0 * (b2 - a2) / b2 * cg * cg);
    polynomial[1] = 4.0 * (-p * (1.0 + p) * cb + 2.0 * a2 / b2 * cg * cg * cb - (1.0 - q) * ca * cg);
    polynomial[0] = (1.0 + p) * (1.0 + p) - 4.0 * a2 / b2 * cg * cg;
    polynomial
}

/// The distances of the three points that belong to a root.
fn distances(v: f64, cosines: &[f64; 3], sides: &[f64; 3]) -> Option<[f64; 3]> {
    let ([ca, cb, cg], [a2, b2, c2]) = (cosines, sides);
    let p = (a2 - c2) / b2;
    let u = ((p - 1.0) * v * v - 2.0 * p * cb * v + 1.0 + p) / (2.0 * (cg - v * ca));
    let first2 = b2 / (1.0 + v * v - 2.0 * v * cb);
    if !(v > 0.0 && u > 0.0 && first2 > 0.0 && u.is_finite() && first2.is_finite()) {
        return None;
    }
    let first = first2.sqrt();
    let mut s = [first, u * first, v * first];
    for _ in 0..POLISHINGS {
        s = polished(s, cosines, sides)?;
    }
    let fits = misclosures(&s, cosines, sides).iter().zip(sides).all(|(off, side)| off.abs() <= FITTING * side);
    (fits && s.iter().all(|s| *s > 0.0)).then_some(s)
}

/// What the triangle of the distances is off from the sides, squared: by the law of cosines.
fn misclosures(s: &[f64; 3], cosines: &[f64; 3], sides: &[f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|k| {
        let (a, b) = ((k + 1) % 3, (k + 2) % 3);
        s[a] * s[a] + s[b] * s[b] - 2.0 * s[a] * s[b] * cosines[k] - sides[k]
    })
}

/// Newton's step.
fn polished(s: [f64; 3], cosines: &[f64; 3], sides: &[f64; 3]) -> Option<[f64; 3]> {
    let f = misclosures(&s, cosines, sides);
    let mut jacobian = nalgebra::Matrix3::zeros();
    for k in 0..3 {
        let (a, b) = ((k + 1) % 3, (k + 2) % 3);
        jacobian[(k, a)] = 2.0 * (s[a] - s[b] * cosines[k]);
        jacobian[(k, b)] = 2.0 * (s[b] - s[a] * cosines[k]);
    }
    let Some(inverse) = jacobian.try_inverse() else { return Some(s) };
    let step = inverse * nalgebra::Vector3::from(f);
    let next = [0, 1, 2].map(|k| s[k] - step[k]);
    next.iter().all(|v| v.is_finite()).then_some(next)
}

/// The pose in which the points lie at these distances in their directions: both triangles have the same axes.
fn pose(directions: &[[f64; 3]; 3], points: &[[f64; 3]; 3], distances: &[f64; 3]) -> Option<Pose> {
    let seen = [0, 1, 2].map(|k| directions[k].map(|d| d * distances[k]));
    let (inside, outside) = (axes(&seen)?, axes(points)?);
    // M takes the object's axes to the photo's: columns of one by rows of the other.
    let rotation = [0, 1, 2].map(|r| [0, 1, 2].map(|c| (0..3).map(|k| inside[k][r] * outside[k][c]).sum::<f64>()));
    let back = |v: &[f64; 3]| [0, 1, 2].map(|c| (0..3).map(|r| rotation[r][c] * v[r]).sum::<f64>());
    Some(Pose { rotation, position: minus(&points[0], &back(&seen[0])) })
}

/// Right-handed axes of unit length of a triangle: along its first side, in its plane, across. `None` for points on a line.
fn axes(corners: &[[f64; 3]; 3]) -> Option<[[f64; 3]; 3]> {
    let unit = |v: [f64; 3]| {
        let length = dot3(&v, &v).sqrt();
        (length > 0.0 && length.is_finite()).then(|| v.map(|x| x / length))
    };
    let (first, second) = (unit(minus(&corners[1], &corners[0]))?, unit(minus(&corners[2], &corners[0]))?);
    let across = cross(&first, &second);
    if !(dot3(&across, &across) > 1e-12) {
        return None;
    }
    let across = unit(across)?;
    Some([first, cross(&across, &first), across])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::camera::rotation_from_angles;
    use crate::math::Random;

    #[test]
    fn the_true_pose_is_among_those_of_three_points() {
        let mut random = Random::new(8);
        let mut uniform = || random.below(1 << 24) as f64 / (1 << 23) as f64 - 1.0;
        let mut found = 0;
        for _ in 0..300 {
            let m = rotation_from_angles(3.0 * uniform(), uniform(), 3.0 * uniform());
            let rotation = [0, 1, 2].map(|r| [0, 1, 2].map(|c| m[(r, c)]));
            let pose = Pose { rotation, position: [50.0 * uniform(), 50.0 * uniform(), 50.0 * uniform()] };
            let seen = [0, 1, 2].map(|_| [40.0 * uniform(), 40.0 * uniform(), -100.0 + 20.0 * uniform()]);
            let points = seen.map(|p| [0, 1, 2].map(|c| pose.position[c] + (0..3).map(|r| rotation[r][c] * p[r]).sum::<f64>()));
            let directions = seen.map(|p| p.map(|v| v / dot3(&p, &p).sqrt()));
            let poses = p3p(&directions, &points);
            for candidate in &poses {
                for k in 0..3 {
                    let at = candidate.to_photo(&points[k]);
                    let length = dot3(&at, &at).sqrt();
                    assert!((0..3).all(|i| (at[i] / length - directions[k][i]).abs() < 1e-6), "{at:?} {:?}", directions[k]);
                }
            }
            let near = |p: &Pose| (0..3).all(|k| (p.position[k] - pose.position[k]).abs() < 1e-3);
            found += usize::from(poses.iter().any(near));
        }
        assert!(found >= 298, "{found} of 300");
    }

    #[test]
    fn points_on_a_line_give_no_pose() {
        let directions = [[0.1, 0.0, -1.0], [0.0, 0.0, -1.0], [-0.1, 0.0, -1.0]].map(|d: [f64; 3]| d.map(|v| v / dot3(&d, &d).sqrt()));
        assert!(p3p(&directions, &[[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]]).is_empty());
        assert!(p3p(&directions, &[[0.0; 3]; 3]).is_empty());
    }
}
