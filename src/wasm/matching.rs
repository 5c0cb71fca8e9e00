//! Offsets and matches between two sets of points.

use super::convert::{
    Bytes, JsResult, Number, Numbers, numbers, object, pack, points, read, read_options, rows, set, thrown, whole, wrong,
};
use super::descriptors::read_pieces;
use super::orientation::pack_oriented;
use super::photo::{Photo, pack_points, read_mask};
use crate::{
    DescribedImage, Descriptor, Error, Expectation, Fit, GreyImage, InterestPoint, LocalFrame, Match, MatchOptions, MatchSet, NoGeometry,
    OffsetField, PairInput, PairInterior, PairMatching, PairResult, PairSettings, PhotoDifference, PointCounts, PointSet, Reduced, Rule,
    Side, TwoView, TwoViewModel, Verdict, candidates_of, epipolar_line as line_between, estimate_offset_of_reduced,
    gradient_candidates as nearest_by_gradients, match_described_pair as match_described, match_in_rounds, match_pair as match_images,
    match_points as match_by_moments, parallax_deviation as deviation,
};
use js_sys::{Int32Array, Object, Reflect, Uint8Array, Uint32Array};
use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::{JsCast, JsValue};

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** The outcome of matching. */
export interface MatchResult {
    counts: MatchCounts;
    /** x and y of the left point, x and y of the right point in px, measure; stride 5. */
    matches: Float64Array;
    /** Index of the left and of the right point of each match, 4294967295 where the place found is no interest point; stride 2. */
    indices: Uint32Array;
    /** What least squares matching found: correlation, covariance xx, xy, yy of the right position in px², iterations; stride 5. NaN where none took place. */
    fits: Float64Array;
    /** For each left point the rule that decided: an index into `rule_names()`. */
    rules: Uint8Array;
    /** For each left point the index of its best right point, -1 without one. */
    best: Int32Array;
    /** For each left point the best place in the right image in px, NaN without one; stride 2. */
    places: Float64Array;
    /** For each left point the best and the second best measure, Infinity where there is none; stride 2. */
    measures: Float64Array;
    /** What relates the views, by which the strategy gradient verified its matches; null for the others and where there is nothing. */
    geometry: Omit<TwoView, "inliers"> | null;
    /** Why there is no geometry, where one was looked for. */
    no_geometry: NoGeometry | null;
}

/** Points as matching takes them: `DescribedPoints`, or what of it the strategy needs. */
export type GivenPoints = Pick<DescribedPoints, "points"> & Partial<Pick<DescribedPoints, "frames" | "moments" | "gradients">>;


/** The outcome of a whole pair. */
export interface PairOutput extends MatchedPair {
    left: DetectedPoints;
    right: DetectedPoints;
}

/** A relative orientation of matches, with what it is worth. */
export type OrientedPair = RelativeOrientation & { verdict: PairVerdict };

/** What becomes of the points of a pair. */
export interface MatchedPair {
    /** Absent where the strategy needs none. */
    offset: OffsetField | null;
    match: MatchResult;
    interior: PairInterior | null;
    /** Side of a left pixel in mm. */
    pixel_mm: number | null;
    orientation: OrientedPair | null;
    /** Why there is no orientation. */
    no_orientation: NoOrientation | null;
    /** What the result is worth. */
    verdict: PairVerdict;
}
"#;

/// The names of the rules, in the order of their codes.
#[wasm_bindgen(unchecked_return_type = "Rule[]")]
pub fn rule_names() -> JsValue {
    pack(&Rule::ALL)
}

/// Estimates the offsets between two images from `Photo.reduced(1024)` of each.
#[wasm_bindgen(unchecked_return_type = "OffsetField")]
pub fn estimate_offset(
    #[wasm_bindgen(unchecked_param_type = "ReducedImage")] left: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "ReducedImage")] right: &JsValue,
) -> JsResult<JsValue> {
    Ok(pack(&estimate_offset_of_reduced(&read_reduced(left)?, &read_reduced(right)?)))
}

/// The same offset (right minus left position, px) everywhere.
#[wasm_bindgen(unchecked_return_type = "OffsetField")]
pub fn constant_offset(dx: &Number, dy: &Number) -> JsResult<JsValue> {
    let field = OffsetField::constant(dx.read("dx")?, dy.read("dy")?);
    field.check().map_err(thrown)?;
    Ok(pack(&field))
}

/// Matches described points: points of stride 3, descriptors of stride 7.
#[wasm_bindgen(unchecked_return_type = "MatchResult")]
pub fn match_points(
    left_points: &Numbers,
    left_descriptors: &Numbers,
    right_points: &Numbers,
    right_descriptors: &Numbers,
    #[wasm_bindgen(unchecked_param_type = "OffsetField")] offset: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Given<MatchOptions>")] options: &JsValue,
) -> JsResult<JsValue> {
    let (left, right) = (Described::read(left_points, left_descriptors)?, Described::read(right_points, right_descriptors)?);
    let (offset, options) = (read_offset(offset)?, read_options::<MatchOptions>("matching", options)?);
    let set = match_by_moments(left.parts(), right.parts(), &offset, &options).map_err(thrown)?;
    Ok(pack_matching(&PairMatching { set, geometry: None }))
}

/// Matches two photos by any strategy.
///
/// With `matching.epipolar` and an interior orientation the pair is oriented and matched again along the epipolar lines, until nothing
/// changes. Only the strategy gradient does without an offset. It finds the nearest descriptors itself, unless it is given the pieces that
/// `nearest_piece` made of all left points, in their order: the matches are the same.
#[allow(clippy::too_many_arguments)]
#[wasm_bindgen(unchecked_return_type = "MatchResult")]
pub fn match_photos(
    left: &Photo,
    right: &Photo,
    #[wasm_bindgen(unchecked_param_type = "GivenPoints")] left_points: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "GivenPoints")] right_points: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "OffsetField | null")] offset: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "PairInterior | null")] interior: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Given<PairSettings>")] settings: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "NearestPiece[]")] nearest: &JsValue,
) -> JsResult<JsValue> {
    let settings = read_options::<PairSettings>("settings", settings)?;
    let strategy = settings.matching.strategy;
    let offset = match offset.is_null() && !strategy.needs_offset() {
        true => OffsetField::constant(0.0, 0.0),
        false => read_offset(offset)?,
    };
    let interior = read::<Option<PairInterior>>("interior", interior)?;
    let given = [read_points(left_points)?, read_points(right_points)?];
    let images = [given[0].match_image(left.view(), strategy), given[1].match_image(right.view(), strategy)];
    let nearest = if nearest.is_undefined() { None } else { read_pieces(nearest)? };
    let expected = Expectation { nearest: nearest.as_ref(), ..Expectation::from(&offset) };
    match_in_rounds(images, expected, interior.as_ref(), &settings).map(|matching| pack_matching(&matching)).map_err(thrown)
}

/// The right points in the order of their distance from the left one of an index, up to `most`: index and measure, stride 2.
#[wasm_bindgen]
pub fn gradient_candidates(index: &Number, left_gradients: &Bytes, right_gradients: &Bytes, most: &Number) -> JsResult<Vec<f64>> {
    let (left, right) = (left_gradients.read("left gradients")?, right_gradients.read("right gradients")?);
    let all = nearest_by_gradients(whole("index of the left point", index)?, &left, &right, whole("most", most)?).map_err(thrown)?;
    Ok(all.iter().flat_map(|c| [c.right as f64, c.measure]).collect())
}

/// Where a point of one image may be seen in the other, by the geometry that `match_photos` gave with the same interior orientations:
/// positions x, y in px along its epipolar line, or the one place that the map of a plane or a rotation gives; stride 2. Empty where the
/// line passes the other image, whose width and height are given.
#[wasm_bindgen]
pub fn epipolar_line(
    #[wasm_bindgen(unchecked_param_type = "\"left\" | \"right\"")] from: &JsValue,
    x: &Number,
    y: &Number,
    #[wasm_bindgen(unchecked_param_type = "TwoViewModel")] model: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "PairInterior | null")] interior: &JsValue,
    other_width: &Number,
    other_height: &Number,
) -> JsResult<Vec<f64>> {
    let size = (whole("width of the other image", other_width)?, whole("height of the other image", other_height)?);
    let side: Side = read("from", from)?;
    let model: TwoViewModel = read("model", model)?;
    let interior: Option<PairInterior> = read("interior", interior)?;
    let line = line_between(&model, interior.as_ref(), (side, [x.read("x")?, y.read("y")?]), size);
    Ok(line.into_iter().flatten().collect())
}

/// The candidates of one left point, the best first: index of the right point and measure, stride 2.
#[wasm_bindgen]
pub fn candidates(
    index: &Number,
    left_points: &Numbers,
    left_descriptors: &Numbers,
    right_points: &Numbers,
    right_descriptors: &Numbers,
    #[wasm_bindgen(unchecked_param_type = "OffsetField")] offset: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Given<MatchOptions>")] options: &JsValue,
) -> JsResult<Vec<f64>> {
    let (left, right) = (Described::read(left_points, left_descriptors)?, Described::read(right_points, right_descriptors)?);
    let (offset, options) = (read_offset(offset)?, read_options::<MatchOptions>("matching", options)?);
    let all = candidates_of(whole("index of the left point", index)?, left.parts(), right.parts(), &offset, &options).map_err(thrown)?;
    Ok(all.iter().flat_map(|c| [c.right as f64, c.measure]).collect())
}

/// How far the y-parallax of one left point is from those of its nearest matches, and how far it may be; absent where it has no place or nothing is near.
/// Rules and places are those of a `MatchResult`.
#[wasm_bindgen(unchecked_return_type = "ParallaxDeviation | undefined")]
pub fn parallax_deviation(
    index: &Number,
    left_points: &Numbers,
    rules: &Bytes,
    places: &Numbers,
    #[wasm_bindgen(unchecked_param_type = "OffsetField")] offset: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Given<MatchOptions>")] options: &JsValue,
) -> JsResult<JsValue> {
    let left = points("left points", &left_points.read("left points")?)?;
    let (rules, places) = (rules.read("rules")?, places.read("places")?);
    let position = |[x, y]: &[f64; 2]| (x.is_finite() && y.is_finite()).then_some([*x, *y]);
    let verdict = |(rule, place)| Verdict { position: position(place), ..Verdict::none(rule) };
    let rule =
        |code: &u8| Rule::ALL.get(usize::from(*code)).copied().ok_or_else(|| wrong("rules", code.to_string(), "indices into rule_names()"));
    let rules: Vec<Rule> = rules.iter().map(rule).collect::<JsResult<_>>()?;
    let verdicts: Vec<Verdict> = rules.into_iter().zip(rows::<2>("places", &places)?).map(verdict).collect();
    let (offset, options) = (read_offset(offset)?, read_options::<MatchOptions>("matching", options)?);
    let found = deviation(whole("index of the left point", index)?, &left, &verdicts, &offset, &options).map_err(thrown)?;
    Ok(found.map_or(JsValue::UNDEFINED, |found| pack(&found)))
}

/// Matches and orients a pair on one thread. Points whose pixel is 0 in the mask of their image, of its size and row by row, are left out.
#[wasm_bindgen(unchecked_return_type = "PairOutput")]
pub fn match_pair(
    left: &Photo,
    right: &Photo,
    #[wasm_bindgen(unchecked_param_type = "Given<PairInput>")] input: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Given<PairSettings>")] settings: &JsValue,
    left_mask: Option<Bytes>,
    right_mask: Option<Bytes>,
) -> JsResult<JsValue> {
    let (left_mask, right_mask) = (read_mask(left_mask)?, read_mask(right_mask)?);
    let (input, settings) = (read_options::<PairInput>("input", input)?, read_options::<PairSettings>("settings", settings)?);
    let (left, right) = (left.pair_image(&left_mask)?, right.pair_image(&right_mask)?);
    match_images(left, right, &input, &settings).map(|result| pack_pair(&result)).map_err(thrown)
}

/// How the right photo lies to the left one in their planes; null where they do not match, however they lie.
#[wasm_bindgen(unchecked_return_type = "PhotoDifference | null")]
pub fn photo_difference(left: &Photo, right: &Photo) -> JsResult<JsValue> {
    let (left, right) = (left.pair_image(&None)?, right.pair_image(&None)?);
    PhotoDifference::between(left.grey, right.grey).map(|found| pack(&found)).map_err(thrown)
}

/// Matches and orients two photos whose points are described: the rest of `match_pair`. For the strategy gradient the nearest descriptors may
/// have been searched for already: the pieces that `nearest_piece` made of all left points, in their order.
#[wasm_bindgen(unchecked_return_type = "MatchedPair")]
pub fn match_described_pair(
    left: &Photo,
    right: &Photo,
    #[wasm_bindgen(unchecked_param_type = "GivenPoints")] left_points: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "GivenPoints")] right_points: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Given<PairInput>")] input: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Given<PairSettings>")] settings: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "NearestPiece[]")] nearest: &JsValue,
) -> JsResult<JsValue> {
    let (input, settings) = (read_options::<PairInput>("input", input)?, read_options::<PairSettings>("settings", settings)?);
    let described = [read_points(left_points)?, read_points(right_points)?];
    let nearest = if nearest.is_undefined() { None } else { read_pieces(nearest)? };
    let (left, right) = (left.pair_image(&None)?, right.pair_image(&None)?);
    let result = match_described(left, right, described, nearest.as_ref(), &input, &settings).map_err(thrown)?;
    Ok(pack_matched(&result))
}

pub(super) fn pack_pair(result: &PairResult) -> JsValue {
    let packed = pack_matched(result);
    set(&packed, "left", &pack_points(&result.left));
    set(&packed, "right", &pack_points(&result.right));
    packed
}

fn pack_matched(result: &PairResult) -> JsValue {
    let verdict = pack(&result.verdict());
    object([
        ("offset", pack(&result.offset)),
        ("match", pack_matching(&PairMatching { set: result.matching.clone(), geometry: result.geometry.clone() })),
        ("interior", pack(&result.interior)),
        ("pixel_mm", pack(&result.interior.as_ref().map(|i| i.left.pixel_mm()))),
        ("orientation", result.orientation.as_ref().map_or(JsValue::NULL, |o| pack_oriented(o, &verdict))),
        ("no_orientation", pack(&result.orientation.as_ref().err())),
        ("verdict", verdict),
    ])
}

fn pack_matching(matching: &PairMatching) -> JsValue {
    let packed = pack_matches(&matching.set);
    set_geometry(&packed, matching.geometry.as_ref());
    packed
}

/// Sets what relates the views, or why nothing does. All matches agree with it: inliers are left out.
pub(super) fn set_geometry(object: &JsValue, geometry: Option<&Result<TwoView, NoGeometry>>) {
    let found = geometry.and_then(|geometry| geometry.as_ref().ok()).map(|found| TwoView { inliers: Vec::new(), ..found.clone() });
    let packed = pack(&found);
    if found.is_some() {
        Reflect::delete_property(packed.unchecked_ref::<Object>(), &"inliers".into()).expect("a plain object gives up its fields");
    }
    set(object, "geometry", &packed);
    set(object, "no_geometry", &pack(&geometry.and_then(|geometry| geometry.as_ref().err())));
}

pub(super) fn pack_matches(set: &MatchSet) -> JsValue {
    let code = |rule: Rule| Rule::ALL.iter().position(|r| *r == rule).expect("all rules are there") as u8;
    let rules: Vec<u8> = set.verdicts.iter().map(|v| code(v.rule)).collect();
    let best: Vec<i32> = set.verdicts.iter().map(|v| v.best.map_or(-1, |best| best as i32)).collect();
    let indices: Vec<u32> = set.matches.iter().flat_map(|m| [m.left as u32, m.right.map_or(u32::MAX, |right| right as u32)]).collect();
    let fit = |m: &Match| {
        m.fit
            .map_or([f64::NAN; 5], |Fit { correlation, covariance: [xx, xy, yy], iterations }| [correlation, xx, xy, yy, iterations as f64])
    };
    object([
        ("counts", pack(&set.counts)),
        ("matches", numbers(set.matches.iter().flat_map(|m| [m.left_px[0], m.left_px[1], m.right_px[0], m.right_px[1], m.measure]))),
        ("indices", Uint32Array::from(&indices[..]).into()),
        ("fits", numbers(set.matches.iter().flat_map(fit))),
        ("rules", Uint8Array::from(&rules[..]).into()),
        ("best", Int32Array::from(&best[..]).into()),
        ("places", numbers(set.verdicts.iter().flat_map(|v| v.position.unwrap_or([f64::NAN; 2])))),
        ("measures", numbers(set.verdicts.iter().flat_map(|v| [v.measure, v.second]))),
    ])
}

/// Points with their descriptors.
struct Described {
    points: Vec<InterestPoint>,
    descriptors: Vec<Option<Descriptor>>,
}

impl Described {
    fn read(point_list: &Numbers, descriptors: &Numbers) -> JsResult<Self> {
        let (point_list, descriptors) = (point_list.read("points")?, descriptors.read("descriptors")?);
        let descriptors = rows::<7>("descriptors", &descriptors)?;
        let descriptors = descriptors.iter().map(|d| d.iter().all(|v| v.is_finite()).then_some(*d)).collect();
        Ok(Self { points: points("points", &point_list)?, descriptors })
    }

    fn parts(&self) -> crate::Described<'_> {
        (&self.points, &self.descriptors)
    }
}

/// Points with what the strategy compares them by.
pub(super) fn read_points(value: &JsValue) -> JsResult<DescribedImage> {
    let field = |name: &str| Reflect::get(value, &name.into()).ok().filter(|found| !found.is_undefined() && !found.is_null());
    let floats = |name| field(name).map_or(Ok(Vec::new()), |found| found.unchecked_ref::<Numbers>().read(name));
    let (frames, moments) = (floats("frames")?, floats("moments")?);
    let (frames, moments) = (rows::<2>("frames", &frames)?, rows::<7>("moments", &moments)?);
    let set = PointSet {
        points: points("points", &field("points").unwrap_or_default().unchecked_ref::<Numbers>().read("points")?)?,
        frames: frames
            .iter()
            .map(|[scale_px, orientation_rad]| LocalFrame { scale_px: *scale_px, orientation_rad: *orientation_rad })
            .collect(),
        counts: PointCounts::default(),
        threshold: 0.0,
    };
    let moments = moments.iter().map(|d| d.iter().all(|v| v.is_finite()).then_some(*d)).collect();
    let gradients = field("gradients").map_or(Ok(Vec::new()), |found| found.unchecked_ref::<Bytes>().read("gradients"))?;
    Ok(DescribedImage { set, moments, gradients })
}

fn read_offset(value: &JsValue) -> JsResult<OffsetField> {
    let field: OffsetField = read("offset field", value)?;
    field.check().map_err(thrown)?;
    Ok(field)
}

fn read_reduced(value: &JsValue) -> JsResult<Reduced> {
    let refuse = |got: &str| {
        let allowed = "an object {width, height, halvings, grey} as Photo.reduced gives it".to_string();
        thrown(Error::InvalidArgument { what: "reduced image", got: got.to_string(), wanted: allowed })
    };
    let field = |name: &str| Reflect::get(value, &name.into()).map_err(|_| refuse("no object"));
    let whole = |name: &str| {
        let number = field(name)?.as_f64().filter(|v| v.fract() == 0.0 && (0.0..1e9).contains(v));
        number.map(|v| v as usize).ok_or_else(|| refuse(&format!("no whole number as {name}")))
    };
    let grey = field("grey")?.dyn_into::<Uint8Array>().map_err(|_| refuse("no Uint8Array as grey"))?;
    let halvings = whole("halvings")?;
    if halvings > 30 {
        return Err(refuse("more than 30 halvings"));
    }
    let image = GreyImage::new(whole("width")?, whole("height")?, grey.to_vec()).map_err(thrown)?;
    Ok(Reduced { image, halvings: halvings as u32 })
}
