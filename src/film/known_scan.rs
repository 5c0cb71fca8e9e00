//! A scan of known marks, for tests.

use super::FilmInput;
use crate::{CameraMm, Fiducial, PhotoInput};

/// A photo of 230 mm on a scan of 1000 x 960 px, turned by some degrees, whose columns and rows are of different scale and a little askew.
const PX_FROM_MM: [[f64; 3]; 2] = [[3.9, 0.45, 505.0], [0.46, -3.92, 480.0]];
pub(super) const SIZE: [usize; 2] = [1000, 960];
pub(super) const MARKS_MM: [[f64; 2]; 4] = [[-106.0, -106.0], [106.0, -105.9], [106.1, 106.0], [-105.9, 106.1]];

pub(super) fn in_scan(x: f64, y: f64) -> [f64; 2] {
    PX_FROM_MM.map(|[by_x, by_y, shift]| by_x * x + by_y * y + shift)
}

pub(super) fn measured(mut off: impl FnMut() -> f64) -> FilmInput {
    let marks = MARKS_MM.map(|[x_mm, y_mm]| {
        let [col, row] = in_scan(x_mm, y_mm);
        Fiducial { col: col + off(), row: row + off(), x_mm, y_mm }
    });
    let camera = CameraMm { principal_point_mm: [0.5, -0.25], ..CameraMm::without_distortion(152.0, None) };
    FilmInput { camera: Some(camera), scan: PhotoInput { fiducials: marks.to_vec(), ..PhotoInput::default() }, marks_mm: Vec::new() }
}
