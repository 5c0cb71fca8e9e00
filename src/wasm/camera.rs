//! Cameras of photographs: what they are called, and that of a pair from that of a block.

use super::convert::{JsResult, pack, read, thrown};
use crate::{Camera, ExifCamera};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

/// A block's camera as a photo of a pair has it: lengths in mm, the radial distortion as a correction of what was measured.
#[wasm_bindgen(unchecked_return_type = "CameraMm")]
pub fn photo_camera(#[wasm_bindgen(unchecked_param_type = "Camera")] camera: &JsValue) -> JsResult<JsValue> {
    read::<Camera>("camera", camera)?.photo_camera().map(|camera| pack(&camera)).map_err(thrown)
}

/// What a block calls the camera of a photograph of this size in px: make, model, focal length and size.
#[wasm_bindgen]
pub fn camera_label(#[wasm_bindgen(unchecked_param_type = "ExifCamera")] camera: &JsValue, width: u32, height: u32) -> JsResult<String> {
    Ok(read::<ExifCamera>("camera", camera)?.label([width, height]))
}
