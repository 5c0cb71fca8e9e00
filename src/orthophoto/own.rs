//! A placed image as a picture of the ground.

use super::outcome::Placement;
use super::rectify::{Rectified, rectify};
use super::reference::Orthophoto;
use crate::{Bands, Error};

/// Larger pictures are made of larger pixels.
const MOST_PIXELS: f64 = 6.4e7;

/// Resamples a placed image to the ground under it, along the directions of the orthophoto, with pixels as large as those of the image.
///
/// # Errors
/// As [`rectify`]; [`Error::InvalidInput`] for another size than that of a scan.
pub fn rectify_placed(image: &Bands, placement: &Placement, reference: &Orthophoto) -> Result<Rectified, Error> {
    let of = reference.georeference.with_gsd(placement.gsd_m);
    let corners: Vec<[f64; 2]> = placement.footprint.iter().map(|place| of.pixel(*place)).collect();
    let extent = |axis: usize| {
        let values = corners.iter().map(|corner| corner[axis]);
        (values.clone().fold(f64::INFINITY, f64::min), values.fold(f64::NEG_INFINITY, f64::max))
    };
    let [(left, right), (top, bottom)] = [extent(0), extent(1)];
    let enlarged = (((right - left) * (bottom - top) / MOST_PIXELS).sqrt()).max(1.0);
    // On whole pixels of the orthophoto's system, so that pictures of several images fit to each other.
    let georeference = of.with_gsd(enlarged * placement.gsd_m);
    let first = [left, top].map(|v| (v / enlarged).floor());
    let size = [right - left, bottom - top].map(|length| ((length / enlarged).ceil() + 1.0).max(1.0) as usize);
    let georeference = crate::Georeference { origin: georeference.ground(first), ..georeference };
    let rectified = |image: &Bands| rectify(image, &placement.camera, &placement.pose, &reference.heights, &georeference, size);
    match &placement.film {
        Some(film) => rectified(&film.frame(&image.views())?),
        None => rectified(image),
    }
}
