//! Cameras of a simulated block and the true orientations of its images.

use super::flight::{NetworkFlight, NetworkKind};
use crate::camera::rotation_from_angles;
use crate::simulate::mounting::{Mounting, NADIR_MM, five, nadir};
use crate::simulate::random::Random;
use crate::{BlockImage, Camera, Pose};

impl NetworkFlight {
    /// Distances of stations along and across the strips.
    pub(super) fn spacing(&self) -> (f64, f64) {
        let ground = self.flying_height_m / self.focal_px;
        ((1.0 - self.end_lap) * self.height_px as f64 * ground, (1.0 - self.side_lap) * self.width_px as f64 * ground)
    }

    pub(super) fn cameras(&self) -> Vec<Camera> {
        let camera = |focal_px: f64| Camera {
            principal_point_px: [0.5 * self.width_px as f64 + 3.0, 0.5 * self.height_px as f64 - 5.0],
            radial: self.radial,
            tangential: self.tangential,
            ..Camera::without_distortion(self.width_px as u32, self.height_px as u32, focal_px)
        };
        self.mountings().iter().map(|mounting| camera(mounting.focal_mm / NADIR_MM * self.focal_px)).collect()
    }

    /// The true orientations: the images' rows lie along the strips, as the shorter side of a frame does.
    pub(super) fn images(&self, random: &mut Random) -> Vec<BlockImage> {
        let (along, across) = self.spacing();
        let mut images = Vec::new();
        let mut strip = |number: usize, stations: usize, turn: f64, height: f64, middle: [f64; 2], images: &mut Vec<BlockImage>| {
            let heading = turn + if number % 2 == 1 { std::f64::consts::PI } else { 0.0 };
            for station in 0..stations {
                let x = (station as f64 - 0.5 * (stations as f64 - 1.0)) * along * height / self.flying_height_m
                    + random.normal_pair().x * 0.03 * along;
                let shift = random.normal_pair() * (0.02 * across);
                let (sin, cos) = libm::sincos(turn);
                let position = [middle[0] + x * cos - shift.x * sin, middle[1] + x * sin + shift.x * cos, height + shift.y];
                let tilts = random.normal_pair() * 0.02;
                let heading = heading + random.normal_pair().x * 0.05;
                for (camera, mounting) in self.mountings().into_iter().enumerate() {
                    let rotation = mounting.rotation * rotation_from_angles(tilts.x, tilts.y, heading - std::f64::consts::FRAC_PI_2);
                    images.push(BlockImage { camera, pose: Pose::new(&rotation, position), gnss: None });
                }
            }
        };
        for number in 0..self.strips {
            let y = (number as f64 - 0.5 * (self.strips as f64 - 1.0)) * across;
            strip(number, self.stations, 0.0, self.flying_height_m, [0.0, y], &mut images);
        }
        if self.kind == NetworkKind::TwoHeights {
            let (length, width) = (self.stations as f64 * along, self.strips as f64 * across);
            let height = 1.3 * self.flying_height_m;
            let strips = ((length / (1.3 * across)) as usize).max(2);
            let stations = ((width / (1.3 * along)) as usize).max(2);
            for number in 0..strips {
                let x = (number as f64 - 0.5 * (strips as f64 - 1.0)) * 1.3 * across;
                strip(number, stations, std::f64::consts::FRAC_PI_2, height, [x, 0.0], &mut images);
            }
        }
        images
    }

    fn mountings(&self) -> Vec<Mounting> {
        if self.kind == NetworkKind::Oblique { five().to_vec() } else { vec![nadir()] }
    }
}
