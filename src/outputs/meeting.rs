//! Where image measurements meet that take no part in the block: by it a point that was measured by hand and rejected has its place on the map.

use crate::error::refuse;
use crate::math::nearest_to_rays;
use crate::{BlockRun, Error, HandMeasurement, Input, Refusal};

/// The place that is nearest to the rays of all measurements; absent where fewer than two are in oriented images, and where the rays are parallel.
///
/// # Errors
/// [`Error::InvalidInput`] for images that do not exist; as [`Camera::direction`](crate::Camera::direction).
pub fn meeting_place(run: &BlockRun, measurements: &[HandMeasurement]) -> Result<Option<[f64; 3]>, Error> {
    let (images, cameras) = (&run.model.images, &run.model.cameras);
    let mut rays = Vec::new();
    for HandMeasurement { image, x_px, y_px, .. } in measurements {
        let Some(seen) = images.get(*image) else {
            return refuse(Refusal::Index { input: Input::Image, index: *image, count: images.len() });
        };
        if let Some(pose) = seen.pose {
            rays.push((pose.position, pose.ray(cameras[seen.camera].direction([*x_px, *y_px])?)));
        }
    }
    Ok(nearest_to_rays(rays))
}
