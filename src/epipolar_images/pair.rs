//! Two oriented images of a project, with the points that both show.

use super::view::StereoView;
use crate::error::refuse;
use crate::{BlockModel, Error, PairRun, Pose, Project, Refusal};
use std::collections::BTreeMap;

/// Two oriented images, the left one first.
#[derive(Debug, Clone, PartialEq)]
pub struct StereoPair {
    pub views: [StereoView; 2],
    /// Whether the left one stands second in the project.
    pub is_swapped: bool,
    /// Positions in the left and the right image of the points that the adjustment accepted in both.
    pub points_px: Vec<[[f64; 2]; 2]>,
}

impl StereoPair {
    /// The images with these names, the left one first. Where none are named: those of a pair, or the two of a block that have most points in
    /// common, in that order in which the base goes to the right.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] where they are not oriented, and for names that the project does not have.
    pub fn of_project(project: &Project, names: Option<&[String; 2]>) -> Result<Self, Error> {
        match project {
            Project::Pair(run) => Self::of_pair(run, names),
            Project::Block(run) => Self::of_block(&run.model, names),
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
        let pair = Self { views: [view(0), view(1)], is_swapped: false, points_px };
        let is_swapped = names.map_or(pair.is_reversed(), |[first, _]| *first == right.name && left.name != right.name);
        Ok(if is_swapped { pair.swapped() } else { pair })
    }

    fn of_block(model: &BlockModel, names: Option<&[String; 2]>) -> Result<Self, Error> {
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
        let pair = Self { views: [view(images[0])?, view(images[1])?], is_swapped: images[0] > images[1], points_px };
        Ok(if names.is_none() && pair.is_reversed() { pair.swapped() } else { pair })
    }

    /// Whether the base goes to the left in the left image.
    fn is_reversed(&self) -> bool {
        let [left, right] = self.views.each_ref().map(|view| view.pose);
        (0..3).map(|k| left.rotation[0][k] * (right.position[k] - left.position[k])).sum::<f64>() < 0.0
    }

    fn swapped(self) -> Self {
        let [left, right] = self.views;
        Self {
            views: [right, left],
            is_swapped: !self.is_swapped,
            points_px: self.points_px.into_iter().map(|[left, right]| [right, left]).collect(),
        }
    }
}

/// The two oriented images that have most points in common; of several pairs the first.
fn best_connected(model: &BlockModel) -> Result<[usize; 2], Error> {
    let mut common: BTreeMap<[usize; 2], usize> = BTreeMap::new();
    for point in &model.points {
        let seen: Vec<usize> = point.rays.iter().map(|ray| ray.image).filter(|image| model.images[*image].pose.is_some()).collect();
        for (k, first) in seen.iter().enumerate() {
            for second in &seen[k + 1..] {
                *common.entry([*first.min(second), *first.max(second)]).or_default() += 1;
            }
        }
    }
    let most = common.values().max().copied().unwrap_or(0);
    match common.into_iter().find(|(_, number)| *number == most) {
        Some((images, _)) => Ok(images),
        None => refuse(Refusal::EpipolarNoPair),
    }
}
