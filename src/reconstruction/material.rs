//! What models are finished with.

use super::adjusting::KnownParameters;
use super::frame::Frame;
use super::options::ReconstructionOptions;
use super::rays::Rays;
use super::result::PointSource;
use crate::BlockDescription;
use crate::tracks::{ImageFeatures, TiePoints};

/// Common points that a pair of images keeps while the block grows and is adjusted.
pub(super) const GROWING_CONNECTION: usize = 15;

/// What is known of a block before its orientation, and how it is oriented.
pub(super) struct Known<'a> {
    pub description: &'a BlockDescription,
    pub options: &'a ReconstructionOptions,
    pub frame: &'a Frame,
}

impl Known<'_> {
    /// Standard error of a coordinate of an image measurement of a point, in px.
    pub fn mark_sigma_px(&self, point: PointSource) -> f64 {
        let own = |control: usize| self.description.control.get(control)?.sigma_px;
        let own = if let PointSource::GroundControl(control) = point { own(control) } else { None };
        own.unwrap_or(self.options.mark_sigma_px)
    }

    /// Whether a control point is a place of an orthophoto: these are behind those that were given.
    pub fn is_place(&self, name: &str) -> bool {
        let own = self.options.tested_control.unwrap_or(usize::MAX);
        self.description.control.iter().skip(own).any(|point| point.name == name)
    }
}

/// What models are finished with.
pub(super) struct Material<'a> {
    pub known: Known<'a>,
    pub points: &'a TiePoints,
    pub features: &'a [ImageFeatures<'a>],
    pub camera_of: &'a [usize],
    pub longer_side_px: &'a [f64],
    pub priors: &'a [KnownParameters],
    /// The rays of all points, the surveyed ones last; made with the first model.
    pub all: Option<Rays>,
}

impl Material<'_> {
    /// The rays of all tie points, then of all ground control points.
    pub fn all_rays(&self) -> Rays {
        let place = |image: u32, feature: u32| self.features[image as usize].positions[feature as usize].map(f64::from);
        let of_points =
            self.points.iter().map(|rays| rays.iter().map(|ray| (ray.image, place(ray.image, ray.feature))).collect::<Vec<_>>());
        let of_control = self.known.description.control.iter();
        let of_control =
            of_control.map(|control| control.measurements.iter().map(|ray| (ray.image as u32, [ray.x_px, ray.y_px])).collect::<Vec<_>>());
        Rays::new(of_points.chain(of_control), self.known.description.images.len()).with_surveyed(self.points.len())
    }
}
