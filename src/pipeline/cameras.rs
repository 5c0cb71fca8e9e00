//! Which images share a camera, and what is known of it before its calibration.

use crate::camera::{FARTHEST_PRINCIPAL, USUAL_FOCAL, camera_label, contradict, far_principal, is_near};
use crate::error::refuse;
use crate::{
    Camera, CameraRule, CameraUncertainty, Error, ExifImage, FreeParameters, KnownCamera, Pinhole, Refusal, Remark, parse_camera_rules,
};
use serde::{Deserialize, Serialize};
use std::cmp::Ordering;

/// A [`KnownCamera`] by its name, as results and project files hold it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
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
    /// How well it is known, by where it is known from; absent in blocks of former versions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub uncertainty: Option<CameraUncertainty>,
}

impl InitialCamera {
    /// The row of a camera. It is taken as it is where nothing of it is estimated.
    pub(crate) fn new(label: String, known: &KnownCamera) -> Self {
        let KnownCamera { width_px, height_px, focal_px, radial, tangential, pixel_mm, free, uncertainty, .. } = *known;
        let Camera { principal_point_px, .. } = known.approximate();
        let fixed = free == FreeParameters::default();
        Self { label, width_px, height_px, focal_px, principal_point_px, radial, tangential, pixel_mm, fixed, uncertainty }
    }

    /// As a model holds it; absent where its focal length is not known.
    pub fn known(&self) -> Option<Camera> {
        self.focal_px.map(|_| self.to_be_calibrated().held())
    }

    /// As the reconstruction takes it.
    pub fn to_be_calibrated(&self) -> KnownCamera {
        let Self { width_px, height_px, focal_px, principal_point_px, radial, tangential, pixel_mm, fixed, uncertainty, .. } = *self;
        let free = if fixed { FreeParameters::default() } else { FreeParameters::USUAL };
        let principal_point_px = Some(principal_point_px);
        KnownCamera { width_px, height_px, focal_px, principal_point_px, radial, tangential, free, pixel_mm, uncertainty }
    }
}

/// So far on the way to the corners, at least, distortion must not fold an image: calibrated lenses of wide angle may do so in the corners.
const UNFOLDED: f64 = 0.6;

/// Refuses distortion that folds images, as terms in other units do.
///
/// # Errors
/// [`Error::InvalidInput`], naming the camera and its terms.
pub(super) fn check_distortion(cameras: &[InitialCamera]) -> Result<(), Error> {
    let folds = |camera: &&InitialCamera| {
        let Some(known) = camera.known() else { return false };
        let ([cx, cy], [width, height]) = (known.principal_point_px, [camera.width_px, camera.height_px].map(f64::from));
        let corners = [[0.0, 0.0], [width, 0.0], [0.0, height], [width, height]];
        corners.iter().any(|[x, y]| known.direction([cx + UNFOLDED * (x - cx), cy + UNFOLDED * (y - cy)]).is_err())
    };
    match cameras.iter().find(folds) {
        Some(InitialCamera { label, radial, .. }) => refuse(Refusal::FoldedImage { camera: label.clone(), radial: format!("{radial:?}") }),
        None => Ok(()),
    }
}

/// Cameras of a file, which take the place of those of EXIF.
#[derive(Debug, Clone, Default)]
pub struct CameraRules(Vec<CameraRule>);

/// Names of images that a refusal shows.
const SHOWN: usize = 2;

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
    /// length, size and recorded lens are of one camera, and so are those of one rule and size. Constants count as one to within what
    /// rounding in files changes. The order of the images decides the order of the cameras and nothing else.
    pub fn group<'a>(&self, images: impl Iterator<Item = (&'a str, [u32; 2], &'a ExifImage)>) -> (Vec<InitialCamera>, Vec<usize>) {
        let own: Vec<OwnCamera> = images.map(|(name, size, exif)| OwnCamera::new(self.camera_of(name, size, exif), exif)).collect();
        let mut order: Vec<usize> = (0..own.len()).collect();
        order.sort_by(|a, b| own[*a].order(&own[*b]));
        // Each is compared with the first of a camera, so that no chain of small steps joins cameras.
        let (mut firsts, mut first_of): (Vec<usize>, Vec<usize>) = (Vec::new(), vec![0; own.len()]);
        for k in order {
            let first = firsts.iter().copied().find(|first| own[*first].is_same(&own[k])).unwrap_or(k);
            if first == k {
                firsts.push(k);
            }
            first_of[k] = first;
        }
        let mut met: Vec<usize> = Vec::new();
        let of = first_of.iter().map(|first| {
            met.iter().position(|known| known == first).unwrap_or_else(|| {
                met.push(*first);
                met.len() - 1
            })
        });
        let of: Vec<usize> = of.collect();
        (met.into_iter().map(|first| own[first].camera.clone()).collect(), of)
    }
}

/// The camera of one image, with what tells it from others.
struct OwnCamera {
    camera: InitialCamera,
    rule: Option<usize>,
    /// Make, model and size; without the focal length, which a label rounds.
    name: String,
    /// Focal length in px and mm and side of a pixel, below 0 where they are unknown; principal point in px, radial and tangential distortion.
    constants: [f64; 10],
}

impl OwnCamera {
    fn new((rule, camera): (Option<usize>, InitialCamera), exif: &ExifImage) -> Self {
        const UNKNOWN: f64 = -1.0;
        let size = [camera.width_px, camera.height_px];
        let focal_mm = exif.camera.as_ref().filter(|camera| rule.is_none() && !camera.is_panorama()).map(|camera| camera.focal_mm);
        let [focal_px, focal_mm, pixel_mm] = [camera.focal_px, focal_mm, camera.pixel_mm].map(|known| known.unwrap_or(UNKNOWN));
        let ([x, y], [k1, k2, k3], [p1, p2]) = (camera.principal_point_px, camera.radial, camera.tangential);
        let name = match rule {
            Some(_) => String::new(),
            None => camera_label(exif.make.as_deref(), exif.model.as_deref(), None, size),
        };
        Self { rule, name, constants: [focal_px, focal_mm, pixel_mm, x, y, k1, k2, k3, p1, p2], camera }
    }

    /// What must be equal.
    fn kind(&self) -> (Option<usize>, &str, [u32; 2], bool) {
        (self.rule, &self.name, [self.camera.width_px, self.camera.height_px], self.camera.fixed)
    }

    fn order(&self, other: &Self) -> Ordering {
        let constants = self.constants.iter().zip(&other.constants).map(|(a, b)| a.total_cmp(b));
        // Of equal constants those that are known best stand for all.
        let share = |own: &Self| own.camera.uncertainty.map_or(1.0, |uncertainty| uncertainty.focal);
        let order = self.kind().cmp(&other.kind()).then_with(|| constants.fold(Ordering::Equal, Ordering::then));
        order.then_with(|| share(self).total_cmp(&share(other)))
    }

    fn is_same(&self, other: &Self) -> bool {
        let side = f64::from(self.camera.width_px.max(self.camera.height_px));
        let [focal_px, focal_mm, pixel_mm, ..] = self.constants;
        let units = [focal_px, focal_mm, pixel_mm, side, side, 1.0, 1.0, 1.0, 1.0, 1.0];
        let constants = self.constants.iter().zip(&other.constants).zip(units);
        self.kind() == other.kind() && constants.into_iter().all(|((a, b), unit)| is_near(*a, *b, unit))
    }
}

fn of_exif(size: [u32; 2], exif: &ExifImage) -> InitialCamera {
    // No focal length makes a panorama a photograph: its camera is unknown.
    let camera = exif.camera.as_ref().filter(|camera| !camera.is_panorama());
    let label = camera_label(exif.make.as_deref(), exif.model.as_deref(), camera.map(|camera| camera.focal_mm), size);
    let pixel_mm = camera.and_then(|camera| camera.pixel_mm);
    let focal_px = camera.zip(pixel_mm).map(|(camera, pixel)| camera.focal_mm / pixel);
    let within = camera.filter(|_| focal_px.is_some()).map_or(CameraUncertainty::ASSUMED, |camera| CameraUncertainty::of(camera.origin));
    let plain = KnownCamera { pixel_mm, uncertainty: Some(within), ..KnownCamera::of_size(size[0], size[1], focal_px) };
    let known = match camera.and_then(|camera| camera.lens.as_deref()) {
        Some(&Camera { principal_point_px, radial, tangential, .. }) => {
            KnownCamera { principal_point_px: Some(principal_point_px), radial, tangential, ..plain }
        }
        None => plain,
    };
    InitialCamera::new(label, &known)
}

fn of_rule(rule: &CameraRule, [width_px, height_px]: [u32; 2], exif: &ExifImage) -> InitialCamera {
    let known = rule.known(width_px, height_px);
    let pixel_mm = known.pixel_mm.or_else(|| exif.camera.as_ref()?.pixel_mm);
    InitialCamera::new(format!("{}, {width_px} x {height_px} px", rule.images), &KnownCamera { pixel_mm, ..known })
}

/// Cameras whose focal length or principal point is hardly one in px.
pub(super) fn doubtful(cameras: &[InitialCamera]) -> impl Iterator<Item = Remark> {
    cameras.iter().flat_map(|camera| {
        let label = || camera.label.clone();
        let of_focal = camera.focal_px.and_then(|focal_px| {
            let sides = focal_px / f64::from(camera.width_px.max(camera.height_px));
            let [least, most] = USUAL_FOCAL;
            let doubt = || Remark::DoubtfulFocal { label: label(), focal_px, sides, least, most, in_mm: sides < least };
            (!(least..=most).contains(&sides)).then(doubt)
        });
        let size = [camera.width_px, camera.height_px].map(f64::from);
        let of_principal = far_principal(camera.principal_point_px, size);
        let of_principal = of_principal.map(|sides| Remark::FarPrincipalPoint { label: label(), sides, most: FARTHEST_PRINCIPAL });
        of_focal.into_iter().chain(of_principal)
    })
}

/// The label of the camera that is given for an image, and its focal length beside what the file of the image says, where that is another one.
pub(crate) fn contradicted_focal(rules: &CameraRules, name: &str, size: [u32; 2], exif: &ExifImage) -> Option<(String, [f64; 2])> {
    let InitialCamera { label, focal_px, .. } = rules.camera_of(name, size, exif).1;
    let both = focal_px.filter(|_| rules.fits(name)).zip(of_exif(size, exif).focal_px);
    both.filter(|(given, file)| contradict(*given, *file)).map(|both| (label, both.into()))
}

/// Given cameras whose focal length is another than what the files of their images say, each once, with these images.
pub(super) fn contradicted<'a>(
    rules: &CameraRules,
    images: impl Iterator<Item = (&'a str, [u32; 2], &'a ExifImage)>,
) -> impl Iterator<Item = Remark> {
    let mut found: Vec<(String, [f64; 2], Vec<String>)> = Vec::new();
    for (name, size, exif) in images {
        let Some((label, both)) = contradicted_focal(rules, name, size, exif) else { continue };
        match found.iter_mut().find(|(known, ..)| *known == label) {
            Some((.., images)) => images.push(name.to_string()),
            None => found.push((label, both, vec![name.to_string()])),
        }
    }
    found.into_iter().map(|(label, [focal_px, file_px], images)| Remark::ContradictedFocal { label, focal_px, file_px, images })
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

    #[test]
    fn a_row_holds_all_that_is_known_of_its_camera() {
        for free in [FreeParameters::default(), FreeParameters::USUAL] {
            let known = KnownCamera {
                principal_point_px: Some([310.0, 250.0]),
                radial: [0.1, -0.02, 0.003],
                tangential: [1e-4, -2e-4],
                free,
                pixel_mm: Some(0.004),
                ..KnownCamera::of_size(640, 480, Some(700.0))
            };
            let row = InitialCamera::new("a".into(), &known);
            assert_eq!(row.to_be_calibrated(), known);
            assert_eq!(row.known(), Some(known.held()));
        }
        let unknown = InitialCamera::new(String::new(), &KnownCamera::of_size(640, 480, None));
        assert_eq!((unknown.principal_point_px, unknown.fixed, unknown.known()), ([320.0, 240.0], false, None));
    }

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
    fn an_image_that_was_saved_again_shares_the_camera_of_the_others() {
        let size = [400, 300];
        let focal = |focal_mm: f64| exif("DJI", "FC220", focal_mm);
        // 4.4995 mm is where labels round to another thousandth.
        let images = [focal(4.4995), focal(4.4995 * (1.0 - 5e-9)), focal(4.6), focal(4.4995 * (1.0 + 5e-9))];
        let grouped = |order: &[usize]| {
            let (cameras, of) = CameraRules::default().group(order.iter().map(|k| ("a", size, &images[*k])));
            // The camera of each image, whatever the order.
            let mut focal = vec![0.0; images.len()];
            order.iter().zip(of).for_each(|(k, camera)| focal[*k] = cameras[camera].focal_px.unwrap());
            (cameras.len(), focal)
        };
        let (count, focal_px) = grouped(&[0, 1, 2, 3]);
        assert_eq!((count, focal_px[0] == focal_px[1], focal_px[0] == focal_px[3]), (2, true, true));
        for order in [[3, 2, 1, 0], [1, 3, 0, 2], [2, 0, 3, 1]] {
            assert_eq!(grouped(&order), (count, focal_px.clone()), "{order:?}");
        }
    }

    #[test]
    fn a_given_focal_length_that_the_files_contradict_is_told() {
        // 4.5 mm of 0.005 mm pixels are 900 px.
        let told = |focal_px: f64| -> Vec<String> {
            let rules = format!(r#"{{"cameras": [{{"images": "DJI*", "focal_px": {focal_px}}}]}}"#);
            let (own, none) = (exif("DJI", "FC220", 4.5), ExifImage::default());
            let images =
                [("DJI_1", [1200, 900], &own), ("DJI_2", [1200, 900], &none), ("DJI_3", [1200, 900], &own), ("x", [1200, 900], &own)];
            contradicted(&CameraRules::read(Some(&rules)).unwrap(), images.into_iter()).map(|remark| remark.to_string()).collect()
        };
        assert_eq!(
            told(450.0),
            ["the focal length of DJI*, 1200 x 900 px is given as 450.0 px, where the files of these images say 900.0 px: DJI_1, DJI_3"]
        );
        assert_eq!((told(800.0), told(1000.0)), (vec![], vec![]));
    }

    #[test]
    fn small_steps_do_not_join_cameras_and_real_differences_part_them() {
        let chain: Vec<ExifImage> = (0..40).map(|k| exif("DJI", "FC220", 4.5 * (1.0 + 5e-6 * f64::from(k)))).collect();
        let (cameras, of) = CameraRules::default().group(chain.iter().map(|exif| ("a", [400, 300], exif)));
        assert!((10..=20).contains(&cameras.len()), "{}", cameras.len());
        assert!(of[0] == of[1] && of[0] != of[39]);
        let mut unknown = exif("DJI", "FC220", 4.5);
        unknown.camera.as_mut().unwrap().pixel_mm = None;
        let apart = [exif("DJI", "FC220", 4.5), exif("DJI", "FC220", 4.501), unknown, exif("DJI", "FC221", 4.5)];
        let (cameras, _) = CameraRules::default().group(apart.iter().map(|exif| ("a", [400, 300], exif)));
        assert_eq!(cameras.len(), 4);
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

    #[test]
    fn distortion_that_folds_images_within_their_corners_is_refused() {
        let told = |radial: [f64; 3]| {
            let known = KnownCamera { radial, ..KnownCamera::of_size(900, 700, Some(1062.5)) };
            let camera = InitialCamera::new("*.jpg, 900 x 700 px".into(), &known);
            check_distortion(&[camera]).map_err(|error| error.to_string()).err()
        };
        for usual in [[0.0; 3], [-0.3, 0.1, 0.0], [0.5, 0.0, 0.0], [-0.7, 0.0, 0.0]] {
            assert_eq!(told(usual), None, "{usual:?}");
        }
        let folded = told([-2.5, 0.0, 0.0]).unwrap();
        assert!(folded.contains("*.jpg, 900 x 700 px: got [-2.5, 0.0, 0.0], which folds the image"), "{folded}");
    }
}
