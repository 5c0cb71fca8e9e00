//! Reading surveyed points: control and check points of a block.

use crate::error::refuse;
use crate::text::{Row, records, shorten, table};
use crate::{ControlRole, Error, Input, Refusal};
use csv::StringRecord;
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;

/// A point whose coordinates are known.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct GroundControlRow {
    pub name: String,
    /// `[x, y, z]` in the unit of the file.
    pub position: [f64; 3],
    /// Standard errors of the place and of the height, above 0; absent where the file has none.
    pub standard_errors: Option<[f64; 2]>,
    /// What it is for; absent where it is not used at all.
    #[serde(default = "control")]
    pub role: Option<ControlRole>,
    /// Standard error of a coordinate of its image measurements in px, above 0; absent where the file has none.
    #[serde(default)]
    pub sigma_px: Option<f64>,
}

fn control() -> Option<ControlRole> {
    Some(ControlRole::Control)
}

/// Reads lines of `name, x, y, z` with or without the standard errors of place and height behind them, between commas, semicolons or tabs.
///
/// A first line that names columns may come before them, in any order, in capitals or not: name, x, y, z, standard errors of place and height,
/// of image measurements in px, and use (`control`, `check` or `off`), each by one of many names; a run tells which are none. Of standard errors of x and y
/// the larger one counts. Without that line the columns are those, as in Pix4D's files. Blank lines and lines that begin with `#` are skipped.
///
/// # Errors
/// [`Error::InvalidInput`], naming the line, for numbers that are none, standard errors that are not above 0, and a name that comes twice.
pub fn parse_ground_control_points(text: &str) -> Result<Vec<GroundControlRow>, Error> {
    let (mut points, mut names, mut columns) = (Vec::new(), BTreeSet::new(), None);
    for (line, record) in records(Input::ControlTable, text)? {
        let Some(columns) = &columns else {
            let found = Columns::of(&record)?;
            columns = Some(found.unwrap_or_default());
            if found.is_none() {
                points.push(read_point(&record, &Columns::default(), line, &mut names)?);
            }
            continue;
        };
        points.push(read_point(&record, columns, line, &mut names)?);
    }
    Ok(points)
}

/// Columns of the table that have a name which says nothing here: they are not read.
///
/// # Errors
/// As [`parse_ground_control_points`].
pub(crate) fn unknown_columns(text: &str) -> Result<Vec<String>, Error> {
    let records = records(Input::ControlTable, text)?;
    let Some((_, record)) = records.first().filter(|(_, record)| !is_point(record)) else { return Ok(Vec::new()) };
    let is_known = |field: &str| NAMES.iter().any(|(_, names)| names.iter().any(|name| field.eq_ignore_ascii_case(name)));
    Ok(record.iter().filter(|field| !field.is_empty() && !is_known(field)).map(String::from).collect())
}

/// What a column may hold.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Column {
    Name,
    X,
    Y,
    Z,
    ErrorAcross,
    ErrorX,
    ErrorY,
    ErrorUp,
    ErrorPx,
    Use,
}

/// The names of columns in tables of control points, here and in other programs.
const NAMES: [(Column, &[&str]); 10] = [
    (Column::Name, &["name", "label", "point", "id", "point_id", "gcp", "nr"]),
    (Column::X, &["x", "e", "east", "easting", "x_m", "longitude", "lon", "long"]),
    (Column::Y, &["y", "n", "north", "northing", "y_m", "latitude", "lat"]),
    (Column::Z, &["z", "h", "height", "elevation", "altitude", "alt", "up", "z_m"]),
    (Column::ErrorAcross, &["sigma_xy", "accH", "acc_xy", "accuracy_xy", "std_xy", "rms_xy", "horizontal_accuracy", "across"]),
    (Column::ErrorX, &["sigma_x", "acc_x", "accuracy_x", "std_x", "rms_x", "sx"]),
    (Column::ErrorY, &["sigma_y", "acc_y", "accuracy_y", "std_y", "rms_y", "sy"]),
    (Column::ErrorUp, &["sigma_z", "accV", "acc_z", "accuracy_z", "std_z", "rms_z", "sz", "vertical_accuracy", "up_error"]),
    (Column::ErrorPx, &["sigma_px", "std_px", "accuracy_px", "image_accuracy"]),
    (Column::Use, &["use", "role"]),
];

/// The columns of a table: of the name, of x, y, z, of the standard errors of the place (of which the larger one counts) and of the height.
#[derive(Debug, Clone, Copy)]
struct Columns {
    name: usize,
    position: [usize; 3],
    standard_errors: Option<([usize; 2], usize)>,
    role: Option<usize>,
    sigma_px: Option<usize>,
}

impl Default for Columns {
    fn default() -> Self {
        Self { name: 0, position: [1, 2, 3], standard_errors: Some(([4, 4], 5)), role: None, sigma_px: None }
    }
}

/// Whether a line holds a point, and no names of columns.
fn is_point(record: &StringRecord) -> bool {
    (1..4).all(|column| record.get(column).is_some_and(|field| field.parse::<f64>().is_ok()))
}

impl Columns {
    /// The columns that a line names; none where it has a point.
    fn of(record: &StringRecord) -> Result<Option<Self>, Error> {
        if is_point(record) {
            return Ok(None);
        }
        let place = |wanted: Column| {
            let names = NAMES.iter().filter(|(column, _)| *column == wanted).flat_map(|(_, names)| *names);
            names.into_iter().find_map(|name| record.iter().position(|field| field.eq_ignore_ascii_case(name)))
        };
        let needed = |column: Column, name: &str| {
            let names = record.iter().collect::<Vec<_>>().join(",");
            place(column).ok_or_else(|| Refusal::ControlColumn { column: name.into(), names: shorten(&names) }.into_error())
        };
        let apart = place(Column::ErrorX).zip(place(Column::ErrorY)).map(|(x, y)| [x, y]);
        let across = place(Column::ErrorAcross).map(|column| [column; 2]).or(apart);
        let standard_errors = across.zip(place(Column::ErrorUp));
        let errors = [Column::ErrorAcross, Column::ErrorX, Column::ErrorY, Column::ErrorUp];
        if let (None, Some(one)) = (standard_errors, errors.into_iter().find_map(place)) {
            let name = record.get(one).unwrap_or("");
            return refuse(Refusal::ControlErrorColumn { column: shorten(name) });
        }
        Ok(Some(Self {
            name: needed(Column::Name, "name")?,
            position: [needed(Column::X, "x")?, needed(Column::Y, "y")?, needed(Column::Z, "z")?],
            standard_errors,
            role: place(Column::Use),
            sigma_px: place(Column::ErrorPx),
        }))
    }
}

fn read_point(record: &StringRecord, columns: &Columns, line: usize, names: &mut BTreeSet<String>) -> Result<GroundControlRow, Error> {
    let field = |column: usize| record.get(column).unwrap_or("");
    let number = |column: usize, what: &str| {
        let value = field(column).parse().ok().filter(|value: &f64| value.is_finite());
        value.ok_or_else(|| Refusal::ControlNumber { word: shorten(field(column)), column: what.into(), line }.into_error())
    };
    let name = field(columns.name).to_string();
    if name.is_empty() || name.chars().any(char::is_control) || !names.insert(name.clone()) {
        return refuse(Refusal::ControlName { name: shorten(&name), line });
    }
    let [x, y, z] = columns.position;
    let position = [number(x, "x")?, number(y, "y")?, number(z, "z")?];
    let given = columns.standard_errors.filter(|([x, y], z)| [x, y, z].iter().any(|column| !field(**column).is_empty()));
    let standard_errors = match given {
        Some(([x, y], z)) => Some([number(x, "sigma_xy")?.max(number(y, "sigma_xy")?), number(z, "sigma_z")?]),
        None => None,
    };
    if let Some(errors) = standard_errors.filter(|errors| !errors.iter().all(|error| *error > 0.0)) {
        return refuse(Refusal::ControlErrors { errors: format!("{errors:?}"), line });
    }
    let role = match columns.role.map(field).unwrap_or("").to_ascii_lowercase().as_str() {
        "" | "control" => Some(ControlRole::Control),
        "check" => Some(ControlRole::Check),
        "off" => None,
        other => return refuse(Refusal::ControlUse { word: shorten(other), line }),
    };
    let sigma_px = columns.sigma_px.filter(|column| !field(*column).is_empty()).map(|column| number(column, "sigma_px")).transpose()?;
    if let Some(sigma) = sigma_px.filter(|sigma| !(*sigma > 0.0)) {
        return refuse(Refusal::ControlErrors { errors: sigma.to_string(), line });
    }
    Ok(GroundControlRow { name, position, standard_errors, role, sigma_px })
}

/// The table of some points, which reads back as they are.
pub(crate) fn ground_control_table(points: &[GroundControlRow]) -> String {
    let rows = points.iter().map(|point| {
        let row = point.position.iter().fold(Row::default().text(&point.name), |row, value| row.number(value));
        row.numbers(point.standard_errors).known(point.sigma_px).number(match point.role {
            Some(ControlRole::Control) => "control",
            Some(ControlRole::Check) => "check",
            None => "off",
        })
    });
    table(&["name", "x", "y", "z", "sigma_xy", "sigma_z", "sigma_px", "use"], rows)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn message(text: &str) -> String {
        parse_ground_control_points(text).unwrap_err().to_string()
    }

    #[test]
    fn points_are_read_with_and_without_names_of_columns() {
        let point = |name: &str, position, standard_errors| GroundControlRow {
            name: name.into(),
            position,
            standard_errors,
            role: Some(ControlRole::Control),
            sigma_px: None,
        };
        let wanted = [point("A1", [1.0, 2.0, 3.0], Some([0.02, 0.03])), point("A 2", [-1.5, 2e3, 0.0], None)];
        assert_eq!(parse_ground_control_points("A1,1,2,3,0.02,0.03\n\nA 2,-1.5,2e3,0\n").unwrap(), wanted);
        assert_eq!(
            parse_ground_control_points("\u{feff}# control\r\nz;Name;y;x;sigma_z;sigma_xy\r\n3;A1;2;1;0.03;0.02\r\n0;A 2;2000;-1.5;;\r\n")
                .unwrap(),
            wanted
        );
        assert_eq!(parse_ground_control_points("A1\t1\t2\t3\t0.02\t0.03\nA 2\t-1.5\t2000\t0\n").unwrap(), wanted);
        assert_eq!(parse_ground_control_points("label,X,Y,Z,accH,accV\nA1,1,2,3,0.02,0.03\nA 2,-1.5,2000,0\n").unwrap(), wanted);
        assert!(parse_ground_control_points("").unwrap().is_empty());
        let roles = parse_ground_control_points("name,x,y,z,Use\na,1,2,3,control\nb,1,2,3,Check\nc,1,2,3,off\nd,1,2,3,\n").unwrap();
        let [control, check] = [Some(ControlRole::Control), Some(ControlRole::Check)];
        assert_eq!(roles.iter().map(|point| point.role).collect::<Vec<_>>(), [control, check, None, control]);
        let measured = parse_ground_control_points("name,x,y,z,sigma_px\na,1,2,3,0.4\nb,1,2,3,\n").unwrap();
        assert_eq!(measured.iter().map(|point| point.sigma_px).collect::<Vec<_>>(), [Some(0.4), None]);
        assert!(message("name,x,y,z,sigma_px\na,1,2,3,0\n").contains("standard errors 0 in line 2"));
        for points in [&wanted[..], &roles, &measured] {
            assert_eq!(parse_ground_control_points(&ground_control_table(points)).unwrap(), points);
        }
        assert!(message("name,x,y,z,use\na,1,2,3,maybe\n").contains("'maybe' as use in line 2"));
    }

    #[test]
    fn what_is_wrong_is_named_by_line() {
        assert!(message("A,1,2\n").contains("neither a column 'name' nor a point"));
        assert!(message("A,1,2,3\nB,1,x,3\n").contains("'x' for y in line 2"));
        assert!(message("A,1,2,3\nB,1,2,inf\n").contains("'inf' for z in line 2"));
        assert!(message("A,1,2,3\nA,1,2,3\n").contains("the name 'A' in line 2"));
        assert!(message("A,1,2,3,0,1\n").contains("not above 0"));
        assert!(
            message("A,1,2,3,0.1\n").contains("'' for sigma_z in line 1; allowed: lines of name, x, y, z and perhaps both"),
            "{}",
            message("A,1,2,3,0.1\n")
        );
        assert!(message("name,x,y,z\n,1,2,3\n").contains("the name ''"));
    }

    #[test]
    fn columns_are_known_by_many_names_and_others_are_told() {
        let read = |text: &str| parse_ground_control_points(text).unwrap()[0].standard_errors;
        assert_eq!(read("point_id,easting,northing,elevation,std_x,std_y,std_z\nA1,1,2,3,0.02,0.05,0.03\n"), Some([0.05, 0.03]));
        assert_eq!(read("GCP;E;N;H;rms_xy;rms_z\nA1;1;2;3;0.02;0.03\n"), Some([0.02, 0.03]));
        let unknown = unknown_columns("name,x,y,z,code,sigma_xy,sigma_z,Kommentar\nA1,1,2,3,tp,0.02,0.03,\n").unwrap();
        assert_eq!(unknown, ["code", "Kommentar"]);
        assert!(unknown_columns("A1,1,2,3,0.02,0.03,more\n").unwrap().is_empty() && unknown_columns("").unwrap().is_empty());
        assert!(message("name,x,y,z,sigma_z\nA1,1,2,3,0.03\n").contains("the column 'sigma_z' without the other standard errors"));
        assert!(message("name,x,y,z,sigma_x,sigma_z\nA1,1,2,3,0.03,0.03\n").contains("'sigma_x' without"));
    }
}
