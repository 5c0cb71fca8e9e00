//! Positions on the earth, in a block's own system and in coordinate reference systems.

use super::convert::{JsResult, Numbers, Text, rows, thrown};
use crate::{Error, coordinates_in_system, geographic_from_local, places_of_coordinates};
use js_sys::Float64Array;
use wasm_bindgen::prelude::wasm_bindgen;

/// Coordinates in a system (an EPSG code, PROJ text or WKT) of longitudes, latitudes in degrees and heights in m (stride 3): x, east or longitude,
/// first; NaN outside the system, an error where the median of the places lies there.
#[wasm_bindgen]
pub fn system_coordinates(crs: &Text, geographic: &Numbers) -> JsResult<Float64Array> {
    flat(coordinates_in_system(&crs.read("crs")?, rows("geographic positions", &geographic.read("geographic positions")?)?))
}

/// The way back: longitudes, latitudes and heights of coordinates in a system (stride 3).
#[wasm_bindgen]
pub fn system_positions(crs: &Text, coordinates: &Numbers) -> JsResult<Float64Array> {
    flat(places_of_coordinates(&crs.read("crs")?, rows("coordinates", &coordinates.read("coordinates")?)?))
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
