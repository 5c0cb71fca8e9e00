//! The report of a pair.

use super::convert::{Bytes, JsResult, Text, pack, read, read_options, rows, thrown, whole};
use super::message::texts_of;
use super::photo::{Photo, read_mask};
use super::project::{floats, read_matched};
use crate::{Error, FiveParameters, PAPER, PairInput, PairSettings, Report as Core, ReportEdits, ReportTruth};
use js_sys::{Float32Array, Reflect};
use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::{JsCast, JsValue};

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** The known answer of a simulated pair, as `simulate` gives it. */
export interface ReportTruth { orientation: FiveParameters; base_mm: number; right_position: Float32Array }

/** The matches of a run after edits by hand, in place of those that it finds. */
export interface ReportEdits {
    /** Those that take part, as a `MatchResult` has them. */
    match: Pick<MatchResult, "matches" | "fits" | "indices">;
    /** Left positions in px of the points that were measured by hand beside those that the operator finds; stride 2. */
    added_px: Float64Array;
    /** How many matches were rejected by hand. */
    rejected: number;
    /** How many matches have a place that was measured by hand. */
    measured: number;
}
"#;

/// What the paper printed for its own pair.
#[wasm_bindgen(unchecked_return_type = "Paper")]
pub fn paper() -> JsValue {
    pack(&PAPER)
}

/// The report of a pair in the making: `step` until it says false, then `html`.
#[wasm_bindgen]
pub struct Report {
    core: Core,
}

#[wasm_bindgen]
impl Report {
    /// Takes copies of both images; `names` are what the report calls them. Points whose pixel is 0 in the mask of their image, of its size
    /// and row by row, are left out. With edits the run is that of the edited matches; the other strategies match by themselves.
    #[allow(clippy::too_many_arguments)]
    #[wasm_bindgen(constructor)]
    pub fn new(
        left: &Photo,
        right: &Photo,
        #[wasm_bindgen(unchecked_param_type = "[string, string]")] names: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "Given<PairInput>")] input: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "Given<PairSettings>")] settings: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "ReportTruth | null")] truth: &JsValue,
        left_mask: Option<Bytes>,
        right_mask: Option<Bytes>,
        #[wasm_bindgen(unchecked_optional_param_type = "ReportEdits | null")] edits: &JsValue,
    ) -> JsResult<Report> {
        let [left_name, right_name]: [String; 2] = read("names", names)?;
        let (input, settings) = (read_options::<PairInput>("input", input)?, read_options::<PairSettings>("settings", settings)?);
        let images = [left.named(left_name, read_mask(left_mask)?)?, right.named(right_name, read_mask(right_mask)?)?];
        let core = Core::new(images, input, settings, read_truth(truth)?);
        Ok(Self { core: if edits.is_null() || edits.is_undefined() { core } else { core.edited(read_edits(edits)?) } })
    }

    /// What each step does, in their order; in English, or in the language of a tag.
    #[wasm_bindgen(unchecked_return_type = "string[]")]
    pub fn steps(&self, #[wasm_bindgen(unchecked_optional_param_type = "string | null")] language: Option<Text>) -> JsResult<JsValue> {
        let texts = texts_of(language)?;
        Ok(pack(&self.core.steps().iter().map(|step| texts.text(step)).collect::<Vec<_>>()))
    }

    /// Does the next step; false when all were done.
    pub fn step(&mut self) -> JsResult<bool> {
        self.core.step().map_err(thrown)
    }

    /// The verdict on this run; null before the first step.
    #[wasm_bindgen(unchecked_return_type = "PairVerdict | null")]
    pub fn verdict(&self) -> JsValue {
        pack(&self.core.verdict())
    }

    /// The page, which holds everything it shows; in English, or in the language of a tag. Does the steps that are left.
    pub fn html(&mut self, #[wasm_bindgen(unchecked_optional_param_type = "string | null")] language: Option<Text>) -> JsResult<String> {
        self.core.html(texts_of(language)?).map_err(thrown)
    }
}

fn read_edits(value: &JsValue) -> JsResult<ReportEdits> {
    let field = |name: &str| Reflect::get(value, &name.into()).unwrap_or_default();
    let number = |name| whole(name, field(name).unchecked_ref());
    Ok(ReportEdits {
        matches: read_matched(&field("match"))?,
        added_px: rows::<2>("added_px", &floats(value, "added_px")?)?.to_vec(),
        rejected: number("rejected")?,
        measured: number("measured")?,
    })
}

fn read_truth(value: &JsValue) -> JsResult<Option<ReportTruth>> {
    if value.is_null() || value.is_undefined() {
        return Ok(None);
    }
    let refused = |got: &str| {
        let allowed = "an object {orientation, base_mm, right_position} as simulate gives them".to_string();
        thrown(Error::InvalidArgument { what: "truth", got: got.to_string(), wanted: allowed })
    };
    let field = |name: &str| Reflect::get(value, &name.into()).map_err(|_| refused("no object"));
    let orientation: FiveParameters = read("truth", &field("orientation")?)?;
    let base_mm = field("base_mm")?.as_f64().ok_or_else(|| refused("no number as base_mm"))?;
    let flat = field("right_position")?.dyn_into::<Float32Array>().map_err(|_| refused("no Float32Array as right_position"))?.to_vec();
    Ok(Some(ReportTruth { orientation, base_mm, right_position: flat.as_chunks::<2>().0.to_vec() }))
}
