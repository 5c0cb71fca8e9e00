//! The interior orientations of a pair: from fiducials, a given camera, or EXIF.

use super::input::{PairImage, PairInput, PhotoInput};
use super::no_orientation::NoOrientation;
use crate::camera::{USUAL_FOCAL, contradict};
use crate::error::refuse;
use crate::{
    CameraCaution, CameraMm, CameraUncertainty, Error, EstimatedCamera, ExifCamera, Fiducial, Interior, Refusal, RelativeOrientation, Side,
    TwoView, TwoViewModel, Warning, orient_fiducials,
};
use serde::{Deserialize, Serialize};

/// Side of a pixel where nobody knows it.
const NOMINAL_PIXEL_MM: f64 = 0.001;

/// How far outside the image a mark may have been measured, as a share of its side: the picture of a cut one is completed.
const BEYOND: f64 = 0.05;

/// Largest σ₀ of an interior orientation: film shrinks and scanners err by a few tenths of a millimetre at most.
const LARGEST_MARKS_SIGMA0_MM: f64 = 1.0;

/// The interior orientations of a pair, of one focal length.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct PairInterior {
    pub left: Interior,
    pub right: Interior,
    pub focal_mm: f64,
    /// What speaks against the focal lengths before anything is matched.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub doubt: Option<Warning>,
    /// Whether both photos are known to be of one lens at one focal length, however their images are turned or resized.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub one_lens: bool,
}

impl PairInterior {
    /// The same in photo axes turned by 90° anticlockwise.
    pub(super) fn turned(&self) -> Self {
        Self { left: self.left.turned(), right: self.right.turned(), ..*self }
    }

    /// The interior orientation and the focal length in mm of either photo, as the orientation has estimated them where the cameras are not
    /// known without error.
    pub(crate) fn estimated(&self, oriented: &RelativeOrientation) -> [(Interior, f64); 2] {
        let sides = [self.left, self.right];
        let Some(cameras) = &oriented.cameras else { return sides.map(|side| (side, self.focal_mm)) };
        [0, 1].map(|side| {
            let EstimatedCamera { focal_mm, principal_point_mm: [x, y], k1_per_mm2, .. } = cameras[side];
            // From the axes of ω φ κ, where these are turned, to those of the photo coordinates.
            let principal_point_mm = if oriented.turn_deg == 0.0 { [x, y] } else { [-y, x] };
            let [_, k2, k3] = sides[side].radial_distortion;
            (Interior { principal_point_mm, radial_distortion: [k1_per_mm2, k2, k3], ..sides[side] }, focal_mm)
        })
    }

    /// Of cameras of which nothing is known but the sizes of their images, in px: principal points in the middle of the images, a pixel being
    /// a thousandth of a millimetre. The focal length is the one that the geometry of the two views gave, or that of most cameras; the
    /// uncertainty is that of the latter. `None` where the geometry is the map of a plane, which no camera turns into an orientation.
    pub fn assumed(found: &TwoView, [left, right]: [(usize, usize); 2]) -> Option<Self> {
        if matches!(found.model, TwoViewModel::Homography { .. }) {
            return None;
        }
        let longer = left.0.max(left.1).max(right.0).max(right.1);
        let focal_px = found.focal.map_or(CameraUncertainty::ASSUMED_FOCAL * longer as f64, |focal| focal.focal_px);
        let focal_mm = focal_px * NOMINAL_PIXEL_MM;
        let uncertainty = Some(CameraUncertainty::ASSUMED);
        let camera = CameraMm { uncertainty, ..CameraMm::without_distortion(focal_mm, Some(NOMINAL_PIXEL_MM)) };
        let of = |(width, height)| Interior::from_pixel_size(&camera, width, height).ok();
        Some(Self { left: of(left)?, right: of(right)?, focal_mm, doubt: None, one_lens: false })
    }
}

/// The interior orientations; or what is missing.
pub(super) fn pair_interior(
    left: PairImage<'_>,
    right: PairImage<'_>,
    input: &PairInput,
) -> Result<Result<PairInterior, NoOrientation>, Error> {
    let of = |side: Side, image: PairImage<'_>, photo: &PhotoInput| {
        let camera = match (&input.camera, image.exif) {
            (Some(camera), _) => *camera,
            (None, Some(exif)) if exif.is_panorama() => return Ok(Err(NoOrientation::Panorama { side })),
            (None, Some(exif)) => CameraMm::from_exif(exif)?,
            (None, None) if photo.fiducials.is_empty() => {
                return Ok(Err(NoOrientation::NoCamera { side }));
            }
            (None, None) => return Ok(Err(NoOrientation::NoFocalLength)),
        };
        if photo.fiducials.is_empty() && camera.pixel_mm.is_none() {
            let altered = image.exif.filter(|_| input.camera.is_none()).and_then(altered);
            let altered = altered.map(|camera_caution| NoOrientation::Altered { side, camera_caution });
            return Ok(Err(altered.unwrap_or(NoOrientation::NoPixelSize { side })));
        }
        let (width, height) = (image.grey.width(), image.grey.height());
        let own = photo_interior(&camera, width, height, photo)?;
        // The focal length of a scan is that of its camera, whatever a scanner wrote.
        let is_digital = photo.fiducials.is_empty();
        let file = image.exif.filter(|exif| is_digital && input.camera.is_some() && !exif.is_panorama());
        let file_px = file.and_then(|exif| Some(exif.focal_mm / exif.pixel_mm?));
        let doubt = doubt_of(side, camera.focal_mm / own.pixel_mm(), file_px, is_digital.then_some(width.max(height)));
        let of_file = image.exif.filter(|_| is_digital && input.camera.is_none());
        let doubt = of_file.and_then(|exif| resized_or_cropped(side, exif)).or(doubt);
        Ok(Ok((own, camera.focal_mm, doubt)))
    };
    let of_files = || left.exif.zip(right.exif).is_some_and(|(left, right)| left.is_of_one_lens(right));
    let one_lens = input.camera.is_some() || of_files();
    Ok(match (of(Side::Left, left, &input.left)?, of(Side::Right, right, &input.right)?) {
        (Ok((left, focal_mm, left_doubt)), Ok((right, right_focal, right_doubt))) => {
            // Only directions matter: the right photo is taken to the focal length of the left one.
            let right = right.scaled(focal_mm / right_focal);
            Ok(PairInterior { left, right, focal_mm, doubt: left_doubt.or(right_doubt), one_lens })
        }
        (Err(reason), _) | (_, Err(reason)) => Err(reason),
    })
}

/// Why nobody knows how many px the focal length of a photo has.
fn altered(exif: &ExifCamera) -> Option<CameraCaution> {
    exif.cautions.iter().find(|caution| matches!(caution, CameraCaution::Cropped { .. } | CameraCaution::FocalPlane { .. })).cloned()
}

fn resized_or_cropped(side: Side, exif: &ExifCamera) -> Option<Warning> {
    let [[taken_width_px, taken_height_px], [width_px, height_px]] = exif.resized_or_cropped()?;
    Some(Warning::ResizedOrCropped { side, taken_width_px, taken_height_px, width_px, height_px })
}

/// What speaks against the focal length of a photo in px: what its file says, or the longer side of its image in px where that is whole.
fn doubt_of(side: Side, focal_px: f64, file_px: Option<f64>, longer_px: Option<usize>) -> Option<Warning> {
    if let Some(file_px) = file_px.filter(|file_px| contradict(focal_px, *file_px)) {
        return Some(Warning::ContradictedFocal { side, given_px: focal_px, file_px });
    }
    let [least, most] = USUAL_FOCAL;
    let sides = focal_px / longer_px? as f64;
    (!(least..=most).contains(&sides)).then_some(Warning::DoubtfulFocal { side, sides, least, most })
}

/// Refuses marks that cannot have been measured in the image.
fn check_marks(width: usize, height: usize, photo: &PhotoInput) -> Result<(), Error> {
    let is_beyond = |v: f64, side: usize| !(-BEYOND * side as f64..=(1.0 + BEYOND) * side as f64).contains(&v);
    let outside = |mark: &&Fiducial| photo.origin.is_none() && (is_beyond(mark.col, width) || is_beyond(mark.row, height));
    match photo.fiducials.iter().find(outside) {
        None => Ok(()),
        Some(mark) => refuse(Refusal::MarkOutside { col: mark.col, row: mark.row, width, height }),
    }
}

/// The interior orientation of one image: from its fiducials, or from the camera's pixel size.
///
/// # Errors
/// [`Error::InvalidOption`] for the camera; as [`orient_fiducials`]; [`Error::InvalidInput`] for an origin without fiducials, for marks
/// outside the image without an origin, and for marks that contradict each other.
pub fn photo_interior(camera: &CameraMm, width: usize, height: usize, photo: &PhotoInput) -> Result<Interior, Error> {
    if !photo.fiducials.is_empty() {
        check_marks(width, height, photo)?;
        let marks = orient_fiducials(&photo.fiducials, photo.model)?;
        if let Some(sigma0_mm) = marks.sigma0_mm.filter(|sigma0_mm| !(*sigma0_mm <= LARGEST_MARKS_SIGMA0_MM)) {
            return refuse(Refusal::MarksSigma0 { sigma0_mm, most_mm: LARGEST_MARKS_SIGMA0_MM });
        }
        return Interior::from_fiducials(camera, &marks, photo.origin.unwrap_or([0.0; 2]));
    }
    match photo.origin {
        Some(origin) => refuse(Refusal::LoneOrigin { origin: format!("{origin:?}") }),
        None => Interior::from_pixel_size(camera, width, height),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{CameraOrigin, GreyImage};

    /// What speaks against a camera of this focal length in px, given for photos of 640 x 480 px whose files say 600 px.
    fn doubt(focal_px: f64, exif: Option<&ExifCamera>, marks: bool) -> Option<Warning> {
        let grey = GreyImage::from_fn(640, 480, |_, _| 0).unwrap();
        let image = |exif| PairImage { grey: grey.view(), exif, mask: None };
        let mark = |col: f64, row: f64| Fiducial { col, row, x_mm: 0.01 * col, y_mm: -0.01 * row };
        let fiducials = if marks { vec![mark(0.0, 0.0), mark(640.0, 0.0), mark(0.0, 480.0), mark(640.0, 480.0)] } else { Vec::new() };
        let photo = PhotoInput { fiducials, ..PhotoInput::default() };
        let camera = Some(CameraMm::without_distortion(0.01 * focal_px, Some(0.01)));
        let input = PairInput { camera, left: photo.clone(), right: photo, offset: None };
        pair_interior(image(None), image(exif), &input).unwrap().unwrap().doubt
    }

    #[test]
    fn a_given_focal_length_is_compared_with_what_the_file_says() {
        let file = ExifCamera { focal_mm: 6.0, pixel_mm: Some(0.01), origin: CameraOrigin::ExifFocalPlane, ..ExifCamera::default() };
        let contradicted = |given_px| Some(Warning::ContradictedFocal { side: Side::Right, given_px, file_px: 600.0 });
        for (given_px, expected) in
            [(600.0, None), (690.0, None), (520.0, None), (1200.0, contradicted(1200.0)), (300.0, contradicted(300.0))]
        {
            assert_eq!(doubt(given_px, Some(&file), false), expected, "{given_px}");
        }
        // A scan is of a camera that its file does not know; what names no pixel, or a panorama, says nothing.
        assert_eq!(doubt(1200.0, Some(&file), true), None);
        assert_eq!(doubt(1200.0, Some(&ExifCamera { pixel_mm: None, ..file.clone() }), false), None);
        assert_eq!(doubt(1200.0, Some(&ExifCamera { origin: CameraOrigin::Panorama, ..file }), false), None);
        assert_eq!(doubt(1200.0, None, false), None);
    }

    #[test]
    fn a_focal_length_of_no_camera_is_doubted() {
        let doubtful = |sides| Some(Warning::DoubtfulFocal { side: Side::Left, sides, least: 0.3, most: 20.0 });
        assert_eq!((doubt(160.0, None, false), doubt(16_000.0, None, false)), (doubtful(0.25), doubtful(25.0)));
        assert_eq!((doubt(256.0, None, false), doubt(6400.0, None, false)), (None, None));
    }
}
