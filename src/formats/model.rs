//! A block as it is exchanged with other programs: cameras, images, points with their rays.

use serde::{Deserialize, Serialize};

/// A block: whatever is not known yet is absent.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct BlockModel {
    pub cameras: Vec<ModelCamera>,
    pub images: Vec<ModelImage>,
    pub points: Vec<ModelPoint>,
    /// Where on the earth the object space is; absent for a block in a system of its own.
    #[serde(default)]
    pub origin: Option<GeographicOrigin>,
}

/// A camera. With x = U/-W, y = -V/-W of photo = (U, V, W) = M·(X - X₀) and r² = x² + y², a point is seen at
/// col = c_x + f (x (1 + k₁r² + k₂r⁴ + k₃r⁶) + 2p₁xy + p₂(r² + 2x²)), row = c_y + f (y (1 + k₁r² + k₂r⁴ + k₃r⁶) + p₁(r² + 2y²) + 2p₂xy).
///
/// # Source
/// Brown 1971, Close-range camera calibration, in the direction from object to image, as OpenCV and COLMAP write it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ModelCamera {
    pub width_px: u32,
    pub height_px: u32,
    pub focal_px: f64,
    /// `[c_x, c_y]` in px; the centre of the top-left pixel is (0.5, 0.5).
    pub principal_point_px: [f64; 2],
    /// `[k1, k2, k3]`, without unit.
    #[serde(default)]
    pub radial: [f64; 3],
    /// `[p1, p2]`, without unit.
    #[serde(default)]
    pub tangential: [f64; 2],
    /// Side of a pixel in mm, which formats with photo coordinates need.
    #[serde(default)]
    pub pixel_mm: Option<f64>,
}

/// An image.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ModelImage {
    /// File name; no two images have the same.
    pub name: String,
    /// Index of its camera.
    pub camera: usize,
    /// Absent where it is not oriented.
    #[serde(default)]
    pub pose: Option<ModelPose>,
}

/// The exterior orientation of an image.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ModelPose {
    /// Rows of M, from object to photo, x right, y up, against the view: photo = M·(X - X₀).
    pub rotation: [[f64; 3]; 3],
    /// X₀, in m where the object space has a scale.
    pub position: [f64; 3],
}

/// A multi-ray point.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ModelPoint {
    /// Absent where it is not intersected.
    #[serde(default)]
    pub position: Option<[f64; 3]>,
    /// Red, green, blue.
    #[serde(default = "grey")]
    pub colour: [u8; 3],
    /// Root mean square length of its residuals in px.
    #[serde(default)]
    pub rmse_px: Option<f64>,
    /// Probability, 0..1, that its rays belong together.
    #[serde(default = "one")]
    pub confidence: f64,
    pub rays: Vec<ModelRay>,
}

/// A point in an image.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ModelRay {
    /// Index of the image.
    pub image: usize,
    /// Measured column and row in px; the centre of the top-left pixel is (0.5, 0.5).
    pub x_px: f64,
    pub y_px: f64,
    /// Probability, 0..1, that it belongs to its point.
    #[serde(default = "one")]
    pub confidence: f64,
}

/// The place of (0, 0, 0) of an object space whose x goes east, y north and z up, all in m.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct GeographicOrigin {
    /// WGS 84.
    pub longitude_deg: f64,
    pub latitude_deg: f64,
    /// Above the ellipsoid.
    pub height_m: f64,
}

fn one() -> f64 {
    1.0
}

fn grey() -> [u8; 3] {
    [128; 3]
}
