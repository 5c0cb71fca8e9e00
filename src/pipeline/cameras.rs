//! Which images share a camera, and what is known of it before its calibration.

use super::Remark;
use crate::camera::camera_label;
use crate::error::refuse;
use crate::{Camera, CameraRule, Error, ExifImage, FreeParameters, KnownCamera, Pinhole, Refusal, parse_camera_rules};
use serde::{Deserialize, Serialize};

/// A camera before its calibration.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct InitialCamera {
    /// Make, model, focal length and size, or the pattern of the rule and the size.
    pub label: String,
    pub width_px: u32,
    pub height_px: u32,
    /// Absent where it is not known.
    pub focal_px: Option<f64>,
    pub principal_point_px: [f64; 2],
    pub radial: [f64; 3],
    pub tangential: [f64; 2],
    pub pixel_mm: Option<f64>,
    /// Whether the block takes it as it is.
    pub fixed: bool,
}

impl InitialCamera {
    /// As a model holds it; absent where its focal length is not known.
    pub fn known(&self) -> Option<Camera> {
        self.focal_px?;
        Some(Camera { free: FreeParameters::default(), ..self.to_be_calibrated().approximate() })
    }

    /// As the reconstruction takes it.
    pub fn to_be_calibrated(&self) -> KnownCamera {
        let Self { width_px, height_px, focal_px, principal_point_px, radial, tangential, pixel_mm, fixed, .. } = *self;
        let free = if fixed { FreeParameters::default() } else { FreeParameters::USUAL };
        KnownCamera { width_px, height_px, focal_px, principal_point_px: Some(principal_point_px), radial, tangential, free, pixel_mm }
    }
}

/// Cameras of a file, which take the place of those of EXIF.
#[derive(Debug, Clone, Default)]
pub struct CameraRules(Vec<CameraRule>);

/// Names of images that a refusal shows.
const SHOWN: usize = 2;

/// Focal lengths in longer sides of the image, between which those of cameras are.
const USUAL_FOCAL: [f64; 2] = [0.3, 20.0];

impl CameraRules {
    /// Reads a file of cameras; without one there are none.
    ///
    /// # Errors
    /// As [`parse_camera_rules`].
    pub fn read(text: Option<&str>) -> Result<Self, Error> {
        text.map_or(Ok(Vec::new()), parse_camera_rules).map(Self)
    }

    /// Patterns that no image's name fits.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] where all are so: the file is of other images.
    pub fn unused(&self, names: &[String]) -> Result<Vec<String>, Error> {
        let unused = self.0.iter().filter(|rule| !names.iter().any(|name| rule.fits(name)));
        let unused: Vec<String> = unused.map(|rule| rule.images.clone()).collect();
        if unused.is_empty() || unused.len() < self.0.len() {
            return Ok(unused);
        }
        let shown: Vec<&str> = names.iter().take(SHOWN).map(String::as_str).collect();
        refuse(Refusal::UnusedPatterns { patterns: unused.join(", "), names: shown.join(", ") })
    }

    /// Whether the camera of an image is given.
    pub fn fits(&self, name: &str) -> bool {
        self.0.iter().any(|rule| rule.fits(name))
    }

    /// The index of the rule that an image fits, and its camera.
    pub(crate) fn camera_of(&self, name: &str, size: [u32; 2], exif: &ExifImage) -> (Option<usize>, InitialCamera) {
        let rule = self.0.iter().position(|rule| rule.fits(name));
        (rule, rule.map_or_else(|| of_exif(size, exif), |rule| of_rule(&self.0[rule], size, exif)))
    }

    /// The cameras of images with these names, sizes in px and EXIF, and the index of each image's own. Images of one make, model, focal
    /// length, size and recorded lens are of one camera, and so are those of one rule and size.
    pub fn group<'a>(&self, images: impl Iterator<Item = (&'a str, [u32; 2], &'a ExifImage)>) -> (Vec<InitialCamera>, Vec<usize>) {
        let mut found: Vec<(Option<usize>, InitialCamera)> = Vec::new();
        let mut of = Vec::new();
        for (name, size, exif) in images {
            let own = self.camera_of(name, size, exif);
            let index = found.iter().position(|other| *other == own).unwrap_or(found.len());
            if index == found.len() {
                found.push(own);
            }
            of.push(index);
        }
        (found.into_iter().map(|(_, camera)| camera).collect(), of)
    }
}

fn plain([width_px, height_px]: [u32; 2]) -> InitialCamera {
    InitialCamera {
        label: String::new(),
        width_px,
        height_px,
        focal_px: None,
        principal_point_px: [0.5 * f64::from(width_px), 0.5 * f64::from(height_px)],
        radial: [0.0; 3],
        tangential: [0.0; 2],
        pixel_mm: None,
        fixed: false,
    }
}

fn of_exif(size: [u32; 2], exif: &ExifImage) -> InitialCamera {
    // No focal length makes a panorama a photograph: its camera is unknown.
    let camera = exif.camera.as_ref().filter(|camera| !camera.is_panorama());
    let label = camera_label(exif.make.as_deref(), exif.model.as_deref(), camera.map(|camera| camera.focal_mm), size);
    let pixel_mm = camera.and_then(|camera| camera.pixel_mm);
    let focal_px = camera.zip(pixel_mm).map(|(camera, pixel)| camera.focal_mm / pixel);
    let plain = InitialCamera { label, focal_px, pixel_mm, ..plain(size) };
    match camera.and_then(|camera| camera.lens.as_deref()) {
        Some(&Camera { principal_point_px, radial, tangential, .. }) => InitialCamera { principal_point_px, radial, tangential, ..plain },
        None => plain,
    }
}

fn of_rule(rule: &CameraRule, size: [u32; 2], exif: &ExifImage) -> InitialCamera {
    let camera = plain(size);
    InitialCamera {
        label: format!("{}, {} x {} px", rule.images, size[0], size[1]),
        focal_px: Some(rule.focal_px),
        principal_point_px: rule.principal_point_px.unwrap_or(camera.principal_point_px),
        radial: rule.radial,
        tangential: rule.tangential,
        pixel_mm: rule.pixel_mm.or_else(|| exif.camera.as_ref()?.pixel_mm),
        fixed: rule.fixed,
        ..camera
    }
}

/// Cameras whose focal length is hardly one in px.
pub(super) fn doubtful(cameras: &[InitialCamera]) -> impl Iterator<Item = Remark> {
    cameras.iter().filter_map(|camera| {
        let focal_px = camera.focal_px?;
        let sides = focal_px / f64::from(camera.width_px.max(camera.height_px));
        let [least, most] = USUAL_FOCAL;
        let label = camera.label.clone();
        (!(least..=most).contains(&sides)).then_some(Remark::DoubtfulFocal { label, focal_px, sides, least, most, in_mm: sides < least })
    })
}

/// A camera as the matching of a pair takes it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct PairCamera {
    pub pinhole: Pinhole,
    /// Whose distortion positions are freed of; absent where none is known.
    pub lens: Option<Camera>,
}

/// What is known of the cameras of a pair: two focal lengths or none.
pub(super) fn pair_cameras(cameras: [&InitialCamera; 2]) -> [PairCamera; 2] {
    let both = cameras.iter().all(|camera| camera.focal_px.is_some());
    cameras.map(|camera| {
        let is_distorted = camera.radial.iter().chain(&camera.tangential).any(|k| *k != 0.0);
        PairCamera {
            pinhole: Pinhole { focal_px: camera.focal_px.filter(|_| both), principal_px: camera.principal_point_px },
            lens: camera.known().filter(|_| both && is_distorted),
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ExifCamera;

    fn exif(make: &str, model: &str, focal_mm: f64) -> ExifImage {
        let [make, model] = [make, model].map(|text| Some(text.to_string()));
        let camera = ExifCamera { make: make.clone(), model: model.clone(), focal_mm, pixel_mm: Some(0.005), ..ExifCamera::default() };
        ExifImage { make, model, camera: Some(camera), ..ExifImage::default() }
    }

    #[test]
    fn images_of_one_make_focal_length_and_size_share_a_camera() {
        let (one, other) = (exif("DJI", "FC220", 4.5), exif("Canon", "Canon EOS", 35.0));
        let images = [("a", [400, 300], &one), ("b", [300, 400], &one), ("c", [400, 300], &other), ("d", [400, 300], &one)];
        let (cameras, of) = CameraRules::default().group(images.into_iter());
        assert_eq!(of, [0, 1, 2, 0]);
        let labels: Vec<&str> = cameras.iter().map(|camera| camera.label.as_str()).collect();
        assert_eq!(labels, ["DJI FC220, 4.5 mm, 400 x 300 px", "DJI FC220, 4.5 mm, 300 x 400 px", "Canon EOS, 35 mm, 400 x 300 px"]);
        assert_eq!(cameras[0].focal_px, Some(900.0));
    }

    #[test]
    fn a_file_of_cameras_of_other_images_is_refused() {
        let rules =
            CameraRules::read(Some(r#"{"cameras": [{"images": "DJI_*", "focal_px": 100}, {"images": "p*", "focal_px": 9}]}"#)).unwrap();
        let names = |list: &[&str]| list.iter().map(|name| name.to_string()).collect::<Vec<_>>();
        assert_eq!(rules.unused(&names(&["p1"])).unwrap(), ["DJI_*"]);
        assert!(rules.unused(&names(&["x.png"])).unwrap_err().to_string().contains("DJI_*, p*, which fit no image"));
        let exif = ExifImage::default();
        let (cameras, _) = rules.group([("p1", [640, 480], &exif)].into_iter());
        let said: Vec<String> = doubtful(&cameras).map(|remark| remark.to_string()).collect();
        assert_eq!(
            said,
            [
                "the focal length of p*, 640 x 480 px is 9 px, 0.014 of the longer side of the image, where 0.3 to 20 are usual: is it in mm?"
            ]
        );
    }
}
