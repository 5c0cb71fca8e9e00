//! Multi-ray points of a block: its pairs, its matches, the points and the choice among them.

use super::convert::{JsResult, object, pack, read_options, rows, thrown};
use crate::tracks::check_features;
use crate::{
    BlockMatches, BlockOptions, BlockSettings, Error, FeatureMatch, ImageFeatures, PairChoice, SelectOptions, TiePoints, acting,
    choose_pairs as choose, local_from_geographic, select_points, shared_points, tie_points,
};
use js_sys::{Float32Array, Float64Array, Uint32Array};
use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::{JsCast, JsValue};

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** Multi-ray points: the rays of point i are those from starts[i] to before starts[i + 1]. */
export interface TiePointTable {
    starts: Uint32Array;
    /** Image and feature of each ray; stride 2. */
    rays: Uint32Array;
    /** Probability, 0..1, that a ray belongs to its point. */
    ray_confidence: Float32Array;
    /** Probability, 0..1, that all rays of a point belong together. */
    confidence: Float32Array;
}

/** Points that were chosen, with the rays and the filled von Gruber places of each image. */
export interface SelectedTiePoints { points: Uint32Array; rays_of_images: Uint32Array; places_of_images: Uint32Array }
"#;

/// The rule that chooses the pairs of a block. `positions`: x, y, z in m of each image, NaN where it has none; stride 3.
#[wasm_bindgen(unchecked_return_type = "PairRule")]
pub fn pair_rule(positions: &[f64], #[wasm_bindgen(unchecked_param_type = "Given<PairChoice>")] choice: &JsValue) -> JsResult<JsValue> {
    Ok(pack(&read_options::<PairChoice>("pairs", choice)?.rule_of(&read_positions(positions)?)))
}

/// The pairs of a block that are tried, each once: `positions` as in `pair_rule`; `similar`: two images and their similarity; stride 3.
#[wasm_bindgen(unchecked_return_type = "ChosenPair[]")]
pub fn choose_pairs(
    positions: &[f64],
    similar: &[f64],
    #[wasm_bindgen(unchecked_param_type = "Given<PairChoice>")] choice: &JsValue,
) -> JsResult<JsValue> {
    let positions = read_positions(positions)?;
    let images = positions.len() as u32;
    let mut lists: Vec<Vec<(u32, f32)>> = vec![Vec::new(); positions.len()];
    for [a, b, value] in rows::<3>("similar images", similar)? {
        let allowed = format!("two images below {images} and a number");
        let wrong = || thrown(Error::InvalidInput { what: "similar images", got: format!("{a}, {b}, {value}"), allowed: allowed.clone() });
        let [a, b] = [index(*a, images).ok_or_else(wrong)?, index(*b, images).ok_or_else(wrong)?];
        lists[a as usize].push((b, *value as f32));
        lists[b as usize].push((a, *value as f32));
    }
    choose(&positions, &lists, &read_options("pairs", choice)?).map(|pairs| pack(&pairs)).map_err(thrown)
}

fn read_positions(flat: &[f64]) -> JsResult<Vec<Option<[f64; 3]>>> {
    let known = |p: &[f64; 3]| p.iter().all(|v| !v.is_nan()).then_some(*p);
    Ok(rows::<3>("positions of images", flat)?.iter().map(known).collect())
}

fn index(value: f64, below: u32) -> Option<u32> {
    (value.fract() == 0.0 && value >= 0.0 && value < f64::from(below)).then_some(value as u32)
}

/// The features of one image: where they are.
#[derive(Clone)]
struct Positions {
    width_px: u32,
    height_px: u32,
    positions: Vec<[f32; 2]>,
}

impl Positions {
    fn features(&self) -> ImageFeatures<'_> {
        ImageFeatures { width_px: self.width_px, height_px: self.height_px, positions: &self.positions }
    }
}

/// The features and matches of a block in wasm memory, and the points made of them. Call `free` when it is no longer needed.
///
/// First every image with `set_image`, then every pair with `add_pair`, in any order each, then `join`.
#[wasm_bindgen]
pub struct BlockPoints {
    images: Vec<Positions>,
    counts: Vec<u32>,
    matches: BlockMatches,
    pub(super) points: TiePoints,
}

#[wasm_bindgen]
impl BlockPoints {
    /// A block of images with these numbers of features.
    #[wasm_bindgen(constructor)]
    pub fn new(counts: Vec<u32>) -> JsResult<BlockPoints> {
        let images = counts.iter().map(|_| Positions { width_px: 0, height_px: 0, positions: Vec::new() }).collect();
        let matches = BlockMatches::new(&counts).map_err(thrown)?;
        Ok(Self { images, counts, matches, points: TiePoints::default() })
    }

    /// Takes the size of an image in px and the positions x, y of its features in px (stride 2).
    pub fn set_image(&mut self, image: u32, width_px: u32, height_px: u32, positions: &[f32]) -> JsResult<()> {
        let (positions, rest) = positions.as_chunks::<2>();
        let wanted = self.counts.get(image as usize).copied();
        if !rest.is_empty() || wanted != Some(positions.len() as u32) {
            let got = format!("{} of image {image}", positions.len());
            let allowed = wanted.map_or(format!("images below {}", self.counts.len()), |count| count.to_string());
            return Err(thrown(Error::InvalidInput { what: "positions of features", got, allowed }));
        }
        self.images[image as usize] = Positions { width_px, height_px, positions: positions.to_vec() };
        Ok(())
    }

    /// Takes the matches of two images: the features of each match (stride 2), and how strong it is.
    pub fn add_pair(&mut self, first: u32, second: u32, indices: &[u32], strengths: &[f32]) -> JsResult<()> {
        let (pairs, rest) = indices.as_chunks::<2>();
        if !rest.is_empty() || pairs.len() != strengths.len() {
            let got = format!("{} indices and {} strengths", indices.len(), strengths.len());
            return Err(thrown(Error::InvalidInput { what: "matches of a pair", got, allowed: "two indices for each strength".into() }));
        }
        let matches: Vec<FeatureMatch> =
            pairs.iter().zip(strengths).map(|(features, strength)| FeatureMatch { features: *features, strength: *strength }).collect();
        self.matches.add_pair([first, second], &matches).map_err(thrown)
    }

    /// Joins the matches to multi-ray points, in place of those made before.
    #[wasm_bindgen(unchecked_return_type = "JoinCounts")]
    pub fn join(&mut self, #[wasm_bindgen(unchecked_param_type = "Given<BlockOptions>")] options: &JsValue) -> JsResult<JsValue> {
        let (points, counts) = tie_points(&self.matches, &read_options::<BlockOptions>("block", options)?).map_err(thrown)?;
        self.points = points;
        Ok(pack(&counts))
    }

    /// How many points there are.
    #[wasm_bindgen(getter)]
    pub fn count(&self) -> usize {
        self.points.len()
    }

    /// How many rays they have together.
    #[wasm_bindgen(getter)]
    pub fn ray_count(&self) -> usize {
        self.points.ray_count()
    }

    /// All points.
    #[wasm_bindgen(unchecked_return_type = "TiePointTable")]
    pub fn table(&self) -> JsValue {
        let mut starts = vec![0_u32];
        starts.extend(self.points.iter().scan(0, |end, rays| {
            *end += rays.len() as u32;
            Some(*end)
        }));
        let rays: Vec<u32> = self.points.iter().flatten().flat_map(|ray| [ray.image, ray.feature]).collect();
        let ray_confidence: Vec<f32> = self.points.iter().flatten().map(|ray| ray.confidence).collect();
        let confidence: Vec<f32> = (0..self.points.len()).map(|point| self.points.confidence(point)).collect();
        object([
            ("starts", whole(&starts)),
            ("rays", whole(&rays)),
            ("ray_confidence", Float32Array::from(&ray_confidence[..]).into()),
            ("confidence", Float32Array::from(&confidence[..]).into()),
        ])
    }

    /// How many points have 2, 3, 4, … rays, from 0 rays on.
    pub fn ray_histogram(&self) -> Vec<u32> {
        let mut counts: Vec<u32> = Vec::new();
        for rays in self.points.iter() {
            counts.resize(counts.len().max(rays.len() + 1), 0);
            counts[rays.len()] += 1;
        }
        counts
    }

    /// For each two images with points in common: both and how many; stride 3.
    pub fn shared(&self) -> Vec<u32> {
        shared_points(&self.points, self.images.len()).iter().flat_map(|s| [s.images[0], s.images[1], s.points]).collect()
    }

    /// Chooses few points, well distributed.
    #[wasm_bindgen(unchecked_return_type = "SelectedTiePoints")]
    pub fn select(&self, #[wasm_bindgen(unchecked_param_type = "Given<SelectOptions>")] options: &JsValue) -> JsResult<JsValue> {
        let options: SelectOptions = read_options("selection", options)?;
        let chosen = select_points(&self.points, &self.features(), &options).map_err(thrown)?;
        Ok(object([
            ("points", whole(&chosen.points)),
            ("rays_of_images", whole(&chosen.rays_of_images)),
            ("places_of_images", whole(&chosen.places_of_images)),
        ]))
    }

    /// A block of these of the points alone, with their rays at these positions x, y in px (stride 2, in the order of points and rays).
    pub fn moved(&self, chosen: &[u32], positions: &[f32]) -> JsResult<BlockPoints> {
        let points = self.points.some(chosen).map_err(thrown)?;
        let (positions, rest) = positions.as_chunks::<2>();
        if !rest.is_empty() || positions.len() != points.ray_count() {
            let got = format!("{} positions", positions.len());
            let allowed = format!("{}, one for each ray", points.ray_count());
            return Err(thrown(Error::InvalidInput { what: "positions of rays", got, allowed }));
        }
        let mut images = self.images.clone();
        for (ray, position) in points.iter().flatten().zip(positions) {
            images[ray.image as usize].positions[ray.feature as usize] = *position;
        }
        let matches = BlockMatches::new(&self.counts).map_err(thrown)?;
        let moved = Self { images, counts: self.counts.clone(), matches, points };
        check_features(&moved.points, &moved.features()).map_err(thrown)?;
        Ok(moved)
    }
}

impl BlockPoints {
    pub(super) fn features(&self) -> Vec<ImageFeatures<'_>> {
        self.images.iter().map(Positions::features).collect()
    }
}

/// Every option of a block, in the order of the pipeline.
#[wasm_bindgen(unchecked_return_type = "Parameter[]")]
pub fn block_parameters() -> JsValue {
    pack(&BlockSettings::parameters().collect::<Vec<_>>())
}

/// The keys of the options of a block that have an effect with these settings.
#[wasm_bindgen(unchecked_return_type = "string[]")]
pub fn acting_block_parameters(#[wasm_bindgen(unchecked_param_type = "Given<BlockSettings>")] settings: &JsValue) -> JsResult<JsValue> {
    Ok(pack(&acting(BlockSettings::parameters(), &read_options::<BlockSettings>("block", settings)?)))
}

/// All settings of a block: those given, the others from the defaults. Values of pairs, points and selection outside their ranges are refused.
#[wasm_bindgen(unchecked_return_type = "BlockSettings")]
pub fn block_settings(#[wasm_bindgen(unchecked_param_type = "Given<BlockSettings>")] given: &JsValue) -> JsResult<JsValue> {
    let settings: BlockSettings = read_options("block", given)?;
    settings.check().map(|()| pack(&settings)).map_err(thrown)
}

fn whole(values: &[u32]) -> JsValue {
    Uint32Array::from(values).unchecked_into()
}

/// Positions in m east, north and up of the first known one: of longitude, latitude in degrees and height in m (stride 3), NaN where not known.
#[wasm_bindgen]
pub fn local_positions(geographic: &[f64]) -> JsResult<Float64Array> {
    let places = rows::<3>("geographic positions", geographic)?;
    let origin = places.iter().find(|p| p.iter().all(|v| v.is_finite()));
    let local = |p: &[f64; 3]| origin.map_or([f64::NAN; 3], |origin| local_from_geographic(*p, *origin));
    Ok(Float64Array::from(&places.iter().flat_map(local).collect::<Vec<f64>>()[..]))
}
