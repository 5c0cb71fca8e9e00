//! What EXIF tells of an image: its camera, how it is to be turned, where it was taken.

use std::io::Cursor;

use exif::{Exif, In, Reader, Tag, Value};
use serde::{Deserialize, Serialize};

/// Camera data of an EXIF block.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ExifCamera {
    pub make: Option<String>,
    pub model: Option<String>,
    /// Focal length in mm.
    pub focal_mm: f64,
    /// Side of a pixel of the stored image in mm, from the focal-plane resolution or the 35 mm equivalent; absent where neither is given.
    pub pixel_mm: Option<f64>,
}

/// What the EXIF of an image tells beside its pixels; what it does not tell is absent.
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
    /// Reads the EXIF of a JPEG, PNG, TIFF or WebP file whose stored image has `width` x `height` px. Of a file without EXIF nothing is known.
    ///
    /// # Source
    /// CIPA DC-008-2019, Exif 2.32, sections 4.6.4 to 4.6.6.
    pub fn read(file: &[u8], width: u64, height: u64) -> Self {
        let Some(exif) = read_exif(file) else { return Self::default() };
        let (position, impossible) = position(&exif);
        let orientation = number(&exif, Tag::Orientation).filter(|n| (1.0..=8.0).contains(n)).map(|n| n as u8);
        Self {
            make: text(&exif, Tag::Make),
            model: text(&exif, Tag::Model),
            camera: ExifCamera::of(&exif, width, height),
            orientation,
            position,
            impossible,
        }
    }
}

/// Diagonal of the 36 mm x 24 mm frame to which the 35 mm equivalent of a focal length refers.
const FRAME_DIAGONAL_MM: f64 = 43.266_615_305_567_87;

impl ExifCamera {
    /// Reads the camera from the EXIF of a JPEG, PNG, TIFF or WebP file whose stored image has `width` x `height` px.
    ///
    /// Absent where the file has no EXIF, where it is damaged, or where it does not name the focal length.
    pub fn read(file: &[u8], width: u64, height: u64) -> Option<Self> {
        Self::of(&read_exif(file)?, width, height)
    }

    fn of(exif: &Exif, width: u64, height: u64) -> Option<Self> {
        let focal_mm = positive(exif, Tag::FocalLength)?;
        let pixel_mm = focal_plane_pixel_mm(exif, width, height).or_else(|| equivalent_pixel_mm(exif, focal_mm, width, height));
        Some(Self { make: text(exif, Tag::Make), model: text(exif, Tag::Model), focal_mm, pixel_mm })
    }
}

/// What can be read of the file's EXIF; fields that are damaged are left out.
fn read_exif(file: &[u8]) -> Option<Exif> {
    let mut reader = Reader::new();
    reader.continue_on_error(true);
    reader.read_from_container(&mut Cursor::new(file)).or_else(|error| error.distill_partial_result(|_| {})).ok()
}

/// Pixel side from the focal-plane resolution, which counts pixels of the image as the camera took it.
fn focal_plane_pixel_mm(exif: &Exif, width: u64, height: u64) -> Option<f64> {
    let unit_mm = match number(exif, Tag::FocalPlaneResolutionUnit).map_or(2, |unit| unit as u32) {
        2 => 25.4,
        3 => 10.0,
        4 => 1.0,
        5 => 0.001,
        _ => return None,
    };
    let taken_pixel_mm = unit_mm / positive(exif, Tag::FocalPlaneXResolution)?;
    // The longer sides are compared, since software that turns an image upright may leave the EXIF as it was.
    let taken_side = positive(exif, Tag::PixelXDimension).map(|x| x.max(positive(exif, Tag::PixelYDimension).unwrap_or(0.0)));
    let stored_side = width.max(height) as f64;
    plausible(taken_pixel_mm * taken_side.map_or(1.0, |taken| taken / stored_side))
}

/// Pixel side from the focal length that has the same angle of view on the 35 mm frame, diagonal to diagonal.
fn equivalent_pixel_mm(exif: &Exif, focal_mm: f64, width: u64, height: u64) -> Option<f64> {
    let equivalent_mm = positive(exif, Tag::FocalLengthIn35mmFilm)?;
    let diagonal_px = (width as f64 * width as f64 + height as f64 * height as f64).sqrt();
    plausible(focal_mm / equivalent_mm * FRAME_DIAGONAL_MM / diagonal_px)
}

/// A pixel side between 0.1 µm and 1 mm: anything else is a damaged field, not a camera.
fn plausible(pixel_mm: f64) -> Option<f64> {
    (1e-4..=1.0).contains(&pixel_mm).then_some(pixel_mm)
}

/// Heights beyond so many metres are damaged fields.
const MOST_HEIGHT_M: f64 = 1e5;

/// The place, and what of it cannot be: an angle or a height out of range, or (0, 0), which receivers without a fix write. Absent where its
/// hemisphere is not told.
fn position(exif: &Exif) -> (Option<ExifPosition>, Option<String>) {
    let longitude = angle(exif, Tag::GPSLongitude, Tag::GPSLongitudeRef, ["E", "W"]);
    let latitude = angle(exif, Tag::GPSLatitude, Tag::GPSLatitudeRef, ["N", "S"]);
    let (Some(longitude_deg), Some(latitude_deg)) = (longitude, latitude) else { return (None, None) };
    if latitude_deg.abs() > 90.0 {
        return (None, Some(format!("latitude {latitude_deg}")));
    }
    if longitude_deg.abs() > 180.0 {
        return (None, Some(format!("longitude {longitude_deg}")));
    }
    if longitude_deg == 0.0 && latitude_deg == 0.0 {
        return (None, Some("longitude 0, latitude 0".into()));
    }
    // The reference 1 says below sea level.
    let sign = if number(exif, Tag::GPSAltitudeRef) == Some(1.0) { -1.0 } else { 1.0 };
    let height = number(exif, Tag::GPSAltitude).filter(|v| v.is_finite()).map(|v| sign * v + 0.0);
    let height_m = height.filter(|v| v.abs() <= MOST_HEIGHT_M);
    let impossible = height.filter(|_| height_m.is_none()).map(|v| format!("height {v} m"));
    (Some(ExifPosition { longitude_deg, latitude_deg, height_m, error_m: positive(exif, Tag::GPSHPositioningError) }), impossible)
}

/// Degrees, minutes and seconds with the hemisphere: positive in the first one.
fn angle(exif: &Exif, tag: Tag, hemisphere: Tag, [first, second]: [&str; 2]) -> Option<f64> {
    let Value::Rational(parts) = &exif.get_field(tag, In::PRIMARY)?.value else { return None };
    let sign = match text(exif, hemisphere)?.to_ascii_uppercase() {
        side if side == first => 1.0,
        side if side == second => -1.0,
        _ => return None,
    };
    let part = |k: usize| parts.get(k).map_or(0.0, |r| f64::from(r.num) / f64::from(r.denom));
    let degrees = part(0) + part(1) / 60.0 + part(2) / 3600.0;
    degrees.is_finite().then_some(sign * degrees + 0.0)
}

fn positive(exif: &Exif, tag: Tag) -> Option<f64> {
    number(exif, tag).filter(|n| n.is_finite() && *n > 0.0)
}

fn number(exif: &Exif, tag: Tag) -> Option<f64> {
    match &exif.get_field(tag, In::PRIMARY)?.value {
        Value::Rational(v) => v.first().map(|r| f64::from(r.num) / f64::from(r.denom)),
        Value::SRational(v) => v.first().map(|r| f64::from(r.num) / f64::from(r.denom)),
        // Not what the standard asks for, but written by software that rescales images.
        Value::Float(v) => v.first().map(|&n| f64::from(n)),
        Value::Double(v) => v.first().copied(),
        value => value.get_uint(0).map(f64::from),
    }
}

fn text(exif: &Exif, tag: Tag) -> Option<String> {
    let Value::Ascii(lines) = &exif.get_field(tag, In::PRIMARY)?.value else {
        return None;
    };
    let text = String::from_utf8_lossy(lines.first()?).trim_matches(|c: char| c.is_whitespace() || c == '\0').to_owned();
    (!text.is_empty()).then_some(text)
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
