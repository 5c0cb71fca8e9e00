//! Weights of blocks whose standard errors are stated right and wrong: `cargo run --release --example variance_components -- [SEEDS] [--from SEED]`.
//!
//! Printed of each kind of block are the share of 95 % intervals of orientations and check points that hold the truth, and the root mean square of
//! the check points' errors by their standard errors, which should be 1, each with stated weights and with estimated ones. Then of each group of
//! observations the true factor, the found one by it (geometric mean), how often its interval holds the true one, how often it was applied and how
//! often held. At the end the same over all blocks, of groups that are stated right and wrong.

#[path = "../tests/scene/normal.rs"]
mod normal;
#[path = "../tests/scene/stated.rs"]
mod stated;

use stated::{Case, GROUPS, Simulated};
use tiepoint::{AdjustmentOptions, AdjustmentResult, Datum, adjust_block};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let from = words.iter().position(|word| word == "--from").and_then(|at| words.get(at + 1));
    let first: u32 = from.map_or(Ok(1), |word| word.parse())?;
    let seeds: u32 = words.first().filter(|word| !word.starts_with("--")).map_or(Ok(20), |word| word.parse())?;
    println!(
        "errors beside what is stated: intervals that hold, check points' error / standard error; factor, found / true, its interval holds, applied, held"
    );
    let (mut right, mut wrong) = (<[Factors; 5]>::default(), <[Factors; 5]>::default());
    let mut weighting = Rounds::default();
    for (name, case) in cases() {
        let mut tallies = [Tally::default(), Tally::default()];
        let mut found = <[Factors; 5]>::default();
        for seed in first..first + seeds {
            let simulated = Simulated::new(&case, seed)?;
            for (variance_components, tally) in [false, true].into_iter().zip(&mut tallies) {
                let options = AdjustmentOptions { datum: case.datum, variance_components, ..AdjustmentOptions::default() };
                let adjusted = adjust_block(&simulated.block, &options)?;
                tally.add(&simulated, &adjusted);
                for component in &adjusted.components {
                    let group = GROUPS.iter().position(|group| *group == component.group).unwrap_or(0);
                    let truth = case.factors[group];
                    let total = if truth == 1.0 { &mut right } else { &mut wrong };
                    [&mut found, total].into_iter().for_each(|factors| factors[group].add(truth, component));
                }
                weighting.add(&adjusted);
            }
        }
        let [stated, estimated] = tallies;
        let groups: Vec<String> =
            (0..5).filter(|k| found[*k].number > 0).map(|k| format!("{:?} {} {}", GROUPS[k], case.factors[k], found[k])).collect();
        println!(
            "{name:32} {:5.1} %, {:5.1} %; {:.2}, {:.2}; {}",
            stated.held(),
            estimated.held(),
            stated.of_checks(),
            estimated.of_checks(),
            groups.join("; ")
        );
    }
    for (name, totals) in [("all groups stated right", right), ("all groups stated wrong", wrong)] {
        let groups: Vec<String> = (0..5).filter(|k| totals[*k].number > 0).map(|k| format!("{:?} {}", GROUPS[k], totals[k])).collect();
        println!("{name:32} {}", groups.join("; "));
    }
    println!(
        "rounds of weighting: {} at most; blocks whose weights did not converge: {} of {}",
        weighting.most, weighting.open, weighting.blocks
    );
    Ok(())
}

fn cases() -> Vec<(String, Case)> {
    let mut all = Vec::new();
    for (label, control, datum) in
        [("both", 12, Datum::GnssAndControl), ("control", 12, Datum::Control), ("4 control", 4, Datum::Control), ("gnss", 0, Datum::Gnss)]
    {
        let mut case = |name: &str, factors| all.push((format!("{label}: {name}"), Case { factors, control, datum }));
        case("right", [1.0; 5]);
        case("marks 0.3", [0.3, 1.0, 1.0, 1.0, 1.0]);
        case("marks 3", [3.0, 1.0, 1.0, 1.0, 1.0]);
        if matches!(datum, Datum::Gnss | Datum::GnssAndControl) {
            case("GNSS 2", [1.0, 2.0, 2.0, 1.0, 1.0]);
            case("GNSS 0.5", [1.0, 0.5, 0.5, 1.0, 1.0]);
        }
        if control > 0 {
            case("control 3", [1.0, 1.0, 1.0, 3.0, 3.0]);
            case("control 0.3, marks 0.3", [0.3, 1.0, 1.0, 0.3, 0.3]);
        }
    }
    all
}

/// What became of the orientations and check points of some blocks.
#[derive(Default)]
struct Tally {
    held: usize,
    all: usize,
    /// Squares of the check points' errors by their standard errors, and how many.
    checks: (f64, usize),
}

impl Tally {
    fn add(&mut self, simulated: &Simulated, adjusted: &AdjustmentResult) {
        let mut judge = |off: f64, error: f64| {
            self.all += 1;
            self.held += usize::from(off.abs() <= 1.96 * error);
        };
        for ((image, truth), statistics) in adjusted.block.images.iter().zip(&simulated.truth.images).zip(&adjusted.images) {
            let (Some(positions), Some(angles)) = (statistics.position_errors, statistics.angle_errors_deg) else { continue };
            let (now, exact) = (image.pose.angles(), truth.pose.angles());
            for k in 0..3 {
                judge(image.pose.position[k] - truth.pose.position[k], positions[k]);
                let off = now[k] - exact[k];
                judge((off - std::f64::consts::TAU * (off / std::f64::consts::TAU).round()).to_degrees(), angles[k]);
            }
        }
        for point in &simulated.checks {
            let Some(errors) = adjusted.points[*point].as_ref().and_then(|statistics| statistics.errors) else { continue };
            for (k, error) in errors.into_iter().enumerate() {
                let off = adjusted.block.points[*point][k] - simulated.truth.points[*point][k];
                judge(off, error);
                self.checks.0 += off / error * (off / error);
                self.checks.1 += 1;
            }
        }
    }

    fn held(&self) -> f64 {
        100.0 * self.held as f64 / self.all as f64
    }

    fn of_checks(&self) -> f64 {
        (self.checks.0 / self.checks.1 as f64).sqrt()
    }
}

/// Factors that were found of a group.
#[derive(Default)]
struct Factors {
    number: usize,
    held: usize,
    applied: usize,
    /// Of those that were not held: the sum of the logarithms of found by true factor, and how many intervals hold the true one.
    logarithms: f64,
    holds: usize,
}

impl Factors {
    fn add(&mut self, truth: f64, component: &tiepoint::VarianceComponent) {
        self.number += 1;
        self.applied += usize::from(component.applied);
        let Some([low, high]) = component.interval else {
            self.held += 1;
            return;
        };
        self.logarithms += (component.factor / truth).ln();
        self.holds += usize::from((low..=high).contains(&truth));
    }
}

impl std::fmt::Display for Factors {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let estimated = self.number - self.held;
        let share = |count: usize, of: usize| 100.0 * count as f64 / of.max(1) as f64;
        let found = (self.logarithms / estimated.max(1) as f64).exp();
        let [holds, applied, held] = [share(self.holds, estimated), share(self.applied, self.number), share(self.held, self.number)];
        match estimated {
            0 => write!(f, "held"),
            _ => write!(f, "{found:.2} {holds:.0} % {applied:.0} % {held:.0} %"),
        }
    }
}

#[derive(Default)]
struct Rounds {
    blocks: usize,
    most: usize,
    open: usize,
}

impl Rounds {
    fn add(&mut self, adjusted: &AdjustmentResult) {
        let Some(weighting) = adjusted.weighting else { return };
        self.blocks += 1;
        self.most = self.most.max(weighting.rounds);
        self.open += usize::from(!weighting.converged);
    }
}
