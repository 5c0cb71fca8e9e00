//! Reading surveyed points: control and check points of a block.

use super::column_names::meanings;
use super::column_units::{Unit, named};
use super::columns::UnreadColumns;
use super::control_columns::{Columns, Layout};
use super::error_columns::ErrorColumns;
use super::hemispheres::Axis;
use super::system_line::SystemLine;
use crate::error::refuse;
use crate::text::{Records, Row, is_none, records, shorten, table};
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

/// Reads lines of `name, x, y, z` with or without the standard errors of place and height behind them, between semicolons, tabs, commas or blanks.
///
/// Numbers may have a decimal comma where commas do not separate, and in quotes. A line that names columns may come before them, below a title and above a line of units, in any order, in capitals or not: name, x, y, z, standard errors of place and height,
/// of image measurements in px, and use (`control`, `check` or `off`, or what other programs write for them), each by one of many names in several languages, with `(m)` behind it or not; a run reports those that it
/// does not read, and refuses coordinates whose name has another unit than their system. Standard errors in another unit are converted to m. A comment directly above rows of numbers is such a line where it names name, x, y and z, as Metashape writes it. Of standard errors of x and y the larger one counts; one without an axis, as `accuracy`, is that of all three. `up` is the height, or its
/// standard error in a table with another height and standard errors of the place alone. Without that line the columns are those, as in Pix4D's files, or have the standard errors of x, y and height behind them; a fifth one of words, or a fifth and last one of whole numbers behind coordinates with a point, is a code and no standard error. Rows all of which begin with a number with decimals and have a height without are refused: they begin with a coordinate. Points without any coordinate, as other programs list those that were not surveyed, are skipped; a dash stands for none, too. Columns of longitude and latitude may have the letters of hemispheres, in the field or in columns of their own, and minutes and seconds. Blank lines and lines that begin with `#` are skipped.
///
/// # Errors
/// [`Error::InvalidInput`], naming the line, for numbers that are none, standard errors that are not above 0, a name that comes twice, and fields that may be parts of numbers with decimal commas.
pub fn parse_ground_control_points(text: &str) -> Result<Vec<GroundControlRow>, Error> {
    let records = records(Input::ControlTable, text)?;
    let Layout { columns, rows, .. } = Layout::of(&records)?;
    let mut names = BTreeSet::new();
    let surveyed = rows.iter().filter(|(_, record)| !columns.lacks_coordinates(record));
    surveyed.map(|(line, record)| read_point(&records, record, &columns, *line, &mut names)).collect()
}

/// The names of the points that have no coordinates.
///
/// # Errors
/// As [`parse_ground_control_points`].
pub(crate) fn points_without_coordinates(text: &str) -> Result<Vec<String>, Error> {
    let records = records(Input::ControlTable, text)?;
    let Layout { columns, rows, .. } = Layout::of(&records)?;
    let without = rows.iter().filter(|(_, record)| columns.lacks_coordinates(record));
    Ok(without.map(|(_, record)| shorten(record.get(columns.name).unwrap_or(""))).collect())
}

/// Columns of the table that are not read. One without a name counts where any of its cells holds something.
///
/// # Errors
/// As [`parse_ground_control_points`].
pub(crate) fn unread_columns(text: &str) -> Result<UnreadColumns, Error> {
    let records = records(Input::ControlTable, text)?;
    let Layout { columns, names, rows } = Layout::of(&records)?;
    let meanings = names.as_ref().map_or_else(Vec::new, meanings);
    let mut read = columns.read();
    // A code behind the coordinates is nobody's mistake; a number may be something else.
    let is_number = |record: &StringRecord| record.get(4).is_some_and(|field| records.number(field).is_some());
    if names.is_none() && columns.standard_errors.is_none() && !rows.iter().any(|(_, record)| is_number(record)) {
        read.insert(4);
    }
    let twin = |column: usize| meanings.get(column).copied().flatten().and_then(|meaning| columns.instead_of(meaning));
    Ok(UnreadColumns::of(rows, names.as_ref(), &read, twin))
}

/// A unit of length that the name of a column of coordinates has.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct StatedUnit {
    /// The name.
    pub column: String,
    /// `m`, `ft`, `us-ft`, `mm`, `cm` or `km`.
    pub unit: &'static str,
    /// Whether it is that of the height.
    pub is_height: bool,
}

impl StatedUnit {
    /// Those that a line of names has for the columns of the plane and of the height.
    pub(super) fn of(head: &StringRecord, plane: [usize; 2], height: Option<usize>) -> Vec<Self> {
        let columns = plane.into_iter().map(|column| (column, false)).chain(height.map(|column| (column, true)));
        let stated = columns.filter_map(|(column, is_height)| {
            let column = head.get(column)?;
            match named(column).1? {
                Unit::Length(unit) => Some(Self { column: shorten(column), unit, is_height }),
                Unit::Degrees => None,
            }
        });
        stated.collect()
    }
}

/// The units of length that columns of coordinates name: the numbers are in them as [`parse_ground_control_points`] reads them.
///
/// # Errors
/// As [`parse_ground_control_points`].
pub(crate) fn stated_units(text: &str) -> Result<Vec<StatedUnit>, Error> {
    let records = records(Input::ControlTable, text)?;
    let Layout { columns, names, .. } = Layout::of(&records)?;
    let [x, y, z] = columns.position;
    Ok(names.map(|names| StatedUnit::of(&names, [x, y], Some(z))).unwrap_or_default())
}

/// The coordinate system that the table names for itself above the names of its columns.
///
/// # Errors
/// As [`parse_ground_control_points`].
pub(crate) fn control_system(text: &str) -> Result<Option<SystemLine>, Error> {
    Ok(SystemLine::of(&records(Input::ControlTable, text)?))
}

/// The columns of standard errors that say no unit.
///
/// # Errors
/// As [`parse_ground_control_points`].
pub(crate) fn error_columns(text: &str) -> Result<ErrorColumns, Error> {
    let records = records(Input::ControlTable, text)?;
    let Layout { columns, names, .. } = Layout::of(&records)?;
    let (across, up) = columns.standard_errors.unzip();
    Ok(ErrorColumns::of(names.as_ref(), across, up))
}

/// The columns without a name that are read as standard errors and may be something else.
///
/// # Errors
/// As [`parse_ground_control_points`].
pub(crate) fn unnamed_errors(text: &str) -> Result<Vec<String>, Error> {
    let (points, columns) = (parse_ground_control_points(text)?, error_columns(text)?);
    let records = records(Input::ControlTable, text)?;
    let Layout { names, .. } = Layout::of(&records)?;
    Ok(columns.unnamed(names.as_ref(), points.iter().filter_map(|point| Some(point.standard_errors?.map(Some)))))
}

fn read_point(
    records: &Records,
    record: &StringRecord,
    columns: &Columns,
    line: usize,
    names: &mut BTreeSet<String>,
) -> Result<GroundControlRow, Error> {
    let field = |column: usize| record.get(column).unwrap_or("");
    let number = |column: usize, what: &str| {
        let value = records.number(field(column));
        let refusal = || Refusal::ControlNumber { word: shorten(field(column)), column: what.into(), line }.into_error();
        value.ok_or_else(|| records.refused_thousands(field(column), what, line).unwrap_or_else(refusal))
    };
    let name = field(columns.name).to_string();
    if name.is_empty() || name.chars().any(char::is_control) || !names.insert(name.clone()) {
        return refuse(Refusal::ControlName { name: shorten(&name), line });
    }
    let [x, y, z] = columns.position;
    let coordinate = |axis: Axis, column: usize, what: &str| {
        let value = match axis.read(field(column), |text| records.number(text)) {
            Some(value) if columns.is_geographic => value,
            _ => number(column, what)?,
        };
        let Some(side) = columns.sides[axis as usize].map(field) else { return Ok(value) };
        let refusal = || Refusal::ControlNumber { word: shorten(&format!("{} {side}", field(column))), column: what.into(), line };
        axis.on_side(value, side).ok_or_else(|| refusal().into_error())
    };
    let position = [coordinate(Axis::Longitude, x, "x")?, coordinate(Axis::Latitude, y, "y")?, number(z, "z")?];
    let given = columns.standard_errors.filter(|([x, y], z)| [x, y, z].iter().any(|column| !is_none(field(**column))));
    let standard_errors = match given {
        Some(([x, y], z)) => {
            let [unit_x, unit_y, unit_z] = columns.error_units_m;
            let across = (unit_x * number(x, "sigma_xy")?).max(unit_y * number(y, "sigma_xy")?);
            Some([across, unit_z * number(z, "sigma_z")?])
        }
        None => None,
    };
    if let Some(errors) = standard_errors.filter(|errors| !errors.iter().all(|error| *error > 0.0)) {
        return refuse(Refusal::ControlErrors { errors: format!("{errors:?}"), line });
    }
    let role = columns.uses.read(record, line)?;
    let sigma_px = columns.sigma_px.filter(|column| !is_none(field(*column))).map(|column| number(column, "sigma_px")).transpose()?;
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
        assert!(message("A,1,2\n").contains("neither a column 'name' (or label, point, pointname,"));
        assert!(message("A,1,2,3\nB,1,x,3\n").contains("'x' for y in line 2"));
        assert!(message("A,1,2,3\nB,1,2,inf\n").contains("'inf' for z in line 2"));
        assert!(message("A,1,2,3\nA,1,2,3\n").contains("the name 'A' in line 2"));
        assert!(message("A,1,2,3,0,1\n").contains("not above 0"));
        let lone = message("A,1,2,3,0.1\n");
        assert!(lone.contains("got one number, '0.1', behind the coordinates in line 1") && lone.contains("a line that names"), "{lone}");
        assert!(message("name,x,y,z\n,1,2,3\n").contains("the name ''"));
    }

    #[test]
    fn columns_are_known_by_many_names_and_others_are_told() {
        let read = |text: &str| parse_ground_control_points(text).unwrap()[0].standard_errors;
        assert_eq!(read("point_id,easting,northing,elevation,std_x,std_y,std_z\nA1,1,2,3,0.02,0.05,0.03\n"), Some([0.05, 0.03]));
        assert_eq!(read("GCP;E;N;H;rms_xy;rms_z\nA1;1;2;3;0.02;0.03\n"), Some([0.02, 0.03]));
        assert_eq!(
            read("Name,X (m),Y (m),Z (m),Sigma X [m],std-dev y,vertical accuracy (m)\nA1,1,2,3,0.02,0.05,0.03\n"),
            Some([0.05, 0.03])
        );
        for bare in ["accuracy", "Std", "rms", "sigma_m", "Accuracy (m)"] {
            assert_eq!(read(&format!("name,x,y,z,{bare}\nA1,1,2,3,0.04\n")), Some([0.04, 0.04]), "{bare}");
        }
        assert_eq!(read("name,x,y,z,accuracy,sigma_z\nA1,1,2,3,0.04,0.07\n"), Some([0.04, 0.07]));
        assert_eq!(read("name,x,y,z,rms_e,rms_n,rms_z\nA1,1,2,3,0.02,0.05,0.03\n"), Some([0.05, 0.03]));
        assert_eq!(read("name,x,y,z,rmse\nA1,1,2,3,0.02\n"), Some([0.02, 0.02]));
        // `h` may be either, and residuals are no standard errors.
        for unknown in ["sigma_h", "X_error", "error"] {
            assert_eq!(unread_columns(&format!("name,x,y,z,{unknown}\nA1,1,2,3,0.4\n")).unwrap().unknown, [unknown]);
        }
        let unread = unread_columns("name,x,y,z,code,sigma_xy,sigma_z,Kommentar,,\nA1,1,2,3,tp,0.02,0.03,,,5\n").unwrap();
        assert_eq!(unread, UnreadColumns { unknown: ["code", "Kommentar", "#10"].map(String::from).into(), doubled: Vec::new() });
        assert_eq!(unread_columns("A1,1,2,3,0.02,0.03,more\n").unwrap().unknown, ["#7"]);
        assert_eq!(unread_columns("A1,1,2,3\nA2,1,2,3,0.02,0.03\n").unwrap(), UnreadColumns::default());
        assert_eq!(unread_columns("").unwrap(), UnreadColumns::default());
        assert!(message("name,x,y,z,sigma_z\nA1,1,2,3,0.03\n").contains("the column 'sigma_z' without the other standard errors"));
        assert!(message("name,x,y,z,sigma_x,sigma_z\nA1,1,2,3,0.03,0.03\n").contains("'sigma_x' without"));
    }

    #[test]
    fn decimal_commas_are_read_between_semicolons_and_tabs() {
        let wanted = parse_ground_control_points("GCP 1,428217.609,5539031.141,100.363,0.02,0.03\n").unwrap();
        for text in [
            "GCP 1;428217,609;5539031,141;100,363;0,02;0,03\n",
            "GCP 1\t428217,609\t5539031,141\t100,363\t0,02\t0,03\n",
            "Punktnummer;Hochwert;Rechtswert;Höhe;std_x;std_y;std_z\nGCP 1;5539031,141;428217,609;100,363;0,02;0,01;0,03\n",
        ] {
            assert_eq!(parse_ground_control_points(text).unwrap(), wanted, "{text}");
        }
        let refused = message("GCP 1;428,217,609;5,539,031,141;100,363\n");
        assert!(refused.contains("'GCP 1;428,217,609;5,539,031,141;100,363'"), "{refused}");
    }

    #[test]
    fn names_of_surveyors_are_known_and_a_name_that_is_not_meets_those_that_are() {
        for head in [
            "Point No.,E,N,H",
            "Name,Easting,Northing,Ellipsoidal height",
            "Pt ID,Eastings,Northings,Elev.",
            "NR,OST,NORD,HÖHE",
            "Punkt,Rechts,Hoch,Hoehe",
            "id,Longitude [deg],Latitude (°),Altitude",
        ] {
            let text = format!("{head}\nA1,1,2,3\n");
            let read = parse_ground_control_points(&text).unwrap();
            assert_eq!((read[0].name.as_str(), read[0].position), ("A1", [1.0, 2.0, 3.0]), "{head}");
            assert_eq!(stated_units(&text).unwrap(), [], "{head}");
        }
        // Of two heights that above the geoid is read, which is the second one of many receivers.
        assert_eq!(parse_ground_control_points("name,e,n,ellipsoidal height,elevation\nA1,1,2,9.5,3\n").unwrap()[0].position[2], 3.0);
        let refused = message("Number,Abszisse,Ordinate,Z\nA1,1,2,3\n");
        assert!(
            refused.contains("neither a column 'x' (or e, east, easting, longitude, lon, rechtswert, ost, xeasting, long")
                && refused.contains("'Number,Abszisse,Ordinate,Z'"),
            "{refused}"
        );
    }

    #[test]
    fn a_unit_in_a_name_is_stated_and_not_taken_for_metres() {
        let feet = "name,Easting (ft),Northing [US ft],Ellipsoidal height [m]\nA1,1,2,3\n";
        let unit = |column: &str, unit, is_height| StatedUnit { column: column.into(), unit, is_height };
        let stated = [("Easting (ft)", "ft"), ("Northing [US ft]", "us-ft")].map(|(column, name)| unit(column, name, false)).to_vec();
        assert_eq!(stated_units(feet).unwrap(), [stated, vec![unit("Ellipsoidal height [m]", "m", true)]].concat());
        assert_eq!(parse_ground_control_points(feet).unwrap()[0].position, [1.0, 2.0, 3.0]);
        assert_eq!(stated_units("name,x,y,z_cm\nA1,1,2,3\n").unwrap(), [unit("z_cm", "cm", true)]);
        assert!(message("name,x,y,z (deg)\nA1,1,2,3\n").contains("neither a column 'z'"));
    }

    #[test]
    fn a_code_behind_the_coordinates_is_no_standard_error() {
        let coded = "GCP 1,5539031.141,428217.609,100.363,TARGET\nGCP 2,5539031.141,428217.609,100.363,\n";
        assert_eq!(parse_ground_control_points(coded).unwrap().iter().map(|point| point.standard_errors).collect::<Vec<_>>(), [None; 2]);
        assert_eq!(unread_columns(coded).unwrap(), UnreadColumns::default());
        for codes in [["GCP1", "GCP2"], ["101", "102"], ["101", "TP 7"], ["", "GCP2"]] {
            let text: String = codes.iter().enumerate().map(|(k, code)| format!("{k},5594521.7,446833.2,124.0,{code}\n")).collect();
            let points = parse_ground_control_points(&text).unwrap_or_else(|error| panic!("{text}: {error}"));
            assert!(points.iter().all(|point| point.standard_errors.is_none() && point.position[2] == 124.0), "{text}");
            let is_number = codes[0] == "101";
            assert_eq!(
                unread_columns(&text).unwrap().unknown,
                is_number.then(|| "#5".to_string()).into_iter().collect::<Vec<_>>(),
                "{text}"
            );
        }
        for code in ["0", "5"] {
            let coded = format!("1,5594521.7,446833.2,124.0,{code}\n");
            assert_eq!(parse_ground_control_points(&coded).unwrap()[0].standard_errors, None, "{code}");
            assert_eq!(unread_columns(&coded).unwrap().unknown, ["#5"]);
        }
        let noted = "1,5594521.7,446833.2,124.0,TP,note\n2,5594521.7,446833.2,124.0,,\n";
        assert_eq!(parse_ground_control_points(noted).unwrap()[0].standard_errors, None);
        assert_eq!(unread_columns(noted).unwrap().unknown, ["#6"]);
        // Whole coordinates may be cut, and a small number may be a standard error.
        for lone in ["101,1040,5,2040,116\n", "1,5594521.7,446833.2,124.0,0.02\n", "A,1.5,2,3,0.02,0.03\nB,1,2,3,0.02\n"] {
            assert!(message(lone).contains("got one number, '"), "{lone}: {}", message(lone));
        }
        // A slip is none.
        assert!(message("A,1,2,3,0.O2,0.03\n").contains("'0.O2' for sigma_xy in line 1"));
        assert!(message("A,1,2,3,x,0.03\nB,1,2,3,0.02,0.03\n").contains("'x' for sigma_xy in line 1"));
    }

    #[test]
    fn up_is_the_height_or_its_standard_error_and_a_second_height_is_reported() {
        let read = |text: &str| parse_ground_control_points(text).unwrap().remove(0);
        let errors = read("name,x,y,z,across,up\nA1,1,2,3,0.02,0.03\n");
        assert_eq!((errors.position, errors.standard_errors), ([1.0, 2.0, 3.0], Some([0.02, 0.03])));
        assert_eq!(unread_columns("name,x,y,z,across,up\nA1,1,2,3,0.02,0.03\n").unwrap(), UnreadColumns::default());
        assert_eq!(read("name,east,north,up\nA1,1,2,3\n").position, [1.0, 2.0, 3.0]);
        let both = "id,up,x,y,z,name,sx,sigma_xy,sigma_z\n7,9,1,2,3,A1,1,0.02,0.03\n";
        let point = read(both);
        assert_eq!((point.name.as_str(), point.position, point.standard_errors), ("A1", [1.0, 2.0, 3.0], Some([0.02, 0.03])));
        let unread = unread_columns(both).unwrap();
        assert_eq!(unread.doubled, ["id (name)", "up (z)", "sx (sigma_xy)"]);
        assert!(unread.unknown.is_empty());
    }
}
