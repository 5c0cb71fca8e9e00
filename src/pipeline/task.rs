//! What a worker is told of a job, beside the bytes that it needs.

use super::cameras::PairCamera;
use crate::georeferenced::Area;
use crate::{FeatureOptions, NearestOptions, RefinementOptions, TwoViewOptions};
use serde::{Deserialize, Serialize};

/// A job as a worker takes it, beside the bytes that it needs.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum Task {
    /// An image file, and perhaps its mask, to a record of features.
    Features(FeatureTask),
    /// Coarse descriptors of an image and of all behind it to a record of how many it has in common with each.
    Likeness(LikenessTask),
    /// Two records of features to a record of verified matches.
    Pair(Box<PairTask>),
    /// An image file and its record of features to a record of windows.
    Windows(WindowTask),
    /// Windows of several images to refined observations.
    Refine(RefineTask),
    /// The file of a geoid to its part about the block.
    Geoid(GeoidTask),
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct GeoidTask {
    /// Of the file.
    pub(super) name: String,
    pub(super) area: Area,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FeatureTask {
    pub(super) key: String,
    pub(super) options: FeatureOptions,
    /// Name of the mask, where there is one.
    pub(super) mask: Option<String>,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LikenessTask {
    pub(super) key: String,
    /// Of the image itself and of each behind it: how many descriptors it has.
    pub(super) counts: Vec<usize>,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PairTask {
    pub(super) key: String,
    /// Of both records of features.
    pub(super) features: [String; 2],
    pub(super) cameras: [PairCamera; 2],
    pub(super) nearest: NearestOptions,
    pub(super) geometry: TwoViewOptions,
    pub(super) least_matches: u32,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WindowTask {
    pub(super) key: String,
    /// Of the record of features.
    pub(super) features: String,
    /// The features that observations are of.
    pub(super) chosen: Vec<u32>,
    pub(super) options: RefinementOptions,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RefineTask {
    /// The observations of point i are those from `starts[i]` to before `starts[i + 1]`.
    pub(super) starts: Vec<u32>,
    /// Index of the image of each.
    pub(super) images: Vec<u32>,
    /// x, y and scale in px and direction in rad of each.
    pub(super) shapes: Vec<[f32; 4]>,
    /// As [`ObservationWindows`](crate::ObservationWindows) has them.
    pub(super) places: Vec<[u32; 4]>,
    pub(super) options: RefinementOptions,
}
