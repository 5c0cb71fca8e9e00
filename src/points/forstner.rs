//! The Förstner operator: weight and roundness of the error ellipse of a point.

use super::box_sums::ColumnSums;
use super::threshold::threshold_of_values;
use super::{Candidates, InterestPoint, PointOptions, Selection};
use crate::catalogue::check;
use crate::{Allowed, Error, GreyView, ImageOperation};

/// Finds distinct points: corners and circle centres.
///
/// At each window of `side` x `side` px (odd) the Roberts gradients give N = [Σg_u² Σg_u·g_v; Σg_u·g_v Σg_v²], of which the weight
/// is w = det N / tr N (grey²) and the roundness q = 4 det N / tr² N (1 isotropic, 0 an edge); both are 0 where tr N = 0. Candidates
/// are the windows with w greater than the threshold times the mean w of all complete windows; of these the points have q greater
/// than `roundness`. The interest is w.
///
/// # Errors
/// [`Error::ImageTooSmall`] for the window; [`Error::InvalidOption`].
///
/// # Source
/// Förstner & Gülch 1987, in Zahran 2007, section 2 and eqs. 1 to 3.
pub fn forstner(image: GreyView<'_>, selection: Selection, side: usize, roundness: f64) -> Result<Candidates, Error> {
    selection.check()?;
    check(PointOptions::PARAMETERS, "points.operator_window", side as f64)?;
    check(PointOptions::PARAMETERS, "points.roundness", roundness)?;
    if side.is_multiple_of(2) {
        return Err(crate::catalogue::refuse("points.operator_window", side, Allowed::OddForForstner));
    }
    let (width, height) = (image.width(), image.height());
    if width.min(height) < side {
        return Err(Error::ImageTooSmall { width, height, image_operation: ImageOperation::ForstnerWindow, min_side: side });
    }
    let mut sum = 0.0;
    for_each_window(image, side, |_, _, window| sum += window.weight());
    let mean = sum / ((width - side + 1) * (height - side + 1)) as f64;
    let factor = selection.resolve(|fraction| {
        let mut weights = Vec::new();
        for_each_window(image, side, |_, _, window| weights.push(window.weight() as f32));
        if mean > 0.0 { threshold_of_values(&mut weights, width * height, fraction) / mean } else { 0.0 }
    });
    let least = factor * mean;
    let mut found = Candidates { threshold: factor, ..Candidates::default() };
    let half = side as f64 / 2.0;
    for_each_window(image, side, |col, row, window| {
        if window.weight() > least {
            found.candidates += 1;
            if window.roundness() > roundness {
                found.points.push(InterestPoint { x: col as f64 + half, y: row as f64 + half, value: window.weight() });
            }
        }
    });
    Ok(found)
}

/// Determinant and trace of N: whole numbers, so that each quotient is rounded once.
struct Window {
    determinant: i64,
    trace: i64,
}

impl Window {
    fn weight(&self) -> f64 {
        if self.trace == 0 { 0.0 } else { self.determinant as f64 / self.trace as f64 }
    }

    fn roundness(&self) -> f64 {
        if self.trace == 0 { 0.0 } else { (4 * self.determinant) as f64 / (self.trace as f64 * self.trace as f64) }
    }
}

/// Gives every window's top-left pixel, determinant and trace, in raster order.
fn for_each_window(image: GreyView<'_>, side: usize, mut visit: impl FnMut(usize, usize, Window)) {
    let quads = image.width() - 1;
    let [mut n_uu, mut n_uv, mut n_vv] = std::array::from_fn(|_| ColumnSums::new(side - 1, quads));
    for bottom in 1..image.height() {
        let (above, line) = (image.row(bottom - 1), image.row(bottom));
        let g_u = |c: usize| i32::from(line[c + 1]) - i32::from(above[c]);
        let g_v = |c: usize| i32::from(line[c]) - i32::from(above[c + 1]);
        n_uu.push(|out| out.iter_mut().enumerate().for_each(|(c, v)| *v = (g_u(c) * g_u(c)) as u32));
        n_uv.push(|out| out.iter_mut().enumerate().for_each(|(c, v)| *v = (g_u(c) * g_v(c)) as u32));
        n_vv.push(|out| out.iter_mut().enumerate().for_each(|(c, v)| *v = (g_v(c) * g_v(c)) as u32));
        let Some(row) = (bottom + 1).checked_sub(side) else { continue };
        let sums = (n_uu.windows(side - 1), n_uv.windows(side - 1), n_vv.windows(side - 1));
        if let (Some(uu), Some(uv), Some(vv)) = sums {
            uu.zip(uv).zip(vv).enumerate().for_each(|(col, ((uu, uv), vv))| {
                let [uu, uv, vv] = [i64::from(uu), i64::from(uv as i32), i64::from(vv)];
                visit(col, row, Window { determinant: uu * vv - uv * uv, trace: uu + vv });
            });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::GreyImage;

    fn by_definition(image: GreyView<'_>, side: usize, col: usize, row: usize) -> (f64, f64) {
        let (mut uu, mut uv, mut vv) = (0.0, 0.0, 0.0);
        for r in row..row + side - 1 {
            for c in col..col + side - 1 {
                let at = |c, r| f64::from(image.at(c, r));
                let (g_u, g_v) = (at(c + 1, r + 1) - at(c, r), at(c, r + 1) - at(c + 1, r));
                (uu, uv, vv) = (uu + g_u * g_u, uv + g_u * g_v, vv + g_v * g_v);
            }
        }
        let (determinant, trace) = (uu * vv - uv * uv, uu + vv);
        if trace == 0.0 { (0.0, 0.0) } else { (determinant / trace, 4.0 * determinant / (trace * trace)) }
    }

    #[test]
    fn agrees_with_the_definition() {
        let image = GreyImage::from_fn(21, 19, |col, row| ((col * col * 5 + row * 37 + col * row * 3) % 256) as u8).unwrap();
        for side in [3, 5, 7] {
            let windows: Vec<_> = (0..=19 - side)
                .flat_map(|row| (0..=21 - side).map(move |col| (col, row)))
                .map(|(col, row)| (col, row, by_definition(image.view(), side, col, row)))
                .collect();
            let mean = windows.iter().map(|(_, _, (w, _))| w).sum::<f64>() / windows.len() as f64;
            let candidates: Vec<_> = windows.iter().filter(|(_, _, (w, _))| *w > 0.8 * mean).collect();
            let expected: Vec<_> = candidates.iter().filter(|(_, _, (_, q))| *q > 0.5).collect();
            let found = forstner(image.view(), Selection::Threshold(0.8), side, 0.5).unwrap();
            assert_eq!(found.candidates, candidates.len());
            assert_eq!(found.points.len(), expected.len());
            for (point, (col, row, (w, _))) in found.points.iter().zip(expected) {
                assert_eq!((point.x, point.y), (*col as f64 + side as f64 / 2.0, *row as f64 + side as f64 / 2.0));
                assert!((point.value - w).abs() <= 1e-9 * w);
            }
        }
    }

    #[test]
    fn a_flat_image_gives_nothing_and_no_division_by_zero() {
        let flat = GreyImage::from_fn(9, 9, |_, _| 77).unwrap();
        let found = forstner(flat.view(), Selection::Threshold(1.0), 5, 0.5).unwrap();
        assert_eq!((found.candidates, found.points.len(), found.threshold), (0, 0, 1.0));
    }

    #[test]
    fn the_fraction_is_met() {
        let image = GreyImage::from_fn(64, 64, |col, row| ((col * col + 3 * row * row + col * row) % 251) as u8).unwrap();
        let found = forstner(image.view(), Selection::Fraction(0.1), 5, 0.5).unwrap();
        assert!((found.candidates as f64 - 409.6).abs() < 3.0, "{}", found.candidates);
    }

    #[test]
    fn even_windows_are_refused() {
        let image = GreyImage::from_fn(9, 9, |_, _| 0).unwrap();
        assert!(matches!(forstner(image.view(), Selection::Threshold(1.0), 4, 0.5), Err(Error::InvalidOption { .. })));
    }
}
