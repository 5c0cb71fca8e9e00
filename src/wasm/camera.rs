//! The camera of a pair from that of a block.

use super::convert::{JsResult, pack, read, thrown};
use crate::Camera;
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

/// A block's camera as a photo of a pair has it: lengths in mm, the radial distortion as a correction of what was measured.
#[wasm_bindgen(unchecked_return_type = "CameraMm")]
pub fn photo_camera(#[wasm_bindgen(unchecked_param_type = "Camera")] camera: &JsValue) -> JsResult<JsValue> {
    read::<Camera>("camera", camera)?.photo_camera().map(|camera| pack(&camera)).map_err(thrown)
}
