//! Simulated flights, and the score of matches by their truth.

use super::about::pack_groups;
use super::convert::{Bytes, JsResult, Number, Numbers, object, pack, read, read_options, rows, thrown, whole};
use crate::{
    DenseTruth, Flight, GreyImage, MatchScore, PartlyGiven, Preset, Rightness, check_flight as check, score_matches as score_by_truth,
    simulate as fly, write_png,
};
use js_sys::{Float32Array, Reflect, Uint8Array};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** Grey values 0..255, row by row. */
export interface SampleImage { width: number; height: number; grey: Uint8Array }

/** A simulated pair and its truth. */
export interface SamplePair {
    left: SampleImage;
    right: SampleImage;
    camera: CameraMm;
    base_mm: number;
    left_fiducials: Fiducial[];
    right_fiducials: Fiducial[];
    left_origin: [number, number];
    right_origin: [number, number];
    /** The true relative orientation. */
    truth: FiveParameters;
    /** For each left pixel, row by row, the x and y in px at which the right image shows the same; NaN where hidden or outside. */
    right_position: Float32Array;
}

/** How right matches are. */
export interface MatchScore {
    matches: number;
    /** Within 1.5 px of where the surface at the left pixel is seen. */
    strict: number;
    /** The same, or of where the surface at one of its 8 neighbours is seen. */
    right: number;
    /** Left points that are seen in the right image and have no right match. */
    missed: number;
    /** For each match 0 wrong, 1 right at an edge only, 2 strictly right. */
    rightness: Uint8Array;
}
"#;

/// Every parameter of a flight.
#[wasm_bindgen(unchecked_return_type = "Parameter[]")]
pub fn flight_parameters() -> JsValue {
    pack_groups(Flight::GROUPS)
}

/// The names of the ready-made flights.
#[wasm_bindgen(unchecked_return_type = "Preset[]")]
pub fn flight_presets() -> JsValue {
    pack(&Preset::ALL)
}

/// A ready-made flight.
#[wasm_bindgen(unchecked_return_type = "Flight")]
pub fn flight_preset(#[wasm_bindgen(unchecked_param_type = "Preset")] name: &JsValue) -> JsResult<JsValue> {
    Ok(pack(&read::<Preset>("preset", name)?.flight()))
}

/// Refuses a flight that [`simulate`] refuses, without rendering it; parameters that are absent are those of the sample.
#[wasm_bindgen]
pub fn check_flight(#[wasm_bindgen(unchecked_param_type = "Given<Flight>")] flight: &JsValue) -> JsResult<()> {
    check(&read_options::<Flight>("flight", flight)?).map_err(thrown)
}

/// Renders the pair of a flight; parameters that are absent are those of the sample.
#[wasm_bindgen(unchecked_return_type = "SamplePair")]
pub fn simulate(#[wasm_bindgen(unchecked_param_type = "Given<Flight>")] flight: &JsValue) -> JsResult<JsValue> {
    let sample = fly(&read_options::<Flight>("flight", flight)?).map_err(thrown)?;
    let image = |grey: &GreyImage| {
        object([
            ("width", (grey.width() as f64).into()),
            ("height", (grey.height() as f64).into()),
            ("grey", Uint8Array::from(grey.data()).into()),
        ])
    };
    Ok(object([
        ("left", image(&sample.left)),
        ("right", image(&sample.right)),
        ("camera", pack(&sample.camera)),
        ("base_mm", sample.base_mm.into()),
        ("left_fiducials", pack(&sample.left_fiducials)),
        ("right_fiducials", pack(&sample.right_fiducials)),
        ("left_origin", pack(&sample.left_origin)),
        ("right_origin", pack(&sample.right_origin)),
        ("truth", pack(&sample.truth)),
        ("right_position", Float32Array::from(sample.right_position.as_flattened()).into()),
    ]))
}

/// Writes grey values as a PNG file, with the camera and the position of `exif` where it is given.
#[wasm_bindgen]
pub fn grey_png(
    width: &Number,
    height: &Number,
    grey: &Bytes,
    #[wasm_bindgen(unchecked_optional_param_type = "ExifImage")] exif: &JsValue,
) -> JsResult<Vec<u8>> {
    let image = GreyImage::new(whole("width", width)?, whole("height", height)?, grey.read("grey values")?).map_err(thrown)?;
    let exif = if exif.is_undefined() { None } else { Some(read("exif", exif)?) };
    Ok(write_png(image.view(), exif.as_ref()))
}

/// Scores matches (stride 5) of left points (stride 3) by the truth of a simulated pair.
#[wasm_bindgen(unchecked_return_type = "MatchScore")]
pub fn score_matches(
    matches: &Numbers,
    left_points: &Numbers,
    #[wasm_bindgen(unchecked_param_type = "Float32Array | readonly number[]")] right_position: &Numbers,
    left_width: &Number,
    left_height: &Number,
    right_width: &Number,
    right_height: &Number,
) -> JsResult<JsValue> {
    let (left_width, left_height) = (whole("left width", left_width)?, whole("left height", left_height)?);
    let (right_width, right_height) = (whole("right width", right_width)?, whole("right height", right_height)?);
    let matches: Vec<[f64; 4]> =
        rows::<5>("matches", &matches.read("matches")?)?.iter().map(|[xl, yl, xr, yr, _]| [*xl, *yl, *xr, *yr]).collect();
    let points: Vec<[f64; 2]> = rows::<3>("left points", &left_points.read("left points")?)?.iter().map(|[x, y, _]| [*x, *y]).collect();
    let right_position = right_position.read_single("right position")?;
    let truth = DenseTruth { right_position: right_position.as_chunks::<2>().0, left_width, left_height, right_width, right_height };
    score_by_truth(&matches, &points, &truth).map(|score| pack_score(&score)).map_err(thrown)
}

/// How right a match is, each in the place of its code.
const RIGHTNESS: [Rightness; 3] = [Rightness::Wrong, Rightness::AtEdge, Rightness::Strict];

pub(super) fn pack_score(score: &MatchScore) -> JsValue {
    let code = |rightness: &Rightness| RIGHTNESS.iter().position(|known| known == rightness).unwrap_or_default() as u8;
    let codes: Vec<u8> = score.rightness.iter().map(code).collect();
    object([
        ("matches", (codes.len() as f64).into()),
        ("strict", (score.strict as f64).into()),
        ("right", (score.right as f64).into()),
        ("missed", (score.missed as f64).into()),
        ("rightness", Uint8Array::from(&codes[..]).into()),
    ])
}

/// The opposite of `pack_score`.
pub(super) fn read_score(value: &JsValue) -> MatchScore {
    let field = |name: &str| Reflect::get(value, &name.into()).unwrap_or(JsValue::NULL);
    let count = |name: &str| field(name).as_f64().unwrap_or_default() as usize;
    let codes = Uint8Array::new(&field("rightness")).to_vec();
    let rightness = codes.iter().map(|code| RIGHTNESS.get(usize::from(*code)).copied().unwrap_or(Rightness::Wrong)).collect();
    MatchScore { rightness, strict: count("strict"), right: count("right"), missed: count("missed") }
}
