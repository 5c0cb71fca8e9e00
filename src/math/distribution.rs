//! Quantiles of the normal and the χ² distribution.

use std::f64::consts::{FRAC_1_SQRT_2, PI, SQRT_2};

/// The probability that a standard normal variable is below `x`.
pub(crate) fn normal_probability(x: f64) -> f64 {
    0.5 * libm::erfc(-x * FRAC_1_SQRT_2)
}

/// The probability that the size of a standard normal variable is above `limit`.
pub(crate) fn normal_outside(limit: f64) -> f64 {
    libm::erfc(limit * FRAC_1_SQRT_2)
}

/// The density of a standard normal variable.
pub(crate) fn normal_density(x: f64) -> f64 {
    libm::exp(-0.5 * x * x) / (SQRT_2 * PI.sqrt())
}

/// The value below which a standard normal variable lies with a probability above 0 and below 1.
pub(crate) fn normal_quantile(probability: f64) -> f64 {
    // The distribution rises steadily: bisection cannot fail, and ends at neighbouring numbers.
    bisect(-40.0, 40.0, |x| normal_probability(x) < probability)
}

/// The value below which a χ² variable of `freedom` degrees of freedom lies with a probability above 0 and below 1.
pub(crate) fn chi_square_quantile(probability: f64, freedom: f64) -> f64 {
    let spread = (2.0 * freedom).sqrt();
    bisect(0.0, freedom + 40.0 * spread + 80.0, |x| chi_square_probability(x, freedom) < probability)
}

/// The probability that a χ² variable of `freedom` degrees of freedom is below `x`.
///
/// # Source
/// Abramowitz & Stegun 1964, 6.5.29 (series) and 6.5.31 (continued fraction) of the incomplete gamma function.
pub(crate) fn chi_square_probability(x: f64, freedom: f64) -> f64 {
    let (a, x) = (0.5 * freedom, 0.5 * x);
    if x <= 0.0 {
        return 0.0;
    }
    let factor = libm::exp(a * libm::log(x) - x - libm::lgamma(a));
    if x < a + 1.0 {
        let (mut term, mut sum, mut n) = (1.0 / a, 1.0 / a, a);
        while term > 1e-17 * sum {
            n += 1.0;
            term *= x / n;
            sum += term;
        }
        return factor * sum;
    }
    // Lentz's evaluation.
    let mut b = x + 1.0 - a;
    let (mut c, mut d) = (1e300, 1.0 / b);
    let mut fraction = d;
    for k in 1..10_000 {
        let numerator = -f64::from(k) * (f64::from(k) - a);
        b += 2.0;
        d = 1.0 / (numerator * d + b);
        c = b + numerator / c;
        fraction *= c * d;
        if (c * d - 1.0).abs() < 1e-16 {
            break;
        }
    }
    1.0 - factor * fraction
}

/// The place between two at which a condition that holds at first no longer does.
pub(super) fn bisect(mut low: f64, mut high: f64, holds: impl Fn(f64) -> bool) -> f64 {
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            return middle;
        }
        if holds(middle) { low = middle } else { high = middle }
    }
}

/// The median magnitude of a standard normal variable that was cut at ± `limit`.
pub(crate) fn normal_median_within(limit: f64) -> f64 {
    normal_quantile(0.5 + 0.5 * (normal_probability(limit) - 0.5))
}

/// The standard deviation of a standard normal variable that was cut at ± `limit`.
pub(crate) fn normal_spread_within(limit: f64) -> f64 {
    // Beyond that nothing is cut, to the last bit.
    if !(limit < 30.0) {
        return 1.0;
    }
    let inside = 2.0 * normal_probability(limit) - 1.0;
    (1.0 - 2.0 * limit * normal_density(limit) / inside).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn normal_quantiles_are_those_of_the_tables() {
        for (probability, wanted) in
            [(0.5, 0.0), (0.975, 1.959_963_985), (0.9995, 3.290_526_731), (0.8, 0.841_621_234), (1e-6, -4.753_424_309)]
        {
            assert!((normal_quantile(probability) - wanted).abs() < 1e-8, "{probability}: {}", normal_quantile(probability));
        }
        assert!((normal_density(1.0) - 0.241_970_724_519).abs() < 1e-12);
    }

    #[test]
    fn chi_square_quantiles_are_those_of_the_tables() {
        let table = [
            (0.95, 1.0, 3.841_459),
            (0.025, 10.0, 3.246_973),
            (0.975, 10.0, 20.483_177),
            (0.5, 4.0, 3.356_694),
            (0.99, 100.0, 135.806_723),
            (0.025, 2000.0, 1_877.946_7),
        ];
        for (probability, freedom, wanted) in table {
            let got = chi_square_quantile(probability, freedom);
            assert!((got / wanted - 1.0).abs() < 1e-5, "{probability} {freedom}: {got}");
        }
    }
}
