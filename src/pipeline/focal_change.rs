//! Focal lengths that an orthophoto changes by more than chance does: its places and the tie points contradict each other.
//!
//! Images by themselves give a focal length; places of the ground beside them make it more precise. Where the standard errors of both hold, the
//! change is by chance, and its variance is the difference of theirs. Warps of an orthophoto and wrong heights make it larger.
//!
//! # Source
//! Hausman 1978, Specification tests in econometrics.

use crate::{BlockDescription, BlockWarning, ReconstructedModel};

/// Beyond so many of its standard errors a change is no chance: by that one in a hundred is.
const MOST: f64 = 2.58;

/// Says which focal lengths of a model the ground has changed. `before`: the model as the images by themselves have it.
pub(super) fn tell_by_ground(model: &mut ReconstructedModel, before: &ReconstructedModel, description: &BlockDescription) {
    let changed: Vec<BlockWarning> = (0..before.cameras.len())
        .filter_map(|camera| {
            let (images, ground) = (focal_length(before, before.cameras[camera])?, focal_length(model, before.cameras[camera])?);
            is_no_chance(images, ground).then(|| warning(description, before.cameras[camera], images, ground))
        })
        .collect();
    model.warnings.extend(changed);
}

/// The same of a model that is edited. `found`: the one that was not, whose warnings say what images by themselves gave.
pub(super) fn tell_after_edits(model: &mut ReconstructedModel, found: &ReconstructedModel, description: &BlockDescription) {
    for told in &found.warnings {
        let BlockWarning::FocalOfGround { camera, images_px, images_error_px, .. } = told else { continue };
        // They are named from 1 on.
        let (index, images) = (camera.number - 1, FocalLength { px: *images_px, error_px: *images_error_px });
        let Some(ground) = focal_length(model, index) else { continue };
        if is_no_chance(images, ground) {
            model.warnings.push(warning(description, index, images, ground));
        }
    }
}

#[derive(Debug, Clone, Copy)]
struct FocalLength {
    px: f64,
    error_px: f64,
}

fn warning(description: &BlockDescription, camera: usize, images: FocalLength, ground: FocalLength) -> BlockWarning {
    BlockWarning::FocalOfGround {
        camera: description.named_camera(camera),
        images_px: images.px,
        images_error_px: images.error_px,
        ground_px: ground.px,
        ground_error_px: ground.error_px,
    }
}

/// That of a camera of the block as a model has it; absent where it was not estimated.
fn focal_length(model: &ReconstructedModel, camera: usize) -> Option<FocalLength> {
    let own = model.cameras.binary_search(&camera).ok()?;
    let error_px = model.adjusted.cameras[own].standard_errors[0]?;
    Some(FocalLength { px: model.adjusted.block.cameras[own].focal_px, error_px })
}

fn is_no_chance(images: FocalLength, ground: FocalLength) -> bool {
    let (change, variance) = (images.px - ground.px, images.error_px * images.error_px - ground.error_px * ground.error_px);
    variance > 0.0 && change * change > MOST * MOST * variance
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_change_is_judged_by_what_the_ground_adds() {
        let is = |images: [f64; 2], ground: [f64; 2]| {
            let [images, ground] = [images, ground].map(|[px, error_px]| FocalLength { px, error_px });
            is_no_chance(images, ground)
        };
        // The standard error of the change is 12.
        assert!(!is([1000.0, 13.0], [1030.5, 5.0]) && is([1000.0, 13.0], [1031.5, 5.0]) && is([1031.5, 13.0], [1000.0, 5.0]));
        // Where the ground adds nothing no change tells anything.
        assert!(!is([1000.0, 5.0], [1030.0, 5.0]) && !is([1000.0, 5.0], [1030.0, 6.0]));
    }
}
