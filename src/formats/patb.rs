//! PAT-B's image coordinates: experimental, since no description of the format is public.

use super::bingo::pixel_mm;
use super::sight::Sights;
use super::text::not_written;
use crate::{BlockModel, Error};
use std::fmt::Write;

/// The files `patb.im` and `patb_photos.txt`, the list of which photo is which image, since photos have numbers alone.
///
/// For each photo a line of its number and its focal length, lines of point, x, y and group 1, and a line of -99. All lengths are in µm, x
/// right, y up, from the principal point and without distortion.
///
/// # Errors
/// [`Error::InvalidOption`] for a camera without `pixel_mm`; [`Error::NotConverged`] for a distortion without inverse.
pub(super) fn write_image_coordinates(model: &BlockModel, sights: &Sights) -> Result<[String; 2], Error> {
    let numbers = model.point_numbers();
    let [mut text, mut photos] = [const { String::new() }; 2];
    for (index, (image, sightings)) in model.images.iter().zip(&sights.of_images).enumerate() {
        let camera = &model.cameras[image.camera];
        let scale = camera.focal_px * 1000.0 * pixel_mm(camera.pixel_mm)?;
        writeln!(photos, "{} {}", index + 1, image.name).map_err(not_written)?;
        writeln!(text, "{:>10} {scale:>12.1}", index + 1).map_err(not_written)?;
        for sighting in sightings {
            let [x, y] = camera.direction([sighting.ray.x_px, sighting.ray.y_px])?;
            writeln!(text, "{:>10} {:>12.1} {:>12.1} 1", numbers[sighting.point], x * scale, 0.0 - y * scale).map_err(not_written)?;
        }
        text.push_str("       -99\n");
    }
    Ok([text, photos])
}
