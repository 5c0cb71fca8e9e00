//! A finished block in wasm memory: what it writes and shows.

use super::convert::{JsResult, emitting, numbers, object, pack, read, set, thrown};
use crate::{
    BlockFiles, BlockModel, BlockOverview, BlockRun, BlockScore, Error, ExportFormat, FileFault, PointColumns, Project, check_truth,
    export_block, planned_files as plan, read_project, score_block, write_block_project,
};
use js_sys::{Function, Uint16Array};
use std::rc::Rc;
use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::{JsCast, JsValue};

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** The points of the model that is written. */
export interface PointColumns {
    rays: Uint16Array;
    /** NaN where a point is not adjusted. */
    rmse_px: Float64Array;
    /** X, Y, Z; NaN where a point is not intersected; stride 3. */
    positions: Float64Array;
    /** Standard errors of X, Y, Z; NaN where there are none; stride 3. */
    errors: Float64Array;
    /** Probability, 0..1, that all rays belong together. */
    confidence: Float64Array;
}

/** A message and its text. */
export type WithText<M> = M & { text: string };

/** Takes the path of a file, with slashes and relative to the folder of the block, and its text. */
export type Emit = (path: string, text: string) => void;
"#;

/// A block that was run, or opened from its project file; its owner frees it.
#[wasm_bindgen]
pub struct FinishedBlock {
    run: Rc<BlockRun>,
}

impl FinishedBlock {
    /// What a run has found.
    pub(super) fn of(run: BlockRun) -> Self {
        Self { run: Rc::new(run) }
    }
}

#[wasm_bindgen]
impl FinishedBlock {
    /// Opens a project file; one that is damaged or of another kind is refused whole.
    pub fn open(bytes: &[u8]) -> JsResult<FinishedBlock> {
        match read_project(bytes).map_err(thrown)? {
            Project::Block(run) => Ok(Self::of(*run)),
            Project::Pair(_) => {
                Err(thrown(Error::UnreadableFile { what: "the project file", place: "content".into(), file_fault: FileFault::HoldsPair }))
            }
        }
    }

    /// The text of its project file.
    pub fn project(&self) -> JsResult<String> {
        write_block_project(&self.run).map_err(thrown)
    }

    /// The model that is written.
    #[wasm_bindgen(unchecked_return_type = "BlockModel")]
    pub fn model(&self) -> JsValue {
        pack(&self.run.model)
    }

    /// What is shown of it.
    #[wasm_bindgen(unchecked_return_type = "BlockOverview & { points: PointColumns }")]
    pub fn overview(&self) -> JsResult<JsValue> {
        let packed = pack(&BlockOverview::new(&self.run).map_err(thrown)?);
        let points = PointColumns::new(&self.run);
        let columns = object([
            ("rays", Uint16Array::from(&points.rays[..]).unchecked_into()),
            ("rmse_px", numbers(points.rmse_px)),
            ("positions", numbers(points.positions.into_iter().flatten())),
            ("errors", numbers(points.errors.into_iter().flatten())),
            ("confidence", numbers(points.confidence)),
        ]);
        set(&packed, "points", &columns);
        Ok(packed)
    }

    /// How near a simulated block is to its truth.
    #[wasm_bindgen(unchecked_return_type = "BlockScore")]
    pub fn score(&self, #[wasm_bindgen(unchecked_param_type = "BlockModel")] truth: &JsValue) -> JsResult<JsValue> {
        score_block(&self.run.model, &read::<BlockModel>("truth", truth)?).map(|score| pack(&score)).map_err(thrown)
    }

    /// Writes it in one format.
    pub fn export(
        &self,
        #[wasm_bindgen(unchecked_param_type = "ExportFormat")] format: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "Emit")] emit: &Function,
    ) -> JsResult<()> {
        let format: ExportFormat = read("format", format)?;
        emitting(emit, |emit| export_block(&self.run.model, format, emit))
    }

    /// All its files, in steps of about one. `score`: what the summary holds of a simulated block.
    pub fn files(
        &self,
        #[wasm_bindgen(unchecked_param_type = "readonly ExportFormat[]")] formats: &JsValue,
        #[wasm_bindgen(unchecked_optional_param_type = "BlockScore | null")] score: &JsValue,
    ) -> JsResult<BlockWriting> {
        let (formats, score): (Vec<ExportFormat>, Option<BlockScore>) = (read("formats", formats)?, read("score", score)?);
        Ok(BlockWriting { run: self.run.clone(), files: BlockFiles::new(&formats, score) })
    }
}

/// The files of a block, of which each step writes some.
#[wasm_bindgen]
pub struct BlockWriting {
    run: Rc<BlockRun>,
    files: BlockFiles,
}

#[wasm_bindgen]
impl BlockWriting {
    /// Writes the next files; gives the summary after the last one, null before.
    #[wasm_bindgen(unchecked_return_type = "Summary | null")]
    pub fn step(&mut self, #[wasm_bindgen(unchecked_param_type = "Emit")] emit: &Function) -> JsResult<JsValue> {
        emitting(emit, |emit| self.files.step(&self.run, emit)).map(|summary| pack(&summary))
    }
}

/// The files that a block of images with these names is written to, but for those of which there is one for each two images.
#[wasm_bindgen]
pub fn planned_files(
    #[wasm_bindgen(unchecked_param_type = "readonly string[]")] names: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "readonly ExportFormat[]")] formats: &JsValue,
) -> JsResult<Vec<String>> {
    let (names, formats): (Vec<String>, Vec<ExportFormat>) = (read("names", names)?, read("formats", formats)?);
    plan(&names, &formats).map_err(thrown)
}

/// Refuses a truth of other images.
#[wasm_bindgen]
pub fn check_block_truth(
    #[wasm_bindgen(unchecked_param_type = "BlockModel")] truth: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "readonly string[]")] names: &JsValue,
) -> JsResult<()> {
    let (truth, names): (BlockModel, Vec<String>) = (read("truth", truth)?, read("names", names)?);
    check_truth(&truth, &names).map_err(thrown)
}
