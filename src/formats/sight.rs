//! What each image sees: its rays in the order of the points, by which formats number the features of an image.

use crate::{BlockModel, ImageObservation};
use std::collections::BTreeMap;

/// A ray as its image has it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sighting {
    pub point: usize,
    pub ray: ImageObservation,
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
            let number = |ray: &ImageObservation| {
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
