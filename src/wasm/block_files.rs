//! Files of a block: what EXIF tells, cameras and surveyed points in, the names of the exchange formats.

use super::convert::{Bytes, JsResult, Number, Text, TextList, pack, read, side, thrown};
use crate::{
    Connection, ConnectionGraph, Error, ExifImage, ExportFormat, measurements_of_images, parse_camera_rules as read_rules,
    parse_ground_control_points as read_points, parse_image_measurements as read_marks, parse_image_positions as read_positions,
};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

/// What EXIF tells of an image of this size beside its pixels.
#[wasm_bindgen(unchecked_return_type = "ExifImage")]
pub fn read_exif(file: &Bytes, width: &Number, height: &Number) -> JsResult<JsValue> {
    let (width, height) = (side("width", width)?, side("height", height)?);
    Ok(pack(&ExifImage::read(&file.read("file of the image")?, u64::from(width), u64::from(height))))
}

/// Reads cameras that hold for the images whose names fit a pattern.
#[wasm_bindgen(unchecked_return_type = "CameraRule[]")]
pub fn parse_camera_rules(json: &Text) -> JsResult<JsValue> {
    read_rules(&json.read("json")?).map(|rules| pack(&rules)).map_err(thrown)
}

/// Reads surveyed points: lines of name, x, y, z and perhaps two standard errors.
#[wasm_bindgen(unchecked_return_type = "GroundControlRow[]")]
pub fn parse_ground_control_points(text: &Text) -> JsResult<JsValue> {
    read_points(&text.read("text")?).map(|points| pack(&points)).map_err(thrown)
}

/// Reads where images show surveyed points: lines of image, point, x, y in px. `images`: names of images, which stand in the rows where the
/// table means them, by other capitals, with a folder or without their ending.
#[wasm_bindgen(unchecked_return_type = "ImageMeasurementRow[]")]
pub fn parse_image_measurements(text: &Text, images: Option<TextList>) -> JsResult<JsValue> {
    let images = images.map(|images| images.read("images")).transpose()?;
    let rows = read_marks(&text.read("text")?).map_err(thrown)?;
    Ok(pack(&measurements_of_images(rows, &images.unwrap_or_default())))
}

/// Reads GNSS positions of images: lines of image, longitude, latitude and height, or of image, x, y and height, and perhaps two standard errors.
#[wasm_bindgen(unchecked_return_type = "ImagePositions")]
pub fn parse_image_positions(text: &Text) -> JsResult<JsValue> {
    read_positions(&text.read("text")?).map(|positions| pack(&positions)).map_err(thrown)
}

/// The names of the formats that blocks are written in.
#[wasm_bindgen(unchecked_return_type = "ExportFormat[]")]
pub fn export_formats() -> JsValue {
    pack(&ExportFormat::ALL)
}

/// More images than any block has.
const MOST_IMAGES: u32 = 10_000_000;

/// The groups of connected images of a block, the largest first.
#[wasm_bindgen(unchecked_return_type = "number[][]")]
pub fn connected_groups(
    images: &Number,
    #[wasm_bindgen(unchecked_param_type = "Connection[]")] connections: &JsValue,
) -> JsResult<JsValue> {
    let (images, connections): (u32, Vec<Connection>) = (side("number of images", images)?, read("connections", connections)?);
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
