//! The camera of a pair from that of a block.

use super::convert::{JsResult, pack, read, thrown};
use crate::ModelCamera;
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

/// A block's camera as a photo of a pair has it: lengths in mm, the radial distortion as a correction of what was measured.
#[wasm_bindgen(unchecked_return_type = "Camera")]
pub fn photo_camera(#[wasm_bindgen(unchecked_param_type = "ModelCamera")] camera: &JsValue) -> JsResult<JsValue> {
    read::<ModelCamera>("camera", camera)?.photo_camera().map(|camera| pack(&camera)).map_err(thrown)
}
