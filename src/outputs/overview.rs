//! A finished block at a glance: what the page shows of it.

use super::check_summary::CheckSummary;
use super::given_points::given_control;
use super::images::{ImageRow, image_rows};
use super::in_system::InSystem;
use super::pairs::{PairRow, pair_rows};
use super::precision::point_errors;
use super::summary::{NamedReason, outcome_counts};
use super::verdict::BlockVerdict;
use super::warning::{OverviewWarning, overview_warnings};
use super::with_text::WithText;
use crate::{
    BlockModel, BlockRun, Camera, Error, GeographicOrigin, Geoid, ObjectPoint, RefinementOutcome, Remark, SurveyedPoint, VarianceComponent,
};
use serde::Serialize;
use std::collections::BTreeMap;

/// What is shown of a finished block, but for its points: [`PointColumns`].
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct BlockOverview {
    pub verdict: WithText<BlockVerdict>,
    pub images: Vec<ImageRow>,
    pub skipped: Vec<NamedReason>,
    /// Masks that belong to no image.
    pub unused_masks: Vec<String>,
    /// Images that image measurements name and that are not in the block.
    pub unknown_images: Vec<String>,
    /// What of the input was not taken as it was given, or is hardly right.
    pub remarks: Vec<WithText<Remark>>,
    pub cameras: Vec<CameraRow>,
    pub pairs: Vec<PairRow>,
    /// Images that are connected with each other, the largest group first.
    pub groups: Vec<Vec<u32>>,
    /// Tie points before some were chosen; absent where an older project file does not say.
    pub found: Option<FoundPoints>,
    /// How many observations had each outcome; absent where none were refined.
    pub refinement: Option<BTreeMap<RefinementOutcome, usize>>,
    /// Of the points of the model that is written, by their number of rays.
    pub by_rays: Vec<RayCount>,
    /// Oriented images.
    pub oriented: usize,
    /// Root mean square length of the residuals of all observations in px; absent before the adjustment.
    pub rmse_px: Option<f64>,
    pub sigma0_px: Option<f64>,
    /// How large errors are beside the stated standard errors, by the residuals; empty where none are stated.
    pub components: Vec<VarianceComponent>,
    /// In the system of the results; absent without check points.
    pub checks: Option<CheckSummary>,
    /// The surveyed points of the model that is written.
    pub surveyed: Vec<SurveyedPoint>,
    /// How many surveyed points the block was found with: edits count those that they add from there on.
    pub given_control: usize,
    /// Where its system touches the earth; absent where that is not known.
    pub origin: Option<GeographicOrigin>,
    /// The coordinate reference system that was chosen for control points and results, as it was given.
    pub crs: Option<String>,
    /// The height of the zero of its heights above the ellipsoid of WGS 84, in the middle of the block; absent where it is not known.
    pub geoid_m: Option<f64>,
    /// The part about the block of the geoid from which they count; absent where none was given.
    pub geoid: Option<Geoid>,
    /// Changes by hand.
    pub edits: usize,
    /// What is weak about the block.
    pub warnings: Vec<WithText<OverviewWarning>>,
}

/// A camera of a finished block.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct CameraRow {
    pub label: String,
    pub images: usize,
    /// What was known before; absent where its focal length was not.
    pub given: Option<Camera>,
    /// As the block adjusted it; absent where no image of it is oriented.
    pub calibrated: Option<Camera>,
    /// Standard error of the focal length.
    pub focal_error_px: Option<f64>,
}

/// Tie points and their observations.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct FoundPoints {
    pub points: usize,
    pub rays: usize,
}

/// Points of one number of rays.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct RayCount {
    pub rays: usize,
    pub points: usize,
    /// Root mean square length of the residuals of their observations; absent before the adjustment.
    pub rmse_px: Option<f64>,
}

/// The points of the model that is written, one number or three of each.
#[derive(Debug, Clone, PartialEq)]
pub struct PointColumns {
    /// What the points are called by.
    pub numbers: Vec<u32>,
    pub rays: Vec<u16>,
    /// NaN where a point is not adjusted.
    pub rmse_px: Vec<f64>,
    /// NaN where a point is not intersected.
    pub positions: Vec<[f64; 3]>,
    /// Standard errors of the positions; NaN where there are none.
    pub errors: Vec<[f64; 3]>,
    /// Probability, 0..1, that all rays belong together.
    pub confidence: Vec<f64>,
}

impl BlockOverview {
    /// The overview of a block.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for pairs of images that do not exist.
    pub fn new(run: &BlockRun) -> Result<Self, Error> {
        let (pairs, groups) = pair_rows(run)?;
        let shown = InSystem::of(run);
        let assembly = run.reconstruction.as_ref().ok();
        let adjusted = assembly.and_then(|assembly| assembly.models.first()).map(|model| &model.adjusted);
        let by_rays = match adjusted {
            Some(adjusted) => adjusted
                .rmse_by_rays
                .iter()
                .map(|group| RayCount { rays: group.rays, points: group.points, rmse_px: Some(group.rmse_px) })
                .collect(),
            None => rmse_by_rays(&run.model),
        };
        Ok(Self {
            verdict: WithText::of(BlockVerdict::of(run)),
            images: image_rows(run),
            skipped: run.skipped.iter().map(NamedReason::of).collect(),
            unused_masks: run.unused_masks.clone(),
            unknown_images: run.unknown_images.clone(),
            remarks: shown.remarks().into_iter().map(WithText::of).collect(),
            cameras: camera_rows(run),
            pairs,
            groups,
            found: run.points.as_ref().map(|points| FoundPoints { points: points.count, rays: points.rays }),
            refinement: run.refinement.as_ref().map(outcome_counts),
            by_rays,
            oriented: run.model.images.iter().filter(|image| image.pose.is_some()).count(),
            rmse_px: adjusted.map_or_else(|| rmse_px(&run.model.points.iter().collect::<Vec<_>>()), |adjusted| Some(adjusted.rmse_px)),
            sigma0_px: adjusted.and_then(|adjusted| adjusted.sigma0_px),
            components: adjusted.map(|adjusted| adjusted.components.clone()).unwrap_or_default(),
            checks: CheckSummary::of(&shown.surveyed()),
            surveyed: surveyed(run).to_vec(),
            given_control: given_control(run),
            origin: run.model.origin,
            crs: run.input.settings.placing.crs.clone(),
            geoid_m: shown.system().and_then(|system| system.geoid_m),
            geoid: run.geoid.clone(),
            edits: run.edits().len(),
            warnings: overview_warnings(run).into_iter().map(WithText::of).collect(),
        })
    }
}

impl PointColumns {
    /// The points of a block.
    pub fn new(run: &BlockRun) -> Self {
        let none = [f64::NAN; 3];
        let points = &run.model.points;
        Self {
            numbers: run.model.point_numbers(),
            rays: points.iter().map(|point| point.rays.len() as u16).collect(),
            rmse_px: points.iter().map(|point| point.rmse_px.unwrap_or(f64::NAN)).collect(),
            positions: points.iter().map(|point| point.position.unwrap_or(none)).collect(),
            errors: point_errors(run).into_iter().map(|errors| errors.map_or(none, |known| known.errors)).collect(),
            confidence: points.iter().map(|point| point.confidence).collect(),
        }
    }
}

fn camera_rows(run: &BlockRun) -> Vec<CameraRow> {
    let model = run.reconstruction.as_ref().ok().and_then(|assembly| assembly.models.first());
    let error = |camera: usize| {
        let place = model?.cameras.iter().position(|own| *own == camera)?;
        model?.adjusted.cameras.get(place)?.standard_errors[0]
    };
    let rows = run.cameras.iter().zip(&run.model.cameras).enumerate().map(|(index, (initial, adjusted))| {
        let own = || run.model.images.iter().filter(move |image| image.camera == index);
        CameraRow {
            label: initial.label.clone(),
            images: own().count(),
            given: initial.known(),
            calibrated: own().any(|image| image.pose.is_some()).then_some(*adjusted),
            focal_error_px: error(index),
        }
    });
    rows.collect()
}

/// The surveyed points of the model that is written.
pub(super) fn surveyed(run: &BlockRun) -> &[SurveyedPoint] {
    let model = run.reconstruction.as_ref().ok().and_then(|assembly| assembly.models.first());
    model.map_or(&[], |model| &model.surveyed)
}

fn rmse_by_rays(model: &BlockModel) -> Vec<RayCount> {
    let mut groups: BTreeMap<usize, Vec<&ObjectPoint>> = BTreeMap::new();
    model.points.iter().for_each(|point| groups.entry(point.rays.len()).or_default().push(point));
    groups.into_iter().map(|(rays, points)| RayCount { rays, points: points.len(), rmse_px: rmse_px(&points) }).collect()
}

/// Root mean square length of the residuals of all observations; absent where points are not adjusted.
fn rmse_px(points: &[&ObjectPoint]) -> Option<f64> {
    let known = || points.iter().filter_map(|point| Some((point.rays.len() as f64, point.rmse_px?)));
    let rays: f64 = known().map(|(rays, _)| rays).sum();
    (rays > 0.0).then(|| (known().map(|(rays, rmse)| rays * (rmse * rmse)).sum::<f64>() / rays).sqrt())
}
