//! The relative orientations of five points.

use super::coplanarity::{Ray, condition};
use crate::math::{MAX_DEGREE, null_space, real_roots};
use nalgebra::Matrix3;

/// Up to ten essential matrices.
#[derive(Debug, Clone, Copy)]
pub(super) struct Essentials {
    matrices: [Matrix3<f64>; MAX_DEGREE],
    count: usize,
}

impl Essentials {
    pub fn as_slice(&self) -> &[Matrix3<f64>] {
        &self.matrices[..self.count]
    }
}

/// A polynomial of first degree in x, y, z: coefficients of x, y, z, 1.
type Linear = [f64; 4];
/// Coefficients of the products of two of (x, y, z, 1), in the order of [`QUADRATIC`].
type Quadratic = [f64; 10];
/// Coefficients of the products of three of (x, y, z, 1), in the order of [`CUBIC`].
type Cubic = [f64; 20];

/// Column of the product of factor i and factor j.
const QUADRATIC: [[usize; 4]; 4] = [[0, 1, 2, 3], [1, 4, 5, 6], [2, 5, 7, 8], [3, 6, 8, 9]];

/// Column of a quadratic monomial times a factor. The order of the columns is that of the elimination:
/// x³ y³ x²y xy² x²z x² y²z y² xyz xy, then xz² xz x yz² yz y z³ z² z 1, which stay.
const CUBIC: [[usize; 4]; 10] = [
    [0, 2, 4, 5],     // x²
    [2, 3, 8, 9],     // xy
    [4, 8, 10, 11],   // xz
    [5, 9, 11, 12],   // x
    [3, 1, 6, 7],     // y²
    [8, 6, 13, 14],   // yz
    [9, 7, 14, 15],   // y
    [10, 13, 16, 17], // z²
    [11, 14, 17, 18], // z
    [12, 15, 18, 19], // 1
];

/// All essential matrices E with q₂ᵀ E q₁ = 0 for five points; none where the five conditions depend on each other.
///
/// Points of a plane serve as well as others.
///
/// # Source
/// Nistér 2004, An efficient solution to the five-point relative pose problem, IEEE PAMI 26(6); the roots of the polynomial of degree ten
/// by enclosure between those of its derivatives instead of Sturm sequences.
pub(super) fn five_point(sample: &[Ray; 5]) -> Essentials {
    let mut essentials = Essentials { matrices: [Matrix3::zeros(); MAX_DEGREE], count: 0 };
    let Some(basis) = null_space(sample.map(|ray| condition(&ray))) else { return essentials };
    let Some(rows) = eliminated(constraints(&basis)) else {
        return essentials;
    };
    let table = [reduce(&rows[0], &rows[1]), reduce(&rows[2], &rows[3]), reduce(&rows[4], &rows[5])];
    for &z in real_roots(&determinant(&table)).as_slice() {
        let Some((x, y)) = back_substitute(&table, z) else { continue };
        let entries: [f64; 9] = std::array::from_fn(|k| basis[0][k] * x + basis[1][k] * y + basis[2][k] * z + basis[3][k]);
        let matrix = Matrix3::from_row_slice(&entries);
        let norm = matrix.norm();
        if norm.is_finite() && norm > 0.0 {
            essentials.matrices[essentials.count] = matrix / norm;
            essentials.count += 1;
        }
    }
    essentials
}

/// The ten cubic conditions of an essential matrix E = xX + yY + zZ + W: (EEᵀ - ½ tr(EEᵀ) I) E = 0 and det E = 0.
fn constraints(basis: &[[f64; 9]; 4]) -> [Cubic; 10] {
    let e: [[Linear; 3]; 3] = std::array::from_fn(|i| std::array::from_fn(|j| std::array::from_fn(|k| basis[k][3 * i + j])));
    let mut square = [[[0.0; 10]; 3]; 3];
    for i in 0..3 {
        for j in i..3 {
            for k in 0..3 {
                add_product(&mut square[i][j], &e[i][k], &e[j][k], 1.0);
            }
            square[j][i] = square[i][j];
        }
    }
    let half_trace: Quadratic = std::array::from_fn(|k| 0.5 * (square[0][0][k] + square[1][1][k] + square[2][2][k]));
    for i in 0..3 {
        (0..10).for_each(|k| square[i][i][k] -= half_trace[k]);
    }
    let mut rows = [[0.0; 20]; 10];
    for i in 0..3 {
        for j in 0..3 {
            for k in 0..3 {
                add_cubic(&mut rows[3 * i + j], &square[i][k], &e[k][j]);
            }
        }
    }
    for k in 0..3 {
        let mut minor = [0.0; 10];
        let (a, b) = ((k + 1) % 3, (k + 2) % 3);
        add_product(&mut minor, &e[1][a], &e[2][b], 1.0);
        add_product(&mut minor, &e[1][b], &e[2][a], -1.0);
        add_cubic(&mut rows[9], &minor, &e[0][k]);
    }
    rows
}

fn add_product(sum: &mut Quadratic, a: &Linear, b: &Linear, sign: f64) {
    for i in 0..4 {
        for j in 0..4 {
            sum[QUADRATIC[i][j]] += sign * a[i] * b[j];
        }
    }
}

fn add_cubic(sum: &mut Cubic, a: &Quadratic, b: &Linear) {
    for i in 0..10 {
        for j in 0..4 {
            sum[CUBIC[i][j]] += a[i] * b[j];
        }
    }
}

/// Gauss-Jordan elimination of the first ten columns; returns the last ten columns of the rows of x²z x² y²z y² xyz xy. `None` where the
/// conditions are singular.
fn eliminated(mut rows: [Cubic; 10]) -> Option<[[f64; 10]; 6]> {
    for column in 0..10 {
        let pivot = (column..10).max_by(|a, b| rows[*a][column].abs().total_cmp(&rows[*b][column].abs()))?;
        rows.swap(column, pivot);
        let divisor = rows[column][column];
        if !(divisor.abs() > 1e-15) {
            return None;
        }
        rows[column][column..].iter_mut().for_each(|v| *v /= divisor);
        let done = rows[column];
        for row in &mut rows[column + 1..] {
            subtract(row, &done, column);
        }
    }
    for column in (5..10).rev() {
        let done = rows[column];
        for row in &mut rows[4..column] {
            subtract(row, &done, column);
        }
    }
    Some(std::array::from_fn(|k| std::array::from_fn(|j| rows[4 + k][10 + j])))
}

fn subtract(row: &mut Cubic, done: &Cubic, column: usize) {
    let factor = row[column];
    for k in column..20 {
        row[k] -= factor * done[k];
    }
}

/// One equation in x, y, 1 whose coefficients are polynomials in z, lowest power first: of degree 3, 3 and 4.
struct Equation {
    x: [f64; 4],
    y: [f64; 4],
    one: [f64; 5],
}

/// `with_z` - z · `without_z`: the leading monomials cancel.
fn reduce(with_z: &[f64; 10], without_z: &[f64; 10]) -> Equation {
    let (a, b) = (with_z, without_z);
    Equation {
        x: [a[2], a[1] - b[2], a[0] - b[1], -b[0]],
        y: [a[5], a[4] - b[5], a[3] - b[4], -b[3]],
        one: [a[9], a[8] - b[9], a[7] - b[8], a[6] - b[7], -b[6]],
    }
}

/// Determinant of the three equations: the polynomial of degree ten in z.
fn determinant(table: &[Equation; 3]) -> [f64; MAX_DEGREE + 1] {
    let mut sum = [0.0; MAX_DEGREE + 1];
    for k in 0..3 {
        let (a, b) = (&table[(k + 1) % 3], &table[(k + 2) % 3]);
        let mut minor = [0.0; 7];
        for i in 0..4 {
            for j in 0..4 {
                minor[i + j] += a.x[i] * b.y[j] - a.y[i] * b.x[j];
            }
        }
        for (i, m) in minor.iter().enumerate() {
            for (j, c) in table[k].one.iter().enumerate() {
                sum[i + j] += m * c;
            }
        }
    }
    sum
}

/// x and y from the pair of equations that determines them best.
fn back_substitute(table: &[Equation; 3], z: f64) -> Option<(f64, f64)> {
    let value = |coefficients: &[f64]| coefficients.iter().rev().fold(0.0, |sum, c| sum * z + c);
    let rows: [[f64; 3]; 3] = std::array::from_fn(|k| [value(&table[k].x), value(&table[k].y), value(&table[k].one)]);
    let minor = |a: usize, b: usize| rows[a][0] * rows[b][1] - rows[a][1] * rows[b][0];
    let pairs = [(0, 1), (1, 2), (2, 0)];
    let (a, b) = pairs.into_iter().max_by(|p, q| minor(p.0, p.1).abs().total_cmp(&minor(q.0, q.1).abs()))?;
    let divisor = minor(a, b);
    let x = (rows[a][1] * rows[b][2] - rows[a][2] * rows[b][1]) / divisor;
    let y = (rows[a][2] * rows[b][0] - rows[a][0] * rows[b][2]) / divisor;
    (x.is_finite() && y.is_finite()).then_some((x, y))
}

#[cfg(test)]
mod tests {
    use super::super::coplanarity::RelativePose;
    use super::*;
    use crate::camera::rotation_from_angles;
    use crate::math::Random;
    use nalgebra::Vector3;

    fn sees(pose: &RelativePose, point: Vector3<f64>) -> Ray {
        let right = pose.rotation * (point - pose.base);
        [-point.x / point.z, -point.y / point.z, -right.x / right.z, -right.y / right.z]
    }

    /// The largest misfit over many samples of the best of the matrices found to the true one.
    fn worst_miss(relief: f64, kappa: f64) -> f64 {
        let mut random = Random::new(11);
        let mut uniform = |low: f64, high: f64| low + (high - low) * random.below(1 << 20) as f64 / (1 << 20) as f64;
        let mut misses: Vec<f64> = (0..300)
            .map(|_| {
                let angles = [uniform(-0.2, 0.2), uniform(-0.2, 0.2), kappa + uniform(-0.2, 0.2)];
                let base = Vector3::new(uniform(-1.0, 1.0), uniform(-1.0, 1.0), uniform(-0.3, 0.3)).normalize();
                let pose = RelativePose { rotation: rotation_from_angles(angles[0], angles[1], angles[2]), base };
                let sample = std::array::from_fn(|_| {
                    sees(&pose, Vector3::new(uniform(-2.0, 2.0), uniform(-2.0, 2.0), -3.0 + relief * uniform(-1.0, 1.0)))
                });
                let truth = pose.essential() / pose.essential().norm();
                let miss = |e: &Matrix3<f64>| (e - truth).amax().min((e + truth).amax());
                five_point(&sample).as_slice().iter().map(miss).fold(f64::INFINITY, f64::min)
            })
            .collect();
        misses.sort_by(f64::total_cmp);
        misses[297]
    }

    #[test]
    fn the_true_matrix_is_among_the_solutions() {
        for (relief, kappa) in [(1.0, 0.0), (0.1, 0.0), (0.5, 3.0)] {
            assert!(worst_miss(relief, kappa) < 1e-6, "relief {relief}, κ {kappa}: {}", worst_miss(relief, kappa));
        }
    }

    #[test]
    fn points_of_a_plane_serve() {
        assert!(worst_miss(0.0, 0.0) < 1e-6, "{}", worst_miss(0.0, 0.0));
    }

    #[test]
    fn every_solution_is_essential_and_fulfils_the_conditions() {
        let sample =
            [[0.1, 0.2, 0.0, 0.21], [-0.3, 0.1, -0.42, 0.1], [0.4, -0.3, 0.3, -0.28], [0.0, -0.1, -0.15, -0.1], [0.25, 0.3, 0.1, 0.33]];
        let found = five_point(&sample);
        assert!(!found.as_slice().is_empty());
        for e in found.as_slice() {
            let square = e * e.transpose();
            let misfit = (square * e - e * (0.5 * square.trace())).amax();
            assert!(misfit < 1e-9 && e.determinant().abs() < 1e-9, "{misfit}");
            for [xl, yl, xr, yr] in sample {
                let condition = Vector3::new(xr, yr, -1.0).dot(&(e * Vector3::new(xl, yl, -1.0)));
                assert!(condition.abs() < 1e-12, "{condition}");
            }
        }
    }

    #[test]
    fn equal_points_have_no_solution() {
        assert!(five_point(&[[0.1, 0.2, 0.3, 0.4]; 5]).as_slice().is_empty());
    }
}
