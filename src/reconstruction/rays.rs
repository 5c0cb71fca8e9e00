//! Who sees what: the rays of all points, by point and by image.

use std::ops::Range;

/// Rays in the order of the points.
pub(super) struct Rays {
    /// The first ray of each point, and the number of all.
    start: Vec<u32>,
    pub image: Vec<u32>,
    pub point: Vec<u32>,
    /// Column and row in px.
    pub at: Vec<[f64; 2]>,
    /// The first point that was surveyed; all after it were, too.
    surveyed: u32,
    image_start: Vec<u32>,
    of_image: Vec<u32>,
}

impl Rays {
    /// `points` gives the images and places of each point's rays.
    pub fn new<P: IntoIterator<Item = (u32, [f64; 2])>>(points: impl Iterator<Item = P>, images: usize) -> Self {
        let mut rays = Self {
            start: vec![0],
            image: vec![],
            point: vec![],
            at: vec![],
            surveyed: u32::MAX,
            image_start: vec![0; images + 1],
            of_image: vec![],
        };
        for (point, of_point) in points.enumerate() {
            for (image, at) in of_point {
                rays.image.push(image);
                rays.point.push(point as u32);
                rays.at.push(at);
                rays.image_start[image as usize + 1] += 1;
            }
            rays.start.push(rays.image.len() as u32);
        }
        for image in 0..images {
            rays.image_start[image + 1] += rays.image_start[image];
        }
        let mut places = rays.image_start.clone();
        rays.of_image = vec![0; rays.image.len()];
        for (ray, image) in rays.image.iter().enumerate() {
            rays.of_image[places[*image as usize] as usize] = ray as u32;
            places[*image as usize] += 1;
        }
        rays
    }

    /// The same with the points from one on being surveyed ones.
    pub fn with_surveyed(self, first: usize) -> Self {
        Self { surveyed: first as u32, ..self }
    }

    /// Whether a ray is a mark: that of a surveyed point.
    pub fn is_mark(&self, ray: usize) -> bool {
        self.point[ray] >= self.surveyed
    }

    /// Number of rays.
    pub fn len(&self) -> usize {
        self.image.len()
    }

    pub fn points(&self) -> usize {
        self.start.len() - 1
    }

    pub fn images(&self) -> usize {
        self.image_start.len() - 1
    }

    pub fn of_point(&self, point: usize) -> Range<usize> {
        self.start[point] as usize..self.start[point + 1] as usize
    }

    /// In the order of the points.
    pub fn of_image(&self, image: usize) -> &[u32] {
        &self.of_image[self.image_start[image] as usize..self.image_start[image + 1] as usize]
    }
}
