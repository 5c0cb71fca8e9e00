//! The adjustment of a block that is still being put together: robust, some images fixed, camera parameters held by what was known of them.

use super::adjustment::Demand;
use super::block::Block;
use super::collinearity::CAMERA_PARAMETERS;
use super::datum::held_images;
use super::network::{Columns, Network};
use super::options::Loss;
use super::reduced::{KnownParameter, Problem};
use super::state::State;
use crate::Error;

/// A part of a block with what its adjustment leaves alone.
pub(crate) struct Start<'a> {
    pub accepted: &'a [bool],
    /// Images that keep their orientation; without any the network is free.
    pub fixed: &'a [bool],
    /// Of each camera what its parameters are known to be, and how well: a standard error of 0 fixes a parameter.
    pub cameras: &'a [[(f64, f64); CAMERA_PARAMETERS]],
    /// Standard error of a coordinate, at least, to which large residuals are compared; it also weighs what is known of the cameras.
    pub sigma_px: f64,
    pub max_iterations: usize,
}

/// Steps of a start need not be small.
const TOLERANCE: f64 = 0.05;

/// Adjusts with the robust loss of Cauchy as far as its iterations go.
///
/// # Errors
/// [`Error::Degenerate`] where an image follows from nothing.
pub(crate) fn adjust_start(block: Block, start: &Start<'_>) -> Result<Block, Error> {
    let network = Network::with_fixed(&block, start.accepted, start.fixed.to_vec());
    let state = State::of(&block);
    let free: Vec<[bool; CAMERA_PARAMETERS]> = start.cameras.iter().map(|known| known.map(|(_, sigma)| sigma > 0.0)).collect();
    let columns = Columns::new(&free);
    let known: Vec<KnownParameter> = (columns.parameter.iter())
        .map(|(camera, parameter)| {
            let (value, sigma) = start.cameras[*camera][*parameter];
            KnownParameter { value, weight: start.sigma_px / sigma * (start.sigma_px / sigma) }
        })
        .collect();
    let (gps, control) = (vec![None; block.images.len()], vec![None; block.points.len()]);
    let held = start.fixed.iter().all(|fixed| !fixed).then(|| held_images(&network, &state));
    let problem = Problem { network: &network, columns: &columns, gps: &gps, control: &control, held, known: &known };
    let demand = Demand {
        loss: Loss::Cauchy,
        sigma: start.sigma_px,
        max_iterations: start.max_iterations,
        tolerance: TOLERANCE,
        warm: false,
        passing: true,
    };
    problem.adjust(state, &demand).map(|adjusted| adjusted.state.put_into(block))
}
