//! The ground operator, in both versions: contrast to the four neighbours makes a candidate.

use super::threshold::threshold_of_histogram;
use super::{Candidates, InterestPoint, PointOptions, Selection};
use crate::catalogue::check;
use crate::{Error, GreyView, ImageOperation};

/// Version 1: of the pixels that differ from at least two of their four neighbours by more than the threshold, the interest is the
/// sum of the absolute grey differences to all eight neighbours.
///
/// Border pixels are never candidates. Values are in grey levels, 0..2040.
///
/// # Errors
/// [`Error::ImageTooSmall`] below 3 px a side; [`Error::InvalidOption`].
///
/// # Source
/// Yan 1988, in Zahran 2007, section 2.
pub fn ground1(image: GreyView<'_>, selection: Selection) -> Result<Candidates, Error> {
    ground(image, selection, |above, row, below| Some(f64::from(sum_of_differences(above, row, below))))
}

/// Version 2, the paper's choice: of the same candidates, the interest is the roundness q of the four Roberts gradients in the
/// 3 x 3 window; `roundness` is the q to exceed, 0..1.
///
/// # Errors
/// [`Error::ImageTooSmall`] below 3 px a side; [`Error::InvalidOption`].
///
/// # Source
/// Yan 1988, in Zahran 2007, section 2 and eqs. 1, 2.
pub fn ground2(image: GreyView<'_>, selection: Selection, roundness: f64) -> Result<Candidates, Error> {
    check(PointOptions::PARAMETERS, "points.roundness", roundness)?;
    ground(image, selection, |above, row, below| Some(roundness_of(above, row, below)).filter(|q| *q > roundness))
}

/// The candidates, with the interest that `interest` gives the three rows of three pixels; it gives none to those that fall.
fn ground(
    image: GreyView<'_>,
    selection: Selection,
    interest: impl Fn([u8; 3], [u8; 3], [u8; 3]) -> Option<f64>,
) -> Result<Candidates, Error> {
    selection.check()?;
    let (width, height) = (image.width(), image.height());
    if width.min(height) < 3 {
        return Err(Error::ImageTooSmall { width, height, image_operation: ImageOperation::GroundOperator, min_side: 3 });
    }
    let threshold = selection.resolve(|fraction| threshold_of_histogram(&contrast_histogram(image), width * height, fraction));
    let mut found = Candidates { threshold, ..Candidates::default() };
    let mut contrast = vec![0; width - 2];
    for row in 1..height - 1 {
        let [above, middle, below] = [image.row(row - 1), image.row(row), image.row(row + 1)];
        contrasts(above, middle, below, &mut contrast);
        for (col, _) in contrast.iter().enumerate().filter(|(_, c)| f64::from(**c) > threshold) {
            found.candidates += 1;
            let triple = |line: &[u8]| [line[col], line[col + 1], line[col + 2]];
            if let Some(value) = interest(triple(above), triple(middle), triple(below)) {
                found.points.push(InterestPoint { x: col as f64 + 1.5, y: row as f64 + 0.5, value });
            }
        }
    }
    Ok(found)
}

/// For each inner pixel of a row the second largest of the four absolute differences: it exceeds T where at least two of them do.
fn contrasts(above: &[u8], row: &[u8], below: &[u8], contrast: &mut [u8]) {
    let inner = contrast.len();
    let (north, south, centre) = (&above[1..][..inner], &below[1..][..inner], &row[1..][..inner]);
    let (west, east) = (&row[..inner], &row[2..][..inner]);
    for k in 0..inner {
        let g = centre[k];
        let (n, s, e, w) = (g.abs_diff(north[k]), g.abs_diff(south[k]), g.abs_diff(east[k]), g.abs_diff(west[k]));
        contrast[k] = n.max(s).min(e.max(w)).max(n.min(s).max(e.min(w)));
    }
}

/// Counts the inner pixels of each contrast.
fn contrast_histogram(image: GreyView<'_>) -> [usize; 256] {
    // Several counters, so that equal neighbours do not wait for one another.
    let mut counters = [[0u32; 256]; 4];
    let mut contrast = vec![0; image.width() - 2];
    for row in 1..image.height() - 1 {
        contrasts(image.row(row - 1), image.row(row), image.row(row + 1), &mut contrast);
        for four in contrast.chunks(4) {
            for (counter, c) in counters.iter_mut().zip(four) {
                counter[usize::from(*c)] += 1;
            }
        }
    }
    std::array::from_fn(|c| counters.iter().map(|counter| counter[c] as usize).sum())
}

fn sum_of_differences(above: [u8; 3], row: [u8; 3], below: [u8; 3]) -> u32 {
    let centre = row[1];
    above.iter().chain(&row).chain(&below).map(|g| u32::from(centre.abs_diff(*g))).sum()
}

/// q = 4 det N / tr² N of the four Roberts gradients in 3 x 3 pixels; 0 where there is no gradient.
fn roundness_of(above: [u8; 3], row: [u8; 3], below: [u8; 3]) -> f64 {
    let quad = |top: [u8; 3], bottom: [u8; 3], k: usize| {
        let g_u = i32::from(bottom[k + 1]) - i32::from(top[k]);
        let g_v = i32::from(bottom[k]) - i32::from(top[k + 1]);
        [g_u * g_u, g_u * g_v, g_v * g_v]
    };
    let quads = [quad(above, row, 0), quad(above, row, 1), quad(row, below, 0), quad(row, below, 1)];
    let [n_uu, n_uv, n_vv] = std::array::from_fn(|k| i64::from(quads[0][k] + quads[1][k] + quads[2][k] + quads[3][k]));
    let trace = n_uu + n_vv;
    if trace == 0 {
        return 0.0;
    }
    // Whole numbers up to here: the quotient is rounded once, equally everywhere.
    (4 * (n_uu * n_vv - n_uv * n_uv)) as f64 / (trace * trace) as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::GreyImage;

    fn image(rows: &[&[u8]]) -> GreyImage {
        GreyImage::new(rows[0].len(), rows.len(), rows.concat()).unwrap()
    }

    #[test]
    fn two_of_four_neighbours_must_differ_by_more_than_the_threshold() {
        // East and south differ by 41, north and west by 0.
        let corner = image(&[&[9, 9, 9], &[9, 9, 50], &[9, 50, 50]]);
        assert_eq!(ground1(corner.view(), Selection::Threshold(40.0)).unwrap().candidates, 1);
        assert_eq!(ground1(corner.view(), Selection::Threshold(41.0)).unwrap().candidates, 0);
        // Only east differs.
        let single = image(&[&[9, 9, 9], &[9, 9, 90], &[9, 9, 9]]);
        assert_eq!(ground1(single.view(), Selection::Threshold(40.0)).unwrap().candidates, 0);
    }

    #[test]
    fn version_1_sums_the_differences_to_eight_neighbours() {
        let spot = image(&[&[10, 20, 30], &[40, 100, 60], &[70, 80, 90]]);
        let found = ground1(spot.view(), Selection::Threshold(10.0)).unwrap();
        assert_eq!(found.points, [InterestPoint { x: 1.5, y: 1.5, value: 90.0 + 80.0 + 70.0 + 60.0 + 40.0 + 30.0 + 20.0 + 10.0 }]);
    }

    #[test]
    fn version_2_gives_a_spot_1_and_an_edge_0() {
        let spot = image(&[&[0, 0, 0], &[0, 200, 0], &[0, 0, 0]]);
        let found = ground2(spot.view(), Selection::Threshold(40.0), 0.32).unwrap();
        assert_eq!(found.points[0].value, 1.0);
        let edge = image(&[&[0, 90, 180], &[0, 90, 180], &[0, 90, 180]]);
        let found = ground2(edge.view(), Selection::Threshold(40.0), 0.0).unwrap();
        assert_eq!((found.candidates, found.points.len()), (1, 0));
    }

    #[test]
    fn border_pixels_are_never_candidates() {
        let noisy = GreyImage::from_fn(7, 5, |col, row| if (col + row) % 2 == 0 { 0 } else { 255 }).unwrap();
        let found = ground1(noisy.view(), Selection::Threshold(40.0)).unwrap();
        assert_eq!(found.candidates, 5 * 3);
        assert!(found.points.iter().all(|p| p.x > 1.0 && p.x < 6.0 && p.y > 1.0 && p.y < 4.0));
    }

    #[test]
    fn the_fraction_is_of_all_pixels() {
        let ramp = GreyImage::from_fn(64, 64, |col, row| ((col * col + 3 * row * row) % 251) as u8).unwrap();
        let found = ground2(ramp.view(), Selection::Fraction(0.148), 0.32).unwrap();
        assert!((found.candidates as f64 / 4096.0 - 0.148).abs() < 0.02, "{}", found.candidates);
        let again = ground2(ramp.view(), Selection::Threshold(found.threshold), 0.32).unwrap();
        assert_eq!(found, again);
    }
}
