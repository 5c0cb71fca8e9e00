//! A photo on film as it was scanned, and the image that an ideal camera would have taken in its place.

use super::input::FilmInput;
use crate::error::refuse;
use crate::{Camera, CameraUncertainty, DecodeLimits, Error, FiducialOrientation, Interior, Refusal, photo_marks};
use serde::{Deserialize, Serialize};

/// How the scan of a photo on film lies to its frame: the image of a camera without distortion, with square pixels, along the photo's axes, of what lies
/// within the marks.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct FilmScan {
    /// Of the scan.
    pub width_px: u32,
    pub height_px: u32,
    pub focal_mm: f64,
    /// Of the scan.
    pub interior: Interior,
    /// How the marks give it.
    pub marks: FiducialOrientation,
    /// Side of a pixel of the frame.
    pub pixel_mm: f64,
    /// Where the top-left corner of the frame lies among the undistorted positions of the scan: see [`Interior::undistorted_px`].
    pub corner_px: [f64; 2],
    /// Width and height of the frame.
    pub frame_px: [u32; 2],
}

/// So far about a mark nothing is of the photograph, as a share of the extent of all marks: 3 mm of a film of 230 mm, on which marks and their numbers
/// have some 2. The frame ends as far within the outermost ones, since the border of the film begins at some.
const HIDDEN: f64 = 1.0 / 80.0;
/// Positions so near to each other are one.
const SAME_PX: f64 = 1e-3;
/// Columns and rows of a scan are perpendicular to this. Exchanged marks of three, which leave no residuals, bring tens of degrees.
const MOST_SKEW_DEG: f64 = 3.0;
/// Neither do scanners and the shrinking of film make columns and rows of lengths that differ by a larger share.
const MOST_SCALES: f64 = 0.05;
/// A frame without as many px along each side shows nothing.
const LEAST_FRAME_PX: f64 = 16.0;

impl FilmScan {
    /// From the marks in a scan of this width and height: its frame has pixels as large as those of the scan in the mean, and ends where the scan does.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] without a camera, and for marks that lie mirrored or askew; as [`photo_marks`](crate::photo_marks) and
    /// [`Interior::from_fiducials`].
    pub fn new(film: &FilmInput, size: [usize; 2]) -> Result<Self, Error> {
        let scan = Self::without_frame(film, size)?;
        let (low, high) = scan.within(&film.film_marks());
        let corner_px = low.map(f64::ceil);
        scan.framed(corner_px, [0, 1].map(|k| high[k].floor() - corner_px[k]))
    }

    /// The same with pixels of this side, in mm, and a frame that the calibration of the marks gives alone: those of all scans of a camera are alike.
    ///
    /// # Errors
    /// As [`new`](Self::new); [`Error::InvalidInput`] for pixels smaller than a half of those of the scan, or more than twice as large: from finer scans grain
    /// would come as false patterns.
    pub fn in_common(film: &FilmInput, size: [usize; 2], pixel_mm: f64) -> Result<Self, Error> {
        let scan = Self::without_frame(film, size)?;
        let own_mm = scan.interior.pixel_mm();
        let [least, most] = [0.5 * own_mm, 2.0 * own_mm];
        if !(pixel_mm >= least && pixel_mm <= most) {
            return refuse(Refusal::FilmPixel { pixel_mm, least, most });
        }
        let marks = film.film_marks();
        let hidden_mm = hidden_mm(&marks);
        // From the principal point, as the camera without distortion sees them.
        let seen: Vec<[f64; 2]> = marks.iter().map(|mark| scan.interior.corrected_mm(*mark)).collect();
        let of_axis = |of: &dyn Fn([f64; 2]) -> f64| {
            let [low, high] = range(seen.iter().map(|mark| of(*mark)));
            [((low + hidden_mm) / pixel_mm).ceil(), ((high - hidden_mm) / pixel_mm).floor()]
        };
        let [[left, right], [top, bottom]] = [of_axis(&|mark| mark[0]), of_axis(&|mark| -mark[1])];
        let (at, scale) = (scan.interior.principal_point_px(), pixel_mm / own_mm);
        let corner_px = [at[0] + scale * left, at[1] + scale * top];
        Self { pixel_mm, ..scan }.framed(corner_px, [right - left, bottom - top])
    }

    /// With a frame that begins there and has this width and height.
    fn framed(self, corner_px: [f64; 2], size: [f64; 2]) -> Result<Self, Error> {
        if !size.iter().all(|side| *side >= LEAST_FRAME_PX) {
            return refuse(Refusal::FilmBeside { width_px: self.width_px, height_px: self.height_px });
        }
        let ([width, height], most) = (size, DecodeLimits::default().max_pixels as f64);
        if !(width * height <= most) {
            let [megapixels, max_megapixels] = [width * height, most].map(|n| n / 1e6);
            return Err(Error::TooManyPixels { width: width as u64, height: height as u64, megapixels, max_megapixels });
        }
        Ok(Self { corner_px, frame_px: size.map(|side| side as u32), ..self })
    }

    fn without_frame(film: &FilmInput, size: [usize; 2]) -> Result<Self, Error> {
        let Some(camera) = &film.camera else { return refuse(Refusal::FilmWithoutCamera) };
        let marks = photo_marks(size[0], size[1], &film.scan)?;
        let interior = Interior::from_fiducials(camera, &marks, film.scan.origin.unwrap_or([0.0; 2]))?;
        if interior.is_mirrored() {
            return refuse(Refusal::MarksMirrored);
        }
        let skew_deg = skew_deg(&interior);
        if !(skew_deg <= MOST_SKEW_DEG) {
            return refuse(Refusal::MarksSkew { skew_deg, most_deg: MOST_SKEW_DEG });
        }
        let scales = scales(&interior);
        if !(scales <= MOST_SCALES) {
            return refuse(Refusal::MarksScales { scales, most: MOST_SCALES });
        }
        let [width_px, height_px] = size.map(|side| side as u32);
        let (focal_mm, pixel_mm) = (camera.focal_mm, interior.pixel_mm());
        Ok(Self { width_px, height_px, focal_mm, interior, marks, pixel_mm, corner_px: [0.0; 2], frame_px: [1; 2] })
    }

    /// The side of a pixel of the frame in pixels of the scan.
    pub(super) fn scale(&self) -> f64 {
        self.pixel_mm / self.interior.pixel_mm()
    }

    /// The lowest and the highest undistorted position of what the scan shows within the marks.
    fn within(&self, marks_mm: &[[f64; 2]]) -> ([f64; 2], [f64; 2]) {
        let hidden = hidden_mm(marks_mm) / self.interior.pixel_mm();
        let marks: Vec<[f64; 2]> = marks_mm.iter().map(|mark| self.of_mark(*mark)).collect();
        let [w, h] = [self.width_px, self.height_px].map(f64::from);
        let border = [[0.0, 0.0], [0.5, 0.0], [1.0, 0.0], [1.0, 0.5], [1.0, 1.0], [0.5, 1.0], [0.0, 1.0], [0.0, 0.5]];
        let border = border.map(|[x, y]| self.interior.undistorted_px(x * w, y * h));
        let along = |all: &[[f64; 2]], axis: usize| range(all.iter().map(|at| at[axis]));
        let both = |axis: usize| {
            let ([low, high], [first, last]) = (along(&marks, axis), along(&border, axis));
            [(low + hidden).max(first), (high - hidden).min(last)]
        };
        let [x, y] = [both(0), both(1)];
        ([x[0], y[0]], [x[1], y[1]])
    }

    /// Where a mark is by its calibration, among undistorted positions.
    pub(super) fn of_mark(&self, mark_mm: [f64; 2]) -> [f64; 2] {
        let ([x0, y0], pixel_mm, [x, y]) =
            (self.interior.principal_point_px(), self.interior.pixel_mm(), self.interior.corrected_mm(mark_mm));
        [x0 + x / pixel_mm, y0 - y / pixel_mm]
    }

    /// The camera of the frame.
    pub fn camera(&self) -> Camera {
        let (at, scale) = (self.interior.principal_point_px(), self.scale());
        let [width, height] = self.frame_px;
        Camera {
            principal_point_px: [0, 1].map(|k| (at[k] - self.corner_px[k]) / scale),
            pixel_mm: Some(self.pixel_mm),
            ..Camera::without_distortion(width, height, self.focal_mm / self.pixel_mm)
        }
    }

    /// What is not known of that camera: what the marks leave open, beside what the camera says itself. What they leave open of shear and of differing
    /// scales is as small, and no parameter of a camera.
    pub fn uncertainty(&self) -> CameraUncertainty {
        let own = self.interior.uncertainty.unwrap_or(CameraUncertainty::NONE);
        let Some(covariance) = &self.interior.covariance else { return own };
        let variance = |by: [f64; 3]| -> f64 { (0..9).map(|k| by[k / 3] * covariance[k / 3][k % 3] * by[k % 3]).sum() };
        let [col, row] = self.interior.principal_point_px();
        let principal_point = variance([col, row, 1.0]).max(0.0).sqrt() / self.focal_mm;
        // The side of a pixel is the root of the determinant, which both rows of the transformation change.
        let [[a, b, _], [d, e, _]] = self.interior.parameters;
        let of_area = variance([e, -d, 0.0]) + variance([-b, a, 0.0]);
        let focal = 0.5 * of_area.max(0.0).sqrt() / (a * e - b * d).abs();
        let with = |own: f64, of_marks: f64| libm::hypot(own, of_marks).min(1.0);
        CameraUncertainty { focal: with(own.focal, focal), principal_point: with(own.principal_point, principal_point), k1: own.k1 }
    }

    /// Standard deviation of the decentring that is left in the frame: of a lens that states its terms a tenth of what is not known of others.
    pub(crate) fn decentring(&self) -> Option<f64> {
        let left = self.uncertainty().decentring_beside(self.interior.tangential_distortion);
        (left > 0.0).then_some(left)
    }

    /// The position in the scan of a position in the frame, both in px; `None` where the distortion leads none there.
    pub fn in_scan(&self, at: [f64; 2]) -> Option<[f64; 2]> {
        let scale = self.scale();
        let [x, y] = [0, 1].map(|k| self.corner_px[k] + scale * at[k]);
        self.interior.image_px(x, y)
    }

    /// The position in the frame of a position in the scan, both in px.
    pub fn in_frame(&self, at: [f64; 2]) -> [f64; 2] {
        let (undistorted, scale) = (self.interior.undistorted_px(at[0], at[1]), self.scale());
        [0, 1].map(|k| (undistorted[k] - self.corner_px[k]) / scale)
    }

    /// The same of a position that the frame shows; `None` beside it, and where the distortion leads another position there.
    pub fn shown_in_frame(&self, at: [f64; 2]) -> Option<[f64; 2]> {
        let there = self.in_frame(at);
        let is_within = (0..2).all(|k| (0.0..=f64::from(self.frame_px[k])).contains(&there[k]));
        let back = Some(there).filter(|_| is_within).and_then(|there| self.in_scan(there))?;
        (0..2).all(|k| (back[k] - at[k]).abs() < SAME_PX).then_some(there)
    }
}

/// Lowest and highest.
fn range(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], v| [low.min(v), high.max(v)])
}

/// What is hidden about a mark.
pub(super) fn hidden_mm(marks_mm: &[[f64; 2]]) -> f64 {
    let extent = [0, 1].map(|k| {
        let [low, high] = range(marks_mm.iter().map(|mark| mark[k]));
        high - low
    });
    HIDDEN * extent[0].max(extent[1])
}

/// By what share the lengths of columns and rows differ on the film.
fn scales(interior: &Interior) -> f64 {
    let [[a, b, _], [d, e, _]] = interior.parameters;
    (libm::hypot(a, d) / libm::hypot(b, e) - 1.0).abs()
}

/// By how much the angle between columns and rows differs from a right one.
fn skew_deg(interior: &Interior) -> f64 {
    let [[a, b, _], [d, e, _]] = interior.parameters;
    let share = (a * b + d * e) / (libm::hypot(a, d) * libm::hypot(b, e));
    libm::asin(share.clamp(-1.0, 1.0)).abs().to_degrees()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::film::known_scan::{MARKS_MM, SIZE, in_scan, measured};
    use crate::math::Random;
    use crate::{Fiducial, FiducialModel, PhotoInput};

    #[test]
    fn the_frame_is_what_lies_within_the_marks_along_the_axes_of_the_photo() {
        let film = measured(|| 0.0);
        let scan = FilmScan::new(&film, SIZE).unwrap();
        let camera = scan.camera();
        let pixel_mm = camera.pixel_mm.unwrap();
        assert!((pixel_mm - 1.0 / (3.9_f64 * 3.92 + 0.45 * 0.46).sqrt()).abs() < 1e-12, "{pixel_mm}");
        assert!((camera.focal_px - 152.0 / pixel_mm).abs() < 1e-6);
        for [x, y] in [[0.5, -0.25], [60.0, 35.0], [-100.0, 98.0]] {
            let (at, [cx, cy]) = (scan.in_frame(in_scan(x, y)), camera.principal_point_px);
            let wanted = [cx + (x - 0.5) / pixel_mm, cy - (y + 0.25) / pixel_mm];
            assert!((0..2).all(|k| (at[k] - wanted[k]).abs() < 1e-6), "{at:?} {wanted:?}");
            let back = scan.in_scan(at).unwrap();
            assert!((0..2).all(|k| (back[k] - in_scan(x, y)[k]).abs() < 1e-6), "{back:?}");
        }
        // 212 mm, less 2 x 2.65 mm; the marks themselves lie beyond, and one in the middle is hidden.
        let [width_mm, height_mm] = scan.frame_px.map(|side| f64::from(side) * pixel_mm);
        assert!((width_mm - 206.7).abs() < 0.6 && (height_mm - 206.7).abs() < 0.6, "{width_mm} {height_mm}");
        let with_middle = FilmInput { marks_mm: vec![[20.0, 30.0]], ..film.clone() };
        let shows = scan.shows(&with_middle.film_marks());
        let seen = |x: f64, y: f64| shows(scan.in_frame(in_scan(x, y)));
        assert_eq!([seen(20.0, 32.0), seen(20.0, 33.5), seen(0.0, 0.0)], [false, true, true]);
        // Of a part of the scan that ends within the marks the rest is the frame.
        let part = FilmInput { scan: PhotoInput { origin: Some([500.0, 480.0]), ..film.scan.clone() }, ..film.clone() };
        let cut = FilmScan::new(&part, [300, 320]).unwrap();
        assert!(cut.frame_px.iter().all(|side| (320..400).contains(side)), "{:?}", cut.frame_px);
        let shows = cut.shows(&part.film_marks());
        assert!(shows(cut.in_frame([20.0, 300.0])) && !shows(cut.in_frame([4.0, 300.0])) && !shows(cut.in_frame([320.0, 100.0])));
    }

    #[test]
    fn scans_of_one_camera_have_one_frame_however_they_were_scanned() {
        const PIXEL_MM: f64 = 0.3;
        let film = measured(|| 0.0);
        // Scanned upside down, larger and askew.
        let other = |x: f64, y: f64| [700.0 - 5.1 * x + 0.2 * y, 690.0 + 0.25 * x + 5.0 * y];
        let turned = film.scan.fiducials.iter().map(|mark| {
            let [col, row] = other(mark.x_mm, mark.y_mm);
            Fiducial { col, row, ..*mark }
        });
        let turned = FilmInput { scan: PhotoInput { fiducials: turned.collect(), ..PhotoInput::default() }, ..film.clone() };
        let [a, b] = [(&film, SIZE), (&turned, [1400, 1380])].map(|(film, size)| FilmScan::in_common(film, size, PIXEL_MM).unwrap());
        let [own, others] = [&a, &b].map(FilmScan::camera);
        assert_eq!(
            (own.width_px, own.height_px, own.focal_px, own.pixel_mm),
            (others.width_px, others.height_px, 152.0 / PIXEL_MM, Some(PIXEL_MM))
        );
        for k in 0..2 {
            assert!((own.principal_point_px[k] - others.principal_point_px[k]).abs() < 1e-6, "{own:?} {others:?}");
            // Whole pixels: frames differ by no part of one.
            assert!((own.principal_point_px[k] - own.principal_point_px[k].round()).abs() < 1e-6, "{own:?}");
        }
        for [x, y] in [[0.5, -0.25], [60.0, 35.0], [-100.0, 98.0]] {
            let [at, there] = [a.in_frame(in_scan(x, y)), b.in_frame(other(x, y))];
            assert!((0..2).all(|k| (at[k] - there[k]).abs() < 1e-6), "{at:?} {there:?}");
            let back = b.in_scan(there).unwrap();
            assert!((0..2).all(|k| (back[k] - other(x, y)[k]).abs() < 1e-6), "{back:?}");
        }
        let refused = |pixel_mm: f64| FilmScan::in_common(&film, SIZE, pixel_mm).unwrap_err().to_string();
        assert!(refused(0.1).contains("0.1") && refused(0.6).contains("0.6") && refused(f64::NAN).contains("pixel"), "{}", refused(0.1));
    }

    #[test]
    fn marks_that_nobody_measured_say_where_the_photograph_ends_and_are_hidden() {
        let film = measured(|| 0.0);
        let mut three = film.clone();
        three.scan.fiducials.pop();
        let of = |film: &FilmInput| FilmScan::in_common(film, SIZE, 0.3).unwrap();
        // Without the fourth mark the outermost ones are still there; of two on one side half of the photo is left.
        let mut half = film.clone();
        half.scan.fiducials = [[-106.0, 0.0], [0.0, 106.0], [0.0, -106.0]]
            .map(|[x_mm, y_mm]| {
                let [col, row] = in_scan(x_mm, y_mm);
                Fiducial { col, row, x_mm, y_mm }
            })
            .to_vec();
        assert!(of(&half).frame_px[0] < 360, "{:?}", of(&half).frame_px);
        let known = FilmInput { marks_mm: MARKS_MM.to_vec(), ..half };
        let [whole, by_three] = [of(&film), of(&FilmInput { marks_mm: MARKS_MM.to_vec(), ..three })];
        for other in [&by_three, &of(&known)] {
            assert_eq!(other.frame_px, whole.frame_px);
            let [own, others] = [&whole, other].map(|scan| scan.camera().principal_point_px);
            assert!((0..2).all(|k| (own[k] - others[k]).abs() < 1e-6), "{own:?} {others:?}");
        }
    }

    #[test]
    fn what_the_marks_leave_open_of_the_camera_is_what_their_errors_bring() {
        const TRIALS: usize = 800;
        let mut random = Random::new(5);
        let mut uniform = || (random.below(1_000_000) as f64 * 1e-6 - 0.5) * 0.4;
        let truth = FilmScan::new(&measured(|| 0.0), SIZE).unwrap().camera();
        let (mut found, mut stated) = ([0.0; 2], [0.0; 2]);
        for _ in 0..TRIALS {
            let scan = FilmScan::new(&measured(&mut uniform), SIZE).unwrap();
            let (camera, uncertainty) = (scan.camera(), scan.uncertainty());
            let at = scan.in_scan(camera.principal_point_px).unwrap();
            let off = [camera.focal_px / truth.focal_px - 1.0, (at[0] - in_scan(0.5, -0.25)[0]) / truth.focal_px];
            for (k, own) in [uncertainty.focal, uncertainty.principal_point].into_iter().enumerate() {
                found[k] += off[k] * off[k];
                stated[k] += own * own;
            }
        }
        for k in 0..2 {
            let ratio = (found[k] / stated[k]).sqrt();
            assert!((0.9..1.1).contains(&ratio), "{ratio}");
        }
        // Three marks say nothing of their errors: then the camera is what it says itself.
        let mut three = measured(|| 0.0);
        three.scan.fiducials.truncate(3);
        assert_eq!(FilmScan::new(&three, SIZE).unwrap().uncertainty(), CameraUncertainty::NONE);
        three.camera.as_mut().unwrap().uncertainty = Some(CameraUncertainty::GIVEN);
        assert_eq!(FilmScan::new(&three, SIZE).unwrap().uncertainty(), CameraUncertainty::GIVEN);
    }

    #[test]
    fn marks_and_cameras_that_cannot_be_are_refused() {
        let refused = |change: &dyn Fn(&mut FilmInput)| {
            let mut film = measured(|| 0.0);
            change(&mut film);
            FilmScan::new(&film, SIZE).unwrap_err().to_string()
        };
        let marks = |change: &dyn Fn(&mut Vec<Fiducial>)| refused(&|film| change(&mut film.scan.fiducials));
        assert!(refused(&|film| film.camera = None).contains("focal length in mm"));
        assert!(refused(&|film| film.camera.as_mut().unwrap().focal_mm = 0.0).contains("camera.focal_mm"));
        assert!(marks(&|marks| marks.truncate(2)).contains("fiducial marks"));
        assert!(marks(&|marks| marks[1].col = 1100.0).contains("marks within the image"));
        assert!(marks(&|marks| marks.iter_mut().for_each(|mark| mark.x_mm = -mark.x_mm)).contains("mirrored"));
        let exchange = |marks: &mut Vec<Fiducial>| {
            let [x_mm, y_mm] = [marks[0].x_mm, marks[0].y_mm];
            marks[0] = Fiducial { x_mm: marks[1].x_mm, y_mm: marks[1].y_mm, ..marks[0] };
            marks[1] = Fiducial { x_mm, y_mm, ..marks[1] };
        };
        assert!(marks(&exchange).contains("exchanged"));
        // Of three marks two that are exchanged mirror the photo, and three of them turn and shear it.
        let two_of_three = |marks: &mut Vec<Fiducial>| {
            marks.truncate(3);
            exchange(marks);
        };
        assert!(marks(&two_of_three).contains("mirrored"));
        let around = |marks: &mut Vec<Fiducial>| {
            marks.truncate(3);
            let places: Vec<[f64; 2]> = marks.iter().map(|mark| [mark.x_mm, mark.y_mm]).collect();
            (0..3).for_each(|k| [marks[k].x_mm, marks[k].y_mm] = places[(k + 1) % 3]);
        };
        assert!(marks(&around).contains("right angle"), "{}", marks(&around));
        // An x that was mistyped for all marks of one side leaves no residuals.
        let stretched = |marks: &mut Vec<Fiducial>| marks.iter_mut().filter(|mark| mark.x_mm < 0.0).for_each(|mark| mark.x_mm = -160.0);
        assert!(marks(&stretched).contains("columns and rows"), "{}", marks(&stretched));
        // A part of the scan that lies beside the photograph.
        assert!(
            refused(&|film| film.scan.origin = Some([5000.0, 5000.0])).contains("outside"),
            "{}",
            refused(&|film| film.scan.origin = Some([5000.0, 5000.0]))
        );
        let similarity = FilmInput { scan: PhotoInput { model: FiducialModel::Similarity, ..measured(|| 0.0).scan }, ..measured(|| 0.0) };
        assert!(FilmScan::new(&similarity, SIZE).is_ok());
    }
}
