//! The score of an oriented block by the truth of its photos.

use super::super::score::RIGHT_WITHIN_PX;
use crate::camera::matrix;
use crate::error::refuse;
use crate::{BlockModel, Camera, Error, ImageObservation, Pose, Refusal, Similarity};
use nalgebra::{Matrix3, Vector3};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// How near a block is to its truth.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct BlockScore {
    /// Images of the truth that the block has, and those of them that it has oriented.
    pub images: usize,
    pub oriented: usize,
    /// Root mean square errors of x, y, z of the perspective centres in m, after the similarity transformation that brings all of them
    /// nearest to the truth: what the placing of the block adds is no part of it. Absent for fewer than three or those in one place.
    pub position_rmse_m: Option<[f64; 3]>,
    /// Root mean square angle in degrees between the oriented and the true directions, after the same transformation.
    pub angle_rmse_deg: Option<f64>,
    /// Points with two or more rays in images of the truth.
    pub points: usize,
    /// Those of which all rays meet, by the true orientations, within 1.5 px in each image. Of two rays only the error across the epipolar
    /// line shows.
    pub right_points: usize,
    /// Root mean square distance in px of the rays of right points from where they meet.
    pub right_rmse_px: Option<f64>,
}

/// A true image.
struct TrueImage<'a> {
    camera: &'a Camera,
    pose: &'a Pose,
}

/// Scores a block by a truth whose images have the same names; its cameras have no distortion.
///
/// # Errors
/// As [`BlockModel::check`] for either; [`Error::InvalidInput`] for a truth of other images, with distortion, or not oriented.
pub fn score_block(model: &BlockModel, truth: &BlockModel) -> Result<BlockScore, Error> {
    model.check()?;
    truth.check()?;
    let known = true_images(truth)?;
    let of_images: Vec<Option<&TrueImage<'_>>> = model.images.iter().map(|image| known.get(image.name.as_str())).collect();
    let images = of_images.iter().flatten().count();
    if images == 0 {
        return of_other_images();
    }
    let poses: Vec<(&Pose, &Pose)> =
        model.images.iter().zip(&of_images).filter_map(|(image, known)| Some((image.pose.as_ref()?, known.as_ref()?.pose))).collect();
    let centres: Vec<([f64; 3], [f64; 3])> = poses.iter().map(|(own, known)| (own.position, known.position)).collect();
    let fit = if centres.len() < 3 { None } else { Similarity::between(&centres) };
    let (points, right): (usize, Vec<Vec<f64>>) = {
        let of_truth = |ray: &ImageObservation| Some((of_images.get(ray.image).copied().flatten()?, [ray.x_px, ray.y_px]));
        let rays = model.points.iter().map(|point| point.rays.iter().filter_map(of_truth).collect::<Vec<_>>());
        let scored: Vec<Vec<f64>> = rays.filter(|rays| rays.len() >= 2).map(|rays| distances(&rays)).collect();
        (scored.len(), scored.into_iter().filter(|all| all.iter().all(|d| *d <= RIGHT_WITHIN_PX)).collect())
    };
    Ok(BlockScore {
        images,
        oriented: poses.len(),
        position_rmse_m: fit
            .map(|fit| [0, 1, 2].map(|k| root_mean_square(centres.iter().map(|(own, known)| fit.point(own)[k] - known[k])).unwrap_or(0.0))),
        angle_rmse_deg: fit.and_then(|fit| root_mean_square(poses.iter().map(|(own, known)| angle_deg(own, known, &fit)))),
        points,
        right_points: right.len(),
        right_rmse_px: root_mean_square(right.into_iter().flatten()),
    })
}

/// Refuses a truth that is none, or of other images, before these are computed.
///
/// # Errors
/// As [`score_block`].
pub fn check_truth(truth: &BlockModel, names: &[String]) -> Result<(), Error> {
    truth.check()?;
    let known = true_images(truth)?;
    if names.iter().any(|name| known.contains_key(name.as_str())) { Ok(()) } else { of_other_images() }
}

fn of_other_images<T>() -> Result<T, Error> {
    refuse(Refusal::TruthOfOthers)
}

fn true_images(truth: &BlockModel) -> Result<BTreeMap<&str, TrueImage<'_>>, Error> {
    let mut known = BTreeMap::new();
    for image in &truth.images {
        let camera = &truth.cameras[image.camera];
        let Some(pose) = &image.pose else { return refuse(Refusal::TruthNotOriented { name: image.name.clone() }) };
        if camera.radial != [0.0; 3] || camera.tangential != [0.0; 2] {
            return refuse(Refusal::TruthDistortion { camera: image.camera });
        }
        known.insert(image.name.as_str(), TrueImage { camera, pose });
    }
    Ok(known)
}

/// The angle between the axes of an image, moved with the block, and the true ones.
fn angle_deg(own: &Pose, known: &Pose, fit: &Similarity) -> f64 {
    let moved = own.matrix() * matrix(&fit.rotation).transpose();
    let turn = moved * known.matrix().transpose();
    // The sine is exact for small angles, where the cosine is not.
    let twice = Vector3::new(turn[(2, 1)] - turn[(1, 2)], turn[(0, 2)] - turn[(2, 0)], turn[(1, 0)] - turn[(0, 1)]).norm();
    libm::atan2(twice, turn.trace() - 1.0).to_degrees()
}

/// The distance in px of each ray from the image of the place nearest to all of them; infinite where there is none before the cameras.
fn distances(rays: &[(&TrueImage<'_>, [f64; 2])]) -> Vec<f64> {
    let (mut normal, mut right) = (Matrix3::zeros(), Vector3::zeros());
    for (TrueImage { camera, pose }, [x, y]) in rays {
        let [cx, cy] = camera.principal_point_px;
        let photo = Vector3::new(x - cx, cy - y, -camera.focal_px);
        let along = (pose.matrix().transpose() * photo).normalize();
        let across = Matrix3::identity() - along * along.transpose();
        normal += across;
        right += across * Vector3::from(pose.position);
    }
    let Some(place) = normal.try_inverse().map(|inverse| inverse * right) else { return vec![f64::INFINITY; rays.len()] };
    let distance = |(TrueImage { camera, pose }, [x, y]): &(&TrueImage<'_>, [f64; 2])| {
        let seen = pose.matrix() * (place - Vector3::from(pose.position));
        let [cx, cy] = camera.principal_point_px;
        let scale = -camera.focal_px / seen.z;
        let [dx, dy] = [cx + scale * seen.x - x, cy - scale * seen.y - y];
        if seen.z < 0.0 { (dx * dx + dy * dy).sqrt() } else { f64::INFINITY }
    };
    rays.iter().map(distance).collect()
}

fn root_mean_square(values: impl Iterator<Item = f64>) -> Option<f64> {
    let (sum, count) = values.fold((0.0, 0_usize), |(sum, count), v| (sum + v * v, count + 1));
    (count > 0).then(|| (sum / count as f64).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{BlockFlight, BlockScene, ObjectPoint, rotation_from_angles};

    fn truth() -> BlockModel {
        let flight = BlockFlight {
            strips: 2,
            exposures: 3,
            width_px: 400,
            height_px: 300,
            pixel_mm: 0.12,
            relief_m: 10.0,
            ..BlockFlight::default()
        };
        BlockScene::new(&flight).unwrap().truth()
    }

    /// Rays to a place from all images that see it.
    fn point(truth: &BlockModel, place: [f64; 3]) -> ObjectPoint {
        let ray = |(image, known): (usize, &crate::ModelImage)| {
            let (camera, pose) = (&truth.cameras[known.camera], known.pose.unwrap());
            let seen = pose.matrix() * (Vector3::from(place) - Vector3::from(pose.position));
            let at = [
                camera.principal_point_px[0] - camera.focal_px * seen.x / seen.z,
                camera.principal_point_px[1] + camera.focal_px * seen.y / seen.z,
            ];
            let inside = (0.0..400.0).contains(&at[0]) && (0.0..300.0).contains(&at[1]);
            inside.then_some(ImageObservation { image, x_px: at[0], y_px: at[1], confidence: 1.0 })
        };
        let rays = truth.images.iter().enumerate().filter_map(ray).collect();
        ObjectPoint { number: None, position: None, colour: [0; 3], rmse_px: None, confidence: 1.0, name: None, rays, by_hand: 0 }
    }

    #[test]
    fn the_truth_is_right_wherever_it_is_moved() {
        let known = truth();
        let [x, y, _] = known.images[1].pose.unwrap().position;
        let mut own = known.clone();
        own.points = vec![point(&known, [x, y, 3.0]), point(&known, [x + 20.0, y - 10.0, 30.0])];
        assert!(own.points.iter().all(|p| p.rays.len() >= 2));
        let turn = rotation_from_angles(0.3, -0.2, 1.0);
        for image in &mut own.images {
            let pose = image.pose.as_mut().unwrap();
            let moved = turn * Vector3::from(pose.position) * 0.5 + Vector3::new(7.0, 8.0, 9.0);
            let rotation = pose.matrix() * turn.transpose();
            *pose = Pose::new(&rotation, moved.into());
        }
        let score = score_block(&own, &known).unwrap();
        assert_eq!((score.images, score.oriented, score.points, score.right_points), (6, 6, 2, 2));
        assert!(score.position_rmse_m.unwrap().iter().all(|e| *e < 1e-6) && score.angle_rmse_deg.unwrap() < 1e-6, "{score:?}");
        assert!(score.right_rmse_px.unwrap() < 1e-6, "{score:?}");
    }

    #[test]
    fn errors_show() {
        let known = truth();
        let [x, y, _] = known.images[1].pose.unwrap().position;
        let mut own = known.clone();
        own.points = vec![point(&known, [x, y, 3.0]), point(&known, [x, y, 30.0])];
        // Across the flight, which for images one behind the other is across the epipolar lines.
        own.points[1].rays[0].x_px += 8.0;
        own.images[2].pose.as_mut().unwrap().position[2] += 6.0;
        own.images[5].pose = None;
        let score = score_block(&own, &known).unwrap();
        assert_eq!((score.oriented, score.points, score.right_points), (5, 2, 1));
        assert!(score.position_rmse_m.unwrap().iter().any(|e| *e > 0.5), "{score:?}");
    }

    #[test]
    fn another_truth_is_refused() {
        let known = truth();
        let renamed = |change: &dyn Fn(&mut BlockModel)| {
            let mut other = known.clone();
            change(&mut other);
            score_block(&known, &other).map(|_| ()).unwrap_err().to_string()
        };
        assert!(renamed(&|other| other.images.iter_mut().for_each(|image| image.name += "x")).contains("none of the block's images"));
        assert!(renamed(&|other| other.images[0].pose = None).contains("without orientation"));
        assert!(renamed(&|other| other.cameras[0].radial[0] = 0.1).contains("distortion"));
    }
}
