//! Scans of film as blocks take them.

use super::convert::{Bytes, JsResult, Numbers, Text, numbers, object, pack, read, read_options, rows, set, thrown};
use crate::formats::image_measurement_table as table;
use crate::{
    CameraRule, Error, ExifImage, FilmInput, FilmScan, FrameOfScan, ImageMeasurementRow, decode_scan, film_cameras as cameras,
    film_frame as frame, film_pattern as pattern_of, film_pixel_mm as pixel, film_warning as warning_of, measurements_in_frames, write_png,
};
use js_sys::{Object, Reflect, Uint8Array};
use serde::Deserialize;
use serde::de::IgnoredAny;
use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::{JsCast, JsValue};

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** A scan of film, resampled to the image of an ideal camera. */
export interface FilmFiles {
    /** PNG, grey or in colours, with the position that the metadata of the scan record. */
    image: Uint8Array;
    /** PNG: 0 where the image shows a fiducial mark, its surroundings, nothing of the scan, or what the mask of the scan leaves out. */
    mask: Uint8Array;
    /** As a file of cameras has it, of this image alone: `film_cameras` gives that of all images of a film. */
    camera: CameraRule;
    /** How the scan lies to the image, by which `film_positions` leads from one to the other, and how the marks give it. */
    scan: FilmScan;
    /** Root mean square length of the residuals of the marks in mm. */
    rmse_mm: number;
}

/** What the image of a scan is to be. */
export interface FrameWanted {
    /** What it is called. */
    image: string;
    /** The side of a pixel, which is to be the same for all scans of a film, as are its marks: see `film_pixel_mm`. */
    pixel_mm: number;
    /** The file of an image as large as the scan that is 0 where no features are wanted. */
    mask?: { name: string; file: Uint8Array } | null;
}
"#;

/// Resamples the file of a scan by the fiducial marks that were measured in it: all scans of a camera become images of one ideal camera, of which a block
/// is made.
#[wasm_bindgen(unchecked_return_type = "FilmFiles")]
pub fn film_frame(
    scan: &Bytes,
    #[wasm_bindgen(unchecked_param_type = "Given<FilmInput>")] film: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "FrameWanted")] wanted: &JsValue,
) -> JsResult<JsValue> {
    let FrameWanted { image, pixel_mm, mask } = FrameWanted::read(wanted)?;
    let film: FilmInput = read_options("film", film)?;
    let scan = scan.read("file of the scan")?;
    let bands = decode_scan(&scan).map_err(thrown)?;
    let exif = ExifImage::read(&scan, bands.width() as u64, bands.height() as u64);
    // Of large scans memory holds what is needed, and no more.
    drop(scan);
    let mut made = frame(&bands, &film, pixel_mm).map_err(thrown)?;
    drop(bands);
    if let Some((name, file)) = mask {
        made.hide(&name, &file).map_err(thrown)?;
    }
    let file = |bytes: Vec<u8>| JsValue::from(Uint8Array::from(bytes.as_slice()));
    Ok(object([
        ("image", file(made.image_file(&exif))),
        ("mask", file(write_png(made.mask.view(), None))),
        ("camera", pack(&made.rule(&image))),
        ("scan", pack(&made.scan)),
        ("rmse_mm", made.scan.marks.rmse_mm().into()),
    ]))
}

struct FrameWanted {
    image: String,
    pixel_mm: f64,
    /// Its name, and its file.
    mask: Option<(String, Vec<u8>)>,
}

impl FrameWanted {
    /// The bytes of the mask are taken as they are, the rest as options are.
    fn read(wanted: &JsValue) -> JsResult<Self> {
        #[derive(Deserialize)]
        #[serde(deny_unknown_fields)]
        struct Named {
            image: String,
            pixel_mm: f64,
            mask: Option<Mask>,
        }
        #[derive(Deserialize)]
        #[serde(deny_unknown_fields)]
        struct Mask {
            name: String,
            #[serde(rename = "file")]
            _file: IgnoredAny,
        }
        let field = |of: &JsValue, name: &str| Reflect::get(of, &name.into()).unwrap_or(JsValue::UNDEFINED);
        // Bytes that pass as text are long: what is read of the rest has none.
        let (plain, file) = match field(wanted, "mask") {
            mask if mask.is_object() => {
                let without = Object::assign(&Object::new(), mask.unchecked_ref());
                set(&without, "file", &JsValue::TRUE);
                let plain = Object::assign(&Object::new(), wanted.unchecked_ref());
                set(&plain, "mask", &without);
                (JsValue::from(plain), field(&mask, "file"))
            }
            _ => (wanted.clone(), JsValue::UNDEFINED),
        };
        let Named { image, pixel_mm, mask } = read("wanted", &plain)?;
        let bytes = |Mask { name, .. }: Mask| Ok::<_, JsValue>((name, file.unchecked_ref::<Bytes>().read("wanted.mask.file")?));
        Ok(Self { image, pixel_mm, mask: mask.map(bytes).transpose()? })
    }
}

/// The side of a pixel of a scan in mm, as its fiducial marks have it.
#[wasm_bindgen]
pub fn film_pixel_mm(#[wasm_bindgen(unchecked_param_type = "Given<FilmInput>")] film: &JsValue) -> JsResult<f64> {
    pixel(&read_options("film", film)?).map_err(thrown)
}

/// What is to be said of the camera of a scan: that the side of a pixel that it gives is another than that of the marks, and not used; null where there is
/// nothing.
#[wasm_bindgen(unchecked_return_type = "Warning | null")]
pub fn film_warning(#[wasm_bindgen(unchecked_param_type = "Given<FilmInput>")] film: &JsValue) -> JsResult<JsValue> {
    warning_of(&read_options("film", film)?).map(|warning| pack(&warning)).map_err(thrown)
}

/// The pattern of the names of frames of one film, whose first one has the camera `rule`, beside those of other films, whose cameras are `given`.
#[wasm_bindgen]
pub fn film_pattern(
    #[wasm_bindgen(unchecked_param_type = "CameraRule")] rule: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "CameraRule[]")] given: &JsValue,
) -> JsResult<String> {
    Ok(pattern_of(&read::<CameraRule>("rule", rule)?, &read::<Vec<CameraRule>>("given", given)?))
}

/// The cameras of frames as a file of cameras has them, from that of each, before those that it has (`given`): frames of one film have one, for all images
/// whose names fit `pattern`, as `film_pattern` gives it.
#[wasm_bindgen(unchecked_return_type = "CameraRule[]")]
pub fn film_cameras(
    pattern: &Text,
    #[wasm_bindgen(unchecked_param_type = "CameraRule[]")] rules: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "CameraRule[]")] given: &JsValue,
) -> JsResult<JsValue> {
    let (rules, given): (Vec<CameraRule>, Vec<CameraRule>) = (read("rules", rules)?, read("given", given)?);
    Ok(pack(&cameras(&pattern.read("pattern")?, &rules, &given)))
}

/// Positions of a scan in its frame, or of a frame in its scan: x, y, x, y … in px, the centre of the top-left pixel at (0.5, 0.5). NaN where there is none,
/// as beside the frame. `to`: `frame` or `scan`.
#[wasm_bindgen(unchecked_return_type = "Float64Array")]
pub fn film_positions(
    #[wasm_bindgen(unchecked_param_type = "FilmScan")] scan: &JsValue,
    positions: &Numbers,
    #[wasm_bindgen(unchecked_param_type = "'frame' | 'scan'")] to: &Text,
) -> JsResult<JsValue> {
    let scan: FilmScan = read("scan", scan)?;
    let positions = positions.read("positions")?;
    let to = to.read("to")?;
    let to_frame = match &to[..] {
        "frame" => true,
        "scan" => false,
        _ => return Err(thrown(Error::InvalidArgument { what: "to", got: to, wanted: "frame or scan".into() })),
    };
    let led = |at: &[f64; 2]| if to_frame { scan.shown_in_frame(*at) } else { scan.in_scan(*at) };
    Ok(numbers(rows::<2>("positions", &positions)?.iter().flat_map(|at| led(at).unwrap_or([f64::NAN; 2]))))
}

/// Takes image measurements that were made in scans into their frames.
#[wasm_bindgen(unchecked_return_type = "FramedMeasurements")]
pub fn film_measurements(
    #[wasm_bindgen(unchecked_param_type = "ImageMeasurementRow[]")] measurements: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "FrameOfScan[]")] frames: &JsValue,
) -> JsResult<JsValue> {
    let (measurements, frames): (Vec<ImageMeasurementRow>, Vec<FrameOfScan>) =
        (read("measurements", measurements)?, read("frames", frames)?);
    Ok(pack(&measurements_in_frames(&measurements, &frames)))
}

/// The table of image measurements, which reads back as they are.
#[wasm_bindgen]
pub fn image_measurement_table(#[wasm_bindgen(unchecked_param_type = "ImageMeasurementRow[]")] measurements: &JsValue) -> JsResult<String> {
    let measurements: Vec<ImageMeasurementRow> = read("measurements", measurements)?;
    Ok(table(&measurements))
}
