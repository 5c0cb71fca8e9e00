//! Kinds of files that people give as photographs, and that are not decoded.

use crate::message::messages;
use serde::{Deserialize, Serialize};

messages! {
    /// What a file holds that is not decoded. The text says what to make of it.
    #[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
    #[non_exhaustive]
    pub enum FileKind as "file_kind" {
        /// High Efficiency Image File Format with HEVC, as iPhones write it.
        Heic,
        Avif,
        JpegXl,
        /// Files of JPEG 2000, or its codestream alone.
        Jpeg2000,
        Ecw,
        MrSid,
        /// Samples of a sensor; `ending`: of the names of such files, in capitals.
        CameraRaw { ending: String },
        Photoshop,
        Gif,
        Pdf,
        Video,
        Archive,
    }
}
