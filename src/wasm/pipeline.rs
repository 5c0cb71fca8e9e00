//! The run of a block: jobs out, bytes in.

use super::convert::{Bytes, JsResult, Text, TextList, kind_of, object, pack, read, read_options, thrown, wrong};
use super::finished::FinishedBlock;
use crate::{
    CameraRules, ControlTables, Document, Error, Failure, GeoreferencingOptions, PositionTable, Run as Pipeline, RunInput, Task, execute,
    json, masks_of,
};
use js_sys::{Array, Uint8Array};
use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::{JsCast, JsValue};

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** What is to be done for a job, beside the bytes of its files. */
export interface Work {
    /** Of the record that comes of it: a kept one is as good, and a new one is kept. Null where nothing is kept. */
    key: string | null;
    /** For `execute_job`. Null where the run takes the bytes of the only record, or nothing, and computes itself. */
    task: string | null;
    /** Keys of kept records whose bytes it takes, after those of the files. */
    records: string[];
    /** Bytes that it takes after those of the records. */
    input: Uint8Array | null;
}
"#;

/// The run of a block. Its host does the jobs of `next`, in any order and any number at the same time: it reads the files, asks `prepare`,
/// looks for a kept record of the key, which goes to `found`, and else calls `execute_job`, keeps what comes of it and hands it to `complete`.
#[wasm_bindgen]
pub struct Run {
    run: Pipeline,
}

#[wasm_bindgen]
impl Run {
    /// A run of which nothing is done; what can be refused before the images are read is refused here.
    #[wasm_bindgen(constructor)]
    pub fn new(#[wasm_bindgen(unchecked_param_type = "Given<RunInput>")] input: &JsValue) -> JsResult<Run> {
        let input: RunInput = read_options("block", input)?;
        Pipeline::new(input).map(|run| Self { run }).map_err(thrown)
    }

    /// Jobs that can be done now, at most so many. Where there are none, and none is under way, the run is over.
    #[wasm_bindgen(unchecked_return_type = "Job[]")]
    pub fn next(&mut self, most: usize) -> JsResult<JsValue> {
        self.run.next(most).map(|jobs| pack(&jobs)).map_err(thrown)
    }

    /// What is to be done for a job whose files have these digests, SHA-256 in hexadecimal digits.
    #[wasm_bindgen(unchecked_return_type = "Work")]
    pub fn prepare(&mut self, id: u32, digests: &TextList) -> JsResult<JsValue> {
        let work = self.run.prepare(id, &digests.read("digests")?).map_err(thrown)?;
        let task = work.task.map(|task| serde_json::to_string(&task).expect("plain data has a JSON form"));
        Ok(object([
            ("key", pack(&work.key)),
            ("task", task.map_or(JsValue::NULL, JsValue::from)),
            ("records", pack(&work.records)),
            ("input", work.input.map_or(JsValue::NULL, |input| Uint8Array::from(&input[..]).into())),
        ]))
    }

    /// Takes a kept record; one that does not read well is not taken, and the job is still to be done.
    pub fn found(&mut self, id: u32, record: &Bytes) -> JsResult<bool> {
        self.run.found(id, record.read("kept record")?).map_err(thrown)
    }

    /// Takes the bytes that came of a job.
    pub fn complete(&mut self, id: u32, bytes: &Bytes) -> JsResult<()> {
        self.run.complete(id, bytes.read("bytes of the job")?).map_err(thrown)
    }

    /// Takes why a job could not be done: an image or a pair is left out with it, where these are to blame.
    pub fn failed(&mut self, id: u32, #[wasm_bindgen(unchecked_param_type = "Failure")] failure: &JsValue) -> JsResult<()> {
        self.run.failed(id, read::<Failure>("failure", failure)?).map_err(thrown)
    }

    /// What was found since the last call, and how far the stages are.
    #[wasm_bindgen(unchecked_return_type = "News[]")]
    pub fn news(&mut self) -> JsValue {
        pack(&self.run.news())
    }

    /// What the run has found; frees it.
    pub fn finish(self) -> JsResult<FinishedBlock> {
        self.run.finish().map(FinishedBlock::of).map_err(thrown)
    }
}

/// Does the task of a job: the same bytes give the same bytes, on every machine.
#[wasm_bindgen]
pub fn execute_job(task: &Text, #[wasm_bindgen(unchecked_param_type = "readonly Uint8Array[]")] inputs: &Array) -> JsResult<Vec<u8>> {
    let unreadable = |json_fault| thrown(Error::InvalidJson { document: Document::Task, json_fault });
    let task: Task = json::from_text(&task.read("task")?).map_err(unreadable)?;
    if !Array::is_array(inputs) {
        return Err(wrong("inputs", kind_of(inputs), "an array of Uint8Array"));
    }
    let inputs = inputs.iter().map(|bytes| bytes.unchecked_ref::<Bytes>().read("inputs")).collect::<JsResult<Vec<_>>>()?;
    execute(&task, &inputs.iter().map(Vec::as_slice).collect::<Vec<_>>()).map_err(thrown)
}

/// Refuses a file of cameras that cannot be read, or fits no image of these names, where there are any.
#[wasm_bindgen]
pub fn check_cameras(text: &Text, names: &TextList) -> JsResult<()> {
    let (text, names) = (text.read("text")?, names.read("names")?);
    let rules = CameraRules::read(Some(&text)).map_err(thrown)?;
    if names.is_empty() { Ok(()) } else { rules.unused(&names).map(|_| ()).map_err(thrown) }
}

/// Refuses ground control points and image measurements that a run of these images would refuse, as far as their names say. `on_orthophoto`:
/// whether one places the block afterwards.
#[wasm_bindgen]
pub fn check_control(
    points: &Text,
    marks: &Text,
    names: &TextList,
    #[wasm_bindgen(unchecked_optional_param_type = "Given<GeoreferencingOptions>")] placing: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "boolean")] on_orthophoto: Option<bool>,
) -> JsResult<()> {
    let (points, marks, names) = (points.read("points")?, marks.read("marks")?, names.read("names")?);
    let placing: GeoreferencingOptions = read_options("placing", placing)?;
    ControlTables::read(&points, &marks).and_then(|tables| tables.check(&names, &placing, on_orthophoto.unwrap_or(false))).map_err(thrown)
}

/// The GNSS position that a table gives to each image, by their names; null where it gives none. Refuses a table that a run of these images would refuse.
/// Heights in a coordinate reference system whose geoid is a file count from its zero here.
#[wasm_bindgen(unchecked_return_type = "(GivenPosition | null)[]")]
pub fn positions_of_images(
    text: &Text,
    names: &TextList,
    #[wasm_bindgen(unchecked_optional_param_type = "Given<GeoreferencingOptions>")] placing: &JsValue,
) -> JsResult<JsValue> {
    let (text, names) = (text.read("text")?, names.read("names")?);
    let placing: GeoreferencingOptions = read_options("placing", placing)?;
    let given = PositionTable::read(&text).and_then(|table| table.positions(&names, &placing));
    given.map(|given| pack(&given)).map_err(thrown)
}

/// What is to be said of a table of GNSS positions beside images of these names: columns that are not understood, rows of other images.
#[wasm_bindgen(unchecked_return_type = "Remark[]")]
pub fn remarks_of_positions(text: &Text, names: &TextList) -> JsResult<JsValue> {
    let (text, names) = (text.read("text")?, names.read("names")?);
    PositionTable::read(&text).map(|table| pack(&table.remarks(&names))).map_err(thrown)
}

/// Refuses the file of a geoid beside its height, and one without a coordinate system whose heights count from it.
#[wasm_bindgen]
pub fn check_geoid(
    name: &Text,
    #[wasm_bindgen(unchecked_optional_param_type = "Given<GeoreferencingOptions>")] placing: &JsValue,
) -> JsResult<()> {
    read_options::<GeoreferencingOptions>("placing", placing)?.check_geoid(Some(&name.read("name")?)).map_err(thrown)
}

/// The index of the mask of each image, by their names; -1 for an image without one. Refuses two masks of one image.
#[wasm_bindgen]
pub fn masks_of_images(names: &TextList, masks: &TextList) -> JsResult<Vec<i32>> {
    let (of, _) = masks_of(&names.read("names")?, &masks.read("masks")?).map_err(thrown)?;
    Ok(of.into_iter().map(|mask| mask.map_or(-1, |index| index as i32)).collect())
}
