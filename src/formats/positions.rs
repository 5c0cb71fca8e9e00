//! Reading where images were taken: the GNSS positions of a block from a table.

use super::column_names::Coordinates;
use super::column_units::units;
use super::columns::UnreadColumns;
use super::control::StatedUnit;
use super::error_columns::ErrorColumns;
use super::hemispheres::Axis;
use super::position_columns::{PositionColumns, is_on_earth};
use super::system_line::SystemLine;
use super::whole_numbers::has_leading_zero;
use crate::error::refuse;
use crate::text::{Headed, NumberedRecord, Records, is_none, records, shorten};
use crate::{Error, Input, Refusal};
use csv::StringRecord;
use serde::{Deserialize, Serialize};

/// The positions of images that a table has.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ImagePositions {
    /// Whether places are longitude and latitude of WGS 84 in degrees, with heights above the ellipsoid; else they are x and y of a coordinate reference system.
    pub is_geographic: bool,
    pub rows: Vec<ImagePositionRow>,
}

/// The position of an image as a table has it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ImagePositionRow {
    /// The image as the table names it: its file name, perhaps with a folder or without its ending.
    pub image: String,
    /// Longitude and latitude in degrees, or x and y in the unit of the coordinate reference system.
    pub place: [f64; 2],
    /// Absent where the table has none.
    pub height: Option<f64>,
    /// Standard errors of the place and of the height in m, above 0; each is absent where the table has none.
    pub standard_errors: [Option<f64>; 2],
    /// The line of the table, counted from 1.
    pub line: usize,
}

/// Reads lines of image, longitude, latitude and height, or image, x, y and height, between commas, semicolons or tabs; between the latter two numbers may
/// have a decimal comma.
///
/// A first line that names columns may come before them, in any order, among others, in capitals or not, also behind a `#`: image, longitude and latitude or x
/// and y, height and standard errors of the place and of the height in m, each by one of many names, English or German. Longitudes and latitudes are read
/// where there are x and y beside them, with the height above the ellipsoid where there are two. What a run does not read it reports.
///
/// Longitudes and latitudes may have the letters of their hemispheres, in the field or in a column of their own (`GPSLatitudeRef`), and minutes and seconds, as
/// ExifTool writes them; heights above sea level and below it likewise. (0, 0), which receivers without a fix write, is no position.
///
/// Places under names that leave it open (`x`, `X/Longitude`) are longitudes and latitudes where all of them can be. Without names the columns are image, x,
/// y, height; of six columns the last two, and of nine, behind three angles, the last two are standard errors, where all of a column are above 0 and below
/// 1 m, or one number up to 50 m; below a line with a coordinate system six have two angles. Degrees without names are longitude and
/// latitude in whatever order, where one of the two is beyond 90° somewhere. Rows without any coordinate, which a dash may stand for, are skipped, as are blank lines and
/// lines that begin with `#`.
///
/// # Errors
/// [`Error::InvalidInput`] for a table without any position; naming the line, for numbers that are none, hemispheres that are none or contradict a sign, commas
/// that may be decimal ones, images without a name, standard errors that are not above 0, and longitudes and
/// latitudes that cannot be; for degrees without names whose order nothing tells.
///
/// # Source
/// The tables of image positions of Metashape, Pix4D and Emlid, and of EXIF as ExifTool writes it.
pub fn parse_image_positions(text: &str) -> Result<ImagePositions, Error> {
    Table::read(text)?.positions().map(|(positions, _)| positions)
}

/// What a table of image positions says beside them.
#[derive(Debug, Clone, Default)]
pub(crate) struct PositionHead {
    /// Columns that are not read.
    pub unread: UnreadColumns,
    /// Units that columns of coordinates have in their names.
    pub stated_units: Vec<StatedUnit>,
    /// Columns of standard errors that say no unit.
    pub error_columns: ErrorColumns,
    /// Columns without a name that are read as standard errors and may be something else.
    pub unnamed_errors: Vec<String>,
    /// A column of heights that is not understood, and how many positions have none for it.
    pub unread_height: Option<(String, usize)>,
    /// Images at longitude 0 and latitude 0, as the table names them.
    pub nowhere: Vec<String>,
    /// The coordinate system that the table names for itself.
    pub system: Option<SystemLine>,
}

/// What the table says beside its positions.
///
/// # Errors
/// As [`parse_image_positions`].
pub(crate) fn position_head(text: &str) -> Result<PositionHead, Error> {
    let table = Table::read(text)?;
    let (head, columns) = (table.head.as_ref(), &table.columns);
    let stated_units = head.map(|head| columns.stated_units(head)).unwrap_or_default();
    let (positions, nowhere) = table.positions()?;
    let of_side = columns.sides[Axis::Height as usize].and_then(|side| head?.get(side)).map(shorten);
    let unsided = table.rows().iter().filter(|(_, record)| table.has_unknown_side(record)).count();
    let unread_height = match head.and_then(|head| columns.unread_height(head)) {
        Some(column) => Some((column, positions.rows.len())),
        None => of_side.map(|column| (column, unsided)).filter(|(_, unsided)| *unsided > 0),
    };
    let (unread, error_columns) = (columns.unread(table.rows(), head), columns.error_columns(head));
    let unnamed_errors = error_columns.unnamed(head, positions.rows.iter().map(|row| row.standard_errors));
    Ok(PositionHead { unread, stated_units, error_columns, unnamed_errors, unread_height, nowhere, system: table.system.clone() })
}

struct Table {
    records: Records,
    /// The line of names, where there is one.
    head: Option<StringRecord>,
    /// Of the records so many, the first, are no rows: titles, names, and their units.
    above: usize,
    columns: PositionColumns,
    /// The coordinate system that it names for itself.
    system: Option<SystemLine>,
}

impl Table {
    fn read(text: &str) -> Result<Self, Error> {
        let mut records = records(Input::PositionTable, text)?;
        let system = SystemLine::of(&records);
        if system.is_some() {
            records.rows.remove(0);
        }
        let Headed { names, rows, misplaced } = records.headed(PositionColumns::needed, &units())?;
        let above = records.rows.len() - rows.len();
        let is_number = |field: Option<&str>| field.is_some_and(|field| records.number(field).is_some());
        let is_given = |record: &StringRecord| (1..4).any(|column| record.get(column).is_some_and(|field| !is_none(field)));
        let first = || rows.iter().map(|(_, record)| record).find(|record| is_given(record));
        let is_in_order = || first().is_none_or(|first| [1, 2].iter().all(|column| is_number(first.get(*column))));
        if names.is_none() && misplaced.is_none() && is_in_order() {
            check_in_order(&records)?;
            // Places in a system that is named have east first, also in degrees.
            let coordinates = system.as_ref().map(|_| Coordinates::Either);
            let columns = PositionColumns::in_order(&records, coordinates);
            columns.numbers(0).check_thousands(&records, rows)?;
            return Ok(Self { columns, records, head: None, above, system });
        }
        let shown = names.or(misplaced).or_else(|| records.likely_head(PositionColumns::needed).cloned()).unwrap_or_default();
        let columns = PositionColumns::named_by(&records, &shown, rows)?;
        let numbers = columns.numbers(shown.len());
        numbers.check_thousands(&records, rows)?;
        numbers.check(&records, rows)?;
        Ok(Self { columns, records, head: Some(shown), above, system })
    }

    fn rows(&self) -> &[NumberedRecord] {
        &self.records.rows[self.above..]
    }

    /// The positions, and the images at longitude 0 and latitude 0.
    fn positions(&self) -> Result<(ImagePositions, Vec<String>), Error> {
        let read =
            self.rows().iter().map(|(line, record)| self.row(*line, record)).collect::<Result<Vec<Option<ImagePositionRow>>, Error>>()?;
        let mut rows: Vec<ImagePositionRow> = read.into_iter().flatten().collect();
        if rows.is_empty() {
            return refuse(Refusal::NoPositions { rows: self.rows().len() });
        }
        let is_geographic = match self.columns.coordinates {
            Some(Coordinates::Geographic) => true,
            Some(Coordinates::Plane) => false,
            Some(Coordinates::Either) => rows.iter().all(|row| is_on_earth(row.place)),
            None => in_order_of_degrees(&mut rows)?,
        };
        if let Some(row) = rows.iter().find(|row| is_geographic && !is_on_earth(row.place)) {
            let [longitude_deg, latitude_deg] = row.place;
            return refuse(Refusal::PositionDegrees { longitude_deg, latitude_deg, line: row.line });
        }
        let (nowhere, rows) = rows.into_iter().partition::<Vec<_>, _>(|row| is_geographic && row.place == [0.0; 2]);
        Ok((ImagePositions { is_geographic, rows }, nowhere.into_iter().map(|row| row.image).collect()))
    }

    /// Whether the side of sea level is not known on which the height of a row is.
    fn has_unknown_side(&self, record: &StringRecord) -> bool {
        let side = self.columns.sides[Axis::Height as usize].and_then(|side| record.get(side)).filter(|word| !word.is_empty());
        side.is_some_and(|word| Axis::Height.is_negative(word).is_none())
    }

    fn row(&self, line: usize, record: &StringRecord) -> Result<Option<ImagePositionRow>, Error> {
        let columns = &self.columns;
        let field = |column: usize| record.get(column).unwrap_or("");
        let name = |column: usize| self.head.as_ref().and_then(|head| head.get(column)).map_or_else(|| format!("#{}", column + 1), shorten);
        let plain = |field: &str| self.records.number(field);
        let refused = |column: usize| {
            let refusal = || Refusal::PositionNumber { word: shorten(field(column)), column: name(column), line }.into_error();
            self.records.refused_thousands(field(column), &name(column), line).unwrap_or_else(refusal)
        };
        let number = |column: usize| plain(field(column)).ok_or_else(|| refused(column));
        let is_of_degrees = columns.coordinates.is_some_and(|coordinates| coordinates != Coordinates::Plane);
        let coordinate = |axis: Axis, column: usize| {
            let value = if is_of_degrees { axis.read(field(column), plain) } else { plain(field(column)) };
            let value = value.ok_or_else(|| refused(column))?;
            let Some(side) = columns.sides[axis as usize].filter(|side| axis != Axis::Height || !field(*side).is_empty()) else {
                return Ok(value);
            };
            let refusal = || Refusal::PositionSide { word: shorten(field(side)), column: name(side), value: shorten(field(column)), line };
            axis.on_side(value, field(side)).ok_or_else(|| refusal().into_error())
        };
        let given = |column: Option<usize>| column.filter(|column| !is_none(field(*column))).map(number).transpose();
        let image = field(columns.image).to_string();
        if image.is_empty() || image.chars().any(char::is_control) {
            return refuse(Refusal::PositionName { name: shorten(&image), line });
        }
        if columns.place.into_iter().chain(columns.height).all(|column| is_none(field(column))) {
            return Ok(None);
        }
        let place = [coordinate(Axis::Longitude, columns.place[0])?, coordinate(Axis::Latitude, columns.place[1])?];
        let [unit_x, unit_y, unit_up] = columns.error_units_m;
        let across = match columns.across {
            Some([x, y]) => {
                [given(Some(x))?.map(|x| unit_x * x), given(Some(y))?.map(|y| unit_y * y)].into_iter().flatten().reduce(f64::max)
            }
            None => None,
        };
        let standard_errors = [across, given(columns.up)?.map(|up| unit_up * up)];
        if let Some(error) = standard_errors.into_iter().flatten().find(|error| !(*error > 0.0)) {
            return refuse(Refusal::PositionErrors { errors: error.to_string(), line });
        }
        let height = columns.height.filter(|column| !is_none(field(*column)) && !self.has_unknown_side(record));
        let height = height.map(|column| coordinate(Axis::Height, column)).transpose()?;
        Ok(Some(ImagePositionRow { image, place, height, standard_errors, line }))
    }
}

/// Whether rows without names of columns are degrees, which are then longitude and latitude.
fn in_order_of_degrees(rows: &mut [ImagePositionRow]) -> Result<bool, Error> {
    let Some(first) = rows.first() else { return Ok(false) };
    let (place, line) = (first.place, first.line);
    let is_longitude_first = rows.iter().all(|row| is_on_earth(row.place));
    let is_latitude_first = rows.iter().all(|row| is_on_earth(exchanged(row.place)));
    match (is_longitude_first, is_latitude_first) {
        (true, true) => refuse(Refusal::PositionOrder { x: place[0], y: place[1], line }),
        (false, true) => {
            rows.iter_mut().for_each(|row| row.place = exchanged(row.place));
            Ok(true)
        }
        (is_geographic, false) => Ok(is_geographic),
    }
}

fn exchanged([x, y]: [f64; 2]) -> [f64; 2] {
    [y, x]
}

/// More numbers than these have decimal points: rows without names have a place, a height, and perhaps what is behind it.
const WHOLE_NUMBERS: usize = 3;

/// Refuses rows without names whose commas may be decimal ones.
fn check_in_order(records: &Records) -> Result<(), Error> {
    for (line, record) in &records.rows {
        let numbers: Vec<&str> = record.iter().skip(1).take_while(|field| records.number(field).is_some()).collect();
        if (numbers.len() > WHOLE_NUMBERS || numbers.iter().any(|field| has_leading_zero(field))) && records.may_be_cut(&numbers) {
            return refuse(Refusal::DecimalCommas { input: Input::PositionTable, record: records.shown(record), line: *line });
        }
    }
    Ok(())
}
