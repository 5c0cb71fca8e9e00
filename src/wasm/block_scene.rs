//! Simulated photos of a block, one at a time, and the score of what is made of them.

use super::about::pack_parameters;
use super::convert::{JsResult, Number, Numbers, numbers, object, pack, read, read_options, rows, thrown, whole};
use crate::{BlockFlight, BlockModel, BlockPreset, BlockScene as Scene, score_block as score_by_truth};
use js_sys::Uint8Array;
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

/// The scene below a simulated block in wasm memory. Call `free` when it is no longer needed.
#[wasm_bindgen]
pub struct BlockScene {
    scene: Scene,
}

#[wasm_bindgen]
impl BlockScene {
    /// Builds the scene of a flight; parameters that are absent take their defaults.
    #[wasm_bindgen(constructor)]
    pub fn new(#[wasm_bindgen(unchecked_param_type = "Given<BlockFlight>")] flight: &JsValue) -> JsResult<BlockScene> {
        let scene = Scene::new(&read_options::<BlockFlight>("flight", flight)?).map_err(thrown)?;
        Ok(Self { scene })
    }

    /// How many photos the flight takes.
    #[wasm_bindgen(getter)]
    pub fn photos(&self) -> usize {
        self.scene.photos()
    }

    /// Takes a photo.
    #[wasm_bindgen(unchecked_return_type = "SampleImage")]
    pub fn photo(&self, index: &Number) -> JsResult<JsValue> {
        let photo = self.scene.photo(whole("index of the photo", index)?).map_err(thrown)?;
        Ok(object([
            ("width", (photo.width() as f64).into()),
            ("height", (photo.height() as f64).into()),
            ("grey", Uint8Array::from(photo.data()).into()),
        ]))
    }

    /// Takes a photo as a PNG file, with its camera and recorded position as EXIF.
    pub fn photo_file(&self, index: &Number) -> JsResult<Vec<u8>> {
        self.scene.photo_file(whole("index of the photo", index)?).map_err(thrown)
    }

    /// The orthophoto of all that the photos show and the heights of its surface, as GeoTIFF files; `gsd_m` is the side of a pixel.
    #[wasm_bindgen(unchecked_return_type = "{ picture: Uint8Array; heights: Uint8Array }")]
    pub fn orthophoto(&self, gsd_m: &Number) -> JsResult<JsValue> {
        let [picture, heights] = self.scene.orthophoto(gsd_m.read("gsd_m")?).and_then(|orthophoto| orthophoto.files()).map_err(thrown)?;
        let bytes = |file: Vec<u8>| Uint8Array::from(file.as_slice()).into();
        Ok(object([("picture", bytes(picture)), ("heights", bytes(heights))]))
    }

    /// The true cameras and exterior orientations.
    #[wasm_bindgen(unchecked_return_type = "BlockModel")]
    pub fn truth(&self) -> JsValue {
        pack(&self.scene.truth())
    }

    /// Places x, y, z in m on the first surface that a photo sees at positions x, y in px (stride 2); stride 3.
    pub fn surface_at(&self, index: &Number, positions: &Numbers) -> JsResult<js_sys::Float64Array> {
        let (index, positions) = (whole("index of the photo", index)?, positions.read("positions")?);
        let places = self.scene.surface_at(index, rows::<2>("positions", &positions)?).map_err(thrown)?;
        Ok(numbers(places.into_iter().flatten()).into())
    }
}

/// Scores an oriented block by the truth of its photos, which have the same names.
#[wasm_bindgen(unchecked_return_type = "BlockScore")]
pub fn score_block(
    #[wasm_bindgen(unchecked_param_type = "BlockModel")] model: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "BlockModel")] truth: &JsValue,
) -> JsResult<JsValue> {
    let (model, truth): (BlockModel, BlockModel) = (read("block", model)?, read("truth", truth)?);
    score_by_truth(&model, &truth).map(|score| pack(&score)).map_err(thrown)
}

/// Every parameter of a block's flight on which photos depend.
#[wasm_bindgen(unchecked_return_type = "Parameter[]")]
pub fn block_flight_parameters() -> JsValue {
    pack_parameters(BlockFlight::photo_parameters().map(|parameter| (parameter.field().into(), *parameter)))
}

/// A ready-made flight of a block.
#[wasm_bindgen(unchecked_return_type = "BlockFlight")]
pub fn block_flight_preset(#[wasm_bindgen(unchecked_param_type = "BlockPreset")] name: &JsValue) -> JsResult<JsValue> {
    Ok(pack(&read::<BlockPreset>("preset", name)?.flight()))
}
