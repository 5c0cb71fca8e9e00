//! Single photos of several kinds on orthophotos of years later: vertical ones, oblique ones, and scans of film with fiducial marks. Errors beside standard
//! errors, and photos that are called placed although they are not. Arguments: first seed, number of seeds, distance in m within which heights err together.

mod later;

use later::{FAULTS, Ground, TOGETHER_M, chance};
use std::process::ExitCode;
use tiepoint::{
    BlockFlight, BlockScene, BlockView, CameraMm, CameraUncertainty, Fiducial, FilmInput, GreyImage, Orthophoto, PhotoInput, PlacedImage,
    PlacingCamera, PlacingOptions, PlacingVerdict, Pose, SearchArea, place_film, place_image,
};

const SIZE_PX: [usize; 2] = [800, 600];
const PIXEL_MM: f64 = 0.03;
/// A photo that is called placed is wrong beyond so many standard errors, or if it is turned by more.
const MOST_RATIO: f64 = 10.0;
const MOST_TURN_DEG: f64 = 1.0;
/// The mean square of errors by their standard errors is no larger: the photos of a scene share its heights, so that it is that of a few numbers.
const HELD: f64 = 4.0;

/// How photos were taken.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Vertical,
    Film,
    Oblique,
}

const KINDS: [(Kind, &str); 3] = [(Kind::Vertical, "vertical"), (Kind::Film, "scan of film"), (Kind::Oblique, "oblique")];

impl Kind {
    /// Four photos: of two strips straight down, or tilted by 45° to all sides, after one straight down, which is left out.
    fn flight(self, seed: u32) -> (BlockFlight, std::ops::Range<usize>) {
        let [width_px, height_px] = SIZE_PX.map(|side| side as u32);
        let (view, strips, photos) = if self == Self::Oblique { (BlockView::Oblique, 1, 1..5) } else { (BlockView::Nadir, 2, 0..4) };
        (BlockFlight { view, strips, exposures: strips, width_px, height_px, pixel_mm: PIXEL_MM, seed, ..BlockFlight::default() }, photos)
    }
}

/// The fiducial marks of a film of 27 x 21 mm, and its principal point.
const MARKS_MM: [[f64; 2]; 8] =
    [[-13.1, -10.1], [13.1, -10.1], [13.1, 10.1], [-13.1, 10.1], [-13.3, 0.0], [13.3, 0.1], [0.1, 10.3], [0.0, -10.3]];
const PRINCIPAL_POINT_MM: [f64; 2] = [0.2, -0.16];
/// The scanner: its angle, the scales of columns and rows, what they lie off a right angle; and the scan.
const ANGLE: f64 = 0.122;
const SCALES: [f64; 2] = [1.003, 0.997];
const SHEAR: f64 = 0.003;
const SCAN_PX: [usize; 2] = [1020, 850];
const MIDDLE_PX: [f64; 2] = [509.3, 424.8];
/// Standard deviations of a measured mark in px and of grain in grey values; an old film has less contrast, and what is dark is lighter.
const MARK_PX: f64 = 0.05;
const GRAIN: f64 = 10.0;
const CONTRAST: f64 = 0.6;
const FOG: f64 = 60.0;

/// Approximately normally distributed.
fn normal(seed: u32, column: usize, row: usize, what: u32) -> f64 {
    (0..12).map(|k| chance(seed, column, row, what + k)).sum::<f64>() - 6.0
}

fn in_scan([x_mm, y_mm]: [f64; 2]) -> [f64; 2] {
    let [x, y] = [(x_mm * SCALES[0] + y_mm * SHEAR) / PIXEL_MM, -y_mm * SCALES[1] / PIXEL_MM];
    let (sine, cosine) = ANGLE.sin_cos();
    [cosine * x - sine * y + MIDDLE_PX[0], sine * x + cosine * y + MIDDLE_PX[1]]
}

fn on_film([col, row]: [f64; 2]) -> [f64; 2] {
    let (sine, cosine) = ANGLE.sin_cos();
    let [u, v] = [col - MIDDLE_PX[0], row - MIDDLE_PX[1]];
    let y_mm = -(cosine * v - sine * u) * PIXEL_MM / SCALES[1];
    [((cosine * u + sine * v) * PIXEL_MM - SHEAR * y_mm) / SCALES[0], y_mm]
}

/// The grey value at a position in px, between the middles of four pixels.
fn between(photo: &GreyImage, at: [f64; 2]) -> f64 {
    let [(x, u), (y, v)] = [0, 1].map(|k| {
        let last = ([photo.width(), photo.height()][k] - 1) as f64;
        let from = (at[k] - 0.5).clamp(0.0, last);
        (from as usize, from.fract())
    });
    let [right, below] = [(x + 1).min(photo.width() - 1), (y + 1).min(photo.height() - 1)];
    let grey = |x, y| f64::from(photo.view().at(x, y));
    (1.0 - v) * ((1.0 - u) * grey(x, y) + u * grey(right, y)) + v * ((1.0 - u) * grey(x, below) + u * grey(right, below))
}

/// A photo as the scan of an old film, with a border and marks.
fn scan_of(photo: &GreyImage, seed: u32) -> GreyImage {
    let grey = |column: usize, row: usize| {
        let [x_mm, y_mm] = on_film([column as f64 + 0.5, row as f64 + 0.5]);
        let off = MARKS_MM.iter().map(|mark| (x_mm - mark[0]).abs().max((y_mm - mark[1]).abs())).fold(f64::INFINITY, f64::min);
        let [x, y] = [x_mm - PRINCIPAL_POINT_MM[0], y_mm - PRINCIPAL_POINT_MM[1]];
        let at = [0.5 * SIZE_PX[0] as f64 + x / PIXEL_MM, 0.5 * SIZE_PX[1] as f64 - y / PIXEL_MM];
        let is_photo = (0..2).all(|k| (0.0..=SIZE_PX[k] as f64).contains(&at[k]));
        let exposed = match off {
            off if off < 0.07 => 230.0,
            off if off < 0.23 || !is_photo => 12.0,
            _ => CONTRAST * between(photo, at) + FOG,
        };
        (exposed + GRAIN * normal(seed, column, row, 40)).round().clamp(0.0, 255.0) as u8
    };
    GreyImage::from_fn(SCAN_PX[0], SCAN_PX[1], grey).expect("a scan of less than 100 MP")
}

fn film(focal_px: f64, seed: u32) -> FilmInput {
    let mark = |(number, [x_mm, y_mm]): (usize, [f64; 2])| {
        let [col, row] = in_scan([x_mm, y_mm]);
        let [off_col, off_row] = [60, 72].map(|what| MARK_PX * normal(seed, number, 0, what));
        Fiducial { col: col + off_col, row: row + off_row, x_mm, y_mm }
    };
    let camera = CameraMm { principal_point_mm: PRINCIPAL_POINT_MM, ..CameraMm::without_distortion(focal_px * PIXEL_MM, None) };
    let scan = PhotoInput { fiducials: MARKS_MM.into_iter().enumerate().map(mark).collect(), ..PhotoInput::default() };
    FilmInput { camera: Some(camera), scan, marks_mm: Vec::new() }
}

/// What came of the photos of one kind on one kind of orthophoto.
#[derive(Default)]
struct Tally {
    photos: usize,
    placed: usize,
    weak: usize,
    wrong: usize,
    /// Of X, Y, Z, ω, φ, κ: errors, and these by their standard errors.
    errors: [Vec<f64>; 6],
    ratios: [Vec<f64>; 6],
}

impl Tally {
    fn add(&mut self, scene: &BlockScene, index: usize, found: PlacedImage) {
        let is_placed = matches!(found.verdict, PlacingVerdict::Placed { .. });
        self.photos += 1;
        self.placed += usize::from(is_placed);
        self.weak += usize::from(matches!(found.verdict, PlacingVerdict::Weak { .. }));
        if !is_placed {
            println!("    photo {index}: {}", found.verdict);
        }
        let (Some(placement), Some(truth)) = (found.placement, scene.truth().images[index].pose) else { return };
        let (angles, true_angles) = (placement.pose.angles(), truth.angles());
        let turns = placement.angle_errors_deg.unwrap_or([f64::NAN; 3]);
        let shifts = placement.position_errors_m.unwrap_or([f64::NAN; 3]);
        let mut is_wrong = false;
        for k in 0..6 {
            let (error, sigma) = match k {
                0..3 => (placement.pose.position[k] - truth.position[k], shifts[k]),
                _ => (((angles[k - 3] - true_angles[k - 3]).to_degrees() + 180.0).rem_euclid(360.0) - 180.0, turns[k - 3]),
            };
            is_wrong |= !((error / sigma).abs() <= MOST_RATIO) || (k >= 3 && error.abs() > MOST_TURN_DEG);
            self.errors[k].push(error);
            self.ratios[k].push(error / sigma);
        }
        self.wrong += usize::from(is_placed && is_wrong);
    }

    fn mean_squares(of: &[Vec<f64>; 6]) -> [f64; 6] {
        of.each_ref().map(|all| all.iter().map(|value| value * value).sum::<f64>() / all.len().max(1) as f64)
    }

    fn is_right(&self) -> bool {
        self.wrong == 0 && Self::mean_squares(&self.ratios).iter().all(|mean| *mean <= HELD)
    }

    fn print(&self, name: &str) {
        let [x, y, z, omega, phi, kappa] = Self::mean_squares(&self.errors).map(f64::sqrt);
        println!("  {name}: {} photos, {} placed, {} with doubt, {} placed wrongly", self.photos, self.placed, self.weak, self.wrong);
        println!("    RMS error X {x:.3}, Y {y:.3}, Z {z:.3} m, ω {omega:.4}, φ {phi:.4}, κ {kappa:.4}°");
        println!("    mean square of error by standard error X Y Z ω φ κ {:.2?}", Self::mean_squares(&self.ratios));
    }
}

/// Where a photo lies is known roughly: the search goes twice as far about a place that is so far off the one where its axis meets the mean ground.
const OFF_M: f64 = 300.0;

fn options(pose: &Pose) -> PlacingOptions {
    let ([x, y, z], axis) = (pose.position, pose.rotation[2]);
    let (along, off) = (z / axis[2], OFF_M / std::f64::consts::SQRT_2);
    let [near_x, near_y] = [x - along * axis[0] + off, y - along * axis[1] - off].map(Some);
    PlacingOptions { near_x, near_y, within_m: 2.0 * OFF_M, points: 4000, ..PlacingOptions::default() }
}

/// A photo of a scene on an orthophoto, by its calibrated camera. Each scan has grain and errors of its marks of its own.
fn placed((scene, seed): (&BlockScene, u32), index: usize, kind: Kind, photo: &GreyImage, reference: &Orthophoto) -> PlacedImage {
    let truth = scene.truth();
    let camera = truth.cameras[truth.images[index].camera];
    let options = options(&truth.images[index].pose.expect("a true pose"));
    let area = SearchArea::new(reference, &options).expect("a place on the orthophoto");
    if kind == Kind::Film {
        let seed = 100 * seed + index as u32;
        let scan = scan_of(photo, seed);
        return place_film(scan.view(), &film(camera.focal_px, seed), None, reference, &area, &options).expect("a scan with its marks");
    }
    let known = PlacingCamera { camera, uncertainty: CameraUncertainty::NONE, decentring: None };
    place_image(photo.view(), &known, reference, &area, &options).expect("a camera as large as the photo")
}

fn main() -> ExitCode {
    let numbers: Vec<u32> = std::env::args().skip(1).filter_map(|word| word.parse().ok()).collect();
    let given = |k: usize, standard: u32| numbers.get(k).copied().unwrap_or(standard);
    let (first, seeds, together_m) = (given(0, 1), given(1, 2), given(2, TOGETHER_M));
    let mut is_right = true;
    for (kind, name) in KINDS {
        let mut all = FAULTS.map(|_| Tally::default());
        for seed in first..first + seeds {
            let (flight, photos) = kind.flight(seed);
            let scene = BlockScene::new(&flight).expect("a flight that can be flown");
            let photos: Vec<(usize, GreyImage)> = photos.map(|index| (index, scene.photo(index).expect("a photo of the flight"))).collect();
            let ground = Ground::new(&scene, &flight);
            for ((fault, _), tally) in FAULTS.iter().zip(&mut all) {
                let reference = ground.later(*fault, together_m);
                photos.iter().for_each(|(index, photo)| tally.add(&scene, *index, placed((&scene, seed), *index, kind, photo, &reference)));
            }
        }
        FAULTS.iter().zip(&all).for_each(|((_, fault), tally)| tally.print(&format!("{name}, {fault}")));
        is_right &= all.iter().all(Tally::is_right);
    }
    if is_right { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
