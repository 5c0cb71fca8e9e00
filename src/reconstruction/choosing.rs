//! The choice among intersected points: those that the block is adjusted by, and those of them that are given.
//!
//! Several dozen points an image describe a block and are too few to calibrate its cameras: a few hundred determine orientation and cameras,
//! the others are left to the search for gross errors alone.

use super::material::{GROWING_CONNECTION, Material};
use super::net::Net;
use super::result::{PointSource, ReconstructedModel, SupportingPoint, SupportingRay};
use crate::Error;
use crate::adjustment::{Block, BlockObservation, ObservationVerdict};
use crate::tracks::{FeatureObservation, SelectOptions, TiePoints, select_points};

/// Intersected points: all, or where points are chosen as many as the model grew by, by their accepted rays; surveyed ones in any case.
///
/// # Errors
/// As [`select_points`].
pub(super) fn adjusting_points(material: &Material<'_>, net: &Net<'_>) -> Result<Vec<usize>, Error> {
    let intersected = (0..net.rays.points()).filter(|point| net.points[*point].is_some());
    let (multi_ray, surveyed): (Vec<usize>, Vec<usize>) = intersected.partition(|point| *point < material.points.len());
    let Some(selection) = &material.known.options.selection else { return Ok([multi_ray, surveyed].concat()) };
    let wanted = SelectOptions {
        per_image: selection.per_image.max(material.known.options.growing_rays),
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
    let Some(selection) = &material.known.options.selection else { return Ok(model) };
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
            // Whatever was surveyed or measured by hand is given.
            PointSource::GroundControl(_) | PointSource::Manual(_) => surveyed.push(point),
        }
    }
    let chosen = select_points(&good, material.features, selection)?.points;
    let kept: Vec<usize> = chosen.iter().map(|point| multi_ray[*point as usize]).chain(surveyed).collect();
    Ok(model.with_points(&kept))
}

impl ReconstructedModel {
    /// With some of its points (ascending) and their rays alone; the other tie points support them.
    pub(super) fn with_points(self, kept: &[usize]) -> Self {
        let supporting = self.supported_without(kept);
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
            supporting,
            ..self
        }
    }

    /// Whether it was adjusted by more points than it has: a project of a former version did not keep them. Each observation gives two equations at most.
    pub(crate) fn lacks_support(&self) -> bool {
        self.supporting.is_empty() && self.adjusted.degrees_of_freedom > 2 * self.adjusted.rays.len()
    }

    /// The adjusted block with the tie points that support it behind its own, and which of its observations took part.
    pub(crate) fn with_support(&self) -> (Block, Vec<bool>) {
        let mut block = self.adjusted.block.clone();
        let mut accepted: Vec<bool> = self.adjusted.rays.iter().map(|ray| ray.verdict == ObservationVerdict::Accepted).collect();
        for supporting in &self.supporting {
            let point = block.points.len();
            block.points.push(supporting.position);
            for ray in &supporting.rays {
                let (image, x_px, y_px) = (ray.image, f64::from(ray.x_px), f64::from(ray.y_px));
                block.rays.push(BlockObservation { image, point, x_px, y_px, weight: 1.0, sigma_px: None });
                accepted.push(!ray.rejected);
            }
        }
        (block, accepted)
    }

    /// The tie points beside some (ascending) by which it was adjusted too.
    fn supported_without(&self, kept: &[usize]) -> Vec<SupportingPoint> {
        let block = &self.adjusted.block;
        let mut place = vec![None; self.points.len()];
        let mut supporting = Vec::new();
        for (index, source) in self.points.iter().enumerate().filter(|(index, _)| kept.binary_search(index).is_err()) {
            let PointSource::TiePoint(point) = *source else { continue };
            place[index] = Some(supporting.len());
            supporting.push(SupportingPoint { point, position: block.points[index], rays: Vec::new() });
        }
        for (ray, statistics) in block.rays.iter().zip(&self.adjusted.rays) {
            let Some(point) = place[ray.point] else { continue };
            let rejected = statistics.verdict != ObservationVerdict::Accepted;
            supporting[point].rays.push(SupportingRay { image: ray.image, x_px: ray.x_px as f32, y_px: ray.y_px as f32, rejected });
        }
        supporting
    }
}
