//! Covariances of chosen unknowns of an adjusted block, with those of every other one among them.
//!
//! The selected inverse holds what images have in common that see a common point. What lies farther apart is solved for, column by column, by the
//! factor of the normal equations at the adjusted values.

use super::adjusted_equations::Solved;
use super::block::Block;
use super::datum::{Freedoms, Seven};
use super::factor3::forward3;
use super::network::Columns;
use super::precision::angles_by_turns;
use super::result::AdjustmentResult;
use super::solution::Step;
use super::sparse::N;
use super::state::State;
use crate::error::refuse;
use crate::{CameraParameter, Error, Refusal};

/// What covariances are wanted of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Part {
    Image(usize),
    Camera(usize),
    Point(usize),
}

/// An unknown of a part.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Unknown {
    /// ω, φ, κ in radians.
    Angle(usize),
    /// X, Y, Z.
    Coordinate(usize),
    Parameter(CameraParameter),
}

/// Covariances of some unknowns.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct PartCovariances {
    /// Each by the index of its part among those that were asked for, with its adjusted value.
    pub unknowns: Vec<(usize, Unknown, f64)>,
    /// Symmetric, row by row.
    pub rows: Vec<Vec<f64>>,
}

impl AdjustmentResult {
    /// Covariances of images, of points and of the parameters of cameras that were estimated, in radians, in px and in the units of the block, with what
    /// errors add that the rays of an image share. `block`: the adjusted one with all points by which it was adjusted, its own first; `accepted`: which of
    /// its rays took part.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for a point without accepted rays and for an image whose angles are not determined, at φ = ±90°; [`Error::TooFew`]
    /// without redundancy, which leaves σ₀ unknown; [`Error::Degenerate`] where the normal equations are singular.
    pub(crate) fn covariances(&self, block: &Block, accepted: &[bool], parts: &[Part]) -> Result<PartCovariances, Error> {
        self.with_equations(block, accepted, |solved| {
            let chosen = solved.chosen(parts)?;
            let column = |one: &Chosen| {
                let step = solved.column(one);
                chosen.iter().map(|other| other.of(&step)).collect()
            };
            let mut rows: Vec<Vec<f64>> = chosen.iter().map(column).collect();
            solved.for_each_shared(|step, share| {
                let moved: Vec<f64> = chosen.iter().map(|one| one.of(step)).collect();
                for (row, own) in rows.iter_mut().zip(&moved) {
                    row.iter_mut().zip(&moved).for_each(|(sum, other)| *sum += share * own * other);
                }
            });
            turns_to_angles(&mut rows, &chosen, solved.state)?;
            let variance = solved.unit_error * solved.unit_error;
            let size = rows.len();
            let rows = (0..size).map(|r| (0..size).map(|c| 0.5 * variance * (rows[r][c] + rows[c][r])).collect()).collect();
            let columns = solved.problem.columns;
            let unknowns = chosen.iter().map(|one| (one.part, one.unknown(columns), one.value(solved.state, columns))).collect();
            Ok(PartCovariances { unknowns, rows })
        })
    }
}

/// An unknown as the equations have it: turns of images in place of angles.
#[derive(Debug, Clone, Copy)]
struct Chosen {
    /// Index of its part among those that were asked for.
    part: usize,
    of: Part,
    /// Of an image 0 to 5, of a point 0 to 2, of a camera its column.
    index: usize,
}

impl Chosen {
    /// Its entry of a change of all unknowns.
    fn of(&self, step: &Step) -> f64 {
        match self.of {
            Part::Image(image) => step.images[image][self.index],
            Part::Camera(_) => step.cameras[self.index],
            Part::Point(point) => step.points[point][self.index],
        }
    }

    fn unknown(&self, columns: &Columns) -> Unknown {
        match self.of {
            Part::Image(_) if self.index < 3 => Unknown::Angle(self.index),
            Part::Image(_) => Unknown::Coordinate(self.index - 3),
            Part::Camera(_) => Unknown::Parameter(CameraParameter::ALL[columns.parameter[self.index].1]),
            Part::Point(_) => Unknown::Coordinate(self.index),
        }
    }

    fn value(&self, state: &State, columns: &Columns) -> f64 {
        match self.of {
            Part::Image(image) if self.index < 3 => state.images[image].angles()[self.index],
            Part::Image(image) => state.images[image].position[self.index - 3],
            Part::Camera(camera) => state.cameras[camera][columns.parameter[self.index].1],
            Part::Point(point) => state.points[point][self.index],
        }
    }
}

fn undetermined_angles<T>(image: usize) -> Result<T, Error> {
    refuse(Refusal::CovarianceImage { image })
}

/// What chosen unknowns have in common with all.
impl Solved<'_> {
    /// The unknowns of some parts.
    fn chosen(&self, parts: &[Part]) -> Result<Vec<Chosen>, Error> {
        let mut chosen = Vec::new();
        for (part, of) in parts.iter().enumerate() {
            let indices: Vec<usize> = match of {
                Part::Image(_) => (0..N).collect(),
                Part::Camera(camera) => self.problem.columns.of_camera[*camera].iter().map(|(_, column)| *column).collect(),
                Part::Point(point) if self.reduced.points[*point].factor[0] == 0.0 => {
                    return refuse(Refusal::CovariancePoint { point: *point });
                }
                Part::Point(_) => (0..3).collect(),
            };
            chosen.extend(indices.into_iter().map(|index| Chosen { part, of: *of, index }));
        }
        Ok(chosen)
    }

    /// The cofactors of all unknowns with one, in the datum of the inner constraints where nothing else places the block: S Q Sᵀ of it, the Q of held
    /// images and S = I - G (GᵀEG)⁻¹ GᵀE.
    fn column(&self, one: &Chosen) -> Step {
        let Self { problem, reduced, freedoms, .. } = self;
        let pattern = &problem.network.pattern;
        let (mut images, mut cameras) = (vec![0.0; problem.network.images() * N], vec![0.0; problem.columns.number()]);
        let mut of_point = None;
        match one.of {
            Part::Image(image) => images[pattern.place[image] as usize * N + one.index] = 1.0,
            Part::Camera(_) => cameras[one.index] = 1.0,
            Part::Point(point) => {
                let unit = [0, 1, 2].map(|k| if k == one.index { 1.0 } else { 0.0 });
                let right = forward3(&reduced.points[point].factor, unit);
                self.eliminate(point, &right, &mut images, &mut cameras);
                of_point = Some((point, right));
            }
        }
        if let Some(freedoms) = freedoms {
            self.take_motion(freedoms, one, &mut images);
        }
        self.solve(images, cameras, of_point)
    }

    /// Takes from images and cameras what the elimination of a point takes.
    fn eliminate(&self, point: usize, right: &[f64; 3], images: &mut [f64], cameras: &mut [f64]) {
        let (network, reduced) = (self.problem.network, self.reduced);
        for sight in network.point_start[point]..network.point_start[point + 1] {
            let (z, at) = (&reduced.shares[sight], network.pattern.place[network.sights[sight].image as usize] as usize * N);
            (0..N).for_each(|r| images[at + r] -= (0..3).map(|c| z[c * N + r] * right[c]).sum::<f64>());
        }
        for (column, share) in &reduced.camera_shares[reduced.camera_start[point]..reduced.camera_start[point + 1]] {
            cameras[*column as usize] -= (0..3).map(|c| share[c] * right[c]).sum::<f64>();
        }
    }

    /// Takes E G (GᵀEG)⁻¹ Gᵀe from the images, of the right-hand side e of one unknown.
    fn take_motion(&self, freedoms: &Freedoms, one: &Chosen, images: &mut [f64]) {
        let own: Seven = match one.of {
            Part::Image(image) => freedoms.of_image(&self.state.images[image])[one.index],
            Part::Point(point) => freedoms.of_point(&self.state.points[point])[one.index],
            Part::Camera(_) => return,
        };
        let motion = freedoms.inverse.map(|row| row.iter().zip(&own).map(|(a, b)| a * b).sum::<f64>());
        for (pose, place) in self.state.images.iter().zip(&self.problem.network.pattern.place) {
            for (k, (row, weight)) in freedoms.of_image(pose).iter().zip(freedoms.weights()).enumerate() {
                images[*place as usize * N + k] -= weight * row.iter().zip(&motion).map(|(a, b)| a * b).sum::<f64>();
            }
        }
    }
}

/// Takes rows and columns of the turns of images to those of their angles.
fn turns_to_angles(rows: &mut [Vec<f64>], chosen: &[Chosen], state: &State) -> Result<(), Error> {
    for (at, one) in chosen.iter().enumerate() {
        let Chosen { of: Part::Image(image), index: 0, .. } = *one else { continue };
        let Some(by_turns) = angles_by_turns(&state.images[image]) else { return undetermined_angles(image) };
        let angles = |turns: [f64; 3]| [0, 1, 2].map(|k| (0..3).map(|t| by_turns[(k, t)] * turns[t]).sum::<f64>());
        for column in 0..chosen.len() {
            let turned = angles([0, 1, 2].map(|k| rows[at + k][column]));
            (0..3).for_each(|k| rows[at + k][column] = turned[k]);
        }
        for row in rows.iter_mut() {
            let turned = angles([0, 1, 2].map(|k| row[at + k]));
            row[at..at + 3].copy_from_slice(&turned);
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::adjustment::collinearity::linearise;
    use crate::adjustment::network::Network;
    use crate::adjustment::systematic_result::SystematicVerdict;
    use crate::{AdjustmentOptions, BlockFlight, BlockPreset, BlockView, Datum, FreeParameters, Loss, adjust_block, simulate_network};
    use nalgebra::DMatrix;

    fn adjusted(datum: Datum, shared_errors: f64) -> AdjustmentResult {
        let flight = BlockFlight {
            view: BlockView::TwoHeights,
            strips: 2,
            exposures: 5,
            points_per_image: 20.0,
            control_points: 6,
            receiver_m: 0.05,
            ..BlockPreset::Network.flight()
        };
        let mut block = simulate_network(&flight).unwrap().observed;
        block.cameras[0].free = FreeParameters { focal: true, radial: 1, ..FreeParameters::default() };
        let options = AdjustmentOptions {
            datum,
            shared_errors,
            loss: Loss::Squares,
            snooping: false,
            calibration_limit_px: 1000.0,
            ..AdjustmentOptions::default()
        };
        adjust_block(&block, &options).unwrap()
    }

    fn all_parts(block: &Block) -> Vec<Part> {
        let images = (0..block.images.len()).map(Part::Image);
        images.chain((0..block.cameras.len()).map(Part::Camera)).chain((0..block.points.len()).map(Part::Point)).collect()
    }

    /// The inverse of the normal equations of all unknowns, summed up ray by ray and inverted as a whole, with the inner constraints beside a free network.
    fn dense(found: &AdjustmentResult, parameters: &[usize]) -> DMatrix<f64> {
        let (block, state) = (&found.block, State::of(&found.block));
        let (images, points) = (block.images.len(), block.points.len());
        let cameras = 6 * images;
        let first_point = cameras + parameters.len();
        let size = first_point + 3 * points;
        let constraints = if found.datum == Datum::Free { 7 } else { 0 };
        let mut normal = DMatrix::<f64>::zeros(size + constraints, size + constraints);
        for ray in &block.rays {
            let line = linearise(&state.cameras[0], &state.images[ray.image], &state.points[ray.point]);
            for row in 0..2 {
                let mut a: Vec<(usize, f64)> = (0..6).map(|k| (6 * ray.image + k, line.by_image[row][k])).collect();
                a.extend(parameters.iter().enumerate().map(|(k, parameter)| (cameras + k, line.by_camera[row][*parameter])));
                a.extend((0..3).map(|k| (first_point + 3 * ray.point + k, line.by_point[row][k])));
                for (i, v) in &a {
                    a.iter().for_each(|(j, w)| normal[(*i, *j)] += ray.weight * v * w);
                }
            }
        }
        let weighted_by = found.weighted_by_px.unwrap();
        let weight = |sigma: f64| weighted_by / sigma * (weighted_by / sigma);
        if found.datum.uses_gnss() {
            for (image, prior) in block.images.iter().enumerate().filter_map(|(k, image)| Some((k, image.gnss?))) {
                (0..3).for_each(|k| normal[(6 * image + 3 + k, 6 * image + 3 + k)] += weight(prior.sigma[k].unwrap()));
            }
        }
        for control in block.control.iter().filter(|_| found.datum.uses_control()) {
            let at = first_point + 3 * control.point;
            (0..3).for_each(|k| normal[(at + k, at + k)] += weight(control.sigma[k]));
        }
        if constraints > 0 {
            let accepted = vec![true; block.rays.len()];
            let freedoms = Freedoms::new(&Network::new(block, &accepted, None), &state).unwrap();
            for (image, pose) in state.images.iter().enumerate() {
                for (k, (row, weight)) in freedoms.of_image(pose).iter().zip(freedoms.weights()).enumerate() {
                    for (freedom, value) in row.iter().enumerate() {
                        normal[(6 * image + k, size + freedom)] = weight * value;
                        normal[(size + freedom, 6 * image + k)] = weight * value;
                    }
                }
            }
        }
        let scale: Vec<f64> =
            (0..size + constraints).map(|k| if normal[(k, k)] > 0.0 { 1.0 / normal[(k, k)].sqrt() } else { 1.0 }).collect();
        let inverse =
            DMatrix::from_fn(size + constraints, size + constraints, |r, c| scale[r] * normal[(r, c)] * scale[c]).try_inverse().unwrap();
        let mut inverse = DMatrix::from_fn(size, size, |r, c| scale[r] * inverse[(r, c)] * scale[c]);
        for (image, pose) in state.images.iter().enumerate() {
            let by_turns = angles_by_turns(pose).unwrap();
            let rows = by_turns * inverse.fixed_rows::<3>(6 * image).clone_owned();
            inverse.fixed_rows_mut::<3>(6 * image).copy_from(&rows);
            let columns = inverse.fixed_columns::<3>(6 * image).clone_owned() * by_turns.transpose();
            inverse.fixed_columns_mut::<3>(6 * image).copy_from(&columns);
        }
        inverse
    }

    #[test]
    fn angles_follow_turns() {
        let pose = adjusted(Datum::Gnss, 0.0).block.images[3].pose;
        let pose = pose.moved(&[0.2, -0.4, 1.1, 0.0, 0.0, 0.0]);
        let (by_turns, before) = (angles_by_turns(&pose).unwrap(), pose.angles());
        for turn in 0..3 {
            let mut step = [0.0; N];
            step[turn] = 1e-6;
            let after = pose.moved(&step).angles();
            for k in 0..3 {
                let change = (after[k] - before[k]) / 1e-6;
                assert!((change - by_turns[(k, turn)]).abs() < 1e-4, "{k} by {turn}: {change} {}", by_turns[(k, turn)]);
            }
        }
    }

    #[test]
    fn covariances_are_those_of_a_dense_inverse() {
        for datum in [Datum::Free, Datum::Gnss, Datum::Control, Datum::GnssAndControl] {
            let found = adjusted(datum, 0.0);
            let accepted = vec![true; found.block.rays.len()];
            let own = found.covariances(&found.block, &accepted, &all_parts(&found.block)).unwrap();
            let parameters: Vec<usize> = (0..8).filter(|k| found.cameras[0].standard_errors[*k].is_some()).collect();
            assert!(!parameters.is_empty());
            let expected = dense(&found, &parameters) * found.unit_error_px.unwrap().powi(2);
            assert_eq!(own.rows.len(), expected.nrows());
            let mut worst = 0.0_f64;
            for (r, row) in own.rows.iter().enumerate() {
                for (c, value) in row.iter().enumerate() {
                    let unit = (expected[(r, r)] * expected[(c, c)]).sqrt();
                    worst = worst.max((value - expected[(r, c)]).abs() / unit);
                }
            }
            assert!(worst < 1e-6, "{datum:?}: off by {worst} of the standard errors");
        }
    }

    #[test]
    fn standard_errors_beside_systematic_errors_of_positions_are_the_same() {
        let flight = BlockFlight { strips: 3, exposures: 5, control_points: 6, receiver_m: 0.05, ..BlockPreset::Network.flight() };
        let mut block = simulate_network(&flight).unwrap().observed;
        block.images.iter_mut().take(5).filter_map(|image| image.gnss.as_mut()).for_each(|gnss| gnss.position[2] += 0.8);
        for datum in [Datum::Gnss, Datum::GnssAndControl] {
            let options = AdjustmentOptions {
                datum,
                gnss_errors: crate::GnssErrors::StripOffsets,
                shared_errors: 0.3,
                ..AdjustmentOptions::default()
            };
            let found = adjust_block(&block, &options).unwrap();
            assert!(found.systematic.as_ref().unwrap().errors.iter().any(|error| error.verdict == SystematicVerdict::Kept));
            let accepted: Vec<bool> = found.rays.iter().map(|ray| ray.verdict == crate::ObservationVerdict::Accepted).collect();
            let own = found.covariances(&found.block, &accepted, &[Part::Image(7), Part::Point(3)]).unwrap();
            let printed = found.images[7].position_errors.unwrap().into_iter().chain(found.points[3].unwrap().errors.unwrap());
            for (k, printed) in (3..9).zip(printed) {
                assert!((own.rows[k][k].sqrt() / printed - 1.0).abs() < 1e-3, "{datum:?} {k}: {} {printed}", own.rows[k][k].sqrt());
            }
        }
    }

    #[test]
    fn their_diagonal_is_that_of_the_standard_errors() {
        for (datum, shared_errors) in [(Datum::Free, 0.5), (Datum::GnssAndControl, 0.5), (Datum::Control, 0.0)] {
            let found = adjusted(datum, shared_errors);
            let accepted = vec![true; found.block.rays.len()];
            let parts = [Part::Point(3), Part::Image(7), Part::Camera(0), Part::Image(0)];
            let own = found.covariances(&found.block, &accepted, &parts).unwrap();
            for (k, (part, unknown, _)) in own.unknowns.iter().enumerate() {
                let printed = match (parts[*part], *unknown) {
                    (Part::Image(image), Unknown::Angle(angle)) => found.images[image].angle_errors_deg.unwrap()[angle].to_radians(),
                    (Part::Image(image), Unknown::Coordinate(axis)) => found.images[image].position_errors.unwrap()[axis],
                    (Part::Point(point), Unknown::Coordinate(axis)) => found.points[point].unwrap().errors.unwrap()[axis],
                    (Part::Camera(camera), Unknown::Parameter(parameter)) => {
                        let at = CameraParameter::ALL.iter().position(|one| *one == parameter).unwrap();
                        found.cameras[camera].standard_errors[at].unwrap()
                    }
                    other => panic!("{other:?}"),
                };
                assert!((own.rows[k][k].sqrt() / printed - 1.0).abs() < 1e-6, "{datum:?} {unknown:?}: {} {printed}", own.rows[k][k].sqrt());
            }
        }
    }
}
