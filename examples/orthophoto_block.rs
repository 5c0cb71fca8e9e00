//! Simulated blocks in the system of orthophotos of their ground, of which much has changed: errors beside standard errors. Then photos of other
//! towns, none of which may be placed. Arguments: first seed, number of seeds, photos of other towns, strips, exposures per strip.

mod later;

use later::{FAULTS, Fault, GSD_M, Ground, TOGETHER_M};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use tiepoint::{
    BlockFlight, BlockLinks, BlockRun, BlockScene, BlockVerdict, CameraUncertainty, ControlRole, DecodeLimits, OnOrthophoto, Orthophoto,
    PlacingCamera, PlacingOptions, PlacingVerdict, RunInput, SearchArea, SurveyedPoint, decode, place_image, run_block,
};

/// The rough position is so far off along both axes together, and the search goes as far beyond the block.
const OFF_M: f64 = 300.0;
/// Errors of centres are to be at most so many pixels of the orthophoto, in height times the factor that their covariance says.
const ASKED_PX: f64 = 0.5;
/// What the mean square of errors by their standard errors is, and the normal deviate of the chance that so few blocks give more, or less.
const HELD: [f64; 2] = [0.8, 1.3];
const BY_CHANCE: f64 = 3.09;

fn flight(seed: u32, strips: usize, exposures: usize) -> BlockFlight {
    BlockFlight { strips, exposures, width_px: 800, height_px: 600, pixel_mm: 0.045, seed, ..BlockFlight::default() }
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
        let ground = Ground::new(&scene, &flight);
        for ((fault, name), sums) in FAULTS.iter().zip(&mut all) {
            let reference = ground.later(*fault, TOGETHER_M);
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
