//! What a block must be before it is written, and after it is read.

use super::block::seen_twice;
use super::{BlockModel, GeographicOrigin, ObjectPoint};
use crate::camera::{Camera, Pose, is_rotation};
use crate::error::refuse;
use crate::{Error, Location, Refusal};
use std::collections::BTreeMap;

impl BlockModel {
    /// Refuses what no file should hold.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for indices of nothing, names that are empty, doubled or hold control characters, points of one number, numbers
    /// that are none or out of range, matrices that are no rotations, rays outside their image, and a point that an image sees twice.
    pub fn check(&self) -> Result<(), Error> {
        self.cameras.iter().enumerate().try_for_each(|(index, camera)| camera.check(|| Location::Camera { camera: index }))?;
        let mut names = BTreeMap::new();
        for (index, image) in self.images.iter().enumerate() {
            let name = || image.name.clone();
            if image.name.trim().is_empty() || image.name.chars().any(char::is_control) {
                return refuse(Refusal::ImageName { name: format!("{:?}", image.name), image: index });
            }
            if let Some(first) = names.insert(image.name.as_str(), index) {
                return refuse(Refusal::ImageNameAgain { name: name(), first, second: index });
            }
            if image.camera >= self.cameras.len() {
                return refuse(Refusal::CameraOfImage { camera: image.camera, name: name(), cameras: self.cameras.len() });
            }
            image.pose.iter().try_for_each(|pose| check_pose(&image.name, pose))?;
        }
        let mut numbers = BTreeMap::new();
        for (index, point) in self.points.iter().enumerate() {
            self.check_point(index, point)?;
            let Some(number) = point.number else { continue };
            if let Some(first) = numbers.insert(number, index) {
                return refuse(Refusal::PointNumberAgain { number, first, second: index });
            }
        }
        self.origin.iter().try_for_each(check_origin)
    }

    fn check_point(&self, index: usize, point: &ObjectPoint) -> Result<(), Error> {
        let share = |value: f64| (0.0..=1.0).contains(&value);
        if !point.position.iter().flatten().all(|v| v.is_finite()) || !point.rmse_px.iter().all(|v| v.is_finite() && *v >= 0.0) {
            let (position, rmse_px) = (format!("{:?}", point.position), format!("{:?}", point.rmse_px));
            return refuse(Refusal::PointNumbers { position, rmse_px, point: index });
        }
        if !share(point.confidence) || !point.rays.iter().all(|ray| share(ray.confidence)) {
            return refuse(Refusal::Confidence { point: index });
        }
        for ray in &point.rays {
            let Some(image) = self.images.get(ray.image) else {
                return refuse(Refusal::ImageOfPoint { image: ray.image, point: index, images: self.images.len() });
            };
            let Camera { width_px, height_px, .. } = self.cameras[image.camera];
            if !self.cameras[image.camera].sees(ray.x_px, ray.y_px) {
                let (x_px, y_px, name) = (ray.x_px, ray.y_px, image.name.clone());
                return refuse(Refusal::RayOutside { point: index, x_px, y_px, name, width_px, height_px });
            }
        }
        match seen_twice(&point.rays) {
            Some(image) => refuse(Refusal::TwoRays { point: index, name: self.images[image].name.clone() }),
            None => Ok(()),
        }
    }
}

fn check_pose(name: &str, pose: &Pose) -> Result<(), Error> {
    if !is_rotation(&pose.rotation) {
        return refuse(Refusal::Rotation { rotation: format!("{:?}", pose.rotation), name: name.into() });
    }
    if !pose.position.iter().all(|v| v.is_finite()) {
        return refuse(Refusal::ImagePosition { position: format!("{:?}", pose.position), name: name.into() });
    }
    Ok(())
}

fn check_origin(origin: &GeographicOrigin) -> Result<(), Error> {
    let GeographicOrigin { longitude_deg, latitude_deg, height_m } = *origin;
    let place = longitude_deg.abs() <= 180.0 && latitude_deg.abs() <= 90.0 && height_m.abs() <= 1e6;
    if place { Ok(()) } else { refuse(Refusal::Origin { longitude_deg, latitude_deg, height_m }) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::tiny_block;

    #[test]
    fn what_no_file_should_hold_is_refused() {
        let refused = |change: &dyn Fn(&mut BlockModel), word: &str| {
            let mut model = tiny_block();
            model.check().unwrap();
            change(&mut model);
            let message = model.check().unwrap_err().to_string();
            assert!(message.contains(word), "{message}");
        };
        refused(&|m| m.images[1].name = m.images[0].name.clone(), "for images 0 and 1");
        refused(&|m| m.images[1].name = "a\nb".into(), "control");
        refused(&|m| m.images[0].camera = 1, "index 1 for");
        refused(&|m| m.cameras[0].focal_px = f64::NAN, "focal");
        refused(&|m| m.cameras[0].radial[1] = f64::INFINITY, "distortion");
        refused(&|m| m.cameras[0].height_px = 0, "size of the images");
        refused(&|m| m.cameras[0].pixel_mm = Some(0.0), "pixel");
        refused(&|m| m.images[0].pose.as_mut().unwrap().rotation[0][0] = 0.5, "rotation");
        refused(&|m| m.images[0].pose.as_mut().unwrap().rotation.iter_mut().for_each(|r| r[2] = -r[2]), "rotation");
        refused(&|m| m.images[0].pose.as_mut().unwrap().position[1] = f64::NAN, "position");
        refused(&|m| m.points[0].position = Some([f64::NAN; 3]), "point 0");
        refused(&|m| m.points[1].rays[0].image = 9, "image 9 of point 1");
        refused(&|m| m.points[1].rays[0].x_px = -0.1, "within 400 x 300");
        refused(&|m| m.points[1].rays[0].y_px = f64::NAN, "within 400 x 300");
        refused(&|m| m.points[1].rays[0].confidence = 1.5, "confidence");
        refused(&|m| m.points[0].rays[1].image = m.points[0].rays[0].image, "two observations of point 0");
        refused(&|m| m.origin.as_mut().unwrap().latitude_deg = 91.0, "latitude");
    }
}
