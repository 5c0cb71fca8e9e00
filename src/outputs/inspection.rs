//! What is known of one tie point, and of the observations of one image: what is looked at where images are opened at a point.

use crate::adjustment::project;
use crate::catalogue::refuse as refuse_option;
use crate::error::refuse;
use crate::{
    Allowed, BlockRun, Camera, ControlRole, Error, Input, ModelImage, ObservationVerdict, PointSource, Pose, ReconstructedModel, Refusal,
    RejectedObservation,
};
use serde::Serialize;

/// A point of the model that is written, with its observations.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct PointDetail {
    /// What it is, whatever its index; absent in a block that is not oriented.
    pub id: Option<PointSource>,
    /// Of a surveyed point.
    pub name: Option<String>,
    pub role: Option<ControlRole>,
    /// X, Y, Z; absent where it is not intersected.
    pub position: Option<[f64; 3]>,
    /// Their standard errors.
    pub errors: Option<[f64; 3]>,
    pub rmse_px: Option<f64>,
    /// Probability, 0..1, that its observations belong together.
    pub confidence: f64,
    pub observations: Vec<ObservationDetail>,
    /// Where the other oriented images should show it.
    pub elsewhere: Vec<ImagePlace>,
}

/// An observation of a point.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ObservationDetail {
    /// Index of the image in the block.
    pub image: usize,
    /// Column and row in px.
    pub x_px: f64,
    pub y_px: f64,
    pub part: ObservationPart,
    /// Whether it was measured by hand.
    pub by_hand: bool,
    /// Observed minus computed.
    pub residual_px: Option<[f64; 2]>,
    /// r, 0..1, of column and row: the share of an error that shows in the residual.
    pub redundancy: Option<[f64; 2]>,
    /// Residuals by their standard errors (Baarda's w).
    pub w: Option<[f64; 2]>,
    /// The error that its test finds with a probability of 0.80.
    pub detectable_px: [Option<f64>; 2],
    /// Where the adjusted point is in the image; absent behind it.
    pub predicted_px: Option<[f64; 2]>,
}

/// Whether an observation takes part in the adjustment, or why not.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum ObservationPart {
    Accepted,
    /// Data snooping rejected it.
    GrossError,
    /// Its point lies behind the image.
    Behind,
    /// Its point has fewer than two rays left, or rays that do not meet.
    LostPoint,
    /// It did not fit before the adjustment.
    DoesNotFit,
    RejectedByHand,
    /// The block is not adjusted.
    NotAdjusted,
}

/// A place in an image.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ImagePlace {
    /// Index of the image in the block.
    pub image: usize,
    /// Column and row in px.
    pub x_px: f64,
    pub y_px: f64,
}

/// An observation of an image.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ImagePoint {
    /// Index of its point in the model that is written.
    pub point: usize,
    pub place_px: [f64; 2],
    /// Observed minus computed.
    pub residual_px: Option<[f64; 2]>,
    /// As [`ObservationDetail`] has them; absent for what did not come to the adjustment.
    pub redundancy: Option<[f64; 2]>,
    pub w: Option<[f64; 2]>,
    pub detectable_px: [Option<f64>; 2],
    pub part: ObservationPart,
}

/// The points of the model that is written, by what they are; empty for a block that is not oriented.
pub fn point_ids(run: &BlockRun) -> Vec<PointSource> {
    written(run).map_or(Vec::new(), |(model, written)| written.iter().map(|point| model.points[*point]).collect())
}

/// All that is known of a point.
///
/// # Errors
/// [`Error::InvalidInput`] for a point that does not exist.
pub fn point_detail(run: &BlockRun, point: usize) -> Result<PointDetail, Error> {
    let Some(known) = run.model.points.get(point) else {
        return refuse(Refusal::Index { input: Input::Point, index: point, count: run.model.points.len() });
    };
    let written = written(run).and_then(|(model, written)| Some((model, *written.get(point)?)));
    let surveyed = written.and_then(|(model, place)| surveyed(model, place));
    let observations = match written {
        Some((model, place)) => adjusted_observations(run, model, place),
        None => known.rays.iter().map(|ray| found(ray.image, [ray.x_px, ray.y_px], ObservationPart::NotAdjusted)).collect(),
    };
    let elsewhere = (0..run.model.images.len())
        .filter(|image| observations.iter().all(|observation| observation.image != *image))
        .filter_map(|image| {
            let [x_px, y_px] = predicted(run, image, &known.position?)?;
            Some(ImagePlace { image, x_px, y_px })
        })
        .collect();
    Ok(PointDetail {
        id: written.map(|(model, place)| model.points[place]),
        name: surveyed.map(|point| point.name.clone()),
        role: surveyed.map(|point| point.role),
        position: known.position,
        errors: written.and_then(|(model, place)| model.adjusted.points[place]?.errors),
        rmse_px: known.rmse_px,
        confidence: known.confidence,
        observations,
        elsewhere,
    })
}

/// The observations of an image.
///
/// # Errors
/// [`Error::InvalidInput`] for an image that does not exist.
pub fn image_points(run: &BlockRun, image: usize) -> Result<Vec<ImagePoint>, Error> {
    if image >= run.model.images.len() {
        return refuse(Refusal::Index { input: Input::Image, index: image, count: run.model.images.len() });
    }
    let Some((model, written)) = written(run) else {
        let of_point = |(point, known): (usize, &crate::ObjectPoint)| {
            let ray = known.rays.iter().find(|ray| ray.image == image)?;
            Some(unadjusted(point, [ray.x_px, ray.y_px], ObservationPart::NotAdjusted))
        };
        return Ok(run.model.points.iter().enumerate().filter_map(of_point).collect());
    };
    let Ok(own) = model.images.binary_search(&image) else { return Ok(Vec::new()) };
    let adjusted = model.adjusted.block.rays.iter().zip(&model.adjusted.rays).filter(|(ray, _)| ray.image == own);
    let adjusted = adjusted.filter_map(|(ray, statistics)| {
        let point = written.binary_search(&ray.point).ok()?;
        Some(ImagePoint {
            residual_px: Some(statistics.residual_px),
            redundancy: statistics.redundancy,
            w: statistics.w,
            detectable_px: statistics.detectable_px,
            ..unadjusted(point, [ray.x_px, ray.y_px], part(statistics.verdict))
        })
    });
    let rejected = model.rejected.iter().filter(|ray| ray.image == own).filter_map(|ray| {
        let point = written.binary_search(&ray.point).ok()?;
        Some(unadjusted(point, [ray.x_px, ray.y_px], rejection(ray)))
    });
    Ok(adjusted.chain(rejected).collect())
}

/// An observation of which the adjustment says nothing.
fn unadjusted(point: usize, place_px: [f64; 2], part: ObservationPart) -> ImagePoint {
    ImagePoint { point, place_px, residual_px: None, redundancy: None, w: None, detectable_px: [None; 2], part }
}

/// Depths along the ray of an epipolar line, as multiples of the median depth of the image's points: from the nearest on.
const NEAREST: f64 = 0.05;
const FARTHEST: f64 = 20.0;
/// Steps from one to the other, equal in their logarithms: the line is straight but for the distortion.
const STEPS: usize = 96;

/// The epipolar line of a place of one image in another one, as far as that shows it: places in px, distortion included, for depths from near
/// to far; empty where an image is not oriented or the line misses the other one.
///
/// # Errors
/// [`Error::InvalidInput`] for images that do not exist, [`Error::InvalidOption`] for a place without numbers; as [`Camera::direction`].
pub fn block_epipolar_line(run: &BlockRun, from: usize, place_px: [f64; 2], to: usize) -> Result<Vec<[f64; 2]>, Error> {
    let images = &run.model.images;
    if let Some(image) = [from, to].into_iter().find(|image| *image >= images.len()) {
        return refuse(Refusal::Index { input: Input::Image, index: image, count: images.len() });
    }
    if !place_px.iter().all(|side| side.is_finite()) {
        return Err(refuse_option("place_px", format!("{place_px:?}"), Allowed::Finite { numbers: 2 }));
    }
    let (Some(pose), Some(depth)) = (images[from].pose, median_depth(run, from)) else { return Ok(Vec::new()) };
    let along = pose.ray(run.model.cameras[images[from].camera].direction(place_px)?);
    let step = libm::pow(FARTHEST / NEAREST, 1.0 / STEPS as f64);
    let at = |i: usize| {
        let length = depth * NEAREST * libm::pow(step, i as f64);
        predicted(run, to, &[0, 1, 2].map(|k| pose.position[k] + length * along[k]))
    };
    Ok((0..=STEPS).filter_map(at).collect())
}

/// The median distance of an image's points from its plane through the projection centre.
fn median_depth(run: &BlockRun, image: usize) -> Option<f64> {
    let pose = run.model.images[image].pose?;
    let seen = run.model.points.iter().filter(|point| point.rays.iter().any(|ray| ray.image == image));
    let mut depths: Vec<f64> = seen.filter_map(|point| Some(-pose.to_photo(&point.position?)[2])).filter(|depth| *depth > 0.0).collect();
    crate::math::median(&mut depths)
}

/// The first model, which is written, and the points of it that are: those with an accepted observation.
fn written(run: &BlockRun) -> Option<(&ReconstructedModel, Vec<usize>)> {
    let model = run.reconstruction.as_ref().ok()?.models.first()?;
    let written = (0..model.points.len()).filter(|point| model.adjusted.points[*point].is_some());
    Some((model, written.collect()))
}

/// The surveyed point that a point of the adjusted block is.
pub(super) fn surveyed(model: &ReconstructedModel, place: usize) -> Option<&crate::SurveyedPoint> {
    model.surveyed.get(surveyed_index(model, place)?)
}

/// The numbers of the surveyed points of the model that is written.
pub(super) fn surveyed_numbers(run: &BlockRun) -> Vec<u32> {
    let Some((model, written)) = written(run) else { return Vec::new() };
    let numbered =
        written.iter().zip(run.model.point_numbers()).filter(|(place, _)| matches!(model.points[**place], PointSource::GroundControl(_)));
    numbered.map(|(_, number)| number).collect()
}

/// The index of a point of the model among the surveyed ones; absent for a tie point.
pub(super) fn surveyed_index(model: &ReconstructedModel, place: usize) -> Option<usize> {
    // Surveyed points stand in the order of the model's, without those that are lost.
    let PointSource::GroundControl(_) = model.points[place] else { return None };
    let before =
        (0..place).filter(|other| matches!(model.points[*other], PointSource::GroundControl(_)) && model.adjusted.points[*other].is_some());
    Some(before.count())
}

fn adjusted_observations(run: &BlockRun, model: &ReconstructedModel, place: usize) -> Vec<ObservationDetail> {
    let position = model.adjusted.block.points[place];
    let of_rays = model.adjusted.block.rays.iter().zip(&model.adjusted.rays).zip(&model.rays).filter(|((ray, _), _)| ray.point == place);
    let adjusted = of_rays.map(|((ray, statistics), source)| ObservationDetail {
        by_hand: source.by_hand,
        residual_px: Some(statistics.residual_px),
        redundancy: statistics.redundancy,
        w: statistics.w,
        detectable_px: statistics.detectable_px,
        ..found(model.images[ray.image], [ray.x_px, ray.y_px], part(statistics.verdict))
    });
    let rejected = model.rejected.iter().filter(|ray| ray.point == place);
    let rejected = rejected
        .map(|ray| ObservationDetail { by_hand: ray.measured, ..found(model.images[ray.image], [ray.x_px, ray.y_px], rejection(ray)) });
    let mut all: Vec<ObservationDetail> = adjusted.chain(rejected).collect();
    for observation in &mut all {
        observation.predicted_px = computed(run, observation.image, &position);
        let [x, y] = [observation.x_px, observation.y_px];
        observation.residual_px = observation.residual_px.or(observation.predicted_px.map(|[px, py]| [x - px, y - py]));
    }
    all.sort_by_key(|observation| observation.image);
    all
}

fn found(image: usize, [x_px, y_px]: [f64; 2], part: ObservationPart) -> ObservationDetail {
    ObservationDetail {
        image,
        x_px,
        y_px,
        part,
        by_hand: false,
        residual_px: None,
        redundancy: None,
        w: None,
        detectable_px: [None; 2],
        predicted_px: None,
    }
}

fn part(verdict: ObservationVerdict) -> ObservationPart {
    match verdict {
        ObservationVerdict::Accepted => ObservationPart::Accepted,
        ObservationVerdict::GrossError => ObservationPart::GrossError,
        ObservationVerdict::Behind => ObservationPart::Behind,
        ObservationVerdict::LostPoint => ObservationPart::LostPoint,
    }
}

fn rejection(ray: &RejectedObservation) -> ObservationPart {
    if ray.by_hand { ObservationPart::RejectedByHand } else { ObservationPart::DoesNotFit }
}

/// Where an image should show a place, if it does.
fn predicted(run: &BlockRun, image: usize, place: &[f64; 3]) -> Option<[f64; 2]> {
    let at = computed(run, image, place)?;
    camera_of(run, image).sees(at[0], at[1]).then_some(at)
}

/// Where a place lies in an image, inside its borders or not; `None` behind it.
fn computed(run: &BlockRun, image: usize, place: &[f64; 3]) -> Option<[f64; 2]> {
    let ModelImage { pose: Some(pose), .. } = &run.model.images[image] else { return None };
    let is_before = Pose::to_photo(pose, place)[2] < 0.0;
    is_before.then(|| project(&camera_of(run, image).values(), pose, place)).filter(|at| at.iter().all(|value| value.is_finite()))
}

fn camera_of(run: &BlockRun, image: usize) -> &Camera {
    &run.model.cameras[run.model.images[image].camera]
}
