//! What stands behind the name of a column: its unit, or what its numbers refer to.

use super::columns::{LENGTHS, letters, without_unit};

/// The unit that the name of a column has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Unit {
    Degrees,
    Length(&'static str),
}

/// Units as tables write them.
const UNITS: [(&str, Unit); 32] = [
    ("m", Unit::Length("m")),
    ("metre", Unit::Length("m")),
    ("metres", Unit::Length("m")),
    ("meter", Unit::Length("m")),
    ("meters", Unit::Length("m")),
    ("decimal degrees", Unit::Degrees),
    ("decimal degree", Unit::Degrees),
    ("dd", Unit::Degrees),
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
    ("ft us", Unit::Length("us-ft")),
    ("sft", Unit::Length("us-ft")),
    ("us survey feet", Unit::Length("us-ft")),
    ("us survey foot", Unit::Length("us-ft")),
    ("us survey ft", Unit::Length("us-ft")),
    ("ift", Unit::Length("ft")),
    ("international feet", Unit::Length("ft")),
    ("international foot", Unit::Length("ft")),
    ("ft", Unit::Length("ft")),
    ("feet", Unit::Length("ft")),
    ("foot", Unit::Length("ft")),
    ("mm", Unit::Length("mm")),
    ("cm", Unit::Length("cm")),
    ("km", Unit::Length("km")),
];

/// Units that are not read, between blanks.
const OTHERS: &str = "in inch inches \" ″ rod rods dm yd yard yards chain chains link links mi mile miles nm fathom fathoms µm μm mas gon gons grad grads \
                      rad radian radians min minutes sec seconds dms arcsec px pix pixel pixels norm normalized normalised";

/// Words for surfaces near the sea that heights count from, with or without a number behind them, between blanks.
const SEA_LEVELS: &str = "navd ngvd cgvd egm dhhn ngf ign nn nhn nap ln lhn rh odn ahd evrf msl amsl asl orth ortho orthometric";
/// Words for the ellipsoid.
const ELLIPSOIDS: &str = "ellipsoid ellipsoidal ellipsoidisch ellipsoidische ellip ell";
/// Words for systems and other surfaces that coordinates refer to.
const REFERENCES: &str = "gps grid geogr geographische utm gk lv wgs etrs etrf itrf igs nad rgf lambert l93 osgb gda mga mgi rd sweref \
                          ed tm mtm epsg geoid local lokal";
/// Those of a plane, in which x and y are no coordinates from the centre of the earth.
const PLANES: &str = "utm gk grid local lokal";
/// Words beside these. West and south are none: numbers that grow that way have another sign.
const FILLERS: &str = "ü über ueber above over the sea level zone height n e m28 m31 m34";

/// A name in small letters, and the unit behind it, where there is one; `m` of `Höhe (m ü. NHN)`, too.
pub(super) fn named(name: &str) -> (String, Option<Unit>) {
    let (bare, unit) = without_unit(name, &UNITS.map(|(unit, _)| unit));
    let known = |unit: &str| UNITS.iter().find(|(known, _)| *known == unit).map(|(_, unit)| *unit);
    match unit.and_then(known) {
        Some(unit) => (bare, Some(unit)),
        None => match in_brackets(&bare).and_then(|(bare, inner)| Some((bare.to_string(), leading(inner)?))) {
            Some((bare, unit)) => (bare, Some(unit)),
            None => (bare, None),
        },
    }
}

/// The name before brackets at its end, and what stands in these.
pub(super) fn in_brackets(joined: &str) -> Option<(&str, &str)> {
    let (bare, inner) = joined.trim_end().strip_suffix([')', ']'])?.rsplit_once(['(', '['])?;
    Some((bare.trim_end(), inner.trim()))
}

/// The known unit that stands before words for what the numbers refer to.
fn leading(inner: &str) -> Option<Unit> {
    let of = |(unit, is): &(&str, Unit)| {
        let rest = inner.strip_prefix(unit)?;
        (rest.starts_with([' ', ',', ';']) && is_reference(rest, true)).then_some(*is)
    };
    UNITS.iter().find_map(of)
}

/// The words of a name or of what stands in brackets, in small letters.
fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|sign: char| !sign.is_alphanumeric()).filter(|word| !word.is_empty())
}

fn is_in(list: &str, word: &str) -> bool {
    list.split(' ').any(|known| known == word)
}

fn without_number(word: &str) -> &str {
    word.trim_end_matches(|sign: char| sign.is_ascii_digit())
}

/// Whether the name of heights says that they count from a surface near the sea.
pub(super) fn is_above_sea(name: &str) -> bool {
    let small = name.to_lowercase();
    small.contains("sea level") || words(&small).any(|word| is_in(SEA_LEVELS, without_number(word)))
}

/// Whether some words say what coordinates refer to and nothing else. `may_fill`: whether words beside these will do.
fn is_reference(text: &str, may_fill: bool) -> bool {
    let mut words = words(text).peekable();
    let mut refers = may_fill;
    let is_known = words.peek().is_some()
        && words.all(|word| {
            // A number or a zone behind what it is of.
            let is_number = word.starts_with(|sign: char| sign.is_ascii_digit());
            let is_named = [SEA_LEVELS, ELLIPSOIDS, REFERENCES].iter().any(|list| is_in(list, word) || is_in(list, without_number(word)));
            let fits = is_named || is_in(FILLERS, word) || (is_number && refers);
            refers |= is_named;
            fits
        });
    is_known && refers
}

/// A name in small letters without the surface or system behind it: `h` of `H (DHHN2016)` and of `H LN02`.
pub(super) fn without_reference(joined: &str) -> Option<&str> {
    match in_brackets(joined) {
        Some((bare, inner)) => Some(bare).filter(|_| is_reference(inner, false)),
        None => {
            let (bare, behind) = joined.trim_end().rsplit_once([' ', '_'])?;
            let is_certain =
                behind.ends_with(|sign: char| sign.is_ascii_digit()) || [SEA_LEVELS, ELLIPSOIDS].iter().any(|list| is_in(list, behind));
            Some(bare.trim_end()).filter(|_| is_certain && is_reference(behind, false))
        }
    }
}

/// A name in small letters behind the system that it is of: `latitude` of `WGS84 Latitude`, `ost` of `UTM-Ost`. X, y and z in a system of the earth may count
/// from its centre, and the height of a geoid is its own.
pub(super) fn behind_reference(joined: &str) -> Option<&str> {
    let (system, bare) = joined.split_once([' ', '_', '-'])?;
    let is_open = (matches!(bare, "x" | "y" | "z") && !is_in(PLANES, without_number(system))) || system == "geoid";
    Some(bare).filter(|_| !is_open && is_reference(system, false))
}

/// A name in letters without the unit in brackets behind it that is not read.
pub(super) fn without_other_unit(name: &str) -> Option<String> {
    let (joined, _) = named(name);
    let (bare, inner) = in_brackets(&joined)?;
    let mut words = inner.split([' ', ',', ';', '.']);
    let is_unit = |word: &str| OTHERS.split(' ').chain(UNITS.iter().map(|(unit, _)| *unit)).any(|known| known == word);
    let is_scale = inner.contains(['×', '*', '^', '/']);
    (is_scale || words.any(is_unit)).then(|| letters(bare))
}

/// Whether something stands behind a name that is none of these units: in brackets, or a unit behind a sign.
pub(super) fn is_of_other_unit(name: &str, own: &[&str]) -> bool {
    let (bare, unit) = without_unit(name, own);
    let is_unit = |word: &str| is_in(OTHERS, word) || UNITS.iter().any(|(known, _)| *known == word);
    unit.is_none() && (in_brackets(&bare).is_some() || bare.rsplit_once(['_', ' ']).is_some_and(|(_, behind)| is_unit(behind)))
}

/// The units as tables write them.
pub(super) fn units() -> Vec<&'static str> {
    UNITS.iter().map(|(unit, _)| *unit).collect()
}

/// The unit of length that the name of a column has, in m: without one they are metres.
pub(super) fn unit_m(name: &str) -> f64 {
    match named(name).1 {
        Some(Unit::Length(unit)) => LENGTHS.iter().find(|(known, _)| *known == unit).map_or(1.0, |(_, length_m)| *length_m),
        Some(Unit::Degrees) | None => 1.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn brackets_hold_units_or_what_coordinates_refer_to() {
        let m = Some(Unit::Length("m"));
        for (name, bare, unit) in [
            ("Höhe [m NHN]", "höhe", m),
            ("Höhe (m ü. NHN)", "höhe", m),
            ("Altitude (m MSL)", "altitude", m),
            ("Easting (m, UTM 32N)", "easting", m),
            ("Elev (ft NAVD88)", "elev", Some(Unit::Length("ft"))),
            ("Easting (ft US)", "easting", Some(Unit::Length("us-ft"))),
            ("Longitude (dd)", "longitude", Some(Unit::Degrees)),
            ("Longitude [deg E]", "longitude", Some(Unit::Degrees)),
            // West is not east, and down is not up.
            ("Longitude [deg W]", "longitude [deg w]", None),
            ("Z (m down)", "z (m down)", None),
            ("Easting (1000 m)", "easting (1000 m)", None),
            ("Elevation (NAVD88)", "elevation (navd88)", None),
        ] {
            assert_eq!(named(name), (bare.to_string(), unit), "{name}");
        }
        for (name, bare) in [
            ("elevation (navd88)", Some("elevation")),
            ("h (dhhn2016)", Some("h")),
            ("ost (utm32)", Some("ost")),
            ("e (utm)", Some("e")),
            ("e (epsg:25832)", Some("e")),
            ("e (etrs89 / utm zone 32n)", Some("e")),
            ("höhe (ü. nhn)", Some("höhe")),
            ("h ln02", Some("h")),
            ("altitude ngf", Some("altitude")),
            ("alt_msl", Some("alt")),
            ("x (l93)", Some("x")),
            ("y (gk m34)", Some("y")),
            ("n (satellites)", None),
            ("wgs84 latitude", None),
            ("h (antenna)", None),
            ("x (1)", None),
            ("longitude (w)", None),
            ("h local", None),
        ] {
            assert_eq!(without_reference(name), bare, "{name}");
        }
        for (name, bare) in [
            ("wgs84 latitude", Some("latitude")),
            ("gps_lat", Some("lat")),
            ("utm-ost", Some("ost")),
            ("utm32_x", Some("x")),
            ("wgs84 x", None),
            ("geoid height", None),
            ("antenna height", None),
        ] {
            assert_eq!(behind_reference(name), bare, "{name}");
        }
        for (name, bare) in [
            ("Easting [inch]", Some("easting")),
            ("H (rod)", Some("h")),
            ("Longitude [deg W]", Some("longitude")),
            ("Easting (1000 m)", Some("easting")),
            ("Elevation (NAVD88)", None),
            ("Hochwert (X)", None),
        ] {
            assert_eq!(without_other_unit(name).as_deref(), bare, "{name}");
        }
    }
}
