//! What cannot be reconstructed, and why.

use super::description::{BlockDescription, GroundControlPoint, KnownCamera, ObservedPosition};
use super::weaknesses::camera_named;
use crate::Error;
use crate::parameters::{FOCAL_PX, check_values};
use crate::tracks::{ImageFeatures, TiePoints, check_features};

impl BlockDescription {
    /// Refuses what no block can be, as [`reconstruct_block`](crate::reconstruct_block) does, before anything is measured.
    ///
    /// # Errors
    /// [`Error::TooFew`] below two images; [`Error::InvalidInput`] for indices of nothing, values that are none or out of range, and marks of
    /// surveyed points that are outside their image or twice in it.
    pub fn check(&self) -> Result<(), Error> {
        if self.images.len() < 2 {
            return Err(Error::TooFew { what: "images of a block", got: self.images.len(), needed: 2 });
        }
        self.cameras.iter().enumerate().try_for_each(|(index, camera)| check_camera(camera, || camera_named(index, self)))?;
        for image in &self.images {
            if image.camera >= self.cameras.len() {
                let got = format!("index {} for {}", image.camera, image.name);
                return Err(Error::InvalidInput {
                    what: "camera of an image",
                    got,
                    allowed: format!("indices below {}", self.cameras.len()),
                });
            }
            image.position.iter().try_for_each(|position| check_position(position, || image.name.clone()))?;
        }
        self.control.iter().try_for_each(|control| self.check_control(control))
    }

    fn check_control(&self, control: &GroundControlPoint) -> Result<(), Error> {
        let name = format!("surveyed point {}", control.name);
        check_position(&control.position, || name.clone())?;
        if matches!(control.position, ObservedPosition::Geographic { height_m: None, .. }) {
            return Err(Error::InvalidInput { what: "height", got: format!("none of {name}"), allowed: "-100000 to 1000000".into() });
        }
        let what = "mark of a surveyed point";
        let mut images = Vec::with_capacity(control.rays.len());
        for ray in &control.rays {
            let Some(image) = self.images.get(ray.image) else {
                let got = format!("index {} as image of {name}", ray.image);
                return Err(Error::InvalidInput { what, got, allowed: format!("indices below {}", self.images.len()) });
            };
            let KnownCamera { width_px, height_px, .. } = self.cameras[image.camera];
            let is_inside = (0.0..=f64::from(width_px)).contains(&ray.x_px) && (0.0..=f64::from(height_px)).contains(&ray.y_px);
            if !is_inside {
                let got = format!("({}, {}) for {} in {}, outside the image", ray.x_px, ray.y_px, control.name, image.name);
                return Err(Error::InvalidInput { what, got, allowed: format!("places within its {width_px} x {height_px} px") });
            }
            images.push(ray.image);
        }
        images.sort_unstable();
        match images.windows(2).find(|pair| pair[0] == pair[1]) {
            Some(twice) => {
                let got = format!("two for {} in {}", control.name, self.images[twice[0]].name);
                Err(Error::InvalidInput { what, got, allowed: "one in an image".into() })
            }
            None => Ok(()),
        }
    }
}

/// Refuses a block that cannot be, and points and features that are not its own.
pub(super) fn check(description: &BlockDescription, points: &TiePoints, features: &[ImageFeatures<'_>]) -> Result<(), Error> {
    description.check()?;
    if features.len() != description.images.len() {
        let got = format!("features of {} images", features.len());
        let allowed = format!("those of the block's {} images", description.images.len());
        return Err(Error::InvalidInput { what: "features of the images", got, allowed });
    }
    check_features(points, features)
}

fn check_camera(camera: &KnownCamera, place: impl Fn() -> String) -> Result<(), Error> {
    check_values("size of the images", &[f64::from(camera.width_px), f64::from(camera.height_px)], 1.0..=1e7, &place)?;
    camera.focal_px.map_or(Ok(()), |focal| check_values("focal length of a camera", &[focal], FOCAL_PX, &place))?;
    camera.principal_point_px.map_or(Ok(()), |at| check_values("principal point of a camera", &at, -1e7..=1e7, &place))?;
    check_values("distortion of a camera", &camera.radial, -1e3..=1e3, &place)?;
    check_values("distortion of a camera", &camera.tangential, -1e3..=1e3, &place)?;
    camera.pixel_mm.map_or(Ok(()), |pixel| check_values("side of a pixel", &[pixel], 1e-6..=10.0, &place))?;
    check_values("free radial coefficients", &[camera.free.radial as f64], 0.0..=3.0, &place)
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
