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
            None if upper.starts_with("EPSG:") || upper.starts_with("+PROJ") => words.clone(),
            None => return None,
        };
        Some(Self { crs, words: shorten(&words), line: *line })
    }

    /// Refuses a table that begins so: those of OpenDroneMap have points and their measurements in one.
    pub(super) fn refuse_in(records: &Records) -> Result<(), Error> {
        Self::of(records).map_or(Ok(()), |found| refuse(Refusal::SystemLine { input: records.input(), words: found.words }))
    }
}

/// The code of `32N`.
fn utm(zone: &str) -> Option<String> {
    let (half, first) = ZONES.into_iter().find(|(half, _)| zone.ends_with(*half))?;
    let zone: u32 = zone.strip_suffix(half)?.trim().parse().ok().filter(|zone| (1..=LAST_ZONE).contains(zone))?;
    Some(format!("EPSG:{}", first + zone))
}
