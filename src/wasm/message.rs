//! The texts of messages.

use super::convert::{JsResult, Text, read, thrown};
use crate::{Error, Texts};
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
    observation_group: { kind: ObservationGroup };
    placing_verdict: PlacingVerdict;
    place_search: PlaceSearch;
    image_reason: ImageReason;
    on_orthophoto: OnOrthophoto;
}
"#;

#[wasm_bindgen(typescript_custom_section)]
const TYPED: &str = r#"
/**
 * The text of a message of a family, or, by its name, another text that belongs to it, as its `label`; in English, or in the language of a tag
 * (`ar`) that there is a catalogue of.
 */
export function message<F extends keyof Messages>(family: F, message: Messages[F], attribute?: string | null, language?: string | null): string;
"#;

/// The text of a message, or, by its name, another text that belongs to it, as its `label`; in English, or in the language of a tag (`ar`)
/// that there is a catalogue of.
#[wasm_bindgen(skip_typescript)]
pub fn message(family: &Text, message: &JsValue, attribute: Option<Text>, language: Option<Text>) -> JsResult<String> {
    let (family, message) = (family.read("family")?, read::<Value>("message", message)?);
    let attribute = attribute.map(|attribute| attribute.read("attribute")).transpose()?;
    let texts = texts_of(language)?;
    let (attribute, id) = (attribute.as_deref(), Texts::id_of(&family, &message));
    if !Texts::english().has(&id, attribute) {
        let got = attribute.map_or(id.clone(), |attribute| format!("{id}.{attribute}"));
        let wanted = "a family of messages, and one that belongs to it".into();
        return Err(thrown(Error::InvalidArgument { what: "message", got, wanted }));
    }
    Ok(texts.text_of(&family, &message, attribute))
}

/// The texts of the language of a tag; of English without any.
pub(super) fn texts_of(language: Option<Text>) -> JsResult<&'static Texts> {
    let language = language.map(|language| language.read("language")).transpose()?;
    Ok(Texts::of(language.as_deref().unwrap_or("en")))
}
