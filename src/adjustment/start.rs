//! The adjustment of a block that is still being put together: robust, some images fixed, camera parameters held by what was known of them.

use super::block::Block;
use super::datum::held_images;
use super::gauss_newton::Demand;
use super::network::{Columns, Network};
use super::options::Loss;
use super::reduced::{KnownParameter, Problem};
use super::state::State;
use super::systematic::SystematicErrors;
use crate::Error;
use crate::camera::CAMERA_PARAMETERS;

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
    let network = Network::with_fixed(&block, start.accepted, start.fixed.to_vec(), None);
    let state = State::of(&block);
    let free: Vec<[bool; CAMERA_PARAMETERS]> = start.cameras.iter().map(|known| known.map(|(_, sigma)| sigma > 0.0)).collect();
    let columns = Columns::new(&free);
    let known: Vec<KnownParameter> = (columns.parameter.iter())
        .map(|(camera, parameter)| {
            let (value, sigma) = start.cameras[*camera][*parameter];
            KnownParameter { value, weight: start.sigma_px / sigma * (start.sigma_px / sigma) }
        })
        .collect();
    let (gnss, control) = (vec![None; block.images.len()], vec![None; block.points.len()]);
    let axes = vec![None; block.images.len()];
    let held = start.fixed.iter().all(|fixed| !fixed).then(|| held_images(&network, &state));
    let problem = Problem {
        network: &network,
        columns: &columns,
        gnss: &gnss,
        control: &control,
        axes: &axes,
        held,
        known: &known,
        systematic: &SystematicErrors::default(),
        constraints: &[],
    };
    let demand = Demand {
        loss: Loss::Cauchy,
        sigma: start.sigma_px,
        max_iterations: start.max_iterations,
        tolerance: TOLERANCE,
        warm: false,
        passing: true,
    };
    problem.adjust(state, &demand, &mut None).map(|adjusted| adjusted.state.put_into(block))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::camera::FreeParameters;
    use crate::{BlockFlight, BlockPreset, SimulatedNetwork, simulate_network};

    fn simulated() -> SimulatedNetwork {
        simulate_network(&BlockFlight { gross_share: 0.05, ..BlockPreset::Network.flight() }).unwrap()
    }

    fn distance(a: &Block, b: &Block, image: usize) -> f64 {
        let square = |k: usize| {
            (a.images[image].pose.position[k] - b.images[image].pose.position[k])
                * (a.images[image].pose.position[k] - b.images[image].pose.position[k])
        };
        (0..3).map(square).sum::<f64>().sqrt()
    }

    #[test]
    fn fixed_images_stay_and_hold_the_others() {
        let SimulatedNetwork { observed, truth, .. } = simulated();
        let (fixed, accepted) = ((0..30).map(|image| image % 6 < 4).collect::<Vec<_>>(), vec![true; observed.rays.len()]);
        let mut block = observed.clone();
        (0..30).filter(|image| fixed[*image]).for_each(|image| block.images[image] = truth.images[image].clone());
        let cameras = [block.cameras[0].values().map(|value| (value, 0.0))];
        let start = Start { accepted: &accepted, fixed: &fixed, cameras: &cameras, sigma_px: 0.2, max_iterations: 12 };
        let adjusted = adjust_start(block, &start).unwrap();
        for image in 0..30 {
            let (before, after) = (distance(&observed, &truth, image), distance(&adjusted, &truth, image));
            // The errors of the start are half a metre; gross errors are weighted down.
            assert!(if fixed[image] { after == 0.0 } else { after < 0.15 && before > 0.1 }, "{image}: {before} {after}");
        }
    }

    #[test]
    fn a_camera_follows_the_rays_as_far_as_what_is_known_of_it_lets_it() {
        let SimulatedNetwork { observed, truth, .. } = simulated();
        let (fixed, accepted) = (vec![false; 30], vec![true; observed.rays.len()]);
        let found = |sigma: f64| {
            let mut block = observed.clone();
            block.cameras[0].focal_px *= 1.03;
            block.cameras[0].free = FreeParameters { focal: true, ..FreeParameters::default() };
            let (values, free) = (block.cameras[0].values(), block.cameras[0].free.flags());
            let cameras = [std::array::from_fn(|k| (values[k], if free[k] { sigma } else { 0.0 }))];
            let start = Start { accepted: &accepted, fixed: &fixed, cameras: &cameras, sigma_px: 0.4, max_iterations: 30 };
            adjust_start(block, &start).unwrap().cameras[0].focal_px / truth.cameras[0].focal_px
        };
        let (held, free) = (found(0.01), found(200.0));
        assert!((held - 1.03).abs() < 1e-4 && (free - 1.0).abs() < 0.01, "{held} {free}");
    }
}
