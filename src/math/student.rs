//! Distributions of what is divided by an estimated standard error: Student's t, central and not, F, and Pope's τ.

use super::distribution::{bisect, chi_square_probability, chi_square_quantile, normal_density, normal_probability, normal_quantile};
use std::f64::consts::{LN_2, PI};

/// The natural logarithm of the regularised incomplete beta function I_x(a, b).
///
/// # Source
/// Abramowitz & Stegun 1964, 26.5.8 (continued fraction), evaluated after Lentz 1976.
fn ln_incomplete_beta(x: f64, a: f64, b: f64) -> f64 {
    if x <= 0.0 {
        return f64::NEG_INFINITY;
    }
    if x >= 1.0 {
        return 0.0;
    }
    if x > (a + 1.0) / (a + b + 2.0) {
        return libm::log1p(-libm::exp(ln_incomplete_beta(1.0 - x, b, a)).min(1.0));
    }
    let ln_beta = libm::lgamma(a) + libm::lgamma(b) - libm::lgamma(a + b);
    a * libm::log(x) + b * libm::log1p(-x) - ln_beta - libm::log(a) - libm::log(beta_fraction(x, a, b))
}

/// The continued fraction by which the leading term of the incomplete beta function is divided.
fn beta_fraction(x: f64, a: f64, b: f64) -> f64 {
    let (mut c, mut d, mut fraction) = (1.0, 0.0, 1.0);
    for m in 1..100_000 {
        let (k, odd) = (f64::from(m / 2), m % 2 == 1);
        let numerator = if odd {
            -(a + k) * (a + b + k) * x / ((a + 2.0 * k) * (a + 2.0 * k + 1.0))
        } else {
            k * (b - k) * x / ((a + 2.0 * k - 1.0) * (a + 2.0 * k))
        };
        d = 1.0 / (1.0 + numerator * d);
        c = 1.0 + numerator / c;
        fraction *= c * d;
        if (c * d - 1.0).abs() < 1e-15 {
            break;
        }
    }
    fraction
}

/// The natural logarithm of the probability that a variable of the F distribution with these degrees of freedom is above `ratio`.
pub(crate) fn ln_f_above(ratio: f64, numerator: f64, denominator: f64) -> f64 {
    ln_incomplete_beta(denominator / (denominator + numerator * ratio), 0.5 * denominator, 0.5 * numerator)
}

/// The value that a variable of the F distribution with `numerator` and `denominator` degrees of freedom exceeds with the probability `above`;
/// without a denominator, that of χ² by its degrees of freedom.
pub(crate) fn f_limit(above: f64, numerator: usize, denominator: Option<usize>) -> f64 {
    let numerator = numerator.max(1) as f64;
    let wanted = libm::log(above);
    if numerator == 2.0 {
        // ν (above^(-2/ν) - 1) / 2.
        return denominator.map_or(-wanted, |denominator| {
            let half = 0.5 * denominator.max(1) as f64;
            half * libm::expm1(-wanted / half)
        });
    }
    denominator.map_or_else(
        || chi_square_quantile(1.0 - above, numerator) / numerator,
        |denominator| bisect(0.0, 1e12, |x| ln_f_above(x, numerator, denominator.max(1) as f64) > wanted),
    )
}

/// By how much the standard error ellipsoid of `unknowns` grows (a standard error for one, an ellipse for two) for all of them to lie in it with
/// the probability 1 - `outside`: √(u F). `freedom`: degrees of freedom of the σ by which standard errors are; `None` where it is known.
///
/// # Source
/// Scheffé 1959, The analysis of variance, 2.3.
pub(crate) fn joint_limit(outside: f64, unknowns: usize, freedom: Option<usize>) -> f64 {
    (unknowns as f64 * f_limit(outside, unknowns, freedom)).sqrt()
}

/// The natural logarithm of the number of choices of `k` out of `n`.
pub(crate) fn ln_choices(n: usize, k: usize) -> f64 {
    let ln_factorial = |n: usize| libm::lgamma(n as f64 + 1.0);
    ln_factorial(n) - ln_factorial(k) - ln_factorial(n - k)
}

/// The value that the size of a variable of Student's distribution with `freedom` (1 or more) degrees of freedom exceeds with the probability `both_sides`.
pub(crate) fn student_limit(both_sides: f64, freedom: usize) -> f64 {
    let nu = freedom.max(1) as f64;
    // Wallace 1959, Bounds on normal approximations to Student's and the chi-square distributions, inverted: a start.
    let stretched = normal_quantile(1.0 - 0.5 * both_sides) * (8.0 * nu + 3.0) / (8.0 * nu + 1.0);
    let mut t = (nu * libm::expm1(stretched * stretched / nu)).sqrt();
    let ln_density = libm::lgamma(0.5 * (nu + 1.0)) - libm::lgamma(0.5 * nu) - 0.5 * libm::log(nu * PI);
    // Newton's steps of the logarithms, of which one is nearly linear in the other.
    for _ in 0..50 {
        let ln_outside = ln_incomplete_beta(nu / (nu + t * t), 0.5 * nu, 0.5);
        let ln_both = ln_density - 0.5 * (nu + 1.0) * libm::log1p(t * t / nu) + LN_2;
        let step = (ln_outside - libm::log(both_sides)) / (t * libm::exp(ln_both - ln_outside));
        t *= libm::exp(step.clamp(-1.0, 1.0));
        if step.abs() < 1e-14 {
            break;
        }
    }
    t
}

/// The value that the size of a residual, standardised by a σ that it took part in estimating, exceeds with the probability `both_sides`; infinite
/// where there is one degree of freedom, with which all such residuals have the size 1.
///
/// # Source
/// Pope 1976, The statistics of residuals and the detection of outliers (the distribution of τ).
pub(crate) fn tau_limit(both_sides: f64, freedom: usize) -> f64 {
    if freedom < 2 {
        return f64::INFINITY;
    }
    let (r, t) = (freedom as f64, student_limit(both_sides, freedom - 1));
    // √r t / √(r - 1 + t²), which a large t does not overflow.
    (r / (1.0 + (r - 1.0) / (t * t))).sqrt()
}

/// The density of τ with `freedom` (above 1, not necessarily whole) degrees of freedom.
fn tau_density(tau: f64, freedom: f64) -> f64 {
    let ln = libm::lgamma(0.5 * freedom) - libm::lgamma(0.5 * (freedom - 1.0)) - 0.5 * libm::log(PI * freedom);
    libm::exp(ln + 0.5 * (freedom - 3.0) * libm::log1p(-tau * tau / freedom))
}

/// No limit that rejects a tenth of good observations leaves less of their variance.
const LEAST_LEFT: f64 = 0.1;

/// What rejection beyond a limit leaves of the variance that the kept residuals show: the estimated σ² is to be divided by it. Exactly 1 where
/// nothing was rejected or one degree of freedom is left.
///
/// `kept` observations have `freedom` degrees of freedom, `rejected` were rejected by residuals beyond what good ones exceed with the probability
/// `both_sides`. Of the rejected ones, no more than the share `both_sides` of all good ones can have been good: gross errors take nothing
/// from the distribution of the others. With σ² of all, nothing of it is cut, whatever the largest residual is: τ and σ² are independent.
///
/// # Source
/// Basu 1955, On statistics independent of a complete sufficient statistic; Pope 1976. ∫ (1 - τ²) f(τ) within ± c is 2c (1 - c²/r) f(c).
pub(crate) fn variance_left(kept: usize, freedom: usize, rejected: usize, both_sides: f64) -> f64 {
    if rejected == 0 || freedom < 2 || both_sides < f64::MIN_POSITIVE {
        return 1.0;
    }
    // Of `good` observations the share `both_sides` lies beyond: good = kept + both_sides · good.
    let expected = both_sides * kept as f64 / (1.0 - both_sides);
    let by_mistake = expected.min(rejected as f64);
    let before = freedom as f64 + by_mistake.max(1.0);
    let limit = tau_limit(both_sides, before.round() as usize);
    let cut = 2.0 * limit * (1.0 - limit * limit / before).max(0.0) * tau_density(limit.min(before.sqrt()), before);
    // Each rejection by mistake takes more than its share of the squares.
    (1.0 - by_mistake / both_sides * cut / freedom as f64).clamp(LEAST_LEFT, 1.0)
}

/// The shift, in standard errors of a residual, with which its size exceeds the limit of a test of this significance with the probability
/// `power`. `freedom`: degrees of freedom of the adjustment whose σ the test uses, the residual's own among them, so that the test follows Student's
/// distribution with one fewer; `None` where σ is known. Infinite where fewer than two are left.
///
/// # Source
/// Baarda 1968 (δ₀ of a known σ); Pope 1976; the probability is that of the non-central t distribution.
pub(crate) fn detectable_shift(both_sides: f64, power: f64, freedom: Option<usize>) -> f64 {
    let Some(freedom) = freedom else {
        return normal_quantile(1.0 - 0.5 * both_sides) + normal_quantile(power);
    };
    if freedom < 2 {
        return f64::INFINITY;
    }
    let nu = freedom - 1;
    let limit = student_limit(both_sides, nu);
    let wanted = normal_quantile(power);
    let reached = |shift: f64| normal_quantile(beyond(shift, limit, nu).clamp(1e-15, 1.0 - 1e-15)) - wanted;
    // The probability rises steadily: a secant within a bracket, by the scale on which it is nearly straight. An end that stays counts half
    // (the Illinois rule), so that both come nearer.
    let (mut low, mut high) = (0.0, 2.0 * limit);
    let (mut at_low, mut at_high) = (reached(low), reached(high));
    while at_high < 0.0 {
        (low, at_low) = (high, at_high);
        high *= 2.0;
        at_high = reached(high);
    }
    let (mut shift, mut rose) = (high, None);
    for _ in 0..100 {
        let next = (low * at_high - high * at_low) / (at_high - at_low);
        let value = reached(next);
        let rises = value < 0.0;
        let again = if rose == Some(rises) { 0.5 } else { 1.0 };
        if rises {
            (low, at_low, at_high) = (next, value, again * at_high);
        } else {
            (high, at_high, at_low) = (next, value, again * at_low);
        }
        let change = (next - shift).abs();
        (shift, rose) = (next, Some(rises));
        if change <= 1e-10 * next {
            break;
        }
    }
    shift
}

/// With few degrees of freedom the integral runs over the numerator of t, else over its denominator: the other factor is then smooth.
const FEW: usize = 8;

/// From this shift on, the probability of the other side is below 1e-9 of any power.
const OTHER_SIDE: f64 = 3.0;

/// The probability that the size of a non-central t of this shift exceeds `limit`.
fn beyond(shift: f64, limit: f64, freedom: usize) -> f64 {
    let nu = freedom as f64;
    // Sums of equal steps: for bell-shaped integrands they are exact to the last digits (trapezoidal rule).
    if freedom <= FEW {
        const STEP: f64 = 0.25;
        let below = |z: f64| {
            let ratio = (shift + z) / limit;
            chi_square_probability(nu * ratio * ratio, nu)
        };
        return (-32..=32).map(|k| STEP * f64::from(k)).map(|z| STEP * normal_density(z) * below(z)).sum();
    }
    // The denominator: χ/√ν with about the standard deviation 1/√(2ν) about 1.
    let step = 0.25 / (2.0 * nu).sqrt();
    let ln_constant = LN_2 + 0.5 * nu * libm::log(0.5 * nu) - libm::lgamma(0.5 * nu);
    let at = |k: i32| {
        let s = 1.0 + step * f64::from(k);
        if s <= 0.0 {
            return 0.0;
        }
        let density = libm::exp(ln_constant + (nu - 1.0) * libm::log(s) - 0.5 * nu * s * s);
        let other = if shift < OTHER_SIDE { normal_probability(-shift - limit * s) } else { 0.0 };
        density * (normal_probability(shift - limit * s) + other)
    };
    step * (-32..=32).map(at).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limits_of_the_f_distribution_are_those_of_the_tables() {
        for (above, numerator, denominator, wanted) in
            [(0.05, 3, Some(20), 3.0984), (0.01, 2, Some(10), 7.5594), (0.05, 1, Some(1), 161.448), (0.05, 3, None, 2.6049)]
        {
            let got = f_limit(above, numerator, denominator);
            assert!((got / wanted - 1.0).abs() < 1e-4, "{above} {numerator} {denominator:?}: {got}");
        }
        assert!((f_limit(0.001, 3, Some(1_000_000)) / f_limit(0.001, 3, None) - 1.0).abs() < 1e-4);
    }

    #[test]
    fn joint_limits_are_those_of_the_tables() {
        // Student's two-sided limits; √(2 F) and √(3 F) of the F tables; √χ² where σ is known.
        let table = [
            (1, Some(1), 12.7062),
            (1, Some(5), 2.570_582),
            (1, None, 1.959_964),
            (2, Some(1), (2.0_f64 * 199.5).sqrt()),
            (2, Some(5), (2.0_f64 * 5.786_14).sqrt()),
            (2, Some(120), (2.0_f64 * 3.071_8).sqrt()),
            (2, None, 5.991_465_f64.sqrt()),
            (3, Some(1), (3.0_f64 * 215.7073).sqrt()),
            (3, Some(5), (3.0_f64 * 5.409_45).sqrt()),
            (3, None, 7.814_728_f64.sqrt()),
        ];
        for (unknowns, freedom, wanted) in table {
            let got = joint_limit(0.05, unknowns, freedom);
            assert!((got / wanted - 1.0).abs() < 2e-5, "{unknowns} {freedom:?}: {got} {wanted}");
        }
        for freedom in [1, 7, 400] {
            assert!((joint_limit(0.01, 1, Some(freedom)) / student_limit(0.01, freedom) - 1.0).abs() < 1e-9, "{freedom}");
            // Two numerator degrees of freedom in closed form, as the incomplete beta function has them.
            let ratio = f_limit(0.05, 2, Some(freedom));
            assert!((libm::exp(ln_f_above(ratio, 2.0, freedom as f64)) / 0.05 - 1.0).abs() < 1e-9, "{freedom}");
        }
    }

    #[test]
    fn limits_are_those_of_the_tables_of_student() {
        // Two-sided: Abramowitz & Stegun, table 26.10, and 3.291 of the normal distribution.
        let table = [
            (0.05, 1, 12.706_205),
            (0.05, 2, 4.302_653),
            (0.05, 5, 2.570_582),
            (0.05, 30, 2.042_272),
            (0.001, 1, 636.619_249),
            (0.001, 4, 8.610_302),
            (0.001, 9, 4.780_913),
            (0.001, 120, 3.373_454),
            (0.2, 10, 1.372_184),
            (0.001, 1_000_000, 3.290_536),
        ];
        for (probability, freedom, wanted) in table {
            let got = student_limit(probability, freedom);
            assert!((got / wanted - 1.0).abs() < 3e-7, "{probability} {freedom}: {got}");
        }
    }

    #[test]
    fn the_f_distribution_is_that_of_the_tables() {
        for (ratio, numerator, denominator, wanted) in
            [(3.325_835, 5.0, 10.0, 0.05), (5.636_326, 5.0, 10.0, 0.01), (4.351_244, 1.0, 20.0, 0.05), (230.161_9, 5.0, 1.0, 0.05)]
        {
            let got = libm::exp(ln_f_above(ratio, numerator, denominator));
            assert!((got / wanted - 1.0).abs() < 1e-5, "{numerator} {denominator}: {got}");
        }
        // Where numbers have long underflown: (1 + 2 f / ν)^(-ν/2) with two degrees of freedom in the numerator.
        let (ratio, freedom) = (1e9, 400.0);
        assert!((ln_f_above(ratio, 2.0, freedom) / (-0.5 * freedom * libm::log1p(2.0 * ratio / freedom)) - 1.0).abs() < 1e-9);
        assert!((libm::exp(ln_choices(20, 12)) / 125_970.0 - 1.0).abs() < 1e-12);
    }

    #[test]
    fn limits_of_tau_are_those_of_pope() {
        // √r t / √(r - 1 + t²) of t at r - 1.
        for (freedom, wanted) in [(2, 1.414_212), (5, 2.178_204), (10, 2.678_436), (15, 2.873_8), (95, 3.223_0)] {
            assert!((tau_limit(0.001, freedom) - wanted).abs() < 3e-3, "{freedom}: {}", tau_limit(0.001, freedom));
        }
        assert_eq!(tau_limit(0.001, 1), f64::INFINITY);
        // The density has the area 1.
        for freedom in [4.0, 7.0, 30.0] {
            let reach = f64::sqrt(freedom);
            let area: f64 =
                (0..20_000).map(|k| -reach + 2.0 * reach * (f64::from(k) + 0.5) / 20_000.0).map(|t| tau_density(t, freedom)).sum();
            assert!((area * 2.0 * reach / 20_000.0 - 1.0).abs() < 1e-3, "{freedom}");
        }
    }

    #[test]
    fn what_is_detectable_grows_where_few_residuals_estimate_sigma() {
        let known = detectable_shift(0.001, 0.8, None);
        assert!((known - 4.132_148).abs() < 1e-5, "{known}");
        for (points, wanted) in [(10, 10.7), (15, 5.90), (20, 5.13), (30, 4.66), (100, 4.25)] {
            let got = detectable_shift(0.001, 0.8, Some(points - 5));
            assert!((got / wanted - 1.0).abs() < 0.005, "{points}: {got}");
        }
        assert!((detectable_shift(0.001, 0.8, Some(1_000_000)) - known).abs() < 1e-4);
        assert_eq!(detectable_shift(0.001, 0.8, Some(1)), f64::INFINITY);
        // Both ways of integration agree where they meet, and the probability without a shift is the significance.
        for freedom in [2, 5, 8, 9, 200] {
            let limit = student_limit(0.01, freedom);
            assert!((beyond(0.0, limit, freedom) / 0.01 - 1.0).abs() < 1e-6, "{freedom}: {}", beyond(0.0, limit, freedom));
        }
        for (alpha0, beta0) in [(1e-6, 0.5), (0.001, 0.999), (0.2, 0.95)] {
            for freedom in [2, 3, 6, 9, 10, 500] {
                let shift = detectable_shift(alpha0, beta0, Some(freedom));
                let power = beyond(shift, student_limit(alpha0, freedom - 1), freedom - 1);
                assert!((power - beta0).abs() < 1e-8, "{alpha0} {beta0} {freedom}: {power}");
            }
        }
    }

    #[test]
    fn truncation_leaves_what_the_normal_distribution_says_of_many() {
        assert_eq!(variance_left(20, 15, 0, 0.001), 1.0);
        assert_eq!(variance_left(6, 1, 2, 0.001), 1.0);
        for both_sides in [0.001, 0.05, 0.2] {
            let spread = super::super::normal_spread_within(normal_quantile(1.0 - 0.5 * both_sides));
            let got = variance_left(1_000_000, 999_995, 500_000, both_sides);
            assert!((got / (spread * spread) - 1.0).abs() < 1e-4, "{both_sides}: {got} {}", spread * spread);
        }
        assert!(variance_left(20, 15, 1, 0.001) > 0.98);
    }
}
