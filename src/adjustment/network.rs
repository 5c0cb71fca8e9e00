//! The rays that take part, in the order in which the normal equations are summed, and the couplings that they make.

use super::block::Block;
use super::sparse::Pattern;
use crate::camera::CAMERA_PARAMETERS;
use std::rc::Rc;

/// A ray that takes part.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sight {
    pub image: u32,
    pub camera: u32,
    pub point: u32,
    /// Its index in the block.
    pub ray: u32,
    pub at: [f64; 2],
    pub weight: f64,
}

/// The accepted rays of a block by points and by images.
pub(super) struct Network {
    /// By point, then image.
    pub sights: Vec<Sight>,
    /// Where the sights of each point begin, and where those of the last one end.
    pub point_start: Vec<usize>,
    /// Indices of sights by image, then point.
    pub by_image: Vec<u32>,
    pub image_start: Vec<usize>,
    /// Images that keep their orientation: they couple nothing and have no unknowns.
    pub fixed: Vec<bool>,
    pub pattern: Rc<Pattern>,
}

impl Network {
    /// All images free; a pattern of other rays is kept where it serves for these, too.
    pub fn new(block: &Block, accepted: &[bool], earlier: Option<&Rc<Pattern>>) -> Self {
        Self::with_fixed(block, accepted, vec![false; block.images.len()], earlier)
    }

    pub fn with_fixed(block: &Block, accepted: &[bool], fixed: Vec<bool>, earlier: Option<&Rc<Pattern>>) -> Self {
        let kept = block.rays.iter().enumerate().zip(accepted).filter(|(_, accepted)| **accepted).map(|(ray, _)| ray);
        let mut sights: Vec<Sight> = kept
            .map(|(index, ray)| Sight {
                image: ray.image as u32,
                camera: block.images[ray.image].camera as u32,
                point: ray.point as u32,
                ray: index as u32,
                at: [ray.x_px, ray.y_px],
                weight: ray.weight,
            })
            .collect();
        sights.sort_unstable_by_key(|s| (s.point, s.image));
        let point_start = starts(block.points.len(), sights.iter().map(|s| s.point));
        let mut by_image: Vec<u32> = (0..sights.len() as u32).collect();
        by_image.sort_by_key(|s| sights[*s as usize].image);
        let image_start = starts(block.images.len(), by_image.iter().map(|s| sights[*s as usize].image));
        let neighbours = neighbours(&sights, &point_start, &by_image, &image_start, &fixed);
        let pattern = earlier.filter(|pattern| pattern.serves(&neighbours)).cloned().unwrap_or_else(|| {
            let places: Vec<[f64; 3]> = block.images.iter().map(|image| image.pose.position).collect();
            Rc::new(Pattern::of(neighbours, &places))
        });
        Self { sights, point_start, by_image, image_start, fixed, pattern }
    }

    pub fn points(&self) -> usize {
        self.point_start.len() - 1
    }

    pub fn images(&self) -> usize {
        self.image_start.len() - 1
    }

    /// The sights of a point.
    pub fn of_point(&self, point: usize) -> &[Sight] {
        &self.sights[self.point_start[point]..self.point_start[point + 1]]
    }

    /// Indices of the sights of an image.
    pub fn of_image(&self, image: usize) -> &[u32] {
        &self.by_image[self.image_start[image]..self.image_start[image + 1]]
    }

    /// Number of images whose orientation is unknown.
    pub fn free_images(&self) -> usize {
        self.fixed.iter().filter(|fixed| !**fixed).count()
    }

    /// Number of points that have rays.
    pub fn used_points(&self) -> usize {
        self.point_start.windows(2).filter(|w| w[1] > w[0]).count()
    }
}

/// Where each key's run of ascending keys begins, and where the last one ends.
fn starts(keys: usize, ascending: impl Iterator<Item = u32>) -> Vec<usize> {
    let mut start = vec![0; keys + 1];
    ascending.for_each(|key| start[key as usize + 1] += 1);
    for key in 0..keys {
        start[key + 1] += start[key];
    }
    start
}

/// For each image those with which it shares a point, ascending; none for fixed ones.
fn neighbours(sights: &[Sight], point_start: &[usize], by_image: &[u32], image_start: &[usize], fixed: &[bool]) -> Vec<Vec<u32>> {
    let images = image_start.len() - 1;
    let mut seen_by = vec![u32::MAX; images];
    (0..images)
        .map(|image| {
            let mut list = Vec::new();
            if fixed[image] {
                return list;
            }
            seen_by[image] = image as u32;
            for sight in &by_image[image_start[image]..image_start[image + 1]] {
                let point = sights[*sight as usize].point as usize;
                for other in &sights[point_start[point]..point_start[point + 1]] {
                    if seen_by[other.image as usize] != image as u32 && !fixed[other.image as usize] {
                        seen_by[other.image as usize] = image as u32;
                        list.push(other.image);
                    }
                }
            }
            list.sort_unstable();
            list
        })
        .collect()
}

/// Which camera parameters and systematic errors are estimated, and their columns in the border of the normal equations.
#[derive(Debug, Clone)]
pub(super) struct Columns {
    /// For each camera the parameters that are estimated with their columns.
    pub of_camera: Vec<Vec<(usize, usize)>>,
    /// Camera and parameter of each of the first columns.
    pub parameter: Vec<(usize, usize)>,
    /// Systematic error of GNSS positions and axis of each of the columns behind these.
    pub systematic: Vec<(usize, usize)>,
    /// For each of these errors the columns of its three values.
    pub of_systematic: Vec<[Option<usize>; 3]>,
}

impl Columns {
    pub fn new(free: &[[bool; CAMERA_PARAMETERS]]) -> Self {
        let of_camera = vec![Vec::new(); free.len()];
        let mut columns = Self { of_camera, parameter: Vec::new(), systematic: Vec::new(), of_systematic: Vec::new() };
        for (camera, free) in free.iter().enumerate() {
            for parameter in (0..CAMERA_PARAMETERS).filter(|k| free[*k]) {
                columns.of_camera[camera].push((parameter, columns.parameter.len()));
                columns.parameter.push((camera, parameter));
            }
        }
        columns
    }

    /// With columns for those values of systematic errors that are free.
    pub fn with_systematic(mut self, free: &[[bool; 3]]) -> Self {
        for (error, free) in free.iter().enumerate() {
            let mut own = [None; 3];
            for axis in (0..3).filter(|axis| free[*axis]) {
                own[axis] = Some(self.number());
                self.systematic.push((error, axis));
            }
            self.of_systematic.push(own);
        }
        self
    }

    pub fn number(&self) -> usize {
        self.parameter.len() + self.systematic.len()
    }
}
