//! From a grown model to an adjusted block: all points, those that it is adjusted by, the bundle adjustment, those that are given.

use super::choosing::{adjusting_points, given};
use super::growth::Growth;
use super::level::{Level, is_open, uncertainty_deg};
use super::material::Material;
use super::net::Net;
use super::result::{ObservationSource, PointSource, ReconstructedModel, RejectedObservation};
use super::review::{Placing, warnings};
use super::surveyed::surveyed_points;
use super::warning::UnorientedReason;
use crate::adjustment::{AdjustmentOptions, AdjustmentResult, Block, BlockImage, BlockObservation, ControlPoint, Datum, adjust_block};
use crate::{Cause, ControlRole, Error};

/// Rays without which an image falls out of the finished block.
const LEAST_RAYS: usize = 6;
/// Times that the block is adjusted without an image that it does not determine.
const WITHOUT: usize = 8;
/// Standard error of a coordinate in px below which marks weigh no less.
const LEAST_SIGMA_PX: f64 = 0.01;

/// A finished model, with the reasons why images that were open to it are not in it.
pub(super) struct Finished {
    pub model: ReconstructedModel,
    pub unoriented: Vec<(usize, UnorientedReason)>,
}

/// Finishes a model; images of others are not open to it.
///
/// # Errors
/// As [`adjust_block`].
pub(super) fn finish(material: &mut Material<'_>, grown: &Net<'_>, is_open: &[bool]) -> Result<Finished, Error> {
    let rays = material.all.take().unwrap_or_else(|| material.all_rays());
    let mut net = Net::new(&rays, material.camera_of, material.longer_side_px, grown.cameras.clone(), material.options);
    (net.limit_px, net.poses) = (grown.limit_px, grown.poses.clone());
    let mut growth = Growth::new(net, material.options, material.priors, is_open.to_vec());
    let most_cosine = growth.most_cosine();
    (0..rays.points()).for_each(|point| {
        growth.net.intersect(point, most_cosine);
    });
    growth.orient_rest();
    let mut lost = vec![None; is_open.len()];
    let finished = adjusted(material, &mut growth.net, &mut lost).map(|model| {
        let left = (0..is_open.len()).filter(|image| is_open[*image] && model.images.binary_search(image).is_err());
        let reason = |image: usize| lost[image].unwrap_or_else(|| growth.reason(image));
        Finished { unoriented: left.map(|image| (image, reason(image))).collect(), model }
    });
    material.all = Some(rays);
    finished
}

/// Adjusts the model, without images that it does not determine; `lost` says of each why it is not in it.
fn adjusted(material: &Material<'_>, net: &mut Net<'_>, lost: &mut [Option<UnorientedReason>]) -> Result<ReconstructedModel, Error> {
    let mut attempt = 0;
    loop {
        drop_images(net, LEAST_RAYS, lost);
        let draft = Draft::new(material, net)?;
        match draft.adjust(material) {
            Ok((adjusted, placing)) => return given(material, draft.model(material, adjusted, placing)),
            // What an image hangs by may fall in data snooping.
            Err(error @ (Error::Degenerate { .. } | Error::UndeterminedImage { .. })) if attempt < WITHOUT && net.oriented() > 2 => {
                attempt += 1;
                let Some(image) = undetermined(&error, &draft.images, net) else { return Err(error) };
                lost[image] = Some(UnorientedReason::Undetermined { rays: net.accepted_of(image) });
                net.lose(image);
            }
            Err(error) => return Err(error),
        }
    }
}

/// Which of the images of an adjustment its error names, and otherwise the one with fewest rays.
fn undetermined(error: &Error, images: &[usize], net: &Net<'_>) -> Option<usize> {
    let weakest = images.iter().copied().min_by_key(|image| net.accepted_of(*image));
    if let Error::UndeterminedImage { image, .. } = error { images.get(*image).copied().or(weakest) } else { weakest }
}

/// Takes out images with fewer accepted rays, as long as there are any.
fn drop_images(net: &mut Net<'_>, least: usize, lost: &mut [Option<UnorientedReason>]) {
    while let Some(image) = (0..net.poses.len()).find(|image| net.poses[*image].is_some() && net.accepted_of(*image) < least) {
        lost[image] = Some(UnorientedReason::Lost { rays: net.accepted_of(image) });
        net.lose(image);
    }
}

/// A block before its adjustment, with what its parts are.
struct Draft {
    block: Block,
    images: Vec<usize>,
    cameras: Vec<usize>,
    points: Vec<PointSource>,
    rays: Vec<ObservationSource>,
    rejected: Vec<RejectedObservation>,
    /// Of a mark beside that of any other ray.
    mark_weight: f64,
}

impl Draft {
    fn new(material: &Material<'_>, net: &Net<'_>) -> Result<Self, Error> {
        let images: Vec<usize> = (0..net.poses.len()).filter(|image| net.poses[*image].is_some()).collect();
        let mut cameras: Vec<usize> = images.iter().map(|image| net.camera_of[*image]).collect();
        cameras.sort_unstable();
        cameras.dedup();
        let place = |list: &[usize], index: usize| list.binary_search(&index).unwrap_or_default();
        let sigma_px = material.options.adjustment.sigma0_px.unwrap_or_else(|| net.sigma_px()).max(LEAST_SIGMA_PX);
        let mark_weight = sigma_px / material.options.mark_sigma_px * (sigma_px / material.options.mark_sigma_px);
        let mut draft =
            Self { block: Block::default(), images, cameras, points: Vec::new(), rays: Vec::new(), rejected: Vec::new(), mark_weight };
        draft.block.cameras = draft.cameras.iter().map(|camera| net.cameras[*camera]).collect();
        for image in &draft.images {
            let Some(pose) = net.poses[*image] else { continue };
            let camera = place(&draft.cameras, net.camera_of[*image]);
            let gnss = material.frame.images[*image];
            draft.block.images.push(BlockImage { camera, pose, gnss, axis: None });
        }
        for point in adjusting_points(material, net)? {
            draft.add_point(material, net, point);
        }
        Ok(draft)
    }

    /// Adds a point with its rays.
    fn add_point(&mut self, material: &Material<'_>, net: &Net<'_>, point: usize) {
        let Some(position) = net.points[point] else { return };
        let index = self.block.points.len();
        let multi_ray = material.points.rays(point);
        let control = point.checked_sub(material.points.len());
        self.points.push(control.map_or(PointSource::TiePoint(point as u32), PointSource::GroundControl));
        self.block.points.push(position);
        if let Some(control) = control.filter(|control| material.description.control[*control].role == ControlRole::Control) {
            let (position, sigma) = material.frame.control[control];
            self.block.control.push(ControlPoint { point: index, position, sigma });
        }
        for (k, ray) in net.rays.of_point(point).enumerate() {
            let Ok(image) = self.images.binary_search(&(net.rays.image[ray] as usize)) else { continue };
            let [x_px, y_px] = net.rays.at[ray];
            if net.accepted[ray] {
                let weight = if control.is_some() { self.mark_weight } else { 1.0 };
                self.block.rays.push(BlockObservation { image, point: index, x_px, y_px, weight });
                let known = multi_ray.get(k);
                self.rays.push(ObservationSource { feature: known.map(|r| r.feature), confidence: known.map_or(1.0, |r| r.confidence) });
            } else {
                self.rejected.push(RejectedObservation { image, point: index, x_px, y_px, residual_px: net.residual(ray) });
            }
        }
    }

    /// Adjusts in the datum that was asked for, or in the best that the observed positions allow, levelled where they leave the rotation of
    /// the whole block open; tells how it is placed.
    fn adjust(&self, material: &Material<'_>) -> Result<(AdjustmentResult, Placing), Error> {
        let options = material.options;
        let with = |block: &Block, datum: Datum| adjust_block(block, &AdjustmentOptions { datum, ..options.adjustment.clone() });
        if let Some(datum) = options.datum {
            let placing = if datum == Datum::Free { Placing::Free { cause: None } } else { Placing::Observed };
            return with(&self.block, datum).map(|adjusted| (adjusted, placing));
        }
        let gnss = self.block.images.iter().filter(|image| image.gnss.is_some()).count();
        let control = self.block.control.len();
        let datum = match (gnss >= 3, control >= 3) {
            (true, _) if control > 0 => Datum::GnssAndControl,
            (true, _) => Datum::Gnss,
            (false, true) => Datum::Control,
            (false, false) => Datum::Free,
        };
        let level = || {
            let views: Vec<_> = self.images.iter().map(|image| material.frame.views[*image]).collect();
            Level::of(&self.block, &views).filter(|_| datum == Datum::Gnss)
        };
        match with(&self.block, datum) {
            Ok(plain) if datum == Datum::Gnss && is_open(&plain) => {
                let error_deg = uncertainty_deg(&plain);
                let levelled = level().and_then(|level| {
                    let adjusted = with(&level.block, datum).ok().filter(|adjusted| level.is_plausible(&plain, adjusted))?;
                    Some((adjusted, Placing::Levelled { recorded: level.recorded, error_deg }))
                });
                Ok(levelled.unwrap_or((plain, Placing::Observed)))
            }
            Ok(adjusted) if datum == Datum::Free => Ok((adjusted, Placing::Free { cause: None })),
            Ok(adjusted) => Ok((adjusted, Placing::Observed)),
            // Poor positions along one strip hardly tell its roll: the adjustment in their system may creep without end. Wrong ones pull images
            // off their rays.
            Err(Error::NotConverged { cause, .. } | Error::Degenerate { cause, .. } | Error::UndeterminedImage { cause, .. })
                if datum != Datum::Free =>
            {
                let levelled = level().filter(|_| !matches!(cause, Cause::NoPosition)).and_then(|level| {
                    let adjusted = with(&level.block, datum).ok().filter(|adjusted| level.is_kept(adjusted))?;
                    Some((adjusted, Placing::Levelled { recorded: level.recorded, error_deg: None }))
                });
                levelled.map_or_else(|| with(&self.block, Datum::Free).map(|adjusted| (adjusted, Placing::Free { cause: Some(cause) })), Ok)
            }
            Err(error) => Err(error),
        }
    }

    fn model(self, material: &Material<'_>, adjusted: AdjustmentResult, placing: Placing) -> ReconstructedModel {
        let guessed = |camera: &usize| material.description.cameras[*camera].focal_px.is_none();
        let mut model = ReconstructedModel {
            guessed_focal: self.cameras.iter().copied().filter(guessed).collect(),
            images: self.images,
            cameras: self.cameras,
            points: self.points,
            rays: self.rays,
            rejected: self.rejected,
            adjusted,
            surveyed: Vec::new(),
            in_system: !matches!(placing, Placing::Free { .. }),
            warnings: Vec::new(),
        };
        model.surveyed = surveyed_points(&model, material.description, material.frame);
        model.warnings = warnings(&model, material.description, material.frame, placing);
        model
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Computation;
    use crate::reconstruction::options::ReconstructionOptions;
    use crate::reconstruction::rays::Rays;

    #[test]
    fn the_image_that_an_error_names_is_lost_and_not_the_weakest() {
        let rays = Rays::new([[0, 2], [0, 2], [0, 3]].iter().map(|images| images.iter().map(|image| (*image, [1.0, 1.0]))), 4);
        let mut net = Net::new(&rays, &[0; 4], &[100.0], Vec::new(), &ReconstructionOptions::default());
        net.accepted.iter_mut().for_each(|accepted| *accepted = true);
        let images = [0, 2, 3];
        let named = Error::UndeterminedImage { computation: Computation::BundleAdjustment, image: 1, cause: Cause::NoPosition };
        assert_eq!(undetermined(&named, &images, &net), Some(2));
        let unnamed = Error::Degenerate { computation: Computation::BundleAdjustment, cause: Cause::PointInPlane };
        assert_eq!(undetermined(&unnamed, &images, &net), Some(3));
    }
}
