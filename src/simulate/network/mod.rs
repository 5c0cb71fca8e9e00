//! A simulated network of rays: rays of points over a made relief, of which everything is known; no pixels.
//!
//! It is for the bundle adjustment: it gives what that takes, joined rays of distorted cameras with gross errors, approximate values, GNSS
//! positions and control points, and the noise of each can be chosen. What comes before, features, matches and photos, is simulated in `block`.
//!
//! Data flow: [`NetworkFlight`] → `orientations` → `rays` (points, observed rays) → `approximations` (what is known before) →
//! [`SimulatedNetwork`].

mod approximations;
mod flight;
mod orientations;
mod rays;

pub use flight::{NetworkFlight, NetworkKind};

use super::random::{Random, Stream};
use crate::{Block, Error};
use approximations::{add_control, approximate};
use rays::observe;

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

/// Simulates a block.
///
/// # Errors
/// [`Error::InvalidOption`], naming the field and its range.
pub fn simulate_network(flight: &NetworkFlight) -> Result<SimulatedNetwork, Error> {
    flight.check()?;
    let mut random = Random::new(flight.seed, Stream::NetworkOrientations);
    let mut truth = Block { cameras: flight.cameras(), images: flight.images(&mut random), ..Block::default() };
    truth.points = flight.points(&mut Random::new(flight.seed, Stream::NetworkPoints));
    let gross = observe(flight, &mut truth);
    add_control(flight, &mut truth);
    let observed = approximate(flight, &truth);
    Ok(SimulatedNetwork { observed, truth, gross })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::BlockImage;

    #[test]
    fn a_block_sees_its_points_often_enough() {
        let simulated = simulate_network(&NetworkFlight::default()).unwrap();
        let block = &simulated.observed;
        assert_eq!(block.images.len(), 30);
        let mean = block.rays.len() as f64 / block.points.len() as f64;
        assert!(block.points.len() > 300 && mean > 4.0, "{} points, {mean} rays each", block.points.len());
        let sideways = |image: &BlockImage| image.pose.rotation[2][2];
        assert!(block.images.iter().all(|image| sideways(image) > 0.99));
        assert_eq!(simulated, simulate_network(&NetworkFlight::default()).unwrap());
    }

    #[test]
    fn an_oblique_block_looks_to_all_sides() {
        let flight = NetworkFlight { kind: NetworkKind::Oblique, ..NetworkFlight::default() };
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
            NetworkFlight { strips: 0, ..NetworkFlight::default() },
            NetworkFlight { noise_px: f64::NAN, ..NetworkFlight::default() },
            NetworkFlight { end_lap: 1.0, ..NetworkFlight::default() },
        ] {
            assert_eq!(simulate_network(&flight).unwrap_err().code(), "invalid-option");
        }
    }
}
