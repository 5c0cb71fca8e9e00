//! From a grown model to an adjusted block: all points, those that it is adjusted by, the bundle adjustment, those that are given.

use super::choosing::{adjusting_points, given};
use super::draft::Draft;
use super::growth::Growth;
use super::material::Material;
use super::net::Net;
use super::result::{ObservationSource, PointSource, ReconstructedModel, RejectedObservation};
use super::warning::UnorientedReason;
use crate::Error;
use crate::adjustment::BlockObservation;

/// Rays without which an image falls out of the finished block.
pub(super) const LEAST_RAYS: usize = 6;
/// Times that the block is adjusted without an image that it does not determine.
pub(super) const WITHOUT: usize = 8;

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
    let mut net = Net::new(&rays, material.camera_of, material.longer_side_px, grown.cameras.clone(), material.known.options);
    (net.limit_px, net.poses) = (grown.limit_of_finish(material.known.options.largest_residual_px), grown.poses.clone());
    let mut growth = Growth::new(net, material.known.options, material.priors, is_open.to_vec());
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
        let draft = draft(material, net)?;
        match draft.adjust(&material.known) {
            Ok(adjusted) => return given(material, draft.model(&material.known, adjusted)),
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

/// The block of a net before its adjustment.
fn draft(material: &Material<'_>, net: &Net<'_>) -> Result<Draft, Error> {
    let known = &material.known;
    let images: Vec<usize> = (0..net.poses.len()).filter(|image| net.poses[*image].is_some()).collect();
    let mut draft = Draft::of_images(known, images, &net.cameras, |image| (net.camera_of[image], net.poses[image]));
    for point in adjusting_points(material, net)? {
        add_point(&mut draft, material, net, point);
    }
    Ok(draft)
}

/// Adds a point with its rays.
fn add_point(draft: &mut Draft, material: &Material<'_>, net: &Net<'_>, point: usize) {
    let Some(place) = net.points[point] else { return };
    let multi_ray = material.points.rays(point);
    let control = point.checked_sub(material.points.len());
    let source = control.map_or(PointSource::TiePoint(point as u32), PointSource::GroundControl);
    let index = draft.add_point(&material.known, source, place);
    for (k, ray) in net.rays.of_point(point).enumerate() {
        let Ok(image) = draft.images.binary_search(&(net.rays.image[ray] as usize)) else { continue };
        let [x_px, y_px] = net.rays.at[ray];
        if net.accepted[ray] {
            let sigma_px = control.map(|_| material.known.mark_sigma_px(source));
            draft.block.rays.push(BlockObservation { image, point: index, x_px, y_px, weight: 1.0, sigma_px });
            let known = multi_ray.get(k);
            let (feature, confidence) = (known.map(|r| r.feature), known.map_or(1.0, |r| r.confidence));
            draft.rays.push(ObservationSource { feature, confidence, by_hand: false });
        } else {
            let residual_px = net.residual(ray);
            draft.rejected.push(RejectedObservation { image, point: index, x_px, y_px, residual_px, by_hand: false, measured: false });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reconstruction::options::ReconstructionOptions;
    use crate::reconstruction::rays::Rays;
    use crate::{Cause, Computation};

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
