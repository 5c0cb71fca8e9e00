//! What the module says of itself: version, defaults, parameters.

use super::convert::{JsResult, pack, read, read_options};
use crate::{CALL_PARAMETERS, PairHint, PairPreset, PairSettings, PairVerdict, acting};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** Options of which any may be absent: these take their defaults. */
export type Given<T> = T extends unknown[] ? T : T extends object ? { [K in keyof T]?: Given<T[K]> } : T;

/** One option: `key` is its place in the settings, as "points.threshold". */
export type Parameter = {
    key: string;
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
    pack(&PairSettings::parameters().collect::<Vec<_>>())
}

/// What calls are given beside settings, by the names of their arguments.
#[wasm_bindgen(unchecked_return_type = "Parameter[]")]
pub fn call_parameters() -> JsValue {
    pack(&CALL_PARAMETERS)
}

/// What else would do for a pair of this verdict and these settings; null where nothing is known to.
#[wasm_bindgen(unchecked_return_type = "PairHint | null")]
pub fn pair_hint(
    #[wasm_bindgen(unchecked_param_type = "PairVerdict")] verdict: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Given<PairSettings>")] settings: &JsValue,
) -> JsResult<JsValue> {
    let (verdict, settings) = (read::<PairVerdict>("verdict", verdict)?, read_options::<PairSettings>("settings", settings)?);
    Ok(pack(&PairHint::of(&verdict, &settings)))
}

/// The keys of the options of a pair that have an effect with these settings.
#[wasm_bindgen(unchecked_return_type = "string[]")]
pub fn acting_parameters(#[wasm_bindgen(unchecked_param_type = "Given<PairSettings>")] settings: &JsValue) -> JsResult<JsValue> {
    let settings = read_options::<PairSettings>("settings", settings)?.resolved();
    Ok(pack(&acting(PairSettings::parameters(), &settings)))
}
