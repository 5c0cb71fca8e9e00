//! The bundle adjustment as it is called: checks, adjusts, describes.

use super::block::{Block, BlockObservation};
use super::check::check_block;
use super::left_out::{Known, left_out};
use super::options::{AdjustmentOptions, Datum};
use super::precision::{Matrix3, image_errors};
use super::reliability::{Judged, Scale, of_position};
use super::result::{
    AdjustmentResult, CameraStatistics, ImageStatistics, ObjectPointStatistics, ObservationStatistics, ObservationVerdict, PriorStatistics,
};
use super::scale::variance_left;
use super::snooping::{Settled, settle};
use super::sparse::Block6;
use super::squares::{Squares, Sums};
use super::statistics::{Statistics, correlation, correlations_of_point, correlations_of_position};
use super::systematic::SystematicErrors;
use super::systematic_result::SystematicResult;
use super::weighted::observed;
use crate::Error;

/// Adjusts all images, cameras and points of a block at once.
///
/// The block brings approximate values, good enough that the rays of most points meet about where the points are. Gross errors are found
/// by a robust adjustment and data snooping; the rest is adjusted by least squares. With GNSS positions or control points the block is
/// taken into their system first; a single image, which control alone orients, has to start in it.
///
/// ```
/// use tiepoint::{AdjustmentOptions, BlockPreset, adjust_block, simulate_network};
///
/// let simulated = simulate_network(&BlockPreset::Network.flight())?;
/// let adjusted = adjust_block(&simulated.observed, &AdjustmentOptions::default())?;
/// let height = adjusted.images[0].position_errors.map(|errors| errors[2]);
/// println!("RMSE {} px, height of image 0 ± {height:?} m", adjusted.rmse_px);
/// # Ok::<(), tiepoint::Error>(())
/// ```
///
/// # Errors
/// [`Error::InvalidOption`]; [`Error::InvalidInput`] for indices, values and rays that do not fit together; [`Error::TooFew`];
/// [`Error::Degenerate`] for a block that falls apart, an image or a datum that follows from nothing; [`Error::NotConverged`].
///
/// # Source
/// Brown 1976, The bundle adjustment: progress and prospects; Triggs et al. 2000, Bundle adjustment: a modern synthesis; Baarda 1968.
pub fn adjust_block(block: &Block, options: &AdjustmentOptions) -> Result<AdjustmentResult, Error> {
    options.check_ranges()?;
    check_block(block, options.datum)?;
    let settled = settle(block, options)?;
    Ok(Description::new(block, options, settled).result())
}

/// A settled adjustment with what its description needs.
struct Description<'a> {
    given: &'a Block,
    options: &'a AdjustmentOptions,
    settled: Settled,
    estimated: Option<f64>,
    /// A priori, or estimated; 0 without either.
    sigma: f64,
    /// The same for standard errors: the estimate itself loses as much by rejections as the residuals do.
    unit_error: f64,
    /// What rejections have left of the variance.
    variance_left: f64,
    /// The error that a test detects, in standard errors of a residual.
    shift: f64,
    residuals: Vec<[f64; 2]>,
    /// What the position of each image observes.
    antennas: Vec<[f64; 3]>,
    /// Cofactors of what is estimated, with those of shared errors.
    total: Option<Total>,
}

/// Cofactors of images, camera columns and points.
struct Total {
    images: Vec<Block6>,
    cameras: Vec<f64>,
    points: Vec<Option<Matrix3>>,
}

impl<'a> Description<'a> {
    fn new(given: &'a Block, options: &'a AdjustmentOptions, settled: Settled) -> Self {
        let variance_left = variance_left(&settled.verdicts, settled.redundancy, options.alpha0);
        let cut = variance_left.sqrt();
        let estimated = (settled.redundancy > 0).then_some(settled.sigma / cut);
        let sigma = options.sigma0_px.or(estimated).unwrap_or(0.0);
        let shift = options.detectable_shift(settled.redundancy);
        let state = &settled.adjusted.state;
        let residual = |ray: &BlockObservation| {
            let camera = settled.block.images[ray.image].camera;
            let at = super::collinearity::project(&state.cameras[camera], &state.images[ray.image], &state.points[ray.point]);
            [ray.x_px - at[0], ray.y_px - at[1]]
        };
        let residuals = settled.block.rays.iter().map(residual).collect();
        let total = settled.statistics.as_ref().map(|Statistics { images, cameras, points, .. }| {
            let mut total = Total { images: images.clone(), cameras: cameras.clone(), points: points.clone() };
            if let Some(shared) = &settled.shared {
                shared.add_to(&mut total.images, &mut total.cameras, &mut total.points, options.shared_errors);
            }
            total
        });
        let systematic = SystematicErrors::of_result(&settled.block, settled.systematic.as_ref());
        let antennas = (0..settled.block.images.len()).map(|image| systematic.antenna(state, image)).collect();
        Self { given, options, settled, estimated, sigma, unit_error: sigma / cut, variance_left, shift, residuals, antennas, total }
    }

    fn result(&self) -> AdjustmentResult {
        let (settled, block) = (&self.settled, &self.settled.block);
        let of_rays = block.rays.iter().zip(&self.residuals).zip(&settled.verdicts);
        let accepted =
            of_rays.filter(|(_, verdict)| **verdict == ObservationVerdict::Accepted).map(|((ray, residual), _)| (ray, *residual));
        let sums = Sums::new(block, accepted);
        let (of_images, of_points) = (&sums.of_images, &sums.of_points);
        let (gnss, control) = observed(block, self.options.datum, settled.weighted_by);
        let state = &settled.adjusted.state;
        let of_control = |c: &super::block::ControlPoint| {
            let (q, at) = (settled.statistics.as_ref().and_then(|s| s.points[c.point]), &state.points[c.point]);
            control[c.point].filter(|_| of_points[c.point].rays > 0).map(|prior| PriorStatistics {
                left_out: q.and_then(|q| {
                    let shared =
                        settled.shared.as_ref().map_or([[0.0; 3]; 3], |shared| shared.of_point(c.point, self.options.shared_errors));
                    left_out(&prior, at, &Known { cofactors: q, shared }, settled.weighted_by, self.unit_error)
                }),
                ..of_position(&prior, at, q.map(|q| [q[0][0], q[1][1], q[2][2]]), self.scale(), true)
            })
        };
        AdjustmentResult {
            block: state.put_into(Block { rays: self.rays_as_stated(), ..self.given.clone() }),
            datum: self.options.datum,
            sigma0_px: self.estimated,
            sigma0_a_priori_px: self.options.sigma0_px,
            weighted_by_px: Some(settled.weighted_by),
            unit_error_px: Some(self.unit_error),
            variance_left: Some(self.variance_left),
            shared_errors: self.options.shared_errors,
            degrees_of_freedom: settled.redundancy,
            rmse_px: sums.all.rmse(),
            rmse_by_rays: sums.by_rays(),
            iterations: settled.iterations,
            last_step: settled.adjusted.last_step,
            rounds: settled.rounds,
            cameras: self.cameras(),
            images: (0..block.images.len()).map(|image| self.image(image, of_images[image], gnss[image])).collect(),
            points: of_points.iter().enumerate().map(|(point, squares)| self.point(point, *squares)).collect(),
            rays: (0..block.rays.len()).map(|ray| self.ray(ray)).collect(),
            control: block.control.iter().map(of_control).collect(),
            components: settled.components.clone(),
            weighting: settled.weighting,
            systematic: self.systematic(),
        }
    }

    /// The systematic errors of positions, those that are estimated with the standard errors of the finished adjustment.
    fn systematic(&self) -> Option<SystematicResult> {
        let mut result = self.settled.systematic.clone()?;
        let columns = &self.settled.columns;
        for (error, statistics) in result.errors.iter_mut().enumerate() {
            for axis in 0..3 {
                let Some(column) = columns.of_systematic[error][axis] else { continue };
                statistics.estimate[axis] = self.settled.adjusted.state.systematic[error][axis];
                let variance = self.total.as_ref().map(|total| total.cameras[column * columns.number() + column].max(0.0));
                statistics.standard_errors[axis] = variance.map(|variance| self.unit_error * variance.sqrt());
            }
        }
        Some(result)
    }

    /// The rays with the standard errors that were given and the weights that they had.
    fn rays_as_stated(&self) -> Vec<BlockObservation> {
        let rays = self.given.rays.iter().zip(&self.settled.block.rays);
        rays.map(|(given, settled)| BlockObservation { weight: settled.weight, ..*given }).collect()
    }

    fn scale(&self) -> Scale {
        Scale { sigma: self.sigma, shift: self.shift }
    }

    fn cameras(&self) -> Vec<CameraStatistics> {
        let fixed = self.settled.fixed.iter();
        let mut cameras: Vec<_> = fixed.map(|fixed| CameraStatistics { fixed: fixed.clone(), ..CameraStatistics::default() }).collect();
        let Some(total) = &self.total else { return cameras };
        let (columns, q) = (&self.settled.columns.parameter, self.settled.columns.number());
        let cofactor = |row: usize, column: usize| total.cameras[row * q + column];
        for (row, &(camera, parameter)) in columns.iter().enumerate() {
            cameras[camera].standard_errors[parameter] = Some(self.unit_error * cofactor(row, row).max(0.0).sqrt());
            let own = (0..columns.len()).filter(|column| columns[*column].0 == camera);
            let correlation = |column| correlation(cofactor(row, column), cofactor(row, row), cofactor(column, column));
            cameras[camera].correlations.push(own.map(correlation).collect());
        }
        cameras
    }

    fn image(&self, image: usize, squares: Squares, gnss: Option<super::weighted::Weighted>) -> ImageStatistics {
        let pose = &self.settled.adjusted.state.images[image];
        let statistics = self.settled.statistics.as_ref();
        let total = self.total.as_ref().map(|total| &total.images[image]);
        let errors = total.map(|q| image_errors(pose, q, self.unit_error));
        ImageStatistics {
            rays: squares.rays,
            rmse_px: squares.rmse(),
            angle_errors_deg: errors.and_then(|(angles, _)| angles),
            position_errors: errors.map(|(_, position)| position),
            position_correlations: total.map(correlations_of_position),
            gnss: gnss.map(|prior| {
                let cofactors = statistics.map(|s| s.of_position(image));
                of_position(&prior, &self.antennas[image], cofactors, self.scale(), self.settled.placed[image])
            }),
        }
    }

    fn point(&self, point: usize, squares: Squares) -> Option<ObjectPointStatistics> {
        let q = self.total.as_ref().and_then(|total| total.points[point]);
        (squares.rays > 0).then(|| ObjectPointStatistics {
            rays: squares.rays,
            rmse_px: squares.rmse(),
            errors: q.map(|q| [0, 1, 2].map(|k| self.unit_error * q[k][k].max(0.0).sqrt())),
            correlations: q.as_ref().map(correlations_of_point),
        })
    }

    fn ray(&self, ray: usize) -> ObservationStatistics {
        let judged = self.settled.statistics.as_ref().and_then(|s| s.rays[ray]);
        let w = |standardised: f64| if self.sigma > 0.0 { standardised / self.sigma } else { 0.0 };
        let weight = self.settled.block.rays[ray].weight;
        let of_both = |of: &dyn Fn(&Judged) -> Option<f64>| judged.as_ref().map_or([None; 2], |[column, row]| [of(column), of(row)]);
        let moves = |one: &Judged| Some(one.moves * self.scale().detectable(weight, one.redundancy)?).filter(|moves| moves.is_finite());
        ObservationStatistics {
            verdict: self.settled.verdicts[ray],
            residual_px: self.residuals[ray],
            redundancy: judged.map(|j| j.map(|j| j.redundancy)),
            w: judged.map(|j| j.map(|j| w(j.standardised))),
            detectable_px: of_both(&|one| self.scale().detectable(weight, one.redundancy)),
            influence: of_both(&|one| self.scale().influence(one.redundancy)),
            moves_point: if self.options.datum == Datum::Free { [None; 2] } else { of_both(&moves) },
        }
    }
}
