//! Images placed on an orthophoto.

use super::convert::{JsResult, object, pack, read, read_options, thrown};
use crate::{
    CameraRules, DecodeLimits, Error, ExifImage, FileFault, HeightModel, Heights, Mosaic, Orthophoto, PlacedImage, Placement,
    PlacingCamera, PlacingOptions, Project, SearchArea, decode, heights_of_points, links_table, place_image, placed_table, read_project,
    rectify_placed, write_geotiff,
};
use js_sys::Uint8Array;
use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::{JsCast, JsValue};

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** An orthophoto that was read: `gsd` is the side of a pixel, `heights` the lowest and the highest of its ground. */
export interface OrthophotoInfo {
    width: number;
    height: number;
    gsd: number;
    georeference: Georeference;
    epsg: number | null;
    heights: [number, number];
}
"#;

/// An orthophoto with the heights of its ground in wasm memory, on which images are placed. Call `free` when it is no longer needed.
#[wasm_bindgen]
pub struct OrthophotoReference {
    orthophoto: Orthophoto,
    options: PlacingOptions,
    area: Option<SearchArea>,
}

#[wasm_bindgen]
impl OrthophotoReference {
    /// Reads a GeoTIFF, or an image with its world file. Its ground is level at 0 until heights are given.
    pub fn open(file: &[u8], world_file: Option<String>) -> JsResult<OrthophotoReference> {
        let level = Heights::Level(0.0);
        let orthophoto = Orthophoto::read(file, world_file.as_deref(), level, &DecodeLimits::default()).map_err(thrown)?;
        Ok(Self { orthophoto, options: PlacingOptions::default(), area: None })
    }

    /// The heights of its ground: one for all, or a file, a GeoTIFF or an ESRI ASCII grid, with its world file perhaps.
    pub fn set_heights(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "number | Uint8Array")] heights: &JsValue,
        world_file: Option<String>,
    ) -> JsResult<()> {
        self.orthophoto.heights = read_heights(heights, world_file.as_deref())?;
        self.area = None;
        Ok(())
    }

    /// How images are placed; those that are absent take their defaults. Finds the points of the orthophoto among which images are sought, and
    /// gives how many they are.
    pub fn search(&mut self, #[wasm_bindgen(unchecked_param_type = "Given<PlacingOptions>")] options: &JsValue) -> JsResult<usize> {
        self.options = read_options::<PlacingOptions>("placing", options)?;
        let area = SearchArea::new(&self.orthophoto, &self.options).map_err(thrown)?;
        Ok(self.area.insert(area).points())
    }

    /// Size, place and heights.
    #[wasm_bindgen(unchecked_return_type = "OrthophotoInfo")]
    pub fn info(&self) -> JsValue {
        let Orthophoto { grey, georeference, heights, epsg, .. } = &self.orthophoto;
        object([
            ("width", (grey.width() as f64).into()),
            ("height", (grey.height() as f64).into()),
            ("gsd", georeference.gsd().into()),
            ("georeference", pack(georeference)),
            ("epsg", pack(epsg)),
            ("heights", pack(&heights.range())),
        ])
    }

    /// Places an image. Its camera is that of `cameras`, the text of a file of cameras as blocks take it, whose pattern its name fits, or that
    /// of its EXIF and XMP, or a usual one.
    #[wasm_bindgen(unchecked_return_type = "PlacedImage")]
    pub fn place(&mut self, name: &str, file: &[u8], cameras: Option<String>) -> JsResult<JsValue> {
        let rules = CameraRules::read(cameras.as_deref()).map_err(thrown)?;
        let image = decode(file, &DecodeLimits::default()).map_err(thrown)?.grey;
        let exif = ExifImage::read(file, image.width() as u64, image.height() as u64);
        let camera = PlacingCamera::of(&rules, name, [image.width() as u32, image.height() as u32], &exif);
        let area = match self.area.take() {
            Some(area) => area,
            None => SearchArea::new(&self.orthophoto, &self.options).map_err(thrown)?,
        };
        let placed = place_image(image.view(), &camera, &self.orthophoto, &area, &self.options);
        self.area = Some(area);
        placed.map(|placed| pack(&placed)).map_err(thrown)
    }

    /// A placed image resampled to the ground, grey, as GeoTIFF.
    pub fn rectified(&self, file: &[u8], #[wasm_bindgen(unchecked_param_type = "Placement")] placement: &JsValue) -> JsResult<Vec<u8>> {
        let placement: Placement = read("placement", placement)?;
        let image = decode(file, &DecodeLimits::default()).map_err(thrown)?.grey;
        let rectified = rectify_placed(image.view(), &placement, &self.orthophoto).map_err(thrown)?;
        write_geotiff(&rectified, self.orthophoto.epsg).map_err(thrown)
    }
}

/// One height for all, or a file.
fn read_heights(heights: &JsValue, world_file: Option<&str>) -> JsResult<Heights> {
    match heights.dyn_ref::<Uint8Array>() {
        Some(file) => HeightModel::read(&file.to_vec(), world_file).map(Heights::Model).map_err(thrown),
        None => read("heights", heights).map(Heights::Level),
    }
}

/// The tables of images that were placed: of the images, and of their links.
#[wasm_bindgen(unchecked_return_type = "{ placed: string; links: string }")]
pub fn placed_tables(
    names: Vec<String>,
    #[wasm_bindgen(unchecked_param_type = "readonly PlacedImage[]")] placed: &JsValue,
) -> JsResult<JsValue> {
    let placed: Vec<PlacedImage> = read("placed images", placed)?;
    let named: Vec<(String, PlacedImage)> = names.into_iter().zip(placed).collect();
    Ok(object([("placed", placed_table(&named).into()), ("links", links_table(&named).into())]))
}

/// Every option of placing images.
#[wasm_bindgen(unchecked_return_type = "Parameter[]")]
pub fn placing_parameters() -> JsValue {
    pack(&PlacingOptions::PARAMETERS)
}

/// Their defaults.
#[wasm_bindgen(unchecked_return_type = "PlacingOptions")]
pub fn placing_defaults() -> JsValue {
    pack(&PlacingOptions::default())
}

/// A quick orthomosaic of an oriented block in wasm memory: each place is taken from the image whose projection centre is nearest in plan. Call
/// `free` when it is no longer needed.
#[wasm_bindgen]
pub struct OrthoMosaic {
    mosaic: Mosaic,
    names: Vec<String>,
}

#[wasm_bindgen]
impl OrthoMosaic {
    /// Lays it out for the block of a project file. `heights`: one height for all or a file; null: those of the tie points. `gsd`: the side of a
    /// pixel; absent: that of the images.
    pub fn open(
        project: &[u8],
        #[wasm_bindgen(unchecked_param_type = "number | Uint8Array | null")] heights: &JsValue,
        heights_world_file: Option<String>,
        gsd: Option<f64>,
    ) -> JsResult<OrthoMosaic> {
        let Project::Block(run) = read_project(project).map_err(thrown)? else {
            return Err(thrown(Error::UnreadableFile { what: "project", place: String::new(), file_fault: FileFault::HoldsPair }));
        };
        let model = &run.model;
        let heights = match heights.is_null() {
            true => Heights::Model(heights_of_points(model).map_err(thrown)?),
            false => read_heights(heights, heights_world_file.as_deref())?,
        };
        let mosaic = Mosaic::new(model, heights, gsd).map_err(thrown)?;
        Ok(Self { mosaic, names: model.images.iter().map(|image| image.name.clone()).collect() })
    }

    /// The names of the block's images.
    #[wasm_bindgen(getter)]
    pub fn names(&self) -> Vec<String> {
        self.names.clone()
    }

    /// Adds an image, by its index; one that is not oriented adds nothing.
    pub fn add(&mut self, index: usize, file: &[u8]) -> JsResult<()> {
        let image = decode(file, &DecodeLimits::default()).map_err(thrown)?.grey;
        self.mosaic.add(index, image.view()).map_err(thrown)
    }

    /// The mosaic, grey, as GeoTIFF.
    pub fn finish(self) -> JsResult<Vec<u8>> {
        self.mosaic.finish().and_then(|mosaic| write_geotiff(&mosaic, None)).map_err(thrown)
    }
}
