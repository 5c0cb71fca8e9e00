//! Where a left point is expected in the right image: a smooth field of offsets.

use super::correlation::{Patch, best_overlap};
use crate::error::refuse;
use crate::math::median;
use crate::{Error, GreyView, Reduced, Refusal, halve, reduce_to};
use serde::{Deserialize, Serialize};

/// Longer side of the image on which estimation ends: finer levels would not narrow the search window further.
const FINEST: usize = 1024;
/// Longer side of the image on which it starts with all translations.
const COARSEST: usize = 64;
/// Intervals between nodes along the longer side.
const INTERVALS: usize = 16;
/// Half the side of a correlated patch in px.
const PATCH_REACH: usize = 10;
/// Px searched about the expected offset on the first level of patches, where a rotation is still unknown, and on the finer ones.
const REACHES: [usize; 2] = [5, 3];
/// Least correlation of a node that is believed.
const LEAST_CORRELATION: f64 = 0.5;

/// Expected offsets (right minus left position) at the nodes of a square grid over the left image, in between bilinear.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct OffsetField {
    pub columns: usize,
    pub rows: usize,
    /// Distance of the nodes in px; the first lies at (0, 0).
    pub spacing_px: f64,
    /// `[dx, dy]` in px of each node, row by row.
    pub offsets: Vec<[f64; 2]>,
    /// Median of the offsets that were found, in px.
    pub median_px: [f64; 2],
    /// Median correlation of the nodes that were found; absent for a given offset.
    pub correlation: Option<f64>,
}

impl OffsetField {
    /// The same offset everywhere.
    pub fn constant(dx_px: f64, dy_px: f64) -> Self {
        Self { columns: 1, rows: 1, spacing_px: 1.0, offsets: vec![[dx_px, dy_px]], median_px: [dx_px, dy_px], correlation: None }
    }

    /// The expected offset at a left position; beyond the outer nodes theirs.
    pub fn at(&self, x_px: f64, y_px: f64) -> [f64; 2] {
        let along = |position: f64, nodes: usize| {
            let place = (position / self.spacing_px).clamp(0.0, (nodes - 1) as f64);
            let first = (place as usize).min(nodes.saturating_sub(2));
            (first, (first + 1).min(nodes - 1), place - first as f64)
        };
        let ((left, right, u), (top, bottom, v)) = (along(x_px, self.columns), along(y_px, self.rows));
        let node = |column: usize, row: usize| self.offsets[row * self.columns + column];
        std::array::from_fn(|axis| {
            let above = node(left, top)[axis] * (1.0 - u) + node(right, top)[axis] * u;
            let below = node(left, bottom)[axis] * (1.0 - u) + node(right, bottom)[axis] * u;
            above * (1.0 - v) + below * v
        })
    }

    /// Refuses a field whose parts do not fit together.
    pub fn check(&self) -> Result<(), Error> {
        let nodes = self.columns.checked_mul(self.rows);
        let finite = self.offsets.iter().flatten().all(|v| v.is_finite());
        if nodes != Some(self.offsets.len()) || nodes == Some(0) || !finite || !(self.spacing_px > 0.0 && self.spacing_px.is_finite()) {
            let Self { columns, rows, spacing_px, .. } = *self;
            return refuse(Refusal::OffsetField { columns, rows, offsets: self.offsets.len(), spacing_px });
        }
        Ok(())
    }
}

/// Estimates the offsets between two overlapping images by correlation from coarse to fine.
///
/// On a small image all translations are correlated; on each finer level patches around a grid of nodes follow, so that rotation (to
/// about 10°), scale and relief are taken up. Nodes that correlate below 0.5, or deviate from their neighbours, take the value that
/// the others suggest. Images without common content give offsets with a low `correlation`: see there before relying on them.
pub fn estimate_offset(left: GreyView<'_>, right: GreyView<'_>) -> OffsetField {
    estimate_offset_of_reduced(&reduce_to(left, FINEST), &reduce_to(right, FINEST))
}

/// As [`estimate_offset`], from images that were reduced already.
pub fn estimate_offset_of_reduced(left: &Reduced, right: &Reduced) -> OffsetField {
    let halvings = left.halvings.max(right.halvings);
    let levels = levels_of(left.halved_to(halvings), right.halved_to(halvings));
    let (coarse_left, coarse_right) = levels.last().expect("there is at least one level");
    let start = best_overlap(coarse_left.view(), coarse_right.view());
    let mut field = OffsetField::constant(start[0] as f64, start[1] as f64);
    for (k, (left, right)) in levels.iter().enumerate().rev() {
        let first = k + 1 == levels.len();
        if !first {
            field = scaled(&field, 2.0);
        }
        field = refine(left.view(), right.view(), &field, REACHES[usize::from(!first)]);
    }
    scaled(&field, f64::from(1u32 << halvings))
}

type Level = (crate::GreyImage, crate::GreyImage);

/// The pair and its halvings, down to the coarsest.
fn levels_of(left: crate::GreyImage, right: crate::GreyImage) -> Vec<Level> {
    let mut levels = vec![(left, right)];
    loop {
        let (left, right) = &levels[levels.len() - 1];
        if left.width().max(left.height()).max(right.width()).max(right.height()) <= COARSEST {
            return levels;
        }
        levels.push((halve(left.view()), halve(right.view())));
    }
}

/// The field on an image `factor` times as large.
fn scaled(field: &OffsetField, factor: f64) -> OffsetField {
    OffsetField {
        spacing_px: field.spacing_px * factor,
        offsets: field.offsets.iter().map(|o| o.map(|v| v * factor)).collect(),
        median_px: field.median_px.map(|v| v * factor),
        ..field.clone()
    }
}

/// Offset and correlation that a node found, if it did.
type Node = Option<([f64; 2], f64)>;

/// The field that patches around the nodes find near the expected one.
fn refine(left: GreyView<'_>, right: GreyView<'_>, expected: &OffsetField, reach: usize) -> OffsetField {
    let spacing = (left.width().max(left.height()) as f64 / INTERVALS as f64).max(4.0);
    let (columns, rows) = ((left.width() as f64 / spacing) as usize + 1, (left.height() as f64 / spacing) as usize + 1);
    let position = |k: usize| [(k % columns) as f64 * spacing, (k / columns) as f64 * spacing];
    let found: Vec<Node> = (0..columns * rows)
        .map(|k| {
            let [x, y] = position(k);
            let patch = Patch::around(left, x, y, PATCH_REACH)?;
            // A patch at the border stands further inside than its node: it is expected where it stands.
            let [cx, cy] = patch.centre();
            patch.best_in(right, expected.at(cx, cy), reach).filter(|(_, correlation)| *correlation >= LEAST_CORRELATION)
        })
        .collect();
    let found = without_outliers(&found, columns);
    let mut correlations: Vec<f64> = found.iter().flatten().map(|n| n.1).collect();
    let Some(correlation) = median(&mut correlations) else {
        return OffsetField { correlation: Some(0.0), ..expected.clone() };
    };
    let along = |axis: usize| median(&mut found.iter().flatten().map(|n| n.0[axis]).collect::<Vec<_>>()).expect("some node was found");
    let median_px = [along(0), along(1)];
    let trend = Trend::fit((0..found.len()).filter_map(|k| found[k].map(|n| (position(k), n.0))), median_px);
    let offsets = filled(&found, columns, |k| trend.at(position(k)));
    OffsetField { columns, rows, spacing_px: spacing, offsets, median_px, correlation: Some(correlation) }
}

/// Drops the nodes that differ by more than 2 px, or 3 times the scatter, from the median of the nodes around them.
fn without_outliers(found: &[Node], columns: usize) -> Vec<Node> {
    let around = |k: usize| {
        let (column, row) = (k % columns, k / columns);
        let near = move |other: &usize| (other % columns).abs_diff(column) <= 2 && (other / columns).abs_diff(row) <= 2;
        (0..found.len()).filter(near).filter(move |other| *other != k).filter_map(|other| found[other].map(|n| n.0))
    };
    let stands = |k: usize, axis: usize, own: f64| {
        let mut values: Vec<f64> = around(k).map(|o| o[axis]).collect();
        let Some(middle) = median(&mut values) else { return false };
        values.iter_mut().for_each(|v| *v = (*v - middle).abs());
        (own - middle).abs() <= (3.0 * 1.4826 * median(&mut values).unwrap_or(0.0)).max(2.0)
    };
    (0..found.len()).map(|k| found[k].filter(|(o, _)| stands(k, 0, o[0]) && stands(k, 1, o[1]))).collect()
}

/// Gives the nodes that found nothing the trend plus what their neighbours deviate from it, spreading outwards.
fn filled(found: &[Node], columns: usize, trend: impl Fn(usize) -> [f64; 2]) -> Vec<[f64; 2]> {
    let mut residuals: Vec<Option<[f64; 2]>> = (0..found.len()).map(|k| found[k].map(|n| difference(n.0, trend(k)))).collect();
    while residuals.iter().any(Option::is_none) {
        let before = residuals.clone();
        for k in (0..found.len()).filter(|k| before[*k].is_none()) {
            let (column, row) = (k % columns, k / columns);
            let near = |other: &usize| (other % columns).abs_diff(column) + (other / columns).abs_diff(row) == 1;
            let known: Vec<[f64; 2]> = (0..found.len()).filter(near).filter_map(|other| before[other]).collect();
            if !known.is_empty() {
                // Halved at each step outwards: far from what was found only the trend remains.
                residuals[k] = Some([0, 1].map(|axis| 0.5 * known.iter().map(|r| r[axis]).sum::<f64>() / known.len() as f64));
            }
        }
    }
    residuals.iter().enumerate().map(|(k, r)| difference(trend(k), r.map_or([0.0; 2], |r| [-r[0], -r[1]]))).collect()
}

fn difference(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

/// Offsets as linear functions of the position.
struct Trend {
    centre: [f64; 2],
    /// Constant, change with x, change with y, for dx and dy.
    coefficients: [[f64; 3]; 2],
}

impl Trend {
    /// Least squares; the constant `fallback` where the positions do not determine slopes.
    fn fit(nodes: impl Iterator<Item = ([f64; 2], [f64; 2])> + Clone, fallback: [f64; 2]) -> Self {
        let number = nodes.clone().count() as f64;
        let mean = |axis: usize| nodes.clone().map(|(p, _)| p[axis]).sum::<f64>() / number;
        let centre = [mean(0), mean(1)];
        let mut normal = nalgebra::Matrix3::zeros();
        let mut rhs = [nalgebra::Vector3::zeros(); 2];
        for (position, offset) in nodes {
            let [x, y] = difference(position, centre);
            let row = nalgebra::Vector3::new(1.0, x, y);
            normal += row * row.transpose();
            rhs[0] += row * offset[0];
            rhs[1] += row * offset[1];
        }
        let coefficients = match normal.cholesky().filter(|_| number >= 6.0) {
            Some(cholesky) => rhs.map(|b| cholesky.solve(&b).into()),
            None => fallback.map(|constant| [constant, 0.0, 0.0]),
        };
        Self { centre, coefficients }
    }

    fn at(&self, position: [f64; 2]) -> [f64; 2] {
        let [x, y] = difference(position, self.centre);
        self.coefficients.map(|[c, cx, cy]| c + cx * x + cy * y)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::GreyImage;

    /// A smooth random texture, the same at the same real position.
    fn texture(x: f64, y: f64) -> f64 {
        let wave = |f: f64, a: f64, p: f64| libm::sin(f * (x * libm::cos(a) + y * libm::sin(a)) + p);
        let sum: f64 = (0..24).map(|k| wave(0.012 * libm::pow(1.17, f64::from(k)), f64::from(k) * 2.4, f64::from(k * k))).sum();
        128.0 + 14.0 * sum
    }

    fn view_of(width: usize, height: usize, place: impl Fn(f64, f64) -> [f64; 2]) -> GreyImage {
        GreyImage::from_fn(width, height, |col, row| {
            let [x, y] = place(col as f64 + 0.5, row as f64 + 0.5);
            texture(x, y).clamp(0.0, 255.0) as u8
        })
        .unwrap()
    }

    fn greatest_error(
        field: &OffsetField,
        width: f64,
        height: f64,
        expected: impl Fn(f64, f64) -> [f64; 2],
        inside: impl Fn(f64, f64) -> bool,
    ) -> f64 {
        let grid = (0..400).map(|k| (width * (f64::from(k % 20) + 0.5) / 20.0, height * (f64::from(k / 20) + 0.5) / 20.0));
        grid.filter(|(x, y)| inside(*x, *y)).flat_map(|(x, y)| difference(field.at(x, y), expected(x, y))).fold(0.0, |m, e| m.max(e.abs()))
    }

    #[test]
    fn a_translation_is_found() {
        for (dx, dy) in [(3.0, -2.0), (-180.0, 35.0), (140.0, -90.0)] {
            let (left, right) = (view_of(500, 400, |x, y| [x, y]), view_of(480, 420, |x, y| [x - dx, y - dy]));
            let field = estimate_offset(left.view(), right.view());
            assert!((field.median_px[0] - dx).abs() < 1.0 && (field.median_px[1] - dy).abs() < 1.0, "{:?}", field.median_px);
            let seen = |x: f64, y: f64| (20.0..460.0).contains(&(x + dx)) && (20.0..400.0).contains(&(y + dy));
            let error = greatest_error(&field, 500.0, 400.0, |_, _| [dx, dy], seen);
            assert!(error < 3.0, "{error} px at {dx}, {dy}");
        }
    }

    #[test]
    fn a_rotation_is_taken_up() {
        let (s, c) = (libm::sin(0.09), libm::cos(0.09));
        let to_right = |x: f64, y: f64| [c * (x - 600.0) - s * (y - 450.0) + 500.0, s * (x - 600.0) + c * (y - 450.0) + 420.0];
        let from_right = |x: f64, y: f64| [c * (x - 500.0) + s * (y - 420.0) + 600.0, -s * (x - 500.0) + c * (y - 420.0) + 450.0];
        let (left, right) = (view_of(1200, 900, |x, y| [x, y]), view_of(1200, 900, from_right));
        let field = estimate_offset(left.view(), right.view());
        let inside = |x: f64, y: f64| {
            let [u, v] = to_right(x, y);
            (40.0..1160.0).contains(&u) && (40.0..860.0).contains(&v)
        };
        let error = greatest_error(&field, 1200.0, 900.0, |x, y| difference(to_right(x, y), [x, y]), inside);
        assert!(error < 6.0, "{error} px");
    }

    #[test]
    fn images_without_content_give_a_field_that_says_so() {
        let flat = GreyImage::from_fn(100, 80, |_, _| 50).unwrap();
        let field = estimate_offset(flat.view(), flat.view());
        assert_eq!(field.correlation, Some(0.0));
        let pixel = GreyImage::from_fn(1, 1, |_, _| 50).unwrap();
        let field = estimate_offset(pixel.view(), flat.view());
        assert!(field.check().is_ok() && field.at(0.5, 0.5).iter().all(|v| v.is_finite()));
    }

    #[test]
    fn between_nodes_the_field_is_bilinear_and_beyond_them_constant() {
        let offsets = vec![[0.0, 0.0], [10.0, 0.0], [0.0, 20.0], [10.0, 20.0]];
        let field = OffsetField { columns: 2, rows: 2, spacing_px: 100.0, offsets, median_px: [5.0, 10.0], correlation: None };
        assert_eq!(field.at(25.0, 50.0), [2.5, 10.0]);
        assert_eq!(field.at(-50.0, 500.0), [0.0, 20.0]);
        assert_eq!(OffsetField::constant(3.0, 4.0).at(1e5, -7.0), [3.0, 4.0]);
    }
}
