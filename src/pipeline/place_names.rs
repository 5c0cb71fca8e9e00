//! Places of an orthophoto among the ground control points of a block, which their names tell from those that were given.

use crate::BlockDescription;

/// What names of these points begin with.
pub(super) const PLACE_NAME: &str = "orthophoto_";

/// How many control points of a block that is linked to an orthophoto were given: the first of all.
pub(super) fn own_control(description: &BlockDescription) -> usize {
    description.control.iter().take_while(|point| !is_place_of_orthophoto(&point.name)).count()
}

/// Whether a control point is a place of an orthophoto: no other may be named so.
pub(crate) fn is_place_of_orthophoto(name: &str) -> bool {
    name.starts_with(PLACE_NAME)
}

/// Whether a control point is a place that was found on an orthophoto, not one that was measured by hand.
pub(super) fn is_found_place(name: &str) -> bool {
    name.strip_prefix(PLACE_NAME).is_some_and(|number| !number.is_empty() && number.bytes().all(|digit| digit.is_ascii_digit()))
}

/// The name of a place of an orthophoto that was measured by hand, which no other has.
pub(crate) fn name_by_hand(number: usize) -> String {
    format!("{PLACE_NAME}hand_{number}")
}
