//! What cannot be assembled, and why.

use super::description::{AssemblyCamera, BlockDescription, ObservedPosition};
use crate::Error;
use crate::block::{ImageFeatures, MultiRayPoints, check_features};
use crate::parameters::{FOCAL_PX, check_values};

/// Refuses indices of nothing, values that are none, and rays outside their images.
pub(super) fn check(description: &BlockDescription, points: &MultiRayPoints, features: &[ImageFeatures<'_>]) -> Result<(), Error> {
    if description.images.len() < 2 {
        return Err(Error::TooFew { what: "images of a block", got: description.images.len(), needed: 2 });
    }
    if features.len() != description.images.len() {
        let got = format!("features of {} images", features.len());
        let allowed = format!("those of the block's {} images", description.images.len());
        return Err(Error::InvalidInput { what: "features of the images", got, allowed });
    }
    description.cameras.iter().enumerate().try_for_each(|(index, camera)| check_camera(index, camera))?;
    for (index, image) in description.images.iter().enumerate() {
        if image.camera >= description.cameras.len() {
            let got = format!("camera {} of image {index}", image.camera);
            let allowed = format!("cameras below {}", description.cameras.len());
            return Err(Error::InvalidInput { what: "camera of an image", got, allowed });
        }
        image.position.iter().try_for_each(|position| check_position(position, || format!("image {index} (counted from 0)")))?;
    }
    for (index, control) in description.control.iter().enumerate() {
        check_position(&control.position, || format!("control point {index} (counted from 0)"))?;
        if matches!(control.position, ObservedPosition::Geographic { height_m: None, .. }) {
            let got = format!("none of control point {index} (counted from 0)");
            return Err(Error::InvalidInput { what: "height", got, allowed: "-100000 to 1000000".into() });
        }
        for ray in &control.rays {
            let place = || format!("control point {index} (counted from 0)");
            if ray.image >= description.images.len() {
                let got = format!("image {} of {}", ray.image, place());
                return Err(Error::InvalidInput {
                    what: "image of a ray",
                    got,
                    allowed: format!("images below {}", description.images.len()),
                });
            }
            check_values("image coordinates", &[ray.x_px, ray.y_px], -1e7..=1e7, place)?;
        }
        let mut images: Vec<usize> = control.rays.iter().map(|ray| ray.image).collect();
        images.sort_unstable();
        if let Some(twice) = images.windows(2).find(|pair| pair[0] == pair[1]) {
            let got = format!("two rays of control point {index} in image {}", twice[0]);
            return Err(Error::InvalidInput { what: "rays", got, allowed: "one ray in an image".into() });
        }
    }
    check_features(points, features)
}

fn check_camera(index: usize, camera: &AssemblyCamera) -> Result<(), Error> {
    let place = || format!("camera {index} (counted from 0)");
    check_values("size of the images", &[f64::from(camera.width_px), f64::from(camera.height_px)], 1.0..=1e7, place)?;
    camera.focal_px.map_or(Ok(()), |focal| check_values("focal length of a camera", &[focal], FOCAL_PX, place))?;
    camera.principal_point_px.map_or(Ok(()), |at| check_values("principal point of a camera", &at, -1e7..=1e7, place))?;
    check_values("distortion of a camera", &camera.radial, -1e3..=1e3, place)?;
    check_values("distortion of a camera", &camera.tangential, -1e3..=1e3, place)?;
    camera.pixel_mm.map_or(Ok(()), |pixel| check_values("side of a pixel", &[pixel], 1e-6..=10.0, place))?;
    check_values("free radial coefficients", &[camera.free.radial as f64], 0.0..=3.0, place)
}

fn check_position(position: &ObservedPosition, place: impl Fn() -> String) -> Result<(), Error> {
    match position {
        ObservedPosition::Local { position, sigma } => {
            check_values("position", position, -1e8..=1e8, &place)?;
            check_values("sigma of a position", sigma, 1e-9..=1e9, &place)
        }
        ObservedPosition::Geographic { longitude_deg, latitude_deg, height_m, sigma_m } => {
            check_values("longitude", &[*longitude_deg], -180.0..=180.0, &place)?;
            check_values("latitude", &[*latitude_deg], -90.0..=90.0, &place)?;
            height_m.map_or(Ok(()), |height| check_values("height", &[height], -1e5..=1e6, &place))?;
            check_values("sigma of a position", sigma_m, 1e-9..=1e9, &place)
        }
    }
}
