//! What the columns of a table of control points hold, by their names or by their order.

use super::columns::{letters, others, without_unit};
use crate::error::refuse;
use crate::text::{Records, shorten};
use crate::{Error, Refusal};
use csv::StringRecord;
use std::collections::BTreeSet;

/// What a column may hold.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Column {
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
const NAMES: [(Column, &str); 7] = [
    (
        Column::Name,
        "name label point pointname id pointid gcp gcpname gcpid number pointnumber nr no pointno pointnr pt ptid ptno marker \
         punkt punktname punktnummer punktnr",
    ),
    (
        Column::X,
        "x e east easting longitude lon rechtswert ost xeasting long xlongitude rechts ostwert eastings lng länge laenge gpslongitude xlon xlong",
    ),
    (Column::Y, "y n north northing latitude lat hochwert nord ynorthing ylatitude hoch nordwert northings breite gpslatitude ylat"),
    (
        Column::Z,
        // With the sign for a letter that was not in UTF-8, too.
        "z h height elevation altitude elev höhe alt zaltitude zelevation zheight hoehe h\u{fffd}he orthometricheight ellipsoidalheight \
         ellipsoidheight ellheight hell ellipsoidischehöhe ellipsoidischehoehe heightellipsoidal gpsaltitude zalt up",
    ),
    (Column::ErrorAcross, "across acch"),
    (Column::ErrorUp, "accv uperror"),
    (Column::Use, "use role"),
];

/// The words for a standard error, bare or with an axis before or behind them. `error` is none: other programs call residuals that.
const ERRORS: [&str; 12] =
    ["sigma", "accuracy", "acc", "std", "stddev", "stdev", "sd", "rms", "rmse", "precision", "standarderror", "standarddeviation"];

/// The axes of standard errors. `h` is none: it is height in one program, horizontal in the next.
const AXES: [(Column, &[&str]); 5] = [
    (Column::ErrorAcross, &["xy", "horizontal", "across", "en", "horz", "hor", "plan", "lage", "lateral"]),
    (Column::ErrorX, &["x", "e", "east", "easting", "longitude", "lon"]),
    (Column::ErrorY, &["y", "n", "north", "northing", "latitude", "lat"]),
    (Column::ErrorUp, &["z", "vertical", "up", "height", "altitude", "elevation", "elev", "vert", "u", "höhe", "hoehe", "alt"]),
    (Column::ErrorPx, &["px", "image"]),
];

/// The unit that the name of a column has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Unit {
    Degrees,
    Length(&'static str),
}

/// Units as tables write them.
const UNITS: [(&str, Unit); 25] = [
    ("m", Unit::Length("m")),
    ("metre", Unit::Length("m")),
    ("metres", Unit::Length("m")),
    ("meter", Unit::Length("m")),
    ("meters", Unit::Length("m")),
    ("decimal degrees", Unit::Degrees),
    ("decimal degree", Unit::Degrees),
    ("deg", Unit::Degrees),
    ("degree", Unit::Degrees),
    ("degrees", Unit::Degrees),
    ("°", Unit::Degrees),
    ("us-ft", Unit::Length("us-ft")),
    ("us ft", Unit::Length("us-ft")),
    ("us_ft", Unit::Length("us-ft")),
    ("usft", Unit::Length("us-ft")),
    ("ussft", Unit::Length("us-ft")),
    ("ftus", Unit::Length("us-ft")),
    ("us survey feet", Unit::Length("us-ft")),
    ("us survey foot", Unit::Length("us-ft")),
    ("ft", Unit::Length("ft")),
    ("feet", Unit::Length("ft")),
    ("foot", Unit::Length("ft")),
    ("mm", Unit::Length("mm")),
    ("cm", Unit::Length("cm")),
    ("km", Unit::Length("km")),
];

/// A name in small letters, and the unit behind it, where there is one.
pub(super) fn named(name: &str) -> (String, Option<Unit>) {
    let (bare, unit) = without_unit(name, &UNITS.map(|(unit, _)| unit));
    let unit = unit.and_then(|unit| UNITS.iter().find(|(known, _)| *known == unit));
    (bare, unit.map(|(_, unit)| *unit))
}

/// A name of letters alone: programs join its words in many ways.
fn plain(name: &str) -> String {
    letters(&named(name).0)
}

/// The names that say a column to hold coordinates: those of the plane, of either, or of longitudes and latitudes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Coordinates {
    Geographic,
    Plane,
    /// `x`, and the `X/Longitude` of programs that name one column for both.
    Either,
}

/// What coordinates the name of a column of x or y says to hold.
pub(super) fn coordinates_of(name: &str) -> Coordinates {
    let plain = plain(name);
    let is_of_degrees = ["lon", "lng", "länge", "laenge", "lat", "breite"].iter().any(|word| plain.contains(word));
    match () {
        () if plain == "x" || plain == "y" || (is_of_degrees && plain.starts_with(['x', 'y'])) => Coordinates::Either,
        () if is_of_degrees => Coordinates::Geographic,
        () => Coordinates::Plane,
    }
}

/// Whether a height is named as one above the ellipsoid, or, `Some(false)`, as one above the geoid; `None` where its name leaves that open.
pub(super) fn is_ellipsoidal(name: &str) -> Option<bool> {
    let plain = plain(name);
    match () {
        () if plain.contains("ell") => Some(true),
        () if plain.contains("ortho") => Some(false),
        () => None,
    }
}

/// What a name says, and how early it stands among the names for that; `None` where it says nothing here, and for standard errors in other units.
pub(super) fn meaning_of(name: &str) -> Option<(Column, usize)> {
    let (joined, unit) = named(name);
    let plain = letters(&joined);
    let listed = NAMES.iter().find_map(|(column, names)| Some((*column, names.split(' ').position(|known| known == plain)?)));
    match unit {
        None | Some(Unit::Length("m")) => {}
        Some(Unit::Degrees) => return listed.filter(|(column, _)| matches!(column, Column::X | Column::Y)),
        Some(Unit::Length(_)) => return listed.filter(|(column, _)| matches!(column, Column::X | Column::Y | Column::Z)),
    }
    // `rmse` is bare, `rms_e` is of the east.
    let bare = ERRORS.iter().position(|word| *word == joined).map(|rank| (Column::ErrorAll, rank));
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

/// The names of a column, between blanks.
pub(super) fn names_of(column: Column) -> &'static str {
    NAMES.iter().find(|(of, _)| *of == column).map_or("", |(_, known)| known)
}

/// What each column of a line of names holds. `up` beside another height, where errors of the place but none of the height are named, is that error.
pub(super) fn meanings(record: &StringRecord) -> Vec<Option<Column>> {
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
pub(super) struct Columns {
    pub name: usize,
    pub position: [usize; 3],
    pub standard_errors: Option<([usize; 2], usize)>,
    pub role: Option<usize>,
    pub sigma_px: Option<usize>,
}

impl Default for Columns {
    fn default() -> Self {
        Self { name: 0, position: [1, 2, 3], standard_errors: Some(([4, 4], 5)), role: None, sigma_px: None }
    }
}

impl Columns {
    /// The columns of a table, and whether its first line names them.
    pub fn of(records: &Records) -> Result<(Self, bool), Error> {
        let has_number = |record: &StringRecord, column: usize| record.get(column).is_some_and(|field| records.number(field).is_some());
        match records.rows.first() {
            None => Ok((Self::default(), false)),
            Some((_, first)) if (1..4).all(|column| has_number(first, column)) => {
                // A word behind the coordinates is a code or a remark.
                let word = first.get(4).filter(|field| !field.is_empty() && !field.contains(|letter: char| letter.is_ascii_digit()));
                let has_code = word.is_some() && !records.rows.iter().any(|(_, record)| has_number(record, 4));
                let columns = Self::default();
                Ok((if has_code { Self { standard_errors: None, ..columns } } else { columns }, false))
            }
            Some((_, first)) => Ok((Self::named_by(records, first)?, true)),
        }
    }

    /// The columns that a line names.
    fn named_by(records: &Records, record: &StringRecord) -> Result<Self, Error> {
        let meanings = meanings(record);
        let rank = |column: usize| record.get(column).and_then(meaning_of).map_or(usize::MAX, |(_, rank)| rank);
        let place =
            |wanted: Column| (0..meanings.len()).filter(|k| meanings[*k] == Some(wanted)).min_by_key(|column| (rank(*column), *column));
        let needed = |column: Column, name: &str| {
            let known = others(names_of(column));
            let refusal = || Refusal::ControlColumn { column: name.into(), known, names: records.shown(record) };
            place(column).ok_or_else(|| refusal().into_error())
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
        Ok(Self {
            name: needed(Column::Name, "name")?,
            position: [needed(Column::X, "x")?, needed(Column::Y, "y")?, needed(Column::Z, "z")?],
            standard_errors,
            role: place(Column::Use),
            sigma_px: place(Column::ErrorPx),
        })
    }

    /// The columns that are read.
    pub fn read(&self) -> BTreeSet<usize> {
        let errors = self.standard_errors.into_iter().flat_map(|([x, y], z)| [x, y, z]);
        self.position.into_iter().chain([self.name]).chain(errors).chain(self.role).chain(self.sigma_px).collect()
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
            Column::Use => self.role,
        }
    }
}
