//! The orientation of a block from its multi-ray points.

use super::block::BlockPoints;
use super::convert::{JsResult, numbers, object, pack, read, read_options, rows, thrown};
use crate::{BlockDescription, Camera, ReconstructionOptions, reconstruct_block};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen]
impl BlockPoints {
    /// Orients the images and adjusts the block. `model` is the largest of its models as a block that is exchanged; null without one.
    #[wasm_bindgen(unchecked_return_type = "{ reconstruction: Reconstruction; model: BlockModel | null }")]
    pub fn reconstruct(
        &self,
        #[wasm_bindgen(unchecked_param_type = "BlockDescription")] description: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "Given<ReconstructionOptions>")] options: &JsValue,
    ) -> JsResult<JsValue> {
        let description: BlockDescription = read("block", description)?;
        let options: ReconstructionOptions = read_options("reconstruction", options)?;
        let reconstruction = reconstruct_block(&description, &self.points, &self.features(), &options).map_err(thrown)?;
        let model = match reconstruction.models.first() {
            Some(_) => Some(reconstruction.block_model(0, &description, &self.points).map_err(thrown)?),
            None => None,
        };
        Ok(object([("reconstruction", pack(&reconstruction)), ("model", pack(&model))]))
    }

    /// The block with these of its points, before any of it is oriented.
    #[wasm_bindgen(unchecked_return_type = "BlockModel")]
    pub fn model(
        &self,
        #[wasm_bindgen(unchecked_param_type = "BlockDescription")] description: &JsValue,
        chosen: &[u32],
    ) -> JsResult<JsValue> {
        let mut model = read::<BlockDescription>("block", description)?.to_model();
        model.add_points(&self.points, chosen, &self.features()).map_err(thrown)?;
        model.check().map_err(thrown)?;
        Ok(pack(&model))
    }
}

/// Refuses what is known of a block where no block can be so, before its images are matched.
#[wasm_bindgen]
pub fn check_block_description(#[wasm_bindgen(unchecked_param_type = "BlockDescription")] description: &JsValue) -> JsResult<()> {
    read::<BlockDescription>("block", description)?.check().map_err(thrown)
}

/// The defaults of the options of the reconstruction.
#[wasm_bindgen(unchecked_return_type = "ReconstructionOptions")]
pub fn reconstruction_defaults() -> JsValue {
    pack(&ReconstructionOptions::default())
}

/// Positions in px (stride 2) freed of a camera's distortion; NaN where it folds the image, so that it has no inverse.
#[wasm_bindgen]
pub fn undistorted_positions(
    #[wasm_bindgen(unchecked_param_type = "Camera")] camera: &JsValue,
    positions: &[f64],
) -> JsResult<js_sys::Float64Array> {
    let camera: Camera = read("camera", camera)?;
    let ideal = rows::<2>("positions", positions)?.iter().map(|at| camera.undistorted_px(*at).unwrap_or([f64::NAN; 2])).collect::<Vec<_>>();
    Ok(numbers(ideal.into_iter().flatten()).into())
}
