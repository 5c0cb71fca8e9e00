//! Suppression of local non-maxima.

use super::{InterestPoint, PointOptions, Ties};
use crate::catalogue::check;
use crate::error::refuse;
use crate::{Error, Refusal};

/// Keeps the points that are maxima of a square window around them.
///
/// A point falls if any original value in the window is strictly greater; of equal values all survive ([`Ties::Keep`]) or the
/// first in raster order ([`Ties::First`]). `points` are in raster order of their pixels, as the operators give them; `side` is the
/// window's side in px, odd, and 1 keeps every point.
///
/// # Errors
/// [`Error::InvalidOption`] for `side`; [`Error::InvalidInput`] for points out of order.
///
/// # Source
/// Zahran 2007, section 2.
pub(super) fn suppress_non_maxima(points: &[InterestPoint], side: usize, ties: Ties) -> Result<Vec<InterestPoint>, Error> {
    check(PointOptions::PARAMETERS, "points.suppression_window", side as f64)?;
    if !points.is_sorted_by(|a, b| pixel(a) < pixel(b)) {
        return refuse(Refusal::RasterOrder);
    }
    if side == 1 {
        return Ok(points.to_vec());
    }
    let reach = (side / 2) as i64;
    // For every row of the window, the first point that is not left of it: each only moves forward.
    let mut fronts = vec![0; side];
    let survives = |index: &usize| {
        let (row, col) = pixel(&points[*index]);
        fronts.iter_mut().zip(row - reach..).all(|(front, window_row)| {
            while points.get(*front).is_some_and(|p| pixel(p) < (window_row, col - reach)) {
                *front += 1;
            }
            let in_row = points[*front..].iter().enumerate().take_while(|(_, p)| pixel(p) <= (window_row, col + reach));
            let value = points[*index].value;
            in_row.into_iter().all(|(k, p)| {
                let earlier_equal = p.value == value && *front + k < *index && ties == Ties::First;
                p.value <= value && !earlier_equal
            })
        })
    };
    let kept: Vec<usize> = (0..points.len()).filter(survives).collect();
    Ok(kept.into_iter().map(|index| points[index]).collect())
}

/// Row and column of the pixel a point lies in.
fn pixel(point: &InterestPoint) -> (i64, i64) {
    (point.y.floor() as i64, point.x.floor() as i64)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(col: usize, row: usize, value: f64) -> InterestPoint {
        InterestPoint { x: col as f64 + 0.5, y: row as f64 + 0.5, value }
    }

    #[test]
    fn greater_values_in_the_window_suppress_even_when_they_fall_themselves() {
        let points = [point(0, 0, 1.0), point(1, 0, 2.0), point(2, 0, 3.0), point(5, 5, 1.0)];
        let kept = suppress_non_maxima(&points, 3, Ties::Keep).unwrap();
        assert_eq!(kept, [points[2], points[3]]);
    }

    #[test]
    fn equal_values_survive_or_fall_as_asked() {
        let points = [point(3, 0, 2.0), point(4, 1, 2.0), point(8, 1, 2.0)];
        assert_eq!(suppress_non_maxima(&points, 3, Ties::Keep).unwrap().len(), 3);
        assert_eq!(suppress_non_maxima(&points, 3, Ties::First).unwrap(), [points[0], points[2]]);
    }

    #[test]
    fn side_one_keeps_everything_and_even_sides_are_refused() {
        let points = [point(0, 0, 1.0), point(1, 0, 2.0)];
        assert_eq!(suppress_non_maxima(&points, 1, Ties::First).unwrap(), points);
        assert!(matches!(suppress_non_maxima(&points, 4, Ties::Keep), Err(Error::InvalidOption { .. })));
    }

    #[test]
    fn points_out_of_order_are_refused() {
        let points = [point(1, 0, 1.0), point(0, 0, 2.0)];
        assert!(matches!(suppress_non_maxima(&points, 3, Ties::Keep), Err(Error::InvalidInput { .. })));
    }

    #[test]
    fn agrees_with_the_definition_on_a_dense_grid() {
        let (width, height) = (40usize, 30usize);
        let value = |col: usize, row: usize| f64::from(((col * 7919 + row * 104_729) * 2_654_435) as u32 % 50);
        let points: Vec<_> =
            (0..height).flat_map(|row| (0..width).map(move |col| point(col, row, value(col, row)))).filter(|p| p.value > 10.0).collect();
        for side in [3, 5, 9] {
            for ties in [Ties::Keep, Ties::First] {
                let reach = (side / 2) as f64;
                let by_definition: Vec<_> = (0..points.len())
                    .filter(|&i| {
                        let p = points[i];
                        (0..points.len())
                            .filter(|&j| (points[j].x - p.x).abs() <= reach && (points[j].y - p.y).abs() <= reach)
                            .all(|j| points[j].value <= p.value && !(ties == Ties::First && j < i && points[j].value == p.value))
                    })
                    .map(|i| points[i])
                    .collect();
                assert_eq!(suppress_non_maxima(&points, side, ties).unwrap(), by_definition, "side {side}, {ties:?}");
            }
        }
    }
}
