//! The Moravec operator: the least of four directional variations.

use super::box_sums::ColumnSums;
use super::threshold::threshold_of_values;
use super::{Candidates, InterestPoint, PointOptions, Selection};
use crate::catalogue::check;
use crate::{Error, GreyView, ImageOperation};

/// Finds windows whose grey values vary in every direction.
///
/// In each window of `side` x `side` px the squared differences of adjacent pixels inside it are summed along the horizontal, the
/// vertical and both diagonals; the interest is the smallest of the four sums (grey²). Windows slide by one pixel, or stand side by
/// side where `tiled`. The point is the window's centre, which for an even side is the corner between four pixels.
///
/// # Errors
/// [`Error::ImageTooSmall`] for the window; [`Error::InvalidOption`].
///
/// # Source
/// Moravec 1981, in Zahran 2007, section 2.
pub fn moravec(image: GreyView<'_>, selection: Selection, side: usize, tiled: bool) -> Result<Candidates, Error> {
    selection.check()?;
    check(PointOptions::PARAMETERS, "points.operator_window", side as f64)?;
    let (width, height) = (image.width(), image.height());
    if width.min(height) < side {
        return Err(Error::ImageTooSmall { width, height, image_operation: ImageOperation::MoravecWindow, min_side: side });
    }
    let step = if tiled { side } else { 1 };
    let threshold = selection.resolve(|fraction| {
        let mut values = Vec::new();
        for_each_window(image, side, step, |_, _, value| values.push(value as f32));
        threshold_of_values(&mut values, width * height, fraction)
    });
    let mut found = Candidates { threshold, ..Candidates::default() };
    let half = side as f64 / 2.0;
    for_each_window(image, side, step, |col, row, value| {
        let value = f64::from(value);
        if value > threshold {
            found.points.push(InterestPoint { x: col as f64 + half, y: row as f64 + half, value });
        }
    });
    found.candidates = found.points.len();
    Ok(found)
}

/// Gives every window's top-left pixel and interest, in raster order.
fn for_each_window(image: GreyView<'_>, side: usize, step: usize, mut visit: impl FnMut(usize, usize, u32)) {
    let width = image.width();
    let square = |a: u8, b: u8| u32::from(a.abs_diff(b)).pow(2);
    let mut horizontal = ColumnSums::new(side, width - 1);
    let [mut vertical, mut falling, mut rising] = [width, width - 1, width - 1].map(|columns| ColumnSums::new(side - 1, columns));
    for bottom in 0..image.height() {
        let line = image.row(bottom);
        horizontal.push(|out| out.iter_mut().enumerate().for_each(|(c, v)| *v = square(line[c], line[c + 1])));
        if bottom > 0 {
            let above = image.row(bottom - 1);
            vertical.push(|out| out.iter_mut().enumerate().for_each(|(c, v)| *v = square(above[c], line[c])));
            falling.push(|out| out.iter_mut().enumerate().for_each(|(c, v)| *v = square(above[c], line[c + 1])));
            rising.push(|out| out.iter_mut().enumerate().for_each(|(c, v)| *v = square(above[c + 1], line[c])));
        }
        let Some(row) = (bottom + 1).checked_sub(side).filter(|row| row % step == 0) else {
            continue;
        };
        let sums = (horizontal.windows(side - 1), vertical.windows(side), falling.windows(side - 1), rising.windows(side - 1));
        if let (Some(h), Some(v), Some(f), Some(r)) = sums {
            h.zip(v).zip(f.zip(r)).enumerate().step_by(step).for_each(|(col, ((h, v), (f, r)))| visit(col, row, h.min(v).min(f).min(r)));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::GreyImage;

    fn by_definition(image: GreyView<'_>, side: usize, col: usize, row: usize) -> u32 {
        let sum = |dc: isize, dr: isize| {
            let inside = |c: isize, r: isize| (0..side as isize).contains(&c) && (0..side as isize).contains(&r);
            let at = |c: isize, r: isize| i32::from(image.at(col + c as usize, row + r as usize));
            let cells = (0..side as isize).flat_map(|r| (0..side as isize).map(move |c| (c, r)));
            cells.filter(|(c, r)| inside(c + dc, r + dr)).map(|(c, r)| (at(c, r) - at(c + dc, r + dr)).pow(2) as u32).sum::<u32>()
        };
        [sum(1, 0), sum(0, 1), sum(1, 1), sum(-1, 1)].into_iter().min().unwrap()
    }

    #[test]
    fn agrees_with_the_definition() {
        let image = GreyImage::from_fn(23, 17, |col, row| ((col * col * 5 + row * 37 + col * row) % 256) as u8).unwrap();
        for side in [2, 4, 5, 8] {
            let found = moravec(image.view(), Selection::Threshold(0.0), side, false).unwrap();
            let expected: Vec<_> = (0..=17 - side)
                .flat_map(|row| (0..=23 - side).map(move |col| (col, row)))
                .map(|(col, row)| {
                    (col as f64 + side as f64 / 2.0, row as f64 + side as f64 / 2.0, by_definition(image.view(), side, col, row))
                })
                .filter(|(_, _, value)| *value > 0)
                .collect();
            assert_eq!(found.points.len(), expected.len());
            assert!(found.points.iter().zip(&expected).all(|(p, e)| (p.x, p.y, p.value) == (e.0, e.1, f64::from(e.2))));
        }
    }

    #[test]
    fn tiles_stand_side_by_side() {
        let image = GreyImage::from_fn(19, 13, |col, row| ((col * 91 + row * 57) % 256) as u8).unwrap();
        let found = moravec(image.view(), Selection::Threshold(0.0), 4, true).unwrap();
        assert_eq!(found.candidates, 4 * 3);
        assert_eq!((found.points[0].x, found.points[1].x, found.points[4].y), (2.0, 6.0, 6.0));
    }

    #[test]
    fn an_edge_is_not_interesting() {
        let edge = GreyImage::from_fn(16, 16, |col, _| if col < 8 { 0 } else { 255 }).unwrap();
        assert_eq!(moravec(edge.view(), Selection::Threshold(0.0), 4, false).unwrap().points, []);
    }

    #[test]
    fn an_image_smaller_than_the_window_is_refused() {
        let small = GreyImage::from_fn(3, 9, |_, _| 0).unwrap();
        assert!(matches!(moravec(small.view(), Selection::Threshold(1.0), 4, false), Err(Error::ImageTooSmall { min_side: 4, .. })));
    }
}
