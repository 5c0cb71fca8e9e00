//! What the module says of itself: version, defaults, parameters.

use super::convert::{JsResult, pack, read, read_options};
use crate::{
    CALL_PARAMETERS, Group, OffsetField, PairHint, PairPreset, PairSettings, PairVerdict, Parameter, PartlyGiven, PhotoDifference, acting,
};
use serde::Serialize;
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** Options of which any may be absent: these take their defaults. */
export type Given<T> = T extends unknown[] ? T : T extends object ? { [K in keyof T]?: Given<T[K]> } : T;

/** One option, or a value of a call. */
export type Parameter = {
    /** What messages call it, as "multiscale.number". */
    key: string;
    /** Where it stands in the object of options, as "features.multiscale.number" of a block; of a value of a call the name of the argument. */
    path: string;
    /** The heading under which it stands. */
    section: string;
    label: string;
    unit: string;
    help: string;
    /** What holds where it is absent, in words; empty where it is never absent. */
    absent: string;
    /** When it has an effect, as "matching.strategy is gradient"; empty: always. */
    acts: string;
    /** Its name in the command where that is not the field's; empty otherwise. */
    named: string;
} & ParameterKind;

/** What every refused call throws. */
export interface TiepointError extends Error {
    name: "TiepointError";
    /** Stable for programs. */
    code: ErrorCode;
    /** Whether the caller's options are at fault rather than the data. */
    usage: boolean;
    /** What was wrong, with its figures: `message("error", error.error, null, "ar")` is the text in another language. */
    error: Messages["error"];
}

/** What a refused call says to programs; codes do not change between versions. */
export type ErrorCode =
    | "constant-window"
    | "degenerate"
    | "image-too-small"
    | "interrupted"
    | "invalid-input"
    | "invalid-json"
    | "invalid-option"
    | "not-converged"
    | "not-loaded"
    | "not-written"
    | "too-few"
    | "too-many-pixels"
    | "too-much-memory"
    | "unreadable-file"
    | "unreadable-image"
    | "unsupported-image"
    | "window-outside";
"#;

/// The version of the crate.
#[wasm_bindgen]
pub fn version() -> String {
    env!("CARGO_PKG_VERSION").to_string()
}

/// The defaults of all options.
#[wasm_bindgen(unchecked_return_type = "PairSettings")]
pub fn defaults() -> JsValue {
    pack(&PairSettings::default())
}

/// The names of ready-made settings.
#[wasm_bindgen(unchecked_return_type = "PairPreset[]")]
pub fn pair_presets() -> JsValue {
    pack(&PairPreset::ALL)
}

/// Ready-made settings.
#[wasm_bindgen(unchecked_return_type = "PairSettings")]
pub fn pair_preset(#[wasm_bindgen(unchecked_param_type = "PairPreset")] name: &JsValue) -> JsResult<JsValue> {
    Ok(pack(&read::<PairPreset>("preset", name)?.settings()))
}

/// Settings with every absent option that follows from the others, as all calls take them; what follows from the images stays absent.
#[wasm_bindgen(unchecked_return_type = "PairSettings")]
pub fn resolved(#[wasm_bindgen(unchecked_param_type = "Given<PairSettings>")] settings: &JsValue) -> JsResult<JsValue> {
    Ok(pack(&read_options::<PairSettings>("settings", settings)?.resolved()))
}

/// Every option of a pair, in the order of the pipeline.
#[wasm_bindgen(unchecked_return_type = "Parameter[]")]
pub fn parameters() -> JsValue {
    pack_groups(PairSettings::GROUPS)
}

/// What calls are given beside settings, by the names of their arguments.
#[wasm_bindgen(unchecked_return_type = "Parameter[]")]
pub fn call_parameters() -> JsValue {
    pack_groups(&[Group { path: "", parameters: CALL_PARAMETERS }])
}

/// The parameters of groups with their places in the whole.
pub fn pack_groups(groups: &[Group]) -> JsValue {
    let of_group = |group: &Group| group.parameters.iter().map(|parameter| (group.path_of(parameter), *parameter)).collect::<Vec<_>>();
    pack_parameters(groups.iter().flat_map(of_group))
}

/// Parameters with their places in an object.
pub fn pack_parameters(all: impl IntoIterator<Item = (String, Parameter)>) -> JsValue {
    #[derive(Serialize)]
    struct Placed {
        path: String,
        #[serde(flatten)]
        parameter: Parameter,
    }
    pack(&all.into_iter().map(|(path, parameter)| Placed { path, parameter }).collect::<Vec<_>>())
}

/// What else would do for a pair of this verdict and these settings; null where nothing is known to. With how the photos lie to each other
/// (`photo_difference`), and the offset by which matches were looked for, it says which of that the strategy does not take.
#[wasm_bindgen(unchecked_return_type = "PairHint | null")]
pub fn pair_hint(
    #[wasm_bindgen(unchecked_param_type = "PairVerdict")] verdict: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Given<PairSettings>")] settings: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "PhotoDifference | null")] difference: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "OffsetField | null")] offset: &JsValue,
) -> JsResult<JsValue> {
    let (verdict, settings) = (read::<PairVerdict>("verdict", verdict)?, read_options::<PairSettings>("settings", settings)?);
    let given = |value: &JsValue| !value.is_null() && !value.is_undefined();
    let difference: Option<PhotoDifference> = given(difference).then(|| read("difference", difference)).transpose()?;
    let offset: Option<OffsetField> = given(offset).then(|| read("offset", offset)).transpose()?;
    let hint = PairHint::of(&verdict, &settings);
    Ok(pack(&hint.map(|hint| difference.map_or(hint, |difference| hint.with(&difference, offset.as_ref(), &settings)))))
}

/// The keys of the options of a pair that have an effect with these settings.
#[wasm_bindgen(unchecked_return_type = "string[]")]
pub fn acting_parameters(#[wasm_bindgen(unchecked_param_type = "Given<PairSettings>")] settings: &JsValue) -> JsResult<JsValue> {
    let settings = read_options::<PairSettings>("settings", settings)?.resolved();
    Ok(pack(&acting(PairSettings::parameters(), &settings)))
}
