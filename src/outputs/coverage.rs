//! How the observations of a block lie over its images.

use crate::BlockModel;
use crate::tracks::von_gruber_position;

/// The observations of one image.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Coverage {
    pub observations: usize,
    /// Of the nine von Gruber positions, those that hold an observation.
    pub positions: usize,
}

/// Counts the observations of each image, those of ground control points too.
pub fn coverage(model: &BlockModel) -> Vec<Coverage> {
    let mut counted = vec![(0, [false; 9]); model.images.len()];
    for ray in model.points.iter().flat_map(|point| &point.rays) {
        let camera = &model.cameras[model.images[ray.image].camera];
        let (observations, filled) = &mut counted[ray.image];
        *observations += 1;
        filled[von_gruber_position([ray.x_px, ray.y_px], [camera.width_px, camera.height_px])] = true;
    }
    let positions = |filled: [bool; 9]| filled.into_iter().filter(|filled| *filled).count();
    counted.into_iter().map(|(observations, filled)| Coverage { observations, positions: positions(filled) }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Camera, ImageObservation, ModelImage, ObjectPoint};

    #[test]
    fn positions_are_the_nine_of_each_image() {
        let camera = Camera::without_distortion(300, 90, 1.0);
        let point = |rays: &[(usize, f64, f64)]| ObjectPoint {
            number: None,
            position: None,
            colour: [0; 3],
            rmse_px: None,
            confidence: 1.0,
            by_hand: 0,
            name: None,
            rays: rays
                .iter()
                .map(|(image, x_px, y_px)| ImageObservation { image: *image, x_px: *x_px, y_px: *y_px, confidence: 1.0 })
                .collect(),
        };
        let model = BlockModel {
            cameras: vec![camera],
            images: ["a", "b", "c"].map(|name| ModelImage { name: name.into(), camera: 0, pose: None }).into(),
            points: vec![
                point(&[(0, 0.0, 0.0), (1, 300.0, 90.0)]),
                point(&[(0, 99.9, 29.9), (1, 200.0, 60.0)]),
                point(&[(0, 100.0, 29.9)]),
            ],
            origin: None,
        };
        let counted: Vec<(usize, usize)> = coverage(&model).iter().map(|image| (image.observations, image.positions)).collect();
        assert_eq!(counted, [(3, 2), (2, 1), (0, 0)]);
    }
}
