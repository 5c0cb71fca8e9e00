//! What a block is set by, and where its images are.

use super::about::pack_groups;
use super::convert::{JsResult, Numbers, pack, read_options, rows, thrown};
use crate::{BlockSettings, PartlyGiven, acting, local_from_geographic};
use js_sys::Float64Array;
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

/// Every option of a block, in the order of the pipeline.
#[wasm_bindgen(unchecked_return_type = "Parameter[]")]
pub fn block_parameters() -> JsValue {
    pack_groups(BlockSettings::GROUPS)
}

/// The keys of the options of a block that have an effect with these settings.
#[wasm_bindgen(unchecked_return_type = "string[]")]
pub fn acting_block_parameters(#[wasm_bindgen(unchecked_param_type = "Given<BlockSettings>")] settings: &JsValue) -> JsResult<JsValue> {
    Ok(pack(&acting(BlockSettings::parameters(), &read_options::<BlockSettings>("block", settings)?)))
}

/// All settings of a block: those given, the others from the defaults. Values of pairs, points and selection outside their ranges are refused.
#[wasm_bindgen(unchecked_return_type = "BlockSettings")]
pub fn block_settings(#[wasm_bindgen(unchecked_param_type = "Given<BlockSettings>")] given: &JsValue) -> JsResult<JsValue> {
    let settings: BlockSettings = read_options("block", given)?;
    settings.check().map(|()| pack(&settings)).map_err(thrown)
}

/// Positions in m east, north and up of the first known one: of longitude, latitude in degrees and height in m (stride 3), NaN where not known.
#[wasm_bindgen]
pub fn local_positions(geographic: &Numbers) -> JsResult<Float64Array> {
    let geographic = geographic.read("geographic positions")?;
    let places = rows::<3>("geographic positions", &geographic)?;
    let origin = places.iter().find(|p| p.iter().all(|v| v.is_finite()));
    let local = |p: &[f64; 3]| origin.map_or([f64::NAN; 3], |origin| local_from_geographic(*p, *origin));
    Ok(Float64Array::from(&places.iter().flat_map(local).collect::<Vec<f64>>()[..]))
}
