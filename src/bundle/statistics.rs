//! All cofactors and tests of one adjustment, from one inverse of its normal equations.

use super::adjustment::Adjusted;
use super::block::Block;
use super::datum::Freedoms;
use super::precision::{Cofactors, Inner, Matrix3};
use super::reduced::Problem;
use super::reliability::{Judged, Judgement};
use super::result::RayVerdict;
use super::solution::Factored;
use super::sparse::{Block6, N};
use crate::Error;

/// Cofactors of the unknowns in the datum, and what they say of the observations.
pub(super) struct Statistics {
    pub images: Vec<Block6>,
    /// Of the camera columns: the diagonal.
    pub cameras: Vec<f64>,
    /// Absent for points without accepted rays.
    pub points: Vec<Option<Matrix3>>,
    /// Column and row of each ray of the block; absent where its point has no accepted rays.
    pub rays: Vec<Option<[Judged; 2]>>,
}

/// Computes the statistics at adjusted values.
///
/// # Errors
/// [`Error::Degenerate`] where the undamped normal equations are singular.
pub(super) fn statistics(problem: &Problem<'_>, adjusted: &Adjusted, block: &Block, verdicts: &[RayVerdict]) -> Result<Statistics, Error> {
    let (state, network) = (&adjusted.state, problem.network);
    let mut reduced = problem.reduce(state, 0.0, adjusted.robust);
    let factored = Factored::new(&network.pattern, &mut reduced).map_err(|singular| problem.singular(singular))?;
    let cofactors = Cofactors::new(problem, &reduced, &factored);
    let inner = match problem.held {
        Some(_) => Some(Inner::new(problem, &reduced, &factored, Freedoms::new(network, state)?, state)),
        None => None,
    };
    let factors: Vec<f64> = network
        .sights
        .iter()
        .zip(problem.residuals(state))
        .map(|(sight, [x, y])| adjusted.robust.factor(sight.weight * (x * x + y * y)))
        .collect();
    let judgement = Judgement { problem, reduced: &reduced, cofactors: &cofactors, state };
    let mut rays = vec![None; block.rays.len()];
    // As they are while the block is held: rays do not see the datum.
    let mut coordinates = vec![None; network.points()];
    for point in 0..network.points() {
        let Some(common) = cofactors.of_point(point) else { continue };
        coordinates[point] = Some(cofactors.of_coordinates(point, &common));
        let sights = network.of_point(point);
        let judged = judgement.of_sights(point, &common, &factors[network.point_start[point]..]);
        sights.iter().zip(judged).for_each(|(sight, judged)| rays[sight.ray as usize] = Some(judged));
    }
    for ((ray, verdict), judged) in block.rays.iter().zip(verdicts).zip(&mut rays) {
        if *verdict != RayVerdict::Accepted
            && let Some(coordinates) = &coordinates[ray.point]
        {
            *judged = Some(judgement.of_outsider(ray, block.images[ray.image].camera, coordinates));
        }
    }
    let of_image = |image: usize| {
        let q = cofactors.of_images(image, image);
        inner.as_ref().map_or(q, |inner| inner.of_image(image, &state.images[image], &q))
    };
    let in_datum =
        |(point, q): (usize, Option<Matrix3>)| q.map(|q| inner.as_ref().map_or(q, |inner| inner.of_point(point, &state.points[point], &q)));
    let q = problem.columns.number();
    Ok(Statistics {
        images: (0..network.images()).map(of_image).collect(),
        cameras: (0..q).map(|k| cofactors.cameras[k * q + k]).collect(),
        points: coordinates.into_iter().enumerate().map(in_datum).collect(),
        rays,
    })
}

impl Statistics {
    /// Cofactors of the position of an image.
    pub fn of_position(&self, image: usize) -> [f64; 3] {
        [3, 4, 5].map(|k| self.images[image][k * N + k])
    }
}
