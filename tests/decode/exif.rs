//! The camera of EXIF blocks made here.

use tiepoint::{CameraCaution, CameraOrigin, ExifCamera};

use super::decode;
use super::jpeg_writer::{Jpeg, segment};

/// Type and value of an EXIF field.
#[derive(Clone)]
pub enum Value {
    Text(&'static str),
    Short(u16),
    Rational(u32, u32),
    Double(f64),
}

pub const MAKE: u16 = 271;
pub const MODEL: u16 = 272;
pub const FOCAL_LENGTH: u16 = 37386;
pub const PIXEL_X: u16 = 40962;
pub const PIXEL_Y: u16 = 40963;
pub const PLANE_X: u16 = 41486;
pub const PLANE_UNIT: u16 = 41488;
pub const FOCAL_35: u16 = 41989;

/// A TIFF structure with one directory of the first fields and an EXIF directory of the others.
pub fn exif_block(fields: &[(u16, Value)]) -> Vec<u8> {
    let (exif, mut main): (Vec<_>, Vec<_>) = fields.iter().cloned().partition(|(tag, _)| *tag >= 0x8000);
    let mut block = b"II*\0\x08\0\0\0".to_vec();
    let main_length = 2 + 12 * (main.len() + 1) + 4;
    main.push((0x8769, Value::Short(0)));
    let mut far = Vec::new();
    let far_start = 8 + main_length + 2 + 12 * exif.len() + 4;
    for directory in [main, exif] {
        block.extend((directory.len() as u16).to_le_bytes());
        for (tag, value) in directory {
            let (kind, count, mut bytes) = match value {
                _ if tag == 0x8769 => (4u16, 1u32, ((8 + main_length) as u32).to_le_bytes().to_vec()),
                Value::Text(text) => (2, text.len() as u32 + 1, [text.as_bytes(), &[0]].concat()),
                Value::Short(v) => (3, 1, v.to_le_bytes().to_vec()),
                Value::Rational(n, d) => (5, 1, [n.to_le_bytes(), d.to_le_bytes()].concat()),
                Value::Double(v) => (12, 1, v.to_le_bytes().to_vec()),
            };
            block.extend(tag.to_le_bytes());
            block.extend(kind.to_le_bytes());
            block.extend(count.to_le_bytes());
            if bytes.len() > 4 {
                let at = (far_start + far.len()) as u32;
                far.append(&mut bytes);
                bytes = at.to_le_bytes().to_vec();
            }
            bytes.resize(4, 0);
            block.extend(bytes);
        }
        block.extend([0; 4]);
    }
    block.extend(far);
    block
}

/// A JPEG of 400 x 300 px with this EXIF block.
fn jpeg_with(block: &[u8]) -> Vec<u8> {
    let jpeg = Jpeg::baseline(400, 300, &[(1, 1, 1)]);
    let mut file = vec![0xff, 0xd8];
    segment(&mut file, 0xe1, &[b"Exif\0\0", block].concat());
    file.extend(&jpeg.write(|_, _, _| 99)[2..]);
    file
}

fn camera(fields: &[(u16, Value)]) -> Option<ExifCamera> {
    decode(&jpeg_with(&exif_block(fields))).expect("the image is sound").camera
}

fn pixel_um(fields: &[(u16, Value)]) -> Option<f64> {
    camera(fields).expect("a camera").pixel_mm.map(|mm| (mm * 1e6).round() / 1e3)
}

use Value::{Double, Rational, Short, Text};

#[test]
fn make_model_and_focal_length() {
    let camera = camera(&[(MAKE, Text("  Canon ")), (MODEL, Text("PowerShot")), (FOCAL_LENGTH, Rational(45, 10))]).unwrap();
    let origin = CameraOrigin::FocalLengthAlone;
    assert_eq!(
        camera,
        ExifCamera { make: Some("Canon".into()), model: Some("PowerShot".into()), focal_mm: 4.5, origin, ..ExifCamera::default() }
    );
}

#[test]
fn pixel_from_the_focal_plane_resolution() {
    let focal = (FOCAL_LENGTH, Rational(50, 1));
    // 2,540 px an inch, 1,000 px a cm, 100 px a mm: 10 µm.
    for (unit, resolution) in [(2, 2540), (3, 1000), (4, 100)] {
        let fields = [focal.clone(), (PLANE_X, Rational(resolution, 1)), (PLANE_UNIT, Short(unit))];
        assert_eq!(pixel_um(&fields), Some(10.0), "unit {unit}");
    }
    assert_eq!(pixel_um(&[focal.clone(), (PLANE_X, Rational(2540, 1))]), Some(10.0), "inches where no unit is given");
    assert_eq!(pixel_um(&[focal, (PLANE_X, Double(2540.0))]), Some(10.0), "a number of another type");
}

#[test]
fn pixel_of_a_reduced_image() {
    let fields = |x, y| [(FOCAL_LENGTH, Rational(50, 1)), (PLANE_X, Rational(2540, 1)), (PIXEL_X, Short(x)), (PIXEL_Y, Short(y))];
    assert_eq!(pixel_um(&fields(400, 300)), Some(10.0));
    assert_eq!(pixel_um(&fields(4000, 3000)), Some(100.0), "the image was reduced tenfold");
    assert_eq!(pixel_um(&fields(300, 400)), Some(10.0), "the image was turned");
}

#[test]
fn pixel_from_the_35_mm_equivalent() {
    // The diagonal of 500 px sees what 43.267 mm see at 100 mm; at 50 mm it has half that length.
    let fields = [(FOCAL_LENGTH, Rational(50, 1)), (FOCAL_35, Short(100))];
    assert_eq!(pixel_um(&fields), Some(43.267));
    let both = [(FOCAL_LENGTH, Rational(50, 1)), (FOCAL_35, Short(430)), (PLANE_X, Rational(2540, 1))];
    assert_eq!(pixel_um(&both), Some(10.0), "the focal plane goes first");
    let broken = [(FOCAL_LENGTH, Rational(50, 1)), (FOCAL_35, Short(100)), (PLANE_X, Rational(0, 0))];
    assert_eq!(pixel_um(&broken), Some(43.267), "0/0 is no resolution");
}

#[test]
fn a_focal_plane_of_another_size_of_the_photo_is_not_used() {
    let focal = (FOCAL_LENGTH, Rational(50, 1));
    let by_equivalent = [focal, (FOCAL_35, Short(100)), (PLANE_X, Rational(2540, 1))];
    // 13.2 mm of 400 px are pixels of 33 µm, and those of a photo of twice as many px half as large.
    let of_sensor = [
        (MAKE, Text("DJI")),
        (MODEL, Text("FC6310")),
        (FOCAL_LENGTH, Rational(88, 10)),
        (PLANE_X, Rational(25_400, 1)),
        (PLANE_UNIT, Short(2)),
    ];
    let halved = of_sensor.map(|(tag, value)| (tag, if tag == PLANE_X { Rational(25_400_000, 14_667) } else { value }));
    for (what, fields, pixel_um, expected_um) in [("35 mm", &by_equivalent[..], 10.0, 43.267), ("sensor", &halved[..], 14.667, 29.333)] {
        let camera = camera(fields).unwrap();
        assert_eq!((camera.pixel_mm, camera.origin), (None, CameraOrigin::FocalLengthAlone), "{what}");
        let [CameraCaution::FocalPlane { pixel_um: own, expected_um: other }] = camera.cautions[..] else {
            panic!("{what}: {:?}", camera.cautions)
        };
        assert!((own - pixel_um).abs() < 1e-3 && (other - expected_um).abs() < 1e-3, "{what}: {own} {other}");
    }
}

#[test]
fn pixel_from_the_size_of_the_sensor() {
    let fields =
        |fields: &[(u16, Value)]| [&[(MAKE, Text("DJI")), (MODEL, Text("FC6310")), (FOCAL_LENGTH, Rational(88, 10))], fields].concat();
    // 400 x 300 px of 13.2 mm x 8.8 mm: all of the height, and part of the width.
    let listed = camera(&fields(&[])).unwrap();
    assert_eq!((listed.origin, pixel_um(&fields(&[]))), (CameraOrigin::SensorTable, Some(29.333)));
    let equivalent = camera(&fields(&[(FOCAL_35, Short(24))])).unwrap();
    assert_eq!(equivalent.origin, CameraOrigin::Exif35Mm, "what the file says goes before the table");
    // The focal plane of this camera's EXIF has 6.198 mm.
    let compact = [(MAKE, Text("Canon")), (MODEL, Text("Canon PowerShot SX260 HS")), (FOCAL_LENGTH, Rational(45, 10))];
    assert!((pixel_um(&compact).unwrap() / (6198.0 / 400.0) - 1.0).abs() < 0.03);
}

#[test]
fn without_a_focal_length_there_is_no_camera() {
    assert_eq!(camera(&[(MAKE, Text("Canon"))]), None);
    for focal in [Rational(0, 1), Rational(5, 0), Rational(0, 0)] {
        assert_eq!(camera(&[(FOCAL_LENGTH, focal)]), None);
    }
}

#[test]
fn damaged_exif_is_no_error() {
    let block =
        exif_block(&[(MAKE, Text("Canon camera")), (FOCAL_LENGTH, Rational(45, 10)), (PLANE_X, Rational(2540, 1)), (PIXEL_X, Short(400))]);
    let whole = decode(&jpeg_with(&block)).unwrap();
    assert!(whole.camera.is_some());
    for length in 0..block.len() {
        let part = decode(&jpeg_with(&block[..length])).unwrap_or_else(|e| panic!("cut to {length}: {e}"));
        assert_eq!(part.grey, whole.grey);
    }
    for at in 0..block.len() {
        for value in [0, 1, 0x7f, 0xff] {
            let mut damaged = block.clone();
            damaged[at] = value;
            assert!(decode(&jpeg_with(&damaged)).is_ok(), "byte {at} = {value}");
        }
    }
}
