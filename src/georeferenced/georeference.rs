//! Where the pixels of a picture of the ground lie in the system of a map.

use crate::error::refuse;
use crate::{Error, Refusal};
use serde::{Deserialize, Serialize};

/// The way from pixels to the ground and back: (X, Y) = origin + x · `by_column` + y · `by_row` of a position (x, y) in px, the centre of
/// the top-left pixel at (0.5, 0.5).
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Georeference {
    /// The top-left corner of the top-left pixel, in units of the map.
    pub origin: [f64; 2],
    /// One px to the right.
    pub by_column: [f64; 2],
    /// One px down.
    pub by_row: [f64; 2],
}

/// Coordinates beyond this are none of a map.
const LARGEST: f64 = 1e8;

impl Georeference {
    /// North up, pixels of `gsd` a side.
    pub fn north_up(origin: [f64; 2], gsd: f64) -> Self {
        Self { origin, by_column: [gsd, 0.0], by_row: [0.0, -gsd] }
    }

    /// Reads a world file: six numbers, one a line, by the centre of the top-left pixel.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for another number of lines, what is no number, and pixels without extent.
    pub fn read_world_file(text: &str) -> Result<Self, Error> {
        let numbers: Option<Vec<f64>> = text.split_whitespace().map(|word| word.parse().ok()).collect();
        let Some([a, d, b, e, x, y]) = numbers.as_deref().and_then(|numbers| <[f64; 6]>::try_from(numbers).ok()) else {
            let first: String = text.chars().take(60).collect();
            return refuse(Refusal::WorldFile { text: format!("{first:?}") });
        };
        Self { origin: [x - 0.5 * (a + b), y - 0.5 * (d + e)], by_column: [a, d], by_row: [b, e] }.checked()
    }

    /// As a world file.
    pub fn world_file(&self) -> String {
        let Self { by_column: [a, d], by_row: [b, e], .. } = *self;
        let [x, y] = self.ground([0.5, 0.5]);
        [a, d, b, e, x, y].map(|v| format!("{v}\n")).concat()
    }

    /// Refuses what places no picture.
    pub(crate) fn checked(self) -> Result<Self, Error> {
        let values = [self.origin, self.by_column, self.by_row];
        if !values.iter().flatten().all(|v| v.abs() <= LARGEST) || !(self.determinant().abs() > 0.0) {
            return refuse(Refusal::Georeference { numbers: format!("{values:?}") });
        }
        Ok(self)
    }

    /// Whether a picture of this size can only be in degrees: within their range, of pixels below a millimetre if they were metres.
    pub(crate) fn is_in_degrees(&self, [width, height]: [usize; 2]) -> bool {
        let corners = [[0.0, 0.0], [width as f64, height as f64]].map(|corner| self.ground(corner));
        self.gsd() < 1e-3 && corners.iter().all(|[x, y]| x.abs() <= 180.0 && y.abs() <= 90.0)
    }

    /// Refuses to place a picture mirrored, as a world file does whose rows go north: points of mirrored pictures resemble none of the ground.
    pub(crate) fn of_picture(self) -> Result<Self, Error> {
        if self.determinant() > 0.0 {
            let ([a, d], [b, e]) = (self.by_column, self.by_row);
            let rows_go_north = a > 0.0 && e > 0.0;
            return refuse(Refusal::MirroredPicture { a, d, b, e, rows_go_north });
        }
        Ok(self)
    }

    fn determinant(&self) -> f64 {
        self.by_column[0] * self.by_row[1] - self.by_column[1] * self.by_row[0]
    }

    /// The place of a position in px.
    pub fn ground(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|k| self.origin[k] + x * self.by_column[k] + y * self.by_row[k])
    }

    /// The position of a place in px.
    pub fn pixel(&self, place: [f64; 2]) -> [f64; 2] {
        let [dx, dy] = [0, 1].map(|k| place[k] - self.origin[k]);
        let determinant = self.determinant();
        [(dx * self.by_row[1] - dy * self.by_row[0]) / determinant, (dy * self.by_column[0] - dx * self.by_column[1]) / determinant]
    }

    /// The side of a square as large as a pixel, in units of the map.
    pub fn gsd(&self) -> f64 {
        self.determinant().abs().sqrt()
    }

    /// Of the picture halved so many times.
    pub fn halved(&self, halvings: u32) -> Self {
        self.with_gsd(f64::from(1_u32 << halvings) * self.gsd())
    }

    /// Along the same directions, with pixels of another side.
    pub fn with_gsd(&self, gsd: f64) -> Self {
        let factor = gsd / self.gsd();
        Self { origin: self.origin, by_column: self.by_column.map(|v| factor * v), by_row: self.by_row.map(|v| factor * v) }
    }

    /// Of the part of the picture that begins at a column and row.
    pub fn from(&self, column: usize, row: usize) -> Self {
        Self { origin: self.ground([column as f64, row as f64]), ..*self }
    }

    /// In a system whose coordinates are so many times as large.
    pub(crate) fn enlarged(&self, factor: f64) -> Self {
        let Self { origin, by_column, by_row } = *self;
        let [origin, by_column, by_row] = [origin, by_column, by_row].map(|vector| vector.map(|v| factor * v));
        Self { origin, by_column, by_row }
    }

    /// In a system whose origin is that place of this one.
    pub(crate) fn about(&self, place: [f64; 2]) -> Self {
        Self { origin: [0, 1].map(|k| self.origin[k] - place[k]), ..*self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixels_and_places_are_each_others_inverse() {
        let turned = Georeference { origin: [500_000.0, 5_400_000.0], by_column: [0.18, 0.02], by_row: [0.03, -0.2] };
        for at in [[0.0, 0.0], [1000.5, 20.25], [-3.0, 7.0]] {
            let back = turned.pixel(turned.ground(at));
            assert!((0..2).all(|k| (back[k] - at[k]).abs() < 1e-6), "{back:?} for {at:?}");
        }
        let part = turned.from(100, 50).halved(1);
        assert!((0..2).all(|k| (part.ground([10.0, 20.0])[k] - turned.ground([120.0, 90.0])[k]).abs() < 1e-6));
    }

    #[test]
    fn a_picture_that_is_mirrored_is_refused_and_a_turned_one_is_not() {
        let of = |a: f64, d: f64, b: f64, e: f64| Georeference { origin: [5e5, 5e6], by_column: [a, d], by_row: [b, e] };
        for mirrored in [of(0.5, 0.0, 0.0, 0.5), of(-0.5, 0.0, 0.0, -0.5), of(0.0, 0.5, -0.5, 0.0)] {
            let told = mirrored.of_picture().unwrap_err();
            let is_north = mirrored.by_row[1] > 0.0 && mirrored.by_column[0] > 0.0;
            assert!(
                matches!(&told, Error::InvalidInput { refusal: Refusal::MirroredPicture { rows_go_north, .. } } if *rows_go_north == is_north)
            );
            assert_eq!(told.to_string().contains("rows go north"), is_north, "{told}");
        }
        for turned in [of(0.5, 0.0, 0.0, -0.5), of(-0.5, 0.0, 0.0, 0.5), of(0.0, -0.5, -0.5, 0.0), of(0.3, 0.4, 0.4, -0.3)] {
            assert_eq!(turned.of_picture().unwrap(), turned);
        }
    }

    #[test]
    fn a_world_file_names_the_centre_of_the_first_pixel() {
        let read = Georeference::read_world_file("0.5\n0\n0\n-0.5\n100.25\n199.75\n").unwrap();
        assert_eq!(read, Georeference::north_up([100.0, 200.0], 0.5));
        assert_eq!(Georeference::read_world_file(&read.world_file()).unwrap(), read);
        for wrong in ["", "1 2 3 4 5", "1\n0\n0\nx\n0\n0", "0\n0\n0\n0\n5\n5", "1\n0\n0\n-1\nNaN\n5"] {
            assert!(Georeference::read_world_file(wrong).is_err(), "{wrong:?}");
        }
    }
}
