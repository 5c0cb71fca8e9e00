//! A simulated block in the system of an orthophoto of its ground, of which much has changed: errors beside standard errors. Then photos of other
//! towns, none of which may be placed. Arguments: first seed, number of seeds, photos of other towns.

use std::fs;
use std::process::ExitCode;
use tiepoint::{
    BlockFlight, BlockLinks, BlockRun, BlockScene, CameraUncertainty, ControlRole, DecodeLimits, GreyImage, OnOrthophoto, Orthophoto,
    PlacingCamera, PlacingOptions, PlacingVerdict, RunInput, SearchArea, decode, place_image, run_block,
};

/// Side of a pixel of the orthophoto in m.
const GSD_M: f64 = 0.5;
/// What has changed: squares of so many m a side, of which this share shows another town.
const CHANGES: [(f64, f64); 2] = [(60.0, 0.2), (12.0, 0.1)];
/// Other light, and noise in grey values.
const GAIN: f64 = 0.75;
const OFFSET: f64 = 35.0;
const NOISE: f64 = 4.0;
/// The rough position is so far off along both axes together, and the search goes as far beyond the block.
const OFF_M: f64 = 300.0;

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

/// The orthophoto of a scene years later: squares of it show another town, the light is another.
fn changed(scene: &BlockScene, seed: u32, flight: &BlockFlight) -> Orthophoto {
    let own = scene.orthophoto(GSD_M).expect("an orthophoto of less than 100 MP");
    let other = BlockScene::new(&BlockFlight { seed: seed + 500, ..flight.clone() }).and_then(|scene| scene.orthophoto(GSD_M));
    let other = other.and_then(|other| other.grey()).expect("the orthophoto of another town");
    let before = own.grey().expect("less than 100 MP");
    let grey = |column: usize, row: usize| {
        let is_other = (0..).zip(CHANGES).any(|(what, (side_m, share))| {
            let [c, r] = [column, row].map(|k| (k as f64 * GSD_M / side_m) as usize);
            chance(seed, c, r, what) < share
        });
        let value = if is_other { other.view().at(column % other.width(), row % other.height()) } else { before.view().at(column, row) };
        let noise = NOISE * (chance(seed, column, row, 8) + chance(seed, column, row, 9) - 1.0) * 2.4;
        (GAIN * f64::from(value) + OFFSET + noise).round().clamp(1.0, 255.0) as u8
    };
    let grey = GreyImage::from_fn(before.width(), before.height(), grey).expect("as large as it was");
    Orthophoto::new(grey, own.georeference, own.heights).expect("the place that it had")
}

/// Runs the block of a scene, and places it.
fn placed(scene: &BlockScene, reference: &Orthophoto, area: &SearchArea, options: &PlacingOptions, seed: u32) -> BlockRun {
    let folder = std::env::temp_dir().join(format!("tiepoint-orthophoto-block-{}-{seed}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder for the photos");
    let photo = |index: usize| {
        let path = folder.join(format!("photo_{index:05}.png"));
        fs::write(&path, scene.photo_file(index).expect("a photo of the flight")).expect("room for the photos");
        path
    };
    let photos: Vec<_> = (0..scene.photos()).map(photo).collect();
    let run = run_block(&photos, &[], RunInput::default(), &folder.join("work"), 2, drop).expect("a block that can be oriented");
    let mut links = BlockLinks::default();
    for (index, path) in photos.iter().enumerate() {
        let bytes = fs::read(path).expect("the photo that was written");
        let grey = decode(&bytes, &DecodeLimits::default()).expect("a PNG").grey;
        links.place(&run, index, grey.view(), reference, area, options).expect("an image of the block");
    }
    let found = links.linked(&run, reference, options).expect("a block without ground control points");
    fs::remove_dir_all(&folder).expect("the folder that was made");
    found
}

/// Sums of squares of X, Y, Z, ω, φ, κ: of errors, and of these by their standard errors.
#[derive(Default)]
struct Sums {
    errors: [f64; 6],
    ratios: [f64; 6],
    images: usize,
}

fn judge(run: &BlockRun, scene: &BlockScene, sums: &mut Sums) {
    let (truth, model) = (scene.truth(), &run.reconstruction.as_ref().expect("a block that is oriented").models[0]);
    for (image, statistics) in model.images.iter().zip(&model.adjusted.images) {
        let (Some(own), Some(known)) = (run.model.images[*image].pose, truth.images[*image].pose) else { continue };
        let (angles, true_angles) = (own.angles(), known.angles());
        let (place, turn) = (statistics.position_errors.expect("statistics"), statistics.angle_errors_deg.expect("statistics"));
        for k in 0..3 {
            let (off, turned) = (own.position[k] - known.position[k], (angles[k] - true_angles[k]).to_degrees());
            (sums.errors[k], sums.errors[3 + k]) = (sums.errors[k] + off * off, sums.errors[3 + k] + turned * turned);
            (sums.ratios[k], sums.ratios[3 + k]) =
                (sums.ratios[k] + off / place[k] * (off / place[k]), sums.ratios[3 + k] + turned / turn[k] * (turned / turn[k]));
        }
        sums.images += 1;
    }
    let checks: Vec<_> = model.surveyed.iter().filter(|point| point.role == ControlRole::Check).collect();
    let root =
        |k: usize| (checks.iter().map(|point| point.difference_m[k] * point.difference_m[k]).sum::<f64>() / checks.len() as f64).sqrt();
    println!("    check points, RMSE of X Y Z {:.3?} m", [0, 1, 2].map(root));
}

/// Photos of other towns that are placed, of so many.
fn strangers(reference: &Orthophoto, area: &SearchArea, options: &PlacingOptions, seed: u32, photos: usize) -> usize {
    let scene = BlockScene::new(&flight(seed + 1000, 5, photos.div_ceil(5))).expect("a flight that can be flown");
    let camera = scene.truth().cameras[0];
    let is_placed = |index: &usize| {
        let photo = scene.photo(*index).expect("a photo of the flight");
        let known = PlacingCamera { camera, uncertainty: CameraUncertainty::EXIF };
        let found = place_image(photo.view(), &known, reference, area, options).expect("a camera as large as the photo");
        !matches!(found.verdict, PlacingVerdict::NotPlaced { .. })
    };
    (0..photos).filter(is_placed).count()
}

fn main() -> ExitCode {
    let numbers: Vec<u32> = std::env::args().skip(1).filter_map(|word| word.parse().ok()).collect();
    let [first, seeds, photos] = [(0, 1), (1, 1), (2, 50)].map(|(k, standard)| numbers.get(k).copied().unwrap_or(standard));
    let (mut sums, mut linked) = (Sums::default(), 0);
    let mut wrong = 0;
    for seed in first..first + seeds {
        let flight = flight(seed, 5, 6);
        let scene = BlockScene::new(&flight).expect("a flight that can be flown");
        let reference = changed(&scene, seed, &flight);
        let [width, height] = reference.size().map(|side| side as f64);
        let [x, y] = reference.georeference.ground([0.5 * width, 0.5 * height]);
        let reach = GSD_M * width.max(height);
        let off = OFF_M / std::f64::consts::SQRT_2;
        let options =
            PlacingOptions { near_x: Some(x + off), near_y: Some(y - off), within_m: 0.5 * reach + OFF_M, ..PlacingOptions::default() };
        let area = SearchArea::new(&reference, &options).expect("a place on the orthophoto");
        let run = placed(&scene, &reference, &area, &options, seed);
        let outcome = run.orthophoto.clone().expect("an orthophoto was given");
        println!("  seed {seed}: {} photos. {outcome}", scene.photos());
        if matches!(outcome, OnOrthophoto::Linked { .. }) {
            linked += 1;
            judge(&run, &scene, &mut sums);
        }
        if seed == first {
            wrong = strangers(&reference, &area, &options, seed, photos as usize);
        }
    }
    let mean = |of: &[f64; 6]| of.map(|sum| sum / sums.images.max(1) as f64);
    let [x, y, z, omega, phi, kappa] = mean(&sums.errors).map(f64::sqrt);
    println!(
        "  {linked} of {seeds} blocks linked; RMS error of centres X {x:.3}, Y {y:.3}, Z {z:.3} m, of ω {omega:.4}, φ {phi:.4}, κ {kappa:.4}°"
    );
    println!("  mean square of error by standard error X Y Z ω φ κ {:.2?}", mean(&sums.ratios));
    println!("  photos of other towns: {photos}, of which {wrong} were placed");
    if linked == seeds as usize && wrong == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
