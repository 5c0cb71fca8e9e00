//! What the columns of a table of control points hold, by their names or by their order.

use super::column_names::{
    Column, Coordinates, coordinates_of, has_unknown_error_unit, is_ellipsoidal, is_lone_letter, listed, meaning_of, meanings, names_of,
    plain,
};
use super::column_units::{unit_m, units, without_other_unit};
use super::columns::{LENGTHS, others};
use super::control_order::errors_in_order;
use super::control_use::Uses;
use super::hemispheres::Axis;
use super::side_columns::side_column;
use super::system_line::SystemLine;
use super::whole_numbers::NumberColumns;
use crate::error::refuse;
use crate::text::{Headed, Records, is_none, shorten};
use crate::{Error, Refusal};
use csv::StringRecord;
use std::collections::BTreeSet;

/// Refuses a column of coordinates that would be the wanted one but for a unit in brackets that is not known.
pub(super) fn check_unit(records: &Records, names: &StringRecord, wanted: Column) -> Result<(), Error> {
    let is_wanted = |name: &&str| without_other_unit(name).and_then(|bare| listed(&bare)).is_some_and(|(column, _)| column == wanted);
    let Some(name) = names.iter().find(is_wanted).filter(|_| matches!(wanted, Column::X | Column::Y | Column::Z)) else { return Ok(()) };
    let units = LENGTHS.map(|(unit, _)| unit).join(", ");
    refuse(Refusal::ColumnUnit { input: records.input(), column: shorten(name), units, degrees: wanted != Column::Z })
}

/// The columns of a table: of the name, of x, y, z, of the standard errors of the place (of which the larger one counts) and of the height.
#[derive(Debug, Clone, Copy)]
pub(super) struct Columns {
    pub name: usize,
    pub position: [usize; 3],
    pub standard_errors: Option<([usize; 2], usize)>,
    /// The units of these, in m.
    pub error_units_m: [f64; 3],
    pub uses: Uses,
    pub sigma_px: Option<usize>,
    /// Whether x and y are named as longitude and latitude.
    pub is_geographic: bool,
    /// Of the hemispheres of these.
    pub sides: [Option<usize>; 2],
}

impl Default for Columns {
    fn default() -> Self {
        let standard_errors = Some(([4, 4], 5));
        Self {
            name: 0,
            position: [1, 2, 3],
            standard_errors,
            error_units_m: [1.0; 3],
            uses: Uses::default(),
            sigma_px: None,
            is_geographic: false,
            sides: [None; 2],
        }
    }
}

/// The columns of a table, what names them, and its rows.
pub(super) struct Layout<'a> {
    pub columns: Columns,
    pub names: Option<StringRecord>,
    pub rows: &'a [(usize, StringRecord)],
}

/// The columns that a table of control points needs, with what they are called here.
const NEEDED: [(Column, &str); 4] = [(Column::Name, "name"), (Column::X, "x"), (Column::Y, "y"), (Column::Z, "z")];

impl<'a> Layout<'a> {
    /// The columns of a table by the line that names them, or by their order.
    pub fn of(records: &'a Records) -> Result<Self, Error> {
        let needed = |names: &StringRecord| {
            let meanings = meanings(names);
            let [name, x, y, z] = NEEDED.map(|(column, _)| place(names, &meanings, column));
            let [x, y] = plane(names, &meanings).map_or([x, y], |plane| plane.map(Some));
            [name, x, y, z]
        };
        let Headed { names, rows, misplaced } = records.headed(needed, &units())?;
        if let Some(names) = names {
            let columns = Columns::named_by(&names, needed(&names), rows)?;
            let numbers = columns.numbers(names.len());
            numbers.check_thousands(records, rows)?;
            numbers.check(records, rows)?;
            return Ok(Self { columns, names: Some(names), rows });
        }
        SystemLine::refuse_in(records)?;
        let has_number = |record: &StringRecord, column: usize| record.get(column).is_some_and(|field| records.number(field).is_some());
        // Of points that were not surveyed yet the coordinates are empty.
        let first = || rows.iter().map(|(_, record)| record).find(|record| !Columns::default().lacks_coordinates(record));
        // A name with decimals, and a height without any, are rather a coordinate and a name.
        let has_decimals = |record: &StringRecord, column: usize| has_number(record, column) && record[column].contains(['.', ',']);
        let is_shifted = |record: &StringRecord| has_decimals(record, 0) && has_number(record, 3) && !has_decimals(record, 3);
        let are_shifted = !rows.is_empty() && rows.iter().all(|(_, record)| is_shifted(record));
        let is_in_order = misplaced.is_none() && !are_shifted && first().is_none_or(|first| (1..4).all(|column| has_number(first, column)));
        if is_in_order {
            let columns = Columns { standard_errors: errors_in_order(records)?, ..Columns::default() };
            columns.numbers(0).check_thousands(records, rows)?;
            return Ok(Self { columns, names: None, rows });
        }
        let shown = misplaced.as_ref().or_else(|| records.likely_head(needed));
        let missing = shown.and_then(|names| needed(names).iter().position(Option::is_none)).unwrap_or(0);
        let (column, name) = NEEDED[missing];
        if let Some(names) = shown {
            check_unit(records, names, column)?;
        }
        let names = shown.map_or_else(String::new, |names| records.shown(names));
        refuse(Refusal::ControlColumn { column: name.into(), known: others(names_of(column)), names })
    }
}

/// The column that holds this, of several the one whose name stands first among those for it; of heights one above the ellipsoid last.
fn place(names: &StringRecord, meanings: &[Option<Column>], wanted: Column) -> Option<usize> {
    let rank = |column: usize| names.get(column).and_then(meaning_of).map_or(usize::MAX, |(_, rank)| rank);
    let is_last = |column: usize| wanted == Column::Z && names.get(column).and_then(is_ellipsoidal) == Some(true);
    (0..meanings.len()).filter(|k| meanings[*k] == Some(wanted)).min_by_key(|column| (is_last(*column), rank(*column), *column))
}

/// The columns of x and y that are named in one way: by words of the plane, by letters, or as longitude and latitude.
fn plane(names: &StringRecord, meanings: &[Option<Column>]) -> Option<[usize; 2]> {
    let way = |column: usize| {
        let name = names.get(column).unwrap_or("");
        match coordinates_of(name) {
            Coordinates::Geographic => 2,
            _ => usize::from(is_lone_letter(&plain(name))),
        }
    };
    (0..3).find_map(|wanted| {
        let of_way: Vec<Option<Column>> = meanings.iter().enumerate().map(|(k, is)| is.filter(|_| way(k) == wanted)).collect();
        Some([place(names, &of_way, Column::X)?, place(names, &of_way, Column::Y)?])
    })
}

impl Columns {
    /// The columns that a line names. `needed`: those of name, x, y and z, as far as they are there.
    fn named_by(names: &StringRecord, needed: [Option<usize>; 4], rows: &[(usize, StringRecord)]) -> Result<Self, Error> {
        let meanings = meanings(names);
        let place = |wanted: Column| place(names, &meanings, wanted);
        if let Some(name) = names.iter().find(|name| has_unknown_error_unit(name)) {
            let units = LENGTHS.map(|(unit, _)| unit).join(", ");
            return refuse(Refusal::ControlErrorUnit { column: shorten(name), units });
        }
        let apart = place(Column::ErrorX).zip(place(Column::ErrorY)).map(|(x, y)| [x, y]);
        let of_all = place(Column::ErrorAll);
        // That of the place may be of both axes together.
        let across = apart.or(place(Column::ErrorAcross).or(of_all).map(|column| [column; 2]));
        let standard_errors = across.zip(place(Column::ErrorUp).or(of_all));
        let errors = [Column::ErrorAcross, Column::ErrorX, Column::ErrorY, Column::ErrorUp];
        if let (None, Some(one)) = (standard_errors, errors.into_iter().find_map(place)) {
            let name = names.get(one).unwrap_or("");
            return refuse(Refusal::ControlErrorColumn { column: shorten(name) });
        }
        let unit_m = |column: usize| names.get(column).map_or(1.0, unit_m);
        let [name, x, y, z] = needed.map(|column| column.unwrap_or(0));
        let is_of_degrees = |column: usize| names.get(column).is_some_and(|name| coordinates_of(name) == Coordinates::Geographic);
        let is_geographic = [x, y].into_iter().all(is_of_degrees);
        Ok(Self {
            name,
            position: [x, y, z],
            standard_errors,
            error_units_m: standard_errors.map_or([1.0; 3], |([x, y], z)| [x, y, z].map(unit_m)),
            uses: Uses::of(rows, place(Column::Use), place(Column::Kind), place(Column::Enabled)),
            sigma_px: place(Column::ErrorPx),
            is_geographic,
            sides: [Axis::Longitude, Axis::Latitude].map(|axis| side_column(names, axis).filter(|_| is_geographic)),
        })
    }

    /// Whether a row has none of x, y and z.
    pub fn lacks_coordinates(&self, record: &StringRecord) -> bool {
        self.position.into_iter().all(|column| record.get(column).is_some_and(is_none))
    }

    /// Its numbers, and what is none. `named`: so many columns a line names.
    fn numbers(&self, named: usize) -> NumberColumns {
        let errors = self.standard_errors.into_iter().flat_map(|([x, y], z)| [x, y, z]).zip(self.error_units_m);
        let texts = [Some(self.name), self.uses.role, self.uses.enabled].into_iter().flatten();
        let read = self.position.into_iter().chain(self.sigma_px);
        // Nobody surveys a point to a degree.
        let named = Some(named).filter(|_| !self.is_geographic);
        let height = Some(self.position[2]);
        NumberColumns { read: read.collect(), height, errors: errors.collect(), texts: texts.collect(), named }
    }

    /// The columns that are read.
    pub fn read(&self) -> BTreeSet<usize> {
        let errors = self.standard_errors.into_iter().flat_map(|([x, y], z)| [x, y, z]);
        let uses = [self.uses.role, self.uses.enabled, self.sigma_px].into_iter().chain(self.sides).flatten();
        self.position.into_iter().chain([self.name]).chain(errors).chain(uses).collect()
    }

    /// The column that is read where another one holds this too.
    pub fn instead_of(&self, meaning: Column) -> Option<usize> {
        match meaning {
            Column::Name => Some(self.name),
            Column::X => Some(self.position[0]),
            Column::Y => Some(self.position[1]),
            Column::Z => Some(self.position[2]),
            Column::ErrorAcross | Column::ErrorX | Column::ErrorAll => self.standard_errors.map(|([x, _], _)| x),
            Column::ErrorY => self.standard_errors.map(|([_, y], _)| y),
            Column::ErrorUp => self.standard_errors.map(|(_, z)| z),
            Column::ErrorPx => self.sigma_px,
            Column::Use => self.uses.role,
            Column::Enabled => self.uses.enabled,
            // It may say something else.
            Column::Kind => None,
        }
    }
}
