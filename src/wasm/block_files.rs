//! Files of a block: what EXIF tells, cameras and surveyed points in, the exchange formats.

use super::convert::{JsResult, emitting, pack, read, thrown};
use crate::{
    BlockModel, Connection, ConnectionGraph, Error, ExifImage, ExportFormat, export_block as write_block, parse_camera_rules as read_rules,
    parse_ground_control_points as read_points, parse_image_measurements as read_marks,
};
use js_sys::Function;
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

/// What EXIF tells of an image of this size beside its pixels.
#[wasm_bindgen(unchecked_return_type = "ExifImage")]
pub fn read_exif(file: &[u8], width: u32, height: u32) -> JsValue {
    pack(&ExifImage::read(file, u64::from(width), u64::from(height)))
}

/// Reads cameras that hold for the images whose names fit a pattern.
#[wasm_bindgen(unchecked_return_type = "CameraRule[]")]
pub fn parse_camera_rules(json: &str) -> JsResult<JsValue> {
    read_rules(json).map(|rules| pack(&rules)).map_err(thrown)
}

/// Reads surveyed points: lines of name, x, y, z and perhaps two standard errors.
#[wasm_bindgen(unchecked_return_type = "GroundControlRow[]")]
pub fn parse_ground_control_points(text: &str) -> JsResult<JsValue> {
    read_points(text).map(|points| pack(&points)).map_err(thrown)
}

/// Reads where images show surveyed points: lines of image, point, x, y in px.
#[wasm_bindgen(unchecked_return_type = "ImageMeasurementRow[]")]
pub fn parse_image_measurements(text: &str) -> JsResult<JsValue> {
    read_marks(text).map(|marks| pack(&marks)).map_err(thrown)
}

/// The names of the formats that blocks are written in.
#[wasm_bindgen(unchecked_return_type = "ExportFormat[]")]
pub fn export_formats() -> JsValue {
    pack(&ExportFormat::ALL)
}

/// Writes a block in one format: `emit` is called with the path, relative to a folder, and the text of each file in turn.
#[wasm_bindgen]
pub fn export_block(
    #[wasm_bindgen(unchecked_param_type = "BlockModel")] model: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "ExportFormat")] format: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "(path: string, text: string) => void")] emit: &Function,
) -> JsResult<()> {
    let (model, format): (BlockModel, ExportFormat) = (read("block", model)?, read("format", format)?);
    emitting(emit, |emit| write_block(&model, format, emit))
}

/// More images than any block has.
const MOST_IMAGES: u32 = 10_000_000;

/// The groups of connected images of a block, the largest first.
#[wasm_bindgen(unchecked_return_type = "number[][]")]
pub fn connected_groups(images: u32, #[wasm_bindgen(unchecked_param_type = "Connection[]")] connections: &JsValue) -> JsResult<JsValue> {
    let connections: Vec<Connection> = read("connections", connections)?;
    // What is no number of images, as -1, arrives as a number beyond all memory.
    if images > MOST_IMAGES {
        let (got, allowed) = (images.to_string(), format!("0 to {MOST_IMAGES}"));
        return Err(thrown(Error::InvalidArgument { what: "number of images", got, wanted: allowed }));
    }
    let mut graph = ConnectionGraph::new(images);
    for connection in &connections {
        graph.set(connection.images, connection.rule, connection.outcome.clone()).map_err(thrown)?;
    }
    Ok(pack(&graph.groups()))
}
