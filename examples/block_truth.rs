//! Simulated blocks beside their truth, kind by kind: `cargo run --release --example block_truth [SEEDS] [PART OF A KIND'S NAME] [--json]`.
//!
//! Tells how many points have only rays that belong together, how many images are oriented, how large errors are beside the standard errors
//! that are told, and what resolving conflicts keeps that dropping them would lose. With `--json` one object a kind and line.

#[path = "../tests/scene/normal.rs"]
mod normal;
#[path = "../tests/scene/surveyed.rs"]
mod surveyed;

use normal::Normal;
use std::error::Error;
use surveyed::{MARK_PX, surveyed};
use tiepoint::{
    BlockDescription, BlockFlight, BlockOptions, BlockView, Conflicts, ControlRole, ObservationVerdict, ObservedPosition, PointSource,
    Reconstruction, ReconstructionOptions, SelectOptions, SimulatedBlock, TiePoints, angles_from_rotation, reconstruct_block,
    simulate_block, tie_points,
};

/// Standard error in m of the positions that place the blocks.
const GNSS_SIGMA_M: f64 = 0.1;

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let mut plain = words.iter().filter(|word| !word.starts_with("--"));
    let seeds = plain.next().map_or(Ok(10), |word| word.parse())?;
    let wanted = plain.next().map_or("", String::as_str);
    for (name, flight, is_surveyed) in kinds().into_iter().filter(|(name, ..)| name.contains(wanted)) {
        let mut sums = Sums::default();
        for seed in 1..=seeds {
            sums.add(&BlockFlight { seed, ..flight.clone() }, is_surveyed)?;
        }
        if words.iter().any(|word| word == "--json") {
            println!("{}", sums.json(name, seeds));
        } else {
            sums.print(name, seeds);
        }
    }
    Ok(())
}

/// Control points and check points of a surveyed block.
const CONTROL: usize = 8;
const CHECKS: usize = 20;

/// Each with its name, its flight, and whether it has control and check points.
fn kinds() -> Vec<(&'static str, BlockFlight, bool)> {
    let nadir = BlockFlight::default();
    // Views to all sides meet on the ground only where the block is longer than it is high.
    let oblique =
        BlockFlight { view: BlockView::Oblique, exposures: 9, forward_overlap: 0.5, side_overlap: 0.4, features: 1200, ..nadir.clone() };
    let two_heights = BlockFlight { view: BlockView::TwoHeights, ..nadir.clone() };
    let wrong = BlockFlight { wrong: 0.4, ..nadir.clone() };
    vec![
        ("5 x 6 nadir", nadir.clone(), false),
        ("five cameras, oblique", oblique, false),
        ("two heights", two_heights, false),
        ("40 % of the matches wrong", wrong, false),
        ("with control and check points", nadir, true),
    ]
}

/// A sum of squares.
#[derive(Default)]
struct Squares {
    sum: f64,
    number: usize,
}

impl Squares {
    fn add(&mut self, values: impl IntoIterator<Item = f64>) {
        for value in values {
            self.sum += value * value;
            self.number += 1;
        }
    }

    fn mean(&self) -> f64 {
        self.sum / self.number as f64
    }
}

/// A number and how many of it are as they should be.
#[derive(Default)]
struct Share {
    good: usize,
    all: usize,
}

impl Share {
    fn add(&mut self, good: usize, all: usize) {
        self.good += good;
        self.all += all;
    }

    fn value(&self) -> f64 {
        self.good as f64 / self.all.max(1) as f64
    }
}

/// What the blocks of a kind come to.
#[derive(Default)]
struct Sums {
    images: Share,
    /// Points whose rays all belong together: as they are joined, and with their accepted rays in the adjusted block.
    joined: Share,
    adjusted: Share,
    /// Rays with a right owner where conflicts are resolved, and where they are dropped.
    resolved: Share,
    dropped: Share,
    /// Errors by standard errors.
    positions: Squares,
    angles: Squares,
    points: Squares,
    cameras: Squares,
    checks: Squares,
    sigma0: Squares,
}

impl Sums {
    fn add(&mut self, flight: &BlockFlight, is_surveyed: bool) -> Result<(), tiepoint::Error> {
        let block = simulate_block(flight)?;
        let (matches, features) = (block.matches()?, block.image_features());
        let join = |conflicts| tie_points(&matches, &features, &BlockOptions { conflicts, ..BlockOptions::default() });
        let (points, _) = join(Conflicts::Resolve)?;
        let (fewer, _) = join(Conflicts::Drop)?;
        let pure = points.iter().filter(|rays| together(&block, rays.iter().map(|ray| (ray.image, ray.feature)))).count();
        self.joined.add(pure, points.len());
        self.resolved.add(right_rays(&block, &points), points.ray_count());
        self.dropped.add(right_rays(&block, &fewer), fewer.ray_count());
        let selection = Some(SelectOptions::default());
        let options = ReconstructionOptions { selection, mark_sigma_px: MARK_PX, ..ReconstructionOptions::default() };
        let description = describe(&block, flight.seed, is_surveyed);
        let reconstruction = reconstruct_block(&description, &points, &block.image_features(), &options)?;
        self.compare(&block, &reconstruction);
        Ok(())
    }

    /// The largest model beside the truth; one that is not in the system of the observed positions has no errors to be told.
    fn compare(&mut self, block: &SimulatedBlock, reconstruction: &Reconstruction) {
        let Some(model) = reconstruction.models.first().filter(|model| model.in_system) else {
            return self.images.add(0, block.exposures.len());
        };
        self.images.add(model.images.len(), block.exposures.len());
        self.sigma0.add(model.adjusted.sigma0_px);
        for ((camera, adjusted), told) in model.cameras.iter().zip(&model.adjusted.block.cameras).zip(&model.adjusted.cameras) {
            let (f, [cx, cy], [k1, k2, _]) = (adjusted.focal_px, adjusted.principal_point_px, adjusted.radial);
            let truth = &block.truth.cameras[*camera];
            let off = [
                f - truth.focal_px,
                cx - truth.principal_point_px[0],
                cy - truth.principal_point_px[1],
                k1 - truth.radial[0],
                k2 - truth.radial[1],
            ];
            self.cameras.add(off.iter().zip(&told.standard_errors).filter_map(|(off, told)| Some(off / (*told)?)));
        }
        for point in model.surveyed.iter().filter(|point| point.role == ControlRole::Check) {
            self.checks.add((0..3).filter_map(|i| Some(point.difference_m[i] / point.standard_errors_m[i]?)));
        }
        for ((k, image), told) in model.images.iter().zip(&model.adjusted.block.images).zip(&model.adjusted.images) {
            let exposure = &block.exposures[*k];
            let off = |at: [f64; 3], wanted: [f64; 3]| [0, 1, 2].map(|i| at[i] - wanted[i]);
            let over = |off: [f64; 3], told: [f64; 3]| [0, 1, 2].map(|i| off[i] / told[i]);
            if let Some(told) = told.position_errors {
                self.positions.add(over(off(image.pose.position, exposure.centre), told));
            }
            if let Some(told) = told.angle_errors_deg {
                let turned = off(image.pose.angles(), angles_from_rotation(&exposure.rotation));
                let within = |v: f64| v - std::f64::consts::TAU * (v / std::f64::consts::TAU).round();
                self.angles.add(over(turned.map(|v| within(v).to_degrees()), told));
            }
        }
        let mut accepted = vec![Vec::new(); model.points.len()];
        let verdicts = model.adjusted.block.rays.iter().zip(&model.adjusted.rays).zip(&model.rays);
        for ((ray, statistics), known) in verdicts {
            if let (ObservationVerdict::Accepted, Some(feature)) = (statistics.verdict, known.feature) {
                accepted[ray.point].push((model.images[ray.image] as u32, feature));
            }
        }
        for (k, known) in model.points.iter().enumerate() {
            let (PointSource::TiePoint(_), Some(told)) = (known, &model.adjusted.points[k]) else { continue };
            let pure = together(block, accepted[k].iter().copied());
            self.adjusted.add(usize::from(pure), 1);
            let Some(owner) = accepted[k].first().map(|(image, feature)| block.owners[*image as usize][*feature as usize]) else {
                continue;
            };
            // Of a point with a ray that does not belong to it the truth is not one place.
            if let (true, Some(owner), Some(told)) = (pure, owner, told.errors) {
                let (at, wanted) = (model.adjusted.block.points[k], block.ground[owner as usize]);
                self.points.add((0..3).map(|i| (at[i] - wanted[i]) / told[i]));
            }
        }
    }

    fn print(&self, name: &str, seeds: u32) {
        println!("{name}, {seeds} blocks: {} of {} images oriented", self.images.good, self.images.all);
        for (what, share) in [("as joined", &self.joined), ("adjusted", &self.adjusted)] {
            println!("  points {what}: {}, all rays belong together in {:.3} %", share.all, 100.0 * share.value());
        }
        for (what, share) in [("resolved", &self.resolved), ("dropped", &self.dropped)] {
            println!("  conflicts {what}: {} rays, {:.3} % right", share.all, 100.0 * share.value());
        }
        println!(
            "  squares of errors by standard errors: positions {:.3}, angles {:.3}, points {:.3}, cameras {:.3}, check points {:.3}; sigma0 {:.4} px",
            self.positions.mean(),
            self.angles.mean(),
            self.points.mean(),
            self.cameras.mean(),
            self.checks.mean(),
            self.sigma0.mean().sqrt()
        );
    }

    fn json(&self, name: &str, seeds: u32) -> serde_json::Value {
        serde_json::json!({
            "kind": name,
            "blocks": seeds,
            "images": self.images.all,
            "oriented": self.images.good,
            "points": self.joined.all,
            "pure": self.joined.value(),
            "adjusted_points": self.adjusted.all,
            "adjusted_pure": self.adjusted.value(),
            "resolved_rays": self.resolved.all,
            "resolved_right": self.resolved.value(),
            "dropped_rays": self.dropped.all,
            "dropped_right": self.dropped.value(),
            "variance_of_positions": self.positions.mean(),
            "variance_of_angles": self.angles.mean(),
            "variance_of_points": self.points.mean(),
            "variance_of_cameras": self.cameras.mean(),
            "variance_of_checks": self.checks.mean(),
            "sigma0_px": self.sigma0.mean().sqrt(),
        })
    }
}

/// Whether rays, of which each is an image and a feature, all show the same ground.
fn together(block: &SimulatedBlock, rays: impl Iterator<Item = (u32, u32)>) -> bool {
    let rays: Vec<_> = rays.collect();
    rays.windows(2).all(|pair| block.is_right(pair[0], pair[1]))
}

/// Rays that show the ground that most rays of their point show.
fn right_rays(block: &SimulatedBlock, points: &TiePoints) -> usize {
    let of_point = |rays: &[tiepoint::FeatureObservation]| {
        let alike =
            |a: &tiepoint::FeatureObservation| rays.iter().filter(|b| block.is_right((a.image, a.feature), (b.image, b.feature))).count();
        rays.iter().map(alike).max().filter(|most| *most > 1).unwrap_or(0)
    };
    points.iter().map(of_point).sum()
}

fn describe(block: &SimulatedBlock, seed: u32, is_surveyed: bool) -> BlockDescription {
    let mut normal = Normal(u64::from(seed) << 32);
    let mut description = block.description(Some(1.0));
    for (image, exposure) in description.images.iter_mut().zip(&block.exposures) {
        let position = exposure.centre.map(|v| v + GNSS_SIGMA_M * normal.next());
        image.position = Some(ObservedPosition::Local { position, sigma: [GNSS_SIGMA_M; 3] });
    }
    if is_surveyed {
        description.control = surveyed(block, CONTROL, CHECKS, &mut normal);
    }
    description
}
