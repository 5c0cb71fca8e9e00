//! Positions on the earth, in a block's own system and in coordinate reference systems.

use super::convert::{JsResult, Numbers, Text, read, rows, thrown, wrong};
use crate::{Error, Geoid, HeightZero, coordinates_in_system, geographic_from_local, places_of_coordinates};
use js_sys::Float64Array;
use serde::Deserialize;
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** Where the heights of a coordinate reference system count from; above the ellipsoid of WGS 84 where both are absent. */
export interface CountedFrom {
    /** How high their zero is above the ellipsoid wherever the places are, in m. */
    geoid_m?: number | null;
    /** In place of it the part of a geoid about the places, as a block has it. */
    geoid?: Geoid | null;
}
"#;

#[derive(Deserialize, Default)]
#[serde(deny_unknown_fields)]
pub(super) struct CountedFrom {
    pub geoid_m: Option<f64>,
    pub geoid: Option<Geoid>,
}

impl CountedFrom {
    /// Refuses a geoid whose numbers are not those of a grid.
    pub fn zero(self) -> JsResult<HeightZero> {
        match self.geoid {
            Some(geoid) if !geoid.is_whole() => {
                Err(wrong("geoid", geoid.name, "a grid of two rows and two columns or more, of numbers with steps above 0"))
            }
            geoid => Ok(HeightZero::of(self.geoid_m, geoid)),
        }
    }
}

fn read_zero(heights: &JsValue) -> JsResult<HeightZero> {
    read::<Option<CountedFrom>>("heights", heights)?.unwrap_or_default().zero()
}

/// Coordinates in a system (an EPSG code, PROJ text or WKT) of longitudes, latitudes in degrees and heights in m (stride 3): x, east or longitude,
/// first; NaN outside the system, an error where the median of the places lies there.
#[wasm_bindgen]
pub fn system_coordinates(
    crs: &Text,
    geographic: &Numbers,
    #[wasm_bindgen(unchecked_optional_param_type = "CountedFrom | null")] heights: &JsValue,
) -> JsResult<Float64Array> {
    let geographic = geographic.read("geographic positions")?;
    flat(coordinates_in_system(&crs.read("crs")?, read_zero(heights)?, rows("geographic positions", &geographic)?))
}

/// The way back: longitudes, latitudes and heights of coordinates in a system (stride 3).
#[wasm_bindgen]
pub fn system_positions(
    crs: &Text,
    coordinates: &Numbers,
    #[wasm_bindgen(unchecked_optional_param_type = "CountedFrom | null")] heights: &JsValue,
) -> JsResult<Float64Array> {
    let coordinates = coordinates.read("coordinates")?;
    flat(places_of_coordinates(&crs.read("crs")?, read_zero(heights)?, rows("coordinates", &coordinates)?))
}

/// Longitudes, latitudes and heights (stride 3) of positions in m east, north and up of an origin, which is their first row: of the others alone.
#[wasm_bindgen]
pub fn geographic_positions(positions: &Numbers) -> JsResult<Float64Array> {
    let positions = positions.read("positions")?;
    let [origin, local @ ..] = rows::<3>("positions", &positions)? else { return Ok(Float64Array::new_with_length(0)) };
    Ok(Float64Array::from(&local.iter().flat_map(|position| geographic_from_local(*position, *origin)).collect::<Vec<f64>>()[..]))
}

fn flat(found: Result<Vec<Option<[f64; 3]>>, Error>) -> JsResult<Float64Array> {
    let found = found.map_err(thrown)?;
    Ok(Float64Array::from(&found.into_iter().flat_map(|position| position.unwrap_or([f64::NAN; 3])).collect::<Vec<f64>>()[..]))
}
