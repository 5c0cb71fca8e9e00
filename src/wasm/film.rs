//! Scans of film as blocks take them.

use super::convert::{JsResult, object, pack, read_options, thrown};
use crate::{DecodeLimits, FilmInput, decode_bands, film_frame as frame, film_pixel_mm as pixel, write_bands, write_png};
use js_sys::Uint8Array;
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** A scan of film, resampled to the image of an ideal camera. */
export interface FilmFiles {
    /** PNG, grey or in colours. */
    image: Uint8Array;
    /** PNG: 0 where the image shows a fiducial mark, its surroundings, or nothing of the scan. */
    mask: Uint8Array;
    /** As a file of cameras has it. */
    camera: CameraRule;
    /** How the scan lies to the film. */
    marks: FiducialOrientation;
}
"#;

/// Resamples the file of a scan by the fiducial marks that were measured in it: all scans of a camera become images of one ideal camera, of which a block
/// is made. `images`: the pattern of their names, of which the camera is to be. `pixel_mm`: the side of a pixel, which is to be the same for all, as are the
/// marks of the film: see `film_pixel_mm`.
#[wasm_bindgen(unchecked_return_type = "FilmFiles")]
pub fn film_frame(
    scan: &[u8],
    #[wasm_bindgen(unchecked_param_type = "Given<FilmInput>")] film: &JsValue,
    images: &str,
    pixel_mm: f64,
) -> JsResult<JsValue> {
    let film: FilmInput = read_options("film", film)?;
    let made = {
        let bands = decode_bands(scan, &DecodeLimits::default()).map_err(thrown)?;
        frame(&bands, &film, pixel_mm).map_err(thrown)?
    };
    let file = |bytes: Vec<u8>| JsValue::from(Uint8Array::from(bytes.as_slice()));
    Ok(object([
        ("image", file(write_bands(&made.image))),
        ("mask", file(write_png(made.mask.view(), None))),
        ("camera", pack(&made.rule(images))),
        ("marks", pack(&made.scan.marks)),
    ]))
}

/// The side of a pixel of a scan in mm, as its fiducial marks have it.
#[wasm_bindgen]
pub fn film_pixel_mm(#[wasm_bindgen(unchecked_param_type = "Given<FilmInput>")] film: &JsValue) -> JsResult<f64> {
    pixel(&read_options("film", film)?).map_err(thrown)
}
