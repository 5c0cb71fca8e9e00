//! Two oriented images of a project, with the points that both show.

use super::system::StereoSystem;
use super::view::StereoView;
use crate::error::refuse;
use crate::{BlockModel, BlockRun, Error, PairRun, Pose, Project, Refusal};
use nalgebra::Vector3;
use std::collections::BTreeMap;

/// Two oriented images, the left one first.
#[derive(Debug, Clone, PartialEq)]
pub struct StereoPair {
    pub views: [StereoView; 2],
    /// Whether the left one stands second in the project.
    pub is_swapped: bool,
    /// SHA-256 of the files of the left and the right one in hexadecimal digits; absent for photos that were simulated.
    pub contents: [Option<String>; 2],
    /// Positions in the left and the right image of the points that the adjustment accepted in both.
    pub points_px: Vec<[[f64; 2]; 2]>,
    /// The system of the views.
    pub system: StereoSystem,
}

impl StereoPair {
    /// The images with these names, the left one first. Where none are named: those of a pair, or the two of a block that have most points in
    /// common, in that order in which the base goes to the right.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] where they are not oriented, and for names that the project does not have.
    pub fn of_project(project: &Project, names: Option<&[String; 2]>) -> Result<Self, Error> {
        if let Some([first, second]) = names
            && first == second
        {
            return refuse(Refusal::EpipolarNames { name: first.clone() });
        }
        match project {
            Project::Pair(run) => Self::of_pair(run, names),
            Project::Block(run) => Self::of_block(run, names),
        }
    }

    fn of_pair(run: &PairRun, names: Option<&[String; 2]>) -> Result<Self, Error> {
        let [left, right] = &run.images;
        let own = [&left.name, &right.name];
        if let Some(name) = names.iter().flat_map(|names| names.iter()).find(|name| !own.contains(name)) {
            return refuse(Refusal::EpipolarName { name: name.clone() });
        }
        let (Ok(oriented), Some(interior)) = (&run.result.orientation, &run.result.interior) else {
            return refuse(Refusal::EpipolarNotOriented { name: right.name.clone() });
        };
        let cameras = interior.estimated(oriented);
        let (rotation, direction) = oriented.pose();
        let p = oriented.parameters;
        let length = (oriented.base_mm * oriented.base_mm + p.by_mm * p.by_mm + p.bz_mm * p.bz_mm).sqrt();
        let poses = [
            Pose { rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], position: [0.0; 3] },
            Pose::new(&rotation, (length * direction).into()),
        ];
        let view = |side: usize| {
            let photo = &run.images[side];
            StereoView::of_interior(photo.name.clone(), [photo.width_px, photo.height_px], cameras[side], poses[side])
        };
        let matches = &run.result.matching.matches;
        let mut accepted = vec![true; matches.len()];
        oriented.rejected.iter().for_each(|index| accepted[*index] = false);
        let points_px = matches.iter().zip(accepted).filter(|(_, accepted)| *accepted).map(|(m, _)| [m.left_px, m.right_px]).collect();
        let contents = [left, right].map(|photo| photo.content.clone());
        let system = StereoSystem::Photo { image: left.name.clone() };
        let pair = Self { views: [view(0), view(1)], is_swapped: false, contents, points_px, system };
        let is_swapped = names.map_or(pair.is_reversed(), |[first, _]| *first == right.name);
        Ok(if is_swapped { pair.swapped() } else { pair })
    }

    fn of_block(run: &BlockRun, names: Option<&[String; 2]>) -> Result<Self, Error> {
        let model = &run.model;
        let images = match names {
            Some(names) => {
                let index = |name: &String| match model.images.iter().position(|image| image.name == *name) {
                    Some(index) => Ok(index),
                    None => refuse(Refusal::EpipolarName { name: name.clone() }),
                };
                [index(&names[0])?, index(&names[1])?]
            }
            None => best_connected(model)?,
        };
        let view = |index: usize| {
            let image = &model.images[index];
            match image.pose {
                Some(pose) => Ok(StereoView::of_camera(image.name.clone(), &model.cameras[image.camera], pose)),
                None => refuse(Refusal::EpipolarNotOriented { name: image.name.clone() }),
            }
        };
        let of =
            |point: &crate::ObjectPoint, image: usize| point.rays.iter().find(|ray| ray.image == image).map(|ray| [ray.x_px, ray.y_px]);
        let points_px = model.points.iter().filter_map(|point| Some([of(point, images[0])?, of(point, images[1])?])).collect();
        let pair = Self {
            views: [view(images[0])?, view(images[1])?],
            is_swapped: images[0] > images[1],
            contents: images.map(|image| Some(run.images[image].content.clone())),
            points_px,
            system: StereoSystem::of_block(run),
        };
        Ok(if names.is_none() && pair.is_reversed() { pair.swapped() } else { pair })
    }

    /// Whether the base goes to the left in the left image.
    fn is_reversed(&self) -> bool {
        let [left, right] = self.views.each_ref().map(|view| view.pose);
        (0..3).map(|k| left.rotation[0][k] * (right.position[k] - left.position[k])).sum::<f64>() < 0.0
    }

    fn swapped(self) -> Self {
        let ([left, right], [of_left, of_right]) = (self.views, self.contents);
        let points_px = self.points_px.into_iter().map(|[left, right]| [right, left]).collect();
        Self { views: [right, left], is_swapped: !self.is_swapped, contents: [of_right, of_left], points_px, system: self.system }
    }
}

/// Angle between two rays, in degrees, from which on a point counts in full.
const GOOD_ANGLE_DEG: f64 = 10.0;

/// The two oriented images that have most points in common, which count less where their rays are nearly parallel: of images that were taken
/// close together the direction of the base is hardly known. Of several pairs the first.
fn best_connected(model: &BlockModel) -> Result<[usize; 2], Error> {
    let mut common: BTreeMap<[usize; 2], f64> = BTreeMap::new();
    for point in &model.points {
        let Some(position) = point.position.map(Vector3::from) else { continue };
        let centre = |image: usize| Some((image, Vector3::from(model.images[image].pose?.position)));
        let seen: Vec<(usize, Vector3<f64>)> = point.rays.iter().filter_map(|ray| centre(ray.image)).collect();
        for (k, (first, from)) in seen.iter().enumerate() {
            for (second, other) in &seen[k + 1..] {
                let (ray, next) = (position - from, position - other);
                let angle_deg = libm::atan2(ray.cross(&next).norm(), ray.dot(&next)).to_degrees();
                *common.entry([*first.min(second), *first.max(second)]).or_default() += (angle_deg / GOOD_ANGLE_DEG).min(1.0);
            }
        }
    }
    let most = common.values().fold(0.0, |most: f64, weight| most.max(*weight));
    match common.into_iter().find(|(_, weight)| *weight == most) {
        Some((images, _)) => Ok(images),
        None => refuse(Refusal::EpipolarNoPair),
    }
}
