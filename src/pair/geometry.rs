//! The interior orientations of a pair: from fiducials, a given camera, or EXIF.

use super::cameras::{KnownPhoto, PairCameras, are_scans, doubt_of_part, doubt_of_scan, unused_pixel};
use super::input::{PairImage, PairInput, PhotoInput};
use super::no_orientation::NoOrientation;
use crate::error::refuse;
use crate::{
    CameraMm, CameraUncertainty, Error, EstimatedCamera, Fiducial, FiducialOrientation, Interior, Refusal, RelativeOrientation, Side,
    TwoView, TwoViewModel, Warning, orient_fiducials,
};
use serde::{Deserialize, Serialize};

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
    /// Whether fiducial marks were measured in both: then they are two photographs, however alike.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub are_scans: bool,
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

    /// Of cameras of which nothing is known but the sizes of their images: principal points in the middle of the images, a pixel being a
    /// thousandth of a millimetre. The focal length is the one that the geometry of the two views gave, or that of most cameras; the uncertainty is that of
    /// the latter, and where a file says that its image may be a part of a photo, of that too. `None` where the geometry is the map of a plane, which no
    /// camera turns into an orientation.
    pub fn assumed(found: &TwoView, photos: [KnownPhoto<'_>; 2]) -> Option<Self> {
        if matches!(found.model, TwoViewModel::Homography { .. }) {
            return None;
        }
        let [(left, left_mm), (right, right_mm)] = photos.map(|photo| assumed_interior(found, photo, photos));
        let doubts = [(Side::Left, photos[0]), (Side::Right, photos[1])].map(|(side, photo)| doubt_of_part(side, photo.file()?));
        let doubt = doubts[0].or(doubts[1]);
        // Of images of different sizes one may be resized, and so may be a part.
        let [(width, height), other] = photos.map(|photo| photo.size);
        let one_lens = doubt.is_none() && ((width, height) == other || (height, width) == other);
        // As in `pair_interior`.
        let right = right?.scaled(left_mm / right_mm);
        Some(Self { left: left?, right, focal_mm: left_mm, doubt, one_lens, are_scans: are_scans(&photos) })
    }
}

/// The interior orientation of one of both photos of which nothing is known, and its focal length in mm.
fn assumed_interior(found: &TwoView, photo: KnownPhoto<'_>, photos: [KnownPhoto<'_>; 2]) -> (Option<Interior>, f64) {
    let longer_px = photos.iter().map(KnownPhoto::longer_px).max().unwrap_or_default() as f64;
    let part = photo.file().and_then(|file| file.part(photo.size));
    // The photo is between as large as its image, which was resized then, and so many times as large: in the middle of both, either being as likely.
    let times = part.map_or(1.0, |part| part.times);
    let focal_px = found.focal.map_or(CameraUncertainty::ASSUMED_FOCAL * longer_px * times.sqrt(), |focal| focal.focal_px);
    let assumed = CameraUncertainty::ASSUMED;
    let uncertainty = part.map_or(assumed, |part| assumed.of_part(0.5 * libm::log(times), part.reach_px / focal_px));
    let camera = CameraMm { uncertainty: Some(uncertainty), ..CameraMm::of_focal_px(focal_px) };
    let (width, height) = photo.size;
    (Interior::from_pixel_size(&camera, width, height).ok(), camera.focal_mm)
}

/// What is known of both photos.
pub(super) fn known_photos<'a>(left: PairImage<'a>, right: PairImage<'a>, input: &PairInput) -> [KnownPhoto<'a>; 2] {
    [(left, &input.left), (right, &input.right)].map(|(image, photo)| KnownPhoto {
        size: (image.grey.width(), image.grey.height()),
        exif: image.exif,
        has_marks: !photo.fiducials.is_empty(),
    })
}

/// The interior orientations; or what is missing.
pub(super) fn pair_interior(
    left: PairImage<'_>,
    right: PairImage<'_>,
    input: &PairInput,
) -> Result<Result<PairInterior, NoOrientation>, Error> {
    let cameras = match PairCameras::of(input.camera.as_ref(), known_photos(left, right, input))? {
        Ok(cameras) => cameras,
        Err(reason) => return Ok(Err(reason)),
    };
    let PairCameras { left: left_camera, right: right_camera, doubt, one_lens, are_scans } = cameras;
    let own = |side, camera, image: PairImage<'_>, photo: &PhotoInput| {
        let size = (image.grey.width(), image.grey.height());
        let interior = photo_interior(camera, size.0, size.1, photo)?;
        let of_scan = || {
            doubt_of_scan(side, camera.focal_mm, &interior, size, &photo.fiducials).or_else(|| unused_pixel(camera, interior.pixel_mm()))
        };
        let doubt = if photo.fiducials.is_empty() { None } else { of_scan() };
        Ok::<_, Error>((interior, doubt))
    };
    let (left, left_doubt) = own(Side::Left, &left_camera, left, &input.left)?;
    let (right, right_doubt) = own(Side::Right, &right_camera, right, &input.right)?;
    // What speaks against a camera stands before what is only to be said of it.
    let (weak, mild) = [doubt, left_doubt, right_doubt].into_iter().flatten().partition::<Vec<_>, _>(Warning::is_weakness);
    let doubt = weak.into_iter().chain(mild).next();
    // Only directions matter: the right photo is taken to the focal length of the left one.
    let focal_mm = left_camera.focal_mm;
    Ok(Ok(PairInterior { left, right: right.scaled(focal_mm / right_camera.focal_mm), focal_mm, doubt, one_lens, are_scans }))
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

/// The transformation from a scan to photo coordinates by the marks that were measured in it; the image is a part of the scan or all of it.
///
/// # Errors
/// As [`orient_fiducials`]; [`Error::InvalidInput`] for marks outside the image without an origin, and for marks that contradict each other.
pub fn photo_marks(width: usize, height: usize, photo: &PhotoInput) -> Result<FiducialOrientation, Error> {
    check_marks(width, height, photo)?;
    let marks = orient_fiducials(&photo.fiducials, photo.model)?;
    match marks.sigma0_mm.filter(|sigma0_mm| !(*sigma0_mm <= LARGEST_MARKS_SIGMA0_MM)) {
        Some(sigma0_mm) => refuse(Refusal::MarksSigma0 { sigma0_mm, most_mm: LARGEST_MARKS_SIGMA0_MM }),
        None => Ok(marks),
    }
}

/// The interior orientation of one image: from its fiducials, or from the camera's pixel size.
///
/// # Errors
/// [`Error::InvalidOption`] for the camera, also where its distortion folds the image; as [`photo_marks`]; [`Error::InvalidInput`] for an origin without
/// fiducials.
pub fn photo_interior(camera: &CameraMm, width: usize, height: usize, photo: &PhotoInput) -> Result<Interior, Error> {
    let interior = match photo.origin {
        _ if !photo.fiducials.is_empty() => {
            let marks = photo_marks(width, height, photo)?;
            Interior::from_fiducials(camera, &marks, photo.origin.unwrap_or([0.0; 2]))?
        }
        Some(origin) => return refuse(Refusal::LoneOrigin { origin: format!("{origin:?}") }),
        None => Interior::from_pixel_size(camera, width, height)?,
    };
    interior.check_distortion(width, height).map(|()| interior)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{CameraCaution, CameraOrigin, ExifCamera};

    fn photo(exif: Option<&ExifCamera>) -> KnownPhoto<'_> {
        KnownPhoto { size: (1000, 900), exif, has_marks: false }
    }

    #[test]
    fn the_principal_point_of_a_cropped_photo_may_lie_anywhere_that_the_crop_allows() {
        let model = TwoViewModel::Fundamental { fundamental: [[0.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]] };
        let found = TwoView { model, inliers: vec![], threshold_px: 1.0, sigma_px: 0.3, degenerate: None, homography: None, focal: None };
        let file = |caution| ExifCamera { origin: CameraOrigin::FocalLengthAlone, cautions: vec![caution], ..ExifCamera::default() };
        let [taken_width_px, taken_height_px, width_px, height_px] = [4000, 3000, 1000, 900];
        let cropped = file(CameraCaution::Cropped { taken_width_px, taken_height_px, width_px, height_px });
        let other_pixels = file(CameraCaution::FocalPlane { pixel_um: 2.0, expected_um: 4.0 });
        let assumed = |files: [Option<&ExifCamera>; 2]| PairInterior::assumed(&found, files.map(photo)).unwrap();
        // Up to 1,550 px off the middle, uniformly distributed, where the focal length is twice as long as that of a whole photo; of a photo that
        // may be twice as large, up to 500 px.
        for (file, times, reach_px) in [(&cropped, 4.0_f64, 1550.0), (&other_pixels, 2.0, 500.0)] {
            let PairInterior { left, right, focal_mm, doubt, one_lens, .. } = assumed([None, Some(file)]);
            assert_eq!(left.uncertainty, Some(CameraUncertainty::ASSUMED));
            let own_px = times.sqrt() * CameraUncertainty::ASSUMED_FOCAL * 1000.0;
            assert!((focal_mm / right.pixel_mm() - own_px).abs() < 1e-6, "{} px", focal_mm / right.pixel_mm());
            let CameraUncertainty { focal, principal_point, .. } = right.uncertainty.unwrap();
            assert!((focal - 0.4_f64.hypot(0.5 * times.ln())).abs() < 1e-12, "{focal}");
            assert!((principal_point * own_px - reach_px / 3.0_f64.sqrt()).abs() < 1.0, "{} px", principal_point * own_px);
            assert!(doubt.is_some_and(|doubt| doubt.is_weakness()) && !one_lens, "{doubt:?}");
        }
        // A scanner may write what it likes.
        let scans = [&cropped, &other_pixels].map(|file| KnownPhoto { has_marks: true, ..photo(Some(file)) });
        let PairInterior { right, doubt, are_scans, .. } = PairInterior::assumed(&found, scans).unwrap();
        assert!(right.uncertainty == Some(CameraUncertainty::ASSUMED) && doubt.is_none() && are_scans, "{doubt:?}");
        let doubt = Warning::Cropped { side: Side::Left, taken_width_px, taken_height_px, width_px, height_px };
        assert_eq!(assumed([Some(&cropped), Some(&other_pixels)]).doubt, Some(doubt));
        let PairInterior { doubt, one_lens, .. } = assumed([None, Some(&ExifCamera::default())]);
        assert!(doubt.is_none() && one_lens);
    }
}
