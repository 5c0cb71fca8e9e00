//! What contradicts the format of an image, and what a format may hold that is not decoded.

use super::file_kind::FileKind;
use crate::json::{Constant, constant};
use crate::message::messages;
use serde::{Deserialize, Serialize};

messages! {
    /// Where an image contradicts its format.
    #[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
    #[non_exhaustive]
    pub enum Damage as "damage" {
        /// The library that decodes the format says why.
        Decoder { words: String },
        /// The file ends before its image does.
        Truncated,
        /// The file is shorter than any of this size.
        TooShort { width: u64, height: u64, least_bytes: u64, bytes: usize },
        /// A side of 0 px.
        NoPixels { width: u64, height: u64 },
        /// More bytes than a machine addresses.
        BeyondAddresses,
        TwoSizes,
        /// The image that the decoder gives has another size than the file declares.
        OtherThanHeader,
        OtherThanDirectory,
        UnknownPamLine,
        IncompletePamHeader,
        LongHeader { most_bytes: usize },
        /// A word of a header where a number belongs.
        NoNumber { word: String },
        OtherCanvas { canvas: (u64, u64), frame: (u64, u64) },
        SegmentLength { marker: u8, length: usize },
        UnexpectedMarker { marker: u8 },
        NoFrameHeader,
        TwoFrameHeaders,
        FrameHeaderLength,
        RestartInterval,
        RestartMarkers { markers: usize, expected: usize },
        ShortScan,
        NoImageData,
        NoWidth,
        NoHeight,
        TwoDirectorySizes,
        ManyTags { tags: usize, most: usize },
        ManyValues { tag: u64, values: u64, most: u64 },
        ColourMap,
    }
}

messages! {
    /// What is not decoded.
    #[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
    #[non_exhaustive]
    pub enum Unsupported as "unsupported" {
        /// A kind of file that is known, and not decoded.
        Kind { file_kind: FileKind, #[serde(deserialize_with = "constant")] formats: Constant },
        /// No format that is known.
        File { #[serde(deserialize_with = "constant")] formats: Constant },
        /// The library that decodes the format says what.
        Decoder { format: String, words: String, #[serde(deserialize_with = "constant")] formats: Constant },
        TiffDecoder { words: String },
        /// The type of a sample, as the library names it.
        Samples { format: String, samples: String },
        AnimatedWebp,
        /// The number of the frame header says how a JPEG is coded.
        JpegArithmetic { frame: u8 },
        JpegLossless { frame: u8 },
        JpegBits { bits: u8 },
        JpegComponents { components: u8 },
        /// Horizontal and vertical factors of each component.
        JpegSampling { sampling: Vec<(u8, u8)> },
        JpegScans { most: usize },
        JpegRgbApart,
        JpegLumaApart,
        TiffFloats,
        TiffSigned,
        TiffBits { bits: u64 },
        TiffColours { photometric: u64, samples: u64, bits: u64 },
        TiffCompression { compression: u64 },
        TiffTileSide,
        TiffTileRow { bytes: u64 },
        TiffBands { bands: u64 },
    }
}
