//! Photos of a block over the made scene, one at a time, with what is known of each.

use super::exposures::{Exposure, exposures};
use super::flight::{BlockFlight, BlockView};
use super::truth::true_block;
use crate::catalogue::refuse;
use crate::error::refuse as refuse_input;
use crate::simulate::buckets::Rectangle;
use crate::simulate::flight::Flight;
use crate::simulate::ground_area::{seen_ground, with_surroundings};
use crate::simulate::limits::check_length;
use crate::simulate::photo::{Photo, Scan};
use crate::simulate::random::{Random, Stream};
use crate::simulate::render::render;
use crate::simulate::scene::{Moment, Scene};
use crate::simulate::sensor::Sensor;
use crate::simulate::view::View;
use crate::{
    Allowed, BlockModel, Error, ExifCamera, ExifImage, ExifPosition, GeographicOrigin, GreyImage, Input, Refusal, geographic_from_local,
    write_png,
};

/// The scene below a block, ready to be photographed.
///
/// Memory is that of the scene and of the photo that is being taken.
pub struct BlockScene {
    pub(super) flight: BlockFlight,
    pub(super) town: Flight,
    exposures: Vec<Exposure>,
    pub(super) scene: Scene,
    /// The ground that photos show: least and greatest X and Y.
    pub(super) seen: Rectangle,
}

/// Where (0, 0, 0) of the ground is on the earth: longitude and latitude in degrees, height in m.
const PLACE: [f64; 3] = [8.0, 50.0, 100.0];

/// Larger photos are not rendered.
const MOST_PIXELS: f64 = 1e8;

impl BlockScene {
    /// Builds the scene of a flight.
    ///
    /// # Errors
    /// [`Error::InvalidOption`] for a value outside its range, and for a flight whose ground is too long, whose photos are too large or too
    /// flat, or which is not ten times as high as relief and houses.
    pub fn new(flight: &BlockFlight) -> Result<Self, Error> {
        flight.check_ranges()?;
        let pixels = f64::from(flight.width_px) * f64::from(flight.height_px);
        if pixels > MOST_PIXELS {
            let allowed = Allowed::PhotoRows { most: MOST_PIXELS / f64::from(flight.width_px) };
            return Err(refuse("block_flight.height_px", f64::from(flight.height_px), allowed));
        }
        let exposures = exposures(flight);
        let seen = ground_area(flight, &exposures)?;
        let area = with_surroundings(seen, Flight::default().highest_building_m);
        let town = town(flight, area)?;
        let scene = Scene::new(&town, area);
        Ok(Self { flight: flight.clone(), town, exposures, scene, seen })
    }

    /// How many photos the flight takes.
    pub fn photos(&self) -> usize {
        self.exposures.len()
    }

    /// Takes a photo: the same one whatever others were taken before.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for a photo that the flight does not take.
    pub fn photo(&self, index: usize) -> Result<GreyImage, Error> {
        let photo = camera(&self.flight, self.exposure(index)?);
        let (width, height) = (self.flight.width_px as usize, self.flight.height_px as usize);
        let view = View::new(&self.scene, &photo, Moment::First, width, height);
        let Flight { psf_px, noise_grey, grain_grey, grain_px, .. } = self.town;
        let sensor = Sensor { gain: 1.0, offset_grey: 0.0, noise_grey, grain_grey, grain_px, haze: 0.0 };
        // Noise that all photos shared would be a texture of its own: each has another seed.
        let noise = || Random::new(self.flight.seed ^ (index as u32 + 1).wrapping_mul(0x9E37_79B9), Stream::BlockNoise);
        sensor.record(&render(&view, width, height, psf_px), width, height, [noise(), noise()])
    }

    /// Takes a photo as a PNG file, with its camera and recorded position as EXIF.
    ///
    /// # Errors
    /// As [`photo`](Self::photo).
    pub fn photo_file(&self, index: usize) -> Result<Vec<u8>, Error> {
        let Exposure { focal_px, camera, .. } = *self.exposure(index)?;
        let pixel_mm = self.flight.pixel_mm;
        let [longitude_deg, latitude_deg, height_m] = self.recorded_position(index)?;
        let [make, model] = ["Tiepoint".to_string(), format!("Simulated {camera}")].map(Some);
        let exif = ExifImage {
            camera: Some(ExifCamera {
                make: make.clone(),
                model: model.clone(),
                focal_mm: focal_px * pixel_mm,
                pixel_mm: Some(pixel_mm),
                ..ExifCamera::default()
            }),
            position: Some(ExifPosition { longitude_deg, latitude_deg, height_m: Some(height_m), error_m: None }),
            make,
            model,
            ..ExifImage::default()
        };
        Ok(write_png(self.photo(index)?.view(), Some(&exif)))
    }

    /// The places in m on the first surface that a photo sees at positions in px, the centre of its top-left pixel at (0.5, 0.5).
    ///
    /// # Errors
    /// As [`photo`](Self::photo); [`Error::InvalidInput`] for a position outside the photo.
    pub fn surface_at(&self, index: usize, positions: &[[f64; 2]]) -> Result<Vec<[f64; 3]>, Error> {
        let photo = camera(&self.flight, self.exposure(index)?);
        let size = [self.flight.width_px, self.flight.height_px];
        let outside = |position: &&[f64; 2]| !(0..2).all(|axis| position[axis] >= 0.0 && position[axis] < f64::from(size[axis]));
        if let Some(position) = positions.iter().find(outside) {
            let (position, [width_px, height_px]) = (format!("{position:?}"), size);
            return refuse_input(Refusal::PhotoPosition { position, width_px, height_px });
        }
        let view = View::new(&self.scene, &photo, Moment::First, size[0] as usize, size[1] as usize);
        Ok(positions.iter().map(|[x, y]| view.hit(*x, *y).point.into()).collect())
    }

    /// The true cameras and exterior orientations, placed on the earth.
    pub fn truth(&self) -> BlockModel {
        let [longitude_deg, latitude_deg, height_m] = PLACE;
        let origin = Some(GeographicOrigin { longitude_deg, latitude_deg, height_m });
        BlockModel { origin, ..true_block(&self.flight, &self.exposures) }
    }

    /// Longitude and latitude in degrees and height in m as the receiver recorded them.
    ///
    /// # Errors
    /// As [`photo`](Self::photo).
    pub fn recorded_position(&self, index: usize) -> Result<[f64; 3], Error> {
        let centre = self.exposure(index)?.centre;
        let mut random = Random::new(self.flight.seed ^ (index as u32 + 1).wrapping_mul(0x9E37_79B9), Stream::BlockReceiver);
        let (across, up) = (random.normal_pair(), random.normal_pair());
        let error = [across.x, across.y, up.x].map(|value| self.flight.receiver_m * value);
        Ok(geographic_from_local(std::array::from_fn(|axis| centre[axis] + error[axis]), PLACE))
    }

    fn exposure(&self, index: usize) -> Result<&Exposure, Error> {
        let beyond = || Refusal::Below { input: Input::PhotoOfBlock, index, count: self.exposures.len() };
        self.exposures.get(index).ok_or_else(|| beyond().into_error())
    }
}

/// The photo of an exposure. Its system has the pixel grid's own direction: no scan lies between.
fn camera(flight: &BlockFlight, exposure: &Exposure) -> Photo {
    Photo {
        centre: exposure.centre.into(),
        photo_from_ground: exposure.rotation,
        focal_mm: exposure.focal_px * flight.pixel_mm,
        principal_point_mm: [0.0; 2],
        distortion: 0.0,
        scan: Scan::digital(flight.pixel_mm, flight.width_px, flight.height_px),
        origin_px: [0.0; 2],
    }
}

/// What stands in the scene.
fn town(flight: &BlockFlight, area: Rectangle) -> Result<Flight, Error> {
    let sample = Flight::default();
    let tenth = 0.1 * flight.flying_height_m;
    if flight.relief_m > tenth {
        return Err(refuse("block_flight.relief_m", flight.relief_m, Allowed::PhotoRelief { most_m: tenth }));
    }
    if sample.lowest_building_m > tenth && flight.buildings > 0.0 {
        let allowed = Allowed::HeightAboveBuildings { least_m: 10.0 * sample.lowest_building_m };
        return Err(refuse("block_flight.flying_height_m", flight.flying_height_m, allowed));
    }
    let km2 = (area[2] - area[0]) * (area[3] - area[1]) * 1e-6;
    Ok(Flight {
        relief_m: flight.relief_m,
        buildings: (flight.buildings * km2) as usize,
        highest_building_m: sample.highest_building_m.min(tenth).max(sample.lowest_building_m),
        trees: (flight.trees * km2) as usize,
        seed: flight.seed,
        ..sample
    })
}

/// The ground under all photos.
fn ground_area(flight: &BlockFlight, exposures: &[Exposure]) -> Result<Rectangle, Error> {
    let rays = exposures.iter().map(|exposure| camera(flight, exposure).rays());
    let Some(seen) = seen_ground(rays, [flight.width_px, flight.height_px].map(f64::from), flight.relief_m) else {
        let allowed = match flight.view {
            BlockView::Oblique => Allowed::SmallImagesOfTilted,
            BlockView::Nadir | BlockView::TwoHeights => Allowed::SmallPixels,
        };
        return Err(refuse("block_flight.pixel_mm", flight.pixel_mm, allowed));
    };
    let longest = (seen[2] - seen[0]).max(seen[3] - seen[1]);
    check_length("block_flight.flying_height_m", true, flight.flying_height_m, longest)?;
    Ok(seen)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::FeatureOptions;

    fn small(view: BlockView) -> BlockFlight {
        BlockFlight {
            view,
            strips: 2,
            exposures: 2,
            width_px: 240,
            height_px: 180,
            pixel_mm: 0.1,
            relief_m: 30.0,
            ..BlockFlight::default()
        }
    }

    #[test]
    fn a_photo_shows_what_its_truth_says() {
        // What one photo shows lies, by the true orientations and level ground, near where another shows the same grey values.
        let flight = BlockFlight { relief_m: 0.0, buildings: 0.0, trees: 0.0, ..small(BlockView::Nadir) };
        let scene = BlockScene::new(&flight).unwrap();
        let (first, second) = (scene.photo(0).unwrap(), scene.photo(1).unwrap());
        let [from, to] = [0, 1].map(|k| scene.exposures[k]);
        let features = [&first, &second].map(|image| crate::features(image.view(), None, &FeatureOptions::default()).unwrap());
        let bytes = features.each_ref().map(|list| list.iter().flat_map(|f| f.descriptor).collect::<Vec<u8>>());
        let matches = crate::nearest_matches(&bytes[0], &bytes[1], &crate::NearestOptions::default()).unwrap();
        let near = matches.iter().filter(|m| {
            let (a, b) = (&features[0][m.left].point, &features[1][m.right].point);
            let [x, y] = from.on_level_ground([a.x, a.y], 240, 180).unwrap();
            to.project([x, y, 0.0], 240, 180).is_some_and(|seen| (seen[0] - b.x).abs() < 1.0 && (seen[1] - b.y).abs() < 1.0)
        });
        let near = near.count();
        assert!(near > 30 && 10 * near > 9 * matches.len(), "{near} of {}", matches.len());
    }

    #[test]
    fn the_town_does_not_repeat_itself() {
        // Nearest descriptors of photos that show no common ground: were the town the same at a distance, many of them would lie at that one.
        let flight = BlockFlight {
            forward_overlap: 0.0,
            side_overlap: 0.0,
            relief_m: 0.0,
            width_px: 400,
            height_px: 300,
            receiver_m: 0.0,
            ..small(BlockView::Nadir)
        };
        let scene = BlockScene::new(&flight).unwrap();
        let options = FeatureOptions::default();
        let seen: Vec<_> = (0..scene.photos()).map(|k| crate::features(scene.photo(k).unwrap().view(), None, &options).unwrap()).collect();
        let bytes: Vec<Vec<u8>> = seen.iter().map(|list| list.iter().flat_map(|f| f.descriptor).collect()).collect();
        let ground = |k: usize, point: &crate::ScalePoint| scene.exposures[k].on_level_ground([point.x, point.y], 400, 300).unwrap();
        for (a, b) in (0..seen.len()).flat_map(|a| (a + 1..seen.len()).map(move |b| (a, b))) {
            let matches = crate::nearest_matches(&bytes[a], &bytes[b], &crate::NearestOptions::default()).unwrap();
            let ways: Vec<[f64; 2]> = matches
                .iter()
                .map(|m| (ground(a, &seen[a][m.left].point), ground(b, &seen[b][m.right].point)))
                .map(|(from, to)| [to[0] - from[0], to[1] - from[1]])
                .filter(|way| way[0] * way[0] + way[1] * way[1] > 100.0 * 100.0)
                .collect();
            let alike = |way: &[f64; 2]| ways.iter().filter(|other| (other[0] - way[0]).abs().max((other[1] - way[1]).abs()) < 6.0).count();
            let most = ways.iter().map(alike).max().unwrap_or(0);
            assert!(most <= 6, "{most} of {} matches of photos {a} and {b} lie at one distance", matches.len());
        }
    }

    #[test]
    fn each_photo_is_the_same_whenever_it_is_taken() {
        let scene = BlockScene::new(&small(BlockView::TwoHeights)).unwrap();
        let again = BlockScene::new(&small(BlockView::TwoHeights)).unwrap();
        let _ = again.photo(3).unwrap();
        assert_eq!(scene.photo(1).unwrap(), again.photo(1).unwrap());
        assert_eq!(scene.recorded_position(1).unwrap(), again.recorded_position(1).unwrap());
        assert_eq!((scene.photos(), scene.truth().images.len()), (4, 4));
        let file = scene.photo_file(1).unwrap();
        let (decoded, read) = (crate::decode(&file, &crate::DecodeLimits::default()).unwrap(), ExifImage::read(&file, 240, 180));
        assert_eq!((decoded.grey, read.model.as_deref()), (scene.photo(1).unwrap(), Some("Simulated 0")));
        assert!((read.camera.unwrap().focal_mm - scene.exposures[1].focal_px * 0.1).abs() < 1e-5);
        let (read, recorded) = (read.position.unwrap(), scene.recorded_position(1).unwrap());
        assert!((read.longitude_deg - recorded[0]).abs() < 1e-9 && (read.latitude_deg - recorded[1]).abs() < 1e-9);
        assert!((read.height_m.unwrap() - recorded[2]).abs() < 1e-5);
        assert!(scene.photo(4).is_err() && scene.photo_file(4).is_err() && scene.recorded_position(4).is_err());
    }

    #[test]
    fn places_on_the_surface_are_seen_where_they_were_asked_for() {
        let flight = small(BlockView::Nadir);
        let scene = BlockScene::new(&flight).unwrap();
        let asked = [[10.25, 20.5], [60.0, 33.3], [0.0, 0.0]];
        let seen = scene.surface_at(1, &asked).unwrap();
        for (place, asked) in seen.iter().zip(asked) {
            let again = scene.exposures[1].project(*place, flight.width_px, flight.height_px).unwrap();
            assert!((0..2).all(|axis| (again[axis] - asked[axis]).abs() < 1e-6), "{asked:?} {again:?}");
        }
        assert!(scene.surface_at(1, &[[-0.1, 5.0]]).unwrap_err().to_string().contains("position in a photo"));
        assert!(scene.surface_at(1, &[[f64::NAN, 5.0]]).is_err() && scene.surface_at(99, &asked).is_err());
    }

    #[test]
    fn tilted_photos_show_a_scene_too() {
        let scene = BlockScene::new(&BlockFlight { strips: 1, exposures: 1, ..small(BlockView::Oblique) }).unwrap();
        assert_eq!((scene.photos(), scene.truth().cameras.len()), (5, 5));
        let photo = scene.photo(2).unwrap();
        let (least, most) = photo.data().iter().fold((255, 0), |(a, b), v| (v.min(&a).to_owned(), v.max(&b).to_owned()));
        assert!(most - least > 60, "{least} to {most}");
        scene.truth().check().unwrap();
    }

    #[test]
    fn recorded_positions_stray_as_told() {
        let flight = BlockFlight { strips: 10, exposures: 20, receiver_m: 2.0, ..small(BlockView::Nadir) };
        let flight = BlockFlight { flying_height_m: 200.0, relief_m: 5.0, ..flight };
        let scene = BlockScene::new(&flight).unwrap();
        let mut sum = 0.0;
        for (index, exposure) in scene.exposures.iter().enumerate() {
            let local = crate::local_from_geographic(scene.recorded_position(index).unwrap(), PLACE);
            sum += (0..3).map(|k| (local[k] - exposure.centre[k]) * (local[k] - exposure.centre[k])).sum::<f64>();
        }
        let deviation = (sum / 600.0).sqrt();
        assert!((deviation - 2.0).abs() < 0.3, "{deviation}");
    }

    #[test]
    fn flights_that_cannot_be_photographed_are_refused() {
        for flight in [
            BlockFlight { relief_m: 90.0, ..small(BlockView::Nadir) },
            BlockFlight { flying_height_m: 30.0, relief_m: 0.0, ..small(BlockView::Nadir) },
            BlockFlight { strips: 1000, ..small(BlockView::Nadir) },
            BlockFlight { pixel_mm: 1.0, ..small(BlockView::Oblique) },
            BlockFlight { width_px: 90_000, height_px: 90_000, ..small(BlockView::Nadir) },
            BlockFlight { receiver_m: f64::NAN, ..small(BlockView::Nadir) },
        ] {
            let refused = BlockScene::new(&flight).err();
            assert!(matches!(refused, Some(Error::InvalidOption { .. })), "{flight:?}: {refused:?}");
        }
    }
}
