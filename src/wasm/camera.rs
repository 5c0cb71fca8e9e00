//! Cameras of photographs: what they are called, and that of a pair from that of a block.

use super::convert::{JsResult, Number, pack, read, side, thrown};
use crate::catalogue::check_call;
use crate::{Camera, CameraMm, ExifCamera};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

/// A block's camera as a photo of a pair has it: lengths in mm, the radial distortion as a correction of what was measured.
#[wasm_bindgen(unchecked_return_type = "CameraMm")]
pub fn photo_camera(#[wasm_bindgen(unchecked_param_type = "Camera")] camera: &JsValue) -> JsResult<JsValue> {
    read::<Camera>("camera", camera)?.photo_camera().map(|camera| pack(&camera)).map_err(thrown)
}

/// The camera of a photo of which nothing but the focal length in px is known.
#[wasm_bindgen(unchecked_return_type = "CameraMm")]
pub fn camera_of_focal_px(focal_px: &Number) -> JsResult<JsValue> {
    let focal_px = focal_px.read("focal_px")?;
    check_call("focal_px", focal_px).map_err(thrown)?;
    Ok(pack(&CameraMm::of_focal_px(focal_px)))
}

/// What a block calls the camera of a photograph of this size in px: make, model, focal length and size.
#[wasm_bindgen]
pub fn camera_label(
    #[wasm_bindgen(unchecked_param_type = "ExifCamera")] camera: &JsValue,
    width: &Number,
    height: &Number,
) -> JsResult<String> {
    let size = [side("width", width)?, side("height", height)?];
    Ok(read::<ExifCamera>("camera", camera)?.label(size))
}
