//! The tags of GeoTIFF: where a TIFF lies, in which system, and which value stands for nothing.

use super::georeference::Georeference;
use crate::error::refuse;
use crate::image::{Directory, checked_directory};
use crate::{Error, FileSource, Refusal};

pub(super) const PIXEL_SCALE: u64 = 33550;
pub(super) const TIE_POINTS: u64 = 33922;
pub(super) const TRANSFORMATION: u64 = 34264;
pub(super) const KEYS: u64 = 34735;
/// Of GDAL, in no standard.
pub(super) const NO_DATA: u64 = 42113;

pub(super) const MODEL_TYPE: u16 = 1024;
pub(super) const RASTER_TYPE: u16 = 1025;
pub(super) const PROJECTED_SYSTEM: u16 = 3072;
pub(super) const PROJECTED: u16 = 1;
const GEOGRAPHIC: u16 = 2;
const PIXEL_IS_POINT: u16 = 2;
/// Says 'described by other keys'.
const USER_DEFINED: u16 = 32767;

/// What a TIFF says of its place.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct GeoTags {
    pub georeference: Option<Georeference>,
    /// The code of its projected system, where it has one.
    pub epsg: Option<u16>,
    pub no_data: Option<f64>,
}

impl GeoTags {
    /// Reads the tags of the first image.
    ///
    /// # Errors
    /// [`Error::UnreadableImage`] for a truncated file; [`Error::InvalidInput`] where coordinates are degrees, or the tags place no picture.
    ///
    /// # Source
    /// OGC 19-008r4, GeoTIFF standard 1.1.
    pub fn read<S: FileSource>(tiff: S) -> Result<Self, Error> {
        let directory = checked_directory(tiff)?;
        let keys = directory.all_shorts(KEYS).unwrap_or_default();
        if key(&keys, MODEL_TYPE) == Some(GEOGRAPHIC) {
            return refuse_degrees();
        }
        let georeference = match transformation(&directory) {
            Some(of_corner) => {
                let is_point = key(&keys, RASTER_TYPE) == Some(PIXEL_IS_POINT);
                let half = if is_point { -0.5 } else { 0.0 };
                Some(Georeference { origin: of_corner.ground([half, half]), ..of_corner }.checked()?)
            }
            None => None,
        };
        let epsg = key(&keys, PROJECTED_SYSTEM).filter(|code| *code != USER_DEFINED && *code != 0);
        let no_data = directory.text(NO_DATA).and_then(|text| text.parse().ok());
        Ok(Self { georeference, epsg, no_data })
    }
}

/// Angles are no lengths: north and east differ by the cosine of the latitude.
pub(super) fn refuse_degrees<T>() -> Result<T, Error> {
    refuse(Refusal::Degrees)
}

/// By which (0, 0) of the raster, be that a corner or a centre, and its steps lie on the map.
fn transformation<S: FileSource>(directory: &Directory<S>) -> Option<Georeference> {
    if let Some(&[a, b, _, x, d, e, _, y, ..]) = directory.doubles(TRANSFORMATION).as_deref() {
        return Some(Georeference { origin: [x, y], by_column: [a, d], by_row: [b, e] });
    }
    let (scale, ties) = (directory.doubles(PIXEL_SCALE)?, directory.doubles(TIE_POINTS)?);
    let (&[sx, sy, ..], &[i, j, _, x, y, ..]) = (scale.as_slice(), ties.as_slice()) else { return None };
    Some(Georeference { origin: [x - i * sx, y + j * sy], by_column: [sx, 0.0], by_row: [0.0, -sy] })
}

/// The value of a key that stands in the directory of keys itself.
fn key(keys: &[u16], wanted: u16) -> Option<u16> {
    let entries = keys.get(4..)?.as_chunks::<4>().0;
    entries.iter().find(|entry| entry[0] == wanted && entry[1] == 0).map(|entry| entry[3])
}
