//! Wrong control points of simulated blocks, how many are found and named, beside what the tests promise:
//! `cargo run --release --example control_detection [SEEDS] [--json]`.
//!
//! Each block has GNSS positions, control points and check points with errors as stated. It is adjusted as it is, which should refuse nothing, and with
//! an error in one coordinate of one control point: of the size that its test finds with a probability of 0.80, of five times the stated standard error,
//! and of five times what the test finds.

#[path = "../tests/scene/normal.rs"]
mod normal;
#[path = "../tests/scene/surveyed.rs"]
mod surveyed;

use normal::Normal;
use std::error::Error;
use surveyed::{MARK_PX, SURVEYED_M, surveyed};
use tiepoint::{
    AdjustmentOptions, BlockDescription, BlockFlight, BlockOptions, BlockWarning, ControlRole, ObservedPosition, ReconstructedModel,
    ReconstructionOptions, SelectOptions, SimulatedBlock, TiePoints, reconstruct_block, simulate_block, tie_points,
};

/// Standard error in m of the GNSS positions.
const GNSS_SIGMA_M: f64 = 0.1;
const CONTROL: usize = 8;
const CHECKS: usize = 20;

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let seeds = words.iter().find(|word| !word.starts_with("--")).map_or(Ok(20), |word| word.parse())?;
    let mut sums = Sums::default();
    for seed in 1..=seeds {
        sums.add(seed)?;
    }
    if words.iter().any(|word| word == "--json") {
        println!("{}", sums.json());
    } else {
        sums.print();
    }
    Ok(())
}

/// Blocks with an error of one size.
#[derive(Default)]
struct Errors {
    blocks: usize,
    /// Those whose wrong point is refused, of which the wrong coordinate is named, of which no other point is.
    found: usize,
    named: usize,
    alone: usize,
    /// Sum of the probabilities that its test promises.
    promised: f64,
}

#[derive(Default)]
struct Sums {
    blocks: usize,
    /// Clean blocks with a warning, and the sum of the probabilities of one.
    false_alarms: usize,
    expected: f64,
    /// Of check points of clean blocks: differences by standard errors.
    checks: (f64, usize),
    errors: [Errors; 3],
}

const SIZES: [&str; 3] = ["1 minimal detectable error", "5 standard errors", "5 minimal detectable errors"];

struct Scene {
    block: SimulatedBlock,
    points: TiePoints,
    description: BlockDescription,
}

impl Scene {
    fn new(seed: u32) -> Result<Self, tiepoint::Error> {
        let block = simulate_block(&BlockFlight { strips: 3, exposures: 5, features: 800, seed, ..BlockFlight::default() })?;
        let (points, _) = tie_points(&block.matches()?, &block.image_features(), &BlockOptions::default())?;
        let mut normal = Normal(u64::from(seed) << 32);
        let mut description = block.description(Some(1.0));
        for (image, exposure) in description.images.iter_mut().zip(&block.exposures) {
            let position = exposure.centre.map(|v| v + GNSS_SIGMA_M * normal.next());
            image.position = Some(ObservedPosition::Local { position, sigma: [GNSS_SIGMA_M; 3] });
        }
        description.control = surveyed(&block, CONTROL, CHECKS, &mut normal);
        Ok(Self { block, points, description })
    }

    /// The largest model, with an error in a coordinate of a point; absent where it is not in the system of the positions.
    fn adjusted(&self, wrong: Option<(&str, usize, f64)>) -> Result<Option<ReconstructedModel>, tiepoint::Error> {
        let mut description = self.description.clone();
        if let Some((name, axis, error)) = wrong {
            for point in description.control.iter_mut().filter(|point| point.name == name) {
                if let ObservedPosition::Local { position, .. } = &mut point.position {
                    position[axis] += error;
                }
            }
        }
        let options =
            ReconstructionOptions { selection: Some(SelectOptions::default()), mark_sigma_px: MARK_PX, ..ReconstructionOptions::default() };
        let found = reconstruct_block(&description, &self.points, &self.block.image_features(), &options)?;
        Ok(found.models.into_iter().next().filter(|model| model.in_system))
    }
}

/// The points that are refused, each with its coordinate.
fn refused(model: &ReconstructedModel) -> Vec<(&str, usize)> {
    let of = |warning| match warning {
        &BlockWarning::ControlRefused { ref point, axis, .. } => Some((point.as_str(), axis as usize)),
        _ => None,
    };
    model.warnings.iter().filter_map(of).collect()
}

impl Sums {
    fn add(&mut self, seed: u32) -> Result<(), tiepoint::Error> {
        let scene = Scene::new(seed)?;
        let Some(clean) = scene.adjusted(None)? else { return Ok(()) };
        self.blocks += 1;
        let is_wrong =
            |warning: &BlockWarning| matches!(warning, BlockWarning::ControlRefused { .. } | BlockWarning::ControlContradicts { .. });
        self.false_alarms += usize::from(clean.warnings.iter().any(is_wrong));
        let of_role = |role| clean.surveyed.iter().filter(move |point| point.role == role);
        let tested = of_role(ControlRole::Control).flat_map(|point| point.detectable_m).flatten().count();
        let alpha0 = AdjustmentOptions::default().alpha0;
        self.expected += 1.0 - libm::pow(1.0 - alpha0, tested as f64);
        for point in of_role(ControlRole::Check) {
            for ratio in (0..3).filter_map(|k| Some(point.difference_m[k] / point.standard_errors_m[k]?)) {
                self.checks = (self.checks.0 + ratio * ratio, self.checks.1 + 1);
            }
        }
        let control: Vec<_> = of_role(ControlRole::Control).collect();
        let (point, axis) = (control[seed as usize % control.len()], seed as usize / control.len() % 3);
        let Some(detectable) = point.detectable_m[axis] else { return Ok(()) };
        let sign = if seed.is_multiple_of(2) { 1.0 } else { -1.0 };
        for (errors, size) in self.errors.iter_mut().zip([detectable, 5.0 * SURVEYED_M[axis], 5.0 * detectable]) {
            let Some(model) = scene.adjusted(Some((&point.name, axis, sign * size)))? else { continue };
            let found = refused(&model);
            errors.blocks += 1;
            errors.promised += power(size / detectable, alpha0);
            let Some((_, named)) = found.iter().find(|(name, _)| *name == point.name) else { continue };
            errors.found += 1;
            errors.named += usize::from(*named == axis);
            errors.alone += usize::from(found.len() == 1);
        }
        Ok(())
    }

    fn print(&self) {
        let percent = |part: f64, all: usize| 100.0 * part / all.max(1) as f64;
        println!("{} blocks of 15 images with GNSS positions, {CONTROL} control points and {CHECKS} check points", self.blocks);
        println!(
            "  clean blocks with a warning of wrong control points: {} ({:.1} %), by chance {:.1} %",
            self.false_alarms,
            percent(self.false_alarms as f64, self.blocks),
            percent(self.expected, self.blocks)
        );
        println!(
            "  check points of clean blocks: mean square of differences by standard errors {:.3}",
            self.checks.0 / self.checks.1 as f64
        );
        for (what, errors) in SIZES.iter().zip(&self.errors) {
            println!(
                "  an error of {what}: {} of {} points found ({:.1} %, promised {:.1} %), coordinate named in {}, no other point refused in {}",
                errors.found,
                errors.blocks,
                percent(errors.found as f64, errors.blocks),
                percent(errors.promised, errors.blocks),
                errors.named,
                errors.alone
            );
        }
    }

    fn json(&self) -> serde_json::Value {
        let of_errors = |errors: &Errors| {
            serde_json::json!({
                "blocks": errors.blocks,
                "found": errors.found,
                "named": errors.named,
                "alone": errors.alone,
                "promised": errors.promised / errors.blocks.max(1) as f64,
            })
        };
        serde_json::json!({
            "blocks": self.blocks,
            "false_alarms": self.false_alarms,
            "false_alarms_by_chance": self.expected / self.blocks.max(1) as f64,
            "variance_of_checks": self.checks.0 / self.checks.1.max(1) as f64,
            "errors": self.errors.iter().map(of_errors).collect::<Vec<_>>(),
        })
    }
}

/// With which probability a test finds an error of so many times the one that it finds with 0.80.
fn power(times: f64, alpha0: f64) -> f64 {
    let (limit, found) = (quantile(1.0 - 0.5 * alpha0), quantile(0.8));
    let shift = times * (limit + found);
    below(shift - limit) + below(-shift - limit)
}

fn below(value: f64) -> f64 {
    0.5 * libm::erfc(-value / std::f64::consts::SQRT_2)
}

/// Of the normal distribution, by bisection.
fn quantile(probability: f64) -> f64 {
    let (mut low, mut high) = (-10.0, 10.0);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if below(middle) < probability { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}
