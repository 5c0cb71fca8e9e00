//! Reading where images show surveyed points.

use super::column_units::is_of_other_unit;
use super::columns::{IMAGES, UnreadColumns, letters, others, without_unit};
use super::system_line::SystemLine;
use super::whole_numbers::{NumberColumns, has_leading_zero};
use crate::error::refuse;
use crate::text::{Headed, NumberedRecord, Records, Row, records, shorten, table};
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

/// Reads marks: lines of image, point, x, y in px, between semicolons, tabs, commas or blanks; numbers may have a decimal comma where commas do not separate.
/// A first line of column names, without figures where places stand, may come before them, below a title and above a line of units: where it names image,
/// point, x (or column) and y (or row), each by one of many names, with `[px]` behind it or not, these stand as it says, among others or not. So does a
/// comment directly above the first measurement. Blank lines are skipped, and so are those that begin with `#`.
///
/// # Errors
/// [`Error::InvalidInput`], naming the line: for a name that is missing, a number that is none, and a point twice in an image; for a first line or a
/// comment above it that names some columns elsewhere than in that order and not all, or places in another unit than px; for fields that may be parts of numbers with decimal commas.
///
/// # Source
/// The columns of the table of marks of Pix4D.
pub fn parse_image_measurements(text: &str) -> Result<Vec<ImageMeasurementRow>, Error> {
    let mut seen = BTreeSet::new();
    let mut marks = Vec::new();
    let records = records(Input::MarkTable, text)?;
    let Layout { columns: [of_image, of_point, of_x, of_y], rows, .. } = Layout::of(&records)?;
    for (line, record) in rows {
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

/// Columns of the table that are not read.
///
/// # Errors
/// As [`parse_image_measurements`].
pub(crate) fn unread_mark_columns(text: &str) -> Result<Vec<String>, Error> {
    let records = records(Input::MarkTable, text)?;
    let Layout { columns, names, rows } = Layout::of(&records)?;
    Ok(UnreadColumns::of(rows, names.as_ref(), &columns.into(), |_| None).unknown)
}

/// Where image, point, x and y stand without names.
const IN_ORDER: [usize; 4] = [0, 1, 2, 3];

/// The names of these columns here and in other programs, in letters alone. The first of them that a table has is read.
const NAMES: [&str; 4] = [
    IMAGES,
    "point label marker name gcp id pointname pointid gcpname gcpid gcplabel markername pointnumber pointno target nr punkt punktname \
     punktnummer punktnr matricule punto ponto النقطة نقطة",
    "x col column u px pixelx xpixel imagex ximage sample samp spalte colonne columna colonna coluna العمود",
    "y row line v py pixely ypixel imagey yimage zeile ligne fila riga linha السطر الصف",
];

const UNITS: [&str; 4] = ["px", "pix", "pixel", "pixels"];

/// Names of the column of images beside those that other tables have.
const FURTHER_IMAGES: &str = "camera cameralabel";

/// Where a line of names says that image, point, x and y stand. Of several columns those of pixels are read: others may be of the ground.
fn find(names: &StringRecord) -> [Option<usize>; 4] {
    let columns: Vec<(String, bool)> =
        names.iter().map(|name| without_unit(name, &UNITS)).map(|(name, unit)| of_pixels(&name, unit)).collect();
    let first = |name: &str, pixels: bool| columns.iter().position(|(column, of_pixels)| column == name && *of_pixels == pixels);
    let [image, point, x, y] = NAMES.map(|names| {
        let any = |pixels: bool| names.split(' ').find_map(|name| first(name, pixels));
        any(true).or_else(|| any(false))
    });
    [image.or_else(|| FURTHER_IMAGES.split(' ').find_map(|name| first(name, false))), point, x, y]
}

/// A name in letters, and whether it says that the column is of pixels.
fn of_pixels(name: &str, unit: Option<&str>) -> (String, bool) {
    let name = letters(name);
    let is_of_pixels = unit.is_some() || ["px", "py", "pix"].iter().any(|word| name.contains(word));
    (name, is_of_pixels)
}

/// Where image, point, x and y stand, what names the columns, and the rows.
struct Layout<'a> {
    columns: [usize; 4],
    names: Option<StringRecord>,
    rows: &'a [NumberedRecord],
}

impl<'a> Layout<'a> {
    fn of(records: &'a Records) -> Result<Self, Error> {
        let Headed { names, rows, misplaced } = records.headed(find, &UNITS)?;
        let numbers = |[image, point, x, y]: [usize; 4], named: usize| NumberColumns {
            read: vec![x, y],
            height: None,
            errors: Vec::new(),
            texts: vec![image, point],
            named: Some(named),
        };
        if let Some((names, [Some(image), Some(point), Some(x), Some(y)])) = names.map(|names| (names.clone(), find(&names))) {
            let columns = [image, point, x, y];
            let numbers = numbers(columns, names.len());
            numbers.check_thousands(records, rows)?;
            numbers.check(records, rows)?;
            return Ok(Self { columns, names: Some(names), rows });
        }
        SystemLine::refuse_in(records)?;
        let missing = |names: &StringRecord| {
            let missing = find(names).iter().position(Option::is_none).unwrap_or(0);
            let column = NAMES[missing].split(' ').next().unwrap_or("").into();
            refuse(Refusal::MeasuredColumn { column, known: others(NAMES[missing]), names: records.shown(names) })
        };
        if let Some(names) = &misplaced {
            return missing(names);
        }
        let Some((_, first)) = rows.first() else { return Ok(Self { columns: IN_ORDER, names: None, rows }) };
        // Images and points may have names of columns; a number with a slip is no name.
        let is_word =
            |column: usize| first.get(column).is_some_and(|field| !field.is_empty() && !field.contains(|c: char| c.is_ascii_digit()));
        let has_names = [2, 3].into_iter().all(is_word);
        if !has_names {
            check_fields(records)?;
        } else if let Some(name) = [2, 3].into_iter().filter_map(|column| first.get(column)).find(|name| is_of_other_unit(name, &UNITS)) {
            let (input, column, units) = (records.input(), shorten(name), UNITS[0].into());
            return refuse(Refusal::ColumnUnit { input, column, units, degrees: false });
        } else if !find(first).iter().zip(IN_ORDER).all(|(found, place)| found.is_none_or(|column| column == place)) {
            return missing(first);
        }
        let rows = &rows[usize::from(has_names)..];
        numbers(IN_ORDER, 0).check_thousands(records, rows)?;
        Ok(Self { columns: IN_ORDER, names: Some(first.clone()).filter(|_| has_names), rows })
    }
}

/// Refuses rows without names whose commas may be decimal commas, with more than two whole numbers behind image and point; and more words between blanks,
/// which names may have.
fn check_fields(records: &Records) -> Result<(), Error> {
    for (line, record) in &records.rows {
        let (line, shown) = (*line, || records.shown(record));
        if records.has_blanks() && record.len() != IN_ORDER.len() {
            return refuse(Refusal::BlankFields { input: Input::MarkTable, record: shown(), line, columns: IN_ORDER.len() });
        }
        let numbers: Vec<&str> = record.iter().skip(2).take_while(|field| records.number(field).is_some()).collect();
        if (numbers.len() > 2 || numbers.iter().any(|field| has_leading_zero(field))) && records.may_be_cut(&numbers) {
            return refuse(Refusal::DecimalCommas { input: Input::MarkTable, record: shown(), line });
        }
    }
    Ok(())
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
        let with = parse_image_measurements("image,point,x,y,weight\na.jpg,P1,10.5,20\n\n# none\nb.jpg, P1 ,1,2,0.5\n").unwrap();
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
