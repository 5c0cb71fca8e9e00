//! Cameras of a simulated network and the true orientations of its images.

use crate::camera::rotation_from_angles;
use crate::simulate::block::{BlockFlight, BlockView};
use crate::simulate::mounting::NADIR_MM;
use crate::simulate::random::Random;
use crate::{BlockImage, Camera, Pose};
use std::f64::consts::{FRAC_PI_2, PI};

/// Distances of exposures along and across the strips.
pub(super) fn spacing(flight: &BlockFlight) -> (f64, f64) {
    let ground = flight.flying_height_m / flight.focal_px();
    let [width, height] = [flight.width_px, flight.height_px].map(f64::from);
    ((1.0 - flight.forward_overlap) * height * ground, (1.0 - flight.side_overlap) * width * ground)
}

pub(super) fn cameras(flight: &BlockFlight) -> Vec<Camera> {
    let [width, height] = [flight.width_px, flight.height_px].map(f64::from);
    let camera = |focal_px: f64| Camera {
        principal_point_px: [0.5 * width + 3.0, 0.5 * height - 5.0],
        radial: flight.radial,
        tangential: flight.tangential,
        ..Camera::without_distortion(flight.width_px, flight.height_px, focal_px)
    };
    flight.mountings().iter().map(|mounting| camera(mounting.focal_mm / NADIR_MM * flight.focal_px())).collect()
}

/// The true orientations: the images' rows lie along the strips, as the shorter side of a frame does.
pub(super) fn images(flight: &BlockFlight, random: &mut Random) -> Vec<BlockImage> {
    let (along, across) = spacing(flight);
    let mut images = Vec::new();
    let mut strip = |number: usize, exposures: usize, turn: f64, height: f64, middle: [f64; 2]| {
        let heading = turn + if number % 2 == 1 { PI } else { 0.0 };
        for exposure in 0..exposures {
            let x = (exposure as f64 - 0.5 * (exposures as f64 - 1.0)) * along * height / flight.flying_height_m
                + random.normal_pair().x * 0.03 * along;
            let shift = random.normal_pair() * (0.02 * across);
            let (sin, cos) = libm::sincos(turn);
            let position = [middle[0] + x * cos - shift.x * sin, middle[1] + x * sin + shift.x * cos, height + shift.y];
            let tilts = random.normal_pair() * 0.02;
            let heading = heading + random.normal_pair().x * 0.05;
            for (camera, mounting) in flight.mountings().into_iter().enumerate() {
                let rotation = mounting.rotation * rotation_from_angles(tilts.x, tilts.y, heading - FRAC_PI_2);
                images.push(BlockImage { camera, pose: Pose::new(&rotation, position), gnss: None, axis: None });
            }
        }
    };
    for number in 0..flight.strips {
        let y = (number as f64 - 0.5 * (flight.strips as f64 - 1.0)) * across;
        strip(number, flight.exposures, 0.0, flight.flying_height_m, [0.0, y]);
    }
    if flight.view == BlockView::TwoHeights {
        let (length, width) = (flight.exposures as f64 * along, flight.strips as f64 * across);
        let height = 1.3 * flight.flying_height_m;
        let strips = ((length / (1.3 * across)) as usize).max(2);
        let exposures = ((width / (1.3 * along)) as usize).max(2);
        for number in 0..strips {
            let x = (number as f64 - 0.5 * (strips as f64 - 1.0)) * 1.3 * across;
            strip(number, exposures, FRAC_PI_2, height, [x, 0.0]);
        }
    }
    images
}
