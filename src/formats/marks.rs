//! Reading where images show surveyed points.

use super::columns::{IMAGES, letters, others, without_unit};
use crate::error::refuse;
use crate::text::{Records, Row, records, shorten, table};
use crate::{Error, Input, Refusal};
use csv::StringRecord;
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

/// Reads marks: lines of image, point, x, y in px, between commas, semicolons or tabs; between the latter two numbers may have a decimal comma. A first line
/// of column names, without figures where places stand, may come before them: where it names image, point, x (or column) and y (or row), each by one of
/// many names, with `[px]` behind it or not, these stand as it says, among others or not. Blank lines are skipped, and so are those that begin with `#`.
///
/// # Errors
/// [`Error::InvalidInput`], naming the line: for a name that is missing, a number that is none, and a point twice in an image; for a first line that
/// names some columns elsewhere than in that order and not all.
///
/// # Source
/// The columns of the table of marks of Pix4D.
pub fn parse_image_measurements(text: &str) -> Result<Vec<ImageMeasurementRow>, Error> {
    let mut seen = BTreeSet::new();
    let mut marks = Vec::new();
    let records = records(Input::MarkTable, text)?;
    let named = records.rows.first().map(|(_, first)| columns_of(&records, first)).transpose()?.flatten();
    let [of_image, of_point, of_x, of_y] = named.unwrap_or(IN_ORDER);
    for (line, record) in records.rows.iter().skip(usize::from(named.is_some())) {
        let (field, line) = (|column: usize| record.get(column).unwrap_or(""), *line);
        let (image, point) = (field(of_image).to_string(), field(of_point).to_string());
        let (Some(x_px), Some(y_px)) = (records.number(field(of_x)), records.number(field(of_y))) else {
            return refuse(Refusal::MeasuredNumbers { x: shorten(field(of_x)), y: shorten(field(of_y)), line });
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

/// Where image, point, x and y stand without names.
const IN_ORDER: [usize; 4] = [0, 1, 2, 3];

/// The names of these columns here and in other programs, in letters alone. The first of them that a table has is read.
const NAMES: [&str; 4] = [
    IMAGES,
    "point label marker name gcp id pointname pointid gcpname gcpid gcplabel markername pointnumber pointno target nr punkt punktname \
     punktnummer punktnr",
    "x col column u px pixelx xpixel imagex ximage sample samp spalte",
    "y row line v py pixely ypixel imagey yimage zeile",
];

/// Where a first line says that image, point, x and y stand; none where it has a measurement.
fn columns_of(records: &Records, first: &StringRecord) -> Result<Option<[usize; 4]>, Error> {
    let letters: Vec<String> = first.iter().map(|name| letters(&without_unit(name, &["px", "pix", "pixel", "pixels"]).0)).collect();
    let find = |names: &str| names.split(' ').find_map(|name| letters.iter().position(|column| column == name));
    let found = NAMES.map(find);
    if let [Some(image), Some(point), Some(x), Some(y)] = found {
        return Ok(Some([image, point, x, y]));
    }
    // Images and points may have names of columns; a number with a slip is no name.
    let is_word = |column: usize| first.get(column).is_some_and(|field| !field.is_empty() && !field.contains(|c: char| c.is_ascii_digit()));
    if ![2, 3].into_iter().all(is_word) {
        return Ok(None);
    }
    let is_in_order = found.iter().zip(IN_ORDER).all(|(found, place)| found.is_none_or(|column| column == place));
    match found.iter().position(Option::is_none).filter(|_| !is_in_order) {
        Some(missing) => {
            let column = NAMES[missing].split(' ').next().unwrap_or("").into();
            refuse(Refusal::MeasuredColumn { column, known: others(NAMES[missing]), names: records.shown(first) })
        }
        None => Ok(Some(IN_ORDER)),
    }
}

/// The table of some measurements, which reads back as they are.
pub(crate) fn image_measurement_table(measurements: &[ImageMeasurementRow]) -> String {
    let row = |is: &ImageMeasurementRow| Row::default().text(&is.image).text(&is.point).number(is.x_px).number(is.y_px);
    table(&["image", "point", "x_px", "y_px"], measurements.iter().map(row))
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
    fn columns_of_marks_stand_where_the_first_line_names_them() {
        let wanted = parse_image_measurements("a.jpg,P1,10.5,20\n").unwrap();
        for text in [
            "Label,Image,x_px,y_px\nP1,a.jpg,10.5,20\n",
            "image,point,row,col\na.jpg,P1,20,10.5\n",
            "Photo;Marker;X [px];Y [px]\na.jpg;P1;10,5;20,0\n",
            "Bild\tPunkt\tNotiz\tSpalte\tZeile\na.jpg\tP1\tTor\t10,5\t20\n",
            "id,x,y,GCP,file name\n7,10.5,20,P1,a.jpg\n",
            // Names that say nothing here: the columns stand in order.
            "Aufnahme,Ziel,rechts,unten\na.jpg,P1,10.5,20\n",
            "image,Ziel,x,y\na.jpg,P1,10.5,20\n",
        ] {
            let read = parse_image_measurements(text);
            if text.starts_with("id") {
                // Of two names of points the first in the list is read.
                assert_eq!(read.unwrap()[0].point, "P1");
            } else {
                assert_eq!(read.unwrap(), wanted, "{text}");
            }
        }
        let refused = parse_image_measurements("Ziel,Image,x_px,y_px\nP1,a.jpg,10.5,20\n").unwrap_err().to_string();
        assert!(refused.contains("no column 'point' (or label, marker,") && refused.contains("'Ziel,Image,x_px,y_px'"), "{refused}");
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
