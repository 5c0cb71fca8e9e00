//! What a block is set by, and where its images are.

use super::convert::{JsResult, pack, read_options, rows, thrown};
use crate::{
    ADJUSTMENT_PARAMETERS, BLOCK_PARAMETERS, BlockSettings, RECONSTRUCTION_PARAMETERS, ReconstructionOptions, RefinementOutcome,
    local_from_geographic,
};
use js_sys::Float64Array;
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

/// Every tunable of a block's pairs, of multi-ray points and of the choice among them.
#[wasm_bindgen(unchecked_return_type = "Parameter[]")]
pub fn block_parameters() -> JsValue {
    pack(&BLOCK_PARAMETERS)
}

/// All settings of a block: those given, the others from the defaults. Values of pairs, points and selection outside their ranges are refused.
#[wasm_bindgen(unchecked_return_type = "BlockSettings")]
pub fn block_settings(#[wasm_bindgen(unchecked_param_type = "Given<BlockSettings>")] given: &JsValue) -> JsResult<JsValue> {
    let settings: BlockSettings = read_options("block", given)?;
    settings.check().map(|()| pack(&settings)).map_err(thrown)
}

/// Positions in m east, north and up of the first known one: of longitude, latitude in degrees and height in m (stride 3), NaN where not known.
#[wasm_bindgen]
pub fn local_positions(geographic: &[f64]) -> JsResult<Float64Array> {
    let places = rows::<3>("geographic positions", geographic)?;
    let origin = places.iter().find(|p| p.iter().all(|v| v.is_finite()));
    let local = |p: &[f64; 3]| origin.map_or([f64::NAN; 3], |origin| local_from_geographic(*p, *origin));
    Ok(Float64Array::from(&places.iter().flat_map(local).collect::<Vec<f64>>()[..]))
}

/// The defaults of the options of the reconstruction.
#[wasm_bindgen(unchecked_return_type = "ReconstructionOptions")]
pub fn reconstruction_defaults() -> JsValue {
    pack(&ReconstructionOptions::default())
}

/// Every tunable of the reconstruction and of the bundle adjustment.
#[wasm_bindgen(unchecked_return_type = "Parameter[]")]
pub fn reconstruction_parameters() -> JsValue {
    pack(&[RECONSTRUCTION_PARAMETERS, ADJUSTMENT_PARAMETERS].concat())
}

/// What can become of a ray that is refined, in the order of its codes.
#[wasm_bindgen(unchecked_return_type = "RefinementOutcome[]")]
pub fn refinement_outcomes() -> JsValue {
    pack(&RefinementOutcome::ALL)
}
