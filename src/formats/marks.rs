//! Reading where images show surveyed points.

use crate::error::refuse;
use crate::text::{Row, records, shorten, table};
use crate::{Error, Input, Refusal};
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;

/// A surveyed point as it was measured in an image.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ImageMeasurementRow {
    /// File name of the image.
    pub image: String,
    /// Name of the point.
    pub point: String,
    /// Column and row in px; the centre of the top-left pixel is (0.5, 0.5).
    pub x_px: f64,
    pub y_px: f64,
}

/// Reads marks: lines of image, point, x, y in px, between commas, semicolons or tabs. A first line of column names, without figures where places
/// stand, is skipped, and so are blank lines and those that begin with `#`.
///
/// # Errors
/// [`Error::InvalidInput`], naming the line: for a name that is missing, a number that is none, and a point twice in an image.
///
/// # Source
/// The columns of the table of marks of Pix4D.
pub fn parse_image_measurements(text: &str) -> Result<Vec<ImageMeasurementRow>, Error> {
    let mut seen = BTreeSet::new();
    let mut marks = Vec::new();
    for (index, (line, record)) in records(Input::MarkTable, text)?.into_iter().enumerate() {
        let field = |column: usize| record.get(column).unwrap_or("");
        let number = |column: usize| field(column).parse().ok().filter(|v: &f64| v.is_finite());
        if index == 0 && [2, 3].iter().all(|column| is_word(field(*column))) {
            continue;
        }
        let (image, point) = (field(0).to_string(), field(1).to_string());
        let (Some(x_px), Some(y_px)) = (number(2), number(3)) else {
            return refuse(Refusal::MeasuredNumbers { x: shorten(field(2)), y: shorten(field(3)), line });
        };
        if image.is_empty() || point.is_empty() {
            return refuse(Refusal::MeasuredNames { line });
        }
        if !seen.insert((image.clone(), point.clone())) {
            return refuse(Refusal::MeasuredAgain { point: shorten(&point), image: shorten(&image), line });
        }
        marks.push(ImageMeasurementRow { image, point, x_px, y_px });
    }
    Ok(marks)
}

/// The table of some measurements, which reads back as they are.
pub(crate) fn image_measurement_table(measurements: &[ImageMeasurementRow]) -> String {
    let row = |is: &ImageMeasurementRow| Row::default().text(&is.image).text(&is.point).number(is.x_px).number(is.y_px);
    table(&["image", "point", "x_px", "y_px"], measurements.iter().map(row))
}

/// Whether a field names a column; a number with a slip is no name.
fn is_word(field: &str) -> bool {
    !field.is_empty() && field.chars().all(|c| !c.is_ascii_digit())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_are_read_with_and_without_column_names() {
        let with = parse_image_measurements("image,point,x,y\na.jpg,P1,10.5,20\n\n# none\nb.jpg, P1 ,1,2,0.5\n").unwrap();
        assert_eq!(with.len(), 2);
        assert_eq!(with[1], ImageMeasurementRow { image: "b.jpg".into(), point: "P1".into(), x_px: 1.0, y_px: 2.0 });
        assert_eq!(parse_image_measurements("a.jpg;P1;10.5;20").unwrap(), with[..1]);
        assert!(parse_image_measurements("").unwrap().is_empty());
        assert_eq!(parse_image_measurements(&image_measurement_table(&with)).unwrap(), with);
    }

    #[test]
    fn wrong_lines_are_named() {
        for (text, named) in [
            ("a.jpg,P1,1,2\na.jpg,P1,3,4", "line 2"),
            ("a.jpg,P1,1,2\nb.jpg,P2,x,4", "line 2"),
            ("a.jpg,P1,1,2\nb.jpg,P2,3", "line 2"),
            (",P1,1,2", "line 1"),
            ("a.jpg,P1,1O0.5,2O0.5\nb.jpg,P1,1,2", "'1O0.5', '2O0.5' as place in line 1"),
            ("a.jpg,P1,NaN,2", "line 1"),
        ] {
            let message = parse_image_measurements(text).unwrap_err().to_string();
            assert!(message.contains(named), "{text}: {message}");
        }
    }
}
