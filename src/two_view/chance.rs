//! How many geometries would have as much support among matches that are all wrong.

use super::scale::Conditions;

/// How well a geometry is supported.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Support {
    /// Matches, and how many of them agree.
    pub count: usize,
    pub agreeing: usize,
    /// Matches of a minimal sample, which agree with any geometry through them, and the most geometries through one.
    pub sample: usize,
    pub models: usize,
    /// Probability that a wrong match agrees.
    pub chance: f64,
}

impl Support {
    /// Natural logarithm of the expected number of geometries with at least as much support, over all minimal samples and all numbers of
    /// agreeing matches, where wrong matches fall evenly over the image.
    ///
    /// # Source
    /// Moisan & Stival 2004, A probabilistic criterion to detect rigid point matches between two images and estimate the fundamental matrix,
    /// IJCV 57(3), eq. 9.
    pub fn log_false_alarms(&self) -> f64 {
        let Self { count, agreeing, sample, models, chance } = *self;
        if agreeing <= sample || count < agreeing {
            return f64::INFINITY;
        }
        let choices = libm::log((models * (count - sample)) as f64) + log_binomial(count, agreeing) + log_binomial(agreeing, sample);
        choices + (agreeing - sample) as f64 * libm::log(chance.clamp(f64::MIN_POSITIVE, 1.0))
    }
}

fn log_binomial(n: usize, k: usize) -> f64 {
    let log_factorial = |n: usize| libm::lgamma(n as f64 + 1.0);
    log_factorial(n) - log_factorial(k) - log_factorial(n - k)
}

/// Probability that a match which is wrong, its right position anywhere in the rectangle that holds those of `points`, is within a distance of
/// the geometry; points and distance in px. The distance is that of all four coordinates: that of the right position alone is up to √2 times
/// as long.
pub(super) fn chance_of_agreeing(points: &[[f64; 4]], distance_px: f64, conditions: Conditions) -> f64 {
    let extent = |axis: usize| {
        let values = points.iter().map(|p| p[axis]);
        values.clone().fold(f64::NEG_INFINITY, f64::max) - values.fold(f64::INFINITY, f64::min)
    };
    let (width, height) = (extent(2), extent(3));
    let reach = std::f64::consts::SQRT_2 * distance_px;
    let within = match conditions {
        Conditions::One => 2.0 * reach * (width * width + height * height).sqrt(),
        Conditions::Two => std::f64::consts::PI * reach * reach,
    };
    if width * height > within { within / (width * height) } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Random;

    #[test]
    fn the_number_is_that_of_its_definition() {
        // 3 geometries, 10 - 2 numbers, 120 choices of 3 in 10, 3 of 2 in 3, one by chance.
        let few = Support { count: 10, agreeing: 3, sample: 2, models: 3, chance: 0.01 };
        assert!((few.log_false_alarms() - libm::log(3.0 * 8.0 * 120.0 * 3.0 * 0.01)).abs() < 1e-9);
        assert_eq!(Support { agreeing: 2, ..few }.log_false_alarms(), f64::INFINITY);
    }

    #[test]
    fn wrong_matches_agree_with_a_line_or_a_place_as_often_as_is_told() {
        let mut random = Random::new(4);
        let mut uniform = |most: f64| most * random.below(1 << 20) as f64 / f64::from(1 << 20);
        let points: Vec<[f64; 4]> = (0..20_000).map(|_| [0.0, 0.0, uniform(800.0), uniform(600.0)]).collect();
        let share = |within: &dyn Fn(f64, f64) -> bool| points.iter().filter(|p| within(p[2], p[3])).count() as f64 / 20_000.0;
        let reach = 10.0 * std::f64::consts::SQRT_2;
        // The diagonal, the longest line there is.
        let line = share(&|x, y| (0.6 * x - 0.8 * y).abs() <= reach);
        let place = share(&|x, y| (x - 400.0) * (x - 400.0) + (y - 300.0) * (y - 300.0) <= reach * reach);
        assert!((chance_of_agreeing(&points, 10.0, Conditions::One) / line - 1.0).abs() < 0.1, "{line}");
        assert!((chance_of_agreeing(&points, 10.0, Conditions::Two) / place - 1.0).abs() < 0.3, "{place}");
        assert_eq!(chance_of_agreeing(&[[1.0; 4]; 9], 1.0, Conditions::One), 1.0);
    }
}
