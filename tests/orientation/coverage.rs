//! Whether 95 % intervals hold the truth, what of few observations is refused, and whether errors of the detectable size are found, for any number of
//! points and kind of gross errors.
//!
//! `npm run bench -- statistics` prints the figures of all sets.

use super::super::sampling::runs;
use super::calibration::displace;
use super::scene::{Dice, FOCAL_MM, NADIR, Pair, standard_errors};
use tiepoint::{FiveParameters, Observation, OrientationOptions, RelativeOrientation, Warning, orient_relative};

const SIGMA_MM: f64 = 0.005;
const SETS: u64 = 10_000;
const SPOILED_SETS: u64 = 3000;
/// Of this number of points and more, fewer sets are made.
const MANY: usize = 100;
/// Standard errors beyond which an unknown is far off.
const FAR: f64 = 10.0;
/// Of this number of points and fewer, Student's distribution itself reaches that far.
const FEW: usize = 12;
/// Draws of errors by which a set says how often chance reaches that far.
const DRAWS: usize = 8;

/// What is wrong with observations beside their noise.
#[derive(Clone, Copy)]
enum Gross {
    None,
    /// The right point lies anywhere within ±12 px of 0.254 mm.
    Wild(f64),
    /// The right point lies 6 to 40 σ across its epipolar line.
    Small(f64),
}

impl Gross {
    fn words(self) -> String {
        match self {
            Gross::None => "clean".into(),
            Gross::Wild(share) => format!("{:.0} % wild", 100.0 * share),
            Gross::Small(share) => format!("{:.0} % of 6 to 40 σ", 100.0 * share),
        }
    }

    fn spoil(self, pair: &Pair, observations: &mut [Observation], seed: u64) {
        let (Gross::Wild(share) | Gross::Small(share)) = self else { return };
        let count = (share * observations.len() as f64).round() as usize;
        let mut dice = Dice::new(seed);
        for k in 0..count {
            let observation = &mut observations[k * observations.len() / count];
            if let Gross::Small(_) = self {
                let sign = if dice.uniform(0.0, 1.0) < 0.5 { -1.0 } else { 1.0 };
                displace(pair, observation, sign * SIGMA_MM * dice.uniform(6.0, 40.0));
            } else {
                observation.right.iter_mut().for_each(|v| *v += dice.uniform(-12.0 * 0.254, 12.0 * 0.254));
            }
        }
    }
}

/// What many sets gave.
#[derive(Default)]
struct Tally {
    sets: u64,
    refused: usize,
    /// Of those oriented: nothing checks their observations, as a warning says.
    unchecked: usize,
    oriented: usize,
    covered: usize,
    far: usize,
    rejected: usize,
    variance: f64,
    /// How many sets chance alone lets be far off: errors of the correlations of each set, by a σ₀ that as many degrees of freedom estimate as
    /// there are without a rejection.
    far_by_chance: f64,
}

impl Tally {
    fn of(points: usize, gross: Gross, sets: u64, options: &OrientationOptions) -> Self {
        let mut tally = Self { sets, ..Self::default() };
        for seed in 0..sets {
            let mut observations = NADIR.observe(points, SIGMA_MM, 50_000 + seed);
            gross.spoil(&NADIR, &mut observations, 90_000 + seed);
            match orient_relative(&observations, FOCAL_MM, options) {
                Ok(found) => {
                    tally.add(&NADIR, &found);
                    if points <= FEW {
                        tally.far_by_chance += share_far_by_chance(&found.correlations, points - 5, seed);
                    }
                }
                Err(_) => tally.refused += 1,
            }
        }
        tally
    }

    fn add(&mut self, pair: &Pair, found: &RelativeOrientation) {
        let five = |p: FiveParameters| [p.omega_deg, p.phi_deg, p.kappa_deg, p.by_mm, p.bz_mm];
        let (errors, half) = (pair.errors(found), five(found.half_widths_95.expect("there is redundancy")));
        let standard = standard_errors(found);
        self.oriented += 1;
        self.unchecked += usize::from(found.warnings.iter().any(|warning| matches!(warning, Warning::Unchecked { .. })));
        self.covered += (0..5).filter(|k| errors[*k].abs() <= half[*k]).count();
        self.far += usize::from((0..5).any(|k| errors[k].abs() > FAR * standard[k]));
        self.rejected += found.rejected.len();
        self.variance += (found.sigma0_mm.unwrap_or(0.0) / SIGMA_MM).powi(2);
    }

    /// The share of the intervals that hold the truth.
    fn covered(&self) -> f64 {
        self.covered as f64 / (5.0 * self.oriented as f64)
    }

    fn refused_or_covered(&self) -> f64 {
        (self.refused as f64 + self.covered as f64 / 5.0) / self.sets as f64
    }

    fn print(&self, what: &str) {
        let oriented = self.oriented as f64;
        println!(
            "intervals, {what}: {:.1} % hold the truth, refused or so {:.1} %; {} refused, {} not checked, and {} beyond 10 standard errors of {} sets; σ₀² {:.3} \
             of the true, {:.2} rejected",
            100.0 * self.covered(),
            100.0 * self.refused_or_covered(),
            self.refused,
            self.unchecked,
            self.far,
            self.sets,
            self.variance / oriented,
            self.rejected as f64 / oriented
        );
    }

    fn print_far(&self, what: &str, freedom: usize) {
        println!(
            "intervals, {what}: {} of {} sets beyond {FAR} standard errors, {:.1} by Student's distribution with {freedom} degrees of freedom",
            self.far, self.sets, self.far_by_chance
        );
    }

    /// 93 to 97 %, with four standard deviations of what so many sets show: the five unknowns of a set count as one.
    fn is_within(&self, share: f64) -> bool {
        let scatter = 4.0 * (0.05 * 0.95 / self.sets as f64).sqrt();
        (0.93 - scatter..=0.97 + scatter).contains(&share)
    }
}

/// The probability with which one of five unknowns of these correlations lies beyond [`FAR`] of its standard errors, which are by a σ₀ of so many
/// degrees of freedom (the multivariate distribution of Student): the mean, over draws of the errors, of the probability of a σ₀ small enough.
fn share_far_by_chance(correlations: &[[f64; 5]; 5], freedom: usize, seed: u64) -> f64 {
    // R = L Lᵀ.
    let mut lower = [[0.0; 5]; 5];
    for row in 0..5 {
        for column in 0..=row {
            let sum: f64 = (0..column).map(|k| lower[row][k] * lower[column][k]).sum();
            let left = correlations[row][column] - sum;
            lower[row][column] = if row == column { left.max(0.0).sqrt() } else { left / lower[column][column] };
        }
    }
    let mut dice = Dice::new(200_000 + seed);
    let one = |dice: &mut Dice| {
        let normal: [f64; 5] = std::array::from_fn(|_| dice.normal());
        let error = |row: &[f64; 5]| (0..5).map(|k| row[k] * normal[k]).sum::<f64>().abs();
        let largest = lower.iter().map(error).fold(0.0, f64::max);
        let r = freedom as f64;
        chi_square_below(r * (largest / FAR).powi(2), r)
    };
    (0..DRAWS).map(|_| one(&mut dice)).sum::<f64>() / DRAWS as f64
}

/// The probability that χ² of so many degrees of freedom is below a small value: the series of the incomplete gamma function.
fn chi_square_below(value: f64, freedom: f64) -> f64 {
    let (x, a) = (0.5 * value, 0.5 * freedom);
    let (mut term, mut sum) = (1.0 / a, 1.0 / a);
    for n in 1..200 {
        term *= x / (a + f64::from(n));
        sum += term;
    }
    sum * libm::exp(a * x.ln() - x - libm::lgamma(a))
}

fn sets_of(points: usize, all: u64) -> u64 {
    runs(if points < MANY { all } else { all * 20 / points as u64 })
}

#[test]
fn intervals_of_clean_observations_hold_the_truth() {
    let plain = OrientationOptions { robust: false, ..NADIR.options() };
    for points in [6, 7, 10, 12, 15, 20, 100, 2000] {
        let sets = sets_of(points, SETS);
        for (way, options) in [("default", NADIR.options()), ("plain", plain.clone())] {
            let found = Tally::of(points, Gross::None, sets, &options);
            found.print(&format!("{points} clean points, {way}"));
            if points <= FEW {
                found.print_far(&format!("{points} clean points, {way}"), points - 5);
            }
            assert!(found.is_within(found.covered()), "{points}, {way}: {}", found.covered());
            assert!(found.refused <= (sets / 200) as usize, "{points}, {way}: {} refused", found.refused);
            if points <= FEW && way == "plain" {
                let scatter = 4.0 * found.far_by_chance.sqrt() + 2.0;
                assert!((found.far as f64 - found.far_by_chance).abs() < scatter, "{points}: {} for {}", found.far, found.far_by_chance);
            }
            assert!(points <= FEW || found.far as u64 <= sets / 5000, "{points}, {way}: {} beyond 10 standard errors", found.far);
        }
    }
}

#[test]
fn intervals_beside_gross_errors_hold_the_truth_or_the_set_is_refused() {
    let kinds = [(Gross::Wild(0.1), 6), (Gross::Wild(0.3), 6), (Gross::Small(0.3), 10), (Gross::Wild(0.6), 20)];
    for (gross, least) in kinds {
        for points in [6, 7, 10, 12, 15, 20, 100, 2000].into_iter().filter(|points| *points >= least) {
            let found = Tally::of(points, gross, sets_of(points, SPOILED_SETS), &NADIR.options());
            found.print(&format!("{points} points, {}", gross.words()));
            let share = if points < 20 { found.refused_or_covered() } else { found.covered() };
            // Of five and some observations, those that agree are too few to tell that others do not.
            assert!(points < 12 || found.is_within(share), "{points}, {}: {share}", gross.words());
        }
    }
}

#[test]
fn errors_of_the_detectable_size_are_found_with_their_power() {
    let plain = OrientationOptions { robust: false, ..NADIR.options() };
    for points in [10, 12, 15, 20, 30, 100] {
        let (mut found, mut trials, mut shift) = (0, 0, 0.0);
        for seed in 0..runs(6000) {
            let mut observations = NADIR.observe(points, SIGMA_MM, 150_000 + seed);
            let clean = orient_relative(&observations, FOCAL_MM, &plain).unwrap();
            let suspect = seed as usize % points;
            let point = clean.points[suspect].unwrap();
            // What is printed is a multiple of the estimated σ₀, which scatters; the power is that of as many true ones.
            let size = point.detectable_mm * SIGMA_MM / clean.sigma0_mm.unwrap();
            if point.redundancy < 1e-3 {
                continue;
            }
            displace(&NADIR, &mut observations[suspect], if seed % 2 == 0 { size } else { -size });
            trials += 1;
            shift = clean.noncentrality.unwrap();
            let spoiled = orient_relative(&observations, FOCAL_MM, &NADIR.options());
            found += usize::from(spoiled.is_ok_and(|spoiled| spoiled.rejected.contains(&suspect)));
        }
        let power = f64::from(found as u32) / f64::from(trials as u32);
        println!(
            "power at the minimal detectable size, {points} points: {:.1} % of {trials} errors found, of {shift:.2} standard errors of a residual",
            100.0 * power
        );
        assert!((0.75..0.85).contains(&power), "{points}: {power}");
    }
}
