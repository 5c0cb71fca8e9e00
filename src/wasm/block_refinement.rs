//! The refinement of a block's rays: windows out of images, points matched by their windows.

use super::convert::{JsResult, numbers, object, pack, read_options, rows, thrown};
use super::photo::Photo;
use crate::{
    Error, ObservationWindows, PointRefiner, RefinementOptions, RefinementOutcome, WindowCentre, WindowedObservation, observation_windows,
};
use js_sys::{Float64Array, Uint8Array, Uint32Array};
use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::{JsCast, JsValue};

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** Windows of an image around rays. */
export interface ObservationWindowTable {
    /** Of each window px. */
    side: number;
    /** Of each window the index of its ray, halvings of the image, column and row of its first pixel there; stride 4. */
    places: Uint32Array;
    /** Grey values, side x side a window, row by row. */
    grey: Uint8Array;
}
"#;

#[wasm_bindgen]
impl Photo {
    /// Cuts windows around rays: x, y and scale in px; stride 3.
    #[wasm_bindgen(unchecked_return_type = "ObservationWindowTable")]
    pub fn observation_windows(
        &self,
        rays: &[f64],
        #[wasm_bindgen(unchecked_param_type = "Given<RefinementOptions>")] options: &JsValue,
    ) -> JsResult<JsValue> {
        let options: RefinementOptions = read_options("refinement", options)?;
        let places: Vec<WindowCentre> =
            rows::<3>("rays", rays)?.iter().map(|[x, y, scale_px]| WindowCentre { position: [*x, *y], scale_px: *scale_px }).collect();
        let cut = observation_windows(self.view(), &places, &options).map_err(thrown)?;
        Ok(object([
            ("side", (cut.side as f64).into()),
            ("places", Uint32Array::from(cut.places.as_flattened()).unchecked_into()),
            ("grey", Uint8Array::from(&cut.grey[..]).into()),
        ]))
    }
}

/// Refines the rays of points by their windows. The rays of point i are those from `starts[i]` to before `starts[i + 1]`, each with x, y and
/// scale in px and direction in rad (stride 4); `places` and `grey` as `observation_windows` gives them, their rays counted from 0 over all points.
///
/// Of each ray the place of its outcome among `refinement_outcomes`, x, y, the standard error in px and the correlation (NaN where it was not
/// refined); stride 5.
#[wasm_bindgen]
pub fn refine_points(
    starts: &[u32],
    rays: &[f64],
    places: &[u32],
    grey: Vec<u8>,
    #[wasm_bindgen(unchecked_param_type = "Given<RefinementOptions>")] options: &JsValue,
) -> JsResult<Float64Array> {
    let options: RefinementOptions = read_options("refinement", options)?;
    let given = rows::<4>("rays", rays)?;
    let (places, rest) = places.as_chunks::<4>();
    if !rest.is_empty() {
        return Err(thrown(Error::InvalidInput {
            what: "windows of rays",
            got: format!("{} left over", rest.len()),
            allowed: "four numbers each".into(),
        }));
    }
    let windows = ObservationWindows::new(places.to_vec(), grey, &options).map_err(thrown)?;
    let windowed = given.iter().enumerate().map(|(index, [x, y, scale_px, direction])| {
        let place = WindowCentre { position: [*x, *y], scale_px: *scale_px };
        Ok(WindowedObservation { place, orientation_rad: *direction, windows: windows.of_ray(index as u32)? })
    });
    let windowed: Vec<WindowedObservation<'_>> = windowed.collect::<Result<_, Error>>().map_err(thrown)?;
    let mut refiner = PointRefiner::new(&options).map_err(thrown)?;
    let mut refined = Vec::with_capacity(5 * given.len());
    for ends in starts.windows(2) {
        let Some(own) = windowed.get(ends[0] as usize..ends[1] as usize) else {
            let allowed = format!("ascending indices up to {}", given.len());
            return Err(thrown(Error::InvalidInput { what: "rays of a point", got: format!("{} to {}", ends[0], ends[1]), allowed }));
        };
        for ray in refiner.refine(own).map_err(thrown)?.rays {
            let code = RefinementOutcome::ALL.iter().position(|outcome| *outcome == ray.outcome).unwrap_or_default();
            let [x, y] = ray.position;
            refined.extend([code as f64, x, y, ray.standard_error_px.unwrap_or(f64::NAN), ray.correlation.unwrap_or(f64::NAN)]);
        }
    }
    Ok(numbers(refined).unchecked_into())
}

/// What can become of a ray that is refined, in the order of its codes.
#[wasm_bindgen(unchecked_return_type = "RefinementOutcome[]")]
pub fn refinement_outcomes() -> JsValue {
    pack(&RefinementOutcome::ALL)
}
