use super::convert::{JsResult, object, pack, thrown};
use crate::{BlockRun, write_project};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;
#[wasm_bindgen]
pub struct FinishedBlock {
    run: BlockRun,
}
impl FinishedBlock {
    pub(super) fn of(run: BlockRun) -> Self {
        Self { run }
    }
}
#[wasm_bindgen]
impl FinishedBlock {
    pub fn project(&self) -> JsResult<String> {
        write_project(&self.run.project()).map_err(thrown)
    }
    #[wasm_bindgen(unchecked_return_type = "any")]
    pub fn overview(&self) -> JsValue {
        object([("pairs", pack(&self.run.connections)), ("geometries", pack(&self.run.geometries))])
    }
}
