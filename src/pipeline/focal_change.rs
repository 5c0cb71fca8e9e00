//! Focal lengths that an orthophoto changes by more than chance does: its places and the tie points contradict each other.
//!
//! Images by themselves give a focal length; places of the ground beside them make it more precise. Where the standard errors of both hold, the
//! change is by chance, and its variance is the difference of theirs. Warps of an orthophoto and wrong heights make it larger. Both variances are by one σ₀,
//! that of the images by themselves: differences of two estimates of it would stand beside the small one of what the ground adds, and what contradicts the
//! images enlarges that of both together.
//!
//! # Source
//! Hausman 1978, Specification tests in econometrics.

use crate::{AdjustmentResult, BlockDescription, BlockWarning, ReconstructedModel};

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
        let BlockWarning::FocalOfGround { camera, images_px, images_error_px, images_unit_px, .. } = told else { continue };
        // They are named from 1 on.
        let (index, images) = (camera.number - 1, FocalLength { px: *images_px, error_px: *images_error_px, unit_px: *images_unit_px });
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
    /// The standard error of a coordinate of weight 1 in it; absent in older projects.
    unit_px: Option<f64>,
}

fn warning(description: &BlockDescription, camera: usize, images: FocalLength, ground: FocalLength) -> BlockWarning {
    BlockWarning::FocalOfGround {
        camera: description.named_camera(camera),
        images_px: images.px,
        images_error_px: images.error_px,
        images_unit_px: images.unit_px,
        ground_px: ground.px,
        ground_error_px: ground.error_px,
    }
}

/// That of a camera of the block as a model has it; absent where it was not estimated.
fn focal_length(model: &ReconstructedModel, camera: usize) -> Option<FocalLength> {
    let own = model.cameras.binary_search(&camera).ok()?;
    FocalLength::of(&model.adjusted, own)
}

impl FocalLength {
    /// That of a camera of an adjusted block; absent where it was not estimated.
    fn of(adjusted: &AdjustmentResult, camera: usize) -> Option<Self> {
        let error_px = adjusted.cameras[camera].standard_errors[0]?;
        Some(Self { px: adjusted.block.cameras[camera].focal_px, error_px, unit_px: adjusted.unit_error_px })
    }
}

/// What the ground changes, and the variance of that where it changes by chance.
fn change(images: FocalLength, ground: FocalLength) -> (f64, f64) {
    let by_same = images.unit_px.zip(ground.unit_px).map_or(1.0, |(images, ground)| images / ground);
    let ground_error = by_same * ground.error_px;
    (images.px - ground.px, images.error_px * images.error_px - ground_error * ground_error)
}

fn is_no_chance(images: FocalLength, ground: FocalLength) -> bool {
    let (change, variance) = change(images, ground);
    variance > 0.0 && change * change > MOST * MOST * variance
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{AdjustmentOptions, BlockFlight, BlockPreset, BlockView, Datum, FreeParameters, Loss, adjust_block, simulate_network};

    /// The focal length of a small block by its images alone, and by twelve places beside them, all with the errors that are stated; absent where it is not determined.
    fn simulated(seed: u32) -> Option<[FocalLength; 2]> {
        let flight = BlockFlight {
            view: BlockView::Oblique,
            strips: 3,
            exposures: 3,
            points_per_image: 15.0,
            control_points: 12,
            control_sigma_m: 0.05,
            seed,
            ..BlockPreset::Network.flight()
        };
        let mut block = simulate_network(&flight).unwrap().observed;
        block.cameras[0].free = FreeParameters { focal: true, ..FreeParameters::default() };
        let of = |datum| {
            let options = AdjustmentOptions { datum, loss: Loss::Squares, snooping: false, ..AdjustmentOptions::default() };
            FocalLength::of(&adjust_block(&block, &options).unwrap(), 0)
        };
        Some([of(Datum::Free)?, of(Datum::GnssAndControl)?])
    }

    #[test]
    fn right_places_change_focal_lengths_by_chance_alone() {
        let of_both: Vec<[FocalLength; 2]> = (1..=60).filter_map(simulated).collect();
        let told = of_both.iter().filter(|[images, ground]| is_no_chance(*images, *ground)).count();
        let changes: Vec<(f64, f64)> = of_both.iter().map(|[images, ground]| change(*images, *ground)).collect();
        let mean_square = changes.iter().map(|(change, variance)| change * change / variance).sum::<f64>() / changes.len() as f64;
        println!("{told} of {} blocks, mean square {mean_square:.3}", changes.len());
        // By a σ₀ of its own each, places take something away from what images know in every third block.
        assert!(changes.len() > 10 && changes.iter().all(|(_, variance)| *variance > 0.0), "{changes:?}");
        // By one of a hundred is told; a mean square of so few has a standard error of 0.4.
        assert!(told <= 1 && (0.2..2.0).contains(&mean_square), "{told}, {mean_square}");
    }

    #[test]
    fn variances_are_compared_by_one_unit() {
        let of = |px, error_px, unit_px| FocalLength { px, error_px, unit_px: Some(unit_px) };
        // By units of their own the ground would add next to nothing, or take something away.
        assert!(!is_no_chance(of(1000.0, 13.0, 0.4), of(1020.0, 12.9, 0.5)) && is_no_chance(of(1000.0, 13.0, 0.4), of(1025.0, 12.9, 0.5)));
        assert!(is_no_chance(of(1000.0, 13.0, 0.4), of(1025.0, 13.5, 0.5)));
    }

    #[test]
    fn a_change_is_judged_by_what_the_ground_adds() {
        let is = |images: [f64; 2], ground: [f64; 2]| {
            let [images, ground] = [images, ground].map(|[px, error_px]| FocalLength { px, error_px, unit_px: None });
            is_no_chance(images, ground)
        };
        // The standard error of the change is 12.
        assert!(!is([1000.0, 13.0], [1030.5, 5.0]) && is([1000.0, 13.0], [1031.5, 5.0]) && is([1031.5, 13.0], [1000.0, 5.0]));
        // Where the ground adds nothing no change tells anything.
        assert!(!is([1000.0, 5.0], [1030.0, 5.0]) && !is([1000.0, 5.0], [1030.0, 6.0]));
    }
}
