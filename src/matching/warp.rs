//! Where least-squares matching places its window, and how a step changes that.

use nalgebra::Vector6;

/// Where the window lies in the right image: position = centre + matrix · (px from the left centre).
#[derive(Debug, Clone, Copy)]
pub(super) struct Warp {
    pub centre: [f64; 2],
    pub matrix: [[f64; 2]; 2],
}

impl Warp {
    /// Px² of the right image by px² of the left one.
    pub fn area(&self) -> f64 {
        let [[a, b], [c, d]] = self.matrix;
        a * d - b * c
    }

    /// This warp after the inverse of a change of the left window; `None` where that turns it over.
    pub fn changed(&self, change: &Vector6<f64>) -> Option<Self> {
        let [[a, b], [c, d]] = [[1.0 + change[2], change[3]], [change[4], 1.0 + change[5]]];
        let determinant = a * d - b * c;
        if !(determinant > 0.1) {
            return None;
        }
        let inverse = [[d / determinant, -b / determinant], [-c / determinant, a / determinant]];
        let matrix = self.matrix.map(|row| [0, 1].map(|k| row[0] * inverse[0][k] + row[1] * inverse[1][k]));
        let centre = [0, 1].map(|axis| self.centre[axis] - (matrix[axis][0] * change[0] + matrix[axis][1] * change[1]));
        Some(Self { centre, matrix })
    }
}
