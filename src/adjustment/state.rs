//! The values of all unknowns, and how steps move them.

use super::block::Block;
use crate::camera::{Camera, CameraValues, Pose, orthonormal};

/// All unknowns of a block, those that are not estimated included.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct State {
    pub cameras: Vec<CameraValues>,
    pub images: Vec<Pose>,
    pub points: Vec<[f64; 3]>,
    /// Three values of each systematic error of GNSS positions.
    pub systematic: Vec<[f64; 3]>,
}

impl State {
    pub fn of(block: &Block) -> Self {
        Self {
            cameras: block.cameras.iter().map(Camera::values).collect(),
            images: block.images.iter().map(|i| Pose { rotation: orthonormal(i.pose.rotation), ..i.pose }).collect(),
            points: block.points.clone(),
            systematic: Vec::new(),
        }
    }

    /// With so many systematic errors, all 0.
    pub fn with_systematic(self, errors: usize) -> Self {
        Self { systematic: vec![[0.0; 3]; errors], ..self }
    }

    /// The block with these values.
    pub fn put_into(&self, mut block: Block) -> Block {
        block.cameras.iter_mut().zip(&self.cameras).for_each(|(camera, values)| *camera = camera.with_values(*values));
        block.images.iter_mut().zip(&self.images).for_each(|(image, pose)| image.pose = *pose);
        block.points.clone_from(&self.points);
        block
    }
}
