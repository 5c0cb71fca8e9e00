//! Adjustments of a growing model: of all its images, or of some that the others hold.

use super::net::Net;
use crate::KnownCamera;
use crate::adjustment::{Block, BlockImage, BlockObservation, Start, adjust_start};
use crate::camera::CAMERA_PARAMETERS;

/// Beyond so many images adjustments of all cost more than the rest, and images are held from many sides: they are made more seldom and
/// end sooner.
pub(super) const MANY: usize = 300;
/// Images of a camera from which on its parameters are left alone between adjustments of all.
pub(super) const CALIBRATED: usize = 10;
/// Images from which on cameras are calibrated.
const LEAST_CALIBRATING: usize = 3;
/// Iterations of an adjustment on the way, and of one of many images.
const ITERATIONS: usize = 12;
const ITERATIONS_OF_MANY: usize = 4;
/// Standard error of k2.
const RADIAL: f64 = 0.05;

/// What is known of the cameras beforehand.
#[derive(Debug, Clone, Copy)]
pub(super) struct KnownParameters {
    /// Values with their standard errors; 0 fixes one.
    pub known: [(f64, f64); CAMERA_PARAMETERS],
}

/// What is known of a camera, as the adjustment of the finished block takes it.
pub(super) fn known_parameters(known: &KnownCamera) -> KnownParameters {
    let (camera, within) = (known.approximate(), known.known_within());
    let (values, free) = (camera.values(), camera.free.flags());
    // Principal point and decentring wait for the adjustment of the finished block.
    let sigmas = [camera.focal_px * within.focal, 0.0, 0.0, within.k1, RADIAL, 0.0, 0.0, 0.0];
    let known = std::array::from_fn(|k| (values[k], if free[k] { sigmas[k] } else { 0.0 }));
    KnownParameters { known }
}

/// Adjusts some images with the points they see; the other images that see these keep their orientation.
pub(super) fn adjust(net: &mut Net<'_>, priors: &[KnownParameters], free: &[usize]) {
    let rays = net.rays;
    let mut is_free = vec![false; net.poses.len()];
    free.iter().for_each(|image| is_free[*image] = net.poses[*image].is_some());
    let mut point_of = vec![u32::MAX; rays.points()];
    let mut image_of = vec![u32::MAX; net.poses.len()];
    let mut block = Block { cameras: net.cameras.clone(), ..Block::default() };
    let (mut points, mut images) = (Vec::new(), Vec::new());
    let seen = free.iter().flat_map(|image| rays.of_image(*image)).filter(|ray| net.accepted[**ray as usize]);
    let mut seen: Vec<usize> = seen.map(|ray| rays.point[*ray as usize] as usize).collect();
    seen.sort_unstable();
    seen.dedup();
    for point in seen {
        let Some(position) = net.points[point] else { continue };
        point_of[point] = points.len() as u32;
        points.push(point);
        block.points.push(position);
        for ray in rays.of_point(point).filter(|ray| net.accepted[*ray]) {
            let image = rays.image[ray] as usize;
            let Some(pose) = net.poses[image] else { continue };
            if image_of[image] == u32::MAX {
                image_of[image] = images.len() as u32;
                images.push(image);
                block.images.push(BlockImage { camera: net.camera_of[image], pose, gnss: None, axis: None });
            }
            let [x_px, y_px] = rays.at[ray];
            let (image, point) = (image_of[image] as usize, point_of[point] as usize);
            block.rays.push(BlockObservation { image, point, x_px, y_px, weight: 1.0, sigma_px: None });
        }
    }
    if block.images.len() < 2 {
        return;
    }
    let fixed: Vec<bool> = images.iter().map(|image| !is_free[*image]).collect();
    let accepted = vec![true; block.rays.len()];
    let cameras = known_cameras(net, priors, &images, fixed.iter().any(|fixed| *fixed));
    let sigma_px = net.limit_px / 10.0;
    let max_iterations = if free.len() > MANY { ITERATIONS_OF_MANY } else { ITERATIONS };
    let start = Start { accepted: &accepted, fixed: &fixed, cameras: &cameras, sigma_px, max_iterations };
    // A singular one leaves everything as it is: what made it so falls by its residuals.
    let Ok(adjusted) = adjust_start(block, &start) else { return };
    for (place, image) in images.iter().enumerate().filter(|(place, _)| !fixed[*place]) {
        net.poses[*image] = Some(adjusted.images[place].pose);
    }
    points.iter().zip(&adjusted.points).for_each(|(point, then)| net.points[*point] = Some(*then));
    net.cameras = adjusted.cameras;
}

/// What is known of the cameras in an adjustment of some images. Cameras that enough images have calibrated are left alone in a part.
fn known_cameras(net: &Net<'_>, priors: &[KnownParameters], images: &[usize], is_part: bool) -> Vec<[(f64, f64); CAMERA_PARAMETERS]> {
    let mut used = vec![0; net.cameras.len()];
    images.iter().for_each(|image| used[net.camera_of[*image]] += 1);
    let mut of_all = vec![0; net.cameras.len()];
    (0..net.poses.len()).filter(|i| net.poses[*i].is_some()).for_each(|i| of_all[net.camera_of[i]] += 1);
    let known = |camera: usize| {
        let calibrates = used[camera] > 0 && images.len() >= LEAST_CALIBRATING && !(is_part && of_all[camera] >= CALIBRATED);
        priors[camera].known.map(|(value, sigma)| (value, if calibrates { sigma } else { 0.0 }))
    };
    (0..net.cameras.len()).map(known).collect()
}
