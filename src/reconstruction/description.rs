//! What is known of a block before it is oriented: cameras, images, surveyed points.

use crate::adjustment::{BlockCamera, CameraLabel, FreeParameters};
use serde::{Deserialize, Serialize};

/// A focal length that is not known is taken for this many times the longer side of the image, as those of most cameras nearly are.
const GUESSED_FOCAL: f64 = 1.2;

/// The cameras and images of a block with whatever positions were observed.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct BlockDescription {
    pub cameras: Vec<KnownCamera>,
    pub images: Vec<KnownImage>,
    #[serde(default)]
    pub control: Vec<GroundControlPoint>,
}

/// A camera before its calibration; symbols as at [`BlockCamera`](crate::BlockCamera).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct KnownCamera {
    pub width_px: u32,
    pub height_px: u32,
    /// Approximate principal distance in px; absent: not known. It is guessed then, and estimated in any case.
    #[serde(default)]
    pub focal_px: Option<f64>,
    /// Approximate principal point in px; absent: the middle of the image.
    #[serde(default)]
    pub principal_point_px: Option<[f64; 2]>,
    #[serde(default)]
    pub radial: [f64; 3],
    #[serde(default)]
    pub tangential: [f64; 2],
    /// What the block estimates of it, where it determines that: by default all but k3, p1 and p2.
    #[serde(default = "KnownCamera::calibrated")]
    pub free: FreeParameters,
    /// Side of a pixel in mm, for exports in photo coordinates.
    #[serde(default)]
    pub pixel_mm: Option<f64>,
}

impl KnownCamera {
    /// Focal length, principal point, k1 and k2.
    pub const fn calibrated() -> FreeParameters {
        FreeParameters { focal: true, principal_point: true, radial: 2, tangential: false }
    }

    /// A camera of which only the size of its images and, perhaps, its focal length is known.
    pub fn of_size(width_px: u32, height_px: u32, focal_px: Option<f64>) -> Self {
        Self {
            width_px,
            height_px,
            focal_px,
            principal_point_px: None,
            radial: [0.0; 3],
            tangential: [0.0; 2],
            free: Self::calibrated(),
            pixel_mm: None,
        }
    }

    /// The camera with what is known of it, and guesses for the rest.
    pub(super) fn approximate(&self) -> BlockCamera {
        let (width, height) = (f64::from(self.width_px), f64::from(self.height_px));
        BlockCamera {
            focal_px: self.focal_px.unwrap_or(GUESSED_FOCAL * width.max(height)),
            principal_point_px: self.principal_point_px.unwrap_or([0.5 * width, 0.5 * height]),
            radial: self.radial,
            tangential: self.tangential,
            free: FreeParameters { focal: self.free.focal || self.focal_px.is_none(), ..self.free },
        }
    }

    /// What it has beside its calibration.
    pub(super) fn label(&self) -> CameraLabel {
        CameraLabel { width_px: self.width_px, height_px: self.height_px, pixel_mm: self.pixel_mm }
    }
}

/// An image before its orientation.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct KnownImage {
    /// File name; no two images have the same.
    pub name: String,
    /// Index of its camera.
    pub camera: usize,
    /// Where GPS has the perspective centre.
    #[serde(default)]
    pub position: Option<ObservedPosition>,
}

/// A position that was observed. All of a block are of the same kind; or those of its images are of one and those of three surveyed points or
/// more of the other, which alone place the block: then distances between the images are compared with the recorded ones, and it is told
/// where the surveyed points have another unit.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(tag = "system", rename_all = "snake_case", deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum ObservedPosition {
    /// In a Cartesian system, z up.
    Local {
        /// x, y, z in m.
        position: [f64; 3],
        /// Standard error of each coordinate in m, above 0.
        sigma: [f64; 3],
    },
    /// On WGS 84.
    Geographic {
        longitude_deg: f64,
        latitude_deg: f64,
        /// Above the ellipsoid, or above any level that is the same for all positions of the block; absent: not known. Surveyed points
        /// have one.
        #[serde(default)]
        height_m: Option<f64>,
        /// Standard errors to the east, to the north and up in m, above 0.
        sigma_m: [f64; 3],
    },
}

/// A surveyed point with the images in which it was measured.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct GroundControlPoint {
    pub name: String,
    pub position: ObservedPosition,
    pub rays: Vec<ImageMeasurement>,
}

/// A surveyed point as an image shows it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ImageMeasurement {
    /// Index of the image.
    pub image: usize,
    /// Column and row in px, inside the image; the centre of the top-left pixel is (0.5, 0.5).
    pub x_px: f64,
    pub y_px: f64,
}
