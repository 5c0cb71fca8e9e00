//! Where the block lies: observed positions, or the seven freedoms of a free network and the constraints that settle them.

use super::axis::turned_to_axes;
use super::block::Block;
use super::network::Network;
use super::options::Datum;
use super::reduced::Problem;
use super::robust_similarity::{Pair, robust_similarity};
use super::similarity::{LEAST_WIDTH, Similarity, middle, relative_width};
use super::solution::Step;
use super::sparse::{N, inverse_of_dense};
use super::state::State;
use super::strip_trend::{Misfit, near_trends};
use super::systematic::SystematicErrors;
use super::weighted::{Weighted, observed};
use crate::camera::{Pose, turn_of};
use crate::math::{dot3, minus};
use crate::{Cause, Computation, Error, Few};

/// The approximate values in the system of the observed positions on which most agree, and for each image whether its position does.
/// Positions with a coordinate that was not observed tell nothing here.
///
/// # Errors
/// [`Error::TooFew`] below three observed positions; [`Error::Degenerate`] where they lie on a line.
pub(super) fn moved_to_observed(
    block: &Block,
    network: &Network,
    state: &State,
    datum: Datum,
    systematic: &SystematicErrors,
) -> Result<(State, Vec<bool>), Error> {
    let (gnss, control) = observed(block, datum, 1.0);
    let of_images: Vec<Option<Pair>> = gnss.iter().zip(&state.images).map(|(prior, pose)| pair(pose.position, prior)).collect();
    let seen = |point: usize| network.of_point(point).len() >= 2;
    let of_points = control.iter().enumerate().filter(|(point, _)| seen(*point));
    let of_points = of_points.filter_map(|(point, prior)| pair(state.points[point], prior));
    let pairs: Vec<Pair> = of_images.iter().flatten().copied().chain(of_points).collect();
    if pairs.len() < 3 {
        return Err(Error::TooFew { few: Few::PositionsForDatum, got: pairs.len(), needed: 3 });
    }
    let undetermined = || Error::Degenerate { computation: Computation::Datum, cause: Cause::NoExtent };
    let (similarity, agree) = robust_similarity(&pairs).ok_or_else(undetermined)?;
    let agreeing: Vec<[f64; 3]> = pairs.iter().zip(&agree).filter(|(_, agrees)| **agrees).map(|(pair, _)| pair.to).collect();
    let width = relative_width(&agreeing);
    let is_levelled = block.images.iter().any(|image| image.axis.is_some());
    if !(width >= LEAST_WIDTH) && !is_levelled {
        let cause = Cause::PositionsOnLine { width, least: LEAST_WIDTH };
        return Err(Error::Degenerate { computation: Computation::Datum, cause });
    }
    let mut judged = agree.iter();
    let mut agrees: Vec<bool> = of_images.iter().map(|pair| pair.is_none() || judged.next() == Some(&true)).collect();
    if systematic.is_of_strips() {
        let misfit = |pair: &Pair| Misfit { off: minus(&pair.to, &similarity.point(&pair.from)), sigma: pair.sigma };
        agrees = near_trends(systematic, &of_images.iter().map(|pair| pair.as_ref().map(misfit)).collect::<Vec<_>>());
    }
    let moved = similarity.state(state);
    Ok((if is_levelled { turned_to_axes(block, moved) } else { moved }, agrees))
}

fn pair(from: [f64; 3], prior: &Option<Weighted>) -> Option<Pair> {
    let prior = prior.as_ref()?;
    Some(Pair { from, to: prior.position, sigma: prior.length_error()? })
}

/// The control points (by their indices in the block) that lie far from the similarity on which most observed positions agree, before anything is
/// adjusted: not those that fewer than two rays show. Empty where nothing tells which.
pub(crate) fn far_control(block: &Block, datum: Datum) -> Vec<usize> {
    let mut rays = vec![0_usize; block.points.len()];
    block.rays.iter().for_each(|ray| rays[ray.point] += 1);
    let (gnss, control) = observed(block, datum, 1.0);
    let of_control = block.control.iter().enumerate().filter(|(_, control)| rays[control.point] >= 2);
    let of_control: Vec<(usize, Pair)> =
        of_control.filter_map(|(index, c)| Some((index, pair(block.points[c.point], &control[c.point])?))).collect();
    let of_images = block.images.iter().zip(&gnss).filter_map(|(image, prior)| pair(image.pose.position, prior));
    let pairs: Vec<Pair> = of_control.iter().map(|(_, pair)| *pair).chain(of_images).collect();
    let Some((_, agree)) = robust_similarity(&pairs) else { return Vec::new() };
    of_control.iter().zip(agree).filter(|(_, agrees)| !agrees).map(|((index, _), _)| *index).collect()
}

/// Two images that hold a free network while it is solved: the one with the most rays, and the one farthest from it.
pub(super) fn held_images(network: &Network, state: &State) -> [usize; 2] {
    let rays = |image: usize| network.of_image(image).len();
    let held = (0..network.images()).rev().max_by_key(|image| rays(*image)).unwrap_or(0);
    let distance = |image: &usize| {
        let d = minus(&state.images[*image].position, &state.images[held].position);
        dot3(&d, &d)
    };
    let far = (0..network.images()).max_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(0);
    [held, far]
}

/// One number for each freedom: shift, turn, change of scale.
pub(super) type Seven = [f64; 7];

/// The freedoms of a free network at its present values. The constraints keep the orientations of all images in the middle of where they
/// were: shifts count as they are, a turn by the arc it makes at the mean distance of the points, so that one strip is held too.
///
/// # Source
/// Granshaw 1980, Bundle adjustment methods in engineering photogrammetry (inner constraints).
pub(super) struct Freedoms {
    centre: [f64; 3],
    /// Unit of length, for the sake of rounding.
    extent: f64,
    /// Square of the mean distance of the points.
    arm2: f64,
    /// (GᵀEG)⁻¹.
    pub inverse: [Seven; 7],
}

impl Freedoms {
    /// # Errors
    /// [`Error::Degenerate`] for images without any extent.
    pub fn new(network: &Network, state: &State) -> Result<Self, Error> {
        let centre = middle(state.images.iter().map(|i| i.position));
        let distance = |s: &super::network::Sight| {
            let d = minus(&state.points[s.point as usize], &state.images[s.image as usize].position);
            dot3(&d, &d).sqrt()
        };
        let mean = network.sights.iter().map(distance).sum::<f64>() / network.sights.len() as f64;
        let mut freedoms = Self { centre, extent: mean, arm2: mean * mean, inverse: [[0.0; 7]; 7] };
        let mut normal = [[0.0; 7]; 7];
        for pose in &state.images {
            for (row, weight) in freedoms.of_image(pose).iter().zip(freedoms.weights()) {
                (0..49).for_each(|k| normal[k / 7][k % 7] += weight * row[k / 7] * row[k % 7]);
            }
        }
        let refused = || Error::Degenerate { computation: Computation::FreeNetwork, cause: Cause::OnePosition };
        freedoms.inverse = inverse_of_dense(&normal).ok_or_else(refused)?;
        Ok(freedoms)
    }

    /// How the six unknowns of an image change with the freedoms.
    pub fn of_image(&self, pose: &Pose) -> [Seven; N] {
        let m = &pose.rotation;
        let turn = [0, 1, 2].map(|r| [0.0, 0.0, 0.0, -m[r][0] / self.extent, -m[r][1] / self.extent, -m[r][2] / self.extent, 0.0]);
        let shift = self.of_point(&pose.position);
        [turn[0], turn[1], turn[2], shift[0], shift[1], shift[2]]
    }

    /// How the coordinates of a point change with the freedoms.
    pub fn of_point(&self, point: &[f64; 3]) -> [Seven; 3] {
        let [x, y, z] = minus(point, &self.centre).map(|v| v / self.extent);
        [[1.0, 0.0, 0.0, 0.0, z, -y, x], [0.0, 1.0, 0.0, -z, 0.0, x, y], [0.0, 0.0, 1.0, y, -x, 0.0, z]]
    }

    /// Weights of the six unknowns of an image in the constraints.
    pub fn weights(&self) -> [f64; N] {
        [self.arm2, self.arm2, self.arm2, 1.0, 1.0, 1.0]
    }

    /// The part of a change of all images that is nothing but a motion of the whole block.
    fn motion(&self, state: &State, changes: &[[f64; N]]) -> Seven {
        let mut right = [0.0; 7];
        for (pose, change) in state.images.iter().zip(changes) {
            for ((row, weight), value) in self.of_image(pose).iter().zip(self.weights()).zip(change) {
                (0..7).for_each(|k| right[k] += weight * row[k] * value);
            }
        }
        self.inverse.map(|row| row.iter().zip(&right).map(|(a, b)| a * b).sum())
    }

    /// Takes the motion of the whole block out of a step.
    pub fn constrain(&self, state: &State, step: &mut Step) {
        let motion = self.motion(state, &step.images);
        let part = |row: &Seven| row.iter().zip(&motion).map(|(a, b)| a * b).sum::<f64>();
        for (pose, change) in state.images.iter().zip(&mut step.images) {
            self.of_image(pose).iter().zip(change).for_each(|(row, value)| *value -= part(row));
        }
        for (point, change) in state.points.iter().zip(&mut step.points) {
            self.of_point(point).iter().zip(change).for_each(|(row, value)| *value -= part(row));
        }
    }

    /// The similarity of a motion.
    fn similarity(&self, motion: &Seven) -> Similarity {
        let [x, y, z, a, b, c, s] = *motion;
        let to = [self.centre[0] + x, self.centre[1] + y, self.centre[2] + z];
        let rotation = turn_of([a, b, c].map(|v| v / self.extent));
        Similarity { scale: 1.0 + s / self.extent, rotation, from: self.centre, to }
    }
}

impl Problem<'_> {
    /// The values after a step. Where nothing is held, what of the step moves the block as a whole is done as a similarity, which leaves the
    /// residuals of all rays as they are: along straight lines a block that is hardly levelled would creep round its arc.
    pub fn after(&self, state: &State, step: &Step) -> State {
        let straight = || step.applied_to(state, self.columns);
        if self.held.is_some() || self.network.fixed.contains(&true) {
            return straight();
        }
        let Ok(freedoms) = Freedoms::new(self.network, state) else { return straight() };
        let similarity = freedoms.similarity(&freedoms.motion(state, &step.images));
        if similarity.scale < LEAST_SCALE {
            return straight();
        }
        let mut rest = step.clone();
        freedoms.constrain(state, &mut rest);
        similarity.state(&rest.applied_to(state, self.columns))
    }
}

/// A step that makes the block smaller than this share of itself is none to first order.
const LEAST_SCALE: f64 = 0.1;

/// Moves a free network as a whole to where the constraints want it beside `reference`: what steps leave to second order.
pub(super) fn moved_onto(network: &Network, mut state: State, reference: &State) -> Result<State, Error> {
    for _ in 0..10 {
        let freedoms = Freedoms::new(network, &state)?;
        let changes: Vec<[f64; N]> = state.images.iter().zip(&reference.images).map(|(from, to)| change(from, to)).collect();
        let motion = freedoms.motion(&state, &changes);
        state = freedoms.similarity(&motion).state(&state);
        if motion.iter().all(|v| v.abs() < 1e-13 * freedoms.extent) {
            break;
        }
    }
    Ok(state)
}

/// The turns, to first order, and the shift from one pose to another.
fn change(from: &Pose, to: &Pose) -> [f64; N] {
    let r = [0, 1, 2].map(|i| [0, 1, 2].map(|j| dot3(&to.rotation[i], &from.rotation[j])));
    let shift = minus(&to.position, &from.position);
    [0.5 * (r[2][1] - r[1][2]), 0.5 * (r[0][2] - r[2][0]), 0.5 * (r[1][0] - r[0][1]), shift[0], shift[1], shift[2]]
}
