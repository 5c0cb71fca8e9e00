//! Positions of the pixels of one image in another, from which it is resampled.

/// Side of a square at whose corners positions are computed, px; between them they are interpolated, to less than a hundredth of a pixel.
const SQUARE: usize = 8;

/// Gives the position of each pixel of an image of this width and height, row by row. `at` computes that of a column and row; `None`: it has none.
pub(crate) fn each_position(
    [width, height]: [usize; 2],
    at: impl Fn([usize; 2]) -> Option<[f64; 2]>,
    mut take: impl FnMut(Option<[f64; 2]>),
) {
    let corners = |row: usize| -> Vec<Option<[f64; 2]>> { (0..=width / SQUARE + 1).map(|k| at([k * SQUARE, row])).collect() };
    let (mut above, mut below) = (Vec::new(), corners(0));
    for row in 0..height {
        if row % SQUARE == 0 {
            above = std::mem::replace(&mut below, corners(row + SQUARE));
        }
        let down = (row % SQUARE) as f64 / SQUARE as f64;
        for column in 0..width {
            let (k, along) = (column / SQUARE, (column % SQUARE) as f64 / SQUARE as f64);
            take(match (above[k], above[k + 1], below[k], below[k + 1]) {
                (Some(a), Some(b), Some(c), Some(d)) => Some([0, 1].map(|axis| {
                    let (upper, lower) = (a[axis] + along * (b[axis] - a[axis]), c[axis] + along * (d[axis] - c[axis]));
                    upper + down * (lower - upper)
                })),
                _ => at([column, row]),
            });
        }
    }
}
