//! What of the input is not taken as it was given, or is hardly right; and why jobs fail.

use crate::Error;
use serde::{Deserialize, Serialize};
use std::fmt;

/// What the user is told of the input beside the images that were skipped.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Remark {
    /// No image has a name that fits the pattern of a camera.
    UnusedCamera { images: String },
    /// A focal length that hardly is one in px.
    DoubtfulFocal {
        camera: String,
        focal_px: f64,
        /// The focal length in longer sides of the image.
        sides: f64,
        /// What is usual of these.
        usual: [f64; 2],
    },
    /// GNSS positions, or their heights, that cannot be: images, each with the value.
    ImpossiblePositions { images: Vec<[String; 2]> },
    /// The block comes from a project file that holds less than is known of a block.
    OlderProject { version: u32 },
}

/// Images are named one by one up to so many.
const NAMED: usize = 5;

impl fmt::Display for Remark {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OlderProject { version } => {
                write!(f, "the project file is of version {version}: it does not hold features, cameras as given, or standard errors")
            }
            Self::UnusedCamera { images } => write!(f, "the camera of {images} is of none of the images"),
            Self::DoubtfulFocal { camera, focal_px, sides, usual: [least, most] } => {
                let in_mm = if sides < least { ": is it in mm?" } else { "" };
                let rounded = format!("{sides:.1e}").parse().unwrap_or(*sides);
                write!(
                    f,
                    "the focal length of {camera} is {focal_px} px, {rounded} of the longer side of the image, where {least} to {most} are usual{in_mm}"
                )
            }
            Self::ImpossiblePositions { images } => {
                let named: Vec<String> = images.iter().take(NAMED).map(|[name, value]| format!("{name} ({value})")).collect();
                let more = images.len().checked_sub(NAMED + 1).map_or(String::new(), |more| format!(" and {} more", more + 1));
                write!(f, "impossible recorded positions and heights are left out: {}{more}", named.join(", "))
            }
        }
    }
}

/// Why a job of the run, or the reading of a file that it needs, failed.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Failure {
    /// The host could not read the file, in its words.
    Unreadable { message: String },
    /// The job refused its input: [`Error::code`], its text, and [`Error::is_usage`].
    Refused { code: String, message: String, usage: bool },
    /// The worker broke down, as where memory ran out.
    BrokeOff { message: String },
}

impl From<&Error> for Failure {
    fn from(error: &Error) -> Self {
        Self::Refused { code: error.code().into(), message: error.to_string(), usage: error.is_usage() }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unreadable { message } | Self::Refused { message, .. } => f.write_str(message),
            Self::BrokeOff { message } => write!(f, "the computation broke off ({message})"),
        }
    }
}

impl Failure {
    /// The fault of an image or a pair, which is left out with it.
    ///
    /// # Errors
    /// [`Error::Interrupted`] for options out of range and kept records that were changed, which no image is to blame for.
    pub(super) fn of_one(self) -> Result<Self, Error> {
        match &self {
            Self::Refused { code, usage, .. } if *usage || code == "unreadable-file" => Err(self.of_all()),
            _ => Ok(self),
        }
    }

    /// A failure that ends the run.
    pub(super) fn of_all(&self) -> Error {
        Error::Interrupted { reason: self.to_string() }
    }
}
