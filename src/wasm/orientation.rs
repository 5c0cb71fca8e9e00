//! Interior and relative orientation.

use super::convert::{JsResult, pack, read, read_options, rows, thrown};
use crate::{
    Camera, Fiducial, FiducialModel, Interior, Observation, OrientationOptions, PhotoInput, observations as photo_observations,
    orient_fiducials as orient_marks, orient_relative as orient_pair, photo_interior,
};
use serde::{Deserialize, Serialize};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

/// An image as interior orientation needs it: its size, and what is known of its fiducials.
#[derive(Serialize, Deserialize, tsify::Tsify)]
#[serde(deny_unknown_fields)]
pub struct PhotoGeometry {
    /// In px.
    pub width: usize,
    pub height: usize,
    #[serde(default)]
    pub fiducials: Vec<Fiducial>,
    #[serde(default)]
    pub model: FiducialModel,
    /// Place `[col, row]` of the image's top-left pixel in the scan whose fiducials were measured.
    #[serde(default)]
    pub origin: Option<[f64; 2]>,
}

/// Interior orientation by fiducial marks.
#[wasm_bindgen(unchecked_return_type = "FiducialOrientation")]
pub fn orient_fiducials(
    #[wasm_bindgen(unchecked_param_type = "Fiducial[]")] fiducials: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "FiducialModel")] model: &JsValue,
) -> JsResult<JsValue> {
    let (fiducials, model): (Vec<Fiducial>, FiducialModel) = (read("fiducials", fiducials)?, read("model", model)?);
    orient_marks(&fiducials, model).map(|o| pack(&o)).map_err(thrown)
}

/// The interior orientation of an image: from its fiducials, or from the camera's pixel size.
#[wasm_bindgen(unchecked_return_type = "Interior")]
pub fn interior(
    #[wasm_bindgen(unchecked_param_type = "Camera")] camera: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "PhotoGeometry")] photo: &JsValue,
) -> JsResult<JsValue> {
    let (camera, photo): (Camera, PhotoGeometry) = (read("camera", camera)?, read("photo", photo)?);
    let input = PhotoInput { fiducials: photo.fiducials, model: photo.model, origin: photo.origin };
    photo_interior(&camera, photo.width, photo.height, &input).map(|i| pack(&i)).map_err(thrown)
}

/// The same rays at a focal length `factor` times as long: two photos of different focal lengths are oriented at one of them.
#[wasm_bindgen(unchecked_return_type = "Interior")]
pub fn scaled_interior(#[wasm_bindgen(unchecked_param_type = "Interior")] interior: &JsValue, factor: f64) -> JsResult<JsValue> {
    Ok(pack(&read::<Interior>("interior", interior)?.scaled(factor)))
}

/// Photo coordinates x, y left, x, y right in mm (stride 4) of matches (stride 5).
#[wasm_bindgen]
pub fn observations(
    matches: &[f64],
    #[wasm_bindgen(unchecked_param_type = "Interior")] left: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Interior")] right: &JsValue,
) -> JsResult<Vec<f64>> {
    let (left, right): (Interior, Interior) = (read("left interior", left)?, read("right interior", right)?);
    let positions: Vec<[f64; 4]> = rows::<5>("matches", matches)?.iter().map(|[xl, yl, xr, yr, _]| [*xl, *yl, *xr, *yr]).collect();
    Ok(photo_observations(&positions, &left, &right).iter().flat_map(|o| [o.left[0], o.left[1], o.right[0], o.right[1]]).collect())
}

/// Relative orientation of observations x, y left, x, y right in mm (stride 4).
#[wasm_bindgen(unchecked_return_type = "RelativeOrientation")]
pub fn orient_relative(
    observations: &[f64],
    focal_mm: f64,
    #[wasm_bindgen(unchecked_param_type = "Given<OrientationOptions>")] options: &JsValue,
) -> JsResult<JsValue> {
    let options: OrientationOptions = read_options("orientation", options)?;
    let rows = rows::<4>("observations", observations)?;
    let observed: Vec<Observation> = rows.iter().map(|[xl, yl, xr, yr]| Observation { left: [*xl, *yl], right: [*xr, *yr] }).collect();
    orient_pair(&observed, focal_mm, &options).map(|o| pack(&o)).map_err(thrown)
}
