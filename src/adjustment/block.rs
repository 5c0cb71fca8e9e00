//! What a bundle adjustment takes: cameras, images, points, rays, control; flat lists that refer to each other by index.
//!
//! The system of the images is that of the whole crate: photo = M·(X - X₀), x to the right, y up, the viewing direction -z. Lengths of the
//! object space have one unit throughout, metres say.

use super::collinearity::distorted;
use super::state::values_of;
use serde::{Deserialize, Serialize};

/// A block of images with approximate values, or an adjusted one.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Block {
    pub cameras: Vec<BlockCamera>,
    pub images: Vec<BlockImage>,
    pub points: Vec<BlockPoint>,
    /// In any order; an image sees a point at most once.
    pub rays: Vec<BlockObservation>,
    #[serde(default)]
    pub control: Vec<ControlPoint>,
}

/// The camera of one or more images.
///
/// With x = -U/W, y = V/W of photo = (U, V, W), so that y goes down as rows do, and r² = x² + y²:
/// col = c_x + f (x (1 + k₁r² + k₂r⁴ + k₃r⁶) + 2p₁xy + p₂(r² + 2x²)), row = c_y + f (y (1 + k₁r² + k₂r⁴ + k₃r⁶) + p₁(r² + 2y²) + 2p₂xy).
///
/// # Source
/// Brown 1971, Close-range camera calibration, in the direction from object to image, as OpenCV and COLMAP write it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct BlockCamera {
    /// Principal distance f in px, 1 to 10,000,000; in mm it is this times the side of a pixel.
    pub focal_px: f64,
    /// Principal point `[col, row]` in px; the centre of the top-left pixel is (0.5, 0.5).
    pub principal_point_px: [f64; 2],
    /// `[k1, k2, k3]`, without unit.
    #[serde(default)]
    pub radial: [f64; 3],
    /// `[p1, p2]`, without unit.
    #[serde(default)]
    pub tangential: [f64; 2],
    /// What the adjustment estimates.
    #[serde(default)]
    pub free: FreeParameters,
}

impl BlockCamera {
    /// Where a direction (x, y) of the photo's system is seen: column and row in px.
    pub fn project(&self, x: f64, y: f64) -> [f64; 2] {
        distorted(&values_of(self), x, y)
    }
}

/// The parameters of a camera that the adjustment estimates, where the block determines them; the others stay as they are given.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct FreeParameters {
    pub focal: bool,
    pub principal_point: bool,
    /// How many of k1, k2, k3, from the first on: 0 to 3.
    pub radial: usize,
    pub tangential: bool,
}

impl FreeParameters {
    /// All eight.
    pub const ALL: Self = Self { focal: true, principal_point: true, radial: 3, tangential: true };
}

/// One image.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct BlockImage {
    /// Index of its camera.
    pub camera: usize,
    /// Rows of M, from object to photo; see [`rotation_from_angles`](crate::rotation_from_angles).
    pub rotation: [[f64; 3]; 3],
    /// Perspective centre X₀.
    pub position: [f64; 3],
    /// Where GPS has the perspective centre.
    #[serde(default)]
    pub gps: Option<PositionPrior>,
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

/// A point of the object.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct BlockPoint {
    pub position: [f64; 3],
}

/// A point as one image sees it.
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
}

fn one() -> f64 {
    1.0
}

/// A point whose position was surveyed.
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
