//! Grey values between pixels.

use super::GreyView;

/// The grey value at a position in px, by cubic convolution; beyond the edges are the pixels of the edge.
///
/// # Source
/// Keys 1981, Cubic convolution interpolation for digital image processing (a = -1/2).
pub(crate) fn bicubic(image: GreyView<'_>, [x, y]: [f64; 2]) -> u8 {
    let along = |position: f64, number: usize| {
        let from_centre = position - 0.5;
        let first = libm::floor(from_centre);
        let last = number as f64 - 1.0;
        ([-1.0, 0.0, 1.0, 2.0].map(|step| (first + step).clamp(0.0, last) as usize), weights(from_centre - first))
    };
    let ((columns, wx), (rows, wy)) = (along(x, image.width()), along(y, image.height()));
    let mut sum = 0.0;
    for (row, weight) in rows.iter().zip(wy) {
        let line = image.row(*row);
        sum += weight * columns.iter().zip(wx).map(|(column, weight)| weight * f64::from(line[*column])).sum::<f64>();
    }
    (sum + 0.5).clamp(0.0, 255.0) as u8
}

/// Of four neighbours, at a distance 0..1 from the second.
fn weights(t: f64) -> [f64; 4] {
    let (t2, t3) = (t * t, t * t * t);
    [-0.5 * t3 + t2 - 0.5 * t, 1.5 * t3 - 2.5 * t2 + 1.0, -1.5 * t3 + 2.0 * t2 + 0.5 * t, 0.5 * t3 - 0.5 * t2]
}
