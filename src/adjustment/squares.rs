//! Residuals summed up: of all accepted rays, by images, by points, by the number of rays of a point.

use super::block::{Block, BlockObservation};
use super::result::RayCountRmse;

/// Sum of squares and number of rays.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Squares {
    sum: f64,
    pub rays: usize,
}

impl Squares {
    pub fn add(&mut self, [x, y]: [f64; 2]) {
        self.sum += x * x + y * y;
        self.rays += 1;
    }

    pub fn rmse(self) -> f64 {
        (self.sum / self.rays.max(1) as f64).sqrt()
    }
}

/// The sums of a block.
pub(super) struct Sums {
    pub all: Squares,
    pub of_images: Vec<Squares>,
    pub of_points: Vec<Squares>,
}

impl Sums {
    /// `accepted` gives rays with their residuals.
    pub fn new<'a>(block: &Block, accepted: impl Iterator<Item = (&'a BlockObservation, [f64; 2])>) -> Self {
        let none = |number: usize| vec![Squares::default(); number];
        let mut sums = Self { all: Squares::default(), of_images: none(block.images.len()), of_points: none(block.points.len()) };
        for (ray, residual) in accepted {
            sums.all.add(residual);
            sums.of_images[ray.image].add(residual);
            sums.of_points[ray.point].add(residual);
        }
        sums
    }

    /// By the number of rays of their point.
    pub fn by_rays(&self) -> Vec<RayCountRmse> {
        let most = self.of_points.iter().map(|s| s.rays).max().unwrap_or(0);
        let mut groups = vec![(0, Squares::default()); most + 1];
        for squares in &self.of_points {
            let (points, group) = &mut groups[squares.rays];
            *points += 1;
            group.sum += squares.sum;
            group.rays += squares.rays;
        }
        let described = groups.iter().enumerate().skip(1).filter(|(_, (points, _))| *points > 0);
        described.map(|(rays, (points, group))| RayCountRmse { rays, points: *points, rmse_px: group.rmse() }).collect()
    }
}
