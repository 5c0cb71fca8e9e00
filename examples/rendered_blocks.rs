//! Blocks of rendered photos beside their truth: `cargo run --release --example rendered_blocks -- FOLDER [SEEDS] [PART OF A KIND'S NAME] [--from SEED] [--shared SIGMAS] [--each]`.
//!
//! Photos are rendered once and matched once; FOLDER keeps them and the rays that came of them, so that an adjustment that was changed is judged
//! in seconds. Each block is adjusted as a free network, by positions and by control points, from its true values: then its datum is that of
//! the truth. Printed are means of squares of errors by their standard errors; 1 is right. `--shared` takes the place of
//! the standard deviation of shared errors that is usual. With `--each` for each block.

#[path = "../tests/scene/normal.rs"]
mod normal;

use normal::Normal;
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use tiepoint::{
    AdjustmentOptions, AdjustmentResult, Block, BlockFlight, BlockObservation, BlockPreset, BlockScene, BlockSettings, ControlPoint, Datum,
    PositionPrior, RefinementMethod, RunInput, adjust_block, run_block,
};

type Failure = Box<dyn Error>;

fn main() -> Result<(), Failure> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let after = |name: &str| words.iter().position(|word| word == name).and_then(|at| words.get(at + 1));
    let first: u32 = after("--from").map_or(Ok(1), |word| word.parse())?;
    let given: Option<f64> = after("--shared").map(|word| word.parse()).transpose()?;
    let is_value = |k: usize| k > 0 && ["--from", "--shared"].contains(&words[k - 1].as_str());
    let plain: Vec<&String> = (0..words.len()).filter(|k| !words[*k].starts_with("--") && !is_value(*k)).map(|k| &words[k]).collect();
    let Some(folder) = plain.first() else { return Err("a folder for photos and rays is missing".into()) };
    let seeds: u32 = plain.get(1).map_or(Ok(5), |word| word.parse())?;
    let wanted = plain.get(2).map_or("", |word| word.as_str());
    let is_each = words.iter().any(|word| word == "--each");
    // Of unrefined blocks and of refined ones.
    let mut totals = [vec![Sums::default(); DATUMS.len()], vec![Sums::default(); DATUMS.len()]];
    for (draw, kind) in (0..).zip(kinds()).filter(|(_, kind)| kind.name.contains(wanted)) {
        let shared = given.unwrap_or_else(|| kind.settings().shared_errors());
        let mut sums = vec![Sums::default(); DATUMS.len()];
        for seed in first..first + seeds {
            let flight = BlockFlight { seed, ..kind.flight.clone() };
            let scene = BlockScene::new(&flight)?;
            let known = kept(&Path::new(folder).join(kind.name).join(seed.to_string()), &scene, &kind)?;
            for (datum, sums) in DATUMS.iter().zip(&mut sums) {
                let mut own = Sums::default();
                own.add(&known, &scene, (&flight, draw), *datum, shared)?;
                if is_each {
                    println!("{:24} {seed:4} {}", kind.name, own.line(*datum));
                }
                sums.join(&own);
            }
        }
        for (datum, sums) in DATUMS.iter().zip(&sums) {
            println!("{:24} {:2} blocks {}", kind.name, seeds, sums.line(*datum));
        }
        totals[usize::from(kind.is_refined)].iter_mut().zip(&sums).for_each(|(total, sums)| total.join(sums));
    }
    for (name, total) in ["all unrefined", "all refined"].into_iter().zip(&totals) {
        for (datum, sums) in DATUMS.iter().zip(total).filter(|(_, sums)| sums.sigma0.number > 0) {
            println!("{name:24} {:2} blocks {}", sums.sigma0.number, sums.line(*datum));
        }
    }
    Ok(())
}

const DATUMS: [Datum; 3] = [Datum::Free, Datum::Gnss, Datum::Control];

struct Kind {
    name: &'static str,
    flight: BlockFlight,
    is_refined: bool,
}

impl Kind {
    fn settings(&self) -> BlockSettings {
        let mut settings = BlockSettings::default();
        settings.refinement.method = if self.is_refined { RefinementMethod::LeastSquares } else { RefinementMethod::None };
        settings
    }
}

fn kinds() -> Vec<Kind> {
    let town = BlockFlight { strips: 3, exposures: 4, receiver_m: 0.0, ..BlockPreset::SmallPhotos.flight() };
    let open = BlockFlight { buildings: 0.0, trees: 0.0, ..town.clone() };
    let village = BlockFlight { buildings: 500.0, trees: 1500.0, forward_overlap: 0.8, side_overlap: 0.6, ..town.clone() };
    let high = BlockFlight { view: tiepoint::BlockView::TwoHeights, relief_m: 70.0, ..town.clone() };
    let kind = |name, flight: &BlockFlight, is_refined| Kind { name, flight: flight.clone(), is_refined };
    vec![
        kind("refined-town", &town, true),
        kind("refined-village", &village, true),
        kind("refined-open", &open, true),
        kind("refined-heights", &high, true),
        kind("town", &town, false),
        kind("village", &village, false),
        kind("open", &open, false),
        kind("heights", &high, false),
    ]
}

/// The rays of a block at its true values: of points those of the surface that their first ray meets.
fn kept(folder: &Path, scene: &BlockScene, kind: &Kind) -> Result<Block, Failure> {
    let file = folder.join("rays.json");
    if let Ok(text) = fs::read_to_string(&file) {
        return Ok(serde_json::from_str(&text)?);
    }
    let shared = folder.parent().and_then(Path::parent).unwrap_or(folder);
    let photos = shared.join(kind.name.trim_start_matches("refined-")).join(folder.file_name().unwrap_or_default()).join("photos");
    fs::create_dir_all(&photos)?;
    fs::create_dir_all(folder)?;
    let threads = std::thread::available_parallelism()?.get();
    let images: Vec<PathBuf> = (0..scene.photos()).map(|k| photos.join(format!("photo_{k:05}.png"))).collect();
    let rendered: Vec<Result<(), String>> = std::thread::scope(|scope| {
        let render = |start: usize| {
            let images = &images;
            move || {
                for k in (start..images.len()).step_by(threads) {
                    if !images[k].exists() {
                        let bytes = scene.photo_file(k).map_err(|error| error.to_string())?;
                        fs::write(&images[k], bytes).map_err(|error| error.to_string())?;
                    }
                }
                Ok(())
            }
        };
        let workers: Vec<_> = (0..threads).map(|start| scope.spawn(render(start))).collect();
        workers.into_iter().map(|worker| worker.join().unwrap_or_else(|_| Err("a photo could not be rendered".into()))).collect()
    });
    rendered.into_iter().collect::<Result<Vec<()>, String>>()?;
    let input = RunInput { use_gnss: false, settings: kind.settings(), ..RunInput::default() };
    let work = folder.join("work");
    let run = run_block(&images, &[], input, &work, threads, |_| ())?;
    fs::remove_dir_all(&work)?;
    let reconstruction = run.reconstruction.map_err(|failure| format!("{failure:?}"))?;
    let model = reconstruction.models.first().ok_or("no model")?;
    if model.images.len() < scene.photos() {
        return Err(format!("{} of {} images are oriented", model.images.len(), scene.photos()).into());
    }
    let mut block = model.adjusted.block.clone();
    for point in &model.supporting {
        let index = block.points.len();
        block.points.push(point.position);
        block.rays.extend(point.rays.iter().map(|ray| BlockObservation {
            image: ray.image,
            point: index,
            x_px: f64::from(ray.x_px),
            y_px: f64::from(ray.y_px),
            weight: 1.0,
            sigma_px: None,
        }));
    }
    let truth = scene.truth();
    for (image, exact) in block.images.iter_mut().zip(&truth.images) {
        image.pose = exact.pose.ok_or("the truth has poses")?;
    }
    for (camera, exact) in block.cameras.iter_mut().zip(&truth.cameras) {
        let free = camera.free;
        *camera = *exact;
        camera.free = free;
    }
    let mut is_placed = vec![false; block.points.len()];
    for ray in &block.rays {
        if !std::mem::replace(&mut is_placed[ray.point], true) {
            block.points[ray.point] = scene.surface_at(ray.image, &[[ray.x_px, ray.y_px]])?[0];
        }
    }
    fs::write(&file, serde_json::to_string(&block)?)?;
    Ok(block)
}

/// Standard errors in m of the positions that place a block, and of its control points; in px of their image measurements.
const GNSS_M: f64 = 0.1;
const SURVEYED_M: f64 = 0.05;
const MARK_PX: f64 = 0.2;
/// Of surveyed points, of which every other one is a control point.
const SURVEYED: usize = 24;

/// Gives a block what a datum asks for; tells the check points with their true places. `draw` tells apart the errors of blocks of one seed.
fn place(
    block: &mut Block,
    scene: &BlockScene,
    (flight, draw): (&BlockFlight, u64),
    datum: Datum,
) -> Result<Vec<(usize, [f64; 3])>, Failure> {
    let mut normal = Normal((u64::from(flight.seed) << 32) + (draw << 16));
    let mut checks = Vec::new();
    if datum == Datum::Gnss {
        for image in &mut block.images {
            let position = image.pose.position.map(|v| v + GNSS_M * normal.next());
            image.gnss = Some(PositionPrior { position, sigma: [Some(GNSS_M); 3] });
        }
    }
    if datum == Datum::Control {
        for (k, (truth, seen)) in surveyed(block, scene, flight)?.into_iter().enumerate() {
            let point = block.points.len();
            block.points.push(truth);
            if k % 2 == 0 {
                let position = truth.map(|v| v + SURVEYED_M * normal.next());
                block.control.push(ControlPoint { point, position, sigma: [SURVEYED_M; 3] });
            } else {
                checks.push((point, truth));
            }
            for (image, at) in seen {
                let [x_px, y_px] = at.map(|v| v + MARK_PX * normal.next());
                block.rays.push(BlockObservation { image, point, x_px, y_px, weight: 1.0, sigma_px: Some(MARK_PX) });
            }
        }
    }
    Ok(checks)
}

/// A place on the surface with the images that see it, and where.
type Seen = ([f64; 3], Vec<(usize, [f64; 2])>);

/// Places on the surface that three images and more see.
fn surveyed(block: &Block, scene: &BlockScene, flight: &BlockFlight) -> Result<Vec<Seen>, Failure> {
    let (width, height) = (f64::from(flight.width_px), f64::from(flight.height_px));
    let mut found = Vec::new();
    let mut k = 0_u32;
    while found.len() < SURVEYED && k < 2000 {
        // Places that fill the photos evenly, one photo after the other.
        let part = |step: f64| (0.5 + f64::from(k) * step).fract();
        let image = (k as usize * 5) % block.images.len();
        let at = [width * (0.05 + 0.9 * part(0.754_877_666)), height * (0.05 + 0.9 * part(0.569_840_291))];
        k += 1;
        let place = scene.surface_at(image, &[at])?[0];
        let mut seen = Vec::new();
        for (other, known) in block.images.iter().enumerate() {
            let [u, v, w] = known.pose.to_photo(&place);
            let camera = &block.cameras[known.camera];
            let at = [camera.principal_point_px[0] - camera.focal_px * u / w, camera.principal_point_px[1] + camera.focal_px * v / w];
            let inside = at[0] >= 1.0 && at[1] >= 1.0 && at[0] <= width - 1.0 && at[1] <= height - 1.0;
            if w < 0.0 && inside {
                let there = scene.surface_at(other, &[at])?[0];
                let off: f64 = (0..3).map(|i| (there[i] - place[i]) * (there[i] - place[i])).sum();
                if off < 1e-2 {
                    seen.push((other, at));
                }
            }
        }
        if seen.len() >= 3 {
            found.push((place, seen));
        }
    }
    Ok(found)
}

/// A sum of squares.
#[derive(Clone, Copy, Default)]
struct Squares {
    sum: f64,
    number: usize,
}

impl Squares {
    fn add(&mut self, value: f64) {
        self.sum += value * value;
        self.number += 1;
    }

    fn join(&mut self, other: &Self) {
        self.sum += other.sum;
        self.number += other.number;
    }

    fn mean(&self) -> f64 {
        self.sum / self.number as f64
    }
}

const KINDS: [&str; 8] = ["centres xy", "z", "omega phi", "kappa", "f", "pp", "k1", "checks"];

/// Squares of errors by standard errors of each of [`KINDS`], and of σ₀.
#[derive(Clone, Default)]
struct Sums {
    of: [Squares; KINDS.len()],
    sigma0: Squares,
}

impl Sums {
    fn add(
        &mut self,
        known: &Block,
        scene: &BlockScene,
        drawn: (&BlockFlight, u64),
        datum: Datum,
        shared_errors: f64,
    ) -> Result<(), Failure> {
        let mut block = known.clone();
        let checks = place(&mut block, scene, drawn, datum)?;
        let options = AdjustmentOptions { datum, calibration_limit_px: 20.0, shared_errors, ..AdjustmentOptions::default() };
        let adjusted: AdjustmentResult = adjust_block(&block, &options)?;
        self.sigma0.add(adjusted.sigma0_px.unwrap_or(0.0));
        for ((image, truth), told) in adjusted.block.images.iter().zip(&known.images).zip(&adjusted.images) {
            let Some(errors) = told.position_errors else { continue };
            for k in 0..3 {
                self.of[usize::from(k == 2)].add((image.pose.position[k] - truth.pose.position[k]) / errors[k]);
            }
            let (Some(errors), now, exact) = (told.angle_errors_deg, image.pose.angles(), truth.pose.angles()) else { continue };
            for k in 0..3 {
                let off = now[k] - exact[k];
                let off = off - std::f64::consts::TAU * (off / std::f64::consts::TAU).round();
                self.of[2 + usize::from(k == 2)].add(off.to_degrees() / errors[k]);
            }
        }
        for ((camera, truth), told) in adjusted.block.cameras.iter().zip(&known.cameras).zip(&adjusted.cameras) {
            let off = [
                (4, 0, camera.focal_px - truth.focal_px),
                (5, 1, camera.principal_point_px[0] - truth.principal_point_px[0]),
                (5, 2, camera.principal_point_px[1] - truth.principal_point_px[1]),
                (6, 3, camera.radial[0] - truth.radial[0]),
            ];
            for (kind, parameter, off) in off {
                if let Some(error) = told.standard_errors[parameter] {
                    self.of[kind].add(off / error);
                }
            }
        }
        for (point, truth) in checks {
            let Some(errors) = adjusted.points[point].as_ref().and_then(|told| told.errors) else { continue };
            (0..3).for_each(|k| self.of[7].add((adjusted.block.points[point][k] - truth[k]) / errors[k]));
        }
        Ok(())
    }

    fn join(&mut self, other: &Self) {
        self.of.iter_mut().zip(&other.of).for_each(|(sum, other)| sum.join(other));
        self.sigma0.join(&other.sigma0);
    }

    fn line(&self, datum: Datum) -> String {
        let shown = KINDS.iter().zip(&self.of).filter(|(_, squares)| squares.number > 0);
        let shown: Vec<String> = shown.map(|(name, squares)| format!("{name} {:.2}", squares.mean())).collect();
        format!("{:8} sigma0 {:.3} px: {}", format!("{datum:?}"), self.sigma0.mean().sqrt(), shown.join(", "))
    }
}
