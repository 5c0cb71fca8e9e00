//! Between the block of an adjustment and the block that is exchanged: the one place where either becomes the other.

use super::block::{Block, BlockCamera, BlockImage, BlockObservation, BlockPoint, FreeParameters};
use super::result::{AdjustmentResult, ObservationVerdict};
use crate::Error;
use crate::formats::{BlockModel, ModelCamera, ModelImage, ModelPoint, ModelPose, ModelRay};
use serde::{Deserialize, Serialize};

/// What an exchanged camera has beside its calibration.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct CameraLabel {
    pub width_px: u32,
    pub height_px: u32,
    /// Side of a pixel in mm.
    #[serde(default)]
    pub pixel_mm: Option<f64>,
}

impl BlockCamera {
    /// The camera as it is exchanged.
    pub fn to_model(&self, label: &CameraLabel) -> ModelCamera {
        ModelCamera {
            width_px: label.width_px,
            height_px: label.height_px,
            focal_px: self.focal_px,
            principal_point_px: self.principal_point_px,
            radial: self.radial,
            tangential: self.tangential,
            pixel_mm: label.pixel_mm,
        }
    }
}

impl AdjustmentResult {
    /// The adjusted block with its accepted rays; points without any are left out. `cameras` and `names` are those of the block's cameras and
    /// images, in their order.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] where these are not as many as the block has.
    pub fn to_model(&self, cameras: &[CameraLabel], names: &[String]) -> Result<BlockModel, Error> {
        let block = &self.block;
        if (cameras.len(), names.len()) != (block.cameras.len(), block.images.len()) {
            let got = format!("{} cameras and {} names", cameras.len(), names.len());
            let allowed = format!("{} cameras and {} names", block.cameras.len(), block.images.len());
            return Err(Error::InvalidInput { what: "labels of the block", got, allowed });
        }
        let mut rays = vec![Vec::new(); block.points.len()];
        for (ray, _) in block.rays.iter().zip(&self.rays).filter(|(_, statistics)| statistics.verdict == ObservationVerdict::Accepted) {
            rays[ray.point].push(ModelRay { image: ray.image, x_px: ray.x_px, y_px: ray.y_px, confidence: 1.0 });
        }
        let points = block.points.iter().zip(&self.points).zip(rays).filter_map(|((point, statistics), rays)| {
            let rmse_px = Some(statistics.as_ref()?.rmse_px);
            Some(ModelPoint { position: Some(point.position), colour: [128; 3], rmse_px, confidence: 1.0, rays })
        });
        let pose = |image: &BlockImage| ModelPose { rotation: image.rotation, position: image.position };
        let images = block.images.iter().zip(names);
        Ok(BlockModel {
            cameras: block.cameras.iter().zip(cameras).map(|(camera, label)| camera.to_model(label)).collect(),
            images: images.map(|(image, name)| ModelImage { name: name.clone(), camera: image.camera, pose: Some(pose(image)) }).collect(),
            points: points.collect(),
            origin: None,
        })
    }
}

/// The oriented part of an exchanged block, as an adjustment takes it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct OrientedPart {
    pub block: Block,
    /// The image of the exchanged block that each image is.
    pub images: Vec<usize>,
    /// The point of the exchanged block that each point is.
    pub points: Vec<usize>,
}

impl OrientedPart {
    /// The oriented images of a block and its intersected points with their rays in these images; nothing of the cameras is free.
    ///
    /// # Errors
    /// As [`BlockModel::check`].
    pub fn of_model(model: &BlockModel) -> Result<Self, Error> {
        model.check()?;
        let mut part = Self { block: Block::default(), images: Vec::new(), points: Vec::new() };
        part.block.cameras = (model.cameras.iter())
            .map(|camera| BlockCamera {
                focal_px: camera.focal_px,
                principal_point_px: camera.principal_point_px,
                radial: camera.radial,
                tangential: camera.tangential,
                free: FreeParameters::default(),
            })
            .collect();
        for (index, image) in model.images.iter().enumerate() {
            let Some(ModelPose { rotation, position }) = image.pose else { continue };
            part.images.push(index);
            part.block.images.push(BlockImage { camera: image.camera, rotation, position, gps: None });
        }
        for (index, point) in model.points.iter().enumerate() {
            let Some(position) = point.position else { continue };
            for ray in &point.rays {
                let Ok(image) = part.images.binary_search(&ray.image) else { continue };
                part.block.rays.push(BlockObservation { image, point: part.points.len(), x_px: ray.x_px, y_px: ray.y_px, weight: 1.0 });
            }
            part.points.push(index);
            part.block.points.push(BlockPoint { position });
        }
        Ok(part)
    }
}
