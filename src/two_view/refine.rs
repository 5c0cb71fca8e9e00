//! A matrix refined by reweighted least squares, whatever its unknowns and conditions are.

use super::scale::{Conditions, NoiseLimits, search_scale};
use crate::math::Candidate;
use crate::orientation::{Field, Normals, Ray};
use nalgebra::{Matrix3, SVector};

/// What a matrix demands of an observation, linearised: rows over the entries of the matrix, and misclosures in the unit of coordinates.
pub(super) type Lines = ([[f64; 9]; 2], [f64; 2]);

/// A kind of matrix with `N` unknowns.
pub(super) trait Kind<const N: usize> {
    const CONDITIONS: Conditions;

    /// The derivatives of the matrix by its unknowns, each by rows.
    fn tangents(&self, matrix: &Matrix3<f64>) -> [[f64; 9]; N];
    /// The matrix after a step of the unknowns.
    fn moved(&self, matrix: &Matrix3<f64>, step: &SVector<f64, N>) -> Matrix3<f64>;
    /// The conditions of an observation, independent and of the same precision as a coordinate; `None` where it says nothing. Of a single
    /// condition the second line is zeros.
    fn lines(&self, matrix: &Matrix3<f64>, ray: &Ray) -> Option<Lines>;
    /// Square of the distance of an observation.
    fn square(&self, matrix: &Matrix3<f64>, ray: &Ray) -> f64;
}

/// Steps of the refinement; it gains little after the first few.
const STEPS: usize = 8;

/// Standard errors beyond which an observation has no weight.
const FARTHEST: f64 = 8.0;

/// Refines a matrix by the first `count` observations, weights 1 / (1 + d²/s²), s following the
/// distances. `None` where the unknowns are not determined.
pub(super) fn refined<const N: usize, K: Kind<N>>(
    kind: &K,
    field: &Field,
    start: &Candidate<Matrix3<f64>>,
    limits: &NoiseLimits,
    count: usize,
) -> Option<Candidate<Matrix3<f64>>> {
    let rays = &field.rays[..count.min(field.rays.len())];
    let distances = |matrix: &Matrix3<f64>| rays.iter().map(|ray| kind.square(matrix, ray).sqrt()).collect::<Vec<_>>();
    let scale = |matrix: &Matrix3<f64>| search_scale(&distances(matrix), K::CONDITIONS, limits);
    let mut found = Candidate { model: start.model, scale: scale(&start.model) };
    for step in 0..STEPS {
        let tangents = kind.tangents(&found.model);
        let weight_at = 1.0 / (found.scale * found.scale);
        let mut normals = Normals::<N>::new();
        for (rows, misclosures) in rays.iter().filter_map(|ray| kind.lines(&found.model, ray)) {
            let square = misclosures[0] * misclosures[0] + misclosures[1] * misclosures[1];
            let ratio = square * weight_at;
            // What lies far off would weigh little each, but there may be many of it.
            if ratio > FARTHEST * FARTHEST {
                continue;
            }
            let weight = 1.0 / (1.0 + ratio);
            for (row, misclosure) in rows.iter().zip(misclosures).take(K::CONDITIONS.count()) {
                let by_unknowns = SVector::<f64, N>::from_fn(|k, _| (0..9).map(|j| tangents[k][j] * row[j]).sum());
                normals.add(&by_unknowns, misclosure, weight);
            }
        }
        let Ok(solution) = normals.solve() else { return (step > 0).then_some(found) };
        let matrix = kind.moved(&found.model, &(solution.step * (0.5 / solution.step.norm()).min(1.0)));
        found = Candidate { scale: scale(&matrix), model: matrix };
        if solution.size < 0.05 * found.scale {
            break;
        }
    }
    found.model.iter().all(|v| v.is_finite()).then_some(found)
}
