//! Photos placed on an orthophoto of the scene that they show: errors beside standard errors; with heights that are not those of the scene; and photos of
//! another scene, which must not be placed. Arguments: first seed, number of seeds.

use std::process::ExitCode;
use tiepoint::{
    BlockFlight, BlockScene, BlockView, Camera, CameraUncertainty, HeightModel, Heights, Orthophoto, PlacingCamera, PlacingOptions,
    PlacingVerdict, SearchArea, place_image,
};

const CALIBRATED: CameraUncertainty = CameraUncertainty { focal: 0.0, principal_point: 0.0, k1: 0.0 };

/// Cameras as they are known: the uncertainty, and the factor by which the focal length is off.
const CAMERAS: [(&str, CameraUncertainty, f64); 2] = [("calibrated", CALIBRATED, 1.0), ("EXIF", CameraUncertainty::EXIF, 0.97)];

fn flights(seed: u32) -> [(&'static str, BlockFlight); 3] {
    let town = BlockFlight { strips: 2, exposures: 2, width_px: 800, height_px: 600, pixel_mm: 0.045, seed, ..BlockFlight::default() };
    let open = BlockFlight { buildings: 0.0, trees: 200.0, relief_m: 80.0, ..town.clone() };
    let oblique = BlockFlight { view: BlockView::Oblique, strips: 1, exposures: 1, pixel_mm: 0.03, ..town.clone() };
    [("town", town), ("open", open), ("oblique", oblique)]
}

/// What came of the photos of one kind.
#[derive(Default)]
struct Tally {
    photos: usize,
    placed: usize,
    weak: usize,
    /// Called placed, and off by more than ten standard errors or 1°.
    wrong: usize,
    /// Squares of errors by standard errors, of X, Y, Z, ω, φ, κ.
    squares: [Vec<f64>; 6],
}

fn trial(scene: &BlockScene, index: usize, area: &(Orthophoto, SearchArea), camera: &(&str, CameraUncertainty, f64), tally: &mut Tally) {
    let (truth, options) = (scene.truth(), options());
    let true_camera = truth.cameras[truth.images[index].camera];
    let known = PlacingCamera {
        camera: Camera { focal_px: camera.2 * true_camera.focal_px, ..true_camera },
        uncertainty: camera.1,
        decentring: None,
    };
    let photo = scene.photo(index).expect("a photo of the flight");
    let found = place_image(photo.view(), &known, &area.0, &area.1, &options).expect("a camera as large as the photo");
    tally.photos += 1;
    let is_placed = matches!(found.verdict, PlacingVerdict::Placed { .. });
    (tally.placed, tally.weak) =
        (tally.placed + usize::from(is_placed), tally.weak + usize::from(matches!(found.verdict, PlacingVerdict::Weak { .. })));
    let (Some(placement), Some(truth)) = (found.placement, truth.images[index].pose) else {
        println!("    {index} {}", found.verdict);
        return;
    };
    let (angles, true_angles) = (placement.pose.angles(), truth.angles());
    let turns = placement.angle_errors_deg.unwrap_or([f64::NAN; 3]);
    let shifts = placement.position_errors_m.unwrap_or([f64::NAN; 3]);
    let mut ratios = [0.0; 6];
    for k in 0..3 {
        ratios[k] = (placement.pose.position[k] - truth.position[k]) / shifts[k];
        ratios[3 + k] = (angles[k] - true_angles[k]).to_degrees() / turns[k];
    }
    let turned = (0..3).map(|k| (angles[k] - true_angles[k]).to_degrees().abs()).fold(0.0, f64::max);
    tally.wrong += usize::from(is_placed && (ratios.iter().any(|ratio| !(ratio.abs() <= 10.0)) || turned > 1.0));
    println!("    {index} {} ratios {ratios:.2?} SE {shifts:.3?}", found.verdict);
    tally.squares.iter_mut().zip(ratios).for_each(|(all, ratio)| all.push(ratio * ratio));
}

/// A height by the right one and that of the place across the middle, about their mean.
type WrongHeight = fn(f64, f64) -> f64;

/// Heights that are not those of the scene.
const WRONG_HEIGHTS: [(&str, WrongHeight); 5] = [
    ("feet taken as metres", |own, _| 3.28084 * own),
    ("metres taken as feet", |own, _| 0.3048 * own),
    ("half of them", |own, _| 0.5 * own),
    ("one level", |_, _| 0.0),
    ("those of other ground", |_, other| other),
];

/// An orthophoto with other heights.
fn with_heights(orthophoto: &Orthophoto, height: WrongHeight) -> Orthophoto {
    let (georeference, [width, height_px]) = (orthophoto.georeference, orthophoto.size());
    let at = |k: usize| {
        let position = [(k % width) as f64 + 0.5, (k / width) as f64 + 0.5];
        orthophoto.heights.at(georeference.ground(position)).expect("heights everywhere")
    };
    let own: Vec<f64> = (0..width * height_px).map(at).collect();
    let mean = own.iter().sum::<f64>() / own.len() as f64;
    let other = own.iter().rev();
    let values = own.iter().zip(other).map(|(own, other)| (mean + height(own - mean, other - mean)) as f32).collect();
    let model = HeightModel::new(width, height_px, values, georeference).expect("heights of the earth");
    Orthophoto::new(orthophoto.grey().expect("less than 100 MP"), georeference, Heights::Model(model)).expect("a place")
}

fn options() -> PlacingOptions {
    PlacingOptions { points: 4000, ..PlacingOptions::default() }
}

fn main() -> ExitCode {
    let numbers: Vec<u32> = std::env::args().skip(1).filter_map(|word| word.parse().ok()).collect();
    let (first, seeds) = (numbers.first().copied().unwrap_or(1), numbers.get(1).copied().unwrap_or(2));
    let mut wrong = 0;
    for kind in 0..flights(first).len() {
        for camera in &CAMERAS {
            let mut tally = Tally::default();
            let name = flights(first)[kind].0;
            println!("{name}, {}", camera.0);
            for seed in first..first + seeds {
                let scene = BlockScene::new(&flights(seed)[kind].1).expect("a flight that can be flown");
                let orthophoto = scene.orthophoto(0.5).expect("an orthophoto of less than 100 MP");
                let area = SearchArea::new(&orthophoto, &options()).expect("options within their ranges");
                let area = (orthophoto, area);
                (0..scene.photos()).for_each(|index| trial(&scene, index, &area, camera, &mut tally));
            }
            let mean = tally.squares.each_ref().map(|all| all.iter().sum::<f64>() / all.len().max(1) as f64);
            println!(
                "{name}, {}: {} photos, {} placed, {} weak, {} wrong; mean square of error by standard error X Y Z ω φ κ {mean:.2?}",
                camera.0, tally.photos, tally.placed, tally.weak, tally.wrong
            );
            wrong += tally.wrong;
        }
    }
    for (name, height) in WRONG_HEIGHTS {
        let mut tally = Tally::default();
        println!("calibrated, {name}");
        for (kind, seed) in [0, 1].into_iter().flat_map(|kind| (first..first + seeds).map(move |seed| (kind, seed))) {
            let scene = BlockScene::new(&flights(seed)[kind].1).expect("a flight that can be flown");
            let orthophoto = with_heights(&scene.orthophoto(0.5).expect("an orthophoto of less than 100 MP"), height);
            let area = SearchArea::new(&orthophoto, &options()).expect("options within their ranges");
            let area = (orthophoto, area);
            (0..scene.photos()).for_each(|index| trial(&scene, index, &area, &CAMERAS[0], &mut tally));
        }
        println!(
            "town and open, calibrated, {name}: {} photos, {} placed, {} weak; {} placed and off by more than ten standard errors or 1°",
            tally.photos, tally.placed, tally.weak, tally.wrong
        );
    }
    // Photos of one town on the orthophoto of another.
    let other = BlockScene::new(&flights(first + 1000)[0].1).expect("a flight that can be flown");
    let orthophoto = other.orthophoto(0.5).expect("an orthophoto of less than 100 MP");
    let area = SearchArea::new(&orthophoto, &options()).expect("options within their ranges");
    let area = (orthophoto, area);
    let mut strangers = Tally::default();
    for seed in first..first + seeds {
        let scene = BlockScene::new(&flights(seed)[0].1).expect("a flight that can be flown");
        (0..scene.photos()).for_each(|index| trial(&scene, index, &area, &CAMERAS[1], &mut strangers));
    }
    println!("photos of other towns: {} photos, {} placed, {} weak", strangers.photos, strangers.placed, strangers.weak);
    if wrong + strangers.placed + strangers.weak > 0 { ExitCode::FAILURE } else { ExitCode::SUCCESS }
}
