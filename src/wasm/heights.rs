//! Heights of the ground: one for all, or a file with what stands beside it.

use super::convert::{JsResult, read, read_options, thrown, wrong_project};
use super::file_in_parts::file_source;
use crate::catalogue::check_call;
use crate::source::read_all;
use crate::{Document, Error, FileFault, FileSource, HeightModel, Heights, Project, Sidecars, heights_of_block, read_project};
use std::sync::Arc;
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

/// One height for all, or a file.
pub(super) fn read_heights(heights: &JsValue, sidecars: &JsValue) -> JsResult<Heights> {
    if heights.is_object() {
        return heights_of_file(file_source(heights)?, read_sidecars(sidecars)?).map(Heights::Model).map_err(thrown);
    }
    let height = read("heights", heights)?;
    check_call("heights", height).map_err(thrown)?;
    Ok(Heights::Level(height))
}

/// What stands beside a raster; none where nothing is given.
pub(super) fn read_sidecars(sidecars: &JsValue) -> JsResult<Sidecars> {
    if sidecars.is_null() || sidecars.is_undefined() { Ok(Sidecars::default()) } else { read_options("sidecars", sidecars) }
}

/// A height model, or the tie points of the block that a project file holds.
fn heights_of_file(file: Arc<dyn FileSource>, sidecars: Sidecars) -> Result<HeightModel, Error> {
    let mut first = [0];
    if file.read_at(0, &mut first).is_err() || first != *b"{" {
        return HeightModel::open(file, sidecars);
    }
    match read_project(&read_all(&*file, Document::Heights)?)? {
        Project::Block(run) => heights_of_block(&run),
        Project::Pair(_) => Err(wrong_project(FileFault::HoldsPair)),
    }
}

/// Refuses what is no height of the ground, nor a file of heights.
#[wasm_bindgen]
pub fn check_heights(
    #[wasm_bindgen(unchecked_param_type = "number | Uint8Array | FileInParts")] heights: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "Given<Sidecars>")] sidecars: &JsValue,
) -> JsResult<()> {
    read_heights(heights, sidecars).map(drop)
}
