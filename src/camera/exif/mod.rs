//! What EXIF and XMP tell of an image: its camera, how it is to be turned, where and in which attitude it was taken.

mod blocks;
mod camera;
mod fields;
mod in_parts;
mod label;

pub use camera::ExifCamera;
pub(crate) use label::camera_label;

use self::blocks::xmp_packet;
use self::fields::{Directory, Fields, Tag};
use super::xmp::{DroneRecord, Xmp};
use crate::FileSource;
use serde::{Deserialize, Serialize};

const MAKE: Tag = (Directory::Main, 0x010f);
const MODEL: Tag = (Directory::Main, 0x0110);
const XMP: Tag = (Directory::Main, 700);
const ORIENTATION: Tag = (Directory::Main, 0x0112);
const LATITUDE_REF: Tag = (Directory::Gps, 1);
const LATITUDE: Tag = (Directory::Gps, 2);
const LONGITUDE_REF: Tag = (Directory::Gps, 3);
const LONGITUDE: Tag = (Directory::Gps, 4);
const ALTITUDE_REF: Tag = (Directory::Gps, 5);
const ALTITUDE: Tag = (Directory::Gps, 6);
const H_POSITIONING_ERROR: Tag = (Directory::Gps, 31);

/// What EXIF and XMP of an image tell beside its pixels; what they do not tell is absent.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ExifImage {
    /// Also where the focal length is not told.
    pub make: Option<String>,
    pub model: Option<String>,
    pub camera: Option<ExifCamera>,
    /// How the stored image is turned for display, 1..8 as the standard counts: 1 not at all, 3 half round, 6 a quarter to the right, 8 a
    /// quarter to the left, the others mirrored too. Positions in px are always those of the stored image.
    pub orientation: Option<u8>,
    pub position: Option<ExifPosition>,
    /// What of the recorded position cannot be and was left out, with its value: all of it, or the height alone.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub impossible: Option<String>,
    /// Of the drone that took it; absent where it recorded nothing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub drone: Option<Box<DroneRecord>>,
}

/// A place on the earth as a receiver had it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ExifPosition {
    /// East positive.
    pub longitude_deg: f64,
    /// North positive.
    pub latitude_deg: f64,
    /// Above the level that the camera refers to, which most do not tell; absent where there is none.
    pub height_m: Option<f64>,
    /// Horizontal positioning error that the receiver states.
    pub error_m: Option<f64>,
}

impl ExifImage {
    /// Reads the EXIF and the XMP of a JPEG, PNG, TIFF or WebP file whose stored image has `width` x `height` px. Of a file without either
    /// nothing is known; of a damaged one, what can be read.
    ///
    /// # Source
    /// CIPA DC-008-2019, Exif 2.32, sections 4.6.4 to 4.6.6.
    pub fn read(file: &[u8], width: u64, height: u64) -> Self {
        let (exif, xmp) = metadata(file);
        let camera = ExifCamera::of(exif.as_ref(), &xmp, [width, height]);
        let drone = (xmp.drone != DroneRecord::default()).then(|| Box::new(xmp.drone));
        let Some(exif) = exif else { return Self { camera, drone, ..Self::default() } };
        let (position, impossible) = position(&exif);
        let orientation = exif.number(ORIENTATION).filter(|n| (1.0..=8.0).contains(n)).map(|n| n as u8);
        Self { make: exif.text(MAKE), model: exif.text(MODEL), camera, orientation, position, impossible, drone }
    }
}

/// The EXIF of a file, and its XMP, which a TIFF file holds in a field.
fn metadata(file: &[u8]) -> (Option<Fields<&[u8]>>, Xmp) {
    let exif = Fields::of(file);
    let in_tiff = || exif.as_ref().filter(|_| file.starts_with(b"II") || file.starts_with(b"MM")).and_then(|exif| exif.bytes(XMP));
    let xmp = xmp_packet(file).or_else(in_tiff).map(Xmp::of).unwrap_or_default();
    (exif, xmp)
}

/// Heights beyond so many metres are damaged fields.
const MOST_HEIGHT_M: f64 = 1e5;

/// What receivers without a fix write.
pub(crate) const NOWHERE: &str = "longitude 0, latitude 0";

/// The place, and what of it cannot be: an angle or a height out of range, or (0, 0), which receivers without a fix write. Absent where its
/// hemisphere is not told.
fn position<S: FileSource>(exif: &Fields<S>) -> (Option<ExifPosition>, Option<String>) {
    let longitude = angle(exif, LONGITUDE, LONGITUDE_REF, ["E", "W"]);
    let latitude = angle(exif, LATITUDE, LATITUDE_REF, ["N", "S"]);
    let (Some(longitude_deg), Some(latitude_deg)) = (longitude, latitude) else { return (None, None) };
    if latitude_deg.abs() > 90.0 {
        return (None, Some(format!("latitude {latitude_deg}")));
    }
    if longitude_deg.abs() > 180.0 {
        return (None, Some(format!("longitude {longitude_deg}")));
    }
    if longitude_deg == 0.0 && latitude_deg == 0.0 {
        return (None, Some(NOWHERE.into()));
    }
    // The reference 1 says below sea level.
    let sign = if exif.number(ALTITUDE_REF) == Some(1.0) { -1.0 } else { 1.0 };
    let height = exif.number(ALTITUDE).filter(|v| v.is_finite()).map(|v| sign * v + 0.0);
    let height_m = height.filter(|v| v.abs() <= MOST_HEIGHT_M);
    let impossible = height.filter(|_| height_m.is_none()).map(|v| format!("height {v} m"));
    (Some(ExifPosition { longitude_deg, latitude_deg, height_m, error_m: exif.positive(H_POSITIONING_ERROR) }), impossible)
}

/// Degrees, minutes and seconds with the hemisphere: positive in the first one.
fn angle<S: FileSource>(exif: &Fields<S>, tag: Tag, hemisphere: Tag, [first, second]: [&str; 2]) -> Option<f64> {
    let [degrees, minutes, seconds] = exif.three_ratios(tag)?;
    let sign = match exif.text(hemisphere)?.to_ascii_uppercase() {
        side if side == first => 1.0,
        side if side == second => -1.0,
        _ => return None,
    };
    let degrees = degrees + minutes / 60.0 + seconds / 3600.0;
    degrees.is_finite().then_some(sign * degrees + 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A TIFF file of nothing but an orientation and a list of GPS fields: tag, type, value.
    fn file(orientation: u16, gps: &[(u16, u16, Vec<u8>)]) -> Vec<u8> {
        let entry = |tag: u16, kind: u16, count: u32, bytes: [u8; 4]| {
            [&tag.to_be_bytes()[..], &kind.to_be_bytes(), &count.to_be_bytes(), &bytes].concat()
        };
        let mut out = b"MM\0*\0\0\0\x08\0\x02".to_vec();
        let [a, b] = orientation.to_be_bytes();
        out.extend(entry(0x0112, 3, 1, [a, b, 0, 0]));
        let list = 8 + 2 + 2 * 12 + 4;
        out.extend(entry(0x8825, 4, 1, (list as u32).to_be_bytes()));
        out.extend([0; 4]);
        out.extend((gps.len() as u16).to_be_bytes());
        let mut behind = Vec::new();
        for (tag, kind, value) in gps {
            let size = [0, 1, 1, 2, 4, 8][usize::from(*kind)];
            let place = (list + 2 + 12 * gps.len() + 4 + behind.len()) as u32;
            let bytes = value.clone().try_into().unwrap_or_else(|long: Vec<u8>| {
                behind.extend(long);
                place.to_be_bytes()
            });
            out.extend(entry(*tag, *kind, (value.len() / size) as u32, bytes));
        }
        out.extend([0; 4]);
        out.extend(behind);
        out
    }

    fn text(letter: u8) -> Vec<u8> {
        vec![letter, 0, 0, 0]
    }

    fn ratios(values: &[(u32, u32)]) -> Vec<u8> {
        values.iter().flat_map(|(n, d)| [n.to_be_bytes(), d.to_be_bytes()].concat()).collect()
    }

    fn place(south: bool, west: bool) -> Vec<(u16, u16, Vec<u8>)> {
        vec![
            (1, 2, text(if south { b'S' } else { b'N' })),
            (2, 5, ratios(&[(30, 1), (10, 1), (180, 10)])),
            (3, 2, text(if west { b'W' } else { b'E' })),
            (4, 5, ratios(&[(98, 1), (5, 1), (0, 1)])),
        ]
    }

    #[test]
    fn a_position_has_its_hemispheres_and_its_height() {
        let read = |fields: &[(u16, u16, Vec<u8>)]| ExifImage::read(&file(6, fields), 10, 10);
        let found = read(&place(false, true));
        assert_eq!(found.orientation, Some(6));
        let position = found.position.unwrap();
        assert!((position.latitude_deg - (30.0 + 10.0 / 60.0 + 18.0 / 3600.0)).abs() < 1e-12, "{position:?}");
        assert!((position.longitude_deg + (98.0 + 5.0 / 60.0)).abs() < 1e-12 && position.height_m.is_none(), "{position:?}");
        assert!(read(&place(true, false)).position.unwrap().latitude_deg < -30.0);
        let below =
            [place(false, false), vec![(5, 1, vec![1, 0, 0, 0]), (6, 5, ratios(&[(125, 10)])), (31, 5, ratios(&[(3, 2)]))]].concat();
        let position = read(&below).position.unwrap();
        assert_eq!((position.height_m, position.error_m), (Some(-12.5), Some(1.5)));
    }

    #[test]
    fn a_position_that_is_none_is_left_out() {
        let without = |tag: u16| place(false, false).into_iter().filter(|field| field.0 != tag).collect::<Vec<_>>();
        for tag in 1..=4 {
            assert!(ExifImage::read(&file(1, &without(tag)), 10, 10).position.is_none(), "{tag}");
        }
        let changed = |tag: u16, value: Vec<u8>| {
            place(false, false)
                .into_iter()
                .map(|field| if field.0 == tag { (tag, field.1, value.clone()) } else { field })
                .collect::<Vec<_>>()
        };
        let nowhere = vec![(1, 2, text(b'N')), (2, 5, ratios(&[(0, 1); 3])), (3, 2, text(b'E')), (4, 5, ratios(&[(0, 1); 3]))];
        // Nothing is said of fields that tell no place.
        for (fields, said) in [
            (changed(1, text(b'X')), None),
            (changed(2, ratios(&[(1, 0)])), None),
            (changed(2, ratios(&[(91, 1)])), Some("latitude 91")),
            (changed(4, ratios(&[(u32::MAX, 1)])), Some("longitude 4294967295")),
            (nowhere, Some("longitude 0, latitude 0")),
        ] {
            let found = ExifImage::read(&file(1, &fields), 10, 10);
            assert!(found.position.is_none(), "{fields:?}");
            assert_eq!(found.impossible.as_deref(), said, "{fields:?}");
        }
        let high = [place(false, false), vec![(6, 5, ratios(&[(u32::MAX, 1)]))]].concat();
        let found = ExifImage::read(&file(1, &high), 10, 10);
        assert_eq!((found.position.unwrap().height_m, found.impossible.as_deref()), (None, Some("height 4294967295 m")));
        assert_eq!(ExifImage::read(b"no file of a known kind", 10, 10), ExifImage::default());
        assert_eq!(ExifImage::read(&file(9, &[]), 10, 10).orientation, None);
    }
}
