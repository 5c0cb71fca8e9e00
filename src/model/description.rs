//! What is known of a block before it is oriented: cameras, images, ground control points.

use super::block::seen_twice;
use super::{BlockModel, ControlRole, GroundControlPoint, ModelImage, ObservedPosition};
use crate::camera::{Camera, CameraUncertainty, FreeParameters};
use crate::error::refuse;
use crate::message::{Message, written};
use crate::{Error, Few, Location, Refusal};
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

impl BlockDescription {
    /// Refuses what no block can be, as [`reconstruct_block`](crate::reconstruct_block) does, before anything is measured.
    ///
    /// # Errors
    /// [`Error::TooFew`] below two images; [`Error::InvalidInput`] for indices of nothing, values that are none or out of range, and marks of
    /// surveyed points that are outside their image or twice in it.
    pub fn check(&self) -> Result<(), Error> {
        if self.images.len() < 2 {
            return Err(Error::TooFew { few: Few::ImagesOfBlock, got: self.images.len(), needed: 2 });
        }
        let named = |index| {
            move || {
                let NamedCamera { only, number, first, more } = self.named_camera(index);
                Location::NamedCamera { only, number, first, more }
            }
        };
        for (index, camera) in self.cameras.iter().enumerate() {
            camera.approximate().check(named(index))?;
            camera.uncertainty.iter().try_for_each(|uncertainty| uncertainty.check_of_block(named(index)))?;
        }
        for image in &self.images {
            if image.camera >= self.cameras.len() {
                return refuse(Refusal::CameraOfImage { camera: image.camera, name: image.name.clone(), cameras: self.cameras.len() });
            }
            image.position.iter().try_for_each(|position| position.check(|| Location::Image { name: image.name.clone() }))?;
        }
        self.control.iter().try_for_each(|control| self.check_control(control))?;
        let is_geographic = |point: &GroundControlPoint| matches!(point.position, ObservedPosition::Geographic { .. });
        let placing = self.control.iter().find(|point| point.role == ControlRole::Control);
        let differs = |point: &&GroundControlPoint| {
            point.role == ControlRole::Check && placing.is_some_and(|placing| is_geographic(placing) != is_geographic(point))
        };
        let other = self.control.iter().find(differs);
        other.map_or(Ok(()), |point| refuse(Refusal::OtherCoordinates { point: point.name.clone() }))
    }

    fn check_control(&self, point: &GroundControlPoint) -> Result<(), Error> {
        let own = || point.name.clone();
        point.check_values()?;
        if matches!(point.position, ObservedPosition::Geographic { height_m: None, .. }) {
            return refuse(Refusal::NoHeight { point: own() });
        }
        for ray in &point.measurements {
            let Some(image) = self.images.get(ray.image) else {
                return refuse(Refusal::MeasuredImage { image: ray.image, point: own(), images: self.images.len() });
            };
            let camera = self.cameras[image.camera].approximate();
            if !camera.sees(ray.x_px, ray.y_px) {
                let (x_px, y_px, name) = (ray.x_px, ray.y_px, image.name.clone());
                let Camera { width_px, height_px, .. } = camera;
                return refuse(Refusal::MeasuredOutside { x_px, y_px, point: own(), name, width_px, height_px });
            }
        }
        match seen_twice(&point.measurements) {
            Some(image) => refuse(Refusal::MeasuredTwice { point: own(), name: self.images[image].name.clone() }),
            None => Ok(()),
        }
    }

    /// The block before any of its images is oriented, without points; what is not known of a camera is guessed as
    /// [`reconstruct_block`](crate::reconstruct_block) guesses it.
    pub fn to_model(&self) -> BlockModel {
        let images = self.images.iter().map(|image| ModelImage { name: image.name.clone(), camera: image.camera, pose: None });
        BlockModel {
            cameras: self.cameras.iter().map(KnownCamera::approximate).collect(),
            images: images.collect(),
            ..BlockModel::default()
        }
    }

    /// A camera as texts name it.
    pub(crate) fn named_camera(&self, camera: usize) -> NamedCamera {
        let mut images = self.images.iter().filter(|image| image.camera == camera).map(|image| image.name.clone());
        NamedCamera { only: self.cameras.len() == 1, number: camera + 1, first: images.next(), more: images.count() }
    }
}

/// A camera by its number, from 1, and by its images: files number cameras from 0.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct NamedCamera {
    /// Whether the block has no other.
    pub only: bool,
    pub number: usize,
    /// Name of its first image.
    pub first: Option<String>,
    /// How many images it has beside that.
    pub more: usize,
}

written!(NamedCamera);

impl Message for NamedCamera {
    const FAMILY: &'static str = "camera";
    #[cfg(test)]
    const KINDS: &'static [(&'static str, &'static [&'static str])] = &[("", &["only", "number", "first", "more"])];
}

/// A camera before its calibration; symbols as at [`Camera`](crate::Camera). Rules of files (`CameraRule`) and rows of a run (`InitialCamera`)
/// are this camera as they write it.
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
    /// What the block estimates of it, where it determines that: by default all but k3.
    #[serde(default = "usual")]
    pub free: FreeParameters,
    /// Side of a pixel in mm, for exports in photo coordinates.
    #[serde(default)]
    pub pixel_mm: Option<f64>,
    /// Standard deviations of the values above, which enter the adjustment as prior information; absent: as
    /// [`known_within`](Self::known_within) says.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub uncertainty: Option<CameraUncertainty>,
}

impl KnownCamera {
    /// A camera of which only the size of its images and, perhaps, its focal length is known.
    pub fn of_size(width_px: u32, height_px: u32, focal_px: Option<f64>) -> Self {
        Self {
            width_px,
            height_px,
            focal_px,
            principal_point_px: None,
            radial: [0.0; 3],
            tangential: [0.0; 2],
            free: FreeParameters::USUAL,
            pixel_mm: None,
            uncertainty: None,
        }
    }

    /// How well its values are known: as stated; else a focal length is taken for one of EXIF, and a guessed one for hardly known.
    pub fn known_within(&self) -> CameraUncertainty {
        let usual = if self.focal_px.is_some() { CameraUncertainty::EXIF } else { CameraUncertainty::ASSUMED };
        self.uncertainty.unwrap_or(usual).without_traces()
    }

    /// The camera with what is known of it, and guesses for the rest; a guessed focal length is estimated.
    pub fn approximate(&self) -> Camera {
        let Self { width_px, height_px, radial, tangential, pixel_mm, .. } = *self;
        let longer_side_px = f64::from(width_px.max(height_px));
        let plain = Camera::without_distortion(width_px, height_px, self.focal_px.unwrap_or(GUESSED_FOCAL * longer_side_px));
        let principal_point_px = self.principal_point_px.unwrap_or(plain.principal_point_px);
        let known = self.known_within();
        let free = FreeParameters {
            focal: (self.free.focal || self.focal_px.is_none()) && known.focal > 0.0,
            principal_point: self.free.principal_point && known.principal_point > 0.0,
            radial: if known.k1 > 0.0 { self.free.radial } else { 0 },
            tangential: self.free.tangential && known.decentring() > 0.0,
        };
        Camera { principal_point_px, radial, tangential, pixel_mm, free, ..plain }
    }

    /// The same, of which nothing is estimated.
    pub(crate) fn held(&self) -> Camera {
        Camera { free: FreeParameters::default(), ..self.approximate() }
    }
}

fn usual() -> FreeParameters {
    FreeParameters::USUAL
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
    /// Where GNSS has the projection centre.
    #[serde(default)]
    pub position: Option<ObservedPosition>,
    /// The direction of view that a drone recorded, of length 1: east, north, up. It levels a block that its positions hardly level.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub view: Option<[f64; 3]>,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::CameraPrior;

    #[test]
    fn a_block_that_is_not_oriented_has_guesses_where_nothing_is_known() {
        let known = KnownCamera { principal_point_px: Some([2010.0, 1490.0]), ..KnownCamera::of_size(4000, 3000, Some(3500.0)) };
        let image = |name: &str, camera| KnownImage { name: name.into(), camera, position: None, view: None };
        let cameras = vec![KnownCamera::of_size(600, 800, None), known];
        let description = BlockDescription { cameras, images: vec![image("a.jpg", 1), image("b.jpg", 0)], control: Vec::new() };
        let model = description.to_model();
        model.check().unwrap();
        let seen: Vec<_> = model.cameras.iter().map(|camera| (camera.focal_px, camera.principal_point_px)).collect();
        assert_eq!(seen, [(960.0, [300.0, 400.0]), (3500.0, [2010.0, 1490.0])]);
        let images: Vec<_> = model.images.iter().map(|image| (image.name.as_str(), image.camera, image.pose)).collect();
        assert_eq!(images, [("a.jpg", 1, None), ("b.jpg", 0, None)]);
    }

    #[test]
    fn a_trace_of_uncertainty_is_none_and_one_that_is_none_names_its_camera() {
        let known = |uncertainty| KnownCamera { uncertainty: Some(uncertainty), ..KnownCamera::of_size(4000, 3000, Some(3500.0)) };
        let traces = known(CameraUncertainty { focal: 1e-16, principal_point: 1e-12, k1: 1e-13 });
        assert_eq!(traces.known_within(), CameraUncertainty::NONE);
        let free = traces.approximate().free;
        assert!(!free.focal && !free.principal_point && free.radial == 0, "{free:?}");
        assert_eq!(CameraPrior::of(0, &traces.approximate(), traces.known_within()).sigma, [None; 8]);
        let image = |name: &str, camera| KnownImage { name: name.into(), camera, position: None, view: None };
        let cameras = vec![traces, known(CameraUncertainty { k1: 1.5, ..CameraUncertainty::EXIF })];
        let images = vec![image("a.jpg", 0), image("b.jpg", 1)];
        let refused = BlockDescription { cameras, images, control: Vec::new() }.check().unwrap_err().to_string();
        assert!(refused.contains("1.5") && refused.contains("b.jpg") && !refused.contains("a.jpg"), "{refused}");
    }
}
