//! Images placed on an orthophoto.

use super::about::pack_groups;
use super::convert::{
    Bytes, JsResult, Number, Numbers, Text, TextList, object, options_inside, pack, read, read_options, thrown, whole, whole_from,
};
use super::crs::CountedFrom;
use super::file_in_parts::file_source;
use super::heights::{read_heights, read_sidecars};
use crate::{
    CameraRules, DecodeLimits, Error, ExifImage, ExifPosition, FilmInput, FilmScan, Geoid, GivenLink, GivenPosition, Heights, Orthophoto,
    PartlyGiven, PlacedImage, Placement, PlacingCamera, PlacingOptions, RecordedPosition, SCAN_LIMITS, SearchArea, control_by_hand, decode,
    decode_bands, ground_positions, image_positions, links_table, place_by_links, place_film, place_film_by_links, place_recorded,
    placed_table, rectify_placed, write_geotiff,
};
use serde::Deserialize;
use serde_json::Value;
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** An orthophoto that was read: `gsd` is the side of a pixel, `heights` the lowest and the highest of its ground. */
export interface OrthophotoInfo {
    width: number;
    height: number;
    gsd: number;
    georeference: Georeference;
    epsg: number | null;
    /** What its system is called where it has one without a code. */
    described: string | null;
    /** Whether it says a system that is known here, so that GNSS positions are led into it. */
    on_earth: boolean;
    heights: [number, number];
    /** What they count from, by the name of a vertical system, where their file says it. */
    heights_from: string | null;
    /** The unit in which their file says that they are, where they were converted from it. */
    heights_given_in: string | null;
    /** Share of the picture that has a height, 0 to 1. */
    heights_share: number;
    /** Whether its pixels are read where they are needed. */
    in_parts: boolean;
}

/** What an image is oriented by without matching. */
export interface ByLinks {
    links: readonly GivenLink[];
    /** Where it was placed, which says whether it is a scan of film; absent: by resection of the links. */
    placement?: Placement | null;
    /** The text of a file of cameras, as of `place`. */
    cameras?: string | null;
    /** As of `search`; absent: those that it had. */
    options?: Given<PlacingOptions> | null;
    /** Of a scan of film that was not placed, as of `place`. */
    film?: Given<FilmInput> | null;
    /** As of `place`. */
    position?: GivenPosition | null;
}

/** A place of the ground that becomes a ground control point of a block. */
export interface PlaceByHand extends CountedFrom {
    /** X and Y in the system of the orthophoto. */
    place: readonly [number, number];
    /** Its number among the places by hand, from 1, which names it. */
    number: number;
    /** The coordinate reference system that the block has; absent: its control points are in the system of the orthophoto. */
    crs?: string | null;
    /** As of `search`; absent: those that it had. */
    options?: Given<PlacingOptions> | null;
}
"#;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ByLinks {
    links: Vec<GivenLink>,
    placement: Option<Placement>,
    cameras: Option<String>,
    options: Option<Value>,
    film: Option<Value>,
    position: Option<GivenPosition>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct PlaceByHand {
    place: [f64; 2],
    number: usize,
    crs: Option<String>,
    geoid_m: Option<f64>,
    geoid: Option<Geoid>,
    options: Option<Value>,
}

/// An orthophoto with the heights of its ground in wasm memory, on which images are placed. Call `free` when it is no longer needed.
#[wasm_bindgen]
pub struct OrthophotoReference {
    pub(super) orthophoto: Orthophoto,
    pub(super) options: PlacingOptions,
    pub(super) area: Option<SearchArea>,
}

impl OrthophotoReference {
    /// The points among which images are sought, found where they are not yet; to be put back.
    pub(super) fn taken_area(&mut self) -> JsResult<SearchArea> {
        match self.area.take() {
            Some(area) => Ok(area),
            None => SearchArea::new(&self.orthophoto, &self.options).map_err(thrown),
        }
    }
}

#[wasm_bindgen]
impl OrthophotoReference {
    /// Opens a GeoTIFF, or an image with its world file: all of its bytes, or a file from which large ones are read in parts. Its ground is level at 0 until
    /// heights are given.
    pub fn open(
        #[wasm_bindgen(unchecked_param_type = "Uint8Array | FileInParts")] file: &JsValue,
        #[wasm_bindgen(unchecked_optional_param_type = "Given<Sidecars>")] sidecars: &JsValue,
    ) -> JsResult<OrthophotoReference> {
        let (level, sidecars) = (Heights::Level(0.0), read_sidecars(sidecars)?);
        let orthophoto = Orthophoto::open(file_source(file)?, sidecars, level, &DecodeLimits::default()).map_err(thrown)?;
        Ok(Self { orthophoto, options: PlacingOptions::default(), area: None })
    }

    /// The heights of its ground: one for all, or a file: a GeoTIFF or an ESRI ASCII grid, with what stands beside it, or the project of an oriented block.
    pub fn set_heights(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "number | Uint8Array | FileInParts")] heights: &JsValue,
        #[wasm_bindgen(unchecked_optional_param_type = "Given<Sidecars>")] sidecars: &JsValue,
    ) -> JsResult<()> {
        self.orthophoto.set_heights(read_heights(heights, sidecars)?).map_err(thrown)?;
        self.area = None;
        Ok(())
    }

    /// How images are placed; those that are absent take their defaults. Finds the points of the orthophoto among which images are sought, and
    /// gives how many they are. Where they are refused the former ones hold.
    pub fn search(&mut self, #[wasm_bindgen(unchecked_param_type = "Given<PlacingOptions>")] options: &JsValue) -> JsResult<usize> {
        let options = read_options::<PlacingOptions>("placing", options)?;
        let area = SearchArea::new(&self.orthophoto, &options).map_err(thrown)?;
        self.options = options;
        Ok(self.area.insert(area).points())
    }

    /// Size, place and heights.
    #[wasm_bindgen(unchecked_return_type = "OrthophotoInfo")]
    pub fn info(&self) -> JsValue {
        let Orthophoto { georeference, heights, epsg, .. } = &self.orthophoto;
        let [width, height] = self.orthophoto.size();
        object([
            ("width", (width as f64).into()),
            ("height", (height as f64).into()),
            ("gsd", georeference.gsd().into()),
            ("georeference", pack(georeference)),
            ("epsg", pack(epsg)),
            ("described", pack(&self.orthophoto.described())),
            ("on_earth", self.orthophoto.is_on_earth().into()),
            ("heights", pack(&heights.range())),
            ("heights_from", pack(&heights.counts_from())),
            ("heights_given_in", pack(&heights.given_in())),
            ("heights_share", self.orthophoto.heights_share().into()),
            ("in_parts", self.orthophoto.is_in_parts().into()),
        ])
    }

    /// Places an image. Its camera is that of `cameras`, the text of a file of cameras as blocks take it, whose pattern its name fits, or that
    /// of its EXIF and XMP, or a usual one. Where it records a GNSS position and the system of the orthophoto is known, it is sought there first, within
    /// `within_m`, then on all of the orthophoto. `film`: of the scan of a photo on film, its calibrated camera and the fiducial marks that were measured in it,
    /// in place of what is known otherwise. `position`: its GNSS position in a table (`positions_of_images`), in place of that which its file records.
    #[wasm_bindgen(unchecked_return_type = "PlacedImage")]
    pub fn place(
        &mut self,
        name: &Text,
        file: &Bytes,
        cameras: Option<Text>,
        #[wasm_bindgen(unchecked_optional_param_type = "Given<FilmInput> | null")] film: &JsValue,
        #[wasm_bindgen(unchecked_optional_param_type = "GivenPosition | null")] position: &JsValue,
    ) -> JsResult<JsValue> {
        let (name, cameras) = (name.read("name")?, cameras.map(|cameras| cameras.read("cameras")).transpose()?);
        let (file, film) = (&file.read("file of the image")?[..], read_film(film)?);
        let given: Option<GivenPosition> = if position.is_undefined() { None } else { read("position", position)? };
        let rules = CameraRules::read(cameras.as_deref()).map_err(thrown)?;
        let image = decode(file, &limits_of(film.is_some())).map_err(thrown)?.grey;
        let exif = ExifImage::read(file, image.width() as u64, image.height() as u64);
        let size = [image.width() as u32, image.height() as u32];
        let camera = PlacingCamera::of(&rules, &name, size, &exif);
        let area = self.taken_area()?;
        let position = RecordedPosition::of(given.as_ref(), &exif);
        let (grey, position) = (image.view(), position.as_ref());
        let placed = match &film {
            Some(film) => place_film(grey, film, position, &self.orthophoto, &area, &self.options),
            None => place_recorded(grey, &camera, position, &self.orthophoto, &area, &self.options)
                .map(|placed| placed.beside_file(&rules, &name, size, &exif)),
        };
        self.area = Some(area);
        placed.map(|placed| pack(&placed)).map_err(thrown)
    }

    /// What is to be said of images that record these GNSS positions (`image_position`) before they are placed: that none lies near
    /// the orthophoto, and what would bring it to them; null where one does, or where nothing says where both are. `options`: as of `search`; absent: those
    /// that it had.
    #[wasm_bindgen(unchecked_return_type = "Remark | null")]
    pub fn elsewhere(
        &self,
        #[wasm_bindgen(unchecked_param_type = "readonly ExifPosition[]")] positions: &JsValue,
        #[wasm_bindgen(unchecked_optional_param_type = "Given<PlacingOptions>")] options: &JsValue,
    ) -> JsResult<JsValue> {
        let options = if options.is_undefined() { self.options.clone() } else { read_options::<PlacingOptions>("placing", options)? };
        let positions: Vec<ExifPosition> = read("positions", positions)?;
        Ok(pack(&self.orthophoto.elsewhere(&positions, &options)))
    }

    /// Grey values of a part of the picture that was halved so many times: `width` times `height` of them from a column and row of the halved
    /// picture on, 0 where it shows nothing.
    pub fn picture(&self, column: &Number, row: &Number, width: &Number, height: &Number, halvings: &Number) -> JsResult<Vec<u8>> {
        let (from, size, halvings) = part_of([column, row, width, height, halvings])?;
        self.orthophoto.shown(from, size, halvings).map_err(thrown)
    }

    /// The same in colours: red, green, blue and alpha of each pixel, alpha 0 where it shows nothing.
    pub fn colours(&self, column: &Number, row: &Number, width: &Number, height: &Number, halvings: &Number) -> JsResult<Vec<u8>> {
        let (from, size, halvings) = part_of([column, row, width, height, halvings])?;
        self.orthophoto.colours(from, size, halvings).map_err(thrown)
    }

    /// Orients an image by links that are given, in their order; nothing is matched.
    #[wasm_bindgen(unchecked_return_type = "PlacedImage")]
    pub fn adjust(
        &self,
        name: &Text,
        file: &Bytes,
        #[wasm_bindgen(unchecked_param_type = "ByLinks")] given: &JsValue,
    ) -> JsResult<JsValue> {
        let (name, file) = (name.read("name")?, &file.read("file of the image")?[..]);
        let ByLinks { links, placement, cameras, options, film, position } = read("links", given)?;
        let film: Option<FilmInput> = options_inside("film", film)?;
        let options = options_inside("placing", options)?.unwrap_or_else(|| self.options.clone());
        let rules = CameraRules::read(cameras.as_deref()).map_err(thrown)?;
        let size = match &placement {
            Some(placement) => [placement.camera.width_px, placement.camera.height_px],
            None => {
                let image = decode(file, &limits_of(film.is_some())).map_err(thrown)?.grey;
                [image.width() as u32, image.height() as u32]
            }
        };
        let scan = match &placement {
            Some(placement) => placement.film.clone(),
            None => film.map(|film| FilmScan::new(&film, size.map(|side| side as usize))).transpose().map_err(thrown)?,
        };
        let exif = ExifImage::read(file, u64::from(size[0]), u64::from(size[1]));
        let position = RecordedPosition::of(position.as_ref(), &exif);
        let position = position.as_ref();
        if let Some(scan) = scan {
            let placed = place_film_by_links(&scan, position, &self.orthophoto, placement.as_ref(), &links, &options);
            return placed.map(|placed| pack(&placed)).map_err(thrown);
        }
        let camera = PlacingCamera::of(&rules, &name, size, &exif);
        place_by_links(&camera, position, &self.orthophoto, placement.as_ref(), &links, &options)
            .map(|placed| pack(&placed.beside_file(&rules, &name, size, &exif)))
            .map_err(thrown)
    }

    /// The edit that adds a place of the ground, measured by eye, as a ground control point to a block; edits after it measure it in images.
    #[wasm_bindgen(unchecked_return_type = "Extract<BlockEdit, { kind: 'add_control' }>")]
    pub fn control_by_hand(&self, #[wasm_bindgen(unchecked_param_type = "PlaceByHand")] given: &JsValue) -> JsResult<JsValue> {
        let PlaceByHand { place, number, crs, geoid_m, geoid, options } = read("place", given)?;
        let options = options_inside("placing", options)?.unwrap_or_else(|| self.options.clone());
        let zero = CountedFrom { geoid_m, geoid }.zero()?;
        control_by_hand(number, place, &self.orthophoto, crs.as_deref().map(|crs| (crs, zero)), &options)
            .map(|edit| pack(&edit))
            .map_err(thrown)
    }

    /// Where places X, Y of the ground, stride 2, are in a placed image: x and y in px, stride 2, no numbers where it does not show them.
    pub fn image_positions(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Placement")] placement: &JsValue,
        places: &Numbers,
    ) -> JsResult<Vec<f64>> {
        let placement: Placement = read("placement", placement)?;
        let positions = image_positions(&placement, &self.orthophoto.heights, pairs("places", &places.read("places")?)?);
        Ok(positions.into_iter().flat_map(|at| at.unwrap_or([f64::NAN; 2])).collect())
    }

    /// The ground X, Y, Z, stride 3, that positions of a placed image show, stride 2; no numbers where they show none.
    pub fn ground_positions(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Placement")] placement: &JsValue,
        positions: &Numbers,
    ) -> JsResult<Vec<f64>> {
        let placement: Placement = read("placement", placement)?;
        let ground = ground_positions(&placement, &self.orthophoto.heights, pairs("positions", &positions.read("positions")?)?);
        Ok(ground.into_iter().flat_map(|place| place.unwrap_or([f64::NAN; 3])).collect())
    }

    /// The heights of places X, Y, stride 2; no number where there is none.
    pub fn heights_at(&self, places: &Numbers) -> JsResult<Vec<f64>> {
        Ok(pairs("places", &places.read("places")?)?.iter().map(|place| self.orthophoto.heights.at(*place).unwrap_or(f64::NAN)).collect())
    }

    /// A placed image resampled to the ground, in its colours, as GeoTIFF.
    pub fn rectified(&self, file: &Bytes, #[wasm_bindgen(unchecked_param_type = "Placement")] placement: &JsValue) -> JsResult<Vec<u8>> {
        let placement: Placement = read("placement", placement)?;
        let image = decode_bands(&file.read("file of the image")?, &limits_of(placement.film.is_some())).map_err(thrown)?;
        let rectified = rectify_placed(&image, &placement, &self.orthophoto).map_err(thrown)?;
        write_geotiff(&rectified, self.orthophoto.epsg).map_err(thrown)
    }
}

/// A part of a picture that was halved: its first column and row, its width and height, and how often.
fn part_of([column, row, width, height, halvings]: [&Number; 5]) -> JsResult<([usize; 2], [usize; 2], u32)> {
    let from = [whole("column", column)?, whole("row", row)?];
    Ok((from, [whole("width", width)?, whole("height", height)?], whole_from("halvings", halvings, 0..=Orthophoto::MOST_HALVINGS)?))
}

/// What the file of an image may ask for: that of a scan of film is the same wherever it is read.
fn limits_of(is_film: bool) -> DecodeLimits {
    if is_film { SCAN_LIMITS } else { DecodeLimits::default() }
}

/// What is known of a scan of film; absent where it is undefined or null.
fn read_film(film: &JsValue) -> JsResult<Option<FilmInput>> {
    let is_given = !film.is_undefined() && !film.is_null();
    is_given.then(|| read_options("film", film)).transpose()
}

/// Numbers two by two.
fn pairs<'a>(what: &'static str, numbers: &'a [f64]) -> JsResult<&'a [[f64; 2]]> {
    match numbers.as_chunks::<2>() {
        (pairs, []) => Ok(pairs),
        _ => Err(thrown(Error::InvalidArgument { what, got: format!("{} numbers", numbers.len()), wanted: "two for each".into() })),
    }
}

/// The tables of images that were placed: of the images, and of their links.
#[wasm_bindgen(unchecked_return_type = "{ placed: string; links: string }")]
pub fn placed_tables(
    names: &TextList,
    #[wasm_bindgen(unchecked_param_type = "readonly PlacedImage[]")] placed: &JsValue,
) -> JsResult<JsValue> {
    let (names, placed): (_, Vec<PlacedImage>) = (names.read("names")?, read("placed images", placed)?);
    if names.len() != placed.len() {
        let got = format!("{} names for {} placed images", names.len(), placed.len());
        return Err(thrown(Error::InvalidArgument { what: "names", got, wanted: "one for each placed image".into() }));
    }
    let named: Vec<(String, PlacedImage)> = names.into_iter().zip(placed).collect();
    Ok(object([("placed", placed_table(&named).into()), ("links", links_table(&named).into())]))
}

/// The GNSS position that an image records; null where it records none. Of a file in parts no more than its EXIF is read: of a TIFF its directories, wherever
/// they lie, of other images what stands in their first 256 KiB.
#[wasm_bindgen(unchecked_return_type = "ExifPosition | null")]
pub fn image_position(#[wasm_bindgen(unchecked_param_type = "Uint8Array | FileInParts")] file: &JsValue) -> JsResult<JsValue> {
    Ok(pack(&ExifPosition::of_file(file_source(file)?)))
}

/// Every option of placing images.
#[wasm_bindgen(unchecked_return_type = "Parameter[]")]
pub fn placing_parameters() -> JsValue {
    pack_groups(PlacingOptions::GROUPS)
}

/// Their defaults.
#[wasm_bindgen(unchecked_return_type = "PlacingOptions")]
pub fn placing_defaults() -> JsValue {
    pack(&PlacingOptions::default())
}
