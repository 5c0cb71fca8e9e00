//! A block as it is exchanged: before any of it is oriented, and with one of its reconstructed models.

use super::description::BlockDescription;
use super::result::{PointSource, Reconstruction};
use crate::adjustment::CameraLabel;
use crate::formats::{BlockModel, ModelImage};
use crate::{Error, TiePoints};

impl BlockDescription {
    /// The block before any of its images is oriented, without points; what is not known of a camera is guessed as
    /// [`reconstruct_block`](crate::reconstruct_block) guesses it.
    pub fn to_model(&self) -> BlockModel {
        let images = self.images.iter().map(|image| ModelImage { name: image.name.clone(), camera: image.camera, pose: None });
        BlockModel {
            cameras: self.cameras.iter().map(|camera| camera.approximate().to_model(&camera.label())).collect(),
            images: images.collect(),
            ..BlockModel::default()
        }
    }
}

impl Reconstruction {
    /// One of the models with all cameras and images of the block, those of other models not oriented: indices are those of the block.
    ///
    /// `points` are those that were reconstructed: they give the confidence of each point.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for a model that does not exist.
    pub fn block_model(&self, model: usize, description: &BlockDescription, points: &TiePoints) -> Result<BlockModel, Error> {
        let Some(own) = self.models.get(model) else {
            let allowed = format!("models below {}", self.models.len());
            return Err(Error::InvalidInput { what: "model of the reconstruction", got: model.to_string(), allowed });
        };
        let labels: Vec<CameraLabel> = own.cameras.iter().map(|camera| description.cameras[*camera].label()).collect();
        let names: Vec<String> = own.images.iter().map(|image| description.images[*image].name.clone()).collect();
        let part = own.adjusted.to_model(&labels, &names)?;
        let mut whole = BlockModel { origin: self.origin.filter(|_| own.in_system), ..description.to_model() };
        own.cameras.iter().zip(part.cameras).for_each(|(camera, calibrated)| whole.cameras[*camera] = calibrated);
        own.images.iter().zip(part.images).for_each(|(image, oriented)| whole.images[*image].pose = oriented.pose);
        whole.points = part.points;
        let mut kept = whole.points.iter_mut();
        for (point, known) in own.adjusted.points.iter().zip(&own.points) {
            let (Some(_), Some(kept)) = (point, if point.is_some() { kept.next() } else { None }) else { continue };
            kept.rays.iter_mut().for_each(|ray| ray.image = own.images[ray.image]);
            if let PointSource::TiePoint(index) = known {
                kept.confidence = f64::from(points.confidence(*index as usize));
            }
        }
        Ok(whole)
    }
}

#[cfg(test)]
mod tests {
    use super::super::description::{KnownCamera, KnownImage};
    use super::*;

    #[test]
    fn a_block_that_is_not_oriented_has_guesses_where_nothing_is_known() {
        let known = KnownCamera { principal_point_px: Some([2010.0, 1490.0]), ..KnownCamera::of_size(4000, 3000, Some(3500.0)) };
        let image = |name: &str, camera| KnownImage { name: name.into(), camera, position: None };
        let cameras = vec![KnownCamera::of_size(600, 800, None), known];
        let description = BlockDescription { cameras, images: vec![image("a.jpg", 1), image("b.jpg", 0)], control: Vec::new() };
        let model = description.to_model();
        model.check().unwrap();
        let seen: Vec<_> = model.cameras.iter().map(|camera| (camera.focal_px, camera.principal_point_px)).collect();
        assert_eq!(seen, [(960.0, [300.0, 400.0]), (3500.0, [2010.0, 1490.0])]);
        let images: Vec<_> = model.images.iter().map(|image| (image.name.as_str(), image.camera, image.pose)).collect();
        assert_eq!(images, [("a.jpg", 1, None), ("b.jpg", 0, None)]);
    }
}
