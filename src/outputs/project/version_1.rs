//! The project file of version 1: a block without what its run knew beside it.

use crate::{
    BlockModel, BlockOptions, BlockRun, BlockSettings, Connection, ExifImage, InitialCamera, Reconstruction, Remark, RunImage, RunInput,
    SelectOptions,
};
use serde::Deserialize;

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Project {
    pub(super) block: BlockModel,
    pub(super) connections: Vec<Connection>,
    pub(super) joining: BlockOptions,
    pub(super) selection: SelectOptions,
}

impl From<Project> for BlockRun {
    /// What the older file does not hold is absent.
    fn from(Project { block: model, connections, joining, selection }: Project) -> Self {
        let cameras = model.cameras.iter().map(|camera| InitialCamera {
            label: format!("{} x {} px", camera.width_px, camera.height_px),
            width_px: camera.width_px,
            height_px: camera.height_px,
            focal_px: None,
            principal_point_px: camera.principal_point_px,
            radial: [0.0; 3],
            tangential: [0.0; 2],
            pixel_mm: camera.pixel_mm,
            fixed: false,
        });
        let images = model.images.iter().map(|image| {
            // Indices are judged with the whole project.
            let size = model.cameras.get(image.camera).map_or([0; 2], |camera| [camera.width_px, camera.height_px]);
            RunImage {
                name: image.name.clone(),
                key: String::new(),
                content: String::new(),
                width_px: size[0],
                height_px: size[1],
                features: None,
                masked: false,
                exif: ExifImage::default(),
                camera: image.camera,
            }
        });
        Self {
            input: RunInput {
                images: model.images.iter().map(|image| image.name.clone()).collect(),
                settings: BlockSettings { block: joining, selection, ..BlockSettings::default() },
                ..RunInput::default()
            },
            images: images.collect(),
            skipped: Vec::new(),
            unused_masks: Vec::new(),
            unknown_images: Vec::new(),
            remarks: vec![Remark::OlderProject { version: 1 }],
            cameras: cameras.collect(),
            geometries: vec![None; connections.len()],
            connections,
            points: None,
            refinement: None,
            reconstruction: Ok(Reconstruction { origin: model.origin, ..Reconstruction::default() }),
            model,
        }
    }
}
