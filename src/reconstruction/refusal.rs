//! What cannot be reconstructed, and why.

use crate::error::refuse;
use crate::tracks::{ImageFeatures, TiePoints, check_features};
use crate::{BlockDescription, Error, Input, Refusal};

/// Refuses a block that cannot be, and points and features that are not its own.
pub(super) fn check(description: &BlockDescription, points: &TiePoints, features: &[ImageFeatures<'_>]) -> Result<(), Error> {
    description.check()?;
    if features.len() != description.images.len() {
        let (images, wanted) = (features.len(), description.images.len());
        return refuse(Refusal::FeaturesOfImages { input: Input::FeaturesOfImages, images, wanted });
    }
    check_features(points, features)
}
