//! The images of a block placed on an orthophoto.

use super::convert::{Bytes, JsResult, Number, pack, thrown, whole};
use super::finished::FinishedBlock;
use super::orthophoto::OrthophotoReference;
use crate::{BlockLinks, DecodeLimits, decode};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

/// The images of an oriented block while they are placed on an orthophoto, one after the other, in wasm memory. Call `free` when it is no longer
/// needed.
#[wasm_bindgen]
#[derive(Default)]
pub struct BlockOnOrthophoto {
    links: BlockLinks,
}

#[wasm_bindgen]
impl BlockOnOrthophoto {
    /// None is placed yet.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self::default()
    }

    /// Places an image of the block, by its index, with the camera that the block has adjusted; null for one that is not oriented.
    #[wasm_bindgen(unchecked_return_type = "PlacingVerdict | null")]
    pub fn place(&mut self, block: &FinishedBlock, index: &Number, file: &Bytes, reference: &mut OrthophotoReference) -> JsResult<JsValue> {
        let index = whole("index of the image", index)?;
        let image = decode(&file.read("file of the image")?, &DecodeLimits::default()).map_err(thrown)?.grey;
        let area = reference.taken_area()?;
        let placed = self.links.place(block.run(), index, image.view(), &reference.orthophoto, &area, &reference.options);
        reference.area = Some(area);
        placed.map(|placed| pack(&placed.map(|placed| &placed.verdict))).map_err(thrown)
    }

    /// The block in the system of the orthophoto, adjusted by places of its ground; what came of it stands in the summary. Where it could not be
    /// linked it is as it was.
    pub fn linked(&self, block: &FinishedBlock, reference: &OrthophotoReference) -> JsResult<FinishedBlock> {
        self.links.linked(block.run(), &reference.orthophoto, &reference.options).map(FinishedBlock::of).map_err(thrown)
    }
}
