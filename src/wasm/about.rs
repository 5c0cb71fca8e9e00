//! What the module says of itself: version, defaults, parameters.

use super::convert::{object, pack};
use crate::{FEATURE_PARAMETERS, GEOMETRY_PARAMETERS, Operator, PARAMETERS, PairSettings, SAMPLE_SEED, Strategy};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

/// What `geometry` holds of the cameras.
const CAMERA: [&str; 2] = ["geometry.focal_px", "geometry.principal_px"];

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** Options of which any may be absent: these take their defaults. */
export type Given<T> = T extends unknown[] ? T : T extends object ? { [K in keyof T]?: Given<T[K]> } : T;

/** One tunable: `key` is its place in PairSettings, as "points.threshold". */
export type Parameter = { key: string; label: string; unit: string; help: string } & ParameterKind;

/** What an operator does where an option is absent. */
export interface OperatorDefaults { threshold: number; roundness: number; operator_window: number }

/** What every refused call throws. */
export interface TiepointError extends Error {
    name: "TiepointError";
    /** Stable for programs, as "invalid-option". */
    code: string;
    /** Whether the caller's options are at fault rather than the data. */
    usage: boolean;
}
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

/// The defaults of each operator for the options that are absent by default.
#[wasm_bindgen(unchecked_return_type = "Record<Operator, OperatorDefaults>")]
pub fn operator_defaults() -> JsValue {
    let of = |operator: Operator| {
        object([
            ("threshold", operator.default_threshold().into()),
            ("roundness", operator.default_roundness().into()),
            ("operator_window", (operator.default_window() as f64).into()),
        ])
    };
    object([
        ("moravec", of(Operator::Moravec)),
        ("forstner", of(Operator::Forstner)),
        ("ground1", of(Operator::Ground1)),
        ("ground2", of(Operator::Ground2)),
        ("multiscale", of(Operator::Multiscale)),
    ])
}

/// The ambiguity ratio of each strategy where none is chosen.
#[wasm_bindgen(unchecked_return_type = "Record<Strategy, number>")]
pub fn ambiguity_defaults() -> JsValue {
    let of = |strategy: Strategy| strategy.default_ambiguity().into();
    object([
        ("moments", of(Strategy::Moments)),
        ("invariants", of(Strategy::Invariants)),
        ("correlation", of(Strategy::Correlation)),
        ("least-squares", of(Strategy::LeastSquares)),
        ("gradient", of(Strategy::Gradient)),
    ])
}

/// Every tunable with label, unit, range and help, in the order of the pipeline.
#[wasm_bindgen(unchecked_return_type = "Parameter[]")]
pub fn parameters() -> JsValue {
    // Cameras are no settings: they belong to the photos.
    let geometry = GEOMETRY_PARAMETERS.iter().filter(|p| p.key.starts_with("geometry.") && !CAMERA.contains(&p.key));
    pack(&PARAMETERS.iter().chain(FEATURE_PARAMETERS).chain(geometry).collect::<Vec<_>>())
}

/// The seed of the built-in sample pair.
#[wasm_bindgen]
pub fn sample_seed() -> u32 {
    SAMPLE_SEED
}
