//! What the columns of a table of image positions hold, by their names or by their order.

use super::column_names::{Column, Coordinates, coordinates_of, is_ellipsoidal, looks_like_height, meaning_of, meanings, names_of};
use super::column_units::unit_m;
use super::columns::{IMAGES, UnreadColumns, letters, others, without_unit};
use super::control::StatedUnit;
use super::control_columns::check_unit;
use super::error_columns::{ErrorColumns, can_be_errors};
use super::hemispheres::Axis;
use super::side_columns::{is_side_of, side_column};
use super::whole_numbers::NumberColumns;
use crate::error::refuse;
use crate::text::{NumberedRecord, Records, filled, is_none, shorten};
use crate::{Error, Refusal};
use csv::StringRecord;

/// Names of the column of images beside those that tables of measurements have.
const FURTHER: &str = "name label cameralabel nom nombre nome";

/// Largest standard error in a column without a name, in m: positions of receivers are known so well.
const MOST_ERROR_M: f64 = 50.0;

/// The columns of a table of image positions.
#[derive(Debug, Clone)]
pub(super) struct PositionColumns {
    pub image: usize,
    /// Of x and y, or of longitude and latitude.
    pub place: [usize; 2],
    pub height: Option<usize>,
    /// Of the hemispheres of longitude and latitude, and of the side of sea level.
    pub sides: [Option<usize>; 3],
    /// Of the standard errors of x and of y, of which the larger one counts.
    pub across: Option<[usize; 2]>,
    pub up: Option<usize>,
    /// The units of these three, in m.
    pub error_units_m: [f64; 3],
    /// What the names of x and y say of them; absent where the table names no columns.
    pub coordinates: Option<Coordinates>,
}

impl PositionColumns {
    /// The columns of rows without names. `coordinates`: what x and y are, where the table says its system. Standard errors stand behind the height where nothing
    /// follows them, or behind three angles, and only where all of them can be some. Below a line with a system, as OpenDroneMap has it, angles stand first.
    pub fn in_order(records: &Records, coordinates: Option<Coordinates>) -> Self {
        let width = records.rows.iter().map(|(_, record)| filled(record)).max().unwrap_or(0);
        let errors = match width {
            6 if coordinates.is_none() => Some(4),
            9 => Some(7),
            _ => None,
        };
        let given = |column: usize| records.rows.iter().filter_map(move |(_, record)| record.get(column).filter(|field| !is_none(field)));
        let numbers = |column: usize| given(column).map(|field| records.number(field)).collect::<Option<Vec<f64>>>();
        // Angles and words stand there, too.
        let are_errors = |column: usize| numbers(column).is_some_and(|numbers| can_be_errors(&numbers, MOST_ERROR_M));
        let errors = errors.filter(|column| are_errors(*column) && are_errors(column + 1));
        Self {
            image: 0,
            place: [1, 2],
            height: Some(3).filter(|column| *column < width),
            sides: [None; 3],
            across: errors.map(|column| [column; 2]),
            up: errors.map(|column| column + 1),
            error_units_m: [1.0; 3],
            coordinates,
        }
    }

    /// The columns of image, x and y that a line names, as far as it does.
    pub fn needed(head: &StringRecord) -> [Option<usize>; 3] {
        let meanings = meanings(head);
        let first = |wanted: Column| meanings.iter().position(|meaning| *meaning == Some(wanted));
        [image_column(head), first(Column::X), first(Column::Y)]
    }

    /// The columns that a line names. Longitudes and latitudes are read where there are others beside them, with the height above the ellipsoid.
    pub fn named_by(records: &Records, head: &StringRecord, rows: &[NumberedRecord]) -> Result<Self, Error> {
        let meanings = meanings(head);
        let name = |column: usize| head.get(column).unwrap_or("");
        let rank = |column: usize| meaning_of(name(column)).map_or(usize::MAX, |(_, rank)| rank);
        let all = |wanted: Column| {
            let mut found: Vec<usize> = (0..meanings.len()).filter(|column| meanings[*column] == Some(wanted)).collect();
            found.sort_by_key(|column| (rank(*column), *column));
            found
        };
        let first = |wanted: Column| all(wanted).first().copied();
        let missing =
            |column: &str, known: String| Refusal::PositionColumn { column: column.into(), known, names: records.shown(head) }.into_error();
        let Some(image) = image_column(head) else {
            return Err(missing("image", others(&format!("{IMAGES} {FURTHER}"))));
        };
        let (xs, ys) = (all(Column::X), all(Column::Y));
        for (wanted, found) in [(Column::X, &xs), (Column::Y, &ys)] {
            if found.is_empty() {
                check_unit(records, head, wanted)?;
            }
        }
        let of = |columns: &[usize], kind| columns.iter().copied().find(|column| coordinates_of(name(*column)) == kind);
        let kinds = [Coordinates::Geographic, Coordinates::Either, Coordinates::Plane];
        let pair = kinds.into_iter().find_map(|kind| Some((of(&xs, kind)?, of(&ys, kind)?, kind)));
        let (x, y, coordinates) = match (pair, xs.first(), ys.first()) {
            (Some(pair), ..) => pair,
            (None, None, _) => return Err(missing("longitude", others(names_of(Column::X)))),
            (None, _, None) => return Err(missing("latitude", others(names_of(Column::Y)))),
            (None, Some(x), Some(y)) => {
                let is_mixed = [*x, *y].iter().any(|column| coordinates_of(name(*column)) == Coordinates::Geographic);
                if is_mixed {
                    return refuse(Refusal::PositionKinds { x: name(*x).into(), y: name(*y).into() });
                }
                (*x, *y, Coordinates::Plane)
            }
        };
        // Names that leave it open are of degrees where all places can be.
        let coordinates = match coordinates {
            Coordinates::Either if rows.iter().all(|(_, record)| may_be_degrees(records, record, [x, y])) => Coordinates::Geographic,
            Coordinates::Either => Coordinates::Plane,
            certain => certain,
        };
        let heights = all(Column::Z);
        let surfaces = match coordinates {
            Coordinates::Plane => [Some(false), None, Some(true)].as_slice(),
            _ => &[Some(true), None],
        };
        let height = surfaces.iter().find_map(|surface| heights.iter().copied().find(|height| is_ellipsoidal(name(*height)) == *surface));
        let is_of_degrees = coordinates == Coordinates::Geographic;
        let sides = [
            side_column(head, Axis::Longitude).filter(|_| is_of_degrees),
            side_column(head, Axis::Latitude).filter(|_| is_of_degrees),
            side_column(head, Axis::Height).filter(|column| height.is_some_and(|height| is_side_of(name(*column), name(height)))),
        ];
        let apart = first(Column::ErrorX).zip(first(Column::ErrorY)).map(|(x, y)| [x, y]);
        let of_all = first(Column::ErrorAll);
        // That of the place may be of both axes together.
        let across = apart.or(first(Column::ErrorAcross).or(of_all).map(|column| [column; 2]));
        let up = first(Column::ErrorUp).or(of_all);
        let unit = |column: Option<usize>| column.map_or(1.0, |column| unit_m(name(column)));
        let error_units_m = [unit(across.map(|[x, _]| x)), unit(across.map(|[_, y]| y)), unit(up)];
        Ok(Self { image, place: [x, y], height, sides, across, up, error_units_m, coordinates: Some(coordinates) })
    }

    /// Its numbers, and what is none. Standard errors beside whole degrees are rather halves of these.
    pub fn numbers(&self, named: usize) -> NumberColumns {
        let is_of_degrees = self.coordinates == Some(Coordinates::Geographic);
        let [unit_x, unit_y, unit_up] = self.error_units_m;
        let across = self.across.into_iter().flatten().zip([unit_x, unit_y]);
        let errors = across.chain(self.up.map(|up| (up, unit_up))).filter(|_| !is_of_degrees);
        let texts = self.sides.into_iter().flatten().chain([self.image]);
        // Nobody measures where an image was taken to a degree.
        let named = Some(named).filter(|_| !is_of_degrees);
        let read = self.place.into_iter().chain(self.height);
        NumberColumns { read: read.collect(), height: self.height, errors: errors.collect(), texts: texts.collect(), named }
    }

    /// The columns of some rows that are not read. `head`: the line of names, where there is one.
    pub fn unread(&self, rows: &[NumberedRecord], head: Option<&StringRecord>) -> UnreadColumns {
        let read = self
            .place
            .into_iter()
            .chain([self.image])
            .chain(self.height)
            .chain(self.sides.into_iter().flatten())
            .chain(self.across.into_iter().flatten())
            .chain(self.up);
        let meanings = head.map(meanings).unwrap_or_default();
        let twin = |column: usize| match meanings.get(column).copied().flatten()? {
            Column::X => Some(self.place[0]),
            Column::Y => Some(self.place[1]),
            Column::Z => self.height,
            Column::ErrorAcross | Column::ErrorX | Column::ErrorAll => self.across.map(|[x, _]| x),
            Column::ErrorY => self.across.map(|[_, y]| y),
            Column::ErrorUp => self.up,
            Column::Name | Column::ErrorPx | Column::Use | Column::Kind | Column::Enabled => None,
        };
        UnreadColumns::of(rows, head, &read.collect(), twin)
    }

    /// The column that is rather one of heights, where none is read.
    pub fn unread_height(&self, head: &StringRecord) -> Option<String> {
        let looks = |(column, name): &(usize, &str)| Some(*column) != self.sides[Axis::Height as usize] && looks_like_height(name);
        head.iter().enumerate().find(looks).filter(|_| self.height.is_none()).map(|(_, name)| shorten(name))
    }

    /// The units of length that names of columns of coordinates have.
    pub fn stated_units(&self, head: &StringRecord) -> Vec<StatedUnit> {
        StatedUnit::of(head, self.place, self.height)
    }

    /// The columns of standard errors that say no unit.
    pub fn error_columns(&self, head: Option<&StringRecord>) -> ErrorColumns {
        ErrorColumns::of(head, self.across, self.up)
    }
}

/// The column of images, where a line names one.
fn image_column(head: &StringRecord) -> Option<usize> {
    let plain: Vec<String> = head.iter().map(|name| letters(&without_unit(name, &[]).0)).collect();
    IMAGES.split(' ').chain(FURTHER.split(' ')).find_map(|name| plain.iter().position(|column| column == name))
}

/// Whether the numbers in these columns of a row, as far as it has any, can be longitude and latitude.
fn may_be_degrees(records: &Records, record: &StringRecord, [x, y]: [usize; 2]) -> bool {
    let read = |axis: Axis, column: usize| axis.read(record.get(column).unwrap_or(""), |text| records.number(text)).unwrap_or(0.0);
    is_on_earth([read(Axis::Longitude, x), read(Axis::Latitude, y)])
}

/// Whether a place can be longitude and latitude in degrees.
pub(super) fn is_on_earth([longitude_deg, latitude_deg]: [f64; 2]) -> bool {
    longitude_deg.abs() <= 180.0 && latitude_deg.abs() <= 90.0
}
