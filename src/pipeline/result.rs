//! What the run of a block finds.

use super::cameras::InitialCamera;
use super::{GivenPosition, OnOrthophoto, RunInput};
use crate::crs::Geoid;
use crate::reconstruction::PointNumbers;
use crate::{
    BlockEdit, BlockModel, Connection, ExifImage, ExifPosition, Failure, JoinCounts, PointSource, Reconstruction, RefinementOutcome,
    Remark, SharedPoints, TwoView,
};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A block from its images to its orientation: all that is written and shown of it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BlockRun {
    /// What it was made of.
    pub input: RunInput,
    /// The images that were read; the indices of all that follows count these.
    pub images: Vec<RunImage>,
    pub skipped: Vec<SkippedImage>,
    /// Names of masks that belong to no image.
    pub unused_masks: Vec<String>,
    /// Names of images that image measurements of control points name and that are not in the block, ascending.
    pub unknown_images: Vec<String>,
    pub remarks: Vec<Remark>,
    /// Before the calibration.
    pub cameras: Vec<InitialCamera>,
    /// The pairs that were matched.
    pub connections: Vec<Connection>,
    /// Of each of `connections`; its inliers are left out, since all matches agree with it.
    pub geometries: Vec<Option<TwoView>>,
    /// Absent where an older project file does not say.
    pub points: Option<JoinedPoints>,
    /// Absent where observations are not refined.
    pub refinement: Option<RefinementTable>,
    /// Or why the block has none.
    pub reconstruction: Result<Reconstruction, Failure>,
    /// The largest model of the reconstruction, or, without one, the points that were chosen.
    pub model: BlockModel,
    /// What was changed by hand, and the block before that; absent where nothing was.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub edited: Option<Box<EditedRun>>,
    /// What came of the orthophoto that it was given; absent where it was given none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub orthophoto: Option<OnOrthophoto>,
    /// The part about the block of the geoid that it was given; absent where it was given none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub geoid: Option<Geoid>,
}

impl BlockRun {
    /// The number of a point of the model that is written, also where it is rejected; absent without such a model.
    pub fn point_number(&self, point: PointSource) -> Option<u32> {
        let Reconstruction { models, .. } = self.reconstruction.as_ref().ok()?;
        Some(PointNumbers::new(&models.first()?.points, self.found_points()).of(point))
    }

    /// The block with numbers of its points, which files of former versions do not hold.
    pub(crate) fn numbered(mut self) -> Self {
        let tie_points = self.found_points();
        let found = self.edited.as_mut().map(|edited| (&mut edited.model, Some(&edited.reconstruction)));
        for (model, reconstruction) in [Some((&mut self.model, self.reconstruction.as_ref().ok())), found].into_iter().flatten() {
            let Some(first) = reconstruction.and_then(|reconstruction| reconstruction.models.first()) else { continue };
            let numbers = PointNumbers::new(&first.points, tie_points);
            let written = first.points.iter().zip(&first.adjusted.points).filter(|(_, known)| known.is_some());
            model.points.iter_mut().zip(written).for_each(|(point, (source, _))| point.number = Some(numbers.of(*source)));
        }
        self
    }

    /// How many tie points there were to choose from; 0 where its file does not say.
    pub(super) fn found_points(&self) -> usize {
        self.points.as_ref().map_or(0, |points| points.count)
    }

    /// The probability of each tie point of the model that is written.
    pub(super) fn confidences(&self) -> BTreeMap<u32, f64> {
        let model = self.reconstruction.as_ref().ok().and_then(|Reconstruction { models, .. }| models.first());
        let written = model.iter().flat_map(|model| model.points.iter().zip(&model.adjusted.points)).filter(|(_, known)| known.is_some());
        let of_point = written.zip(&self.model.points).filter_map(|((source, _), point)| match source {
            PointSource::TiePoint(index) => Some((*index, point.confidence)),
            PointSource::GroundControl(_) | PointSource::Manual(_) => None,
        });
        of_point.collect()
    }
}

/// Edits of a block, and what it was without them.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct EditedRun {
    /// In their order.
    pub edits: Vec<BlockEdit>,
    /// How many of them each step has, where some were made together; empty where each is a step.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub steps: Vec<usize>,
    pub reconstruction: Reconstruction,
    pub model: BlockModel,
    /// What had come of the orthophoto, where edits made something else of it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub orthophoto: Option<OnOrthophoto>,
    /// What is to be said of places of an orthophoto that edits added, beside what was said of the block before.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub remarks: Vec<Remark>,
}

/// An image that was read.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct RunImage {
    /// File name; no two images have the same.
    pub name: String,
    /// Of its record of features.
    pub key: String,
    /// SHA-256 of the file in hexadecimal digits.
    pub content: String,
    pub width_px: u32,
    pub height_px: u32,
    /// Absent where an older project file does not say.
    pub features: Option<u32>,
    /// Whether a mask belongs to it.
    pub masked: bool,
    pub exif: ExifImage,
    /// The GNSS position that a table gave, in place of that of the file.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub given: Option<GivenPosition>,
    /// Index of its camera.
    pub camera: usize,
}

impl RunImage {
    /// Its GNSS position: that of a table, else that of its file.
    pub fn gnss(&self) -> Option<&ExifPosition> {
        self.given.as_ref().map(|given| &given.position).or(self.exif.position.as_ref())
    }
}

/// An image that is not in the block, and why.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct SkippedImage {
    pub name: String,
    pub reason: Failure,
}

/// What came of joining the matches of all pairs.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct JoinedPoints {
    pub join: JoinCounts,
    pub count: usize,
    /// Observations of all points.
    pub rays: usize,
    /// How many points have 0, 1, 2, … rays.
    pub histogram: Vec<u32>,
    /// The points that each two images have in common.
    pub shared: Vec<SharedPoints>,
}

/// What became of the observations that were refined, those of each point one after the other.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct RefinementTable {
    /// The observations of point i are those from `starts[i]` to before `starts[i + 1]`.
    pub starts: Vec<u32>,
    pub observations: Vec<RefinedObservation>,
}

/// What became of an observation.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct RefinedObservation {
    /// Index of the image.
    pub image: u32,
    /// Where it is now, in px.
    pub position_px: [f32; 2],
    pub outcome: RefinementOutcome,
    /// Relative to the observation to which it was matched, in px; absent, as the correlation, where it was not refined.
    pub standard_error_px: Option<f32>,
    /// Of the matched windows, -1..1.
    pub correlation: Option<f32>,
}
