//! The camera of a file: of what EXIF, XMP and the table of sensors say, the most certain.

use super::fields::{Directory, Fields, Tag};
use crate::camera::distortion::fitted_terms;
use crate::camera::origin::{CameraCaution, CameraOrigin};
use crate::camera::px::Camera;
use crate::camera::same::{MOST_CONTRADICTION, is_near};
use crate::camera::sensors::{NOMINAL_PIXEL_MM, sensor_mm};
use crate::camera::xmp::{DjiLens, Pix4dLens, Projection, Xmp};
use crate::{CameraUncertainty, Location};
use serde::{Deserialize, Serialize};
use std::f64::consts::{FRAC_2_PI, PI, SQRT_2};

const MAKE: Tag = (Directory::Main, 0x010f);
const MODEL: Tag = (Directory::Main, 0x0110);
const FOCAL_LENGTH: Tag = (Directory::Exif, 0x920a);
const PIXEL_X_DIMENSION: Tag = (Directory::Exif, 0xa002);
const PIXEL_Y_DIMENSION: Tag = (Directory::Exif, 0xa003);
const FOCAL_PLANE_X_RESOLUTION: Tag = (Directory::Exif, 0xa20e);
const FOCAL_PLANE_RESOLUTION_UNIT: Tag = (Directory::Exif, 0xa210);
const FOCAL_LENGTH_IN_35_MM_FILM: Tag = (Directory::Exif, 0xa405);

/// The camera that a file names, by EXIF, XMP and the table of sensors.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ExifCamera {
    pub make: Option<String>,
    pub model: Option<String>,
    /// Focal length in mm.
    pub focal_mm: f64,
    /// Side of a pixel of the stored image in mm; absent where nothing tells it. The focal length in px is `focal_mm / pixel_mm`.
    pub pixel_mm: Option<f64>,
    /// Where the focal length in px comes from.
    #[serde(default)]
    pub origin: CameraOrigin,
    /// What XMP says of the lens, in px of the stored image; absent where that is no more than a focal length.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lens: Option<Box<Camera>>,
    /// What speaks against it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub cautions: Vec<CameraCaution>,
}

/// Pixels of the focal plane by those of the 35 mm equivalent: a square of a 3:2 frame has 0.78, and a photo of half the size 0.5.
const CROPPED: std::ops::RangeInclusive<f64> = 0.65..=1.2;
/// Formats that differ by less, as a share, are the same after rounding to whole px, or to whole blocks of 16 px.
const SAME_FORMAT: f64 = 0.01;
/// Taken sides this many times as long as the stored ones say that a photo was resized or cropped: by less its camera hardly changes.
const FEWER: f64 = 1.02;
/// A calibration is of images as large as its designed principal point says, where that is no more than this off another known size.
const SAME_SIZE: f64 = 0.05;
/// Rays by which a fisheye's distortion is described in the terms of Brown.
const RAYS: usize = 128;

impl ExifCamera {
    /// What the camera is called in a photograph of this size: that of another focal length or size is another camera.
    #[must_use]
    pub fn label(&self, size: [u32; 2]) -> String {
        let focal_mm = (!self.is_panorama()).then_some(self.focal_mm);
        super::camera_label(self.make.as_deref(), self.model.as_deref(), focal_mm, size)
    }

    /// What the file's EXIF and XMP say of its camera: a calibration by XMP goes before the focal plane or the 35 mm equivalent of EXIF, these
    /// before the table of sensors. Absent where no focal length is known.
    pub(super) fn of(exif: Option<&Fields<&[u8]>>, xmp: &Xmp, size: [u64; 2]) -> Option<Self> {
        let text = |tag| exif.and_then(|exif| exif.text(tag));
        let named = Self { make: text(MAKE), model: text(MODEL), ..Self::default() };
        if let Some((projection, circle_px)) = &xmp.panorama {
            return Some(named.of_panorama(projection, circle_px.unwrap_or(size[0] as f64)));
        }
        let taken = exif.and_then(taken_size);
        let caution = taken.and_then(|taken| size_caution(taken, size));
        let focal_mm = exif.and_then(|exif| exif.positive(FOCAL_LENGTH));
        if matches!(caution, Some(CameraCaution::Cropped { .. })) {
            let origin = CameraOrigin::FocalLengthAlone;
            return Some(Self { focal_mm: focal_mm?, origin, cautions: caution.into_iter().collect(), ..named });
        }
        // What is known of a pixel without the focal length, and by it.
        let measured = exif.and_then(|exif| focal_plane_pixel_mm(exif, taken, size)).map(|pixel| (pixel, CameraOrigin::ExifFocalPlane));
        let listed = || Some((listed_pixel_mm(&named, size)?, CameraOrigin::SensorTable));
        let equivalent = || Some((equivalent_pixel_mm(exif?, focal_mm?, size)?, CameraOrigin::Exif35Mm));
        let mut cautions: Vec<CameraCaution> = caution.into_iter().collect();
        let in_doubt = measured.and_then(|own| Some((own, focal_plane_doubt(own.0, listed(), equivalent())?)));
        cautions.extend(in_doubt.map(|((own, _), (other, _))| CameraCaution::FocalPlane { pixel_um: 1e3 * own, expected_um: 1e3 * other }));
        let measured = measured.filter(|_| in_doubt.is_none());
        let by_exif = if in_doubt.is_some() { None } else { measured.or_else(equivalent).or_else(listed) };
        let exif_focal_px = focal_mm.zip(by_exif).map(|(focal, (pixel, _))| focal / pixel);
        let pitch = measured.or_else(listed).or_else(equivalent).map(|(pixel, _)| pixel);
        if let Some((lens, origin)) = xmp_lens(xmp, taken, size, pitch) {
            match exif_focal_px.filter(|focal| contradict(lens.focal_px, *focal)) {
                Some(exif_focal_px) => cautions.push(CameraCaution::Contradiction { xmp_focal_px: lens.focal_px, exif_focal_px }),
                None => {
                    // The pixel's side is a fact where it was measured or is listed; else it follows from the focal length.
                    let known = measured.or_else(listed).map(|(pixel, _)| pixel);
                    let pixel = known.or(focal_mm.and_then(|focal| plausible(focal / lens.focal_px))).unwrap_or(NOMINAL_PIXEL_MM);
                    let lens = Camera { pixel_mm: Some(pixel), ..lens };
                    return Some(Self {
                        focal_mm: lens.focal_px * pixel,
                        pixel_mm: Some(pixel),
                        origin,
                        lens: Some(Box::new(lens)),
                        cautions,
                        ..named
                    });
                }
            }
        }
        let origin = by_exif.map_or(CameraOrigin::FocalLengthAlone, |(_, origin)| origin);
        Some(Self { focal_mm: focal_mm?, pixel_mm: by_exif.map(|(pixel, _)| pixel), origin, cautions, ..named })
    }

    /// What is not known of it.
    pub(crate) fn uncertainty(&self) -> CameraUncertainty {
        let known = CameraUncertainty::of(self.origin);
        match (self.partial(), self.pixel_mm) {
            (Some(CameraCaution::Resized { taken_width_px, taken_height_px, width_px, height_px }), Some(pixel_mm)) => {
                let part = Part::of_format([*taken_width_px, *taken_height_px], [*width_px, *height_px]);
                // Resized, as is assumed, or cropped: either is as likely.
                known.of_part(libm::log(part.times) / SQRT_2, part.reach_px / (self.focal_mm / pixel_mm))
            }
            _ => known,
        }
    }

    /// The caution that says that the image of a file may be a part of a photo: one that has fewer pixels than it was taken with, or others. A calibration
    /// goes before the pixels of EXIF.
    pub(crate) fn partial(&self) -> Option<&CameraCaution> {
        self.cautions.iter().find(|caution| match **caution {
            CameraCaution::Resized { taken_width_px, taken_height_px, width_px, height_px } => {
                f64::from(taken_width_px.max(taken_height_px)) > FEWER * f64::from(width_px.max(height_px))
            }
            CameraCaution::Cropped { .. } | CameraCaution::FocalPlane { .. } => self.pixel_mm.is_none(),
            CameraCaution::Contradiction { .. } | CameraCaution::Panorama { .. } => false,
        })
    }

    /// What the image of a file, of this size in px, is at the least of its photo, where it may be a part of it.
    pub(crate) fn part(&self, (width, height): (usize, usize)) -> Option<Part> {
        match *self.partial()? {
            CameraCaution::Resized { taken_width_px, taken_height_px, width_px, height_px } => {
                Some(Part::of_format([taken_width_px, taken_height_px], [width_px, height_px]))
            }
            CameraCaution::Cropped { taken_width_px, taken_height_px, width_px, height_px } => {
                Some(Part::of_any([taken_width_px, taken_height_px], [width_px, height_px]))
            }
            // A photo as large as its sensor would be at the pixels that EXIF has.
            CameraCaution::FocalPlane { pixel_um, expected_um } => {
                let stored = [width, height].map(|v| v as f64);
                Some(Part::of(stored.map(|v| v * expected_um / pixel_um), stored))
            }
            CameraCaution::Contradiction { .. } | CameraCaution::Panorama { .. } => None,
        }
    }

    /// Whether a photo of this camera at this focal length has the same lens as another: also where one of them was turned or resized.
    pub(crate) fn is_of_one_lens(&self, other: &Self) -> bool {
        let lens = |own: &Self| own.lens.as_ref().map(|lens| (lens.radial, lens.tangential));
        self.model.is_some()
            && (&self.make, &self.model, self.origin) == (&other.make, &other.model, other.origin)
            && is_near(self.focal_mm, other.focal_mm, self.focal_mm)
            && lens(self) == lens(other)
    }

    /// Whether it is no photograph of a central perspective.
    pub fn is_panorama(&self) -> bool {
        self.origin == CameraOrigin::Panorama
    }

    /// Of a panorama: px a radian at its middle.
    fn of_panorama(self, projection: &str, circle_px: f64) -> Self {
        let focal_mm = circle_px.clamp(1.0, 1e7) / (2.0 * PI) * NOMINAL_PIXEL_MM;
        let cautions = vec![CameraCaution::Panorama { projection: projection.to_owned() }];
        Self { focal_mm, pixel_mm: Some(NOMINAL_PIXEL_MM), origin: CameraOrigin::Panorama, cautions, ..self }
    }
}

/// What an image is of its photo if it was cut out of it. If it was also resized, it shows more of the photo.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Part {
    /// How many times as long the longer side of the photo is, 1 or more.
    pub times: f64,
    /// How far the middle of the photo may lie from that of the image along an axis, px.
    pub reach_px: f64,
}

impl Part {
    fn of(taken: [f64; 2], stored: [f64; 2]) -> Self {
        let reach_px = (0..2).map(|k| 0.5 * (taken[k] - stored[k])).fold(0.0, f64::max);
        Self { times: (sides(taken)[0] / sides(stored)[0]).max(1.0), reach_px }
    }

    /// Of a photo of the same format, which may have been turned.
    fn of_format(taken: [u32; 2], stored: [u32; 2]) -> Self {
        Self::of(sides(taken.map(f64::from)), sides(stored.map(f64::from)))
    }

    /// Of a photo of another format. A photo that was turned upright may keep the size that it was taken with: of both ways in which the image fits into
    /// it the one that leaves more open.
    fn of_any(taken: [u32; 2], stored: [u32; 2]) -> Self {
        let [taken, stored] = [taken, stored].map(|size| size.map(f64::from));
        let ways = [taken, [taken[1], taken[0]]];
        let fits = |way: &&[f64; 2]| (0..2).all(|k| stored[k] <= way[k]);
        let parts = ways.iter().filter(fits).map(|way| Self::of(*way, stored));
        parts.max_by(|a, b| a.reach_px.total_cmp(&b.reach_px)).unwrap_or_else(|| Self::of(sides(taken), sides(stored)))
    }
}

/// Whether two values for the same are too far apart.
fn contradict(own: f64, other: f64) -> bool {
    (own / other - 1.0).abs() > MOST_CONTRADICTION
}

/// What the pixel should be by the sensor, or without it by the 35 mm equivalent, where the focal plane is of a photo of another size. A photo that
/// the camera crops may keep the equivalent of the whole frame.
fn focal_plane_doubt(
    own: f64,
    listed: Option<(f64, CameraOrigin)>,
    equivalent: Option<(f64, CameraOrigin)>,
) -> Option<(f64, CameraOrigin)> {
    match (listed, equivalent) {
        (Some(listed), _) => Some(listed).filter(|(pixel, _)| contradict(own, *pixel)),
        (None, Some(equivalent)) => Some(equivalent).filter(|(pixel, _)| !CROPPED.contains(&(own / pixel))),
        (None, None) => None,
    }
}

/// The size in px that the photo was taken with.
fn taken_size(exif: &Fields<&[u8]>) -> Option<[f64; 2]> {
    Some([exif.positive(PIXEL_X_DIMENSION)?, exif.positive(PIXEL_Y_DIMENSION)?])
}

/// Longer and shorter side: software that turns an image upright may leave the EXIF as it was.
fn sides([width, height]: [f64; 2]) -> [f64; 2] {
    [width.max(height), width.min(height)]
}

/// What it means that a photo has another size than it was taken with.
fn size_caution(taken: [f64; 2], size: [u64; 2]) -> Option<CameraCaution> {
    let stored = size.map(|v| v as f64);
    if sides(taken) == sides(stored) {
        return None;
    }
    let [[taken_width_px, taken_height_px], [width_px, height_px]] = [taken, stored].map(|size| size.map(|v| v as u32));
    let format = |size| sides(size)[0] / sides(size)[1];
    Some(match (format(taken) / format(stored) - 1.0).abs() <= SAME_FORMAT {
        true => CameraCaution::Resized { taken_width_px, taken_height_px, width_px, height_px },
        false => CameraCaution::Cropped { taken_width_px, taken_height_px, width_px, height_px },
    })
}

/// Pixel side from the focal-plane resolution, which counts pixels of the image as the camera took it.
fn focal_plane_pixel_mm(exif: &Fields<&[u8]>, taken: Option<[f64; 2]>, size: [u64; 2]) -> Option<f64> {
    let unit_mm = match exif.number(FOCAL_PLANE_RESOLUTION_UNIT).map_or(2, |unit| unit as u32) {
        2 => 25.4,
        3 => 10.0,
        4 => 1.0,
        5 => 0.001,
        _ => return None,
    };
    let taken_pixel_mm = unit_mm / exif.positive(FOCAL_PLANE_X_RESOLUTION)?;
    let taken_side = taken.map(|taken| sides(taken)[0]).or_else(|| exif.positive(PIXEL_X_DIMENSION));
    plausible(taken_pixel_mm * taken_side.map_or(1.0, |taken| taken / sides(size.map(|v| v as f64))[0]))
}

/// Diagonal of the 36 mm x 24 mm frame to which the 35 mm equivalent of a focal length refers.
const FRAME_DIAGONAL_MM: f64 = 43.266_615_305_567_87;

/// Pixel side from the focal length that has the same angle of view on the 35 mm frame, diagonal to diagonal.
fn equivalent_pixel_mm(exif: &Fields<&[u8]>, focal_mm: f64, [width, height]: [u64; 2]) -> Option<f64> {
    let equivalent_mm = exif.positive(FOCAL_LENGTH_IN_35_MM_FILM)?;
    let diagonal_px = (width as f64 * width as f64 + height as f64 * height as f64).sqrt();
    plausible(focal_mm / equivalent_mm * FRAME_DIAGONAL_MM / diagonal_px)
}

/// Pixel side from the size of the sensor: a photo of another format than the sensor's uses all of one of its sides.
fn listed_pixel_mm(camera: &ExifCamera, size: [u64; 2]) -> Option<f64> {
    let sensor = sides(sensor_mm(camera.make.as_deref()?, camera.model.as_deref()?)?);
    let [longer, shorter] = sides(size.map(|v| v as f64));
    plausible((sensor[0] / longer).min(sensor[1] / shorter))
}

/// A pixel side between 0.1 µm and 1 mm: anything else is a damaged field, not a camera.
fn plausible(pixel_mm: f64) -> Option<f64> {
    (1e-4..=1.0).contains(&pixel_mm).then_some(pixel_mm)
}

/// The lens that XMP describes, in px of the stored image; absent where it is none.
fn xmp_lens(xmp: &Xmp, taken: Option<[f64; 2]>, size: [u64; 2], pixel_mm: Option<f64>) -> Option<(Camera, CameraOrigin)> {
    let of_pix4d = || pix4d_camera(xmp.pix4d_lens.as_ref()?, taken, size, pixel_mm);
    let of_dji = || Some(dji_camera(xmp.dji_lens.as_ref()?, taken, size));
    // A lens whose distortion folds the image is a damaged field.
    of_pix4d().or_else(of_dji).filter(|(camera, _)| camera.check(|| Location::CameraOfImage).is_ok() && camera.photo_camera().is_ok())
}

fn dji_camera(lens: &DjiLens, taken: Option<[f64; 2]>, size: [u64; 2]) -> (Camera, CameraOrigin) {
    let stored = size.map(|v| v as f64);
    let known = taken.unwrap_or(stored);
    // Software that resizes a photo adapts its EXIF, and leaves its XMP: the designed principal point is the middle of the photo as taken.
    let designed = lens.principal_point_px.map(|centre| centre.map(|v| 2.0 * v)).filter(|size| size.iter().all(|v| *v > 0.0));
    let calibrated_side = match designed.map(|size| sides(size)[0]) {
        Some(side) if (side / sides(known)[0] - 1.0).abs() > SAME_SIZE => side,
        _ => sides(known)[0],
    };
    let scale = sides(stored)[0] / calibrated_side;
    let plain = Camera::without_distortion(size[0] as u32, size[1] as u32, lens.focal_px * scale);
    let [x, y] = plain.principal_point_px;
    let is_turned = (known[0] > known[1]) != (stored[0] > stored[1]);
    match lens.calibrated {
        None => (plain, CameraOrigin::XmpDesign),
        Some(_) if lens.is_dewarped => (plain, CameraOrigin::XmpDewarped),
        // Whether to the left or to the right is not known.
        Some(data) if is_turned => (Camera { radial: data.radial, ..plain }, CameraOrigin::XmpCalibration),
        Some(data) => {
            let principal_point_px = [x + data.offset_px[0] * scale, y + data.offset_px[1] * scale];
            let camera = Camera { principal_point_px, radial: data.radial, tangential: data.tangential, ..plain };
            (camera, CameraOrigin::XmpCalibration)
        }
    }
}

fn pix4d_camera(lens: &Pix4dLens, taken: Option<[f64; 2]>, size: [u64; 2], pixel_mm: Option<f64>) -> Option<(Camera, CameraOrigin)> {
    let stored = size.map(|v| v as f64);
    let (width, height) = (size[0] as u32, size[1] as u32);
    let camera = match lens.projection {
        Projection::Perspective { focal_mm, radial, tangential } => {
            Camera { radial, tangential, ..Camera::without_distortion(width, height, focal_mm / pixel_mm?) }
        }
        Projection::Fisheye { scale_px, polynomial } => {
            let scale_px = scale_px * taken.map_or(1.0, |taken| sides(stored)[0] / sides(taken)[0]);
            let plain = Camera::without_distortion(width, height, scale_px * FRAC_2_PI);
            Camera { radial: fisheye_radial(scale_px, polynomial, &plain), ..plain }
        }
    };
    let principal_point_px = lens.principal_point_mm.zip(pixel_mm).map(|(point, pixel)| point.map(|v| v / pixel));
    // A principal point in the outer parts of the photo is that of a turned one, or of another unit.
    let is_central = |point: &[f64; 2]| (0..2).all(|k| (point[k] / stored[k] - 0.5).abs() < 0.1);
    let principal_point_px = principal_point_px.filter(is_central).unwrap_or(camera.principal_point_px);
    Some((Camera { principal_point_px, ..camera }, CameraOrigin::XmpCalibration))
}

/// The radial terms of Brown that come nearest to a fisheye over the image.
fn fisheye_radial(scale_px: f64, [p2, p3]: [f64; 2], camera: &Camera) -> [f64; 3] {
    let focal_px = camera.focal_px;
    let seen = |angle: f64| {
        let theta = angle * FRAC_2_PI;
        scale_px * theta * (1.0 + theta * (p2 + theta * p3)) / focal_px
    };
    let corner =
        0.5 * (f64::from(camera.width_px) * f64::from(camera.width_px) + f64::from(camera.height_px) * f64::from(camera.height_px)).sqrt();
    // The angle that is seen in the corner, short of a quarter circle, by halves: the distance grows with the angle.
    let (mut inside, mut outside) = (0.0, 0.49 * PI);
    for _ in 0..60 {
        let middle = 0.5 * (inside + outside);
        if seen(middle) * focal_px < corner { inside = middle } else { outside = middle }
    }
    let rays = (1..=RAYS).map(|k| {
        let angle = inside * k as f64 / RAYS as f64;
        (libm::tan(angle), seen(angle))
    });
    fitted_terms(rays, libm::tan(inside))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn part(caution: CameraCaution, pixel_mm: Option<f64>) -> Option<(f64, f64)> {
        let camera = ExifCamera { pixel_mm, cautions: vec![caution], ..ExifCamera::default() };
        camera.part((1000, 900)).map(|part| (part.times, part.reach_px))
    }

    #[test]
    fn a_part_of_a_turned_photo_leaves_open_what_either_way_does() {
        let cropped = |[taken_width_px, taken_height_px]: [u32; 2], [width_px, height_px]: [u32; 2]| {
            part(CameraCaution::Cropped { taken_width_px, taken_height_px, width_px, height_px }, None).unwrap()
        };
        assert_eq!(cropped([4000, 3000], [1000, 900]), (4.0, 1550.0));
        // Higher than the photo was taken: it was turned. Of one that fits both ways the worse counts.
        assert_eq!(cropped([4000, 3000], [1000, 3500]), (4000.0 / 3500.0, 1000.0));
        assert_eq!(cropped([4000, 3000], [2900, 2000]), (4000.0 / 2900.0, 1000.0));
        // Enlarged.
        assert_eq!(cropped([400, 300], [1000, 900]), (1.0, 0.0));
        // Turned and halved, the format is the same: sides belong to each other.
        let resized = CameraCaution::Resized { taken_width_px: 4000, taken_height_px: 3000, width_px: 1500, height_px: 2000 };
        assert_eq!(part(resized, Some(0.001)), Some((2.0, 1000.0)));
    }

    #[test]
    fn a_calibration_goes_before_the_pixels_of_exif() {
        let other_pixels = CameraCaution::FocalPlane { pixel_um: 2.0, expected_um: 4.0 };
        assert_eq!(part(other_pixels.clone(), None), Some((2.0, 500.0)));
        assert_eq!(part(other_pixels, Some(0.001)), None);
    }
}
