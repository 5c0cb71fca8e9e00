//! Small files of text: fiducials, observations and a camera in; points and matches out.

use crate::error::refuse;
use crate::json;
use crate::text::{Headed, NumberedRecord, Records, Row, records, shorten, table};
use crate::{CameraMm, Document, Error, Fiducial, Input, ModelPoint, Observation, Refusal};
use csv::StringRecord;
use serde::Deserialize;
use serde::de::IgnoredAny;
use std::collections::BTreeSet;

/// Reads fiducial marks: columns `col`, `row` (px, the centre of the top-left pixel at (0.5, 0.5)), `x_mm`, `y_mm`.
///
/// The first line, one below a title or a comment directly above the first mark names the columns, in any order, in capitals or not, also as `x (mm)`, and
/// columns and rows in German, French, Spanish, Italian or Portuguese (`Spalte`, `Zeile`); further columns are ignored. Separated by semicolons, tabs, commas or blanks;
/// where commas do not separate a number may have a decimal comma. Blank lines and lines that begin with `#` are skipped.
///
/// # Errors
/// [`Error::InvalidInput`], naming the line and the column.
pub fn parse_fiducials(csv: &str) -> Result<Vec<Fiducial>, Error> {
    let rows = read_table(Input::FiducialTable, csv, ["col", "row", "x_mm", "y_mm"])?;
    Ok(rows.into_iter().map(|[col, row, x_mm, y_mm]| Fiducial { col, row, x_mm, y_mm }).collect())
}

/// Reads photo coordinates in mm: columns `x_left_mm`, `y_left_mm`, `x_right_mm`, `y_right_mm`, in the form of [`parse_fiducials`].
///
/// # Errors
/// [`Error::InvalidInput`], naming the line and the column.
pub fn parse_observations(csv: &str) -> Result<Vec<Observation>, Error> {
    let rows = read_table(Input::ObservationTable, csv, ["x_left_mm", "y_left_mm", "x_right_mm", "y_right_mm"])?;
    Ok(rows.into_iter().map(|[xl, yl, xr, yr]| Observation::new([xl, yl], [xr, yr])).collect())
}

/// What a file of the cameras of a block holds.
#[derive(Deserialize)]
struct OfBlock {
    cameras: Vec<IgnoredAny>,
}

/// Reads a camera: `{"focal_mm": 153.38, "principal_point_mm": [0, 0], "pixel_mm": 0.01, "radial_distortion": [0, 0, 0],
/// "tangential_distortion": [0, 0]}`, all but the first optional.
///
/// # Errors
/// [`Error::InvalidJson`] with the place; [`Error::InvalidOption`] for a value outside its range; [`Error::InvalidInput`] for the cameras of a block.
pub fn parse_camera(json: &str) -> Result<CameraMm, Error> {
    let text = json.trim_start_matches('\u{feff}');
    // Of a block there is a file of cameras that looks like it.
    if let Ok(OfBlock { cameras }) = serde_json::from_str(text) {
        return refuse(Refusal::CamerasOfBlock { cameras: cameras.len() });
    }
    let camera: CameraMm = json::from_text(text).map_err(|json_fault| Error::InvalidJson { document: Document::Camera, json_fault })?;
    camera.check().map(|()| camera)
}

/// What an orientation made of a match or an observation.
const USED: &str = "used";
const REJECTED: &str = "rejected";

/// Writes matches `[x_left, y_left, x_right, y_right, measure]`, positions in px, one a line under a line of column names. `state` says what the
/// orientation made of a match: used or rejected, by the indices of those that it rejected; empty where there is none.
pub fn matches_csv(matches: &[[f64; 5]], rejected: Option<&[usize]>) -> String {
    let rejected: Option<BTreeSet<usize>> = rejected.map(|rejected| rejected.iter().copied().collect());
    let state = |index: usize| rejected.as_ref().map(|rejected| if rejected.contains(&index) { REJECTED } else { USED });
    let rows = matches.iter().enumerate().map(|(index, found)| Row::default().numbers(Some(*found)).known(state(index)));
    table(&["x_left_px", "y_left_px", "x_right_px", "y_right_px", "measure", "state"], rows)
}

/// Writes points `[x, y, value]`, positions in px, one a line under a line of column names.
pub fn points_csv(points: &[[f64; 3]]) -> String {
    write_table(&["x_px", "y_px", "value"], points)
}

/// Writes object points of a pair with their standard errors, one a line under a line of column names: `point` counts the observations from
/// 0, `use` says whether the observation took part; what is not known is empty.
pub fn model_points_csv(points: &[Option<ModelPoint>]) -> String {
    let rows = points.iter().enumerate().map(|(index, point)| {
        let row = Row::default().number(index).numbers(point.map(|point| point.position));
        let row = row.numbers(point.and_then(|point| point.errors));
        row.known(point.map(|point| if point.accepted { USED } else { REJECTED }))
    });
    table(&["point", "x", "y", "z", "sigma_x", "sigma_y", "sigma_z", "use"], rows)
}

fn write_table<const N: usize>(columns: &[&str; N], rows: &[[f64; N]]) -> String {
    table(columns, rows.iter().map(|row| Row::default().numbers(Some(*row))))
}

fn read_table<const N: usize>(input: Input, text: &str, columns: [&'static str; N]) -> Result<Vec<[f64; N]>, Error> {
    let records = records(input, text)?;
    let (places, rows) = find_columns(input, &records, columns)?;
    rows.iter().map(|(line, record)| read_row(input, &records, record, columns, places, *line)).collect()
}

/// Columns that have other names, too, in letters alone.
const WORDS: [(&str, &str); 2] = [("col", "column spalte colonne columna colonna coluna"), ("row", "zeile ligne fila riga linha")];

fn is_named(name: &str, column: &str) -> bool {
    let letters = |name: &str| name.chars().filter(|sign| sign.is_alphanumeric()).collect::<String>().to_lowercase();
    let (name, column) = (letters(name), letters(column));
    let words = || WORDS.iter().filter(|(of, _)| *of == column).flat_map(|(_, words)| words.split(' '));
    // Columns and rows are in px, whatever is said.
    name == column || words().chain(words().next().map(|_| column.as_str())).any(|word| name.strip_suffix("px").unwrap_or(&name) == word)
}

/// Where the columns stand, and the rows that have them.
fn find_columns<'a, const N: usize>(
    input: Input,
    records: &'a Records,
    columns: [&'static str; N],
) -> Result<([usize; N], &'a [NumberedRecord]), Error> {
    let find = |names: &StringRecord| columns.map(|column| names.iter().position(|name| is_named(name, column)));
    let Headed { names, rows, .. } = records.headed(find, &[])?;
    let shown = names.as_ref().or_else(|| records.likely_head(find));
    let places = shown.map_or([None; N], find);
    let mut found = [0; N];
    for ((found, place), column) in found.iter_mut().zip(places).zip(columns) {
        let names = || shown.map_or_else(String::new, |names| records.shown(names));
        *found = place
            .ok_or_else(|| Refusal::NoColumn { input, column: column.into(), names: names(), columns: columns.join(",") }.into_error())?;
        if shown.is_some_and(|names| names.iter().filter(|name| is_named(name, column)).count() > 1) {
            return refuse(Refusal::ColumnAgain { input, column: column.into(), columns: columns.join(",") });
        }
    }
    Ok((found, rows))
}

fn read_row<const N: usize>(
    input: Input,
    records: &Records,
    record: &StringRecord,
    columns: [&'static str; N],
    places: [usize; N],
    line: usize,
) -> Result<[f64; N], Error> {
    let mut row = [0.0; N];
    for ((value, column), place) in row.iter_mut().zip(columns).zip(places) {
        let own = || column.to_string();
        let field = record.get(place).ok_or_else(|| Refusal::NoValue { input, column: own(), line }.into_error())?;
        *value =
            records.number(field).ok_or_else(|| Refusal::NoNumber { input, word: shorten(field), column: own(), line }.into_error())?;
    }
    Ok(row)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn message(csv: &str) -> String {
        parse_fiducials(csv).unwrap_err().to_string()
    }

    #[test]
    fn columns_stand_in_any_order_among_others() {
        let text = "\u{feff}# a scan\r\n\r\nmark, y_mm, x_mm, row, col\r\n1, 4, 3, 2, 1.5\r\n  \r\n# end\r\n2, -4, -3, 20, 10\r\n";
        let marks = parse_fiducials(text).unwrap();
        assert_eq!(
            marks,
            [Fiducial { col: 1.5, row: 2.0, x_mm: 3.0, y_mm: 4.0 }, Fiducial { col: 10.0, row: 20.0, x_mm: -3.0, y_mm: -4.0 },]
        );
    }

    #[test]
    fn columns_are_known_in_other_languages_below_titles_and_behind_comment_signs() {
        let wanted = [Fiducial { col: 1.5, row: 2.0, x_mm: -103.9, y_mm: 4.0 }];
        for text in [
            "Spalte;Zeile;x (mm);y (mm)\n1,5;2;-103,9;4\n",
            "RMK 1963\nZeile;Spalte (px);X [mm];Y_mm\n2;1,5;-103,9;4\n",
            "Ligne\tColonne\tx_mm\ty_mm\n2\t1.5\t-103.9\t4\n",
            "#row,col,x_mm,y_mm\n2,1.5,-103.9,4\n",
            "col row x_mm y_mm\n1.5 2 -103.9 4\n",
        ] {
            assert_eq!(parse_fiducials(text).unwrap(), wanted, "{text}");
        }
        // Without their unit coordinates may be in anything.
        assert!(message("Spalte;Zeile;x;y\n1,5;2;-103,9;4\n").contains("no column x_mm in the first line 'Spalte;Zeile;x;y'"));
        assert!(message("col,Spalte,row,x_mm,y_mm\n1,1,2,3,4\n").contains("column col twice"));
        assert!(message("col,row,x_mm,y_mm\n1,5,2,-103,9\n").contains("decimal commas"));
    }

    #[test]
    fn semicolons_separate_where_the_first_line_has_them() {
        let read = parse_observations("x_left_mm;y_left_mm;x_right_mm;y_right_mm\n1;2;-3;4e-1\n;;;\n1,5;2;3;4\n").unwrap();
        assert_eq!(read, [Observation::new([1.0, 2.0], [-3.0, 0.4]), Observation::new([1.5, 2.0], [3.0, 4.0])]);
    }

    #[test]
    fn what_is_wrong_is_named_by_line_and_column() {
        assert!(message("").contains("no column col"), "{}", message(""));
        assert!(message("1,2,3,4\n5,6,7,8\n").contains("no column col in the first line '1,2,3,4'"));
        assert!(message("col,row,x_mm,y_mm,row\n1,2,3,4,5\n").contains("column row twice"));
        assert!(message("col,row,x_mm,y_mm\n1,2,3,4\n\n1,2,x,4\n").contains("'x' for x_mm in line 4"));
        assert!(message("col,row,x_mm,y_mm\r\n# two\r\n1,2,3,4\r\n \r\n\r\n#\r\n1,2,x,4").contains("'x' for x_mm in line 7"));
        assert!(message("col,row,x_mm,y_mm\n1,2,3\n").contains("no value for y_mm in line 2"));
        assert!(message("col,row,x_mm,y_mm\n1,NaN,3,4\n").contains("'NaN' for row in line 2"));
        assert!(message("col,row,x_mm,y_mm\n1,inf,3,4\n").contains("'inf' for row"));
        assert!(message("col,row,x_mm,y_mm\n\"1,500\",2,3,4\n").contains("'1,500' for col in line 2"));
        assert!(!message(&"\u{1}x".repeat(1000)).contains('\u{1}'));
    }

    #[test]
    fn a_camera_is_read_and_checked() {
        let camera = parse_camera("\u{feff}{\"focal_mm\": 24.0, \"pixel_mm\": 0.0039}").unwrap();
        assert_eq!((camera.focal_mm, camera.pixel_mm, camera.principal_point_mm), (24.0, Some(0.0039), [0.0, 0.0]));
        let of_block = parse_camera(r#"{"cameras": [{"images": "a*", "focal_px": 1500}, {"focal_px": 900}]}"#).unwrap_err();
        assert_eq!(of_block, Error::InvalidInput { refusal: Refusal::CamerasOfBlock { cameras: 2 } });
        assert!(of_block.to_string().contains("got 2 cameras of a block"), "{of_block}");
        assert_eq!(parse_camera("{\"focal_mm\": 24,").unwrap_err().code(), "invalid-json");
        assert_eq!(parse_camera("{\"focal_mm\": -24}").unwrap_err().code(), "invalid-option");
    }

    #[test]
    fn written_numbers_read_back_as_they_were() {
        let matches = [[0.5, 1.25, 1.0 / 3.0, 1e-7, 2.5], [1.0, 2.0, 3.0, 4.0, 0.5]];
        let text = |states: [&str; 2]| {
            let [first, second] = states;
            let (x, y) = (1.0 / 3.0, 1e-7);
            format!("x_left_px,y_left_px,x_right_px,y_right_px,measure,state\n0.5,1.25,{x},{y},2.5,{first}\n1,2,3,4,0.5,{second}\n")
        };
        assert_eq!(matches_csv(&matches, Some(&[1])), text(["used", "rejected"]));
        assert_eq!(matches_csv(&matches, None), text(["", ""]));
        let point = |errors, accepted| Some(ModelPoint { position: [1.0, -0.5, -2.0], errors, accepted });
        assert_eq!(
            model_points_csv(&[point(Some([0.25; 3]), true), None, point(None, false)]),
            "point,x,y,z,sigma_x,sigma_y,sigma_z,use\n0,1,-0.5,-2,0.25,0.25,0.25,used\n1,,,,,,,\n2,1,-0.5,-2,,,,rejected\n"
        );
        assert_eq!(points_csv(&[[0.5, 1.5, 40.0]]), "x_px,y_px,value\n0.5,1.5,40\n");
    }
}
