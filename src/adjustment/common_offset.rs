//! What all GNSS positions of an adjusted block are off by alike, as its residuals tell it without another adjustment.
//!
//! Observations that have an error C∇ in common leave residuals v of which ∇ = (CᵀPQᵥᵥPC)⁻¹ CᵀPv follows. Precise positions take the block with them:
//! their own residuals hardly show what they are off by, and PQᵥᵥP knows how little.
//!
//! # Source
//! Baarda 1968, A testing procedure for use in geodetic networks; Teunissen 2006, Testing theory, 4.

use super::adjusted_equations::Solved;
use super::block::Block;
use super::reliability::LEAST_REDUNDANCY;
use super::result::{AdjustmentResult, PriorStatistics};
use super::solution::Step;
use super::sparse::N;
use super::weighted::Weighted;
use crate::Error;
use crate::math::{median, scatter};
use nalgebra::{Matrix3, Vector3};

/// An offset is not determined where so little of the weight of the positions is left to tell it.
const LEAST_LEFT: f64 = 1e-9;
/// Residuals, at least, whose median size tells their scatter.
const LEAST_RESIDUALS: usize = 4;

/// What all positions are off by along an axis, in the unit of the block.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct CommonOffset {
    pub value: f64,
    /// Larger where residuals scatter by more than the standard errors that were stated.
    pub error: f64,
    /// How far the images have followed it, in the median.
    pub followed: f64,
}

impl AdjustmentResult {
    /// Of the positions that take part along X, Y, Z; none along an axis where nothing else tells it. `block`, `accepted`: as covariances take them. The
    /// adjustment estimated no systematic errors of positions.
    ///
    /// # Errors
    /// As covariances.
    pub(crate) fn common_offset(&self, block: &Block, accepted: &[bool]) -> Result<[Option<CommonOffset>; 3], Error> {
        self.with_equations(block, accepted, |solved| {
            let positions = Positions { weighted: solved.problem.gnss };
            let follows =
                [0, 1, 2].map(|axis| solved.solve(positions.right(solved, axis), vec![0.0; solved.problem.columns.number()], None));
            let whole = [0, 1, 2].map(|axis| positions.of_observed(|weight, _| weight[axis]));
            // CᵀPQᵥᵥPC; an axis that nothing tells stays by itself.
            let mut left = Matrix3::from_fn(|r, c| if r == c { whole[r] } else { 0.0 } - positions.moved(&follows[c])[r]);
            left = 0.5 * (left + left.transpose());
            let is_told = [0, 1, 2].map(|axis| whole[axis] > 0.0 && left[(axis, axis)] > LEAST_LEFT * whole[axis]);
            for axis in (0..3).filter(|axis| !is_told[*axis]) {
                left.fill_row(axis, 0.0);
                left.fill_column(axis, 0.0);
                left[(axis, axis)] = 1.0;
            }
            let Some(cofactors) = left.try_inverse() else { return Ok([None; 3]) };
            let residual = |image: usize| self.images[image].gnss.map_or([0.0; 3], |gnss| gnss.residual);
            let sums = Vector3::from_fn(|axis, _| positions.of_observed(|weight, image| weight[axis] * residual(image)[axis]));
            let offset = Vector3::from_fn(|axis, _| if is_told[axis] { (cofactors * sums)[axis] } else { 0.0 });
            let mut variances = cofactors.diagonal();
            solved.for_each_shared(|step, share| variances += share * (cofactors * positions.moved(step)).map(|moved| moved * moved));
            let unit_error = self.unit_error_beside(solved.unit_error, sums.dot(&offset), is_told.iter().filter(|told| **told).count());
            let beside = Beside { adjusted: self, solved, follows: &follows, offset, unit_error };
            let error = |axis: usize| unit_error * variances[axis].max(0.0).sqrt() * beside.scatter(axis);
            let told = |axis| CommonOffset {
                value: offset[axis],
                error: error(axis),
                followed: positions.followed(&follows[axis], axis) * offset[axis],
            };
            Ok([0, 1, 2].map(|axis| is_told[axis].then(|| told(axis))))
        })
    }

    /// That of an observation of weight 1 once an offset of some axes has taken a part of the squares upon itself.
    fn unit_error_beside(&self, unit_error: f64, taken: f64, axes: usize) -> f64 {
        let freedom = self.degrees_of_freedom as f64;
        let left = (unit_error * unit_error * freedom - taken) / (freedom - axes as f64);
        if self.sigma0_a_priori_px.is_none() && left.is_finite() && left > 0.0 { left.sqrt() } else { unit_error }
    }
}

/// The residuals that are left beside the offset, once the block has followed it.
struct Beside<'a> {
    adjusted: &'a AdjustmentResult,
    solved: &'a Solved<'a>,
    /// How the block follows an offset along each axis.
    follows: &'a [Step; 3],
    offset: Vector3<f64>,
    unit_error: f64,
}

impl Beside<'_> {
    /// By how many times their standard errors positions or control points scatter along an axis, at least 1.
    fn scatter(&self, axis: usize) -> f64 {
        let Self { adjusted, solved, offset, .. } = self;
        let of_image = |(image, observed): (usize, &Option<Weighted>)| {
            let change = self.followed(|step| step.images[image][N - 3 + axis]) - offset[axis];
            self.size(observed.as_ref()?, adjusted.images[image].gnss.as_ref()?, axis, change)
        };
        let of_control = |(at, statistics): (usize, &Option<PriorStatistics>)| {
            let point = adjusted.block.control[at].point;
            let change = self.followed(|step| step.points[point][axis]);
            self.size(solved.problem.control[point].as_ref()?, statistics.as_ref()?, axis, change)
        };
        let scatter_of = |mut sizes: Vec<f64>| scatter(&mut sizes).filter(|_| sizes.len() >= LEAST_RESIDUALS);
        let of_positions = scatter_of(solved.problem.gnss.iter().enumerate().filter_map(of_image).collect());
        let of_points = scatter_of(adjusted.control.iter().enumerate().filter_map(of_control).collect());
        of_positions.into_iter().chain(of_points).fold(1.0, f64::max)
    }

    /// What follows the offset of what follows one along each axis.
    fn followed(&self, of: impl Fn(&Step) -> f64) -> f64 {
        self.follows.iter().zip(self.offset.iter()).map(|(step, offset)| of(step) * offset).sum()
    }

    /// Of a residual that changes, in its standard errors; none where nothing checks it.
    fn size(&self, observed: &Weighted, statistics: &PriorStatistics, axis: usize, change: f64) -> Option<f64> {
        let redundancy = statistics.redundancy?[axis];
        let size = (statistics.residual[axis] + change).abs() * (observed.weight[axis] / redundancy).sqrt() / self.unit_error;
        (observed.weight[axis] > 0.0 && redundancy > LEAST_REDUNDANCY).then_some(size)
    }
}

/// The positions that take part, by the images.
struct Positions<'a> {
    weighted: &'a [Option<Weighted>],
}

impl Positions<'_> {
    fn of_observed(&self, value: impl Fn(&[f64; 3], usize) -> f64) -> f64 {
        self.weighted.iter().enumerate().filter_map(|(image, observed)| Some(value(&observed.as_ref()?.weight, image))).sum()
    }

    /// AᵀPC of an offset along an axis.
    fn right(&self, solved: &Solved<'_>, axis: usize) -> Vec<f64> {
        let place = &solved.problem.network.pattern.place;
        let mut images = vec![0.0; place.len() * N];
        for (at, observed) in place.iter().zip(self.weighted) {
            images[*at as usize * N + N - 3 + axis] = observed.map_or(0.0, |observed| observed.weight[axis]);
        }
        images
    }

    /// What the images of a change move by along an axis, in the median of those that have a position.
    fn followed(&self, step: &Step, axis: usize) -> f64 {
        let of_observed = |(image, observed): (usize, &Option<Weighted>)| observed.is_some().then(|| step.images[image][N - 3 + axis]);
        median(&mut self.weighted.iter().enumerate().filter_map(of_observed).collect::<Vec<f64>>()).unwrap_or(0.0)
    }

    /// CᵀP of a change.
    fn moved(&self, step: &Step) -> Vector3<f64> {
        Vector3::from_fn(|axis, _| self.of_observed(|weight, image| weight[axis] * step.images[image][N - 3 + axis]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        AdjustmentOptions, BlockFlight, BlockPreset, Datum, FreeParameters, GnssErrors, Loss, ObservationVerdict, adjust_block,
        simulate_network,
    };

    /// A block of RTK positions and control points, the positions off by so much.
    fn observed(seed: u32, off: [f64; 3]) -> Block {
        let flight = BlockFlight {
            strips: 3,
            exposures: 5,
            points_per_image: 20.0,
            control_points: 6,
            receiver_m: 0.02,
            seed,
            ..BlockPreset::Network.flight()
        };
        let mut block = simulate_network(&flight).unwrap().observed;
        block.images.iter_mut().filter_map(|image| image.gnss.as_mut()).for_each(|gnss| (0..3).for_each(|k| gnss.position[k] += off[k]));
        block
    }

    fn adjusted(block: &Block, gnss_errors: GnssErrors, shared_errors: f64) -> AdjustmentResult {
        let (datum, loss) = (Datum::GnssAndControl, Loss::Squares);
        let options = AdjustmentOptions { datum, loss, gnss_errors, shared_errors, snooping: false, ..AdjustmentOptions::default() };
        adjust_block(block, &options).unwrap()
    }

    fn told(found: &AdjustmentResult) -> [CommonOffset; 3] {
        let accepted: Vec<bool> = found.rays.iter().map(|ray| ray.verdict == ObservationVerdict::Accepted).collect();
        found.common_offset(&found.block, &accepted).unwrap().map(Option::unwrap)
    }

    #[test]
    fn an_offset_is_the_one_that_another_adjustment_estimates() {
        for shared_errors in [0.0, 0.4] {
            let block = observed(3, [0.6, -0.5, 0.9]);
            let estimated = adjusted(&block, GnssErrors::Offset, shared_errors).systematic.unwrap().errors.remove(0);
            let told = told(&adjusted(&block, GnssErrors::None, shared_errors));
            for (k, told) in told.iter().enumerate() {
                let (value, error) = (estimated.estimate[k], estimated.standard_errors[k].unwrap());
                // Of residuals that scatter by chance the error is larger, never smaller; the values differ by what is not linear.
                assert!(
                    (told.value - value).abs() < 0.5 * error && (0.95..2.0).contains(&(told.error / error)),
                    "{k}: {told:?} {value} {error}"
                );
            }
        }
    }

    #[test]
    fn what_is_said_of_positions_without_an_offset_is_chance() {
        const BLOCKS: usize = 60;
        let mut sizes = Vec::new();
        for seed in 0..BLOCKS {
            let mut block = observed(100 + seed as u32, [0.0; 3]);
            block.cameras[0].free = FreeParameters { focal: seed % 2 == 1, ..FreeParameters::default() };
            sizes.extend(told(&adjusted(&block, GnssErrors::None, 0.0)).map(|told| told.value / told.error));
        }
        let square = sizes.iter().map(|size| size * size).sum::<f64>() / sizes.len() as f64;
        let beyond = sizes.iter().filter(|size| size.abs() > 3.29).count();
        assert!((0.5..1.1).contains(&square) && beyond <= 1, "{square} {beyond}");
    }
}
