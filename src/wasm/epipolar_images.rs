//! Epipolar images of a project.

use super::convert::{Bytes, JsResult, ProjectFile, TextList, object, pack, thrown};
use super::photo::Photo;
use crate::{
    Bands, DecodeLimits, EpipolarGeometry, EpipolarImages, Error, StereoPair, decode_bands, read_project, write_anaglyph, write_bands,
};
use js_sys::Uint8Array;
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** Epipolar images as PNG files, of one size, and how they lie. */
export interface EpipolarFiles {
    left: Uint8Array;
    right: Uint8Array;
    /** Both in one, for red-cyan glasses. */
    anaglyph: Uint8Array;
    /** JSON: an `EpipolarGeometry` with the names of the images. */
    parameters: string;
}
"#;

/// Two oriented images of a project, to be resampled so that what both show lies in the same row of either. Call `free` when it is no longer
/// needed.
#[wasm_bindgen]
pub struct EpipolarPair {
    pair: StereoPair,
    geometry: EpipolarGeometry,
}

#[wasm_bindgen]
impl EpipolarPair {
    /// Of a project file. `names`: the left and the right image; absent: those of a pair, or the two of a block that have most points in common, in
    /// that order in which the base goes to the right.
    pub fn open(project: &ProjectFile, names: Option<TextList>) -> JsResult<EpipolarPair> {
        let names = names.map(|names| names.read("names")).transpose()?;
        let names = names.map(<[String; 2]>::try_from).transpose().map_err(|names| {
            let got = format!("{} names", names.len());
            thrown(Error::InvalidArgument { what: "images of epipolar images", got, wanted: "two names".into() })
        })?;
        let project = read_project(&project.read("file of the project")?).map_err(thrown)?;
        let pair = StereoPair::of_project(&project, names.as_ref()).map_err(thrown)?;
        let geometry = EpipolarGeometry::new(pair.views.each_ref(), &pair.points_px).map_err(thrown)?;
        Ok(Self { pair, geometry })
    }

    /// The names of the left and the right image.
    #[wasm_bindgen(getter)]
    pub fn names(&self) -> Vec<String> {
        self.pair.views.iter().map(|view| view.name.clone()).collect()
    }

    /// SHA-256 of the files of the left and the right image in hexadecimal digits; null for photos that were simulated.
    #[wasm_bindgen(getter, unchecked_return_type = "(string | null)[]")]
    pub fn contents(&self) -> JsValue {
        pack(&self.pair.contents)
    }

    /// Whether the left image stands second in the project.
    #[wasm_bindgen(getter)]
    pub fn is_swapped(&self) -> bool {
        self.pair.is_swapped
    }

    /// How the epipolar images lie.
    #[wasm_bindgen(getter, unchecked_return_type = "EpipolarGeometry")]
    pub fn geometry(&self) -> JsValue {
        pack(&self.geometry)
    }

    /// Resamples the grey values of both images, which are given in the order of `names`.
    #[wasm_bindgen(unchecked_return_type = "EpipolarFiles")]
    pub fn resample(&self, left: &Photo, right: &Photo) -> JsResult<JsValue> {
        self.files([left, right].map(Photo::bands))
    }

    /// Resamples both images in the colours of their files, which are given in the order of `names`.
    #[wasm_bindgen(unchecked_return_type = "EpipolarFiles")]
    pub fn resample_files(&self, left: &Bytes, right: &Bytes) -> JsResult<JsValue> {
        let decoded = |file: &Bytes| decode_bands(&file.read("file of the image")?, &DecodeLimits::default()).map_err(thrown);
        self.files([decoded(left)?, decoded(right)?])
    }
}

impl EpipolarPair {
    fn files(&self, [left, right]: [Bands; 2]) -> JsResult<JsValue> {
        let images = EpipolarImages::new(&self.geometry, &self.pair, [&left, &right]).map_err(thrown)?;
        let file = |bytes: Vec<u8>| JsValue::from(Uint8Array::from(bytes.as_slice()));
        Ok(object([
            ("left", file(write_bands(&images.left, None))),
            ("right", file(write_bands(&images.right, None))),
            ("anaglyph", file(write_anaglyph(&images))),
            ("parameters", self.geometry.file(&self.pair).into()),
        ]))
    }
}
