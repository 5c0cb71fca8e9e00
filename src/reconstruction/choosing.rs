//! The choice among intersected points: those that the block is adjusted by, and those of them that are given.
//!
//! Several dozen points an image describe a block and are too few to calibrate its cameras: a few hundred determine orientation and cameras,
//! the others are left to the search for gross errors alone.

use super::material::{GROWING_CONNECTION, Material};
use super::net::Net;
use super::result::{PointSource, ReconstructedModel};
use crate::Error;
use crate::adjustment::ObservationVerdict;
use crate::tracks::{FeatureObservation, SelectOptions, TiePoints, select_points};

/// Intersected points: all, or where points are chosen as many as the model grew by, by their accepted rays; surveyed ones in any case.
///
/// # Errors
/// As [`select_points`].
pub(super) fn adjusting_points(material: &Material<'_>, net: &Net<'_>) -> Result<Vec<usize>, Error> {
    let intersected = (0..net.rays.points()).filter(|point| net.points[*point].is_some());
    let (multi_ray, surveyed): (Vec<usize>, Vec<usize>) = intersected.partition(|point| *point < material.points.len());
    let Some(selection) = &material.options.selection else { return Ok([multi_ray, surveyed].concat()) };
    let wanted = SelectOptions {
        per_image: selection.per_image.max(material.options.growing_rays),
        per_connection: selection.per_connection.max(GROWING_CONNECTION),
    };
    let mut good = TiePoints::with_capacity(multi_ray.len(), 0);
    for point in &multi_ray {
        let accepted = material.points.rays(*point).iter().zip(net.rays.of_point(*point)).filter(|(_, ray)| net.accepted[*ray]);
        good.push(accepted.map(|(ray, _)| *ray), material.points.confidence(*point));
    }
    let chosen = select_points(&good, material.features, &wanted)?.points;
    Ok(chosen.iter().map(|point| multi_ray[*point as usize]).chain(surveyed).collect())
}

/// An adjusted model with the points that are to be given: all, or those that are chosen by the rays that the adjustment accepted.
///
/// # Errors
/// As [`select_points`].
pub(super) fn given(material: &Material<'_>, model: ReconstructedModel) -> Result<ReconstructedModel, Error> {
    let Some(selection) = &material.options.selection else { return Ok(model) };
    let mut accepted: Vec<Vec<FeatureObservation>> = vec![Vec::new(); model.points.len()];
    for ((ray, statistics), known) in model.adjusted.block.rays.iter().zip(&model.adjusted.rays).zip(&model.rays) {
        if let (ObservationVerdict::Accepted, Some(feature)) = (statistics.verdict, known.feature) {
            accepted[ray.point].push(FeatureObservation { image: model.images[ray.image] as u32, feature, confidence: known.confidence });
        }
    }
    let (mut multi_ray, mut surveyed) = (Vec::new(), Vec::new());
    let mut good = TiePoints::with_capacity(model.points.len(), 0);
    for (point, known) in model.points.iter().enumerate() {
        match known {
            PointSource::TiePoint(index) => {
                if model.adjusted.points[point].is_some() {
                    good.push(accepted[point].iter().copied(), material.points.confidence(*index as usize));
                    multi_ray.push(point);
                }
            }
            PointSource::GroundControl(_) => surveyed.push(point),
        }
    }
    let chosen = select_points(&good, material.features, selection)?.points;
    let kept: Vec<usize> = chosen.iter().map(|point| multi_ray[*point as usize]).chain(surveyed).collect();
    Ok(model.with_points(&kept))
}

impl ReconstructedModel {
    /// With some of its points (ascending) and their rays alone.
    fn with_points(self, kept: &[usize]) -> Self {
        let (adjusted, rays) = self.adjusted.with_points(kept);
        let rejected = self.rejected.into_iter();
        let rejected = rejected.filter_map(|mut ray| {
            kept.binary_search(&ray.point).ok().map(|point| {
                ray.point = point;
                ray
            })
        });
        Self {
            points: kept.iter().map(|point| self.points[*point]).collect(),
            rays: rays.iter().map(|ray| self.rays[*ray]).collect(),
            rejected: rejected.collect(),
            adjusted,
            ..self
        }
    }
}
