//! How many points each two images have in common.

use super::{FeatureObservation, TiePoints};
use serde::{Deserialize, Serialize};

/// The points that two images have in common.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct SharedPoints {
    /// In ascending order.
    pub images: [u32; 2],
    pub points: u32,
}

/// For each pair of images with points in common, how many: ordered by image. Rays of images from `images` on are passed over.
pub fn shared_points(points: &TiePoints, images: usize) -> Vec<SharedPoints> {
    count_shared(&PointsOfImages::new(points, images), |point| points.rays(point as usize), images)
}

/// The points of each image, ascending, in one array.
pub(super) struct PointsOfImages {
    starts: Vec<u32>,
    points: Vec<u32>,
}

impl PointsOfImages {
    pub(super) fn new(points: &TiePoints, images: usize) -> Self {
        let mut starts = vec![0_u32; images + 1];
        let known = |ray: &&FeatureObservation| (ray.image as usize) < images;
        points.iter().flatten().filter(known).for_each(|ray| starts[ray.image as usize + 1] += 1);
        for image in 0..images {
            starts[image + 1] += starts[image];
        }
        let mut places = starts.clone();
        let mut list = vec![0; starts[images] as usize];
        for (point, rays) in points.iter().enumerate() {
            for ray in rays.iter().filter(known) {
                list[places[ray.image as usize] as usize] = point as u32;
                places[ray.image as usize] += 1;
            }
        }
        Self { starts, points: list }
    }

    pub(super) fn of(&self, image: u32) -> &[u32] {
        &self.points[self.starts[image as usize] as usize..self.starts[image as usize + 1] as usize]
    }
}

pub(super) fn count_shared<'a>(
    of_images: &PointsOfImages,
    rays: impl Fn(u32) -> &'a [FeatureObservation],
    images: usize,
) -> Vec<SharedPoints> {
    let mut counts = vec![0_u32; images];
    let mut partners = Vec::new();
    let mut found = Vec::new();
    for image in 0..images as u32 {
        for ray in
            of_images.of(image).iter().flat_map(|point| rays(*point)).filter(|ray| ray.image > image && (ray.image as usize) < images)
        {
            if counts[ray.image as usize] == 0 {
                partners.push(ray.image);
            }
            counts[ray.image as usize] += 1;
        }
        partners.sort_unstable();
        for partner in partners.drain(..) {
            found.push(SharedPoints { images: [image, partner], points: std::mem::take(&mut counts[partner as usize]) });
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_point_counts_for_all_pairs_of_its_rays() {
        let mut points = TiePoints::with_capacity(2, 5);
        let ray = |image| FeatureObservation { image, feature: 0, confidence: 1.0 };
        points.push([0, 2, 3].map(ray).into_iter(), 1.0);
        points.push([2, 3].map(ray).into_iter(), 1.0);
        let shared: Vec<_> = shared_points(&points, 4).iter().map(|s| (s.images, s.points)).collect();
        assert_eq!(shared, [([0, 2], 1), ([0, 3], 1), ([2, 3], 2)]);
        assert_eq!(shared_points(&points, 3).len(), 1);
    }
}
