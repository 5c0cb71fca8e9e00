//! A block as files hold it: cameras, images, object points with their observations.

use crate::camera::{Camera, Pose};
use serde::{Deserialize, Serialize};

/// A block: whatever is not known yet is absent.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct BlockModel {
    pub cameras: Vec<Camera>,
    pub images: Vec<ModelImage>,
    pub points: Vec<ObjectPoint>,
    /// Where on the earth the object space is; absent for a block in a system of its own.
    #[serde(default)]
    pub origin: Option<GeographicOrigin>,
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
    pub pose: Option<Pose>,
}

/// A tie point or control point.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ObjectPoint {
    /// By which files and views call it, counted from 1: the same whatever of its block is rejected. Absent where it has none but its place.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub number: Option<u32>,
    /// Absent where it is not intersected.
    #[serde(default)]
    pub position: Option<[f64; 3]>,
    /// Red, green, blue.
    #[serde(default = "grey")]
    pub colour: [u8; 3],
    /// Root mean square length of its residuals in px.
    #[serde(default)]
    pub rmse_px: Option<f64>,
    /// Probability, 0..1, that its observations belong together.
    #[serde(default = "one")]
    pub confidence: f64,
    /// Of a ground control or check point.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    pub rays: Vec<ImageObservation>,
    /// How many of these were measured by hand.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub by_hand: usize,
}

/// The measured position of a point in one image.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ImageObservation {
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

impl BlockModel {
    /// What files and views call the points by: their numbers, or their places, counted from 1, where any has none.
    pub fn point_numbers(&self) -> Vec<u32> {
        let own: Option<Vec<u32>> = self.points.iter().map(|point| point.number).collect();
        own.unwrap_or_else(|| (1..).take(self.points.len()).collect())
    }
}

/// The image that has two of the observations, if any has.
pub(super) fn seen_twice(observations: &[ImageObservation]) -> Option<usize> {
    let mut images: Vec<usize> = observations.iter().map(|observation| observation.image).collect();
    images.sort_unstable();
    images.windows(2).find(|pair| pair[0] == pair[1]).map(|pair| pair[0])
}

fn one() -> f64 {
    1.0
}

fn is_zero(count: &usize) -> bool {
    *count == 0
}

fn grey() -> [u8; 3] {
    [128; 3]
}

/// Three images and three points: one of three rays, one of two, one of two that is not intersected.
#[cfg(test)]
pub(crate) fn tiny_block() -> BlockModel {
    let upright = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let image = |name: &str, x: Option<f64>| ModelImage {
        name: name.into(),
        camera: 0,
        pose: x.map(|x| Pose { rotation: upright, position: [x, 0.0, 100.0] }),
    };
    let ray = |image, x_px, y_px| ImageObservation { image, x_px, y_px, confidence: 1.0 };
    let point = |position, rays: &[ImageObservation]| ObjectPoint {
        number: None,
        position,
        colour: [10, 20, 30],
        rmse_px: Some(0.25),
        confidence: 1.0,
        name: None,
        rays: rays.into(),
        by_hand: 0,
    };
    BlockModel {
        cameras: vec![Camera { pixel_mm: Some(0.01), ..Camera::without_distortion(400, 300, 500.0) }],
        images: vec![image("a.jpg", Some(0.0)), image("b.jpg", Some(10.0)), image("c.jpg", None)],
        points: vec![
            point(Some([5.0, 0.0, 0.0]), &[ray(0, 225.0, 150.0), ray(1, 175.0, 150.0), ray(2, 100.5, 20.25)]),
            point(Some([5.0, 10.0, 0.0]), &[ray(0, 225.0, 100.0), ray(1, 175.0, 100.0)]),
            point(None, &[ray(1, 10.0, 20.0), ray(2, 30.0, 40.0)]),
        ],
        origin: Some(GeographicOrigin { longitude_deg: 8.0, latitude_deg: 50.0, height_m: 200.0 }),
    }
}
