//! The cameras of a pair, given or of its files, and what is known beside their constants.

use super::no_orientation::NoOrientation;
use crate::camera::{FARTHEST_PRINCIPAL, USUAL_FOCAL, contradict, far_principal};
use crate::{CameraCaution, CameraMm, Error, ExifCamera, Fiducial, Interior, Side, Warning};
use serde::Serialize;

/// What of a photo tells its camera.
#[derive(Debug, Clone, Copy)]
pub struct KnownPhoto<'a> {
    /// Of its image, px.
    pub size: (usize, usize),
    pub exif: Option<&'a ExifCamera>,
    /// Whether fiducial marks were measured in it: then it is a scan.
    pub has_marks: bool,
}

/// The cameras of both photos.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct PairCameras {
    pub left: CameraMm,
    pub right: CameraMm,
    /// As in [`PairInterior`](super::PairInterior).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub doubt: Option<Warning>,
    /// As in [`PairInterior`](super::PairInterior).
    pub one_lens: bool,
    /// As in [`PairInterior`](super::PairInterior).
    pub are_scans: bool,
}

impl KnownPhoto<'_> {
    pub(super) fn longer_px(&self) -> usize {
        self.size.0.max(self.size.1)
    }

    /// What its file says of its camera: of a scan it says nothing, whatever a scanner wrote.
    pub(super) fn file(&self) -> Option<&ExifCamera> {
        self.exif.filter(|_| !self.has_marks)
    }
}

/// Whether fiducial marks were measured in both photos.
pub(super) fn are_scans(photos: &[KnownPhoto<'_>; 2]) -> bool {
    photos.iter().all(|photo| photo.has_marks)
}

impl PairCameras {
    /// The cameras; or what is missing. A camera that is given is that of both photos.
    ///
    /// # Errors
    /// As [`CameraMm::from_exif`].
    pub fn of(given: Option<&CameraMm>, [left, right]: [KnownPhoto<'_>; 2]) -> Result<Result<Self, NoOrientation>, Error> {
        let (of_left, of_right) = (camera_of(given, Side::Left, left)?, camera_of(given, Side::Right, right)?);
        let are_scans = are_scans(&[left, right]);
        let of_one_lens = left.exif.zip(right.exif).is_some_and(|(left, right)| left.is_of_one_lens(right));
        Ok(of_left.and_then(|(left, left_doubt)| {
            of_right.map(|(right, right_doubt)| Self {
                left,
                right,
                doubt: left_doubt.or(right_doubt),
                one_lens: given.is_some() || of_one_lens,
                are_scans,
            })
        }))
    }
}

/// The camera of a photo with what speaks against it; or what is missing.
fn camera_of(
    given: Option<&CameraMm>,
    side: Side,
    photo: KnownPhoto<'_>,
) -> Result<Result<(CameraMm, Option<Warning>), NoOrientation>, Error> {
    let camera = match (given, photo.exif) {
        (Some(camera), file) => {
            camera.check()?;
            // A focal length alone is of the pixels that the file tells, unless it is a part of another image.
            let own =
                file.filter(|exif| !photo.has_marks && !exif.is_panorama() && exif.partial().is_none()).and_then(|exif| exif.pixel_mm);
            CameraMm { pixel_mm: camera.pixel_mm.or(own), ..*camera }
        }
        (None, Some(exif)) if exif.is_panorama() => return Ok(Err(NoOrientation::Panorama { side })),
        (None, Some(exif)) => CameraMm::from_exif(exif)?,
        (None, None) if photo.has_marks => return Ok(Err(NoOrientation::NoFocalLength)),
        (None, None) => return Ok(Err(NoOrientation::NoCamera { side })),
    };
    // The focal length of a scan is that of its camera, whatever a scanner wrote.
    if photo.has_marks {
        return Ok(Ok((camera, None)));
    }
    let of_file = photo.exif.filter(|_| given.is_none());
    let Some(pixel_mm) = camera.pixel_mm else {
        // Fewer pixels alone would leave a focal length in mm without the size of a pixel just so.
        let altered = of_file.and_then(ExifCamera::partial).filter(|caution| !matches!(caution, CameraCaution::Resized { .. }));
        let altered = altered.map(|camera_caution| NoOrientation::Altered { side, camera_caution: camera_caution.clone() });
        return Ok(Err(altered.unwrap_or(NoOrientation::NoPixelSize { side })));
    };
    let file_px = photo.exif.filter(|exif| given.is_some() && !exif.is_panorama()).and_then(|exif| Some(exif.focal_mm / exif.pixel_mm?));
    let part = of_file.and_then(|exif| doubt_of_part(side, exif));
    let doubt =
        || doubt_of(side, camera.focal_mm / pixel_mm, file_px, photo.longer_px()).or_else(|| doubt_of_rest(side, &camera, photo.size));
    Ok(Ok((camera, part.or_else(doubt))))
}

/// So many times as far from the principal point the correction takes a corner of the image: of lenses of usual cameras, and of those that take fiducial
/// marks with each photo, whose distortion is some hundredths of a mm.
const USUAL_AT_CORNER: [f64; 2] = [0.5, 2.0];
const USUAL_OF_FILM: [f64; 2] = [0.9, 1.1];

/// What speaks against the other constants of a photo, as those in other units do.
fn doubt_of_rest(side: Side, camera: &CameraMm, size: (usize, usize)) -> Option<Warning> {
    let interior = Interior::from_pixel_size(camera, size.0, size.1).ok()?;
    let of_principal = doubt_of_principal(side, interior.principal_point_px(), [size.0 as f64, size.1 as f64]);
    of_principal.or_else(|| doubt_of_corner(side, &interior, size, USUAL_AT_CORNER))
}

/// The same of a scan with its interior orientation by fiducial marks, which tell how large its pixels are on the film, and where the middle of the photo
/// lies: that of a part of the scan lies elsewhere.
pub(super) fn doubt_of_scan(side: Side, focal_mm: f64, interior: &Interior, size: (usize, usize), marks: &[Fiducial]) -> Option<Warning> {
    let of_focal = || doubt_of(side, focal_mm / interior.pixel_mm(), None, size.0.max(size.1));
    let of_principal = || {
        let range = |of: fn(&Fiducial) -> f64| {
            let ends = (f64::INFINITY, f64::NEG_INFINITY);
            marks.iter().map(of).fold(ends, |(least, most), at| (least.min(at), most.max(at)))
        };
        let ([x, y], (left, right), (low, high)) = (interior.principal_point_mm, range(|mark| mark.x_mm), range(|mark| mark.y_mm));
        doubt_of_principal(side, [x - left, y - low], [right - left, high - low])
    };
    of_focal().or_else(of_principal).or_else(|| doubt_of_corner(side, interior, size, USUAL_OF_FILM))
}

/// What is to be said of the pixel of a camera beside that of a scan by its fiducial marks, which counts.
pub(crate) fn unused_pixel(camera: &CameraMm, marks_mm: f64) -> Option<Warning> {
    let pixel_mm = camera.pixel_mm.filter(|pixel_mm| contradict(*pixel_mm, marks_mm))?;
    Some(Warning::UnusedPixel { pixel_mm, marks_mm })
}

/// `at`: from a corner of the photo, which has this `size` in the same unit.
fn doubt_of_principal(side: Side, at: [f64; 2], size: [f64; 2]) -> Option<Warning> {
    let sides = far_principal(at, size)?;
    Some(Warning::FarPrincipalPoint { side, sides, most: FARTHEST_PRINCIPAL })
}

fn doubt_of_corner(side: Side, interior: &Interior, (width, height): (usize, usize), [least, most]: [f64; 2]) -> Option<Warning> {
    let factor = interior.corner_factor(width, height);
    (!(least..=most).contains(&factor)).then_some(Warning::DoubtfulDistortion { side, factor, least, most })
}

/// What speaks against the camera of a photo whose file says that its image may be a part of it.
pub(super) fn doubt_of_part(side: Side, exif: &ExifCamera) -> Option<Warning> {
    match *exif.partial()? {
        CameraCaution::Resized { taken_width_px, taken_height_px, width_px, height_px } => {
            Some(Warning::ResizedOrCropped { side, taken_width_px, taken_height_px, width_px, height_px })
        }
        CameraCaution::Cropped { taken_width_px, taken_height_px, width_px, height_px } => {
            Some(Warning::Cropped { side, taken_width_px, taken_height_px, width_px, height_px })
        }
        CameraCaution::FocalPlane { pixel_um, expected_um } => Some(Warning::OtherPixels { side, pixel_um, expected_um }),
        _ => None,
    }
}

/// What speaks against the focal length of a photo: what its file says, or the longer side of its image.
fn doubt_of(side: Side, focal_px: f64, file_px: Option<f64>, longer_px: usize) -> Option<Warning> {
    if let Some(file_px) = file_px.filter(|file_px| contradict(focal_px, *file_px)) {
        return Some(Warning::ContradictedFocal { side, given_px: focal_px, file_px });
    }
    let [least, most] = USUAL_FOCAL;
    let sides = focal_px / longer_px as f64;
    (!(least..=most).contains(&sides)).then_some(Warning::DoubtfulFocal { side, sides, least, most })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::CameraOrigin;

    /// Marks in the corners of a photo of so many mm.
    fn corners(width: f64, height: f64) -> [Fiducial; 4] {
        let mark = |[x, y]: [f64; 2]| Fiducial { col: 0.0, row: 0.0, x_mm: 0.5 * width * x, y_mm: 0.5 * height * y };
        [[-1.0, -1.0], [1.0, 1.0], [-1.0, 1.0], [1.0, -1.0]].map(mark)
    }

    /// What speaks against a camera of this focal length in px, given for photos of 640 px whose right file says what it says.
    fn doubt(focal_px: f64, exif: Option<&ExifCamera>, has_marks: bool) -> Option<Warning> {
        let photo = |exif| KnownPhoto { size: (640, 480), exif, has_marks };
        let camera = CameraMm::without_distortion(0.01 * focal_px, Some(0.01));
        PairCameras::of(Some(&camera), [photo(None), photo(exif)]).unwrap().unwrap().doubt
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
    fn a_focal_length_alone_is_of_the_pixels_that_the_file_tells() {
        let file = ExifCamera { focal_mm: 6.0, pixel_mm: Some(0.01), origin: CameraOrigin::ExifFocalPlane, ..ExifCamera::default() };
        let photo = |exif| KnownPhoto { size: (640, 480), exif, has_marks: false };
        let of = |exif| PairCameras::of(Some(&CameraMm::without_distortion(6.1, None)), [photo(Some(&file)), photo(exif)]).unwrap();
        let both = of(Some(&file)).unwrap();
        assert_eq!((both.left.focal_mm, both.left.pixel_mm, both.right.pixel_mm, both.doubt), (6.1, Some(0.01), Some(0.01), None));
        assert_eq!(of(None).unwrap_err(), NoOrientation::NoPixelSize { side: Side::Right });
        // Of a part of a photo nobody knows whose pixels these are.
        let [taken_width_px, taken_height_px, width_px, height_px] = [4000, 3000, 640, 480];
        let cropped = CameraCaution::Cropped { taken_width_px, taken_height_px, width_px, height_px };
        let part = ExifCamera { pixel_mm: None, cautions: vec![cropped], ..file.clone() };
        assert!(of(Some(&part)).is_err());
    }

    #[test]
    fn a_focal_length_of_no_camera_is_doubted() {
        let doubtful = |sides| Some(Warning::DoubtfulFocal { side: Side::Left, sides, least: 0.3, most: 20.0 });
        assert_eq!((doubt(160.0, None, false), doubt(16_000.0, None, false)), (doubtful(0.25), doubtful(25.0)));
        assert_eq!((doubt(256.0, None, false), doubt(6400.0, None, false)), (None, None));
    }

    #[test]
    fn a_principal_point_far_from_the_middle_is_doubted_and_so_is_the_focal_length_of_a_scan_in_metres() {
        let camera = |principal_point_mm| CameraMm { principal_point_mm, ..CameraMm::without_distortion(6.0, Some(0.01)) };
        let photo = KnownPhoto { size: (640, 480), exif: None, has_marks: false };
        let doubt = |camera: &CameraMm| PairCameras::of(Some(camera), [photo; 2]).unwrap().unwrap().doubt;
        let scanned = |focal_mm, camera: &CameraMm| {
            doubt_of_scan(Side::Right, focal_mm, &Interior::from_pixel_size(camera, 640, 480).unwrap(), (640, 480), &corners(6.4, 4.8))
        };
        // In a part of the scan it lies outside, and where it is.
        let interior = Interior::from_pixel_size(&camera([0.0; 2]), 640, 480).unwrap();
        assert_eq!(doubt_of_scan(Side::Left, 6.0, &interior, (100, 80), &corners(6.4, 4.8)), None);
        let far = |side| Some(Warning::FarPrincipalPoint { side, sides: 0.625, most: 0.5 });
        assert_eq!((doubt(&camera([3.0, 0.0])), scanned(6.0, &camera([3.0, 0.0]))), (None, None));
        assert_eq!((doubt(&camera([4.0, 0.0])), scanned(6.0, &camera([4.0, 0.0]))), (far(Side::Left), far(Side::Right)));
        assert!(matches!(scanned(0.006, &camera([0.0; 2])), Some(Warning::DoubtfulFocal { side: Side::Right, .. })));
    }

    #[test]
    fn a_pixel_size_beside_fiducial_marks_that_give_another_is_named_with_both_and_no_weakness() {
        let camera = |pixel_mm| CameraMm::without_distortion(152.5, pixel_mm);
        let unused = unused_pixel(&camera(Some(0.014)), 0.127).unwrap();
        assert_eq!(unused, Warning::UnusedPixel { pixel_mm: 0.014, marks_mm: 0.127 });
        assert!(!unused.is_weakness());
        let words = crate::Texts::english().text(&unused);
        assert!(words.contains("0.0140 mm") && words.contains("0.127 mm"), "{words}");
        for agreeing in [None, Some(0.127), Some(0.125)] {
            assert_eq!(unused_pixel(&camera(agreeing), 0.127), None, "{agreeing:?}");
        }
    }

    #[test]
    fn a_distortion_in_other_units_is_doubted_or_refused() {
        use crate::{PhotoInput, photo_interior};
        // The corners are 4 mm from the principal point.
        let of = |radial_distortion| CameraMm { radial_distortion, ..CameraMm::without_distortion(6.0, Some(0.01)) };
        let photo = KnownPhoto { size: (640, 480), exif: None, has_marks: false };
        let doubt = |camera: &CameraMm| PairCameras::of(Some(camera), [photo; 2]).unwrap().unwrap().doubt;
        let refused = |camera: &CameraMm| photo_interior(camera, 640, 480, &PhotoInput::default()).err().map(|error| error.to_string());
        for usual in [[0.0; 3], [-0.015, 0.0, 0.0], [0.03, 0.0, 0.0], [-0.02, 0.001, 0.0]] {
            assert_eq!((doubt(&of(usual)), refused(&of(usual))), (None, None), "{usual:?}");
        }
        let far = doubt(&of([0.1, 0.0, 0.0]));
        assert!(
            matches!(far, Some(Warning::DoubtfulDistortion { side: Side::Left, factor, .. }) if (factor - 2.6).abs() < 1e-12),
            "{far:?}"
        );
        // A scan of 80 mm is of a camera whose distortion is far smaller.
        let of_film = |k1: f64| {
            let camera = CameraMm { radial_distortion: [k1, 0.0, 0.0], ..CameraMm::without_distortion(100.0, Some(0.1)) };
            doubt_of_scan(Side::Right, 100.0, &Interior::from_pixel_size(&camera, 640, 480).unwrap(), (640, 480), &corners(64.0, 48.0))
        };
        assert_eq!(of_film(2e-8), None);
        assert!(
            matches!(of_film(1e-4), Some(Warning::DoubtfulDistortion { side: Side::Right, factor, .. }) if (factor - 1.16).abs() < 1e-12)
        );
        // 3 k1 r² = -1 within the image, or in the middle alone.
        for folds in [[-0.05, 0.0, 0.0], [-0.4, 0.05, 0.0]] {
            let told = refused(&of(folds)).unwrap();
            assert!(told.starts_with("camera.radial_distortion is [") && told.contains("mm⁻²") && told.contains("4.00 mm"), "{told}");
        }
    }
}
