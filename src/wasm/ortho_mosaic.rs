//! The orthomosaic of a block, whose file is written as its images come.

use super::convert::{Bytes, JsResult, Number, ProjectFile, TextList, object, pack, thrown, whole, wrong_project};
use super::heights::read_heights;
use crate::{DecodeLimits, FileFault, Heights, Mosaic, Project, decode_bands, read_project, write_heights};
use js_sys::Uint8Array;
use std::io;
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

/// A quick orthomosaic of an oriented block in wasm memory: each place is taken from the image whose projection centre is nearest in plan. Its file, a
/// tiled GeoTIFF, is returned in parts: append what `add`, `leave_out` and `finish().end` return, then overwrite the first bytes with `finish().beginning`.
/// Call `free` when it is no longer needed.
#[wasm_bindgen]
pub struct OrthoMosaic {
    mosaic: Mosaic,
    names: Vec<String>,
    file: Outbox,
}

/// What was written to a file since that was taken last; what goes back to its beginning stands apart.
#[derive(Default)]
struct Outbox {
    appended: Vec<u8>,
    beginning: Option<Vec<u8>>,
}

impl io::Write for Outbox {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.beginning.as_mut().unwrap_or(&mut self.appended).extend_from_slice(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl io::Seek for Outbox {
    fn seek(&mut self, to: io::SeekFrom) -> io::Result<u64> {
        if to != io::SeekFrom::Start(0) {
            return Err(io::ErrorKind::Unsupported.into());
        }
        self.beginning = Some(Vec::new());
        Ok(0)
    }
}

#[wasm_bindgen]
impl OrthoMosaic {
    /// Lays it out for the block of a project file. `heights`: one height for all or a file; null: those of the tie points. `gsd`: the side of a
    /// pixel; absent: that of the images. In the coordinate reference system of the block, where it has one; `in_adjustment`: in the system of its
    /// adjustment, as the map of the page is. `images`: the names of those that it is made of; absent: all.
    pub fn open(
        project: &ProjectFile,
        #[wasm_bindgen(unchecked_param_type = "number | Uint8Array | FileInParts | null")] heights: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "Given<Sidecars> | null | undefined")] heights_sidecars: &JsValue,
        gsd: Option<Number>,
        in_adjustment: Option<bool>,
        images: Option<TextList>,
    ) -> JsResult<OrthoMosaic> {
        let Project::Block(run) = read_project(&project.read("file of the project")?).map_err(thrown)? else {
            return Err(thrown(wrong_project(FileFault::HoldsPair)));
        };
        let given = || read_heights(heights, heights_sidecars);
        let heights = (!heights.is_null()).then(given).transpose()?;
        let lay_out = if in_adjustment.unwrap_or(false) { Mosaic::in_adjustment } else { Mosaic::of_images };
        let images = images.map_or(Ok(Vec::new()), |images| images.read("images"))?;
        let mosaic = lay_out(&run, &images, heights, gsd.map(|gsd| gsd.read("gsd")).transpose()?).map_err(thrown)?;
        Ok(Self { mosaic, names: run.model.images.iter().map(|image| image.name.clone()).collect(), file: Outbox::default() })
    }

    /// What is to be said of the heights that were given, or of the system; null where there is nothing.
    #[wasm_bindgen(unchecked_return_type = "Remark | null")]
    pub fn remark(&self) -> JsValue {
        pack(&self.mosaic.remark())
    }

    /// The names of the block's images.
    #[wasm_bindgen(getter)]
    pub fn names(&self) -> Vec<String> {
        self.names.clone()
    }

    /// The indices of the oriented images that it is made of, in an order in which little waits in memory for images to come.
    pub fn order(&self) -> Vec<usize> {
        self.mosaic.order()
    }

    /// Width and height in px.
    pub fn size(&self) -> Vec<usize> {
        self.mosaic.size().to_vec()
    }

    /// Adds an image, by its index; one that is not oriented adds nothing. Gives what the file goes on with.
    pub fn add(&mut self, index: &Number, file: &Bytes) -> JsResult<Vec<u8>> {
        let image = decode_bands(&file.read("file of the image")?, &DecodeLimits::default()).map_err(thrown)?;
        self.mosaic.add(whole("index of the image", index)?, &image, &mut self.file).map_err(thrown)?;
        Ok(std::mem::take(&mut self.file.appended))
    }

    /// An image, by its index, that will not be added. Gives what the file goes on with.
    pub fn leave_out(&mut self, index: &Number) -> JsResult<Vec<u8>> {
        self.mosaic.leave_out(whole("index of the image", index)?, &mut self.file).map_err(thrown)?;
        Ok(std::mem::take(&mut self.file.appended))
    }

    /// The heights on which it lies, as GeoTIFF; absent where these are one for all.
    pub fn heights(&self) -> JsResult<Option<Vec<u8>>> {
        match self.mosaic.heights() {
            Heights::Model(model) => write_heights(model, self.mosaic.epsg()).map(Some).map_err(thrown),
            Heights::Level(_) => Ok(None),
        }
    }

    /// What the file ends with, and the bytes that it begins with in place of those that were given first.
    #[wasm_bindgen(unchecked_return_type = "{ end: Uint8Array; beginning: Uint8Array }")]
    pub fn finish(mut self) -> JsResult<JsValue> {
        self.mosaic.finish(&mut self.file).map_err(thrown)?;
        let bytes = |bytes: &[u8]| Uint8Array::from(bytes).into();
        let Outbox { appended, beginning } = &self.file;
        Ok(object([("end", bytes(appended)), ("beginning", bytes(beginning.as_deref().unwrap_or_default()))]))
    }
}
