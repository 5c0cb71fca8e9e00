//! Files of a block: what EXIF tells, cameras and surveyed points in, the project and the exchange formats.

use super::convert::{JsResult, pack, read, thrown};
use crate::{
    BlockModel, CameraRule, Connection, ConnectionGraph, Error, ExifImage, ExportFormat, Project, export_block as write_block,
    parse_camera_rules as read_rules, parse_ground_control_points as read_points, parse_image_measurements as read_marks,
    read_project as parse_project, write_project as format_project,
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

/// For each name of an image the index of the first rule that it fits, -1 without one.
#[wasm_bindgen]
pub fn camera_rules_of(
    #[wasm_bindgen(unchecked_param_type = "CameraRule[]")] rules: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "string[]")] names: &JsValue,
) -> JsResult<Vec<i32>> {
    let (rules, names): (Vec<CameraRule>, Vec<String>) = (read("camera rules", rules)?, read("names", names)?);
    let of = |name: &String| rules.iter().position(|rule| rule.fits(name)).map_or(-1, |index| index as i32);
    Ok(names.iter().map(of).collect())
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

/// Writes a project.
#[wasm_bindgen]
pub fn write_project(#[wasm_bindgen(unchecked_param_type = "Project")] project: &JsValue) -> JsResult<String> {
    format_project(&read::<Project>("project", project)?).map_err(thrown)
}

/// Reads a project; a file that is damaged or of another kind is refused whole.
#[wasm_bindgen(unchecked_return_type = "Project")]
pub fn read_project(bytes: &[u8]) -> JsResult<JsValue> {
    parse_project(bytes).map(|project| pack(&project)).map_err(thrown)
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
    // What the caller's function throws goes back to the caller as it is.
    let mut threw = None;
    let written = write_block(&model, format, &mut |path, text| {
        emit.call2(&JsValue::NULL, &path.into(), &text.into()).map(|_| ()).map_err(|error| {
            threw = Some(error);
            Error::NotWritten { what: "the export" }
        })
    });
    written.map_err(|error| threw.take().unwrap_or_else(|| thrown(error)))
}

/// The groups of connected images of a block, the largest first.
#[wasm_bindgen(unchecked_return_type = "number[][]")]
pub fn connected_groups(images: u32, #[wasm_bindgen(unchecked_param_type = "Connection[]")] connections: &JsValue) -> JsResult<JsValue> {
    let connections: Vec<Connection> = read("connections", connections)?;
    let mut graph = ConnectionGraph::new(images);
    for connection in &connections {
        graph.set(connection.images, connection.rule, connection.outcome.clone()).map_err(thrown)?;
    }
    Ok(pack(&graph.groups()))
}
