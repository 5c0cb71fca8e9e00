//! The figures of the orientation of a block and of each of its models.

use super::check_summary::CheckSummary;
use super::in_system::InSystem;
use super::place_group::PlaceGroup;
use super::with_text::WithText;
use crate::math::median;
use crate::{
    BlockRun, BlockWarning, Camera, Datum, Factors95, Failure, GeographicOrigin, ObservationGroup, ObservationVerdict, RayCountRmse,
    ReconstructedModel, SystematicError, SystematicStatistics, UnorientedReason, VarianceComponent,
};
use serde::Serialize;

/// The orientation of a block.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum OrientationSummary {
    Failed { oriented: usize, reason: WithText<Failure> },
    Done(Box<Oriented>),
}

/// The orientation of a block that has one.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Oriented {
    pub oriented: usize,
    pub points: usize,
    pub rays: usize,
    pub models: Vec<ModelSummary>,
    pub cameras: Vec<Camera>,
    pub unoriented: Vec<NotOriented>,
    pub origin: Option<GeographicOrigin>,
}

/// A model of a block.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ModelSummary {
    pub images: usize,
    pub names: Vec<String>,
    pub in_system: bool,
    pub datum: Datum,
    pub sigma0_px: Option<f64>,
    pub rmse_px: f64,
    pub rmse_by_rays: Vec<RayCountRmse>,
    pub degrees_of_freedom: usize,
    /// By what standard errors grow for intervals, ellipses and ellipsoids of 95 %; absent without standard errors.
    pub factors_95: Option<Factors95>,
    /// Medians over the images of the total standard errors of positions and of ω φ κ, along and about the axes of the adjustment; absent without
    /// statistics.
    pub position_errors_m: Option<[f64; 3]>,
    pub angle_errors_deg: Option<[f64; 3]>,
    pub rays_rejected: usize,
    /// Root mean square residuals of the GNSS positions that took part, of each coordinate; absent without any.
    pub position_rmse_m: Option<[f64; 3]>,
    /// How large errors are beside the stated standard errors, by the residuals.
    pub components: Vec<ComponentSummary>,
    /// Systematic errors of GNSS positions that were to be estimated; absent where none was.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub systematic: Vec<SystematicSummary>,
    /// Absent without check points.
    pub checks: Option<CheckSummary>,
    pub warnings: Vec<WithText<BlockWarning>>,
}

/// What the residuals say of the stated standard errors of some observations.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ComponentSummary {
    /// Of which, in words.
    pub name: String,
    #[serde(flatten)]
    pub component: VarianceComponent,
}

/// A systematic error of GNSS positions, and what became of it.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct SystematicSummary {
    /// In words.
    pub name: String,
    /// The images of its strip, from the first to the last; absent where it is that of no strip.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub images: Vec<String>,
    #[serde(flatten)]
    pub statistics: SystematicStatistics,
}

impl SystematicSummary {
    fn of_model(model: &ReconstructedModel, name: impl Fn(usize) -> String) -> Vec<Self> {
        let Some(systematic) = &model.adjusted.systematic else { return Vec::new() };
        let images = |error: SystematicError| match error {
            SystematicError::StripOffset { strip } | SystematicError::StripDrift { strip } => {
                systematic.strips[strip].images.iter().map(|image| name(model.images[*image])).collect()
            }
            SystematicError::LeverArm { .. } | SystematicError::Offset => Vec::new(),
        };
        let of_error = |statistics: &SystematicStatistics| Self {
            name: statistics.error.to_string(),
            images: images(statistics.error),
            statistics: *statistics,
        };
        systematic.errors.iter().map(of_error).collect()
    }
}

/// An image that is in no model, and why.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct NotOriented {
    pub name: String,
    pub reason: WithText<UnorientedReason>,
}

pub(super) fn orientation(run: &BlockRun, shown: &InSystem<'_>, name: impl Fn(usize) -> String) -> OrientationSummary {
    let oriented = run.model.images.iter().filter(|image| image.pose.is_some()).count();
    let assembly = match &run.reconstruction {
        Ok(assembly) => assembly,
        Err(failure) => return OrientationSummary::Failed { oriented: 0, reason: WithText::of(failure.clone()) },
    };
    let unoriented = assembly.unoriented.iter().map(|image| NotOriented { name: name(image.image), reason: WithText::of(image.reason) });
    OrientationSummary::Done(Box::new(Oriented {
        oriented,
        points: run.model.points.len(),
        rays: run.model.points.iter().map(|point| point.rays.len()).sum(),
        models: assembly.models.iter().map(|model| model_summary(model, shown, &name)).collect(),
        cameras: run.model.cameras.clone(),
        unoriented: unoriented.collect(),
        origin: run.model.origin,
    }))
}

fn model_summary(model: &ReconstructedModel, shown: &InSystem<'_>, name: impl Fn(usize) -> String) -> ModelSummary {
    let adjusted = &model.adjusted;
    let residuals: Vec<[f64; 3]> =
        adjusted.images.iter().filter_map(|image| image.gnss.filter(|gps| gps.accepted).map(|gps| gps.residual)).collect();
    let root_mean_square = |axis: usize| (residuals.iter().map(|r| r[axis] * r[axis]).sum::<f64>() / residuals.len() as f64).sqrt();
    ModelSummary {
        images: model.images.len(),
        names: model.images.iter().map(|image| name(*image)).collect(),
        in_system: model.in_system,
        datum: adjusted.datum,
        sigma0_px: adjusted.sigma0_px,
        rmse_px: adjusted.rmse_px,
        rmse_by_rays: adjusted.rmse_by_rays.clone(),
        degrees_of_freedom: adjusted.degrees_of_freedom,
        factors_95: adjusted.factors_95(),
        position_errors_m: medians(adjusted.images.iter().filter_map(|image| image.position_errors)),
        angle_errors_deg: medians(adjusted.images.iter().filter_map(|image| image.angle_errors_deg)),
        rays_rejected: model.rejected.len() + adjusted.rays.iter().filter(|ray| ray.verdict != ObservationVerdict::Accepted).count(),
        position_rmse_m: (!residuals.is_empty()).then(|| [0, 1, 2].map(root_mean_square)),
        components: adjusted
            .components
            .iter()
            .map(|component| ComponentSummary { name: name_of(component.group, model), component: *component })
            .collect(),
        systematic: SystematicSummary::of_model(model, &name),
        checks: CheckSummary::of(&shown.points_of(model)),
        warnings: model.warnings.iter().cloned().map(WithText::of).collect(),
    }
}

/// Control points may be places of an orthophoto.
fn name_of(group: ObservationGroup, model: &ReconstructedModel) -> String {
    PlaceGroup::of(group, &model.surveyed).map_or_else(|| group.to_string(), |group| group.to_string())
}

/// Of each of three values; absent without any.
fn medians(all: impl Iterator<Item = [f64; 3]>) -> Option<[f64; 3]> {
    let all: Vec<[f64; 3]> = all.collect();
    let of = |axis: usize| median(&mut all.iter().map(|values| values[axis]).collect::<Vec<f64>>());
    Some([of(0)?, of(1)?, of(2)?])
}
