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
/// of image measurements in px, and use (`control`, `check` or `off`), each by one of many names, with `(m)` behind it or not; a run reports those that it
/// does not read. Of standard errors of x and y the larger one counts; one without an axis, as `accuracy`, is that of all three. `up` is the height, or its
/// standard error in a table with another height and standard errors of the place alone. Without that line the columns are those, as in Pix4D's files. Blank lines and lines that begin with `#` are skipped.
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

/// The columns of a table of control points that are not read.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct UnreadColumns {
    /// Those that say nothing here: by their names, or `#7` for the seventh where it has none.
    pub unknown: Vec<String>,
    /// Those that give what another column gives, each with the one that is read: `up (z)`.
    pub doubled: Vec<String>,
}

/// Columns of the table that are not read. One without a name counts where any of its cells holds something.
///
/// # Errors
/// As [`parse_ground_control_points`].
pub(crate) fn unread_columns(text: &str) -> Result<UnreadColumns, Error> {
    let records = records(Input::ControlTable, text)?;
    let Some((_, first)) = records.first() else { return Ok(UnreadColumns::default()) };
    let found = Columns::of(first)?;
    let is_named = found.is_some();
    let meanings = if is_named { meanings(first) } else { Vec::new() };
    let columns = found.unwrap_or_default();
    let read = columns.read();
    let width = records.iter().map(|(_, record)| record.len()).max().unwrap_or(0);
    let mut unread = UnreadColumns::default();
    for column in (0..width).filter(|column| !read.contains(column)) {
        let name = first.get(column).filter(|name| is_named && !name.is_empty());
        let is_empty = || records.iter().all(|(_, record)| record.get(column).unwrap_or("").is_empty());
        let twin = meanings.get(column).copied().flatten().and_then(|meaning| columns.instead_of(meaning));
        match (name, twin.and_then(|twin| first.get(twin))) {
            (Some(name), Some(twin)) => unread.doubled.push(format!("{} ({})", shorten(name), shorten(twin))),
            (Some(name), None) => unread.unknown.push(shorten(name)),
            (None, _) if !is_empty() => unread.unknown.push(format!("#{}", column + 1)),
            (None, _) => {}
        }
    }
    Ok(unread)
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
    /// Of all three coordinates.
    ErrorAll,
    ErrorPx,
    Use,
}

/// The names of columns in tables of control points, here and in other programs, as [`plain`] writes them. The first of them that a table has is read.
const NAMES: [(Column, &[&str]); 7] = [
    (Column::Name, &["name", "label", "point", "pointname", "id", "pointid", "gcp", "gcpname", "gcpid", "number", "pointnumber", "nr"]),
    (Column::X, &["x", "e", "east", "easting", "xeasting", "longitude", "lon", "long", "xlongitude"]),
    (Column::Y, &["y", "n", "north", "northing", "ynorthing", "latitude", "lat", "ylatitude"]),
    (Column::Z, &["z", "h", "height", "elevation", "altitude", "alt", "zaltitude", "up"]),
    (Column::ErrorAcross, &["across", "acch"]),
    (Column::ErrorUp, &["accv", "uperror"]),
    (Column::Use, &["use", "role"]),
];

/// The words for a standard error, bare or with an axis before or behind them. `error` is none: other programs call residuals that.
const ERRORS: [&str; 12] =
    ["sigma", "accuracy", "acc", "std", "stddev", "stdev", "sd", "rms", "rmse", "precision", "standarderror", "standarddeviation"];

/// The axes of standard errors. `h` is none: it is height in one program, horizontal in the next.
const AXES: [(Column, &[&str]); 5] = [
    (Column::ErrorAcross, &["xy", "horizontal", "across", "en"]),
    (Column::ErrorX, &["x", "e", "east", "easting"]),
    (Column::ErrorY, &["y", "n", "north", "northing"]),
    (Column::ErrorUp, &["z", "vertical", "up", "height", "altitude", "elevation"]),
    (Column::ErrorPx, &["px", "image"]),
];

/// A name in small letters, without a unit of metres behind it.
fn without_unit(name: &str) -> String {
    let small = name.trim().to_lowercase();
    let short = ["(m)", "[m]", "_m", " m"].iter().find_map(|unit| small.strip_suffix(unit));
    short.map_or(small.clone(), |short| short.trim_end().to_string())
}

/// A name of letters alone: programs join its words in many ways.
fn plain(name: &str) -> String {
    without_unit(name).chars().filter(|letter| !matches!(letter, '_' | '-' | ' ' | '.' | '/')).collect()
}

/// What a name says, and how early it stands among the names for that; `None` where it says nothing here.
fn meaning_of(name: &str) -> Option<(Column, usize)> {
    let (joined, plain) = (without_unit(name), plain(name));
    // `rmse` is bare, `rms_e` is of the east.
    let bare = ERRORS.iter().position(|word| *word == joined).map(|rank| (Column::ErrorAll, rank));
    let listed = NAMES.iter().find_map(|(column, names)| Some((*column, names.iter().position(|known| *known == plain)?)));
    let short = [("sx", Column::ErrorX), ("sy", Column::ErrorY), ("sz", Column::ErrorUp)].into_iter();
    let short = short.filter(|(name, _)| *name == plain).map(|(_, column)| (column, ERRORS.len())).next();
    listed.or(short).or(bare).or_else(|| {
        ERRORS.iter().enumerate().find_map(|(rank, word)| {
            let axis = plain.strip_prefix(word).or_else(|| plain.strip_suffix(word))?;
            let axes = AXES.iter().find(|(_, axes)| axes.contains(&axis)).map(|(column, _)| *column);
            let column = if axis.is_empty() { Some(Column::ErrorAll) } else { axes };
            column.map(|column| (column, rank))
        })
    })
}

/// What each column of a line of names holds. `up` beside another height, where errors of the place but none of the height are named, is that error.
fn meanings(record: &StringRecord) -> Vec<Option<Column>> {
    let mut found: Vec<Option<Column>> = record.iter().map(|name| meaning_of(name).map(|(column, _)| column)).collect();
    let is_up = |column: &usize| record.get(*column).is_some_and(|name| plain(name) == "up");
    let has_height = (0..found.len()).any(|column| found[column] == Some(Column::Z) && !is_up(&column));
    let lacks_error = found.contains(&Some(Column::ErrorAcross)) && !found.contains(&Some(Column::ErrorUp));
    if has_height && lacks_error {
        (0..found.len()).filter(is_up).for_each(|column| found[column] = Some(Column::ErrorUp));
    }
    found
}

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
        let meanings = meanings(record);
        let rank = |column: usize| record.get(column).and_then(meaning_of).map_or(usize::MAX, |(_, rank)| rank);
        let place =
            |wanted: Column| (0..meanings.len()).filter(|k| meanings[*k] == Some(wanted)).min_by_key(|column| (rank(*column), *column));
        let needed = |column: Column, name: &str| {
            let names = record.iter().collect::<Vec<_>>().join(",");
            place(column).ok_or_else(|| Refusal::ControlColumn { column: name.into(), names: shorten(&names) }.into_error())
        };
        let apart = place(Column::ErrorX).zip(place(Column::ErrorY)).map(|(x, y)| [x, y]);
        let of_all = place(Column::ErrorAll);
        let across = place(Column::ErrorAcross).map(|column| [column; 2]).or(apart).or(of_all.map(|column| [column; 2]));
        let standard_errors = across.zip(place(Column::ErrorUp).or(of_all));
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

    /// The columns that are read.
    fn read(&self) -> BTreeSet<usize> {
        let errors = self.standard_errors.into_iter().flat_map(|([x, y], z)| [x, y, z]);
        self.position.into_iter().chain([self.name]).chain(errors).chain(self.role).chain(self.sigma_px).collect()
    }

    /// The column that is read where another one holds this too.
    fn instead_of(&self, meaning: Column) -> Option<usize> {
        match meaning {
            Column::Name => Some(self.name),
            Column::X => Some(self.position[0]),
            Column::Y => Some(self.position[1]),
            Column::Z => Some(self.position[2]),
            Column::ErrorAcross | Column::ErrorX | Column::ErrorAll => self.standard_errors.map(|([x, _], _)| x),
            Column::ErrorY => self.standard_errors.map(|([_, y], _)| y),
            Column::ErrorUp => self.standard_errors.map(|(_, z)| z),
            Column::ErrorPx => self.sigma_px,
            Column::Use => self.role,
        }
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
        // Millimetres are not metres, `h` may be either, and residuals are no standard errors.
        for unknown in ["sigma_x (mm)", "sigma_h", "X_error", "error"] {
            assert_eq!(unread_columns(&format!("name,x,y,z,{unknown}\nA1,1,2,3,4\n")).unwrap().unknown, [unknown]);
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
