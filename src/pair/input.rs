//! What is known of a pair before it is matched.

use crate::{CameraMm, ExifCamera, Fiducial, FiducialModel, GreyView, PartlyGiven};
use serde::{Deserialize, Serialize};

/// What is known of one image of a pair.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct PhotoInput {
    /// Measured fiducial marks; none for a digital camera.
    pub fiducials: Vec<Fiducial>,
    pub model: FiducialModel,
    /// Place `[col, row]` of the image's top-left pixel in the scan whose fiducials were measured.
    pub origin: Option<[f64; 2]>,
}

/// What is known of a pair beside its grey values.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct PairInput {
    /// The camera of both images; absent: that of their EXIF.
    pub camera: Option<CameraMm>,
    pub left: PhotoInput,
    pub right: PhotoInput,
    /// Right minus left position `[dx, dy]` in px; absent: estimated.
    pub offset: Option<[f64; 2]>,
}

impl PartlyGiven for PairInput {}

/// An image with the camera that its file names.
#[derive(Clone, Copy)]
pub struct PairImage<'a> {
    pub grey: GreyView<'a>,
    pub exif: Option<&'a ExifCamera>,
    /// As large as the image: points whose pixel is 0 in it are left out.
    pub mask: Option<GreyView<'a>>,
}
