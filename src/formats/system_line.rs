//! The line by which tables of OpenDroneMap begin: the coordinate system of what stands below.

use crate::error::refuse;
use crate::text::{Records, shorten};
use crate::{Error, Refusal};

/// A coordinate system that a table names for itself.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct SystemLine {
    /// By its code or as PROJ text.
    pub crs: String,
    /// As the table has it.
    pub words: String,
    pub line: usize,
}

/// UTM on WGS 84, north and south.
const ZONES: [(char, u32); 2] = [('N', 32_600), ('S', 32_700)];
const LAST_ZONE: u32 = 60;

impl SystemLine {
    /// That of the first record, where it is one.
    pub(super) fn of(records: &Records) -> Option<Self> {
        let (line, first) = records.rows.first()?;
        let words = first.iter().collect::<Vec<_>>().join(" ");
        let upper = words.to_uppercase();
        let crs = match upper.strip_prefix("WGS84 UTM") {
            Some(zone) => utm(zone.trim())?,
            None if upper.starts_with("EPSG:") => code(&upper).unwrap_or_else(|| words.trim().to_string()),
            None if upper.starts_with("+PROJ") => words.trim().to_string(),
            None => return None,
        };
        Some(Self { crs, words: shorten(words.trim()), line: *line })
    }

    /// Refuses a table without names of columns that begins so: those of OpenDroneMap have points and their measurements in one.
    pub(super) fn refuse_in(records: &Records) -> Result<(), Error> {
        Self::of(records).map_or(Ok(()), |found| refuse(Refusal::SystemLine { input: records.input(), words: found.words }))
    }
}

/// The code that stands before the name of a system, as in `EPSG:25832 (ETRS89 / UTM 32N)`.
fn code(upper: &str) -> Option<String> {
    let behind = upper.strip_prefix("EPSG:")?.trim_start();
    let length = behind.find(|sign: char| !sign.is_ascii_digit() && sign != '+').unwrap_or(behind.len());
    let is_whole = !behind[length..].starts_with(char::is_alphanumeric);
    (length > 0 && is_whole).then(|| format!("EPSG:{}", &behind[..length]))
}

/// The code of `32N`.
fn utm(zone: &str) -> Option<String> {
    let (half, first) = ZONES.into_iter().find(|(half, _)| zone.ends_with(*half))?;
    let zone: u32 = zone.strip_suffix(half)?.trim().parse().ok().filter(|zone| (1..=LAST_ZONE).contains(zone))?;
    Some(format!("EPSG:{}", first + zone))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Input;
    use crate::text::records;

    #[test]
    fn a_code_is_told_from_the_name_behind_it() {
        for (line, crs) in [
            ("EPSG:25832", Some("EPSG:25832")),
            ("EPSG:25832;;;", Some("EPSG:25832")),
            ("EPSG:25832 (ETRS89 / UTM 32N)", Some("EPSG:25832")),
            ("epsg: 25832+7837", Some("EPSG:25832+7837")),
            ("EPSG:25832x", Some("EPSG:25832x")),
            ("+proj=utm +zone=32", Some("+proj=utm +zone=32")),
            ("WGS84 UTM 32N", Some("EPSG:32632")),
            ("name,x,y,z", None),
        ] {
            let found = SystemLine::of(&records(Input::ControlTable, line).unwrap());
            assert_eq!(found.map(|found| found.crs).as_deref(), crs, "{line}");
        }
    }
}
