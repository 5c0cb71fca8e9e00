//! Drawing of the report: error ellipse of the base.

use crate::html::significant;
use crate::{ErrorEllipse, Texts};
use maud::{Markup, html};

/// The standard error ellipse of by and bz, dashed that of 95 %; a cross where the truth lies.
pub fn ellipse(texts: &Texts, ellipse: &ErrorEllipse, of_95: Option<&ErrorEllipse>, error: Option<[f64; 2]>) -> Markup {
    let far = error.map_or(0.0, |[x, y]| x.abs().max(y.abs()));
    let largest = of_95.unwrap_or(ellipse).semi_major;
    let scale = 70.0 / largest.max(1.15 * far).max(f64::MIN_POSITIVE);
    let turned = format!("rotate({:.2})", -ellipse.bearing_deg);
    let axes = format!("{} × {}", significant(1000.0 * ellipse.semi_major), significant(1000.0 * ellipse.semi_minor));
    let words = texts.with("report-error-ellipse", [("axes", axes)]);
    html! {
        figure {
            figcaption {
                (words)
                @if of_95.is_some() { (texts.say("report-ellipse-dashed")) }
                @if error.is_some() { (texts.say("report-ellipse-cross")) }
            }
            svg.ellipse viewBox="-80 -80 160 160" role="img" aria-label=(words) {
                path.axis d="M-80 0h160M0 -80v160" {}
                @for (one, class) in [(Some(ellipse), "outline"), (of_95, "outline faint")].into_iter().filter_map(|(one, class)| Some((one?, class))) {
                    ellipse class=(class) rx=(format!("{:.2}", scale * one.semi_major)) ry=(format!("{:.2}", scale * one.semi_minor)) transform=(turned) {}
                }
                // The truth lies where the error is undone.
                @if let Some([x, y]) = error { path.truth d=(format!("M{:.1} {:.1}m-5 -5l10 10m-10 0l10 -10", -x * scale, y * scale)) {} }
                text x="62" y="-4" { "by" }
                text x="4" y="-68" { "bz" }
            }
        }
    }
}
