//! Standard errors beside the intervals and ellipsoids that hold the truth in 95 % of cases.

use crate::html::significant;
use crate::outputs::precision::CoordinateErrors;
use crate::{Factors95, Texts, ellipsoid_semi_axes};
use maud::{Markup, html};

/// A standard error, and the half-width of its interval.
pub(super) fn with_interval(error: Option<f64>, factors: Option<Factors95>) -> Markup {
    let half_width = error.zip(factors).map(|(error, factors)| factors.interval * error);
    html! { (significant(error)) @if half_width.is_some() { " " small { "± " (significant(half_width)) } } }
}

/// The semi-axes of the ellipsoid of a position, the longest first; absent without correlations.
pub(super) fn ellipsoid(errors: &CoordinateErrors, factors: Option<Factors95>) -> Option<[f64; 3]> {
    let factor = factors?.ellipsoid;
    Some(ellipsoid_semi_axes(errors.errors, errors.correlations?).map(|axis| factor * axis))
}

/// Semi-axes in words; a dash where there are none.
pub(super) fn semi_axes(ellipsoid: Option<[f64; 3]>) -> String {
    ellipsoid.map_or_else(|| "–".into(), |axes| axes.map(significant).join(" × "))
}

/// What the figures behind ± and the ellipsoids are.
pub(super) fn note(texts: &Texts, factors: Option<Factors95>) -> Markup {
    html! {
        @if let Some(Factors95 { interval, ellipse, ellipsoid }) = factors {
            p.note {
                (texts.with("report-interval-95", [("interval", significant(interval))])) " "
                (texts.with("report-ellipses-and-ellipsoids", [("ellipse", significant(ellipse)), ("ellipsoid", significant(ellipsoid))]))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_interval_and_an_ellipsoid_follow_the_factors() {
        let factors = Some(Factors95 { interval: 2.0, ellipse: 2.5, ellipsoid: 3.0 });
        assert_eq!(with_interval(Some(0.25), factors).into_string(), "0.250 <small>± 0.500</small>");
        assert_eq!(with_interval(Some(0.25), None).into_string(), "0.250");
        assert_eq!(with_interval(None, factors).into_string(), "–");
        let errors = CoordinateErrors { errors: [1.0, 4.0, 2.0], correlations: Some([0.0; 3]) };
        assert_eq!(semi_axes(ellipsoid(&errors, factors)), "12.0 × 6.00 × 3.00");
        assert_eq!(semi_axes(ellipsoid(&CoordinateErrors { correlations: None, ..errors }, factors)), "–");
    }
}
