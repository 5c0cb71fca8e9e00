//! Heights of the ground: one for all, or a file with what stands beside it.

use super::convert::{JsResult, bytes_of, read, read_options, thrown, wrong_project};
use crate::catalogue::check_call;
use crate::{Error, FileFault, HeightModel, Heights, Project, Sidecars, heights_of_block, read_project};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

/// One height for all, or a file.
pub(super) fn read_heights(heights: &JsValue, sidecars: &JsValue) -> JsResult<Heights> {
    match bytes_of(heights) {
        Some(file) => heights_of_file(&file, read_sidecars(sidecars)?).map(Heights::Model).map_err(thrown),
        None => {
            let height = read("heights", heights)?;
            check_call("heights", height).map_err(thrown)?;
            Ok(Heights::Level(height))
        }
    }
}

/// What stands beside a raster; none where nothing is given.
pub(super) fn read_sidecars(sidecars: &JsValue) -> JsResult<Sidecars> {
    if sidecars.is_null() || sidecars.is_undefined() { Ok(Sidecars::default()) } else { read_options("sidecars", sidecars) }
}

/// A height model, or the tie points of the block that a project file holds.
fn heights_of_file(file: &[u8], sidecars: Sidecars) -> Result<HeightModel, Error> {
    if !file.starts_with(b"{") {
        return HeightModel::read(file, sidecars);
    }
    match read_project(file)? {
        Project::Block(run) => heights_of_block(&run),
        Project::Pair(_) => Err(wrong_project(FileFault::HoldsPair)),
    }
}

/// Refuses what is no height of the ground, nor a file of heights.
#[wasm_bindgen]
pub fn check_heights(
    #[wasm_bindgen(unchecked_param_type = "number | Uint8Array")] heights: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "Given<Sidecars>")] sidecars: &JsValue,
) -> JsResult<()> {
    read_heights(heights, sidecars).map(drop)
}
