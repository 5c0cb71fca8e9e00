//! A finished block in wasm memory: what it writes and shows.

use super::convert::{JsResult, Number, ProjectFile, Text, emitting, numbers, object, pack, read, set, thrown, whole, wrong_project};
use super::message::texts_of;
use crate::{
    BlockEdit, BlockFiles, BlockModel, BlockOverview, BlockPlaces, BlockRun, BlockScore, Carrying, ExportFormat, FileFault,
    HandMeasurement, ImagePoint, ObservationPart, PointColumns, Project, accuracy_map, block_covariances, block_epipolar_line,
    carried_steps as steps_carried, check_truth, covariance_table, export_run, image_points, meeting_place, planned_files as plan,
    point_detail, point_ids, read_project, score_block, write_block_project,
};
use js_sys::{Function, Uint8Array, Uint16Array, Uint32Array};
use std::rc::Rc;
use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::{JsCast, JsValue};

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** The points of the model that is written. */
export interface PointColumns {
    /** What the points are called by. */
    numbers: Uint32Array;
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

/** The observations of an image. */
export interface ImagePoints {
    /** Index of the point of each in the model that is written. */
    points: Uint32Array;
    /** Column and row in px; stride 2. */
    places: Float64Array;
    /** Observed minus computed in px; NaN where there is none; stride 2. */
    residuals: Float64Array;
    /** Redundancy numbers r, 0..1, of column and row; NaN where there are none, as of `w` and `detectable`; stride 2. */
    redundancy: Float64Array;
    /** Residuals by their standard errors (Baarda's w); stride 2. */
    w: Float64Array;
    /** Minimal detectable errors in px, found with a probability of 0.80; NaN where nothing checks the coordinate; stride 2. */
    detectable: Float64Array;
    /** 0: it takes part; 1: it was rejected; 2: it was rejected by hand. */
    parts: Uint8Array;
}

/** A message and its text. */
export type WithText<M> = M & { text: string };

/** Takes the path of a file, with slashes and relative to the folder of the block, and its text. */
export type Emit = (path: string, text: string) => void;

/** A map of expected standard errors, on a grid over the ground. */
export interface AccuracyFiles {
    /** GeoTIFF of floating-point numbers: the standard error in plan, that in height, and the number of images; NaN stands for nothing. */
    plan: Uint8Array;
    height: Uint8Array;
    images: Uint8Array;
    /** The same as a table. */
    table: string;
    summary: AccuracySummary;
}
"#;

/// The steps of edits that hold in another block, that was found or placed anew: by names of images and surveyed points, and by where places lie.
#[wasm_bindgen(unchecked_return_type = "CarriedSteps")]
pub fn carried_steps(#[wasm_bindgen(unchecked_param_type = "Carrying")] carrying: &JsValue) -> JsResult<JsValue> {
    Ok(pack(&steps_carried(&read::<Carrying>("carrying", carrying)?)))
}

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

    pub(super) fn run(&self) -> &BlockRun {
        &self.run
    }
}

#[wasm_bindgen]
impl FinishedBlock {
    /// Opens a project file; one that is damaged or of another kind is refused whole.
    pub fn open(file: &ProjectFile) -> JsResult<FinishedBlock> {
        match read_project(&file.read("file of the project")?).map_err(thrown)? {
            Project::Block(run) => Ok(Self::of(*run)),
            Project::Pair(_) => Err(thrown(wrong_project(FileFault::HoldsPair))),
        }
    }

    /// The text of its project file.
    pub fn project(&self) -> JsResult<String> {
        write_block_project(&self.run).map_err(thrown)
    }

    /// What came of the orthophoto that the block was given; null where it was given none.
    #[wasm_bindgen(unchecked_return_type = "OnOrthophoto | null")]
    pub fn on_orthophoto(&self) -> JsValue {
        pack(&self.run.orthophoto)
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
            ("numbers", Uint32Array::from(&points.numbers[..]).unchecked_into()),
            ("rays", Uint16Array::from(&points.rays[..]).unchecked_into()),
            ("rmse_px", numbers(points.rmse_px)),
            ("positions", numbers(points.positions.into_iter().flatten())),
            ("errors", numbers(points.errors.into_iter().flatten())),
            ("confidence", numbers(points.confidence)),
        ]);
        set(&packed, "points", &columns);
        Ok(packed)
    }

    /// The block as it was found with these edits, whatever edits it has, adjusted anew; without any, as it was found. `steps`: how many of them each
    /// step has that is undone at once; one where it is absent.
    pub fn edited(
        &self,
        #[wasm_bindgen(unchecked_param_type = "readonly BlockEdit[]")] edits: &JsValue,
        #[wasm_bindgen(unchecked_optional_param_type = "readonly number[]")] steps: &JsValue,
    ) -> JsResult<FinishedBlock> {
        let edits: Vec<BlockEdit> = read("edits", edits)?;
        let steps: Option<Vec<usize>> = read("steps", steps)?;
        let run = self.run.with_edits(&edits).and_then(|run| match steps {
            Some(steps) => run.in_steps(&steps),
            None => Ok(run),
        });
        run.map(Self::of).map_err(thrown)
    }

    /// The edits that it has.
    #[wasm_bindgen(unchecked_return_type = "BlockEdit[]")]
    pub fn edits(&self) -> JsValue {
        pack(&self.run.edits())
    }

    /// How many edits each step has.
    #[wasm_bindgen(unchecked_return_type = "number[]")]
    pub fn edit_steps(&self) -> JsValue {
        pack(&self.run.edit_steps())
    }

    /// Its places of an orthophoto, by which edits of them are carried to the same block once it is placed anew.
    #[wasm_bindgen(unchecked_return_type = "BlockPlaces")]
    pub fn places(&self) -> JsResult<JsValue> {
        self.run.places().map(|places| pack(&places)).map_err(thrown)
    }

    /// Which of its places lie where those of the same block lay when it was placed before.
    #[wasm_bindgen(unchecked_return_type = "PlaceAgain[]")]
    pub fn places_again(&self, #[wasm_bindgen(unchecked_param_type = "BlockPlaces")] before: &JsValue) -> JsResult<JsValue> {
        let before: BlockPlaces = read("before", before)?;
        self.run.places().map(|places| pack(&places.again(&before))).map_err(thrown)
    }

    /// The edits of the same block as it was placed before, for this one, to which `edited` applies them; those of places hold where the places lie again.
    #[wasm_bindgen(unchecked_return_type = "CarriedEdits")]
    pub fn carried_edits(&self, before: &FinishedBlock) -> JsResult<JsValue> {
        let places = before.run.places().map_err(thrown)?;
        self.run.carried_edits(&places, before.run.edits()).map(|carried| pack(&carried)).map_err(thrown)
    }

    /// The points of the model that is written by what they are, whatever their indices; empty for a block that is not oriented.
    #[wasm_bindgen(unchecked_return_type = "PointSource[]")]
    pub fn point_ids(&self) -> JsValue {
        pack(&point_ids(&self.run))
    }

    /// The number of a point, also where it is rejected; absent for a block that is not oriented.
    pub fn point_number(&self, #[wasm_bindgen(unchecked_param_type = "PointSource")] point: &JsValue) -> JsResult<Option<u32>> {
        Ok(self.run.point_number(read("point", point)?))
    }

    /// All that is known of a point of the model that is written.
    #[wasm_bindgen(unchecked_return_type = "PointDetail")]
    pub fn point(&self, point: &Number) -> JsResult<JsValue> {
        point_detail(&self.run, whole("index of the point", point)?).map(|detail| pack(&detail)).map_err(thrown)
    }

    /// The observations of an image.
    #[wasm_bindgen(unchecked_return_type = "ImagePoints")]
    pub fn image_points(&self, image: &Number) -> JsResult<JsValue> {
        let found = image_points(&self.run, whole("index of the image", image)?).map_err(thrown)?;
        let points: Vec<u32> = found.iter().map(|seen| seen.point as u32).collect();
        let parts: Vec<u8> = found.iter().map(|seen| part_code(seen.part)).collect();
        let of_axes =
            |of: &dyn Fn(&ImagePoint) -> Option<[f64; 2]>| numbers(found.iter().flat_map(|seen| of(seen).unwrap_or([f64::NAN; 2])));
        Ok(object([
            ("points", Uint32Array::from(&points[..]).unchecked_into()),
            ("places", numbers(found.iter().flat_map(|seen| seen.place_px))),
            ("residuals", of_axes(&|seen| seen.residual_px)),
            ("redundancy", of_axes(&|seen| seen.redundancy)),
            ("w", of_axes(&|seen| seen.w)),
            ("detectable", numbers(found.iter().flat_map(|seen| seen.detectable_px.map(|error| error.unwrap_or(f64::NAN))))),
            ("parts", Uint8Array::from(&parts[..]).unchecked_into()),
        ]))
    }

    /// The epipolar line of a place of one image in another one: x, y in px, stride 2, as far as that shows it, from near to far.
    pub fn epipolar_line(&self, from: &Number, x_px: &Number, y_px: &Number, to: &Number) -> JsResult<Vec<f64>> {
        let (from, to) = (whole("index of the image", from)?, whole("index of the other image", to)?);
        let at = [x_px.read("x_px")?, y_px.read("y_px")?];
        block_epipolar_line(&self.run, from, at, to).map(|line| line.into_iter().flatten().collect()).map_err(thrown)
    }

    /// The place that is nearest to the rays of measurements that take no part: X, Y, Z; absent where they do not meet.
    pub fn meeting_place(
        &self,
        #[wasm_bindgen(unchecked_param_type = "readonly HandMeasurement[]")] measurements: &JsValue,
    ) -> JsResult<Option<Vec<f64>>> {
        let measurements: Vec<HandMeasurement> = read("measurements", measurements)?;
        Ok(meeting_place(&self.run, &measurements).map_err(thrown)?.map(Into::into))
    }

    /// The covariances of images, points and cameras with these names as a table of text: each row an unknown with its unit, adjusted value and standard
    /// error, then its covariances with all of them. `all` names the whole block.
    pub fn covariances(&self, #[wasm_bindgen(unchecked_param_type = "readonly string[]")] names: &JsValue) -> JsResult<String> {
        let names: Vec<String> = read("names", names)?;
        block_covariances(&self.run, &names).map(|found| covariance_table(&found)).map_err(thrown)
    }

    /// A map of the standard errors that are expected of points that would be measured in the block. `cell`: the side of a cell, in units of the block;
    /// `sigma_px`: the standard error of an image coordinate. Absent: an eightieth of the longer side; σ₀ of the block.
    #[wasm_bindgen(unchecked_return_type = "AccuracyFiles")]
    pub fn accuracy(&self, cell: Option<Number>, sigma_px: Option<Number>) -> JsResult<JsValue> {
        let read = |what, number: Option<Number>| number.map(|number| number.read(what)).transpose();
        let map = accuracy_map(&self.run, read("cell", cell)?, read("sigma_px", sigma_px)?).map_err(thrown)?;
        let [plan, height, images] = map.rasters().map_err(thrown)?.map(|file| JsValue::from(Uint8Array::from(file.as_slice())));
        let (table, summary) = (map.table().into(), pack(&map.summary()));
        Ok(object([("plan", plan), ("height", height), ("images", images), ("table", table), ("summary", summary)]))
    }

    /// How near a simulated block is to its truth.
    #[wasm_bindgen(unchecked_return_type = "BlockScore")]
    pub fn score(&self, #[wasm_bindgen(unchecked_param_type = "BlockModel")] truth: &JsValue) -> JsResult<JsValue> {
        score_block(&self.run.model, &read::<BlockModel>("truth", truth)?).map(|score| pack(&score)).map_err(thrown)
    }

    /// Writes it in one format; tables are in the coordinate reference system of the results.
    pub fn export(
        &self,
        #[wasm_bindgen(unchecked_param_type = "ExportFormat")] format: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "Emit")] emit: &Function,
    ) -> JsResult<()> {
        let format: ExportFormat = read("format", format)?;
        emitting(emit, |emit| export_run(&self.run, format, emit))
    }

    /// All its files, in steps of about one. `score`: what the summary holds of a simulated block; `language`: the tag of that of the report, `en`
    /// where it is absent.
    pub fn files(
        &self,
        #[wasm_bindgen(unchecked_param_type = "readonly ExportFormat[]")] formats: &JsValue,
        #[wasm_bindgen(unchecked_optional_param_type = "BlockScore | null")] score: &JsValue,
        #[wasm_bindgen(unchecked_optional_param_type = "string | null")] language: Option<Text>,
    ) -> JsResult<BlockWriting> {
        let (formats, score): (Vec<ExportFormat>, Option<BlockScore>) = (read("formats", formats)?, read("score", score)?);
        Ok(BlockWriting { run: self.run.clone(), files: BlockFiles::new(&formats, score, texts_of(language)?) })
    }
}

fn part_code(part: ObservationPart) -> u8 {
    match part {
        ObservationPart::Accepted | ObservationPart::NotAdjusted => 0,
        ObservationPart::RejectedByHand => 2,
        _ => 1,
    }
}

/// The files of a block, of which each step writes some.
#[wasm_bindgen]
pub struct BlockWriting {
    run: Rc<BlockRun>,
    files: BlockFiles<'static>,
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
