//! Drawings of reports: histogram, matrix of correlations.

use super::numbers::fixed;
use super::words::quantity;
use crate::Texts;
use maud::{Markup, html};

const WIDTH: f64 = 420.0;
const HEIGHT: f64 = 130.0;
const BINS: usize = 41;

/// A histogram of values about 0, of `reach` to either side; what lies beyond is counted in the outermost bins.
pub(crate) fn histogram(texts: &Texts, values: &[f64], reach: f64, unit: &str, words: &str) -> Markup {
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
                text x="0" y=(HEIGHT + 14.0) { (quantity(texts, fixed(-reach, 2), unit)) }
                text.middle x=(WIDTH / 2.0) y=(HEIGHT + 14.0) { "0" }
                text.end x=(WIDTH) y=(HEIGHT + 14.0) { (quantity(texts, fixed(reach, 2), unit)) }
            }
        }
    }
}

const CELL: f64 = 46.0;
const HEAD: f64 = 28.0;
/// The part of a cell that the number takes, below the square: a small square would strike it through.
const FOOT: f64 = 14.0;

/// The matrix of correlations of unknowns with these symbols: the area of a square stands for the magnitude, its colour for the sign.
pub(crate) fn correlations<R: AsRef<[f64]>>(symbols: &[&str], matrix: &[R], words: &str) -> Markup {
    let size = HEAD + symbols.len() as f64 * CELL;
    let at = |k: usize| HEAD + CELL * (k as f64 + 0.5);
    html! {
        figure {
            figcaption { (words) }
            svg.matrix viewBox=(format!("0 0 {size} {size}")) role="img" aria-label=(words) {
                @for (k, symbol) in symbols.iter().enumerate() {
                    text.middle x=(at(k)) y=(HEAD - 8.0) { (symbol) }
                    text.middle x=(HEAD / 2.0) y=(at(k) + 4.0) { (symbol) }
                }
                @for (i, row) in matrix.iter().enumerate() {
                    @for (j, value) in row.as_ref().iter().enumerate() {
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
