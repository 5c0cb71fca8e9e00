//! Surveyed points that edits by hand add to a block, as a table of ground control points would have them.

use super::BlockRun;
use crate::error::refuse;
use crate::{BlockEdit, Error, GroundControlRow, Refusal, parse_ground_control_points};
use std::collections::BTreeSet;

/// The points that these edits add, in their order.
pub(crate) fn added_control(edits: &[BlockEdit]) -> impl Iterator<Item = GroundControlRow> {
    edits.iter().filter_map(|edit| match edit {
        BlockEdit::AddControl { name, position, standard_errors, sigma_px, role, .. } => Some(GroundControlRow {
            name: name.clone(),
            position: *position,
            standard_errors: *standard_errors,
            role: Some(*role),
            sigma_px: *sigma_px,
        }),
        _ => None,
    })
}

impl BlockRun {
    /// Surveyed points that were added by hand.
    pub(crate) fn added_control(&self) -> impl Iterator<Item = GroundControlRow> {
        added_control(self.edits())
    }

    /// Refuses surveyed points of edits whose names are taken or cannot stand in a table, and standard errors that are none.
    pub(super) fn check_added(&self, edits: &[BlockEdit]) -> Result<(), Error> {
        // Most edits add none.
        if added_control(edits).next().is_none() {
            return Ok(());
        }
        let given = self.input.control.as_ref().map(|texts| parse_ground_control_points(&texts.points)).transpose()?;
        let mut names: BTreeSet<String> = given.unwrap_or_default().into_iter().map(|row| row.name).collect();
        for (number, edit) in (1..).zip(edits) {
            let BlockEdit::AddControl { name, standard_errors, .. } = edit else { continue };
            let refusal = if name.trim().is_empty() || name.chars().any(char::is_control) || !names.insert(name.clone()) {
                Refusal::AddedControlName { name: format!("{name:?}") }
            } else if let Some(errors) = standard_errors.filter(|errors| !errors.iter().all(|error| error.is_finite() && *error > 0.0)) {
                Refusal::AddedControlErrors { errors: format!("{errors:?}"), name: name.clone() }
            } else {
                continue;
            };
            return refuse(Refusal::InEdit { edit: number, refusal: Box::new(refusal) });
        }
        Ok(())
    }
}
