//! The residual field of a camera: mean residual vectors on a grid over the image.

use crate::html::{count, dots, fixed, quantity, round_below, rounded, strokes};
use crate::{AdjustmentResult, ObservationVerdict, Texts};
use maud::{Markup, PreEscaped, html};

/// The longer side of the drawing, and the cells along it.
const SIDE: f64 = 420.0;
const CELLS: f64 = 12.0;
/// Cells with fewer residuals are left empty.
const LEAST: usize = 4;

/// Sums of the residuals of one cell.
#[derive(Debug, Clone, Copy, Default)]
struct Cell {
    number: usize,
    sum: [f64; 2],
    squares: f64,
}

impl Cell {
    fn mean(&self) -> [f64; 2] {
        self.sum.map(|sum| sum / self.number as f64)
    }

    /// What the mean square of the mean vector is by chance alone.
    fn chance(&self) -> f64 {
        let [x, y] = self.mean();
        let n = self.number as f64;
        (self.squares / n - (x * x + y * y)).max(0.0) / (n - 1.0)
    }
}

/// The residual field of a camera of an adjusted block.
pub(super) fn field(texts: &Texts, adjusted: &AdjustmentResult, camera: usize) -> Markup {
    let own = &adjusted.block.cameras[camera];
    let [width, height] = [own.width_px, own.height_px].map(f64::from);
    let longer = width.max(height);
    let [columns, rows] = [width, height].map(|side| ((CELLS * side / longer).round() as usize).max(1));
    let mut cells = vec![Cell::default(); columns * rows];
    for (ray, statistics) in adjusted.block.rays.iter().zip(&adjusted.rays) {
        if statistics.verdict != ObservationVerdict::Accepted || adjusted.block.images[ray.image].camera != camera {
            continue;
        }
        let place = |at: f64, side: f64, number: usize| ((at / side * number as f64).max(0.0) as usize).min(number - 1);
        let cell = &mut cells[place(ray.y_px, height, rows) * columns + place(ray.x_px, width, columns)];
        let [x, y] = statistics.residual_px;
        cell.number += 1;
        cell.sum = [cell.sum[0] + x, cell.sum[1] + y];
        cell.squares += x * x + y * y;
    }
    let filled: Vec<(usize, &Cell)> = cells.iter().enumerate().filter(|(_, cell)| cell.number >= LEAST).collect();
    if filled.is_empty() {
        return html! { p.note { (texts.say("report-few-residuals")) } };
    }
    let square = |[x, y]: [f64; 2]| x * x + y * y;
    let mean_square = |of: &dyn Fn(&Cell) -> f64| filled.iter().map(|(_, cell)| of(cell)).sum::<f64>() / filled.len() as f64;
    let (found, chance) = (mean_square(&|cell| square(cell.mean())).sqrt(), mean_square(&Cell::chance).sqrt());
    let largest = filled.iter().map(|(_, cell)| square(cell.mean())).fold(0.0, f64::max).sqrt();
    let scale = SIDE / longer;
    let cell_side = SIDE / CELLS;
    // The largest mean is nearly as long as a cell.
    let factor = 0.9 * cell_side / largest.max(f64::MIN_POSITIVE);
    let centre = |place: usize| {
        [(place % columns) as f64 + 0.5, (place / columns) as f64 + 0.5].into_iter().zip([width / columns as f64, height / rows as f64])
    };
    let vectors = filled.iter().map(|(place, cell)| {
        let mut at = centre(*place).map(|(number, side)| scale * number * side);
        let [x, y] = cell.mean();
        ([at.next().unwrap_or(0.0), at.next().unwrap_or(0.0)], [factor * x, factor * y])
    });
    let vectors: Vec<([f64; 2], [f64; 2])> = vectors.collect();
    let [w, h] = [scale * width, scale * height];
    let bar = round_below(largest);
    let observations = count(cells.iter().map(|cell| cell.number).sum());
    let figures = [("observations", observations), ("rms", fixed(found, 3)), ("chance", fixed(chance, 3))];
    let words = texts.with("report-mean-residuals", figures);
    html! {
        figure {
            svg.field viewBox=(format!("-1 -1 {:.0} {:.0}", SIDE + 2.0, h + 34.0)) role="img" aria-label=(words) {
                rect.frame width=(format!("{w:.1}")) height=(format!("{h:.1}")) {}
                path.mean d=(PreEscaped(strokes(vectors.iter().copied()))) {}
                path.centre d=(PreEscaped(dots(vectors.iter().map(|(at, _)| *at)))) {}
                path.scale d=(format!("M2 {:.1}v8h{:.1}v-8", h + 6.0, factor * bar)) {}
                text x=(format!("{:.1}", factor * bar + 8.0)) y=(format!("{:.1}", h + 17.0)) { (quantity(texts, rounded(bar), "px")) }
            }
            figcaption { (words) (texts.with("report-enlarged", [("factor", count((factor / scale).round() as usize))])) }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Block, BlockFlight, adjust_block, simulate_network};

    #[test]
    fn a_shift_of_part_of_the_image_stands_out_from_chance() {
        let simulated = simulate_network(&BlockFlight { strips: 2, exposures: 4, ..BlockFlight::default() }).unwrap();
        let mut adjusted = adjust_block(&simulated.observed, &crate::AdjustmentOptions::default()).unwrap();
        let figures = |html: Markup| -> Vec<f64> {
            let html = html.into_string();
            html.split("aria-label=\"")
                .nth(1)
                .unwrap()
                .split(" px")
                .take(2)
                .map(|text| text.rsplit(' ').next().unwrap().parse().unwrap())
                .collect()
        };
        let plain = figures(field(Texts::english(), &adjusted, 0));
        assert!(plain[0] < 1.5 * plain[1], "{plain:?}");
        let Block { rays, cameras, .. } = &adjusted.block;
        let middle = 0.5 * f64::from(cameras[0].width_px);
        for (ray, statistics) in rays.iter().zip(&mut adjusted.rays) {
            statistics.residual_px[0] += if ray.x_px < middle { 1.0 } else { -1.0 };
        }
        let shifted = figures(field(Texts::english(), &adjusted, 0));
        assert!(shifted[0] > 0.9 && shifted[1] < 0.3, "{shifted:?}");
    }
}
