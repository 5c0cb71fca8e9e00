//! Reading surveyed points: control and check points of a block.

use crate::text::{records, shorten};
use crate::{ControlRole, Error};
use csv::StringRecord;
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;

const WHAT: &str = "the table of control points";

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
}

fn control() -> Option<ControlRole> {
    Some(ControlRole::Control)
}

/// Reads lines of `name, x, y, z` with or without the standard errors of place and height behind them, between commas, semicolons or tabs.
///
/// A first line that names columns may come before them: `name` or `label`, `x`, `y`, `z`, `sigma_xy`, `sigma_z` (or `accH`,
/// `accV`), and `use` (`control`, `check` or `off`), in any order, among others, in capitals or not. Without it the columns are those, as in Pix4D's files. Blank lines and lines that begin with `#` are skipped.
///
/// # Errors
/// [`Error::InvalidInput`], naming the line, for numbers that are none, standard errors that are not above 0, and a name that comes twice.
pub fn parse_ground_control_points(text: &str) -> Result<Vec<GroundControlRow>, Error> {
    let (mut points, mut names, mut columns) = (Vec::new(), BTreeSet::new(), None);
    for (line, record) in records(WHAT, text)? {
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

/// The columns of a table: of the name, of x, y, z, and of both standard errors.
#[derive(Debug, Clone, Copy)]
struct Columns {
    name: usize,
    position: [usize; 3],
    standard_errors: Option<[usize; 2]>,
    role: Option<usize>,
}

impl Default for Columns {
    fn default() -> Self {
        Self { name: 0, position: [1, 2, 3], standard_errors: Some([4, 5]), role: None }
    }
}

impl Columns {
    /// The columns that a line names; none where it has a point.
    fn of(record: &StringRecord) -> Result<Option<Self>, Error> {
        if (1..4).all(|column| record.get(column).is_some_and(|field| field.parse::<f64>().is_ok())) {
            return Ok(None);
        }
        let place = |name: &str| record.iter().position(|field| field.eq_ignore_ascii_case(name));
        let needed = |name: &str| {
            let names = record.iter().collect::<Vec<_>>().join(",");
            place(name).ok_or_else(|| refused(format!("neither a column '{name}' nor a point in the first line '{}'", shorten(&names))))
        };
        let errors = |[xy, z]: [&str; 2]| place(xy).zip(place(z)).map(|(xy, z)| [xy, z]);
        let standard_errors = errors(["sigma_xy", "sigma_z"]).or_else(|| errors(["accH", "accV"]));
        let name = place("label").map_or_else(|| needed("name"), Ok)?;
        Ok(Some(Self { name, position: [needed("x")?, needed("y")?, needed("z")?], standard_errors, role: place("use") }))
    }
}

fn read_point(record: &StringRecord, columns: &Columns, line: usize, names: &mut BTreeSet<String>) -> Result<GroundControlRow, Error> {
    let field = |column: usize| record.get(column).unwrap_or("");
    let number = |column: usize, what: &str| {
        let value = field(column).parse().ok().filter(|value: &f64| value.is_finite());
        value.ok_or_else(|| refused(format!("'{}' for {what} in line {line}", shorten(field(column)))))
    };
    let name = field(columns.name).to_string();
    if name.is_empty() || name.chars().any(char::is_control) || !names.insert(name.clone()) {
        return Err(refused(format!("the name '{}' in line {line}, which is empty or comes twice", shorten(&name))));
    }
    let [x, y, z] = columns.position;
    let position = [number(x, "x")?, number(y, "y")?, number(z, "z")?];
    let given = columns.standard_errors.filter(|places| places.iter().any(|column| !field(*column).is_empty()));
    let standard_errors = match given {
        Some([xy, z]) => Some([number(xy, "sigma_xy")?, number(z, "sigma_z")?]),
        None => None,
    };
    if let Some(errors) = standard_errors.filter(|errors| !errors.iter().all(|error| *error > 0.0)) {
        return Err(refused(format!("standard errors {errors:?} in line {line}, which are not above 0")));
    }
    let role = match columns.role.map(field).unwrap_or("").to_ascii_lowercase().as_str() {
        "" | "control" => Some(ControlRole::Control),
        "check" => Some(ControlRole::Check),
        "off" => None,
        other => return Err(refused(format!("'{}' as use in line {line}; it is control, check or off", shorten(other)))),
    };
    Ok(GroundControlRow { name, position, standard_errors, role })
}

fn refused(got: String) -> Error {
    Error::InvalidInput {
        what: WHAT,
        got,
        allowed: "lines of name, x, y, z and perhaps both standard errors, of place and of height".into(),
    }
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
}
