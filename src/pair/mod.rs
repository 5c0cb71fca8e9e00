//! The whole way of one pair: points, descriptors, offset, matches, photo coordinates, relative orientation.

mod geometry;
mod rounds;

pub use geometry::{PairInterior, photo_interior};
pub use rounds::{match_in_rounds, match_weights, observations, orient_matches};

use crate::{
    Camera, Error, ExifCamera, Fiducial, FiducialModel, GreyView, MatchImage, MatchOptions, MatchSet, OffsetField, OrientationOptions,
    PointOptions, PointSet, RelativeOrientation, WindowOptions, describe, detect, estimate_offset,
};
use serde::{Deserialize, Serialize};

/// The options of all stages.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct PairSettings {
    pub points: PointOptions,
    pub window: WindowOptions,
    pub matching: MatchOptions,
    pub orientation: OrientationOptions,
}

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
    pub camera: Option<Camera>,
    pub left: PhotoInput,
    pub right: PhotoInput,
    /// Right minus left position `[dx, dy]` in px; absent: estimated.
    pub offset: Option<[f64; 2]>,
}

/// The outcome of one pair.
#[derive(Debug, Clone, PartialEq)]
pub struct PairResult {
    pub left: PointSet,
    pub right: PointSet,
    pub offset: OffsetField,
    pub matching: MatchSet,
    pub interior: Option<PairInterior>,
    /// The orientation; or, in words, why there is none.
    pub orientation: Result<RelativeOrientation, String>,
}

/// An image with the camera that its file names.
#[derive(Clone, Copy)]
pub struct PairImage<'a> {
    pub grey: GreyView<'a>,
    pub exif: Option<&'a ExifCamera>,
}

/// Matches and orients a pair.
///
/// Where no camera is known, or the matches do not determine an orientation, the matches are given all the same.
///
/// # Errors
/// As the stages: [`Error::InvalidOption`], [`Error::ImageTooSmall`]; [`Error::InvalidInput`] for a camera or fiducials that do not fit.
pub fn match_pair(left: PairImage<'_>, right: PairImage<'_>, input: &PairInput, settings: &PairSettings) -> Result<PairResult, Error> {
    // What is wrong with the camera is told before the images are searched.
    let interior = geometry::pair_interior(left, right, input)?;
    let [left_points, right_points] = [detect(left.grey, &settings.points)?, detect(right.grey, &settings.points)?];
    let described = |image: PairImage<'_>, set: &PointSet| match settings.matching.strategy.measure() {
        Some(measure) => describe(image.grey, &set.points, &settings.window, measure),
        None => Ok(Vec::new()),
    };
    let descriptors = [described(left, &left_points)?, described(right, &right_points)?];
    let offset = match input.offset {
        Some([dx, dy]) => OffsetField::constant(dx, dy),
        None => estimate_offset(left.grey, right.grey),
    };
    let images = [
        MatchImage { grey: left.grey, points: &left_points.points, descriptors: &descriptors[0] },
        MatchImage { grey: right.grey, points: &right_points.points, descriptors: &descriptors[1] },
    ];
    let matching = match_in_rounds(images, &offset, interior.as_ref().ok(), settings)?;
    let orientation = match &interior {
        Err(reason) => Err(reason.clone()),
        Ok(interior) => match orient_matches(&matching.matches, interior, &settings.orientation) {
            Err(error) if error.is_usage() => return Err(error),
            outcome => outcome.map_err(|error| error.to_string()),
        },
    };
    Ok(PairResult { left: left_points, right: right_points, offset, matching, interior: interior.ok(), orientation })
}
