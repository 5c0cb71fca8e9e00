//! Drawings of the report: histogram, matrix of correlations, error ellipse.

use super::text::{UNKNOWNS, fixed};
use crate::ErrorEllipse;
use maud::{Markup, html};

const WIDTH: f64 = 420.0;
const HEIGHT: f64 = 130.0;
const BINS: usize = 41;

/// A histogram of values about 0, of `reach` to either side; what lies beyond is counted in the outermost bins.
pub fn histogram(values: &[f64], reach: f64, unit: &str, words: &str) -> Markup {
    let mut counts = [0usize; BINS];
    for value in values {
        let place = ((value / reach + 1.0) * 0.5 * BINS as f64).clamp(0.0, BINS as f64 - 1.0);
        counts[place as usize] += 1;
    }
    let most = counts.iter().copied().max().unwrap_or(0).max(1);
    let width = WIDTH / BINS as f64;
    html! {
        figure {
            figcaption { (words) }
            svg.histogram viewBox=(format!("0 0 {WIDTH} {}", HEIGHT + 18.0)) role="img" aria-label=(words) {
                @for (bin, count) in counts.iter().enumerate() {
                    @let height = HEIGHT * *count as f64 / most as f64;
                    rect.bar x=(format!("{:.1}", bin as f64 * width)) y=(format!("{:.1}", HEIGHT - height)) width=(format!("{:.1}", width - 1.0)) height=(format!("{height:.1}")) {}
                }
                path.axis d=(format!("M0 {HEIGHT}h{WIDTH}")) {}
                text x="0" y=(HEIGHT + 14.0) { (fixed(-reach, 2)) " " (unit) }
                text.middle x=(WIDTH / 2.0) y=(HEIGHT + 14.0) { "0" }
                text.end x=(WIDTH) y=(HEIGHT + 14.0) { (fixed(reach, 2)) " " (unit) }
            }
        }
    }
}

const CELL: f64 = 46.0;
const HEAD: f64 = 28.0;
/// The part of a cell that the number takes, below the square: a small square would strike it through.
const FOOT: f64 = 14.0;

/// The matrix of correlations: the area of a square stands for the magnitude, its colour for the sign.
pub fn correlations(matrix: &[[f64; 5]; 5]) -> Markup {
    let size = HEAD + 5.0 * CELL;
    let at = |k: usize| HEAD + CELL * (k as f64 + 0.5);
    html! {
        figure {
            figcaption { "Correlations of the unknowns" }
            svg.matrix viewBox=(format!("0 0 {size} {size}")) role="img" aria-label="Correlations of the unknowns" {
                @for (k, (symbol, _, _)) in UNKNOWNS.iter().enumerate() {
                    text.middle x=(at(k)) y=(HEAD - 8.0) { (symbol) }
                    text.middle x=(HEAD / 2.0) y=(at(k) + 4.0) { (symbol) }
                }
                @for (i, row) in matrix.iter().enumerate() {
                    @for (j, value) in row.iter().enumerate() {
                        @let side = (CELL - FOOT - 4.0) * value.abs().min(1.0).sqrt();
                        rect class=(if *value < 0.0 { "negative" } else { "positive" })
                            x=(format!("{:.1}", at(j) - side / 2.0)) y=(format!("{:.1}", at(i) - 0.5 * FOOT - side / 2.0)) width=(format!("{side:.1}")) height=(format!("{side:.1}")) {}
                        text.middle x=(at(j)) y=(at(i) + 0.5 * CELL - 4.0) { (fixed(*value, 2)) }
                    }
                }
            }
        }
    }
}

/// The standard error ellipse of by and bz; a cross where the truth lies.
pub fn ellipse(ellipse: &ErrorEllipse, error: Option<[f64; 2]>) -> Markup {
    let far = error.map_or(0.0, |[x, y]| x.abs().max(y.abs()));
    let scale = 70.0 / (2.0 * ellipse.semi_major).max(1.15 * far).max(f64::MIN_POSITIVE);
    let turned = format!("rotate({:.2})", -ellipse.bearing_deg);
    let words =
        format!("by, bz: standard error ellipse {} × {} µm", fixed(1000.0 * ellipse.semi_major, 1), fixed(1000.0 * ellipse.semi_minor, 1));
    html! {
        figure {
            figcaption { (words) "; dashed: twice as large, 2 standard errors" @if error.is_some() { "; cross: truth" } }
            svg.ellipse viewBox="-80 -80 160 160" role="img" aria-label=(words) {
                path.axis d="M-80 0h160M0 -80v160" {}
                @for (factor, class) in [(1.0, "outline"), (2.0, "outline faint")] {
                    ellipse class=(class) rx=(format!("{:.2}", factor * scale * ellipse.semi_major)) ry=(format!("{:.2}", factor * scale * ellipse.semi_minor)) transform=(turned) {}
                }
                // The truth lies where the error is undone.
                @if let Some([x, y]) = error { path.truth d=(format!("M{:.1} {:.1}m-5 -5l10 10m-10 0l10 -10", -x * scale, y * scale)) {} }
                text x="62" y="-4" { "by" }
                text x="4" y="-68" { "bz" }
            }
        }
    }
}
