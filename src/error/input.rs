//! The names of what is given, and of the places where it stands.

use crate::message::messages;
use serde::{Deserialize, Serialize};

messages! {
    /// A photo of a pair.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(rename_all = "snake_case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum Side as "side" {
        Left,
        Right,
    }
}

messages! {
    /// What is given.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(rename_all = "snake_case")]
    #[non_exhaustive]
    pub enum Input as "input" {
        AxisSigma,
        Base,
        CameraDistortion,
        CameraFocalLength,
        CameraOfImage,
        CameraOfPrior,
        CameraParameter,
        CameraPrincipalPoint,
        CameraSigma,
        FeaturesOfImages,
        FiducialTable,
        ControlTable,
        FreeRadial,
        Height,
        Image,
        ImageCoordinates,
        ImageOfRay,
        ImageSize,
        GeometriesOfProject,
        ImagesOfProject,
        CamerasOfProject,
        PointsOfProject,
        EditsOfSteps,
        ObservationsOfPoint,
        ImagesOfModel,
        ImagesOfBlock,
        CamerasOfBlock,
        PointsOfModel,
        ObservationsOfModel,
        PlacesOfStrip,
        VerdictsOfPair,
        MatchedOfPair,
        FramesOfPair,
        ObservationsOfPair,
        ResidualsOfPair,
        ScoresOfPair,
        Latitude,
        LeftDescriptors,
        LeftFeatures,
        LeftPoints,
        Longitude,
        MarkTable,
        ObservationTable,
        PhotoOfBlock,
        PixelSide,
        Point,
        PointOfControl,
        PointOfRay,
        PointsOfBlock,
        Position,
        PositionSigma,
        PositionTable,
        MarkSigma,
        RaySigma,
        RightDescriptors,
        RightFeatures,
        RightPoints,
        SurveyedPoint,
        SurveyedPointOfBlock,
        Text,
        Weight,
    }
}

messages! {
    /// Where a value stands.
    #[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
    #[non_exhaustive]
    pub enum Location as "location" {
        Camera { camera: usize },
        NamedCamera { only: bool, number: usize, first: Option<String>, more: usize },
        CameraOfFile { camera: usize },
        CameraOfImages { images: String },
        CameraOfImage,
        CameraOfPrior,
        Control { name: String },
        ElementOfControl { element: Element, control: usize },
        ElementOfImage { element: Element, image: usize },
        ElementOfRay { element: Element, ray: usize },
        Geometry { side: Side },
        Image { name: String },
        ImageIndex { image: usize },
        Pair,
        Point { point: usize },
        Prior { camera: usize },
    }
}

messages! {
    /// What is given of an image, a ray or a control point.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(rename_all = "snake_case")]
    #[non_exhaustive]
    pub enum Element as "element" {
        AxisDirection,
        AxisSigma,
        Camera,
        Coordinates,
        GnssPosition,
        GnssSigma,
        Image,
        Point,
        Position,
        Rotation,
        Sigma,
        Weight,
    }
}

messages! {
    /// A point of a block, as texts name it: by the number that it has in files and views; indices count from 0.
    #[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
    #[non_exhaustive]
    pub enum PointName as "point_name" {
        Control { name: String },
        ControlIndex { point: usize },
        Manual { number: u32 },
        TiePoint { number: u32 },
    }
}

messages! {
    /// The descriptors that points have.
    #[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
    #[non_exhaustive]
    pub enum DescribedBy as "described" {
        None,
        Moments { descriptors: usize },
        Gradients { bytes: usize },
    }
}
