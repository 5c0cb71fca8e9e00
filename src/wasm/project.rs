//! The project file of a pair, which is plain data on either side; that of a block is written and opened by `FinishedBlock`.

use super::convert::{JsResult, Numbers, ProjectFile, object, pack, read, read_options, rows, set, thrown, wrong_project};
use super::matching::{pack_matches, pack_pair, read_points};
use super::simulate::{pack_score, read_score};
use crate::{
    Error, FileFault, Fit, Match, MatchSet, PairEdits, PairPhoto, PairResult, PairRun, PairTruth, PointSet, PointStatistics, Project,
    RelativeOrientation, Rule, TwoView, Verdict, project_kind as kind_of, read_project, write_pair_project as write,
};
use js_sys::{Array, Int32Array, Object, Reflect, Uint8Array, Uint32Array};
use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::{JsCast, JsValue};

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** A pair that was matched and oriented, with all that was given for it. */
export interface PairProject {
    /** The left and the right one. */
    images: [PairPhoto, PairPhoto];
    input: Given<PairInput>;
    settings: Given<PairSettings>;
    output: PairOutput;
    /** What is known of a simulated pair. */
    truth: PairTruth | null;
    /** What was changed by hand; null where nothing was. */
    edited?: PairEdits | null;
}

/** Edits of the matches of a pair, and the matches that were found: the output has the edited ones. */
export interface PairEdits {
    /** In their order. */
    edits: readonly PairEdit[];
    /** Of the left points before those that were measured by hand, which come last. */
    found: Omit<MatchResult, "geometry" | "no_geometry">;
}

/** The truth of a simulated pair. */
export interface PairTruth {
    /** by and bz at the scale of `base_mm`. */
    orientation: FiveParameters;
    base_mm: number;
    score: MatchScore;
}
"#;

/// What a project file holds, by its first kilobyte; null for what is no project.
#[wasm_bindgen(unchecked_return_type = "ProjectKind | null")]
pub fn project_kind(start: &ProjectFile) -> JsResult<JsValue> {
    Ok(pack(&kind_of(&start.read("start of the file")?)))
}

/// Writes the project file of a pair.
#[wasm_bindgen]
pub fn write_pair_project(#[wasm_bindgen(unchecked_param_type = "PairProject")] project: &JsValue) -> JsResult<String> {
    let images: [PairPhoto; 2] = read("images", &field(project, "images"))?;
    let given = (read_options("input", &field(project, "input"))?, read_options("settings", &field(project, "settings"))?);
    let truth = present(project, "truth").map(|truth| read_truth(&truth)).transpose()?;
    let run = PairRun::new(images, given, read_result(&field(project, "output"))?, truth).map_err(thrown)?;
    let run = match present(project, "edited") {
        Some(edited) => run.edited(read_edits(&edited)?).map_err(thrown)?,
        None => run,
    };
    write(&run).map_err(thrown)
}

/// Opens the project file of a pair; one that is damaged or of another kind is refused whole.
#[wasm_bindgen(unchecked_return_type = "PairProject")]
pub fn open_pair_project(file: &ProjectFile) -> JsResult<JsValue> {
    match read_project(&file.read("file of the project")?).map_err(thrown)? {
        Project::Pair(run) => Ok(object([
            ("images", pack(&run.images)),
            ("input", pack(&run.input)),
            ("settings", pack(&run.settings)),
            ("output", pack_pair(&run.result)),
            ("truth", run.truth.as_ref().map_or(JsValue::NULL, pack_truth)),
            ("edited", run.edited.as_ref().map_or(JsValue::NULL, pack_edits)),
        ])),
        Project::Block(_) => Err(thrown(wrong_project(FileFault::HoldsBlock))),
    }
}

fn pack_edits(edited: &PairEdits) -> JsValue {
    object([("edits", pack(&edited.edits)), ("found", pack_matches(&edited.found))])
}

fn read_edits(value: &JsValue) -> JsResult<PairEdits> {
    Ok(PairEdits { edits: read("edits", &field(value, "edits"))?, found: read_matches(&field(value, "found"))? })
}

fn pack_truth(truth: &PairTruth) -> JsValue {
    object([("orientation", pack(&truth.orientation)), ("base_mm", truth.base_mm.into()), ("score", pack_score(&truth.score))])
}

fn read_truth(value: &JsValue) -> JsResult<PairTruth> {
    Ok(PairTruth {
        orientation: read("orientation", &field(value, "orientation"))?,
        base_mm: read("base_mm", &field(value, "base_mm"))?,
        score: read_score(&field(value, "score")),
    })
}

fn field(value: &JsValue, name: &str) -> JsValue {
    Reflect::get(value, &name.into()).unwrap_or(JsValue::NULL)
}

fn present(value: &JsValue, name: &str) -> Option<JsValue> {
    Some(field(value, name)).filter(|found| !found.is_null() && !found.is_undefined())
}

pub(super) fn floats(value: &JsValue, name: &'static str) -> JsResult<Vec<f64>> {
    field(value, name).unchecked_ref::<Numbers>().read(name)
}

/// The opposite of `pack_pair`.
fn read_result(output: &JsValue) -> JsResult<PairResult> {
    let found = field(output, "match");
    let geometry: Option<TwoView> = read("geometry", &field(&found, "geometry"))?;
    let geometry = match geometry {
        Some(geometry) => Some(Ok(geometry)),
        None => read::<Option<_>>("no_geometry", &field(&found, "no_geometry"))?.map(Err),
    };
    let orientation = match present(output, "orientation") {
        Some(orientation) => Ok(read_orientation(&orientation)?),
        None => Err(read("no_orientation", &field(output, "no_orientation"))?),
    };
    Ok(PairResult {
        left: read_set(&field(output, "left"))?,
        right: read_set(&field(output, "right"))?,
        offset: read("offset field", &field(output, "offset"))?,
        geometry,
        matching: read_matches(&found)?,
        interior: read("interior", &field(output, "interior"))?,
        orientation,
    })
}

fn read_set(value: &JsValue) -> JsResult<PointSet> {
    let set = read_points(value)?.set;
    let threshold = field(value, "threshold").as_f64().unwrap_or(f64::INFINITY);
    Ok(PointSet { counts: read("counts", &field(value, "counts"))?, threshold, ..set })
}

/// What is said of arrays that do not belong together.
fn other_lengths() -> JsValue {
    let allowed = "three arrays of as many matches and four of as many points".into();
    thrown(Error::InvalidArgument { what: "matches", got: "arrays of other lengths".into(), wanted: allowed })
}

/// The matches of a `MatchResult`, without what became of the points.
pub(super) fn read_matched(value: &JsValue) -> JsResult<Vec<Match>> {
    let (matches, fits) = (floats(value, "matches")?, floats(value, "fits")?);
    let (matches, fits) = (rows::<5>("matches", &matches)?, rows::<5>("fits", &fits)?);
    let indices = Uint32Array::new(&field(value, "indices")).to_vec();
    let indices = indices.as_chunks::<2>().0;
    if [fits.len(), indices.len()].iter().any(|length| *length != matches.len()) {
        return Err(other_lengths());
    }
    let fit = |[correlation, xx, xy, yy, iterations]: [f64; 5]| {
        (!correlation.is_nan()).then_some(Fit { correlation, covariance: [xx, xy, yy], iterations: iterations as usize })
    };
    let matched = matches.iter().zip(fits).zip(indices).map(|((found, fitted), [left, right])| {
        let [xl, yl, xr, yr, measure] = *found;
        let right = (*right != u32::MAX).then_some(*right as usize);
        Match { left: *left as usize, right, left_px: [xl, yl], right_px: [xr, yr], measure, fit: fit(*fitted) }
    });
    Ok(matched.collect())
}

/// The opposite of `pack_matches`.
fn read_matches(value: &JsValue) -> JsResult<MatchSet> {
    let matches = read_matched(value)?;
    let (places, measures) = (floats(value, "places")?, floats(value, "measures")?);
    let (places, measures) = (rows::<2>("places", &places)?, rows::<2>("measures", &measures)?);
    let (rules, best) = (Uint8Array::new(&field(value, "rules")).to_vec(), Int32Array::new(&field(value, "best")).to_vec());
    if [best.len(), places.len(), measures.len()].iter().any(|length| *length != rules.len()) {
        return Err(other_lengths());
    }
    let verdicts = rules.iter().zip(best).zip(places).zip(measures).map(|(((rule, best), place), [measure, second])| Verdict {
        rule: Rule::ALL.get(usize::from(*rule)).copied().unwrap_or(Rule::NoCandidate),
        best: usize::try_from(best).ok(),
        position: (!place[0].is_nan()).then_some(*place),
        measure: *measure,
        second: *second,
        fit: None,
    });
    Ok(MatchSet { matches, verdicts: verdicts.collect(), counts: read("counts", &field(value, "counts"))? })
}

/// The opposite of `pack_orientation`.
fn read_orientation(value: &JsValue) -> JsResult<RelativeOrientation> {
    let points = floats(value, "points")?;
    let statistics = |row: &[f64; 9]| {
        let [parallax_mm, redundancy, w, detectable_mm, influence, weight, x, y, z] = *row;
        let model_mm = (!x.is_nan()).then_some([x, y, z]);
        (!parallax_mm.is_nan()).then_some(PointStatistics { parallax_mm, redundancy, w, detectable_mm, influence, weight, model_mm })
    };
    let points = rows::<9>("points", &points)?.iter().map(statistics).collect();
    let residuals_mm = rows::<4>("residuals_mm", &floats(value, "residuals_mm")?)?.to_vec();
    let plain = Object::assign(&Object::new(), value.unchecked_ref());
    ["residuals_mm", "points"].iter().for_each(|name| set(&plain, name, &Array::new()));
    Ok(RelativeOrientation { residuals_mm, points, ..read("orientation", &plain)? })
}
