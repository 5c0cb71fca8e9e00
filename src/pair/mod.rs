//! The whole way of one pair: points, descriptors, offset, matches, photo coordinates, relative orientation.

mod described;
mod epipolar;
mod frames;
mod geometry;
mod orienting;
mod rounds;
mod verification;

pub use described::{DescribedImage, describe_image};
pub use epipolar::epipolar_line;
pub use geometry::{PairInterior, photo_interior};
pub use orienting::{match_weights, observations, orient_matches};
pub use rounds::{PairMatching, match_in_rounds};
pub use verification::{FeatureMatchOptions, VerifiedMatches, match_features};

use crate::message::messages;
use crate::{
    CameraMm, Degeneracy, Error, ExifCamera, Expectation, Fiducial, FiducialModel, GradientOptions, GreyView, MatchOptions, MatchSet,
    MultiscaleOptions, NearestTable, NoGeometry, OffsetField, Operator, OrientationOptions, Parameter, PointOptions, PointSet,
    RelativeOrientation, Side, Strategy, TwoView, TwoViewOptions, WindowOptions, estimate_offset,
};
use serde::{Deserialize, Serialize};

/// The options of all stages.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct PairSettings {
    pub points: PointOptions,
    /// Of the operator of that name.
    pub multiscale: MultiscaleOptions,
    pub window: WindowOptions,
    /// Of the strategy of that name.
    pub gradient: GradientOptions,
    pub matching: MatchOptions,
    /// The geometry of the two views, by which the strategy gradient verifies its matches. Cameras that the pair knows take the place of
    /// those named here.
    pub geometry: TwoViewOptions,
    pub orientation: OrientationOptions,
}

impl PairSettings {
    /// All parameters, in the order of the pipeline.
    pub fn parameters() -> impl Iterator<Item = &'static Parameter> {
        [
            PointOptions::PARAMETERS,
            MultiscaleOptions::PARAMETERS,
            WindowOptions::PARAMETERS,
            GradientOptions::PARAMETERS,
            MatchOptions::PARAMETERS,
            TwoViewOptions::PARAMETERS,
            OrientationOptions::PARAMETERS,
        ]
        .into_iter()
        .flatten()
    }

    /// The settings with every absent option that follows from the others: the operator of the strategy, its roundness and window, the
    /// ambiguity ratio. What follows from the images stays absent. Everything that takes settings resolves them so.
    pub fn resolved(&self) -> Self {
        let gradients = self.matching.strategy == Strategy::Gradient;
        let points = self.points.resolved(if gradients { Operator::Multiscale } else { Operator::Ground2 });
        let matching = MatchOptions { ambiguity: Some(self.matching.ambiguity()), ..self.matching.clone() };
        Self { points, matching, ..self.clone() }
    }
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
    pub camera: Option<CameraMm>,
    pub left: PhotoInput,
    pub right: PhotoInput,
    /// Right minus left position `[dx, dy]` in px; absent: estimated.
    pub offset: Option<[f64; 2]>,
}

/// The outcome of one pair.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PairResult {
    pub left: PointSet,
    pub right: PointSet,
    /// Absent where the strategy needs none and none was given.
    pub offset: Option<OffsetField>,
    pub matching: MatchSet,
    /// As in [`PairMatching`].
    pub geometry: Option<Result<TwoView, NoGeometry>>,
    pub interior: Option<PairInterior>,
    /// The orientation; or why there is none.
    pub orientation: Result<RelativeOrientation, NoOrientation>,
}

messages! {
    /// Why a pair has no orientation.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum NoOrientation as "no_orientation" {
        /// No camera is given, and an image names none.
        NoCamera { side: Side },
        /// Fiducial marks without a focal length.
        NoFocalLength,
        /// An image with neither fiducial marks nor a pixel size.
        NoPixelSize { side: Side },
        NoGeometry { no_geometry: NoGeometry },
        PureRotation,
        /// The orientation refuses the matches.
        Refused {
            #[cfg_attr(target_arch = "wasm32", tsify(type = "{ kind: string }"))]
            error: Error,
        },
    }
}

/// An image with the camera that its file names.
#[derive(Clone, Copy)]
pub struct PairImage<'a> {
    pub grey: GreyView<'a>,
    pub exif: Option<&'a ExifCamera>,
    /// As large as the image: points whose pixel is 0 in it are left out.
    pub mask: Option<GreyView<'a>>,
}

/// Matches and orients a pair.
///
/// Where no camera is known, or the matches do not determine an orientation, the matches are given all the same.
///
/// # Errors
/// As the stages: [`Error::InvalidOption`], [`Error::ImageTooSmall`]; [`Error::InvalidInput`] for a camera or fiducials that do not fit.
pub fn match_pair(left: PairImage<'_>, right: PairImage<'_>, input: &PairInput, settings: &PairSettings) -> Result<PairResult, Error> {
    // What is wrong with the camera is told before the images are searched.
    geometry::pair_interior(left, right, input)?.ok();
    let described = [describe_image(left.grey, left.mask, settings)?, describe_image(right.grey, right.mask, settings)?];
    match_described_pair(left, right, described, None, input, settings)
}

/// The rest of [`match_pair`], once both images are described: for callers that do so at the same time, and that may also have searched for
/// the nearest right descriptors of all left ones. Masks have had their effect.
///
/// # Errors
/// As [`match_pair`].
pub fn match_described_pair(
    left: PairImage<'_>,
    right: PairImage<'_>,
    described: [DescribedImage; 2],
    nearest: Option<&NearestTable>,
    input: &PairInput,
    settings: &PairSettings,
) -> Result<PairResult, Error> {
    let interior = geometry::pair_interior(left, right, input)?;
    let strategy = settings.matching.strategy;
    let offset = match input.offset {
        Some([dx, dy]) => Some(OffsetField::constant(dx, dy)),
        None => strategy.needs_offset().then(|| estimate_offset(left.grey, right.grey)),
    };
    let images = [described[0].match_image(left.grey, strategy), described[1].match_image(right.grey, strategy)];
    let expected = offset.clone().unwrap_or(OffsetField::constant(0.0, 0.0));
    let PairMatching { set: matching, geometry } =
        match_in_rounds(images, Expectation { nearest, ..Expectation::from(&expected) }, interior.as_ref().ok(), settings)?;
    let found = geometry.as_ref().and_then(|geometry| geometry.as_ref().ok());
    let sizes = [left, right].map(|image| (image.grey.width(), image.grey.height()));
    let interior = interior.or_else(|reason| found.and_then(|found| PairInterior::estimated(found.focal.as_ref()?, sizes)).ok_or(reason));
    let is_rotation = found.is_some_and(|found| found.degenerate == Some(Degeneracy::PureRotation));
    let orientation = match (&interior, &geometry) {
        (Err(reason), _) => Err(reason.clone()),
        (Ok(_), Some(Err(no_geometry))) => Err(NoOrientation::NoGeometry { no_geometry: *no_geometry }),
        _ if is_rotation => Err(NoOrientation::PureRotation),
        (Ok(interior), _) => match orient_matches(&matching.matches, interior, &settings.orientation) {
            Err(error) if error.is_usage() => return Err(error),
            outcome => outcome.map_err(|error| NoOrientation::Refused { error }),
        },
    };
    let [left, right] = described.map(|image| image.set);
    Ok(PairResult { left, right, offset, matching, geometry, interior: interior.ok(), orientation })
}
