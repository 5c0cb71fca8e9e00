//! An adjusted block with some of its points.

use super::block::{BlockObservation, ControlPoint};
use super::result::{AdjustmentResult, ObservationVerdict};
use super::squares::Sums;

impl AdjustmentResult {
    /// The adjusted block with only the points `kept` (ascending) and their rays, and the rays that these were.
    ///
    /// What was adjusted stays as it is, with its standard errors, σ₀ and degrees of freedom: all points determined it. Numbers of rays and
    /// root mean squares are those of the points that are kept.
    pub(crate) fn with_points(self, kept: &[usize]) -> (Self, Vec<usize>) {
        let mut place = vec![None; self.block.points.len()];
        kept.iter().enumerate().for_each(|(to, from)| place[*from] = Some(to));
        let Self { mut block, control, .. } = self;
        let rays: Vec<usize> = (0..block.rays.len()).filter(|ray| place[block.rays[*ray].point].is_some()).collect();
        block.rays =
            rays.iter().filter_map(|ray| Some(BlockObservation { point: place[block.rays[*ray].point]?, ..block.rays[*ray] })).collect();
        block.points = kept.iter().map(|point| block.points[*point]).collect();
        let of_control = block
            .control
            .iter()
            .zip(control)
            .filter_map(|(c, statistics)| Some((ControlPoint { point: place[c.point]?, ..*c }, statistics)));
        let (surveyed, control) = of_control.unzip();
        block.control = surveyed;
        let of_rays: Vec<_> = rays.iter().map(|ray| self.rays[*ray]).collect();
        let accepted = block.rays.iter().zip(&of_rays).filter(|(_, statistics)| statistics.verdict == ObservationVerdict::Accepted);
        let sums = Sums::new(&block, accepted.map(|(ray, statistics)| (ray, statistics.residual_px)));
        let mut images = self.images;
        images.iter_mut().zip(&sums.of_images).for_each(|(image, squares)| (image.rays, image.rmse_px) = (squares.rays, squares.rmse()));
        let part = Self {
            rmse_px: sums.all.rmse(),
            rmse_by_rays: sums.by_rays(),
            points: kept.iter().map(|point| self.points[*point]).collect(),
            rays: of_rays,
            block,
            images,
            control,
            ..self
        };
        (part, rays)
    }
}
