//! Interior and relative orientation.

use super::convert::{JsResult, Number, Numbers, numbers, object, pack, read, read_options, rows, set, thrown, whole};
use crate::{
    CameraMm, Error, ExifCamera, Fiducial, FiducialModel, Fit, Interior, KnownPhoto, Match, ModelPoint, NoOrientation, Observation,
    OneImage, OrientationOptions, PairCameras, PairInterior, PairVerdict, PhotoInput, PointStatistics, RelativeOrientation, TwoView,
    judged, judged_observations, model_points as points_of, observations as photo_observations, orient_fiducials as orient_marks,
    orient_matches as orient_by_matches, orient_relative as orient_pair, photo_interior,
};
use serde::{Deserialize, Serialize};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
export interface RelativeOrientation {
    /** Corrections of x and y in the left and in the right photo in mm, of every observation, the rejected ones included; stride 4. */
    residuals_mm: Float64Array;
    /**
     * For each observation: residual y-parallax in mm, redundancy number, standardised residual w, minimal detectable displacement of the
     * right point across its epipolar line in mm, external reliability, weight (0 where rejected), model X, Y, Z in mm; stride 9. NaN where absent.
     */
    points: Float64Array;
}
"#;

/// An image as interior orientation needs it: its size, and what is known of its fiducials.
#[derive(Serialize, Deserialize, tsify::Tsify)]
#[serde(deny_unknown_fields)]
pub struct PhotoGeometry {
    /// In px.
    pub width: usize,
    pub height: usize,
    #[serde(default)]
    pub fiducials: Vec<Fiducial>,
    #[serde(default)]
    pub model: FiducialModel,
    /// Place `[col, row]` of the image's top-left pixel in the scan whose fiducials were measured.
    #[serde(default)]
    pub origin: Option<[f64; 2]>,
}

/// Interior orientation by fiducial marks.
#[wasm_bindgen(unchecked_return_type = "FiducialOrientation")]
pub fn orient_fiducials(
    #[wasm_bindgen(unchecked_param_type = "Fiducial[]")] fiducials: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "FiducialModel")] model: &JsValue,
) -> JsResult<JsValue> {
    let (fiducials, model): (Vec<Fiducial>, FiducialModel) = (read("fiducials", fiducials)?, read("model", model)?);
    orient_marks(&fiducials, model).map(|o| pack(&o)).map_err(thrown)
}

/// The camera of an EXIF block, with what is not known of it.
#[wasm_bindgen(unchecked_return_type = "CameraMm")]
pub fn camera_of_exif(#[wasm_bindgen(unchecked_param_type = "ExifCamera")] exif: &JsValue) -> JsResult<JsValue> {
    CameraMm::from_exif(&read::<ExifCamera>("exif", exif)?).map(|camera| pack(&camera)).map_err(thrown)
}

/// What of a photo tells its camera, before its interior orientation.
#[derive(Serialize, Deserialize, tsify::Tsify)]
#[serde(deny_unknown_fields)]
pub struct PhotoFacts {
    /// Of its image.
    pub width_px: usize,
    pub height_px: usize,
    pub exif: Option<ExifCamera>,
    /// Whether fiducial marks were measured in it.
    pub has_marks: bool,
}

impl PhotoFacts {
    fn known(&self) -> KnownPhoto<'_> {
        KnownPhoto { size: (self.width_px, self.height_px), exif: self.exif.as_ref(), has_marks: self.has_marks }
    }
}

/// The cameras of a pair, the given one or those of its files, with what speaks against them; or what is missing.
#[wasm_bindgen(unchecked_return_type = "PairCameras | { missing: NoOrientation }")]
pub fn pair_cameras(
    #[wasm_bindgen(unchecked_param_type = "CameraMm | null")] given: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "PhotoFacts")] left: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "PhotoFacts")] right: &JsValue,
) -> JsResult<JsValue> {
    let given: Option<CameraMm> = read("camera", given)?;
    let photos: [PhotoFacts; 2] = [read("left", left)?, read("right", right)?];
    let cameras = PairCameras::of(given.as_ref(), photos.each_ref().map(PhotoFacts::known)).map_err(thrown)?;
    Ok(cameras.map_or_else(|reason| object([("missing", pack(&reason))]), |cameras| pack(&cameras)))
}

/// The interior orientations of a pair of whose cameras nothing is known but what its geometry tells; null where it is the map of a plane.
#[wasm_bindgen(unchecked_return_type = "PairInterior | null")]
pub fn assumed_interior(
    #[wasm_bindgen(unchecked_param_type = "Omit<TwoView, \"inliers\">")] geometry: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "PhotoFacts")] left: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "PhotoFacts")] right: &JsValue,
) -> JsResult<JsValue> {
    let found: TwoView = read("geometry", geometry)?;
    let photos: [PhotoFacts; 2] = [read("left", left)?, read("right", right)?];
    Ok(pack(&PairInterior::assumed(&found, photos.each_ref().map(PhotoFacts::known))))
}

/// Why matches (stride 5) between images of these sizes in px have no base: they are one photo twice, or parts of one image. Null where
/// they are neither.
#[wasm_bindgen(unchecked_return_type = "NoOrientation | null")]
pub fn one_image(
    matches: &Numbers,
    left_width: &Number,
    left_height: &Number,
    right_width: &Number,
    right_height: &Number,
) -> JsResult<JsValue> {
    let positions = positions_of(matches)?;
    let size = |width, height| Ok::<_, JsValue>((whole("width", width)?, whole("height", height)?));
    let sizes = [size(left_width, left_height)?, size(right_width, right_height)?];
    Ok(pack(&OneImage::of(&positions, sizes).map(OneImage::reason)))
}

/// Why so few matches have no orientation, whatever else is missing; null where they are enough.
#[wasm_bindgen(unchecked_return_type = "NoOrientation | null")]
pub fn few_matches(matches: &Number) -> JsResult<JsValue> {
    Ok(pack(&NoOrientation::of_few(whole("matches", matches)?)))
}

/// The positions of matches (stride 5).
fn positions_of(matches: &Numbers) -> JsResult<Vec<[f64; 4]>> {
    Ok(rows::<5>("matches", &matches.read("matches")?)?.iter().map(|[xl, yl, xr, yr, _]| [*xl, *yl, *xr, *yr]).collect())
}

/// The interior orientation of an image: from its fiducials, or from the camera's pixel size.
#[wasm_bindgen(unchecked_return_type = "Interior")]
pub fn interior(
    #[wasm_bindgen(unchecked_param_type = "CameraMm")] camera: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "PhotoGeometry")] photo: &JsValue,
) -> JsResult<JsValue> {
    let (camera, photo): (CameraMm, PhotoGeometry) = (read("camera", camera)?, read("photo", photo)?);
    let input = PhotoInput { fiducials: photo.fiducials, model: photo.model, origin: photo.origin };
    photo_interior(&camera, photo.width, photo.height, &input).map(|i| pack(&i)).map_err(thrown)
}

/// The same rays at a focal length `factor` times as long: two photos of different focal lengths are oriented at one of them.
#[wasm_bindgen(unchecked_return_type = "Interior")]
pub fn scaled_interior(#[wasm_bindgen(unchecked_param_type = "Interior")] interior: &JsValue, factor: &Number) -> JsResult<JsValue> {
    let factor = factor.read("factor")?;
    if !(factor > 0.0 && factor.is_finite()) {
        let (got, wanted) = (factor.to_string(), "a number above 0".into());
        return Err(thrown(Error::InvalidArgument { what: "factor", got, wanted }));
    }
    Ok(pack(&read::<Interior>("interior", interior)?.scaled(factor)))
}

/// Photo coordinates x, y left, x, y right in mm (stride 4) of matches (stride 5).
#[wasm_bindgen]
pub fn observations(
    matches: &Numbers,
    #[wasm_bindgen(unchecked_param_type = "Interior")] left: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Interior")] right: &JsValue,
) -> JsResult<Vec<f64>> {
    let (left, right): (Interior, Interior) = (read("left interior", left)?, read("right interior", right)?);
    let positions = positions_of(matches)?;
    Ok(photo_observations(&positions, &left, &right).iter().flat_map(|o| [o.left[0], o.left[1], o.right[0], o.right[1]]).collect())
}

/// Relative orientation from matches (stride 5) with what least squares matching found of them (stride 5, as `MatchResult.fits`; empty: all
/// of weight 1), with the verdict on it. `points`: how many the left and the right image have, where they were matched. The total standard errors hold those of the interior orientations, where these have covariances.
#[wasm_bindgen(unchecked_return_type = "OrientedPair")]
pub fn orient_matches(
    matches: &Numbers,
    fits: &Numbers,
    #[wasm_bindgen(unchecked_param_type = "PairInterior")] interior: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Given<OrientationOptions>")] options: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "[number, number]")] points: &JsValue,
) -> JsResult<JsValue> {
    let points: Option<[usize; 2]> = if points.is_undefined() { None } else { read("points", points)? };
    let (interior, options): (PairInterior, OrientationOptions) = (read("interior", interior)?, read_options("orientation", options)?);
    let (matches, fits) = (matches.read("matches")?, fits.read("fits")?);
    let (rows, fits) = (rows::<5>("matches", &matches)?, rows::<5>("fits", &fits)?);
    if !fits.is_empty() && fits.len() != rows.len() {
        let got = format!("{} fits for {} matches", fits.len(), rows.len());
        return Err(thrown(Error::InvalidArgument { what: "fits", got, wanted: "one for each match, or none".into() }));
    }
    let fit = |[correlation, xx, xy, yy, iterations]: &[f64; 5]| {
        correlation.is_finite().then_some(Fit { correlation: *correlation, covariance: [*xx, *xy, *yy], iterations: *iterations as usize })
    };
    let one = |(k, [xl, yl, xr, yr, measure]): (usize, &[f64; 5])| Match {
        left: k,
        right: None,
        left_px: [*xl, *yl],
        right_px: [*xr, *yr],
        measure: *measure,
        fit: fits.get(k).and_then(fit),
    };
    let matches: Vec<Match> = rows.iter().enumerate().map(one).collect();
    let orientation = judged(orient_by_matches(&matches, &interior, &options).map_err(thrown)?, &matches, &interior, points);
    Ok(pack_oriented(&orientation, &pack(&PairVerdict::of(&orientation, interior.left.pixel_mm()))))
}

/// Relative orientation of observations x, y left, x, y right in mm (stride 4), each of its weight, or all of weight 1, with the verdict on it.
#[wasm_bindgen(unchecked_return_type = "OrientedPair")]
pub fn orient_relative(
    observations: &Numbers,
    focal_mm: &Number,
    #[wasm_bindgen(unchecked_param_type = "Given<OrientationOptions>")] options: &JsValue,
    weights: Option<Numbers>,
) -> JsResult<JsValue> {
    let options: OrientationOptions = read_options("orientation", options)?;
    let observations = weighted(observations, weights)?;
    let found = orient_pair(&observations, focal_mm.read("focal_mm")?, &options).map_err(thrown)?;
    let orientation = judged_observations(found, &observations);
    Ok(pack_oriented(&orientation, &pack(&PairVerdict::of_observations(&orientation))))
}

/// Object points of observations (stride 4) that are oriented as `orient_relative` does: X, Y, Z, their standard errors (NaN where there are
/// none), 1 where the observation took part and 0 where it was rejected; stride 7, NaN for parallel rays. `base`: the length of the base in
/// the unit that the points shall have; 1: the base is the unit.
#[wasm_bindgen]
pub fn model_points(
    observations: &Numbers,
    focal_mm: &Number,
    #[wasm_bindgen(unchecked_param_type = "Given<OrientationOptions>")] options: &JsValue,
    base: &Number,
    weights: Option<Numbers>,
) -> JsResult<Vec<f64>> {
    let options: OrientationOptions = read_options("orientation", options)?;
    let observations = weighted(observations, weights)?;
    let orientation = orient_pair(&observations, focal_mm.read("focal_mm")?, &options).map_err(thrown)?;
    let points = points_of(&orientation, &observations, base.read("base")?).map_err(thrown)?;
    let row = |point: Option<ModelPoint>| {
        let Some(ModelPoint { position: [x, y, z], errors, accepted }) = point else { return [f64::NAN; 7] };
        let [sx, sy, sz] = errors.unwrap_or([f64::NAN; 3]);
        [x, y, z, sx, sy, sz, if accepted { 1.0 } else { 0.0 }]
    };
    Ok(points.into_iter().flat_map(row).collect())
}

/// Observations of stride 4 with their weights, or all of weight 1.
fn weighted(observations: &Numbers, weights: Option<Numbers>) -> JsResult<Vec<Observation>> {
    let observations = observations.read("observations")?;
    let weights = weights.map(|weights| weights.read("weights")).transpose()?;
    let rows = rows::<4>("observations", &observations)?;
    if let Some(weights) = weights.as_ref().filter(|weights| weights.len() != rows.len()) {
        let got = format!("{} weights for {} observations", weights.len(), rows.len());
        return Err(thrown(Error::InvalidArgument { what: "weights", got, wanted: "one weight for each observation".into() }));
    }
    let weight = |k: usize| weights.as_ref().map_or(1.0, |weights| weights[k]);
    let of = |(k, [xl, yl, xr, yr]): (usize, &[f64; 4])| Observation { left: [*xl, *yl], right: [*xr, *yr], weight: weight(k) };
    Ok(rows.iter().enumerate().map(of).collect())
}

/// The orientation of matches, with the verdict on it.
pub(super) fn pack_oriented(orientation: &RelativeOrientation, verdict: &JsValue) -> JsValue {
    let packed = pack_orientation(orientation);
    set(&packed, "verdict", verdict);
    packed
}

/// The orientation, with the residuals and the statistics of its points as flat arrays.
pub(super) fn pack_orientation(orientation: &RelativeOrientation) -> JsValue {
    let packed = pack(&RelativeOrientation { residuals_mm: Vec::new(), points: Vec::new(), ..orientation.clone() });
    let row = |point: &Option<PointStatistics>| match point {
        None => [f64::NAN; 9],
        Some(p) => {
            let [x, y, z] = p.model_mm.unwrap_or([f64::NAN; 3]);
            [p.parallax_mm, p.redundancy, p.w, p.detectable_mm, p.influence, p.weight, x, y, z]
        }
    };
    set(&packed, "residuals_mm", &numbers(orientation.residuals_mm.iter().copied().flatten()));
    set(&packed, "points", &numbers(orientation.points.iter().flat_map(row)));
    packed
}
