//! What models are finished with.

use super::adjusting::CameraPrior;
use super::frame::Frame;
use super::options::ReconstructionOptions;
use super::rays::Rays;
use crate::BlockDescription;
use crate::tracks::{ImageFeatures, TiePoints};

/// Common points that a pair of images keeps while the block grows and is adjusted.
pub(super) const GROWING_CONNECTION: usize = 15;

/// What models are finished with.
pub(super) struct Material<'a> {
    pub description: &'a BlockDescription,
    pub points: &'a TiePoints,
    pub features: &'a [ImageFeatures<'a>],
    pub options: &'a ReconstructionOptions,
    pub frame: &'a Frame,
    pub camera_of: &'a [usize],
    pub longer_side_px: &'a [f64],
    pub priors: &'a [CameraPrior],
    /// The rays of all points, the surveyed ones last; made with the first model.
    pub all: Option<Rays>,
}

impl Material<'_> {
    /// The rays of all tie points, then of all ground control points.
    pub fn all_rays(&self) -> Rays {
        let place = |image: u32, feature: u32| self.features[image as usize].positions[feature as usize].map(f64::from);
        let of_points =
            self.points.iter().map(|rays| rays.iter().map(|ray| (ray.image, place(ray.image, ray.feature))).collect::<Vec<_>>());
        let of_control = self.description.control.iter();
        let of_control =
            of_control.map(|control| control.measurements.iter().map(|ray| (ray.image as u32, [ray.x_px, ray.y_px])).collect::<Vec<_>>());
        Rays::new(of_points.chain(of_control), self.description.images.len()).with_surveyed(self.points.len())
    }
}
