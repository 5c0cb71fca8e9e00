//! Homographies: from four and more points, and in the search for consensus.

use super::least_direction::{by_rows, least_direction};
use super::refine::{Kind, Lines, refined};
use super::scale::{Conditions, NoiseLimits};
use super::transfer::{dlt_rows, lines, square_transfer};
use crate::math::{BLOCK, Candidate, Problem, null_space};
use crate::orientation::{Field, Ray};
use nalgebra::{Matrix3, SMatrix, SVector};
use std::ops::Range;

/// A random choice of this many observations refines a map during the search as well as all of them would.
pub(super) const REFINED_BY: usize = 250;

/// Least determinant of a homography of norm 1: below it a plane is seen from within itself.
const LEAST_DETERMINANT: f64 = 1e-9;

/// The homography of four points; `None` where three of them lie on a line.
pub(super) fn four_point(sample: &[Ray; 4]) -> Option<Matrix3<f64>> {
    let pairs = sample.map(|ray| dlt_rows(&ray));
    let [entries] = null_space::<8, 1>(std::array::from_fn(|k| pairs[k / 2][k % 2]))?;
    Some(Matrix3::from_row_slice(&entries)).filter(is_regular)
}

/// The homography that fulfils the conditions of four or more points best (direct linear transformation). `None` where they do not determine it.
/// Coordinates are normalised: their products are near 1.
///
/// # Source
/// Hartley & Zisserman 2004, Multiple View Geometry, 2nd ed., section 4.1.
pub(super) fn direct_linear(rays: &[Ray]) -> Option<Matrix3<f64>> {
    let mut sums = SMatrix::<f64, 9, 9>::zeros();
    for row in rays.iter().flat_map(dlt_rows) {
        for i in 0..9 {
            for j in i..9 {
                sums[(i, j)] += row[i] * row[j];
            }
        }
    }
    least_direction(sums).map(|entries| Matrix3::from_row_slice(&entries)).filter(is_regular)
}

fn is_regular(matrix: &Matrix3<f64>) -> bool {
    let norm = matrix.norm();
    matrix.determinant().abs() > LEAST_DETERMINANT * norm * norm * norm
}

/// The refinement of a homography: eight directions at right angles to its entries.
pub(super) struct Plane;

impl Kind<8> for Plane {
    const CONDITIONS: Conditions = Conditions::Two;

    fn tangents(&self, matrix: &Matrix3<f64>) -> [[f64; 9]; 8] {
        null_space::<1, 8>([by_rows(matrix)]).unwrap_or([[0.0; 9]; 8])
    }

    fn moved(&self, matrix: &Matrix3<f64>, step: &SVector<f64, 8>) -> Matrix3<f64> {
        let tangents = self.tangents(matrix);
        let moved = matrix + tangents.iter().zip(step.iter()).map(|(t, s)| Matrix3::from_row_slice(t) * *s).sum::<Matrix3<f64>>();
        moved / moved.norm()
    }

    fn lines(&self, matrix: &Matrix3<f64>, ray: &Ray) -> Option<Lines> {
        lines(matrix, ray)
    }

    fn square(&self, matrix: &Matrix3<f64>, ray: &Ray) -> f64 {
        square_transfer(matrix, ray)
    }
}

/// The search for a homography.
pub(super) struct Homographies<'a> {
    pub field: &'a Field,
    pub limits: NoiseLimits,
}

impl Problem for Homographies<'_> {
    type Model = Matrix3<f64>;
    const SAMPLE: usize = 4;

    fn count(&self) -> usize {
        self.field.rays.len()
    }

    fn drafts(&self, sample: &[usize], take: &mut dyn FnMut(Matrix3<f64>)) {
        four_point(&std::array::from_fn(|k| self.field.rays[sample[k]])).into_iter().for_each(take);
    }

    fn squares(&self, draft: &Matrix3<f64>, range: Range<usize>, squares: &mut [f64; BLOCK]) {
        squares.iter_mut().zip(&self.field.rays[range]).for_each(|(square, ray)| *square = square_transfer(draft, ray));
    }

    fn refined(&self, draft: &Matrix3<f64>, scale: f64) -> Option<Candidate<Matrix3<f64>>> {
        refined(&Plane, self.field, &Candidate { model: draft / draft.norm(), scale }, &self.limits, REFINED_BY)
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

    const TRUTH: [f64; 9] = [0.9, 0.2, 0.1, -0.15, 1.1, -0.2, 0.05, -0.08, 1.0];

    fn rays(count: usize, noise: f64) -> Vec<Ray> {
        let mut random = Random::new(6);
        let mut uniform = || random.below(1 << 20) as f64 / (1 << 19) as f64 - 1.0;
        let matrix = Matrix3::from_row_slice(&TRUTH);
        (0..count)
            .map(|_| {
                let (x, y) = (uniform(), uniform());
                let seen = matrix * nalgebra::Vector3::new(x, y, -1.0);
                [x, y, -seen.x / seen.z, -seen.y / seen.z].map(|v| v + noise * uniform())
            })
            .collect()
    }

    fn miss(found: &Matrix3<f64>) -> f64 {
        let truth = Matrix3::from_row_slice(&TRUTH);
        let (found, truth) = (found / found.norm(), truth / truth.norm());
        (found - truth).amax().min((found + truth).amax())
    }

    #[test]
    fn four_points_and_more_give_the_true_homography() {
        let four = rays(4, 0.0);
        assert!(miss(&four_point(&std::array::from_fn(|k| four[k])).unwrap()) < 1e-12);
        for count in [4, 5, 50] {
            assert!(miss(&direct_linear(&rays(count, 0.0)).unwrap()) < 1e-7, "{count}");
        }
    }

    #[test]
    fn points_on_a_line_give_none() {
        let on_a_line: [Ray; 4] = std::array::from_fn(|k| [k as f64, 2.0 * k as f64, 0.5 * k as f64, k as f64]);
        assert!(four_point(&on_a_line).is_none() && direct_linear(&on_a_line).is_none());
        assert!(four_point(&[[0.1, 0.2, 0.3, 0.4]; 4]).is_none());
    }

    #[test]
    fn refinement_finds_the_homography_of_noisy_points() {
        let all = rays(300, 1e-3);
        let field = Field::new(&all, 1);
        let limits = NoiseLimits { largest_threshold: 0.05, fixed: false };
        let start = Candidate { model: four_point(&std::array::from_fn(|k| field.rays[k])).unwrap(), scale: 0.02 };
        let found = refined(&Plane, &field, &start, &limits, 300).unwrap();
        assert!(miss(&found.model) < 5e-4 && miss(&found.model) < miss(&start.model), "{}", miss(&found.model));
        assert!((found.scale / (1e-3 / 3f64.sqrt()) - 1.0).abs() < 0.2, "{}", found.scale);
    }
}
