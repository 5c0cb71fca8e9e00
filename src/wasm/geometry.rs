//! Geometry of two views, and matching that it guides.

use super::convert::{Bytes, JsResult, Numbers, pack, read_options, rows, set, thrown};
use super::descriptors::pack_matches;
use crate::{Error, Guide, GuidedOptions, Located, TwoViewOptions, guided_matches as match_guided, two_view as relate};
use js_sys::{Reflect, Uint32Array};
use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::{JsCast, JsValue};

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** `TwoView` with its matches as a typed array. */
export type TwoViewResult = Omit<TwoView, "inliers"> & { inliers: Uint32Array };

/** Where a left point may be seen: a matrix of nine numbers by rows, of homogeneous positions in px. */
export type MatchGuide = { fundamental: Float64Array | number[] } | { homography: Float64Array | number[] };
"#;

/// The geometry of two images from matches x, y left, x, y right in px (stride 4), of which many may be wrong.
#[wasm_bindgen(unchecked_return_type = "TwoViewResult")]
pub fn two_view(points: &Numbers, #[wasm_bindgen(unchecked_param_type = "Given<TwoViewOptions>")] options: &JsValue) -> JsResult<JsValue> {
    let options: TwoViewOptions = read_options("geometry", options)?;
    let found = relate(rows::<4>("matches", &points.read("matches")?)?, &options).map_err(thrown)?;
    let inliers: Vec<u32> = found.inliers.iter().map(|k| *k as u32).collect();
    let packed = pack(&found);
    set(&packed, "inliers", &Uint32Array::from(&inliers[..]).unchecked_into());
    Ok(packed)
}

/// Matches byte descriptors near the epipolar line, or the place, of each left point: positions x, y in px (stride 2), 128 bytes each.
#[wasm_bindgen(unchecked_return_type = "DescriptorMatches")]
pub fn match_guided_descriptors(
    left_positions: &Numbers,
    left_descriptors: &Bytes,
    right_positions: &Numbers,
    right_descriptors: &Bytes,
    #[wasm_bindgen(unchecked_param_type = "MatchGuide")] guide: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Given<GuidedOptions>")] options: &JsValue,
) -> JsResult<JsValue> {
    let (guide, options) = (read_guide(guide)?, read_options::<GuidedOptions>("guided", options)?);
    let (left_bytes, right_bytes) = (left_descriptors.read("left descriptors")?, right_descriptors.read("right descriptors")?);
    let (left_positions, right_positions) = (left_positions.read("left positions")?, right_positions.read("right positions")?);
    let left = Located { positions: rows::<2>("left positions", &left_positions)?, descriptors: &left_bytes };
    let right = Located { positions: rows::<2>("right positions", &right_positions)?, descriptors: &right_bytes };
    match_guided(left, right, &guide, &options).map(|matches| pack_matches(&matches)).map_err(thrown)
}

fn read_guide(value: &JsValue) -> JsResult<Guide> {
    let field = |name: &str| Reflect::get(value, &name.into()).ok().filter(|found| !found.is_undefined() && !found.is_null());
    let matrix = |found: JsValue| {
        let entries: Vec<f64> = js_sys::Array::from(&found).iter().map(|v| v.as_f64().unwrap_or(f64::NAN)).collect();
        let allowed = || thrown(Error::InvalidArgument { what: "guide", got: format!("{} numbers", entries.len()), wanted: "nine".into() });
        let entries: [f64; 9] = entries.as_slice().try_into().map_err(|_| allowed())?;
        Ok(std::array::from_fn(|i| std::array::from_fn(|j| entries[3 * i + j])))
    };
    match (field("fundamental"), field("homography")) {
        (Some(found), None) => matrix(found).map(Guide::Lines),
        (None, Some(found)) => matrix(found).map(Guide::Places),
        _ => {
            let got = "neither or both of them".into();
            Err(thrown(Error::InvalidArgument { what: "guide", got, wanted: "fundamental or homography".into() }))
        }
    }
}
