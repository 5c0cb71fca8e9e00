//! Features of two images to verified matches.

use super::convert::{Bytes, JsResult, Numbers, read_options, rows, thrown};
use super::descriptors::pack_matches;
use super::matching::set_geometry;
use crate::{FeatureMatchOptions, Located, match_features as match_verified};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** Matches of features that agree with the geometry of their two images. */
export interface VerifiedMatches extends DescriptorMatches {
    /** What relates the views; null where there is nothing, and then there are no matches. */
    geometry: Omit<TwoView, "inliers"> | null;
    /** Why there is no geometry. */
    no_geometry: NoGeometry | null;
}
"#;

/// Matches the features of two images (positions x, y in px, stride 2; 128 bytes each) by nearest descriptors, verified by the geometry of
/// the two views and completed along its lines. Where `options.geometry` names cameras, positions are those of cameras without distortion.
#[wasm_bindgen(unchecked_return_type = "VerifiedMatches")]
pub fn match_features(
    left_positions: &Numbers,
    left_descriptors: &Bytes,
    right_positions: &Numbers,
    right_descriptors: &Bytes,
    #[wasm_bindgen(unchecked_param_type = "Given<FeatureMatchOptions>")] options: &JsValue,
) -> JsResult<JsValue> {
    let options: FeatureMatchOptions = read_options("feature matching", options)?;
    let (left_bytes, right_bytes) = (left_descriptors.read("left descriptors")?, right_descriptors.read("right descriptors")?);
    let (left_positions, right_positions) = (left_positions.read("left positions")?, right_positions.read("right positions")?);
    let left = Located { positions: rows::<2>("left positions", &left_positions)?, descriptors: &left_bytes };
    let right = Located { positions: rows::<2>("right positions", &right_positions)?, descriptors: &right_bytes };
    let found = match_verified(left, right, &options).map_err(thrown)?;
    let packed = pack_matches(&found.matches);
    set_geometry(&packed, Some(&found.geometry));
    Ok(packed)
}
