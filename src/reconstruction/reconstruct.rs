//! The reconstruction as it is called: one model after another, until no images are left that make one.

use super::adjusting::{KnownParameters, known_parameters};
use super::finish::{Finished, finish};
use super::frame::Frame;
use super::growth::Growth;
use super::material::{GROWING_CONNECTION, Known, Material};
use super::net::Net;
use super::options::ReconstructionOptions;
use super::rays::Rays;
use super::refusal::check;
use super::result::{ReconstructedModel, Reconstruction, UnorientedImage};
use super::start::start_pairs;
use super::warning::UnorientedReason;
use crate::Error;
use crate::camera::Camera;
use crate::model::{BlockDescription, KnownCamera};
use crate::tracks::{ImageFeatures, SelectOptions, SharedPoints, TiePoints, select_points, shared_points};

/// Starts that are compared, and the images that each grows to for that.
const STARTS: usize = 4;
const COMPARED_AT: usize = 5;

/// Orients the images of a block from multi-ray points alone, and adjusts it.
///
/// Two images with many common points at a wide angle are oriented to each other; images are added by three points and consensus, points
/// by the intersection of rays, and the block is adjusted by a robust loss now and then, with its cameras. Then all points are intersected,
/// the block is taken into the system of observed positions and adjusted as [`adjust_block`](crate::adjust_block) does. Where
/// `options.selection` chooses points, the block is adjusted by as many as it grew by, and those that are chosen of them are given: their
/// standard errors, and those of images and cameras, are of that adjustment. Images that do not belong to the largest model make models of their own or are given with the
/// reason why they are not oriented. `features` are those of the images, in their order.
///
/// # Errors
/// [`Error::InvalidOption`]; [`Error::InvalidInput`] for indices, values and features that do not fit together; [`Error::TooFew`]; the errors
/// of [`adjust_block`](crate::adjust_block) for the largest model. A block without any model is no error.
///
/// # Source
/// Snavely, Seitz & Szeliski 2006, Photo tourism (growth); Schönberger & Frahm 2016, Structure-from-motion revisited (next images, adjustments).
pub fn reconstruct_block(
    description: &BlockDescription,
    points: &TiePoints,
    features: &[ImageFeatures<'_>],
    options: &ReconstructionOptions,
) -> Result<Reconstruction, Error> {
    options.check()?;
    check(description, points, features)?;
    let frame = Frame::new(description)?;
    let cameras: Vec<Camera> = description.cameras.iter().map(KnownCamera::approximate).collect();
    let priors: Vec<KnownParameters> = description.cameras.iter().map(known_parameters).collect();
    let camera_of: Vec<usize> = description.images.iter().map(|image| image.camera).collect();
    let longer_side = |camera: &KnownCamera| f64::from(camera.width_px.max(camera.height_px));
    let longer_side_px: Vec<f64> = description.cameras.iter().map(longer_side).collect();
    let growing = SelectOptions { per_image: options.growing_rays, per_connection: GROWING_CONNECTION };
    let chosen = select_points(points, features, &growing)?.points;
    let place = |image: u32, feature: u32| features[image as usize].positions[feature as usize].map(f64::from);
    let images = description.images.len();
    let rays = Rays::new(
        chosen.iter().map(|point| points.rays(*point as usize).iter().map(|ray| (ray.image, place(ray.image, ray.feature)))),
        images,
    );
    let shared: Vec<SharedPoints> = shared_points(&subset(points, &chosen), images);
    let (camera_of, longer_side_px) = (&camera_of[..], &longer_side_px[..]);
    let known = Known { description, options, frame: &frame };
    let mut material = Material { known, points, features, camera_of, longer_side_px, priors: &priors, all: None };
    let mut is_open = vec![true; images];
    let mut refused: Vec<Option<UnorientedReason>> = vec![None; images];
    let mut models: Vec<ReconstructedModel> = Vec::new();
    while models.len() < options.most_models {
        let net = Net::new(&rays, camera_of, longer_side_px, cameras.clone(), options);
        let Some(mut growth) = best_start(Growth::new(net, options, &priors, is_open.clone()), &shared) else { break };
        growth.grow(usize::MAX);
        if growth.net.oriented() < 2 {
            break;
        }
        match finish(&mut material, &growth.net, &is_open) {
            Ok(Finished { model, unoriented }) => {
                model.images.iter().for_each(|image| is_open[*image] = false);
                // The first model is the largest as a rule: why an image is not in it is what counts.
                unoriented.iter().for_each(|(image, reason)| refused[*image] = refused[*image].or(Some(*reason)));
                models.push(model);
            }
            Err(error) if models.is_empty() => return Err(error),
            Err(_) => (0..images).filter(|image| growth.net.poses[*image].is_some()).for_each(|image| is_open[image] = false),
        }
    }
    models.sort_by_key(|model| std::cmp::Reverse(model.images.len()));
    let mut is_oriented = vec![false; images];
    models.iter().flat_map(|model| &model.images).for_each(|image| is_oriented[*image] = true);
    let unoriented = (0..images).filter(|image| !is_oriented[*image]).map(|image| {
        let known = rays.of_image(image).len();
        let reason = if known == 0 { UnorientedReason::NoPoints } else { refused[image].unwrap_or(UnorientedReason::NoPartner) };
        UnorientedImage { image, reason }
    });
    let unoriented = unoriented.collect();
    let origin = frame.origin.filter(|_| models.iter().any(|model| model.in_system));
    Ok(Reconstruction { models, unoriented, origin })
}

/// Some of the points by themselves.
fn subset(points: &TiePoints, chosen: &[u32]) -> TiePoints {
    let mut some = TiePoints::with_capacity(chosen.len(), 0);
    for point in chosen {
        some.push(points.rays(*point as usize).iter().copied(), points.confidence(*point as usize));
    }
    some
}

/// Of several starts the one that gets farthest: over flat ground a pair alone may have the wrong one of two orientations.
fn best_start<'a>(empty: Growth<'a>, shared: &[SharedPoints]) -> Option<Growth<'a>> {
    let pairs = start_pairs(&empty.net, shared, &empty.is_open, empty.options.seed);
    let mut best: Option<(Growth<'a>, usize)> = None;
    for pair in pairs.iter().take(STARTS) {
        let mut growth = empty.clone();
        growth.start(pair);
        growth.grow(COMPARED_AT);
        let images = growth.net.oriented();
        let accepted = growth.net.accepted.iter().filter(|accepted| **accepted).count();
        // As many rays as fit; where they are many more images, that shows.
        if images >= 2 && best.as_ref().is_none_or(|(_, most)| accepted > *most) {
            best = Some((growth, accepted));
        }
    }
    best.map(|(growth, _)| growth)
}
