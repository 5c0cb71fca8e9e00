//! Columns that say on which side a coordinate lies: `GPSLatitudeRef`, `Latitude hemisphere` or `N/S`.

use super::column_names::{Column, Coordinates, coordinates_of, meaning_of};
use super::columns::{letters, without_unit};
use super::hemispheres::Axis;
use csv::StringRecord;

/// The column of the side of a coordinate, where a line names one.
pub(super) fn side_column(head: &StringRecord, axis: Axis) -> Option<usize> {
    let letters_of_sides = match axis {
        Axis::Longitude => "e/w",
        Axis::Latitude => "n/s",
        Axis::Height => "",
    };
    let wanted = match axis {
        Axis::Longitude => Column::X,
        Axis::Latitude => Column::Y,
        Axis::Height => Column::Z,
    };
    head.iter().position(|name| {
        let is_of_axis =
            |of: &str| coordinates_of(of) == Coordinates::Geographic && meaning_of(of).is_some_and(|(column, _)| column == wanted);
        match side_of(name) {
            // Other references of heights are surfaces.
            Some(of) if axis == Axis::Height => of.ends_with("altitude"),
            Some(of) => is_of_axis(&of),
            None => name.trim().to_lowercase() == letters_of_sides,
        }
    })
}

/// The coordinate whose side a name says, in letters.
fn side_of(name: &str) -> Option<String> {
    let plain = letters(&without_unit(name, &[]).0);
    ["ref", "hemisphere", "hem"].iter().find_map(|word| plain.strip_suffix(word).map(String::from))
}

/// Whether the side that a name says is that of this coordinate.
pub(super) fn is_side_of(name: &str, coordinate: &str) -> bool {
    let plain = letters(&without_unit(coordinate, &["m"]).0);
    side_of(name).is_some_and(|of| of.ends_with(&plain) || plain.ends_with(&of))
}
