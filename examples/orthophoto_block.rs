//! Simulated blocks in the system of orthophotos of their ground, of which much has changed: errors beside standard errors. Then photos of other
//! towns, none of which may be placed. Arguments: first seed, number of seeds, photos of other towns, strips, exposures per strip.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use tiepoint::{
    BlockFlight, BlockLinks, BlockRun, BlockScene, BlockVerdict, CameraUncertainty, ControlRole, DecodeLimits, GreyImage, HeightModel,
    Heights, OnOrthophoto, Orthophoto, PlacingCamera, PlacingOptions, PlacingVerdict, RunInput, SearchArea, SurveyedPoint, decode,
    place_image, run_block,
};

/// Side of a pixel of the orthophoto in m.
const GSD_M: f64 = 0.5;
/// What was built: squares of so many m a side, of which this share shows another town.
const CHANGES: [(f64, f64); 2] = [(60.0, 0.2), (12.0, 0.1)];
const MORE_CHANGES: [(f64, f64); 2] = [(60.0, 0.35), (12.0, 0.2)];
/// Fields of so many m a side, of which this share shows another crop: what was dark is bright, with a texture of so many px.
const FIELDS: (f64, f64) = (80.0, 0.2);
const TEXTURE_PX: f64 = 6.0;
const TEXTURE_GREY: f64 = 25.0;
/// Standard error of a height, that which is stated without an option, and the distance in m within which heights err together.
const HEIGHT_M: f64 = GSD_M;
const TOGETHER_M: f64 = 150.0;
/// Other light, and noise in grey values.
const GAIN: f64 = 0.75;
const OFFSET: f64 = 35.0;
const NOISE: f64 = 4.0;
/// The rough position is so far off along both axes together, and the search goes as far beyond the block.
const OFF_M: f64 = 300.0;
/// Errors of centres are to be at most so many pixels of the orthophoto, in height times the factor that their covariance says.
const ASKED_PX: f64 = 0.5;
/// What the mean square of errors by their standard errors is, and the normal deviate of the chance that so few blocks give more, or less.
const HELD: [f64; 2] = [0.8, 1.3];
const BY_CHANCE: f64 = 3.09;

/// What is wrong with an orthophoto beside what was built and the light.
#[derive(Clone, Copy)]
enum Fault {
    None,
    Built,
    Season,
    Heights,
}

const FAULTS: [(Fault, &str); 4] = [
    (Fault::None, "heights right"),
    (Fault::Built, "more was built"),
    (Fault::Season, "fields of another season"),
    (Fault::Heights, "heights wrong together"),
];

fn flight(seed: u32, strips: usize, exposures: usize) -> BlockFlight {
    BlockFlight { strips, exposures, width_px: 800, height_px: 600, pixel_mm: 0.045, seed, ..BlockFlight::default() }
}

/// A number from 0 to 1 that is the same for the same numbers.
fn chance(seed: u32, column: usize, row: usize, what: u32) -> f64 {
    let mut mixed =
        seed ^ (column as u32).wrapping_mul(0x9E37_79B1) ^ (row as u32).wrapping_mul(0x85EB_CA77) ^ what.wrapping_mul(0xC2B2_AE3D);
    for shift in [15, 13, 16] {
        mixed = (mixed ^ (mixed >> shift)).wrapping_mul(0x2C1B_3C6D);
    }
    f64::from(mixed) / f64::from(u32::MAX)
}

/// Normally distributed, of variance 1, and smooth over so many px.
fn smooth(seed: u32, column: usize, row: usize, side_px: f64, what: u32) -> f64 {
    let normal = |column: usize, row: usize| {
        let [a, b] = [what, what + 1].map(|what| chance(seed, column, row, what));
        (-2.0 * a.max(1e-9).ln()).sqrt() * (std::f64::consts::TAU * b).cos()
    };
    let [x, y] = [column, row].map(|k| k as f64 / side_px);
    let [u, v] = [x.fract(), y.fract()];
    let corners = [([0, 0], (1.0 - u) * (1.0 - v)), ([1, 0], u * (1.0 - v)), ([0, 1], (1.0 - u) * v), ([1, 1], u * v)];
    let sum: f64 = corners.iter().map(|([c, r], weight)| weight * normal(x as usize + c, y as usize + r)).sum();
    sum / corners.iter().map(|(_, weight)| weight * weight).sum::<f64>().sqrt()
}

/// The orthophoto of a scene years later: squares of it show another town, the light is another.
fn changed(scene: &BlockScene, seed: u32, flight: &BlockFlight, fault: Fault) -> Orthophoto {
    let own = scene.orthophoto(GSD_M).expect("an orthophoto of less than 100 MP");
    let other = BlockScene::new(&BlockFlight { seed: seed + 500, ..flight.clone() }).and_then(|scene| scene.orthophoto(GSD_M));
    let other = other.and_then(|other| other.grey()).expect("the orthophoto of another town");
    let before = own.grey().expect("less than 100 MP");
    let changes = if matches!(fault, Fault::Built) { MORE_CHANGES } else { CHANGES };
    let is_among = |column: usize, row: usize, what: u32, (side_m, share): (f64, f64)| {
        let [c, r] = [column, row].map(|k| (k as f64 * GSD_M / side_m) as usize);
        chance(seed, c, r, what) < share
    };
    let grey = |column: usize, row: usize| {
        let is_other = (0..).zip(changes).any(|(what, squares)| is_among(column, row, what, squares));
        let shown = if is_other { other.view().at(column % other.width(), row % other.height()) } else { before.view().at(column, row) };
        let is_crop = matches!(fault, Fault::Season) && is_among(column, row, 20, FIELDS);
        let crop = || 0.5 * (255.0 - f64::from(shown)) + 40.0 + TEXTURE_GREY * smooth(seed, column, row, TEXTURE_PX, 21);
        let value = if is_crop { crop() } else { f64::from(shown) };
        let noise = NOISE * (chance(seed, column, row, 8) + chance(seed, column, row, 9) - 1.0) * 2.4;
        (GAIN * value + OFFSET + noise).round().clamp(1.0, 255.0) as u8
    };
    let grey = GreyImage::from_fn(before.width(), before.height(), grey).expect("as large as it was");
    let heights = match fault {
        Fault::Heights => wrong_together(&own, seed),
        Fault::None | Fault::Built | Fault::Season => own.heights,
    };
    Orthophoto::new(grey, own.georeference, heights).expect("the place that it had")
}

/// The heights of an orthophoto with errors as large as stated that neighbours share.
fn wrong_together(own: &Orthophoto, seed: u32) -> Heights {
    let [width, height] = own.size();
    let wrong = |k: usize| {
        let (column, row) = (k % width, k / width);
        let right = own.heights.at(own.georeference.ground([column as f64 + 0.5, row as f64 + 0.5]));
        right.map_or(f32::NAN, |right| (right + HEIGHT_M * smooth(seed, column, row, TOGETHER_M / GSD_M, 31)) as f32)
    };
    let model = HeightModel::new(width, height, (0..width * height).map(wrong).collect(), own.georeference);
    Heights::Model(model.expect("heights of the earth"))
}

/// The photos of a scene with the block that they make.
struct Photos {
    files: Vec<PathBuf>,
    run: BlockRun,
}

impl Photos {
    fn new(scene: &BlockScene, folder: &Path) -> Self {
        fs::create_dir_all(folder).expect("a folder for the photos");
        let photo = |index: usize| {
            let path = folder.join(format!("photo_{index:05}.png"));
            fs::write(&path, scene.photo_file(index).expect("a photo of the flight")).expect("room for the photos");
            path
        };
        let files: Vec<_> = (0..scene.photos()).map(photo).collect();
        let run = run_block(&files, &[], RunInput::default(), &folder.join("work"), 2, drop).expect("a block that can be oriented");
        Self { files, run }
    }

    /// The block on an orthophoto.
    fn placed(&self, reference: &Orthophoto, area: &SearchArea, options: &PlacingOptions) -> BlockRun {
        let mut links = BlockLinks::default();
        for (index, path) in self.files.iter().enumerate() {
            let bytes = fs::read(path).expect("the photo that was written");
            let grey = decode(&bytes, &DecodeLimits::default()).expect("a PNG").grey;
            links.place(&self.run, index, grey.view(), reference, area, options).expect("an image of the block");
        }
        links.linked(&self.run, reference, options).expect("a block without ground control points")
    }
}

/// Errors of the centres of a block by what is asked of them: half a pixel of the orthophoto in plan, and in height that times the factor by which the
/// covariance of the centre foretells its height to be less precise than its place in plan, σZ / √((σX² + σY²) / 2).
#[derive(Default)]
struct Asked {
    ratios: [Vec<f64>; 3],
    factors: Vec<f64>,
}

impl Asked {
    fn add(&mut self, error: [f64; 3], standard_errors: [f64; 3]) {
        let [x, y, z] = standard_errors;
        let factor = z / (0.5 * (x * x + y * y)).sqrt();
        self.factors.push(factor);
        for ((ratios, error), factor) in self.ratios.iter_mut().zip(error).zip([1.0, 1.0, factor]) {
            ratios.push(error.abs() / (ASKED_PX * GSD_M * factor));
        }
    }

    /// Says them, and gives the number of those along each axis that are within.
    fn print(mut self) -> [usize; 3] {
        self.ratios.iter_mut().chain([&mut self.factors]).for_each(|all| all.sort_by(f64::total_cmp));
        let at = |all: &[f64], share: f64| all[((all.len() - 1) as f64 * share).round() as usize];
        let [x, y, z] = self.ratios.each_ref().map(|all| [0.5, 0.95, 1.0].map(|share| at(all, share)));
        println!(
            "    errors of centres by {ASKED_PX} px of the orthophoto, of Z times {:.1}: median, 95 %, worst of X {x:.2?}, Y {y:.2?}, Z {z:.2?}",
            at(&self.factors, 0.5)
        );
        self.ratios.map(|all| all.iter().filter(|ratio| **ratio <= 1.0).count())
    }
}

/// Sums of squares of X, Y, Z, ω, φ, κ of all images, of the focal lengths of all blocks, and of their changes by the orthophoto: of errors, and of
/// these by their standard errors. A block has one focal length, and errors of Z follow it: of few blocks their mean is that of few numbers.
#[derive(Default)]
struct Sums {
    errors: [f64; 8],
    ratios: [f64; 8],
    /// Coordinates of centres that are off by no more than is asked.
    within: [usize; 3],
    images: usize,
    linked: usize,
}

impl Sums {
    fn add(&mut self, k: usize, error: f64, standard_error: f64) {
        self.errors[k] += error * error;
        self.ratios[k] += (error / standard_error).powi(2);
    }

    /// `before`: the block without the orthophoto.
    fn judge(&mut self, run: &BlockRun, before: &BlockRun, scene: &BlockScene) {
        let (truth, model) = (scene.truth(), &run.reconstruction.as_ref().expect("a block that is oriented").models[0]);
        let mut asked = Asked::default();
        for (image, statistics) in model.images.iter().zip(&model.adjusted.images) {
            let (Some(own), Some(known)) = (run.model.images[*image].pose, truth.images[*image].pose) else { continue };
            let (angles, true_angles) = (own.angles(), known.angles());
            let (place, turn) = (statistics.position_errors.expect("statistics"), statistics.angle_errors_deg.expect("statistics"));
            for k in 0..3 {
                self.add(k, own.position[k] - known.position[k], place[k]);
                // An angle near ±180° may be either.
                let apart = (angles[k] - true_angles[k]).to_degrees();
                self.add(3 + k, (apart + 180.0).rem_euclid(360.0) - 180.0, turn[k]);
            }
            asked.add([0, 1, 2].map(|k| own.position[k] - known.position[k]), place);
            self.images += 1;
        }
        self.within.iter_mut().zip(asked.print()).for_each(|(all, own)| *all += own);
        let focal = model.adjusted.cameras[0].standard_errors[0].expect("a focal length that was estimated");
        let off = model.adjusted.block.cameras[0].focal_px - truth.cameras[0].focal_px;
        self.add(6, off, focal);
        let before = &before.reconstruction.as_ref().expect("a block that is oriented").models[0].adjusted;
        let change = model.adjusted.block.cameras[0].focal_px - before.block.cameras[0].focal_px;
        let alone = before.cameras[0].standard_errors[0].expect("a focal length that was estimated");
        self.add(7, change, (alone * alone - focal * focal).max(0.0).sqrt());
        self.linked += 1;
        let checks: Vec<_> = model.surveyed.iter().filter(|point| point.role == ControlRole::Check).collect();
        let root = |of: &dyn Fn(&SurveyedPoint, usize) -> f64, k: usize| {
            (checks.iter().map(|point| of(point, k).powi(2)).sum::<f64>() / checks.len() as f64).sqrt()
        };
        let differences = [0, 1, 2].map(|k| root(&|point, k| point.difference_m[k], k));
        let ratios = [0, 1, 2].map(|k| root(&|point, k| point.difference_m[k] / point.standard_errors_m[k].unwrap_or(f64::NAN), k));
        println!(
            "    focal length {off:.2} px off, standard error {focal:.2} px; check points, RMSE of X Y Z {differences:.3?} m, by standard errors {ratios:.2?}"
        );
    }

    fn mean(&self, of: &[f64; 8]) -> [f64; 8] {
        let mut mean = of.map(|sum| sum / self.images.max(1) as f64);
        [6, 7].iter().for_each(|k| mean[*k] = of[*k] / self.linked.max(1) as f64);
        mean
    }

    /// The shares of the coordinates of centres that are off by no more than is asked.
    fn shares(&self) -> [f64; 3] {
        self.within.map(|within| within as f64 / self.images.max(1) as f64)
    }

    /// Whether errors are as large as their standard errors say, within what chance does to so few blocks: the images of one err together.
    ///
    /// # Source
    /// Wilson & Hilferty 1931 (quantiles of χ²).
    fn is_held(&self) -> bool {
        let scatter = 2.0 / (9.0 * self.linked.max(1) as f64);
        let quantile = |deviate: f64| (1.0 - scatter + deviate * scatter.sqrt()).max(0.0).powi(3);
        let held = HELD[0] * quantile(-BY_CHANCE)..=HELD[1] * quantile(BY_CHANCE);
        self.mean(&self.ratios).iter().all(|mean| held.contains(mean))
    }

    fn print(&self, name: &str, blocks: u32) {
        let [x, y, z, omega, phi, kappa, focal, change] = self.mean(&self.errors).map(f64::sqrt);
        println!("  {name}: {} of {blocks} blocks linked", self.linked);
        println!(
            "    RMS error of centres X {x:.3}, Y {y:.3}, Z {z:.3} m, of ω {omega:.4}, φ {phi:.4}, κ {kappa:.4}°, of f {focal:.2} px, which the orthophoto changed by {change:.2} px"
        );
        let [x, y, z] = self.shares().map(|share| 100.0 * share);
        println!(
            "    within {ASKED_PX} px of the orthophoto, of Z times the factor of each image: X {x:.0} %, Y {y:.0} %, Z {z:.0} % of the centres"
        );
        println!("    mean square of error by standard error X Y Z ω φ κ f, change of f {:.2?}", self.mean(&self.ratios));
    }
}

/// Photos of other towns that are placed, of so many.
fn strangers(reference: &Orthophoto, area: &SearchArea, options: &PlacingOptions, seed: u32, photos: usize) -> usize {
    let scene = BlockScene::new(&flight(seed + 1000, 5, photos.div_ceil(5))).expect("a flight that can be flown");
    let camera = scene.truth().cameras[0];
    let is_placed = |index: &usize| {
        let photo = scene.photo(*index).expect("a photo of the flight");
        let known = PlacingCamera { camera, uncertainty: CameraUncertainty::EXIF, decentring: None };
        let found = place_image(photo.view(), &known, reference, area, options).expect("a camera as large as the photo");
        !matches!(found.verdict, PlacingVerdict::NotPlaced { .. })
    };
    (0..photos).filter(is_placed).count()
}

fn main() -> ExitCode {
    let numbers: Vec<u32> = std::env::args().skip(1).filter_map(|word| word.parse().ok()).collect();
    let given = |k: usize, standard: u32| numbers.get(k).copied().unwrap_or(standard);
    let (first, seeds, photos, strips, exposures) = (given(0, 1), given(1, 1), given(2, 50), given(3, 5), given(4, 6));
    let mut all = FAULTS.map(|_| Sums::default());
    let mut wrong = 0;
    for seed in first..first + seeds {
        let flight = flight(seed, strips as usize, exposures as usize);
        let scene = BlockScene::new(&flight).expect("a flight that can be flown");
        let folder = std::env::temp_dir().join(format!("tiepoint-orthophoto-block-{}-{seed}", std::process::id()));
        let block = Photos::new(&scene, &folder);
        for ((fault, name), sums) in FAULTS.iter().zip(&mut all) {
            let reference = changed(&scene, seed, &flight, *fault);
            let [width, height] = reference.size().map(|side| side as f64);
            let [x, y] = reference.georeference.ground([0.5 * width, 0.5 * height]);
            let reach = GSD_M * width.max(height);
            let off = OFF_M / std::f64::consts::SQRT_2;
            let options =
                PlacingOptions { near_x: Some(x + off), near_y: Some(y - off), within_m: 0.5 * reach + OFF_M, ..PlacingOptions::default() };
            let area = SearchArea::new(&reference, &options).expect("a place on the orthophoto");
            let run = block.placed(&reference, &area, &options);
            let outcome = run.orthophoto.clone().expect("an orthophoto was given");
            println!("  seed {seed}, {name}: {} photos. {outcome} {}", scene.photos(), BlockVerdict::of(&run));
            if matches!(outcome, OnOrthophoto::Linked { .. }) {
                sums.judge(&run, &block.run, &scene);
            }
            if seed == first && photos > 0 && matches!(fault, Fault::None) {
                wrong = strangers(&reference, &area, &options, seed, photos as usize);
            }
        }
        fs::remove_dir_all(&folder).expect("the folder that was made");
    }
    FAULTS.iter().zip(&all).for_each(|((_, name), sums)| sums.print(name, seeds));
    println!("  photos of other towns: {photos}, of which {wrong} were placed");
    if all.iter().all(|sums| sums.linked == seeds as usize && sums.is_held()) && wrong == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
