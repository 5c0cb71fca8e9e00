//! Multi-scale points with gradient descriptors.

use super::convert::{Bytes, JsResult, numbers, object, pack, read_options, thrown};
use super::photo::{Photo, read_mask};
use crate::{FeatureOptions, features};
use js_sys::Uint8Array;
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** Points with their descriptors. */
export interface Features {
    /** x, y and scale in px, the dominant direction in rad from x towards y, and the weight: stride 5. */
    points: Float64Array;
    /** 128 bytes a point. */
    descriptors: Uint8Array;
}
"#;

#[wasm_bindgen]
impl Photo {
    /// Finds points distinct in position and scale and describes them by the gradients around them. Points whose pixel is 0 in the mask,
    /// of the image's size and row by row, are left out.
    #[wasm_bindgen(unchecked_return_type = "Features")]
    pub fn features(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Given<FeatureOptions>")] options: &JsValue,
        mask: Option<Bytes>,
    ) -> JsResult<JsValue> {
        let mask = read_mask(mask)?;
        let options: FeatureOptions = read_options("features", options)?;
        let found = features(self.view(), self.masked(&mask)?, &options).map_err(thrown)?;
        let points = found.iter().flat_map(|f| [f.point.x, f.point.y, f.point.scale_px, f.orientation_rad, f.point.weight]);
        let descriptors: Vec<u8> = found.iter().flat_map(|f| f.descriptor).collect();
        Ok(object([("points", numbers(points)), ("descriptors", Uint8Array::from(&descriptors[..]).into())]))
    }
}

/// The defaults of the options of features.
#[wasm_bindgen(unchecked_return_type = "FeatureOptions")]
pub fn feature_defaults() -> JsValue {
    pack(&FeatureOptions::default())
}
