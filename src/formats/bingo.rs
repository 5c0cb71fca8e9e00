//! BINGO's image coordinates.

use super::sight::Sights;
use super::text::{not_written, one_word};
use crate::catalogue::refuse_absent;
use crate::{Allowed, BlockModel, Error};
use std::fmt::Write;

/// For each image a line of its name and its camera's number, then lines of point, x, y, and an empty line. Coordinates are in mm from the
/// middle of the image, x right, y up, as they were measured: BINGO has its own camera data.
///
/// # Errors
/// [`Error::InvalidOption`] for a camera without `pixel_mm`.
pub(super) fn write_image_coordinates(model: &BlockModel, sights: &Sights) -> Result<String, Error> {
    let numbers = model.point_numbers();
    let mut text = String::new();
    for (image, sightings) in model.images.iter().zip(&sights.of_images) {
        let camera = &model.cameras[image.camera];
        let pixel = pixel_mm(camera.pixel_mm)?;
        writeln!(text, "{} {}", one_word("BINGO", &image.name)?, image.camera + 1).map_err(not_written)?;
        for sighting in sightings {
            let x = (sighting.ray.x_px - 0.5 * f64::from(camera.width_px)) * pixel;
            let y = (0.5 * f64::from(camera.height_px) - sighting.ray.y_px) * pixel;
            writeln!(text, "{} {x:.5} {y:.5}", numbers[sighting.point]).map_err(not_written)?;
        }
        text.push('\n');
    }
    Ok(text)
}

/// The side of a pixel, without which there are no photo coordinates.
pub(super) fn pixel_mm(pixel_mm: Option<f64>) -> Result<f64, Error> {
    pixel_mm.ok_or_else(|| refuse_absent("camera.pixel_mm", Allowed::ForPhotoCoordinates { min: 1e-6, max: 10.0 }))
}
