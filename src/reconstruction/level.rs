//! The rotation of a whole block that its GNSS positions hardly tell: from the directions of view that drones recorded, or else from views
//! that are taken as vertical on average.

use crate::adjustment::{AdjustmentResult, AxisPrior, Block, BlockImage};
use crate::math::{dot3, minus};

/// The rotation of a model is open where the angles of no image are surer than this.
pub(super) const UNCERTAIN_TURN_DEG: f64 = 2.0;
/// Standard error in degrees of the mean direction of view: mounts are stabilised, or their flights level, to some degrees.
pub(super) const LEVEL_DEG: f64 = 3.0;
/// Views that are all within this angle of their mean are those of one camera that looks one way.
const ALIKE_DEG: f64 = 25.0;
/// What the positions lose, in their standard errors squared, beyond which they contradict the level: χ² of two angles at 0.0001.
const CONTRADICTION: f64 = 18.4;

/// The least share of positions that a levelled block accepts where it could not be adjusted without the level.
const LEAST_ACCEPTED: f64 = 0.8;

/// A block with the axes that would level it.
pub(super) struct Level {
    pub block: Block,
    /// Whether drones recorded the directions; otherwise the views are taken as vertical.
    pub recorded: bool,
}

impl Level {
    /// `views`: the recorded direction of each image of the block. `None` where nothing was recorded and the views differ.
    pub fn of(block: &Block, views: &[Option<[f64; 3]>]) -> Option<Self> {
        let recorded = views.iter().any(Option::is_some);
        if !recorded && !are_alike(block) {
            return None;
        }
        let direction = |view: &Option<[f64; 3]>| if recorded { view.map(|view| view.map(|v| -v)) } else { Some([0.0, 0.0, 1.0]) };
        let directions: Vec<Option<[f64; 3]>> = views.iter().map(direction).collect();
        // What the directions have in common decides, as a mount that is not level: all of them together are worth one.
        let sigma_deg = LEVEL_DEG * (directions.iter().flatten().count() as f64).sqrt();
        let mut block = block.clone();
        for (image, direction) in block.images.iter_mut().zip(directions) {
            image.axis = direction.map(|direction| AxisPrior { direction, sigma_deg });
        }
        Some(Self { block, recorded })
    }

    /// Whether what positions of images lose by the level is within their errors; `plain`: the adjustment without it.
    pub fn is_plausible(&self, plain: &AdjustmentResult, levelled: &AdjustmentResult) -> bool {
        let lost = self.square_of_positions(levelled, plain) - self.square_of_positions(plain, plain);
        lost + self.square_of_axis(levelled) < CONTRADICTION
    }

    /// Whether an adjustment that was not possible without the level has kept it, and nearly all positions.
    pub fn is_kept(&self, levelled: &AdjustmentResult) -> bool {
        let positions = || levelled.images.iter().filter_map(|image| image.gnss);
        let accepted = positions().filter(|gnss| gnss.accepted).count();
        self.square_of_axis(levelled) < CONTRADICTION && accepted as f64 >= LEAST_ACCEPTED * positions().count() as f64
    }

    /// Sum of the squares of what positions are off in an adjustment, in standard errors; those count that `plain` accepts.
    fn square_of_positions(&self, adjusted: &AdjustmentResult, plain: &AdjustmentResult) -> f64 {
        let of_one = |(known, image): (&BlockImage, &BlockImage)| {
            let Some(gnss) = known.gnss else { return 0.0 };
            let off = minus(&gnss.position, &image.pose.position);
            (0..3).filter_map(|k| gnss.sigma[k].map(|sigma| off[k] / sigma * (off[k] / sigma))).sum::<f64>()
        };
        let images = self.block.images.iter().zip(&adjusted.block.images).zip(&plain.images);
        images.filter(|(_, plain)| plain.gnss.is_some_and(|gnss| gnss.accepted)).map(|(image, _)| of_one(image)).sum()
    }

    /// Square of what the mean axis is off, in standard errors.
    fn square_of_axis(&self, adjusted: &AdjustmentResult) -> f64 {
        let (mut off, mut known) = ([0.0; 3], 0.0);
        for (axis, image) in self.block.images.iter().zip(&adjusted.block.images).filter_map(|(known, image)| Some((known.axis?, image))) {
            (0..3).for_each(|k| off[k] += axis.direction[k] - image.pose.rotation[2][k]);
            known += 1.0;
        }
        let sigma = known * LEVEL_DEG.to_radians();
        dot3(&off, &off) / (sigma * sigma)
    }
}

/// The largest standard error of an angle, of the image whose angles are surest: what all have in common.
pub(super) fn uncertainty_deg(adjusted: &AdjustmentResult) -> Option<f64> {
    let largest = |angles: [f64; 3]| angles.into_iter().fold(0.0, f64::max);
    adjusted.images.iter().filter_map(|image| image.angle_errors_deg.map(largest)).min_by(f64::total_cmp)
}

/// Whether an adjustment leaves the rotation of the whole block open.
pub(super) fn is_open(adjusted: &AdjustmentResult) -> bool {
    uncertainty_deg(adjusted).is_some_and(|error| error > UNCERTAIN_TURN_DEG)
}

fn are_alike(block: &Block) -> bool {
    let axes = || block.images.iter().map(|image| image.pose.rotation[2]);
    let sum = axes().fold([0.0; 3], |sum, axis| [0, 1, 2].map(|k| sum[k] + axis[k]));
    let length = dot3(&sum, &sum).sqrt();
    axes().all(|axis| dot3(&axis, &sum) > libm::cos(ALIKE_DEG.to_radians()) * length)
}
