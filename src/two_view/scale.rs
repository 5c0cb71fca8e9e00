//! How precise the good observations are, and where the others begin.

use crate::math::{normal_density, normal_spread_within};

/// Residuals of one condition (distance from an epipolar line) or of two (distance from a place).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Conditions {
    One,
    Two,
}

impl Conditions {
    pub fn count(self) -> usize {
        match self {
            Self::One => 1,
            Self::Two => 2,
        }
    }
}

/// What is known beforehand of the noise.
#[derive(Debug, Clone, Copy)]
pub(super) struct NoiseLimits {
    /// Largest distance of a good observation.
    pub largest_threshold: f64,
    /// The threshold is given, not estimated.
    pub fixed: bool,
}

/// Good observations among others.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Noise {
    /// Standard error of a coordinate.
    pub sigma: f64,
    /// Largest distance of an observation that more likely is good than not.
    pub threshold: f64,
    /// Estimated number of good observations, and of others within the threshold.
    pub good: f64,
    pub others: f64,
}

impl Noise {
    /// Whether that many observations agree by more than chance: the best of many models, each through a sample of `sample`, has more of them
    /// than any one would.
    pub fn is_supported(&self, sample: usize) -> bool {
        self.good >= BEYOND_CHANCE * self.others.sqrt() + (LEAST_REDUNDANCY + sample) as f64
    }
}

/// σ by distances, for a search: the largest one while the good observations are not more than chance.
pub(super) fn search_scale(distances: &[f64], conditions: Conditions, limits: &NoiseLimits) -> f64 {
    let found = noise(distances, conditions, limits);
    if found.is_supported(0) { found.sigma } else { limits.largest_threshold / THRESHOLDS[0] }
}

/// How many standard deviations of chance the good observations exceed.
const BEYOND_CHANCE: f64 = 6.0;
/// Observations beyond those of a minimal sample that a geometry stands on at least.
pub(super) const LEAST_REDUNDANCY: usize = 8;

/// Standard errors within which residuals are taken for σ.
const CUT: f64 = 2.5;
/// Least and most standard errors that a threshold is.
const THRESHOLDS: [f64; 2] = [2.0, 3.5];
/// Least standard error, as a share of the largest threshold: below it distances are rounding.
const LEAST_SHARE: f64 = 1e-4;
/// A step leaves at least this share of σ.
const SHRINKING: f64 = 0.6;
/// The others are counted from one to two of these times the largest threshold.
const FAR: f64 = 2.0;
/// Guided matches that reach this many times a known threshold tell how many others there are.
const LEAST_BAND: f64 = 1.5;

/// Estimates σ from distances: of those within a cut of the last estimate, less what others would leave there. The density of the others is
/// counted where no good ones lie; gross errors fall evenly about a line, and evenly over the area about a place.
pub(super) fn noise(distances: &[f64], conditions: Conditions, limits: &NoiseLimits) -> Noise {
    let largest = limits.largest_threshold;
    let far = FAR * largest;
    let [from, to] = zone_of_others(distances, limits);
    let beyond = distances.iter().filter(|d| **d > from && **d <= to).count() as f64;
    // Others within d: density · d, or density · d².
    let density = match conditions {
        Conditions::One => beyond / (to - from),
        Conditions::Two => beyond / (to * to - from * from),
    };
    let others_within = |d: f64| match conditions {
        Conditions::One => density * d,
        Conditions::Two => density * d * d,
    };
    let squares_of_others = |d: f64| match conditions {
        Conditions::One => density * d * d * d / 3.0,
        Conditions::Two => 0.5 * density * d * d * d * d,
    };
    let cut_share = mean_square_within(CUT, conditions);
    let (least, most) = (LEAST_SHARE * largest, largest / THRESHOLDS[0]);
    let mut sigma = most;
    for _ in 0..30 {
        let cut = (CUT * sigma).min(far);
        let within = distances.iter().filter(|d| **d <= cut);
        let (count, sum) = within.fold((0.0, 0.0), |(count, sum), d| (count + 1.0, sum + d * d));
        let good = count - others_within(cut);
        if !(good > 0.0) {
            sigma = most;
            break;
        }
        let square = (sum - squares_of_others(cut)) / (good * cut_share);
        // Far out, chance among the others outweighs the good ones: no step goes further than to these.
        let next = square.max(SHRINKING * SHRINKING * sigma * sigma).sqrt().clamp(least, most);
        let change = (next - sigma).abs();
        sigma = next;
        if change <= 1e-3 * sigma {
            break;
        }
    }
    let threshold = if limits.fixed { largest } else { threshold(distances, sigma, conditions, density, others_within).min(largest) };
    let within = distances.iter().filter(|d| **d <= threshold).count() as f64;
    let others = others_within(threshold).min(within);
    Noise { sigma, threshold, good: within - others, others }
}

/// Where the others are counted. Guided matches end near the epipolar lines: with a threshold that is known, all beyond it are others.
fn zone_of_others(distances: &[f64], limits: &NoiseLimits) -> [f64; 2] {
    let largest = limits.largest_threshold;
    let far = FAR * largest;
    let end = distances.iter().filter(|d| d.is_finite()).fold(0.0, |end: f64, d| end.max(*d));
    let is_band = limits.fixed && end > LEAST_BAND * largest && end < 2.0 * far;
    if is_band { [largest, end] } else { [far, 2.0 * far] }
}

/// Where a good observation becomes less likely than another one.
fn threshold(distances: &[f64], sigma: f64, conditions: Conditions, density: f64, others_within: impl Fn(f64) -> f64) -> f64 {
    let cut = CUT * sigma;
    let good = (distances.iter().filter(|d| **d <= cut).count() as f64 - others_within(cut)).max(1.0);
    // Densities at 0 of distance, or of its square, times σ, or σ²: that of good ones falls as exp(-d²/2σ²).
    let ratio = match conditions {
        Conditions::One => good * 2.0 * normal_density(0.0) / (density * sigma),
        Conditions::Two => good / (2.0 * density * sigma * sigma),
    };
    let standard = if ratio > 1.0 { (2.0 * libm::log(ratio)).sqrt() } else { 0.0 };
    sigma * standard.clamp(THRESHOLDS[0], THRESHOLDS[1])
}

/// Mean square of the distances within `cut` standard errors, in σ².
fn mean_square_within(cut: f64, conditions: Conditions) -> f64 {
    match conditions {
        Conditions::One => normal_spread_within(cut) * normal_spread_within(cut),
        Conditions::Two => {
            let tail = libm::exp(-0.5 * cut * cut);
            2.0 * (1.0 - 0.5 * cut * cut * tail / (1.0 - tail))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Random;

    const LIMITS: NoiseLimits = NoiseLimits { largest_threshold: 4.0, fixed: false };

    /// Distances with a standard error, and others evenly within 100 of a line or a place.
    fn distances(good: usize, sigma: f64, others: usize, conditions: Conditions) -> Vec<f64> {
        let mut random = Random::new(3);
        let mut uniform = || (random.below(1 << 24) as f64 + 0.5) / (1 << 24) as f64;
        let mut normal = || (0..12).map(|_| uniform()).sum::<f64>() - 6.0;
        let good: Vec<f64> = (0..good)
            .map(|_| match conditions {
                Conditions::One => (sigma * normal()).abs(),
                Conditions::Two => sigma * (normal().powi(2) + normal().powi(2)).sqrt(),
            })
            .collect();
        let strangers = (0..others).map(|_| match conditions {
            Conditions::One => 100.0 * uniform(),
            Conditions::Two => 100.0 * uniform().sqrt(),
        });
        good.iter().copied().chain(strangers).collect()
    }

    #[test]
    fn the_standard_error_of_the_good_ones_is_found_among_others() {
        for conditions in [Conditions::One, Conditions::Two] {
            for sigma in [0.1, 0.4, 1.2] {
                for (good, others) in [(1000, 0), (500, 500), (300, 2700)] {
                    let found = noise(&distances(good, sigma, others, conditions), conditions, &LIMITS);
                    assert!((found.sigma / sigma - 1.0).abs() < 0.25, "{conditions:?} {sigma} {good} {others}: {found:?}");
                    assert!((found.good / good as f64 - 1.0).abs() < 0.15, "{conditions:?} {sigma} {good} {others}: {found:?}");
                    let standard = found.threshold / found.sigma;
                    assert!((1.9..=3.51).contains(&standard) || found.threshold == 4.0, "{found:?}");
                }
            }
        }
    }

    #[test]
    fn more_others_draw_the_threshold_in_and_a_fixed_one_stays() {
        let threshold = |others| noise(&distances(500, 0.5, others, Conditions::One), Conditions::One, &LIMITS).threshold;
        assert!(threshold(0) > threshold(2000) && threshold(2000) > threshold(20_000));
        let fixed = NoiseLimits { fixed: true, ..LIMITS };
        assert_eq!(noise(&distances(500, 0.5, 500, Conditions::One), Conditions::One, &fixed).threshold, 4.0);
    }

    #[test]
    fn guided_matches_tell_the_others_by_those_beyond_the_threshold() {
        let mut random = Random::new(5);
        let guided: Vec<f64> = (0..800).map(|_| 2.4 * random.below(1 << 20) as f64 / (1 << 20) as f64).collect();
        let all = [distances(1000, 0.3, 0, Conditions::One), guided].concat();
        let known = NoiseLimits { largest_threshold: 1.05, fixed: true };
        let found = noise(&all, Conditions::One, &known);
        assert!((found.sigma / 0.3 - 1.0).abs() < 0.1 && (found.good / 1000.0 - 1.0).abs() < 0.1, "{found:?}");
        assert!((found.others / 350.0 - 1.0).abs() < 0.15, "{found:?}");
    }

    #[test]
    fn strangers_alone_have_hardly_a_good_one() {
        let found = noise(&distances(0, 1.0, 3000, Conditions::One), Conditions::One, &LIMITS);
        assert!(found.good < 60.0, "{found:?}");
        assert_eq!(noise(&[], Conditions::One, &LIMITS).good, 0.0);
    }
}
