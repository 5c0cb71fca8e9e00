//! The texts of messages.

use super::convert::{JsResult, read};
use crate::Texts;
use serde_json::Value;
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** The families of messages, each with what it says. */
export interface Messages {
    warning: Warning;
    block_warning: BlockWarning;
    unoriented: UnorientedReason;
    connection: Connection;
    outcome: PairOutcome;
    failure: Failure;
    remark: Remark;
    no_geometry: NoGeometry;
    no_orientation: NoOrientation;
    pair_verdict: PairVerdict;
    pair_hint: PairHint;
    block_verdict: BlockVerdict;
    degeneracy: Degeneracy;
    two_view_model: Pick<TwoViewModel, "kind">;
    verdict: Rule | "gross_error" | "undecided";
    camera_caution: CameraCaution;
    camera_origin: CameraOrigin;
    camera_parameter: CameraParameter;
    error: { kind: string };
    allowed: { kind: string };
    overview_warning: OverviewWarning;
    placing_verdict: PlacingVerdict;
    place_search: PlaceSearch;
    image_reason: ImageReason;
    on_orthophoto: OnOrthophoto;
}
"#;

/// The text of a message, or, by its name, another text that belongs to it, as its `label`; in English, or in the language of a tag (`ar`)
/// that there is a catalogue of.
#[wasm_bindgen]
pub fn message(
    #[wasm_bindgen(unchecked_param_type = "keyof Messages")] family: &str,
    #[wasm_bindgen(unchecked_param_type = "Messages[keyof Messages]")] message: &JsValue,
    attribute: Option<String>,
    language: Option<String>,
) -> JsResult<String> {
    Ok(Texts::of(language.as_deref().unwrap_or("en")).text_of(family, &read::<Value>("message", message)?, attribute.as_deref()))
}
