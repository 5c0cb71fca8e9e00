//! The one error type: what was wrong, what was got, what is allowed.

mod allowed;
mod damage;
mod failure;
mod file_kind;
mod input;
mod refusal;
mod subject;

use crate::json::{Constant, JsonFault, JsonKind, constant};
use crate::message::messages;
use serde::{Deserialize, Serialize};

pub use allowed::Allowed;
pub use damage::{Damage, Unsupported};
pub use failure::Failure;
pub use file_kind::FileKind;
pub use input::{DescribedBy, Element, Input, Location, PointName, Side};
pub use refusal::Refusal;
pub use subject::{Document, Few, FilePlace, ImageOperation};

messages! {
    /// Why a call fails. The message says what to change; [`Error::code`] is stable for programs.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "kebab-case", deny_unknown_fields)]
    #[non_exhaustive]
    pub enum Error as "error" {
        /// An option outside its range; `got`: none where it is absent.
        InvalidOption { #[serde(deserialize_with = "constant")] field: Constant, got: Option<String>, allowed: Allowed },
        /// Options or a camera that are not the JSON object they should be.
        InvalidJson { document: Document, json_fault: JsonFault },
        /// Options, or one of them by its place, of another type; `field`: none for all of them.
        WrongType { document: Document, field: Option<String>, json_kind: JsonKind, allowed: Allowed },
        /// Array lengths or coordinates that do not fit together.
        InvalidInput { refusal: Refusal },
        /// Values from JavaScript that are not the arrays and objects that a function of the module takes, in words.
        InvalidArgument { #[serde(deserialize_with = "constant")] what: Constant, got: String, #[serde(alias = "allowed")] wanted: String },
        /// A file that is no image of a known format, or a damaged one.
        UnreadableImage { image_fault: ImageFault },
        /// A format or a pixel type that is not decoded.
        UnsupportedImage { unsupported: Unsupported },
        /// More pixels than the limit, found in the header.
        TooManyPixels { width: u64, height: u64, megapixels: f64, max_megapixels: f64 },
        /// More memory than the limit, found in the header.
        TooMuchMemory { width: u64, height: u64, needed_mb: u64, max_mb: u64 },
        /// Fewer pixels a side than an operation needs.
        ImageTooSmall { width: usize, height: usize, image_operation: ImageOperation, min_side: usize },
        /// A window that leaves the image.
        WindowOutside { side: usize, col: usize, row: usize, width: usize, height: usize },
        /// A window in which all grey values are equal: it has no moments.
        ConstantWindow { side: usize, col: usize, row: usize },
        /// Too few observations for the unknowns.
        TooFew { few: Few, got: usize, needed: usize },
        /// Observations whose geometry does not determine the unknowns.
        Degenerate { computation: Computation, cause: Cause },
        /// An image of a block whose orientation its observations do not determine; images count from 0.
        UndeterminedImage { computation: Computation, image: usize, cause: Cause },
        /// An adjustment that did not converge.
        NotConverged { computation: Computation, iterations: usize, cause: Cause },
        /// A file that is not what it should be, is damaged, or is of a newer version.
        UnreadableFile { document: Document, file_place: Option<FilePlace>, file_fault: FileFault },
        /// Images whose names formats cannot hold; the error of the first format.
        NotExportable { formats: String, error: Box<Error> },
        /// A run of a block that no image and no pair stops, but what goes on around it.
        Interrupted { interruption: Interruption },
        /// A sink that takes no more text.
        NotWritten { document: Document },
        /// A call of the module before it is loaded. The JavaScript around the module throws it.
        NotLoaded,
    }
}

impl std::error::Error for Error {}

/// Refuses an input.
pub(crate) fn refuse<T>(refusal: Refusal) -> Result<T, Error> {
    Err(refusal.into_error())
}

impl Refusal {
    pub(crate) fn into_error(self) -> Error {
        Error::InvalidInput { refusal: self }
    }
}

impl Unsupported {
    pub(crate) fn into_error(self) -> Error {
        Error::UnsupportedImage { unsupported: self }
    }
}

impl Error {
    /// A name for programs; it does not change between versions.
    pub fn code(&self) -> &'static str {
        match self {
            Error::InvalidOption { .. } => "invalid-option",
            Error::InvalidJson { .. } | Error::WrongType { .. } => "invalid-json",
            Error::InvalidInput { .. } | Error::InvalidArgument { .. } | Error::NotExportable { .. } => "invalid-input",
            Error::UnreadableImage { .. } => "unreadable-image",
            Error::UnsupportedImage { .. } => "unsupported-image",
            Error::TooManyPixels { .. } => "too-many-pixels",
            Error::TooMuchMemory { .. } => "too-much-memory",
            Error::ImageTooSmall { .. } => "image-too-small",
            Error::WindowOutside { .. } => "window-outside",
            Error::ConstantWindow { .. } => "constant-window",
            Error::TooFew { .. } => "too-few",
            Error::Degenerate { .. } | Error::UndeterminedImage { .. } => "degenerate",
            Error::NotConverged { .. } => "not-converged",
            Error::UnreadableFile { .. } => "unreadable-file",
            Error::Interrupted { .. } => "interrupted",
            Error::NotWritten { .. } => "not-written",
            Error::NotLoaded => "not-loaded",
        }
    }

    /// Whether the caller's options are at fault rather than the data: a command exits with 2 for these, with 1 for the rest.
    pub fn is_usage(&self) -> bool {
        matches!(self, Error::InvalidOption { .. } | Error::InvalidJson { .. } | Error::WrongType { .. })
    }
}

messages! {
    /// What is wrong with an image file.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
    pub enum ImageFault as "image_fault" {
        Empty,
        /// It contradicts its format.
        Damaged { format: String, damage: Damage },
        /// The mask of an image.
        Mask { name: String, error: Box<Error> },
    }
}

messages! {
    /// What is wrong with a file or a folder.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
    pub enum FileFault as "file_fault" {
        /// The system refuses it, in its words.
        System { message: String },
        /// It is not UTF-8.
        NotText,
        /// A field is not as it should be.
        Content { json_fault: Box<JsonFault> },
        /// A field of a line.
        NoNumber { field: String, word: String },
        NoWholeNumber { field: String, word: String },
        /// A line ends before a field.
        ShortLine { field: String },
        /// What a line defines was defined before.
        CameraAgain { camera: u64 },
        ImageAgain { image: u64 },
        PointAgain { point: u64 },
        /// What a line refers to.
        NoCamera { camera: u64 },
        NoImage { image: u64 },
        NoFeature { image: usize, feature: usize },
        CameraModel { model: String, parameters: usize },
        ZeroQuaternion,
        /// A name of several words.
        AfterName { word: String },
        NoFeatures,
        /// Its first line is not that of a project.
        NoProject { line: String },
        /// The same, and why.
        NoHeader { line: String, json_fault: Box<JsonFault> },
        OtherFormat { format: String, wanted: String },
        OtherVersion { version: u32, newest: u32 },
        /// So many bytes follow the first line, and so many it declares.
        OtherLength { bytes: usize, declared: usize },
        OtherChecksum,
        /// A project of a pair where a block is wanted, or the reverse.
        HoldsPair,
        HoldsBlock,
        /// A kept record.
        RecordChanged,
        /// Another run works on the folder.
        InUse { owner: String },
    }
}

messages! {
    /// Why a run cannot go on.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
    pub enum Interruption as "interruption" {
        /// An image is another one than at the start of the run.
        ImageChanged { name: String },
        /// What came of a job.
        UnreadableWork,
        /// It was ended before all of its jobs were done.
        Unfinished,
        Job { failure: Failure },
        Refinement { name: String, failure: Failure },
    }
}

messages! {
    /// What is computed.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(rename_all = "snake_case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum Computation as "computation" {
        AffineTransformation,
        BundleAdjustment,
        /// The components of the base across b, in units of it.
        ByAndBz,
        Datum,
        /// The textbook form of the relative orientation.
        DeterminantForm,
        DistortionCorrection,
        FreeNetwork,
        FundamentalMatrix,
        Homography,
        OmegaAndKappa,
        RelativeOrientation,
        TwoViewGeometry,
    }
}

messages! {
    /// Why observations do not determine what is computed, or why its iterations do not converge.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    #[non_exhaustive]
    pub enum Cause as "cause" {
        /// The points of a photo lie on a line; `width` is that across the line as a share of the length.
        PointsOnLine { side: Side, #[serde(with = "crate::json::infinite")] width: f64, least: f64 },
        /// Fiducial marks lie on a line, as measured or as calibrated.
        MarksOnLine { calibrated: bool, #[serde(with = "crate::json::infinite")] width: f64, least: f64 },
        /// What is known of the positions of images and points lies on a line.
        PositionsOnLine { #[serde(with = "crate::json::infinite")] width: f64, least: f64 },
        /// The approximate positions of the block have no extent.
        NoExtent,
        /// All images have the same position.
        OnePosition,
        /// Both photos have the same coordinates.
        NoParallax,
        /// The median parallax beside a rotation, in standard errors of a photo coordinate.
        NoBase { #[serde(with = "crate::json::infinite")] parallax: f64, least: f64 },
        /// The unknowns can hardly be told apart.
        Inseparable { #[serde(with = "crate::json::infinite")] condition: f64, most: f64 },
        /// Of an angle or of the direction of the base.
        LargeErrors { #[serde(with = "crate::json::infinite")] largest_deg: f64 },
        /// Matches agree with the orientation no better than wrong ones do; in px of the left photo.
        LargeResiduals { #[serde(with = "crate::json::infinite")] sigma0_px: f64, most_px: f64 },
        /// Too few observations agree for an orientation, and all together have none.
        WeakSupport { agreeing: usize, observations: usize },
        /// Too many points lie behind the cameras.
        BehindCameras { in_front: usize, points: usize },
        /// `share`: 1 - R² of the unknown that hardly anything determines.
        SingularNormals { #[serde(with = "crate::json::infinite")] share: f64, least: f64 },
        /// The base has this share of its length along x.
        BaseAcrossX { along_x: f64, least: f64 },
        /// The determinant form divides by the component of the base along x.
        NoBaseAlongX,
        /// φ is ±90°.
        GimbalLock,
        /// No more matches agree than would by chance.
        Chance { agreeing: usize, matches: usize },
        /// More than one matrix fulfils the conditions.
        SeveralMatrices,
        TooManyOnLine,
        /// The right photo is turned by more than 60° from a vertical start.
        TurnedAway,
        /// The base rises by more than 60° from a vertical start.
        RisingBase,
        /// The last step by the length that counts as converged.
        LongSteps { #[serde(with = "crate::json::infinite")] ratio: f64 },
        /// No step lowers the residuals any more; the last one in standard errors.
        Stalled { #[serde(with = "crate::json::infinite")] last_step: f64 },
        /// Gross errors, positions or weights still change after the last round.
        Unsettled { unsettled: Unsettled, rounds: usize },
        /// A point lies in the plane of a projection centre.
        PointInPlane,
        /// The rotation of an image follows from nothing.
        NoRotation,
        /// The position of an image follows from nothing.
        NoPosition,
        /// An image has few observations of points that others see.
        FewObservations { observations: usize, needed: usize },
        /// A parameter of a camera, which counts from 0, follows from nothing.
        NoCameraParameter { camera: usize, camera_parameter: CameraParameter },
        /// The block falls into parts without common points; two images of different ones.
        Parts { parts: usize, first: usize, second: usize },
        /// The camera's distortion has no inverse at a position.
        FoldedAt { x_px: f64, y_px: f64 },
        /// The camera's distortion has no inverse at a distance from the principal point.
        FoldedBeyond { radius_px: f64 },
    }
}

messages! {
    /// What may change from round to round of an adjustment.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(rename_all = "snake_case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum Unsettled as "unsettled" {
        GrossErrors,
        Positions,
        Weights,
    }
}

messages! {
    /// An unknown of a camera.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(rename_all = "snake_case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum CameraParameter as "camera_parameter" {
        Focal,
        PrincipalX,
        PrincipalY,
        K1,
        K2,
        K3,
        P1,
        P2,
    }
}

impl From<&Error> for Failure {
    fn from(error: &Error) -> Self {
        Self::Refused {
            code: error.code().into(),
            message: error.to_string(),
            usage: error.is_usage(),
            error: serde_json::to_value(error).ok().map(Box::new),
        }
    }
}
