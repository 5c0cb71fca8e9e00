//! The truth of a block: its cameras and the exterior orientations of its images.

use super::exposures::Exposure;
use super::flight::BlockFlight;
use crate::{BlockModel, Camera, ModelImage, Pose};

/// The true cameras and exterior orientations of exposures, in the system of the flight; images are named `photo_00000` and so on.
pub(super) fn true_block(flight: &BlockFlight, exposures: &[Exposure]) -> BlockModel {
    let count = exposures.iter().map(|exposure| exposure.camera + 1).max().unwrap_or(0);
    let focal_px = |camera: u32| exposures.iter().find(|e| e.camera == camera).map_or(1.0, |e| e.focal_px);
    let camera = |number: u32| Camera {
        pixel_mm: Some(flight.pixel_mm),
        ..Camera::without_distortion(flight.width_px, flight.height_px, focal_px(number))
    };
    let image = |(index, exposure): (usize, &Exposure)| ModelImage {
        name: format!("photo_{index:05}"),
        camera: exposure.camera as usize,
        pose: Some(Pose::new(&exposure.rotation, exposure.centre)),
    };
    BlockModel {
        cameras: (0..count).map(camera).collect(),
        images: exposures.iter().enumerate().map(image).collect(),
        ..BlockModel::default()
    }
}
