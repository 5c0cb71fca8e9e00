//! What the name of a column says that it holds: coordinates, standard errors and uses, in the words of many programs and languages.

use super::column_units::{Unit, behind_reference, in_brackets, is_above_sea, named, without_reference};
use super::columns::letters;
use csv::StringRecord;

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
    /// What a point is, which may say how it is used.
    Kind,
    Enabled,
}

/// The names of columns in tables of control points, here and in other programs, as [`plain`] writes them. The first of them that a table has is read.
const NAMES: [(Column, &str); 9] = [
    (
        Column::Name,
        "name label point pointname id pointid gcp gcpname gcpid number pointnumber nr no pointno pointnr pt ptid ptno marker \
         punkt punktname punktnummer punktnr pktnr pkt bezeichnung nomdupoint matricule n° nº numéro numero número num punto pto nom nombre nome ponto # \
         النقطة نقطة رقمالنقطة اسمالنقطة الاسم الرقم",
    ),
    (
        Column::X,
        "x e east easting longitude lon rechtswert ost xeasting long xlongitude rechts ostwert eastings \
         lng länge laenge gpslongitude xlon xlong est este leste longitud longitudine coordenadax xcoordinate coordinatex xcoord coordx öst längengrad \
         الشرق شرق الشرقيات شرقيات خطالطول خططول",
    ),
    (
        Column::Y,
        "y n north northing latitude lat hochwert nord ynorthing ylatitude hoch nordwert northings \
         breite gpslatitude ylat norte latitud latitudine coordenaday ycoordinate coordinatey ycoord coordy norr breitengrad \
         الشمال شمال الشماليات شماليات خطالعرض خطعرض دائرةالعرض",
    ),
    (
        Column::Z,
        // With the sign for a letter that was not in UTF-8, too.
        "z h height elevation altitude elev höhe alt zaltitude zelevation zheight hoehe h\u{fffd}he orthometricheight orthoheight ellipsoidalheight \
         ellipsoidheight ellheight hell elliphgt elliphht ellhgt ellipheight ellipsoidalhgt ellipsoidischehöhe ellipsoidischehoehe heightellipsoidal gpsaltitude absolutealtitude absalt hauteurellipsoïdale hauteurellipsoidale altitudeellipsoïdale \
         altitudeellipsoidale alturaelipsoidal quotaellissoidica hgt zalt up pointelevation höjd \
         cota quota cote hauteur altura altitud altitudine coordenadaz zcoordinate coordinatez zcoord coordz elevación elevacion elevação الارتفاع ارتفاع المنسوب منسوب",
    ),
    (Column::ErrorAcross, "across acch"),
    (Column::ErrorUp, "accv uperror"),
    (Column::Use, "use role"),
    (Column::Kind, "type typ pointtype punktart"),
    (Column::Enabled, "enabled enable active"),
];

/// The words for a standard error, bare or with an axis before or behind them. `error` is none: other programs call residuals that.
const ERRORS: [&str; 21] = [
    "sigma",
    "accuracy",
    "acc",
    "std",
    "stddev",
    "stdev",
    "sd",
    "rms",
    "rmse",
    "precision",
    "standarderror",
    "standarddeviation",
    "genauigkeit",
    "standardabweichung",
    "stdabw",
    "stabw",
    "prec",
    "σ",
    "précision",
    "ecarttype",
    "écarttype",
];

/// The axes of standard errors beside the names of coordinates.
const AXES: [(Column, &[&str]); 4] = [
    (Column::ErrorAll, &["xyz"]),
    (
        Column::ErrorAcross,
        &["xy", "horizontal", "horizontale", "horiz", "horz", "hor", "lage", "plan", "planimétrique", "lateral", "across", "en"],
    ),
    (Column::ErrorUp, &["vertical", "verticale", "vert", "u", "höhen", "hoehen", "altimétrique"]),
    (Column::ErrorPx, &["px", "image"]),
];

/// A name of letters alone: programs join its words in many ways.
pub(super) fn plain(name: &str) -> String {
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
    let is_of_degrees = ["lon", "lng", "länge", "laenge", "lat", "breite", "خطالطول", "خططول", "خطالعرض", "خطعرض", "دائرةالعرض"]
        .iter()
        .any(|word| plain.contains(word));
    match () {
        () if plain == "x" || plain == "y" || (is_of_degrees && plain.starts_with(['x', 'y'])) => Coordinates::Either,
        () if is_of_degrees => Coordinates::Geographic,
        () => Coordinates::Plane,
    }
}

/// Whether a height is named as one above the ellipsoid, or, `Some(false)`, as one above the geoid or the sea; `None` where its name leaves that open.
pub(super) fn is_ellipsoidal(name: &str) -> Option<bool> {
    let plain = plain(name);
    match () {
        () if plain.contains("ortho") || is_above_sea(name) => Some(false),
        () if ["ell", "elipsoid", "wgs"].iter().any(|word| plain.contains(word)) => Some(true),
        () => None,
    }
}

/// What a name of letters says of NAMES, and how early it stands among the names for that: a letter, which may be of something else (`n` satellites, `h` of
/// an antenna), behind all words.
pub(super) fn listed(plain: &str) -> Option<(Column, usize)> {
    let behind = if is_lone_letter(plain) { BEHIND_WORDS } else { 0 };
    NAMES.iter().find_map(|(column, names)| Some((*column, behind + names.split(' ').position(|known| known == plain)?)))
}

/// Ranks of letters follow those of words.
const BEHIND_WORDS: usize = 1000;

pub(super) fn is_lone_letter(plain: &str) -> bool {
    matches!(plain, "e" | "n" | "h")
}

/// What a name of an axis in a letter and in a word says, as `x (nord)`, `y/rechtswert` or `hochwert (x)`: the word counts, since letters are exchanged in
/// some countries. `Some(None)`: words that contradict each other.
fn axis_in_words(joined: &str) -> Option<Option<(Column, usize)>> {
    // Metashape calls its estimates so.
    let joined = Some(joined).filter(|joined| !joined.ends_with("_est"))?;
    let (one, other) = joined.trim_end_matches([')', ']']).split_once(['(', '[', '/', '_', ' '])?;
    let [one, other] = [one, other].map(|part| letters(part.trim_matches(['(', '[', ')', ']', ' '])));
    let is_letter = |name: &str| matches!(name, "x" | "y" | "z");
    let (of_one, of_other) = (listed(&one)?, listed(&other)?);
    let is_axis = |(column, _): (Column, usize)| matches!(column, Column::X | Column::Y | Column::Z);
    match (is_axis(of_one) && is_axis(of_other), is_letter(&one), is_letter(&other)) {
        (false, ..) => None,
        (true, true, false) => Some(Some(of_other)),
        (true, false, true) => Some(Some(of_one)),
        (true, ..) => Some(Some(of_one).filter(|(column, _)| *column == of_other.0)),
    }
}

/// What a name says, and how early it stands among the names for that; `None` where it says nothing here, and for standard errors in degrees.
pub(super) fn meaning_of(name: &str) -> Option<(Column, usize)> {
    let (joined, unit) = named(name);
    let plain = letters(&joined);
    let of_reference = || {
        let found = [without_reference(&joined), behind_reference(&joined)].into_iter().flatten().find_map(|bare| listed(&letters(bare)));
        found.filter(|(column, _)| matches!(column, Column::X | Column::Y | Column::Z))
    };
    let listed = axis_in_words(&joined).unwrap_or_else(|| listed(&plain).or_else(of_reference));
    match unit {
        None | Some(Unit::Length("m")) => {}
        Some(Unit::Degrees) => return listed.filter(|(column, _)| matches!(column, Column::X | Column::Y)),
        Some(Unit::Length(_)) => {
            let is_length =
                |column: Column| !matches!(column, Column::Name | Column::ErrorPx | Column::Use | Column::Kind | Column::Enabled);
            return listed.or_else(|| error_of(&joined, &plain)).filter(|(column, _)| is_length(*column));
        }
    }
    listed.or_else(|| error_of(&joined, &plain))
}

/// What a name of a standard error says.
fn error_of(joined: &str, plain: &str) -> Option<(Column, usize)> {
    // `rmse` is bare, `rms_e` is of the east.
    let bare = ERRORS.iter().position(|word| *word == joined).map(|rank| (Column::ErrorAll, rank));
    let short = [("sx", Column::ErrorX), ("sy", Column::ErrorY), ("sz", Column::ErrorUp)].into_iter();
    let short = short.filter(|(name, _)| *name == plain).map(|(_, column)| (column, ERRORS.len())).next();
    // DJI has those of its receivers so.
    let plain = plain.strip_prefix("rtk").unwrap_or(plain);
    short.or(bare).or_else(|| {
        ERRORS.iter().enumerate().find_map(|(rank, word)| {
            let axis = plain.strip_prefix(word).or_else(|| plain.strip_suffix(word))?;
            let column = if axis.is_empty() { Some(Column::ErrorAll) } else { error_along(axis) };
            column.map(|column| (column, rank))
        })
    })
}

/// What a standard error is of, by what stands beside the word for it, in brackets or not. `h` is nothing: it is height in one program, horizontal in the next.
fn error_along(axis: &str) -> Option<Column> {
    let axis = axis.trim_matches(['(', ')', '[', ']']);
    AXES.iter().find(|(_, axes)| axes.contains(&axis)).map(|(column, _)| *column).or_else(|| {
        match listed(axis).filter(|_| axis != "h")?.0 {
            Column::X => Some(Column::ErrorX),
            Column::Y => Some(Column::ErrorY),
            Column::Z => Some(Column::ErrorUp),
            _ => None,
        }
    })
}

/// Whether a name is of a standard error in degrees, or in a unit in brackets that is not known.
pub(super) fn has_unknown_error_unit(name: &str) -> bool {
    let (joined, unit) = named(name);
    let is_length_error = |joined: &str| {
        let found = error_of(joined, &letters(joined)).or_else(|| listed(&letters(joined)));
        found.is_some_and(|(column, _)| {
            matches!(column, Column::ErrorAcross | Column::ErrorX | Column::ErrorY | Column::ErrorUp | Column::ErrorAll)
        })
    };
    match in_brackets(&joined) {
        Some((bare, inner)) => unit.is_none() && is_length_error(bare) && error_along(inner).is_none(),
        None => unit == Some(Unit::Degrees) && is_length_error(&joined),
    }
}

/// Whether a name is rather one of heights, though it is not read as such: one of its words is, or holds such a word.
pub(super) fn looks_like_height(name: &str) -> bool {
    let (joined, _) = named(name);
    let of_heights = ["height", "hgt", "altitude", "elevation", "höhe", "hoehe", "hauteur", "altura"];
    let mut words = joined.split(|sign: char| !sign.is_alphanumeric()).filter(|word| !word.is_empty());
    let is_error = ERRORS.iter().any(|word| letters(&joined).contains(word));
    let is_height = |word: &str| listed(word).is_some_and(|(column, _)| column == Column::Z);
    !is_error && words.any(|word| is_height(word) || of_heights.iter().any(|of| word.contains(of)))
}

/// The names of a column, between blanks.
pub(super) fn names_of(column: Column) -> &'static str {
    NAMES.iter().find(|(of, _)| *of == column).map_or("", |(_, known)| known)
}

/// What each column of a line of names holds. `up` beside another height, where errors of the place but none of the height are named, is that error; so is `h` beside errors of both axes;
/// beside `v` it is the place.
pub(super) fn meanings(record: &StringRecord) -> Vec<Option<Column>> {
    let mut found: Vec<Option<Column>> = record.iter().map(|name| meaning_of(name).map(|(column, _)| column)).collect();
    let is_up = |column: &usize| record.get(*column).is_some_and(|name| plain(name) == "up");
    let has_height = (0..found.len()).any(|column| found[column] == Some(Column::Z) && !is_up(&column));
    let lacks_error = found.contains(&Some(Column::ErrorAcross)) && !found.contains(&Some(Column::ErrorUp));
    if has_height && lacks_error {
        (0..found.len()).filter(is_up).for_each(|column| found[column] = Some(Column::ErrorUp));
    }
    // Numbers of points, where northings are in a column of their own.
    let is_n = |column: usize| record.get(column).is_some_and(|name| plain(name) == "n");
    let has_northings = found.iter().enumerate().any(|(column, is)| *is == Some(Column::Y) && !is_n(column));
    if is_n(0) && has_northings && found[0] == Some(Column::Y) && !found.contains(&Some(Column::Name)) {
        found[0] = Some(Column::Name);
    }
    let of_axis = |axis: &str| -> Vec<usize> {
        let is_of = |name: &str| ERRORS.iter().any(|word| name.strip_prefix(word) == Some(axis) || name.strip_suffix(word) == Some(axis));
        let name = |column: &usize| record.get(*column).map(plain).unwrap_or_default();
        (0..found.len()).filter(|column| found[*column].is_none() && named_in_metres(record, *column) && is_of(&name(column))).collect()
    };
    let (of_h, of_v) = (of_axis("h"), of_axis("v"));
    // Beside one of the vertical, as `HRMS` and `VRMS`, it is the horizontal.
    let beside_both =
        found.contains(&Some(Column::ErrorX)) && found.contains(&Some(Column::ErrorY)) && !found.contains(&Some(Column::ErrorUp));
    let (h_is, v_is) = match () {
        () if !of_v.is_empty() && !of_h.is_empty() => (Some(Column::ErrorAcross), Some(Column::ErrorUp)),
        () if beside_both => (Some(Column::ErrorUp), None),
        () => (None, None),
    };
    of_h.into_iter().for_each(|column| found[column] = h_is);
    of_v.into_iter().for_each(|column| found[column] = v_is);
    found
}

/// Whether the name of a column has no unit or one of length.
fn named_in_metres(record: &StringRecord, column: usize) -> bool {
    record.get(column).is_some_and(|name| named(name).1 != Some(Unit::Degrees))
}
