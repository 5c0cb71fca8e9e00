//! Names of columns in tables of other programs: in capitals or not, with their words joined in many ways and a unit behind them.

use crate::text::{NumberedRecord, shorten};
use csv::StringRecord;
use std::collections::BTreeSet;

/// Units of length that tables have, in m.
pub(crate) const LENGTHS: [(&str, f64); 6] =
    [("mm", 0.001), ("cm", 0.01), ("m", 1.0), ("ft", 0.3048), ("us-ft", 1200.0 / 3937.0), ("km", 1000.0)];

/// The names of the column of images here and in other programs, in letters alone. The first of them that a table has is read.
pub(super) const IMAGES: &str = "image photo picture sourcefile filename imagename file photoname imagefile imagelabel img bild bildname foto bilddatei dateiname datei imagen immagine imagem nomdel'image nomdel’image nomdelimage nomimage الصورة صورة اسمالصورة";

/// The columns of a table that are not read.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct UnreadColumns {
    /// Those that say nothing here: by their names, or `#7` for the seventh where it has none.
    pub unknown: Vec<String>,
    /// Those that give what another column gives, each with the one that is read: `up (z)`.
    pub doubled: Vec<String>,
}

impl UnreadColumns {
    /// Of some rows, beside the columns that are read; one without a name counts where any of its cells holds something. `head`: the line of names, where
    /// there is one. `twin`: of a column, the one that is read and gives the same.
    pub(super) fn of(
        rows: &[NumberedRecord],
        head: Option<&StringRecord>,
        read: &BTreeSet<usize>,
        twin: impl Fn(usize) -> Option<usize>,
    ) -> Self {
        let width = rows.iter().map(|(_, record)| record).chain(head).map(StringRecord::len).max().unwrap_or(0);
        let mut unread = Self::default();
        for column in (0..width).filter(|column| !read.contains(column)) {
            let name = |column: usize| head.and_then(|head| head.get(column)).filter(|name| !name.is_empty());
            let is_empty = || rows.iter().all(|(_, record)| record.get(column).unwrap_or("").is_empty());
            match (name(column), twin(column).and_then(name)) {
                (Some(name), Some(twin)) => unread.doubled.push(format!("{} ({})", shorten(name), shorten(twin))),
                (Some(name), None) => unread.unknown.push(shorten(name)),
                (None, _) if !is_empty() => unread.unknown.push(format!("#{}", column + 1)),
                (None, _) => {}
            }
        }
        unread
    }
}

/// A name in small letters, and the unit behind it as it is written there: `easting` and `ft` of `Easting (ft)`, of `easting [ft]` and of `easting_ft`.
/// `units`: those that are known, in small letters.
pub(super) fn without_unit<'a>(name: &str, units: &[&'a str]) -> (String, Option<&'a str>) {
    let small = name.trim().to_lowercase();
    let cut = |unit: &'a str| {
        let bare = match small.strip_suffix([')', ']']) {
            Some(inner) => inner.trim_end().strip_suffix(unit)?.trim_end().strip_suffix(['(', '['])?,
            None => small.strip_suffix(unit)?.strip_suffix(['_', ' '])?,
        };
        Some((bare.trim_end().to_string(), Some(unit)))
    };
    units.iter().find_map(|unit| cut(unit)).unwrap_or_else(|| (small.clone(), None))
}

/// A name of letters alone, without the sign for a number behind it.
pub(super) fn letters(name: &str) -> String {
    let letters: String = name.chars().filter(|letter| !matches!(letter, '_' | '-' | ' ' | '.' | '/')).collect();
    match letters.strip_suffix('#').filter(|bare| !bare.is_empty()) {
        Some(bare) => bare.into(),
        None => letters,
    }
}

/// Some further names of a column than the first of these, which blanks separate, for a message.
pub(super) fn others(names: &str) -> String {
    const MOST: usize = 10;
    names.split(' ').skip(1).take(MOST).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_unit_behind_a_name_is_told_from_its_letters() {
        let units = ["us-ft", "ft", "m"];
        for (name, bare, unit) in [
            ("Easting (ft)", "easting", Some("ft")),
            (" X [ us-ft ]", "x", Some("us-ft")),
            ("height_m", "height", Some("m")),
            ("Z m", "z", Some("m")),
            ("rmsem", "rmsem", None),
            ("m", "m", None),
            ("Height (cm)", "height (cm)", None),
        ] {
            assert_eq!(without_unit(name, &units), (bare.to_string(), unit), "{name}");
        }
        assert_eq!(["point no./id", "pt #", "#"].map(letters), ["pointnoid", "pt", "#"]);
    }
}
