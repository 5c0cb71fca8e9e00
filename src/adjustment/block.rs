//! What a bundle adjustment takes: cameras, images, points, rays, control; flat lists that refer to each other by index.
//!
//! The system of the images is that of the whole crate: photo = M·(X - X₀), x to the right, y up, the viewing direction -z. Lengths of the
//! object space have one unit throughout, metres say.

use crate::camera::{Camera, CameraUncertainty, FreeParameters, Pose};
use crate::{BlockModel, Error};
use serde::{Deserialize, Serialize};

/// A block of images with approximate values, or an adjusted one.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Block {
    pub cameras: Vec<Camera>,
    pub images: Vec<BlockImage>,
    pub points: Vec<[f64; 3]>,
    /// In any order; an image sees a point at most once.
    pub rays: Vec<BlockObservation>,
    #[serde(default)]
    pub control: Vec<ControlPoint>,
    /// What is known of cameras beforehand; a camera has one at most.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub camera_priors: Vec<CameraPrior>,
}

impl Block {
    /// The oriented images of a model and its intersected points with their observations in these images; nothing of the cameras is free.
    ///
    /// # Errors
    /// As [`BlockModel::check`].
    pub fn of_model(model: &BlockModel) -> Result<Self, Error> {
        model.check()?;
        let free = FreeParameters::default();
        let mut block = Self { cameras: model.cameras.iter().map(|camera| Camera { free, ..*camera }).collect(), ..Self::default() };
        let mut places = vec![None; model.images.len()];
        for (image, place) in model.images.iter().zip(&mut places) {
            let Some(pose) = image.pose else { continue };
            *place = Some(block.images.len());
            block.images.push(BlockImage { camera: image.camera, pose, gnss: None, axis: None });
        }
        for (point, position) in model.points.iter().filter_map(|point| Some((point, point.position?))) {
            let index = block.points.len();
            let seen = point.rays.iter().filter_map(|ray| Some((places[ray.image]?, ray)));
            block.rays.extend(seen.map(|(image, ray)| BlockObservation {
                image,
                point: index,
                x_px: ray.x_px,
                y_px: ray.y_px,
                weight: 1.0,
                sigma_px: None,
            }));
            block.points.push(position);
        }
        Ok(block)
    }
}

/// One image.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct BlockImage {
    /// Index of its camera.
    pub camera: usize,
    pub pose: Pose,
    /// Where GNSS has the projection centre, but for systematic errors of the positions.
    #[serde(default)]
    pub gnss: Option<PositionPrior>,
    /// Where its axis is known to point in the system of the observed positions; a free network does not use it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub axis: Option<AxisPrior>,
}

/// The known direction of a camera axis.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct AxisPrior {
    /// Against the direction of view, of length 1: (0, 0, 1) looks down.
    pub direction: [f64; 3],
    /// Standard error across it in degrees.
    pub sigma_deg: f64,
}

/// What is known of the parameters of a camera beforehand. A parameter that is not free keeps the value that the block has.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct CameraPrior {
    /// Index of the camera.
    pub camera: usize,
    /// f, c_x, c_y in px, k₁, k₂, k₃, p₁, p₂.
    pub values: [f64; 8],
    /// Standard errors of these, above 0; absent for what is not known: its place in `values` means nothing.
    pub sigma: [Option<f64>; 8],
}

impl CameraPrior {
    /// Of a camera with its values before the adjustment. What has a standard deviation of 0 is known without error: it must not be free.
    pub fn of(camera: usize, known: &Camera, uncertainty: CameraUncertainty) -> Self {
        let CameraUncertainty { focal, principal_point, k1 } = uncertainty;
        let f = known.focal_px;
        let sigma = |sigma: f64| (sigma > 0.0).then_some(sigma);
        let (point, decentring) = (sigma(principal_point * f), sigma(uncertainty.decentring_beside(known.tangential)));
        Self { camera, values: known.values(), sigma: [sigma(focal * f), point, point, sigma(k1), None, None, decentring, decentring] }
    }
}

/// An observed position with the standard error of each of its coordinates.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct PositionPrior {
    pub position: [f64; 3],
    /// Above 0; absent for a coordinate that was not observed: its place in `position` means nothing.
    pub sigma: [Option<f64>; 3],
}

/// The measured position of a point in one image.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct BlockObservation {
    /// Index of the image.
    pub image: usize,
    /// Index of the point.
    pub point: usize,
    /// Column in px; the centre of the top-left pixel is 0.5.
    pub x_px: f64,
    /// Row in px; the centre of the top-left pixel is 0.5.
    pub y_px: f64,
    /// Above 0; the variance of both coordinates is σ₀² / weight.
    #[serde(default = "one")]
    pub weight: f64,
    /// Standard error of both coordinates in px, above 0, where it is known beside that of the other rays: the weight follows from it and σ₀.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sigma_px: Option<f64>,
}

fn one() -> f64 {
    1.0
}

/// A point with known coordinates.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ControlPoint {
    /// Index of the point.
    pub point: usize,
    pub position: [f64; 3],
    /// Standard error of each coordinate, above 0.
    pub sigma: [f64; 3],
}
