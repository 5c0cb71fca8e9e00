//! Photos of simulated towns placed on coarser and finer orthophotos with a calibrated camera: errors beside standard errors; and by how much links make the
//! image larger, where houses stand about them and where none does. Arguments: first seed, number of seeds, GSD of the orthophotos in m, pixel of the photos
//! in mm.

use std::process::ExitCode;
use tiepoint::{
    BlockFlight, BlockScene, Camera, CameraUncertainty, Heights, Link, LinkUse, Orthophoto, PlacingCamera, PlacingOptions, Pose,
    SearchArea, place_image,
};

/// The mean square of errors by their standard errors is no larger, and so many standard deviations of its own beyond.
const HELD: f64 = 1.3;
const BEYOND_CHANCE: f64 = 2.0;
/// Links make an image larger by no more, in ppm.
const MOST_PPM: f64 = 50.0;
/// Half of the side of a window of least squares matching in px, and the range of heights in it, in m, of ground without houses.
const HALF_PX: i32 = 10;
const EVEN_M: f64 = 2.0;

/// How much larger links make an image, by least squares of their errors along their distance from the principal point.
#[derive(Default)]
struct Scale {
    links: usize,
    product: f64,
    square: f64,
}

impl Scale {
    /// `error`: where the link lies minus where the true orientation sees its place; `from_middle`: of that.
    fn add(&mut self, error: [f64; 2], from_middle: [f64; 2]) {
        self.links += 1;
        self.product += error[0] * from_middle[0] + error[1] * from_middle[1];
        self.square += from_middle[0] * from_middle[0] + from_middle[1] * from_middle[1];
    }

    fn ppm(&self) -> f64 {
        1e6 * self.product / self.square
    }
}

/// Errors by standard errors, of X, Y, Z, ω, φ, κ of each photo; and links by whether houses stand about them.
#[derive(Default)]
struct Tally {
    ratios: Vec<[f64; 6]>,
    errors_m: Vec<[f64; 3]>,
    even: Scale,
    built: Scale,
}

impl Tally {
    fn mean(&self, of: impl Fn(f64) -> f64) -> [f64; 6] {
        std::array::from_fn(|k| self.ratios.iter().map(|ratios| of(ratios[k])).sum::<f64>() / self.ratios.len().max(1) as f64)
    }

    fn add(&mut self, scene: &BlockScene, index: usize, reference: &Orthophoto, area: &SearchArea) {
        let truth = scene.truth();
        let (camera, pose) = (truth.cameras[truth.images[index].camera], truth.images[index].pose.expect("a true pose"));
        let known = PlacingCamera { camera, uncertainty: CameraUncertainty::NONE, decentring: None };
        let photo = scene.photo(index).expect("a photo of the flight");
        let found = place_image(photo.view(), &known, reference, area, &options()).expect("a camera as large as the photo");
        let Some(placement) = found.placement else { return println!("    {index} {}", found.verdict) };
        let (shifts, turns) = (placement.position_errors_m.expect("statistics"), placement.angle_errors_deg.expect("statistics"));
        let (angles, true_angles) = (placement.pose.angles(), pose.angles());
        let errors_m = [0, 1, 2].map(|k| placement.pose.position[k] - pose.position[k]);
        let turned = [0, 1, 2].map(|k| (angles[k] - true_angles[k]).to_degrees() / turns[k]);
        let ratios = std::array::from_fn(|k| if k < 3 { errors_m[k] / shifts[k] } else { turned[k - 3] });
        println!("    {index} ratios {ratios:.2?} SE {shifts:.3?}, {} links", placement.links.len());
        self.ratios.push(ratios);
        self.errors_m.push(errors_m);
        for link in placement.links.iter().filter(|link| link.role != LinkUse::Rejected) {
            let (error, from_middle) = error_of(link, &camera, &pose);
            let scale = if is_even(link, reference) { &mut self.even } else { &mut self.built };
            scale.add(error, from_middle);
        }
    }
}

fn error_of(link: &Link, camera: &Camera, pose: &Pose) -> ([f64; 2], [f64; 2]) {
    let [u, v, w] = pose.to_photo(&link.place);
    let from_middle = [-camera.focal_px * u / w, camera.focal_px * v / w];
    ([0, 1].map(|k| link.at[k] - camera.principal_point_px[k] - from_middle[k]), from_middle)
}

/// Whether the heights within the window about a link differ by little.
fn is_even(link: &Link, reference: &Orthophoto) -> bool {
    let gsd = reference.georeference.gsd();
    let around = || (-HALF_PX..=HALF_PX).map(|k| f64::from(k) * gsd);
    let heights = around().flat_map(|y| around().map(move |x| [x, y])).filter_map(|[x, y]| {
        let Heights::Model(model) = &reference.heights else { return None };
        model.at([link.place[0] + x, link.place[1] + y])
    });
    let [low, high] = heights.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], z| [low.min(z), high.max(z)]);
    high - low < EVEN_M
}

/// Heights are exact up to rounding.
const HEIGHT_M: f64 = 0.05;

fn options() -> PlacingOptions {
    PlacingOptions { points: 4000, height_sigma_m: Some(HEIGHT_M), ..PlacingOptions::default() }
}

fn main() -> ExitCode {
    let numbers: Vec<f64> = std::env::args().skip(1).filter_map(|word| word.parse().ok()).collect();
    let number = |k: usize, usual: f64| numbers.get(k).copied().unwrap_or(usual);
    let (first, seeds) = (number(0, 1.0) as u32, number(1, 6.0) as u32);
    let (gsd, pixel_mm) = (number(2, 0.8), number(3, 0.06));
    let mut tally = Tally::default();
    for seed in first..first + seeds {
        let flight = BlockFlight { strips: 2, exposures: 2, width_px: 800, height_px: 600, pixel_mm, seed, ..BlockFlight::default() };
        let scene = BlockScene::new(&flight).expect("a flight that can be flown");
        let orthophoto = scene.orthophoto(gsd).expect("an orthophoto of less than 100 MP");
        let area = SearchArea::new(&orthophoto, &options()).expect("options within their ranges");
        println!("  seed {seed}");
        (0..scene.photos()).for_each(|index| tally.add(&scene, index, &orthophoto, &area));
    }
    let squares = tally.mean(|ratio| ratio * ratio);
    let photos = tally.ratios.len();
    let rms_m = [0, 1, 2].map(|k| (tally.errors_m.iter().map(|error| error[k] * error[k]).sum::<f64>() / photos.max(1) as f64).sqrt());
    println!(
        "{photos} photos, pixel {pixel_mm} mm, orthophoto {gsd} m: of X Y Z ω φ κ mean of error by standard error {:.2?}, mean square {squares:.2?}; RMS of X Y Z {rms_m:.3?} m",
        tally.mean(|ratio| ratio)
    );
    for (name, scale) in [("without houses", &tally.even), ("with houses", &tally.built)] {
        println!("{} links {name} about them make the image larger by {:.1} ppm", scale.links, scale.ppm());
    }
    let most = HELD + BEYOND_CHANCE * (2.0 / photos as f64).sqrt();
    let is_as_large = [&tally.even, &tally.built].iter().all(|scale| scale.links == 0 || scale.ppm().abs() <= MOST_PPM);
    if photos > 0 && squares.iter().all(|square| *square <= most) && is_as_large { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
