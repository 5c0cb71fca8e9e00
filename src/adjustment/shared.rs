//! Errors that the rays of an image share, and what they add to the cofactors of the unknowns.
//!
//! Windows around features see the same walls and slopes: their errors have a part that changes slowly over the image. In each image columns
//! and rows are off by the modes 1, x, y, xy, x², y², each by a random amount of the same standard deviation. A mode moves the unknowns as any
//! error of observations does, δ = N⁻¹AᵀPe, and the sum of δδᵀ over all modes of all images is what they add. Of many images random signs
//! of all modes are drawn instead: the mean over the draws is the same sum.
//!
//! # Source
//! Koch 1999, Parameter estimation, 3.2 (propagation); Hutchinson 1990 (random signs).

use super::block::Block;
use super::collinearity::linearise;
use super::datum::Freedoms;
use super::factor3::forward3;
use super::gauss_newton::Adjusted;
use super::loss::Robust;
use super::precision::Matrix3;
use super::reduced::{Problem, Reduced};
use super::solution::{Factored, Step};
use super::sparse::{Block6, N};
use super::state::State;
use crate::Error;
use crate::math::Random;

/// Modes of an image: those of its columns, then those of its rows.
const MODES: usize = 12;
/// The modes of each image are summed up for so many images; of more, so many times `MODES` draws are.
const MOST_IMAGES: usize = 30;
const DRAWS: usize = 10;
/// Of the random signs.
const SEED: u32 = 1;

/// Cofactors that shared errors add, for modes of the standard deviation of a ray.
pub(super) struct SharedCofactors {
    pub images: Vec<Block6>,
    /// Of the camera columns, row by row.
    pub cameras: Vec<f64>,
    pub points: Vec<Matrix3>,
}

/// Some modes at the same time: what they do to each ray, and the right-hand sides that follow.
struct Batch {
    images: Vec<Vec<f64>>,
    cameras: Vec<Vec<f64>>,
    /// L⁻¹ of the right-hand side of each point.
    points: Vec<[[f64; 3]; MODES]>,
}

/// At an adjustment, by the factor of its equations; `reduced` holds what elimination left of its points.
///
/// # Errors
/// Those of a free network without extent.
pub(super) fn shared_cofactors(
    problem: &Problem<'_>,
    reduced: &Reduced,
    factored: &Factored,
    adjusted: &Adjusted,
    block: &Block,
) -> Result<SharedCofactors, Error> {
    let (network, q, state) = (problem.network, problem.columns.number(), &adjusted.state);
    let freedoms = problem.held.map(|_| Freedoms::new(network, state)).transpose()?;
    let mut sum = SharedCofactors {
        images: vec![[0.0; N * N]; network.images()],
        cameras: vec![0.0; q * q],
        points: vec![[[0.0; 3]; 3]; network.points()],
    };
    let add = |step: &Step, share: f64| sum.add(step, share);
    for_each_mode(problem, reduced, factored, (state, adjusted.robust), block, freedoms.as_ref(), add);
    Ok(sum)
}

/// Gives what each mode does to the unknowns, of a free network in the datum of its inner constraints, with the share by which its square counts.
pub(super) fn for_each_mode(
    problem: &Problem<'_>,
    reduced: &Reduced,
    factored: &Factored,
    at: (&State, Robust),
    block: &Block,
    freedoms: Option<&Freedoms>,
    mut take: impl FnMut(&Step, f64),
) {
    let (network, q) = (problem.network, problem.columns.number());
    let mut batch = Batch {
        images: vec![vec![0.0; network.images() * N]; MODES],
        cameras: vec![vec![0.0; q]; MODES],
        points: vec![[[0.0; 3]; MODES]; network.points()],
    };
    let all: Vec<u32> = (0..network.sights.len() as u32).collect();
    let mut random = Random::new(SEED);
    let is_exact = network.images() <= MOST_IMAGES;
    let batches = if is_exact { network.images() } else { DRAWS };
    for index in 0..batches {
        batch.images.iter_mut().chain(&mut batch.cameras).flatten().for_each(|value| *value = 0.0);
        batch.points.iter_mut().for_each(|point| *point = [[0.0; 3]; MODES]);
        // For each draw the sign of each mode of each image.
        let signs: Vec<u16> =
            if is_exact { Vec::new() } else { (0..MODES * network.images()).map(|_| random.below(1 << MODES) as u16).collect() };
        let amounts = |image: usize, modes: [f64; MODES / 2]| -> [[f64; 2]; MODES] {
            std::array::from_fn(|k| match signs.get(image * MODES + k) {
                None if k < MODES / 2 => [modes[k], 0.0],
                None => [0.0, modes[k - MODES / 2]],
                Some(signs) => {
                    let signed = |at: usize| modes[at % (MODES / 2)] * if signs >> at & 1 == 0 { 1.0 } else { -1.0 };
                    [(0..MODES / 2).map(signed).sum(), (MODES / 2..MODES).map(signed).sum()]
                }
            })
        };
        let sights = if is_exact { network.of_image(index) } else { &all };
        batch.add_rays(problem, reduced, at, block, sights, amounts);
        batch.eliminate_points(problem, reduced);
        let share = if is_exact { 1.0 } else { 1.0 / (DRAWS * MODES) as f64 };
        for k in 0..MODES {
            let mut step = batch.step(problem, reduced, factored, k);
            if let Some(freedoms) = freedoms {
                freedoms.constrain(at.0, &mut step);
            }
            take(&step, share);
        }
    }
}

impl Batch {
    /// Adds AᵀPe, CᵀPe and L⁻¹BᵀPe of some rays. `amounts` tells an image's errors at a place with these modes.
    fn add_rays(
        &mut self,
        problem: &Problem<'_>,
        reduced: &Reduced,
        (state, robust): (&State, Robust),
        block: &Block,
        sights: &[u32],
        amounts: impl Fn(usize, [f64; MODES / 2]) -> [[f64; 2]; MODES],
    ) {
        for sight in sights.iter().map(|sight| &problem.network.sights[*sight as usize]) {
            let (image, point, camera) = (sight.image as usize, sight.point as usize, sight.camera as usize);
            let factor = &reduced.points[point].factor;
            // What was measured by hand or is known apart shares nothing.
            if factor[0] == 0.0 || block.rays[sight.ray as usize].sigma_px.is_some() {
                continue;
            }
            let line = linearise(&state.cameras[camera], &state.images[image], &state.points[point]);
            let (dx, dy) = (sight.at[0] - line.at[0], sight.at[1] - line.at[1]);
            let weight = sight.weight * robust.factor(sight.weight * (dx * dx + dy * dy));
            let [width, height] = [block.cameras[camera].width_px, block.cameras[camera].height_px].map(f64::from);
            let half = 0.5 * width.max(height);
            let (x, y) = ((sight.at[0] - 0.5 * width) / half, (sight.at[1] - 0.5 * height) / half);
            let errors = amounts(image, [1.0, x, y, x * y, x * x, y * y]);
            let at = problem.network.pattern.place[image] as usize * N;
            let by_point = line.by_point.map(|row| forward3(factor, row));
            for (k, error) in errors.iter().enumerate() {
                let [ex, ey] = error.map(|e| weight * e);
                if ex == 0.0 && ey == 0.0 {
                    continue;
                }
                (0..N).for_each(|r| self.images[k][at + r] += line.by_image[0][r] * ex + line.by_image[1][r] * ey);
                (0..3).for_each(|r| self.points[point][k][r] += by_point[0][r] * ex + by_point[1][r] * ey);
                for &(parameter, column) in &problem.columns.of_camera[camera] {
                    self.cameras[k][column] += line.by_camera[0][parameter] * ex + line.by_camera[1][parameter] * ey;
                }
            }
        }
    }

    /// Takes from images and cameras what the elimination of the points takes.
    fn eliminate_points(&mut self, problem: &Problem<'_>, reduced: &Reduced) {
        let network = problem.network;
        for (point, rights) in self.points.iter().enumerate() {
            if rights.iter().flatten().all(|value| *value == 0.0) {
                continue;
            }
            for sight in network.point_start[point]..network.point_start[point + 1] {
                let (z, at) = (&reduced.shares[sight], network.pattern.place[network.sights[sight].image as usize] as usize * N);
                for (images, y) in self.images.iter_mut().zip(rights) {
                    (0..N).for_each(|r| images[at + r] -= z[r] * y[0] + z[N + r] * y[1] + z[2 * N + r] * y[2]);
                }
            }
            for (column, share) in &reduced.camera_shares[reduced.camera_start[point]..reduced.camera_start[point + 1]] {
                for (cameras, y) in self.cameras.iter_mut().zip(rights) {
                    cameras[*column as usize] -= share[0] * y[0] + share[1] * y[1] + share[2] * y[2];
                }
            }
        }
    }

    /// What one of the modes does to the unknowns.
    fn step(&mut self, problem: &Problem<'_>, reduced: &Reduced, factored: &Factored, mode: usize) -> Step {
        let pattern = &problem.network.pattern;
        let (images, cameras) = (&mut self.images[mode], &mut self.cameras[mode]);
        factored.solve(pattern, images, cameras);
        let points = (0..problem.network.points())
            .map(|point| reduced.back_substitute(problem, point, self.points[point][mode], images, cameras))
            .collect();
        let images = pattern.place.iter().map(|at| std::array::from_fn(|k| images[*at as usize * N + k])).collect();
        Step { images, cameras: cameras.clone(), points, square: 0.0 }
    }
}

impl SharedCofactors {
    /// Adds a share of δδᵀ.
    fn add(&mut self, step: &Step, share: f64) {
        for (sum, change) in self.images.iter_mut().zip(&step.images) {
            (0..N * N).for_each(|k| sum[k] += share * change[k % N] * change[k / N]);
        }
        for (sum, change) in self.points.iter_mut().zip(&step.points) {
            (0..9).for_each(|k| sum[k / 3][k % 3] += share * change[k / 3] * change[k % 3]);
        }
        let q = step.cameras.len();
        (0..q * q).for_each(|k| self.cameras[k] += share * step.cameras[k / q] * step.cameras[k % q]);
    }

    /// The cofactors with what modes of so many standard deviations of a ray add.
    pub fn add_to(&self, images: &mut [Block6], cameras: &mut [f64], points: &mut [Option<Matrix3>], sigmas: f64) {
        let share = sigmas * sigmas;
        for (own, shared) in images.iter_mut().zip(&self.images) {
            own.iter_mut().zip(shared).for_each(|(own, shared)| *own += share * shared);
        }
        cameras.iter_mut().zip(&self.cameras).for_each(|(own, shared)| *own += share * shared);
        for (point, own) in points.iter_mut().enumerate() {
            if let Some(own) = own {
                let shared = self.of_point(point, sigmas);
                (0..9).for_each(|k| own[k / 3][k % 3] += shared[k / 3][k % 3]);
            }
        }
    }

    /// What modes of so many standard deviations of a ray add to the cofactors of a point.
    pub fn of_point(&self, point: usize, sigmas: f64) -> Matrix3 {
        self.points[point].map(|row| row.map(|shared| sigmas * sigmas * shared))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{AdjustmentOptions, AdjustmentResult, BlockFlight, BlockPreset, Loss, SimulatedNetwork, adjust_block, simulate_network};

    fn simulated(strips: usize, exposures: usize) -> Block {
        let flight = BlockFlight { strips, exposures, noise_px: 0.1, ..BlockPreset::Network.flight() };
        let SimulatedNetwork { observed, .. } = simulate_network(&flight).unwrap();
        observed
    }

    fn adjusted(block: &Block, shared_errors: f64) -> AdjustmentResult {
        let options = AdjustmentOptions { shared_errors, loss: Loss::Squares, snooping: false, ..AdjustmentOptions::default() };
        adjust_block(block, &options).unwrap()
    }

    #[test]
    fn standard_errors_hold_what_each_mode_of_each_image_does() {
        let block = simulated(2, 2);
        let (plain, total) = (adjusted(&block, 0.0), adjusted(&block, 1.0));
        let sigma0 = plain.sigma0_px.unwrap();
        let mut squares = [0.0; 4];
        for image in 0..block.images.len() {
            for mode in 0..MODES {
                let mut moved = block.clone();
                let camera = &block.cameras[block.images[image].camera];
                let [width, height] = [camera.width_px, camera.height_px].map(f64::from);
                for ray in moved.rays.iter_mut().filter(|ray| ray.image == image) {
                    let (x, y) = ((ray.x_px - 0.5 * width) / (0.5 * width), (ray.y_px - 0.5 * height) / (0.5 * width));
                    let error = 0.01 * [1.0, x, y, x * y, x * x, y * y][mode % (MODES / 2)];
                    if mode < MODES / 2 { ray.x_px += error } else { ray.y_px += error }
                }
                let moved = adjusted(&moved, 0.0).block;
                let shift = |from: &[f64; 3], to: &[f64; 3], k: usize| (to[k] - from[k]) / 0.01;
                let position = |block: &Block| block.images[1].pose.position;
                (0..3).for_each(|k| squares[k] += shift(&position(&plain.block), &position(&moved), k).powi(2));
                squares[3] += shift(&plain.block.points[0], &moved.points[0], 2).powi(2);
            }
        }
        let added = |before: f64, after: f64| (after * after - before * before) / (sigma0 * sigma0);
        let [before, after] = [&plain, &total].map(|told| told.images[1].position_errors.unwrap());
        for k in 0..3 {
            assert!((added(before[k], after[k]) / squares[k] - 1.0).abs() < 0.02, "{k}: {} {}", added(before[k], after[k]), squares[k]);
        }
        let [before, after] = [&plain, &total].map(|told| told.points[0].unwrap().errors.unwrap()[2]);
        assert!((added(before, after) / squares[3] - 1.0).abs() < 0.02, "{} {}", added(before, after), squares[3]);
    }

    #[test]
    fn drawn_signs_come_to_the_same_as_all_modes() {
        let growth = |exposures: usize| {
            let block = simulated(3, exposures);
            let (plain, total) = (adjusted(&block, 0.0), adjusted(&block, 0.25));
            let ratio = |(a, b): (&crate::ImageStatistics, &crate::ImageStatistics)| {
                b.position_errors.unwrap().iter().zip(a.position_errors.unwrap()).map(|(b, a)| (b / a).powi(2)).sum::<f64>() / 3.0
            };
            plain.images.iter().zip(&total.images).map(ratio).sum::<f64>() / plain.images.len() as f64
        };
        let (all, drawn) = (growth(10), growth(11));
        assert!(all > 1.05 && (drawn / all - 1.0).abs() < 0.1, "{all} {drawn}");
    }
}
