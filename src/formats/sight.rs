//! What each image sees: its rays in the order of the points, by which formats number the features of an image.

use super::{BlockModel, ModelRay};
use std::collections::BTreeMap;

/// A ray as its image has it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sighting {
    pub point: usize,
    pub ray: ModelRay,
}

/// The rays of each image, and of each ray of a point its number among those of its image.
pub(super) struct Sights {
    pub of_images: Vec<Vec<Sighting>>,
    pub numbers: Vec<Vec<usize>>,
}

impl Sights {
    pub(super) fn new(model: &BlockModel) -> Self {
        let mut of_images: Vec<Vec<Sighting>> = vec![Vec::new(); model.images.len()];
        let mut numbers = Vec::with_capacity(model.points.len());
        for (point, of) in model.points.iter().enumerate() {
            let number = |ray: &ModelRay| {
                let image = &mut of_images[ray.image];
                image.push(Sighting { point, ray: *ray });
                image.len() - 1
            };
            numbers.push(of.rays.iter().map(number).collect());
        }
        Self { of_images, numbers }
    }

    /// For each pair of images with points in common, the numbers of their rays: ordered by image, then by point.
    pub(super) fn pairs(&self, model: &BlockModel) -> BTreeMap<[usize; 2], Vec<[usize; 2]>> {
        let mut pairs: BTreeMap<[usize; 2], Vec<[usize; 2]>> = BTreeMap::new();
        for (point, numbers) in model.points.iter().zip(&self.numbers) {
            let rays: Vec<(usize, usize)> = point.rays.iter().map(|ray| ray.image).zip(numbers.iter().copied()).collect();
            for (index, a) in rays.iter().enumerate() {
                for b in &rays[index + 1..] {
                    let (first, second) = if a.0 < b.0 { (a, b) } else { (b, a) };
                    pairs.entry([first.0, second.0]).or_default().push([first.1, second.1]);
                }
            }
        }
        pairs
    }
}

/// Three images and three points: one of three rays, one of two, one of two that is not intersected.
#[cfg(test)]
pub(crate) fn tiny_block() -> BlockModel {
    use super::{GeographicOrigin, ModelCamera, ModelImage, ModelPoint, ModelPose};
    let upright = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let image = |name: &str, x: Option<f64>| ModelImage {
        name: name.into(),
        camera: 0,
        pose: x.map(|x| ModelPose { rotation: upright, position: [x, 0.0, 100.0] }),
    };
    let ray = |image, x_px, y_px| ModelRay { image, x_px, y_px, confidence: 1.0 };
    let point = |position, rays: &[ModelRay]| ModelPoint {
        position,
        colour: [10, 20, 30],
        rmse_px: Some(0.25),
        confidence: 1.0,
        rays: rays.into(),
    };
    BlockModel {
        cameras: vec![ModelCamera {
            width_px: 400,
            height_px: 300,
            focal_px: 500.0,
            principal_point_px: [200.0, 150.0],
            radial: [0.0; 3],
            tangential: [0.0; 2],
            pixel_mm: Some(0.01),
        }],
        images: vec![image("a.jpg", Some(0.0)), image("b.jpg", Some(10.0)), image("c.jpg", None)],
        points: vec![
            point(Some([5.0, 0.0, 0.0]), &[ray(0, 225.0, 150.0), ray(1, 175.0, 150.0), ray(2, 100.5, 20.25)]),
            point(Some([5.0, 10.0, 0.0]), &[ray(0, 225.0, 100.0), ray(1, 175.0, 100.0)]),
            point(None, &[ray(1, 10.0, 20.0), ray(2, 30.0, 40.0)]),
        ],
        origin: Some(GeographicOrigin { longitude_deg: 8.0, latitude_deg: 50.0, height_m: 200.0 }),
    }
}
