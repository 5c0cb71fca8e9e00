//! The GNSS position of an image that is placed by itself, with how precise its height is.

use crate::pipeline::stated_height_error;
use crate::{ExifImage, ExifPosition, GivenPosition};

/// The GNSS position of an image: that of a table, or that which its file records.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RecordedPosition {
    pub position: ExifPosition,
    /// Standard error of the height in m; absent where nothing states one, as of most receivers of cameras.
    pub height_error_m: Option<f64>,
    /// Whether its height counts from where those of a coordinate reference system do; otherwise from the ellipsoid, as far as anything says it.
    pub in_crs: bool,
}

impl RecordedPosition {
    /// That of a table, else that of the file.
    pub fn of(given: Option<&GivenPosition>, exif: &ExifImage) -> Option<Self> {
        let height_error_m = stated_height_error(given, exif);
        match given {
            Some(given) => Some(Self { position: given.as_recorded(), height_error_m, in_crs: given.in_crs }),
            None => exif.position.map(|position| Self { position, height_error_m, in_crs: false }),
        }
    }
}

impl From<ExifPosition> for RecordedPosition {
    /// One of which nothing says how precise its height is.
    fn from(position: ExifPosition) -> Self {
        Self { position, height_error_m: None, in_crs: false }
    }
}
