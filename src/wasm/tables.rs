//! Small files of text.

use super::convert::{JsResult, Numbers, Text, pack, read, rows, thrown};
use crate::{
    ModelPoint, matches_csv as write_matches, model_points_csv as write_model_points, parse_camera as read_camera,
    parse_fiducials as read_fiducials, parse_observations as read_observations, points_csv as write_points,
};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

/// Reads fiducial marks: columns col, row, x_mm, y_mm.
#[wasm_bindgen(unchecked_return_type = "Fiducial[]")]
pub fn parse_fiducials(csv: &Text) -> JsResult<JsValue> {
    read_fiducials(&csv.read("csv")?).map(|f| pack(&f)).map_err(thrown)
}

/// Reads photo coordinates: columns x_left_mm, y_left_mm, x_right_mm, y_right_mm; stride 4.
#[wasm_bindgen]
pub fn parse_observations(csv: &Text) -> JsResult<Vec<f64>> {
    let observations = read_observations(&csv.read("csv")?).map_err(thrown)?;
    Ok(observations.iter().flat_map(|o| [o.left[0], o.left[1], o.right[0], o.right[1]]).collect())
}

/// Reads a camera: {"focal_mm", "principal_point_mm", "pixel_mm", "radial_distortion", "tangential_distortion"}.
#[wasm_bindgen(unchecked_return_type = "CameraMm")]
pub fn parse_camera(json: &Text) -> JsResult<JsValue> {
    read_camera(&json.read("json")?).map(|c| pack(&c)).map_err(thrown)
}

/// Writes matches (stride 5) as CSV, each with its state: used or rejected by the orientation whose `rejected` is given, empty without.
#[wasm_bindgen]
pub fn matches_csv(
    matches: &Numbers,
    #[wasm_bindgen(unchecked_optional_param_type = "readonly number[] | null")] rejected: &JsValue,
) -> JsResult<String> {
    let rejected: Option<Vec<usize>> = if rejected.is_null() || rejected.is_undefined() { None } else { Some(read("rejected", rejected)?) };
    Ok(write_matches(rows("matches", &matches.read("matches")?)?, rejected.as_deref()))
}

/// Writes points (stride 3) as CSV.
#[wasm_bindgen]
pub fn points_csv(points: &Numbers) -> JsResult<String> {
    Ok(write_points(rows("points", &points.read("points")?)?))
}

/// Writes object points of a pair (stride 7, as `model_points` gives them) as CSV.
#[wasm_bindgen]
pub fn model_points_csv(points: &Numbers) -> JsResult<String> {
    let point = |[x, y, z, sx, sy, sz, accepted]: &[f64; 7]| {
        let errors = Some([*sx, *sy, *sz]).filter(|errors| errors.iter().all(|error| error.is_finite()));
        x.is_finite().then_some(ModelPoint { position: [*x, *y, *z], errors, accepted: *accepted != 0.0 })
    };
    Ok(write_model_points(&rows::<7>("points", &points.read("points")?)?.iter().map(point).collect::<Vec<_>>()))
}
