//! All cofactors and tests of one adjustment, from one inverse of its normal equations.

use super::block::Block;
use super::datum::Freedoms;
use super::gauss_newton::Adjusted;
use super::precision::{Cofactors, Inner, Matrix3, Orientations};
use super::reduced::Problem;
use super::reliability::{Judged, Judgement};
use super::result::ObservationVerdict;
use super::solution::Factored;
use super::sparse::{Block6, N};
use crate::Error;

/// Cofactors of the unknowns in the datum, and what they say of the observations.
pub(super) struct Statistics {
    pub images: Vec<Block6>,
    /// Of X, Y, Z of the antenna of each image: of its projection centre where no systematic errors of positions are estimated.
    antennas: Vec<[f64; 3]>,
    /// Of the camera columns, row by row.
    pub cameras: Vec<f64>,
    /// Absent for points without accepted rays.
    pub points: Vec<Option<Matrix3>>,
    /// Column and row of each ray of the block; absent where its point has no accepted rays.
    pub rays: Vec<Option<[Judged; 2]>>,
}

/// What the rays of a block are told by cofactors.
pub(super) struct JudgedRays {
    /// Column and row of each ray of the block; absent where its point has no accepted rays.
    pub rays: Vec<Option<[Judged; 2]>>,
    /// Cofactors of each point while the block is held: rays do not see the datum.
    coordinates: Vec<Option<Matrix3>>,
}

/// Judges all rays at adjusted values.
fn judge(cofactors: &Cofactors<'_>, adjusted: &Adjusted, block: &Block, verdicts: &[ObservationVerdict]) -> JudgedRays {
    let (state, network) = (&adjusted.state, cofactors.problem.network);
    let factors: Vec<f64> = network
        .sights
        .iter()
        .zip(cofactors.problem.residuals(state))
        .map(|(sight, [x, y])| adjusted.robust.factor(sight.weight * (x * x + y * y)))
        .collect();
    let judgement = Judgement { cofactors, state };
    let mut rays = vec![None; block.rays.len()];
    let mut coordinates = vec![None; network.points()];
    let mut outsiders = vec![Vec::new(); network.points()];
    for (index, (ray, _)) in
        block.rays.iter().zip(verdicts).enumerate().filter(|(_, (_, verdict))| **verdict != ObservationVerdict::Accepted)
    {
        outsiders[ray.point].push(index);
    }
    for point in 0..network.points() {
        let Some(common) = cofactors.of_point(point) else { continue };
        coordinates[point] = Some(cofactors.of_coordinates(point, &common));
        let sights = network.of_point(point);
        let judged = judgement.of_sights(point, &common, &factors[network.point_start[point]..]);
        sights.iter().zip(judged).for_each(|(sight, judged)| rays[sight.ray as usize] = Some(judged));
        for index in &outsiders[point] {
            let ray = &block.rays[*index];
            rays[*index] = Some(judgement.of_outsider(ray, block.images[ray.image].camera, &common));
        }
    }
    JudgedRays { rays, coordinates }
}

/// Judges all rays by the cofactors that orientations had with nearly the same rays: without a factorisation and its inverse.
pub(super) fn judge_by(
    orientations: &Orientations,
    problem: &Problem<'_>,
    adjusted: &Adjusted,
    block: &Block,
    verdicts: &[ObservationVerdict],
) -> JudgedRays {
    let reduced = problem.eliminated(&adjusted.state, 0.0, adjusted.robust);
    judge(&Cofactors { problem, reduced: &reduced, orientations }, adjusted, block, verdicts)
}

/// Computes the statistics at adjusted values; gives them with the factor and the cofactors of orientations that they are from.
///
/// # Errors
/// [`Error::Degenerate`] where the undamped normal equations are singular.
pub(super) fn statistics(
    problem: &Problem<'_>,
    adjusted: &Adjusted,
    block: &Block,
    verdicts: &[ObservationVerdict],
) -> Result<(Statistics, Factored, Orientations), Error> {
    let (state, network) = (&adjusted.state, problem.network);
    let mut reduced = problem.reduce(state, 0.0, adjusted.robust);
    let factored = Factored::new(&network.pattern, &mut reduced).map_err(|singular| problem.singular(singular))?;
    let orientations = Orientations::new(problem, &factored);
    let cofactors = Cofactors { problem, reduced: &reduced, orientations: &orientations };
    let inner = match problem.held {
        Some(_) => Some(Inner::new(problem, &reduced, &factored, Freedoms::new(network, state)?, state)),
        None => None,
    };
    let JudgedRays { rays, coordinates } = judge(&cofactors, adjusted, block, verdicts);
    let of_image = |image: usize| {
        let q = cofactors.of_images(image, image);
        inner.as_ref().map_or(q, |inner| inner.of_image(image, &state.images[image], &q))
    };
    let in_datum =
        |(point, q): (usize, Option<Matrix3>)| q.map(|q| inner.as_ref().map_or(q, |inner| inner.of_point(point, &state.points[point], &q)));
    let images: Vec<Block6> = (0..network.images()).map(of_image).collect();
    let statistics = Statistics {
        antennas: images.iter().enumerate().map(|(image, own)| cofactors.of_antenna(image, own, state)).collect(),
        images,
        cameras: orientations.cameras.clone(),
        points: coordinates.into_iter().enumerate().map(in_datum).collect(),
        rays,
    };
    Ok((statistics, factored, orientations))
}

impl Statistics {
    /// Cofactors of what the position of an image observes.
    pub fn of_position(&self, image: usize) -> [f64; 3] {
        self.antennas[image]
    }
}

/// Correlations of the coordinates of the position of an image by its cofactors: the first with the second, the first with the third, the
/// second with the third.
pub(super) fn correlations_of_position(cofactors: &Block6) -> [f64; 3] {
    let q = |row: usize, column: usize| cofactors[column * N + row];
    [(3, 4), (3, 5), (4, 5)].map(|(row, column)| correlation(q(row, column), q(row, row), q(column, column)))
}

/// The same of an object point.
pub(super) fn correlations_of_point(cofactors: &Matrix3) -> [f64; 3] {
    [(0, 1), (0, 2), (1, 2)].map(|(row, column)| correlation(cofactors[row][column], cofactors[row][row], cofactors[column][column]))
}

/// Of two unknowns by their cofactors; 0 where one has no variance.
pub(super) fn correlation(common: f64, first: f64, second: f64) -> f64 {
    let product = first * second;
    if product > 0.0 { (common / product.sqrt()).clamp(-1.0, 1.0) } else { 0.0 }
}
