//! Scans of film as a block takes them.

use super::scan_file::SCAN_LIMITS;
use super::{FilmInput, FilmScan};
use crate::error::refuse;
use crate::pair::unused_pixel;
use crate::pipeline::decode_mask;
use crate::{Bands, CameraRule, CameraUncertainty, Error, ExifImage, GreyImage, Interior, Refusal, Warning, orient_fiducials, write_bands};

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

/// What is to be said of the camera of a scan: that the side of a pixel that it gives is not used.
///
/// # Errors
/// As [`film_pixel_mm`].
pub fn film_warning(film: &FilmInput) -> Result<Option<Warning>, Error> {
    let marks_mm = film_pixel_mm(film)?;
    Ok(film.camera.as_ref().and_then(|camera| unused_pixel(camera, marks_mm)))
}

impl FilmFrame {
    /// Leaves out of its mask what a mask of the scan leaves out, where that is 0. `name` and `file` are those of an image as large as the scan.
    ///
    /// # Errors
    /// [`Error::UnreadableImage`] and [`Error::InvalidInput`], naming the mask, for one that cannot be decoded and for one of another size.
    pub fn hide(&mut self, name: &str, file: &[u8]) -> Result<(), Error> {
        let mask = decode_mask(name, file, [self.scan.width_px as usize, self.scan.height_px as usize], &SCAN_LIMITS)?;
        self.mask = self.scan.masked(&self.mask, mask.view())?;
        Ok(())
    }

    /// The image as a PNG file, with the place that the metadata of the scan record: camera and orientation in them are those of a scanner.
    ///
    /// # Panics
    /// As [`write_bands`].
    pub fn image_file(&self, of_scan: &ExifImage) -> Vec<u8> {
        let place = of_scan.position.map(|position| ExifImage { position: Some(position), ..ExifImage::default() });
        write_bands(&self.image, place.as_ref())
    }

    /// Its camera as a file of cameras has it, for the images whose names fit: as it is where nothing speaks against that, else to be calibrated within what
    /// the camera of the film and the errors of the marks leave open.
    pub fn rule(&self, images: &str) -> CameraRule {
        let camera = self.scan.camera();
        let uncertainty = Some(self.scan.uncertainty().without_traces()).filter(|own| *own != CameraUncertainty::NONE);
        CameraRule {
            images: images.into(),
            focal_px: camera.focal_px,
            principal_point_px: Some(camera.principal_point_px.map(|v| (v * ROUNDING).round() / ROUNDING)),
            radial: camera.radial,
            tangential: camera.tangential,
            pixel_mm: camera.pixel_mm,
            fixed: uncertainty.is_none(),
            uncertainty,
        }
    }
}

/// Principal points of frames are whole pixels, but for the last bits of their computation.
const ROUNDING: f64 = 1e6;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::film::decode_scan;
    use crate::formats::parse_camera_rules;
    use crate::{CameraMm, Fiducial, PhotoInput, write_png};

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
    fn errors_of_the_marks_are_not_known_of_the_camera() {
        let (scan, mut film) = scanned(None);
        // 0.2 px of an mm of 4 px, to and fro: 0.05 mm.
        film.scan.fiducials.iter_mut().zip([0.2, -0.2, 0.2, -0.2, 0.0]).for_each(|(mark, off)| mark.col += off);
        let frame = film_frame(&scan, &film, 0.25).unwrap();
        let (rule, own) = (frame.rule("*"), frame.scan.uncertainty());
        assert_eq!((rule.fixed, rule.uncertainty), (false, Some(own)));
        // Five marks of 100 mm about the middle: σ of a coordinate / √5, and of the scale σ / 200 mm.
        let sigma_mm = frame.scan.marks.sigma0_mm.unwrap();
        assert!((sigma_mm - 0.05).abs() < 1e-4, "{sigma_mm}");
        assert!((own.principal_point * 150.0 / (sigma_mm / 5.0_f64.sqrt()) - 1.0).abs() < 1e-3, "{own:?}");
        assert!((own.focal / (sigma_mm / 200.0 / 2.0_f64.sqrt()) - 1.0).abs() < 1e-3 && own.k1 == 0.0, "{own:?}");
        let known = rule.known(780, 780);
        assert_eq!(known.known_within(), own);
    }

    #[test]
    fn a_mask_of_the_scan_hides_the_same_in_its_frame() {
        let (scan, film) = scanned(None);
        let mut frame = film_frame(&scan, &film, 0.25).unwrap();
        let before = frame.mask.clone();
        // A rectangle, in px of the scan.
        let mask =
            GreyImage::from_fn(840, 860, |column, row| u8::from(!((300..500).contains(&column) && (200..250).contains(&row)))).unwrap();
        frame.hide("scan_mask.png", &write_png(mask.view(), None)).unwrap();
        let hidden = |at: [usize; 2]| {
            let [column, row] = frame.scan.in_scan(at.map(|v| v as f64 + 0.5)).unwrap();
            (300.0..500.0).contains(&column) && (200.0..250.0).contains(&row)
        };
        let (mut seen, mut other) = (0, 0);
        for (column, row) in (0..780).flat_map(|column| (0..780).map(move |row| (column, row))) {
            let wanted = if hidden([column, row]) { 0 } else { before.view().at(column, row) };
            other += usize::from(frame.mask.view().at(column, row) != wanted);
            seen += usize::from(wanted != before.view().at(column, row));
        }
        assert!(other == 0 && (9_500..10_500).contains(&seen), "{other} {seen}");
        let small = GreyImage::from_fn(84, 86, |_, _| 0).unwrap();
        let refused = frame.hide("scan_mask.png", &write_png(small.view(), None)).unwrap_err().to_string();
        assert!(refused.contains("scan_mask.png") && refused.contains("840 x 860"), "{refused}");
        assert!(frame.hide("scan_mask.png", b"none").unwrap_err().to_string().contains("scan_mask.png"));
    }

    #[test]
    fn the_place_of_a_scan_is_that_of_its_frame_and_no_scanner_its_camera() {
        let (scan, film) = scanned(None);
        let frame = film_frame(&scan, &film, 0.25).unwrap();
        let position = crate::ExifPosition { longitude_deg: 8.25, latitude_deg: -50.5, height_m: Some(1840.5), error_m: Some(12.0) };
        let camera = crate::ExifCamera { focal_mm: 28.0, ..Default::default() };
        let of_scan = ExifImage {
            make: Some("Scanner".into()),
            camera: Some(camera),
            orientation: Some(6),
            position: Some(position),
            ..ExifImage::default()
        };
        let read = |file: &[u8]| ExifImage::read(file, 780, 780);
        let wanted = ExifImage { orientation: Some(1), position: Some(position), ..ExifImage::default() };
        assert_eq!(read(&frame.image_file(&of_scan)), wanted);
        assert_eq!(read(&frame.image_file(&ExifImage { position: None, ..of_scan.clone() })), ExifImage::default());
        assert_eq!(decode_scan(&frame.image_file(&of_scan)).unwrap(), frame.image);
        // Grey files have it as well.
        let grey = film_frame(&Bands::from(scan.to_grey()), &film, 0.25).unwrap();
        assert_eq!(read(&grey.image_file(&of_scan)), wanted);
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
