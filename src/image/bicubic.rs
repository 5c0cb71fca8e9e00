//! Grey values between pixels.

use super::GreyView;

/// The pixels about a position, four by four, and how much each counts: the same in all bands of an image. Beyond the edges are the pixels of the edge.
///
/// # Source
/// Keys 1981, Cubic convolution interpolation for digital image processing (a = -1/2).
pub(crate) struct Neighbours {
    columns: [usize; 4],
    rows: [usize; 4],
    by_column: [f64; 4],
    by_row: [f64; 4],
}

impl Neighbours {
    /// In an image of this width and height.
    pub fn about([x, y]: [f64; 2], [width, height]: [usize; 2]) -> Self {
        let along = |position: f64, number: usize| {
            let from_centre = position - 0.5;
            let first = libm::floor(from_centre);
            let last = number as f64 - 1.0;
            ([-1.0, 0.0, 1.0, 2.0].map(|step| (first + step).clamp(0.0, last) as usize), weights(from_centre - first))
        };
        let ((columns, by_column), (rows, by_row)) = (along(x, width), along(y, height));
        Self { columns, rows, by_column, by_row }
    }

    /// The grey value at the position.
    pub fn mean(&self, image: GreyView<'_>) -> u8 {
        let mut sum = 0.0;
        for (row, weight) in self.rows.iter().zip(self.by_row) {
            let line = image.row(*row);
            sum += weight * self.columns.iter().zip(self.by_column).map(|(column, weight)| weight * f64::from(line[*column])).sum::<f64>();
        }
        (sum + 0.5).clamp(0.0, 255.0) as u8
    }
}

/// Of four neighbours, at a distance 0..1 from the second.
fn weights(t: f64) -> [f64; 4] {
    let (t2, t3) = (t * t, t * t * t);
    [-0.5 * t3 + t2 - 0.5 * t, 1.5 * t3 - 2.5 * t2 + 1.0, -1.5 * t3 + 2.0 * t2 + 0.5 * t, 0.5 * t3 - 0.5 * t2]
}
