//! Surveyed points that edits by hand add to a block, as a table of ground control points would have them.

use super::BlockRun;
use super::control_point::control_point;
use crate::editing::in_edit;
use crate::error::refuse;
use crate::{BlockEdit, ControlRole, Error, GroundControlRow, Refusal, parse_ground_control_points};
use std::collections::BTreeSet;

/// The points that these edits add, in their order.
pub(crate) fn added_control(edits: &[BlockEdit]) -> impl Iterator<Item = GroundControlRow> {
    edits.iter().filter_map(added_row)
}

fn added_row(edit: &BlockEdit) -> Option<GroundControlRow> {
    match edit {
        BlockEdit::AddControl { name, position, standard_errors, sigma_px, role, .. } => Some(GroundControlRow {
            name: name.clone(),
            position: *position,
            standard_errors: *standard_errors,
            role: Some(*role),
            sigma_px: *sigma_px,
        }),
        _ => None,
    }
}

impl BlockRun {
    /// Surveyed points that were added by hand.
    pub(crate) fn added_control(&self) -> impl Iterator<Item = GroundControlRow> {
        added_control(self.edits())
    }

    /// Refuses surveyed points of edits whose names are taken or cannot stand in a table, and coordinates and standard errors that are none, each by its edit.
    pub(super) fn check_added(&self, edits: &[BlockEdit]) -> Result<(), Error> {
        // Most edits add none.
        if added_control(edits).next().is_none() {
            return Ok(());
        }
        let given = self.input.control.as_ref().map(|texts| parse_ground_control_points(&texts.points)).transpose()?;
        let mut names: BTreeSet<String> = given.unwrap_or_default().into_iter().map(|row| row.name).collect();
        for (number, edit) in (1..).zip(edits) {
            let Some(row) = added_row(edit) else { continue };
            let is_own = names.insert(row.name.clone());
            self.check_row(&row, is_own).map_err(|error| in_edit(error, number))?;
        }
        Ok(())
    }

    fn check_row(&self, row: &GroundControlRow, is_own: bool) -> Result<(), Error> {
        let name = &row.name;
        if name.trim().is_empty() || name.chars().any(char::is_control) || !is_own {
            return refuse(Refusal::AddedControlName { name: format!("{name:?}") });
        }
        if let Some(errors) = row.standard_errors.filter(|errors| !errors.iter().all(|error| error.is_finite() && *error > 0.0)) {
            return refuse(Refusal::AddedControlErrors { errors: format!("{errors:?}"), name: name.clone() });
        }
        // As it was given: where it lies on the earth is found with the block.
        control_point(row, ControlRole::Control, &self.input.settings.placing, None)?.check_values()
    }
}
