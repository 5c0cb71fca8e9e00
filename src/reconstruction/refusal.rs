//! What cannot be reconstructed, and why.

use crate::error::refuse;
use crate::tracks::{ImageFeatures, TiePoints, check_features};
use crate::{BlockDescription, Error};

/// Refuses a block that cannot be, and points and features that are not its own.
pub(super) fn check(description: &BlockDescription, points: &TiePoints, features: &[ImageFeatures<'_>]) -> Result<(), Error> {
    description.check()?;
    if features.len() != description.images.len() {
        let got = format!("features of {} images", features.len());
        let allowed = format!("those of the block's {} images", description.images.len());
        return refuse("features of the images", got, &allowed);
    }
    check_features(points, features)
}
