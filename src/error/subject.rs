//! What an error is about: what is too few, which document cannot be read or written, which operation needs a larger image.

use crate::message::messages;
use serde::{Deserialize, Serialize};

messages! {
    /// What there is too little of. Projects of former versions have the texts that stand beside the names.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(rename_all = "snake_case")]
    #[non_exhaustive]
    pub enum Few as "few" {
        /// Observations of a relative orientation that agree.
        #[serde(alias = "observations that agree on a relative orientation")]
        AgreeingObservations,
        /// Different observations for a relative orientation.
        #[serde(alias = "different observations for the relative orientation")]
        DifferentObservations,
        /// Different matches for the geometry of two views.
        DifferentMatches,
        MatchesForFundamentalMatrix,
        MatchesForHomography,
        #[serde(alias = "fiducial marks")]
        FiducialMarks,
        ImagesOfBlock,
        ObservationsOfPoint,
        ObservedCoordinates,
        /// GNSS positions or control points with two observations.
        PositionsForDatum,
        ControlPointsForDatum,
        DegreesOfFreedom,
        IntersectedPoints,
        /// Links with an orthophoto that take part.
        Links,
    }
}

messages! {
    /// What is read or written.
    #[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
    #[non_exhaustive]
    pub enum Document as "document" {
        /// A file of several that belong together, or an argument of a call, by its name.
        Named { name: String },
        Block,
        Camera,
        Cameras,
        Export,
        File,
        Folder,
        GeoTiff,
        Heights,
        KeptRecord,
        Orthophoto,
        Project,
        Task,
    }
}

messages! {
    /// Where a document is wrong.
    #[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
    #[non_exhaustive]
    pub enum FilePlace as "file_place" {
        /// Of a file or a folder, or the key of a record.
        Path { path: String },
        /// Counted from 1.
        Line { line: usize },
        Byte { byte: usize },
        Length,
        Checksum,
        Content,
    }
}

messages! {
    /// What needs an image of some size.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(rename_all = "snake_case")]
    #[non_exhaustive]
    pub enum ImageOperation as "image_operation" {
        ForstnerWindow,
        GroundOperator,
        MoravecWindow,
        PlacingOnOrthophoto,
        PyramidOfScales,
    }
}
