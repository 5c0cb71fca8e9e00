//! A simulated network of rays: rays of points over a made relief, of which everything is known; no pixels.
//!
//! It is for the bundle adjustment: it gives what that takes, joined rays of distorted cameras with gross errors, approximate values, GNSS
//! positions and control points, and the noise of each can be chosen. What comes before, features, matches and photos, is simulated in `block`.
//!
//! Data flow: [`BlockFlight`] → `orientations` → `rays` (points, observed rays) → `approximations` (what is known before) →
//! [`SimulatedNetwork`].

mod approximations;
mod orientations;
mod rays;

use super::block::BlockFlight;
use super::random::{Random, Stream};
use crate::catalogue::refuse;
use crate::{Allowed, Block, Error};
use approximations::{add_control, approximate};
use orientations::{cameras, images};
use rays::{observe, points};

/// A simulated block with its truth.
#[derive(Debug, Clone, PartialEq)]
pub struct SimulatedNetwork {
    /// Approximate values, observed rays, GNSS positions and control points.
    pub observed: Block,
    /// True values; the rays as they are observed.
    pub truth: Block,
    /// Indices of the rays that are gross errors.
    pub gross: Vec<usize>,
}

/// Simulates the network of a flight, as [`BlockPreset::Network`](crate::BlockPreset::Network) is one. The ground's mean height is 0.
///
/// # Errors
/// [`Error::InvalidOption`], naming the field and its range.
pub fn simulate_network(flight: &BlockFlight) -> Result<SimulatedNetwork, Error> {
    check(flight)?;
    let mut random = Random::new(flight.seed, Stream::NetworkOrientations);
    let mut truth = Block { cameras: cameras(flight), images: images(flight, &mut random), ..Block::default() };
    truth.points = points(flight, &mut Random::new(flight.seed, Stream::NetworkPoints));
    let gross = observe(flight, &mut truth);
    add_control(flight, &mut truth);
    let observed = approximate(flight, &truth);
    Ok(SimulatedNetwork { observed, truth, gross })
}

/// Refuses values outside their ranges.
fn check(flight: &BlockFlight) -> Result<(), Error> {
    flight.check_ranges()?;
    for (field, value, most) in [("block_flight.relief_m", flight.relief_m, 0.5), ("block_flight.approximate_m", flight.approximate_m, 0.2)]
    {
        let most = most * flight.flying_height_m;
        if !(value <= most) {
            return Err(refuse(field, value, Allowed::Real { min: 0.0, max: most }));
        }
    }
    let mut lens = flight.radial.iter().chain(&flight.tangential);
    match lens.find(|k| !(k.abs() <= 1.0)) {
        Some(wrong) => Err(refuse("block_flight.radial, block_flight.tangential", wrong, Allowed::Real { min: -1.0, max: 1.0 })),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{BlockImage, BlockPreset, BlockView};

    #[test]
    fn a_block_sees_its_points_often_enough() {
        let simulated = simulate_network(&BlockPreset::Network.flight()).unwrap();
        let block = &simulated.observed;
        assert_eq!(block.images.len(), 30);
        let mean = block.rays.len() as f64 / block.points.len() as f64;
        assert!(block.points.len() > 300 && mean > 4.0, "{} points, {mean} rays each", block.points.len());
        let sideways = |image: &BlockImage| image.pose.rotation[2][2];
        assert!(block.images.iter().all(|image| sideways(image) > 0.99));
        assert_eq!(simulated, simulate_network(&BlockPreset::Network.flight()).unwrap());
    }

    #[test]
    fn an_oblique_block_looks_to_all_sides() {
        let flight = BlockFlight { view: BlockView::Oblique, ..BlockPreset::Network.flight() };
        let block = simulate_network(&flight).unwrap().truth;
        assert_eq!(block.images.len(), 150);
        for camera in 1..5 {
            let image = block.images.iter().find(|image| image.camera == camera).unwrap();
            // The viewing direction is -z of the photo: minus the third row of M.
            assert!((image.pose.rotation[2][2] - std::f64::consts::FRAC_1_SQRT_2).abs() < 0.1);
            assert!(block.rays.iter().any(|ray| block.images[ray.image].camera == camera));
        }
    }

    #[test]
    fn wrong_flights_are_refused() {
        for flight in [
            BlockFlight { strips: 0, ..BlockPreset::Network.flight() },
            BlockFlight { noise_px: f64::NAN, ..BlockPreset::Network.flight() },
            BlockFlight { forward_overlap: 1.0, ..BlockPreset::Network.flight() },
        ] {
            assert_eq!(simulate_network(&flight).unwrap_err().code(), "invalid-option");
        }
    }
}
