//! Scans of film as a block takes them.

use super::{FilmInput, FilmScan};
use crate::error::refuse;
use crate::{Bands, CameraRule, Error, GreyImage, Interior, Refusal, orient_fiducials};

/// The scan of a photo on film, resampled to the image of an ideal camera.
#[derive(Debug, Clone, PartialEq)]
pub struct FilmFrame {
    /// How the scan lies to it.
    pub scan: FilmScan,
    pub image: Bands,
    /// 0 where the frame shows a mark, its surroundings, or nothing of the scan; else 255.
    pub mask: GreyImage,
}

/// Resamples a scan to its frame, which is the same for all scans of a film whose marks and pixel are the same: a block of such frames has one camera,
/// without distortion. `pixel_mm`: the side of its pixels, as [`film_pixel_mm`] has that of a scan.
///
/// # Errors
/// As [`FilmScan::in_common`].
pub fn film_frame(scan: &Bands, film: &FilmInput, pixel_mm: f64) -> Result<FilmFrame, Error> {
    let own = FilmScan::in_common(film, [scan.width(), scan.height()], pixel_mm)?;
    let (image, mask) = (own.frame(&scan.views())?, own.mask(&film.film_marks())?);
    Ok(FilmFrame { scan: own, image, mask })
}

/// The side of a pixel of a scan, as its marks have it, to 0.01 µm.
///
/// # Errors
/// As [`orient_fiducials`] and [`Interior::from_fiducials`]; [`Error::InvalidInput`] without a camera.
pub fn film_pixel_mm(film: &FilmInput) -> Result<f64, Error> {
    let Some(camera) = &film.camera else { return refuse(Refusal::FilmWithoutCamera) };
    let interior = Interior::from_fiducials(camera, &orient_fiducials(&film.scan.fiducials, film.scan.model)?, [0.0; 2])?;
    Ok((interior.pixel_mm() * STEPS_PER_MM).round() / STEPS_PER_MM)
}

const STEPS_PER_MM: f64 = 1e5;

impl FilmFrame {
    /// Its camera as a file of cameras has it, for the images whose names fit: as it is, unless the camera of the film says what is not known of it.
    pub fn rule(&self, images: &str) -> CameraRule {
        let camera = self.scan.camera();
        CameraRule {
            images: images.into(),
            focal_px: camera.focal_px,
            principal_point_px: Some(camera.principal_point_px.map(|v| (v * ROUNDING).round() / ROUNDING)),
            radial: camera.radial,
            tangential: camera.tangential,
            pixel_mm: camera.pixel_mm,
            fixed: self.scan.interior.uncertainty.is_none(),
            uncertainty: self.scan.interior.uncertainty,
        }
    }
}

/// Principal points of frames are whole pixels, but for the last bits of their computation.
const ROUNDING: f64 = 1e6;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::formats::parse_camera_rules;
    use crate::{CameraMm, Fiducial, PhotoInput};

    /// 4 px a mm, turned by a right angle: x of the film is down, y to the right.
    fn scanned(uncertainty: Option<crate::CameraUncertainty>) -> (Bands, FilmInput) {
        let marks = [[-100.0, -100.0], [100.0, -100.0], [100.0, 100.0], [-100.0, 100.0], [0.0, 0.0]];
        let fiducials = marks.map(|[x_mm, y_mm]| Fiducial { col: 420.0 + 4.0 * y_mm, row: 430.0 + 4.0 * x_mm, x_mm, y_mm });
        let camera = CameraMm { principal_point_mm: [0.25, 0.0], uncertainty, ..CameraMm::without_distortion(150.0, None) };
        let film = FilmInput {
            camera: Some(camera),
            scan: PhotoInput { fiducials: fiducials.to_vec(), ..PhotoInput::default() },
            marks_mm: Vec::new(),
        };
        // Brighter along x of the film.
        let band = |factor: usize| GreyImage::from_fn(840, 860, move |_, row| (row / 4 * factor / 2) as u8).unwrap();
        (Bands::colours([band(2), band(1), band(1)]).unwrap(), film)
    }

    #[test]
    fn a_scan_becomes_an_image_of_an_ideal_camera_with_a_mask_of_its_marks() {
        let (scan, film) = scanned(None);
        let frame = film_frame(&scan, &film, film_pixel_mm(&film).unwrap()).unwrap();
        let rule = frame.rule("*");
        assert_eq!((rule.focal_px, rule.pixel_mm, rule.fixed, rule.radial), (600.0, Some(0.25), true, [0.0; 3]));
        // 2.5 mm within the marks on every side: 195 mm; the principal point is 0.25 mm right of the middle.
        assert_eq!([frame.image.width(), frame.image.height()], [780, 780]);
        assert_eq!(rule.principal_point_px, Some([391.0, 390.0]));
        let [red, green, blue] = frame.image.images() else { panic!("three bands") };
        let at = |band: &GreyImage, x_mm: f64| f64::from(band.view().at((391.0 + (x_mm - 0.25) / 0.25) as usize, 200));
        for x_mm in [-90.0, -10.0, 60.0] {
            let row = 430.0 + 4.0 * x_mm;
            assert!((at(red, x_mm) - row / 4.0).abs() < 2.0 && (at(green, x_mm) - row / 8.0).abs() < 2.0, "{x_mm}: {}", at(red, x_mm));
        }
        assert_eq!(green, blue);
        // The mark in the middle is 1 px left of the principal point.
        let mask = frame.mask.view();
        assert_eq!([mask.at(390, 390), mask.at(396, 390), mask.at(403, 390), mask.at(100, 100)], [0, 0, 255, 255]);
        let text = format!(r#"{{"cameras": [{}]}}"#, serde_json::to_string(&rule).unwrap());
        assert_eq!(parse_camera_rules(&text).unwrap(), [rule]);
    }

    #[test]
    fn frames_of_a_camera_that_is_not_sure_are_calibrated_and_all_have_the_pixel_that_is_asked_for() {
        let (scan, film) = scanned(Some(crate::CameraUncertainty::GIVEN));
        let frame = film_frame(&scan, &film, 0.5).unwrap();
        let rule = frame.rule("*");
        let known = rule.known(389, 390);
        assert_eq!((rule.focal_px, rule.pixel_mm, rule.fixed), (300.0, Some(0.5), false));
        assert_eq!((known.uncertainty, known.free), (Some(crate::CameraUncertainty::GIVEN), crate::FreeParameters::USUAL));
        assert_eq!([frame.image.width(), frame.image.height()], [389, 390]);
    }
}
