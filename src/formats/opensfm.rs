//! OpenSfM's table of tracks, `tracks.csv`, version 2.

use super::sight::Sights;
use super::text::not_written;
use crate::{BlockModel, Error};
use std::fmt::Write;

/// One line a ray between tabs: image, track, feature, x, y, scale, red, green, blue, segmentation, instance.
///
/// Positions count from the middle of the image, y down, in units of its longer side. In OpenSfM, too, the middle is that of the outermost
/// pixels' outer edges: (px - (w - 1)/2) / max(w, h) with 0 as the centre of the first pixel.
///
/// # Source
/// OpenSfM, `opensfm/src/map/src/tracks_manager.cc`.
pub(super) fn write_tracks(model: &BlockModel, sights: &Sights) -> Result<String, Error> {
    let mut text = String::from("OPENSFM_TRACKS_VERSION_v2\n");
    for (track, (point, numbers)) in model.points.iter().zip(&sights.numbers).enumerate() {
        let [r, g, b] = point.colour;
        for (ray, number) in point.rays.iter().zip(numbers) {
            let image = &model.images[ray.image];
            let camera = &model.cameras[image.camera];
            let [width, height] = [camera.width_px, camera.height_px].map(f64::from);
            let longer = width.max(height);
            let (x, y) = ((ray.x_px - 0.5 * width) / longer, (ray.y_px - 0.5 * height) / longer);
            writeln!(text, "{}\t{track}\t{number}\t{x}\t{y}\t{}\t{r}\t{g}\t{b}\t-1\t-1", image.name, 1.0 / longer).map_err(not_written)?;
        }
    }
    Ok(text)
}
