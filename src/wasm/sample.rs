//! The built-in sample pair.

use super::convert::{JsResult, object, pack, thrown};
use crate::{GreyImage, sample_pair};
use js_sys::{Float32Array, Uint8Array};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** Grey values 0..255, row by row. */
export interface SampleImage { width: number; height: number; grey: Uint8Array }

/** A simulated pair and its truth. */
export interface SamplePair {
    left: SampleImage;
    right: SampleImage;
    camera: Camera;
    base_mm: number;
    left_fiducials: Fiducial[];
    right_fiducials: Fiducial[];
    left_origin: [number, number];
    right_origin: [number, number];
    /** The true relative orientation. */
    truth: FiveParameters;
    /** For each left pixel, row by row, the x and y in px at which the right image shows the same; NaN where hidden or outside. */
    right_position: Float32Array;
}
"#;

/// Renders the sample pair of a seed.
#[wasm_bindgen(unchecked_return_type = "SamplePair")]
pub fn sample(seed: u32) -> JsResult<JsValue> {
    let sample = sample_pair(seed).map_err(thrown)?;
    let image = |grey: &GreyImage| {
        object([
            ("width", (grey.width() as f64).into()),
            ("height", (grey.height() as f64).into()),
            ("grey", Uint8Array::from(grey.data()).into()),
        ])
    };
    Ok(object([
        ("left", image(&sample.left)),
        ("right", image(&sample.right)),
        ("camera", pack(&sample.camera)),
        ("base_mm", sample.base_mm.into()),
        ("left_fiducials", pack(&sample.left_fiducials)),
        ("right_fiducials", pack(&sample.right_fiducials)),
        ("left_origin", pack(&sample.left_origin)),
        ("right_origin", pack(&sample.right_origin)),
        ("truth", pack(&sample.truth)),
        ("right_position", Float32Array::from(sample.right_position.as_flattened()).into()),
    ]))
}
