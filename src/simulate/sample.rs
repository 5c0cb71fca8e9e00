//! The simulated pair with everything that a measurement of it needs and everything that is known of it.

use super::buckets::Rectangle;
use super::flight::Flight;
use super::ground_area::{seen_ground, with_surroundings};
use super::photo::{Photo, Scan, photos};
use super::random::{Random, Stream};
use super::render::render;
use super::scene::{Moment, Scene};
use super::sensor::Sensor;
use super::truth::right_positions;
use super::view::View;
use crate::camera::{CameraMm, Fiducial};
use crate::catalogue::refuse;
use crate::orientation::FiveParameters;
use crate::{Allowed, Error, GreyImage};

/// A simulated pair and its truth.
#[derive(Debug, Clone)]
pub struct Sample {
    /// The patches that were cut from the scans of both photos.
    pub left: GreyImage,
    pub right: GreyImage,
    pub camera: CameraMm,
    /// Fiducial marks as measured, in px of the whole scans; the centre of a scan's top-left pixel is (0.5, 0.5).
    pub left_fiducials: Vec<Fiducial>,
    pub right_fiducials: Vec<Fiducial>,
    /// Column and row of the scan's pixel that is the patch's top-left one: whole numbers.
    pub left_origin: [f64; 2],
    pub right_origin: [f64; 2],
    /// The base component b at photo scale in mm.
    pub base_mm: f64,
    /// The true dependent relative orientation of the right photo.
    pub truth: FiveParameters,
    /// For each left pixel, row by row, the `[x, y]` in px of the right patch at which what its centre shows is seen; NaN where
    /// that is hidden or outside, or covered by a moving car in either image. The centre of the patch's top-left pixel is (0.5, 0.5).
    pub right_position: Vec<[f32; 2]>,
}

/// Renders the default flight with another seed.
///
/// # Errors
/// None for any seed; those of [`simulate`] in principle.
pub fn sample_pair(seed: u32) -> Result<Sample, Error> {
    simulate(&Flight { seed, ..Flight::default() })
}

/// Flies over a synthetic scene, takes two photos, scans them and cuts patches of the same ground.
///
/// The same flight gives the same bytes natively and as WebAssembly.
///
/// # Errors
/// [`Error::InvalidOption`], naming the field and its range; a NaN is in no range.
pub fn simulate(flight: &Flight) -> Result<Sample, Error> {
    let Stage { scene, photos, mut scan_random } = Stage::new(flight)?;
    let (width, height) = (flight.width_px, flight.height_px);
    let [left_photo, right_photo] = &photos;
    let left_view = View::new(&scene, left_photo, Moment::First, width, height);
    let right_view = View::new(&scene, right_photo, Moment::Second, width, height);
    let take = |view: &View<'_>, psf_px, gain, offset_grey, [noise, grain]: [Stream; 2]| {
        let Flight { noise_grey, grain_grey, grain_px, haze, .. } = *flight;
        let sensor = Sensor { gain, offset_grey, noise_grey, grain_grey, grain_px, haze };
        let random = [noise, grain].map(|stream| Random::new(flight.seed, stream));
        sensor.record(&render(view, width, height, psf_px), width, height, random)
    };
    let [left, right] = &photos;
    Ok(Sample {
        left: take(&left_view, flight.psf_px, 1.0, 0.0, [Stream::LeftNoise, Stream::LeftGrain])?,
        right: take(&right_view, flight.right_psf_px(), flight.gain, flight.offset_grey, [Stream::RightNoise, Stream::RightGrain])?,
        camera: camera(flight),
        left_fiducials: left.scan.measure(flight.fiducial_noise_px, &mut scan_random[0]),
        right_fiducials: right.scan.measure(flight.fiducial_noise_px, &mut scan_random[1]),
        left_origin: left.origin_px,
        right_origin: right.origin_px,
        base_mm: flight.base_mm,
        truth: flight.orientation(),
        right_position: right_positions(&left_view, &right_view, width, height),
    })
}

/// Refuses what [`simulate`] refuses, at once: nothing is built or rendered.
///
/// # Errors
/// As [`simulate`].
pub fn check_flight(flight: &Flight) -> Result<(), Error> {
    Placed::new(flight).map(|_| ())
}

/// A flight before the shutter opens.
pub(super) struct Stage {
    pub(super) scene: Scene,
    pub(super) photos: [Photo; 2],
    /// The random numbers of both scans, after their geometry was drawn.
    scan_random: [Random; 2],
}

impl Stage {
    /// Places the photos of a flight and builds its scene.
    pub(super) fn new(flight: &Flight) -> Result<Self, Error> {
        let Placed { photos, scan_random, area } = Placed::new(flight)?;
        Ok(Self { scene: Scene::new(flight, area), photos, scan_random })
    }
}

/// The photos of a flight over ground that is not built yet.
struct Placed {
    photos: [Photo; 2],
    scan_random: [Random; 2],
    /// The ground that has to be built.
    area: Rectangle,
}

impl Placed {
    /// Checks a flight and places its photos.
    fn new(flight: &Flight) -> Result<Self, Error> {
        flight.check()?;
        let mut scan_random = [Stream::LeftScan, Stream::RightScan].map(|stream| Random::new(flight.seed, stream));
        let scans = scan_random.each_mut().map(|random| Scan::new(flight.pixel_mm, random));
        let photos = photos(flight, scans, cut_px(&mut Random::new(flight.seed, Stream::Cut)));
        let size = [flight.width_px as f64, flight.height_px as f64];
        let Some(seen) = seen_ground(photos.iter().map(Photo::rays), size, flight.relief_m) else {
            return Err(refuse("flight.focal_mm", flight.focal_mm, Allowed::LongFocalLength));
        };
        let area = with_surroundings(seen, flight.highest_building_m);
        Ok(Self { photos, scan_random, area })
    }
}

/// Patches are never cut exactly: up to two whole pixels aside.
fn cut_px(random: &mut Random) -> [f64; 2] {
    [0, 1].map(|_| random.between(-2.5, 2.5).round())
}

/// Pixels come from the fiducial marks, so that the camera names none.
fn camera(flight: &Flight) -> CameraMm {
    CameraMm {
        principal_point_mm: [flight.principal_x_mm, flight.principal_y_mm],
        radial_distortion: [flight.distortion, 0.0, 0.0],
        ..CameraMm::without_distortion(flight.focal_mm, None)
    }
}
