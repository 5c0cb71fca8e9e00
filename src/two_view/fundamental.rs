//! Fundamental matrices: from eight and from seven points, and in the search for consensus.

use super::least_direction::{by_rows, least_direction};
use super::refine::{Kind, Lines, refined};
use super::scale::{Conditions, NoiseLimits};
use crate::math::{BLOCK, Candidate, MAX_DEGREE, Problem, null_space, real_roots};
use crate::orientation::{Field, Ray, condition, square_distance};
use nalgebra::{Matrix3, SMatrix, SVector};
use std::ops::Range;

/// All matrices with q₂ᵀ F q₁ = 0 for seven points and det F = 0: one or three. None where the conditions depend on each other.
///
/// # Source
/// Hartley 1994, Projective reconstruction and invariants from multiple images, IEEE PAMI 16(10).
pub(super) fn seven_point(sample: &[Ray; 7]) -> Vec<Matrix3<f64>> {
    let Some([a, b]) = null_space::<7, 2>(sample.map(|ray| condition(&ray))) else { return Vec::new() };
    let (a, b) = (Matrix3::from_row_slice(&a), Matrix3::from_row_slice(&b));
    // det(a + z b) by powers of z; the derivative of a determinant is the sum of the products with its cofactors.
    let mut cubic = [0.0; MAX_DEGREE + 1];
    cubic[..4].copy_from_slice(&[a.determinant(), cofactors(&a).dot(&b), cofactors(&b).dot(&a), b.determinant()]);
    real_roots(&cubic).as_slice().iter().map(|z| a + b * *z).map(|f| f / f.norm()).filter(|f| f.iter().all(|v| v.is_finite())).collect()
}

fn cofactors(m: &Matrix3<f64>) -> Matrix3<f64> {
    let (a, b, c) = (m.row(0).transpose(), m.row(1).transpose(), m.row(2).transpose());
    Matrix3::from_rows(&[b.cross(&c).transpose(), c.cross(&a).transpose(), a.cross(&b).transpose()])
}

/// The matrix of rank 2 nearest to the one that fulfils the conditions of eight or more points best. `None` where they do not determine it.
/// Coordinates are normalised: their products are near 1.
///
/// # Source
/// Hartley 1997, In defense of the eight-point algorithm, IEEE PAMI 19(6).
pub(super) fn eight_point(rays: &[Ray]) -> Option<Matrix3<f64>> {
    let mut sums = SMatrix::<f64, 9, 9>::zeros();
    for ray in rays {
        let row = condition(ray);
        for i in 0..9 {
            for j in i..9 {
                sums[(i, j)] += row[i] * row[j];
            }
        }
    }
    let matrix = Matrix3::from_row_slice(&least_direction(sums)?);
    Some(RankTwo::nearest(&matrix)?.matrix())
}

/// A matrix U diag(cos θ, sin θ, 0) Vᵀ.
#[derive(Debug, Clone, Copy)]
struct RankTwo {
    u: Matrix3<f64>,
    v: Matrix3<f64>,
    cos: f64,
    sin: f64,
}

impl RankTwo {
    /// The nearest one to a matrix, of norm 1.
    fn nearest(matrix: &Matrix3<f64>) -> Option<Self> {
        if !matrix.iter().all(|v| v.is_finite()) {
            return None;
        }
        let svd = matrix.svd(true, true);
        let (u, v, values) = (svd.u?, svd.v_t?.transpose(), svd.singular_values);
        let mut order = [0, 1, 2];
        order.sort_by(|a, b| values[*b].total_cmp(&values[*a]));
        let sorted = |m: &Matrix3<f64>| Matrix3::from_columns(&order.map(|k| m.column(k).into_owned()));
        let (first, second) = (values[order[0]], values[order[1]]);
        let norm = (first * first + second * second).sqrt();
        (norm > 0.0).then(|| Self { u: sorted(&u), v: sorted(&v), cos: first / norm, sin: second / norm })
    }

    fn matrix(&self) -> Matrix3<f64> {
        self.u * Matrix3::from_diagonal(&nalgebra::Vector3::new(self.cos, self.sin, 0.0)) * self.v.transpose()
    }
}

/// The refinement of a fundamental matrix: small turns of U and of V, and θ.
///
/// # Source
/// Bartoli & Sturm 2004, Non-linear estimation of the fundamental matrix with minimal parameters, IEEE PAMI 26(3).
pub(super) struct Epipolar;

impl Kind<7> for Epipolar {
    const CONDITIONS: Conditions = Conditions::One;

    fn tangents(&self, matrix: &Matrix3<f64>) -> [[f64; 9]; 7] {
        let Some(RankTwo { u, v, cos, sin }) = RankTwo::nearest(matrix) else { return [[0.0; 9]; 7] };
        let diagonal = |a: f64, b: f64| Matrix3::from_diagonal(&nalgebra::Vector3::new(a, b, 0.0));
        let turn = |k: usize| nalgebra::Vector3::ith(k, 1.0).cross_matrix();
        std::array::from_fn(|k| {
            let inner = match k {
                0..3 => turn(k) * diagonal(cos, sin),
                3..6 => diagonal(cos, sin) * turn(k - 3),
                _ => diagonal(-sin, cos),
            };
            by_rows(&(u * inner * v.transpose()))
        })
    }

    fn moved(&self, matrix: &Matrix3<f64>, step: &SVector<f64, 7>) -> Matrix3<f64> {
        let change = self.tangents(matrix).iter().zip(step.iter()).map(|(t, s)| Matrix3::from_row_slice(t) * *s).sum::<Matrix3<f64>>();
        RankTwo::nearest(&(matrix / matrix.norm() + change)).map_or(*matrix, |near| near.matrix())
    }

    fn lines(&self, matrix: &Matrix3<f64>, ray: &Ray) -> Option<Lines> {
        let row = condition(ray);
        let value: f64 = (0..9).map(|k| row[k] * matrix[(k / 3, k % 3)]).sum();
        let distance = square_distance(matrix, *ray).sqrt();
        // The distance is the value by its gradient.
        let gradient = value.abs() / distance;
        let gradient = if gradient.is_finite() && gradient > 0.0 { gradient } else { return None };
        Some(([row.map(|v| v / gradient), [0.0; 9]], [value / gradient, 0.0]))
    }

    fn square(&self, matrix: &Matrix3<f64>, ray: &Ray) -> f64 {
        square_distance(matrix, *ray)
    }
}

/// The search for a fundamental matrix.
pub(super) struct Fundamentals<'a> {
    pub field: &'a Field,
    pub limits: NoiseLimits,
}

/// A random choice of this many observations refines a matrix during the search as well as all of them would.
const REFINED_BY: usize = 500;

impl Problem for Fundamentals<'_> {
    type Model = Matrix3<f64>;
    const SAMPLE: usize = 7;

    fn count(&self) -> usize {
        self.field.rays.len()
    }

    fn drafts(&self, sample: &[usize], take: &mut dyn FnMut(Matrix3<f64>)) {
        seven_point(&std::array::from_fn(|k| self.field.rays[sample[k]])).into_iter().for_each(take);
    }

    fn squares(&self, draft: &Matrix3<f64>, range: Range<usize>, squares: &mut [f64; BLOCK]) {
        self.field.squares(draft, range, squares);
    }

    fn refined(&self, draft: &Matrix3<f64>, scale: f64) -> Option<Candidate<Matrix3<f64>>> {
        refined(&Epipolar, self.field, &Candidate { model: *draft, scale }, &self.limits, REFINED_BY)
    }

    fn draft_of(&self, model: &Matrix3<f64>) -> Matrix3<f64> {
        *model
    }

    fn penalty(&self, _: &Matrix3<f64>, _: f64) -> f64 {
        0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Random;

    /// Seven or more points seen from two places.
    fn rays(count: usize, seed: u32) -> (Vec<Ray>, Matrix3<f64>) {
        let mut random = Random::new(seed);
        let mut uniform = |low: f64, high: f64| low + (high - low) * random.below(1 << 20) as f64 / (1 << 20) as f64;
        let rotation = crate::camera::rotation_from_angles(uniform(-0.3, 0.3), uniform(-0.3, 0.3), uniform(-3.0, 3.0));
        let base = nalgebra::Vector3::new(uniform(-1.0, 1.0), uniform(-1.0, 1.0), uniform(-0.5, 0.5));
        let see = |_| {
            let point = nalgebra::Vector3::new(uniform(-2.0, 2.0), uniform(-2.0, 2.0), uniform(-5.0, -2.0));
            let right = rotation * (point - base);
            [-point.x / point.z, -point.y / point.z, -right.x / right.z, -right.y / right.z]
        };
        let rays = (0..count).map(see).collect();
        let truth = rotation * base.cross_matrix();
        (rays, truth / truth.norm())
    }

    fn miss(found: &Matrix3<f64>, truth: &Matrix3<f64>) -> f64 {
        (found - truth).amax().min((found + truth).amax())
    }

    #[test]
    fn the_true_matrix_is_among_those_of_seven_points() {
        for seed in 0..100 {
            let (rays, truth) = rays(7, seed);
            let found = seven_point(&std::array::from_fn(|k| rays[k]));
            assert!((1..=3).contains(&found.len()));
            assert!(found.iter().any(|f| miss(f, &truth) < 1e-6), "seed {seed}");
            assert!(found.iter().all(|f| f.determinant().abs() < 1e-9));
        }
    }

    #[test]
    fn eight_points_and_more_give_the_true_matrix() {
        for (seed, count) in (0..50).zip([8, 9, 20, 200].into_iter().cycle()) {
            let (rays, truth) = rays(count, seed);
            let found = eight_point(&rays).unwrap();
            assert!(miss(&found, &truth) < 1e-6, "seed {seed}: {}", miss(&found, &truth));
        }
        assert!(eight_point(&[[0.1, 0.2, 0.3, 0.4]; 9]).is_none());
        assert!(seven_point(&[[0.1, 0.2, 0.3, 0.4]; 7]).is_empty());
    }

    #[test]
    fn tangents_are_small_differences_of_matrices_of_rank_two() {
        let (_, truth) = rays(1, 5);
        let h = 1e-6;
        for (k, tangent) in Epipolar.tangents(&truth).iter().enumerate() {
            let step = |sign: f64| Epipolar.moved(&truth, &SVector::from_fn(|i, _| if i == k { sign * h } else { 0.0 }));
            let numeric = (step(1.0) - step(-1.0)) / (2.0 * h);
            assert!((numeric - Matrix3::from_row_slice(tangent)).amax() < 1e-5, "{k}");
            assert!(step(1.0).determinant().abs() < 1e-15);
        }
    }

    #[test]
    fn refinement_finds_the_matrix_of_noisy_points() {
        let (mut all, truth) = rays(400, 11);
        let mut random = Random::new(1);
        all.iter_mut().flatten().for_each(|v| *v += 1e-4 * (random.below(2001) as f64 / 1000.0 - 1.0));
        let field = Field::new(&all, 1);
        let (rays, limits) = (field.rays[..8].to_vec(), NoiseLimits { largest_threshold: 1e-2, fixed: false });
        let start = Candidate { model: eight_point(&rays).unwrap(), scale: 3e-3 };
        let found = refined(&Epipolar, &field, &start, &limits, 400).unwrap();
        assert!(miss(&found.model, &truth) < 1e-3 && miss(&found.model, &truth) < miss(&start.model, &truth));
        assert!((found.scale / (1e-4 / 3f64.sqrt()) - 1.0).abs() < 0.2, "{}", found.scale);
    }
}
