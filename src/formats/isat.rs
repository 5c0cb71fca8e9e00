//! ISAT's photo file (ImageStation Automatic Triangulation): measurements of points, photo by photo.

use super::bingo::pixel_mm;
use super::sight::Sights;
use super::text::{not_written, one_word};
use crate::{BlockModel, Error};
use std::fmt::Write;

/// Blocks `begin photo_measurements` … `end photo_measurements` of lines with point, measured x and y, corrected x and y, and status 1 for
/// measured. Coordinates are in µm, x right, y up: the measured ones from the middle of the image, the corrected ones from the principal
/// point and without distortion.
///
/// # Errors
/// [`Error::InvalidOption`] for a camera without `pixel_mm`; [`Error::NotConverged`] for a distortion without inverse.
///
/// # Source
/// ImageStation, Appendix A: ASCII Data File Formats, photo file.
pub(super) fn write_photos(model: &BlockModel, sights: &Sights) -> Result<String, Error> {
    let numbers = model.point_numbers();
    let mut text = String::from("# photo coordinates in micrometres\n");
    for (image, sightings) in model.images.iter().zip(&sights.of_images) {
        let camera = &model.cameras[image.camera];
        let micrometres = 1000.0 * pixel_mm(camera.pixel_mm)?;
        writeln!(text, "begin photo_measurements {}", one_word("ISAT", &image.name)?).map_err(not_written)?;
        for sighting in sightings {
            let x = (sighting.ray.x_px - 0.5 * f64::from(camera.width_px)) * micrometres;
            let y = (0.5 * f64::from(camera.height_px) - sighting.ray.y_px) * micrometres;
            let [right, down] = camera.direction([sighting.ray.x_px, sighting.ray.y_px])?.map(|v| v * camera.focal_px * micrometres);
            let up = 0.0 - down;
            writeln!(text, " {} {x:.2} {y:.2} {right:.2} {up:.2} 1", numbers[sighting.point]).map_err(not_written)?;
        }
        text.push_str("end photo_measurements\n");
    }
    Ok(text)
}
