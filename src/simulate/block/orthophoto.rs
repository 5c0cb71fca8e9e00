//! The orthophoto of a made scene, with the heights of its surface.

use super::photos::BlockScene;
use crate::catalogue::refuse;
use crate::simulate::photo::{Photo, Scan};
use crate::simulate::random::{Random, Stream};
use crate::simulate::render::render;
use crate::simulate::scene::Moment;
use crate::simulate::sensor::Sensor;
use crate::simulate::view::View;
use crate::{Allowed, Error, Georeference, HeightModel, Heights, Orthophoto};
use nalgebra::{Matrix3, Vector3};

/// From so high rays are parallel: they lean by less than a millimetre in 100 m of height and a kilometre of ground.
const HEIGHT_M: f64 = 1e8;
const MOST_PIXELS: f64 = 1e8;
/// Of the sensor and its processing, beside those of the photos.
const GAIN: f64 = 0.85;
const OFFSET_GREY: f64 = 20.0;

impl BlockScene {
    /// The orthophoto of all that the block's photos show, taken at another moment: cars have moved, and the light has another strength. Its
    /// height model is that of the surface, roofs and trees included, one height a pixel.
    ///
    /// # Errors
    /// [`Error::InvalidOption`] for a side of the pixel that makes it larger than 100 MP, or that is none.
    pub fn orthophoto(&self, gsd_m: f64) -> Result<Orthophoto, Error> {
        let [x0, y0, x1, y1] = self.seen;
        let size = [(x1 - x0) / gsd_m, (y1 - y0) / gsd_m];
        if !(gsd_m > 0.0 && size[0] * size[1] <= MOST_PIXELS && size.iter().all(|side| *side >= 16.0)) {
            let allowed = Allowed::OrthophotoPixel { above: ((x1 - x0) * (y1 - y0) / MOST_PIXELS).sqrt() };
            return Err(refuse("gsd_m", gsd_m, allowed));
        }
        let [width, height] = size.map(|side| side as usize);
        let georeference = Georeference::north_up([x0, y1], gsd_m);
        let middle = georeference.ground([0.5 * width as f64, 0.5 * height as f64]);
        let from_above = Photo {
            centre: Vector3::new(middle[0], middle[1], HEIGHT_M),
            photo_from_ground: Matrix3::identity(),
            focal_mm: HEIGHT_M / gsd_m,
            principal_point_mm: [0.0; 2],
            distortion: 0.0,
            scan: Scan::digital(1.0, width as u32, height as u32),
            origin_px: [0.0; 2],
        };
        let view = View::new(&self.scene, &from_above, Moment::Second, width, height);
        let noise = [0, 1].map(|k| Random::new(self.flight.seed ^ (0x5EED + k), Stream::BlockNoise));
        let crate::Flight { psf_px, noise_grey, grain_grey, grain_px, .. } = self.town;
        let sensor = Sensor { gain: GAIN, offset_grey: OFFSET_GREY, noise_grey, grain_grey, grain_px, haze: 0.0 };
        let grey = sensor.record(&render(&view, width, height, psf_px), width, height, noise)?;
        let heights = (0..width * height).map(|k| view.hit((k % width) as f64 + 0.5, (k / width) as f64 + 0.5).point.z as f32);
        let heights = HeightModel::new(width, height, heights.collect(), georeference)?;
        Orthophoto::new(grey, georeference, Heights::Model(heights))
    }
}
