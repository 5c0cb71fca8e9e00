//! Control and check points that were given and of which a finished block says nothing: each with why.

use super::precision::written;
use crate::pipeline::is_place_of_orthophoto;
use crate::{
    BlockEdit, BlockRun, ControlRole, GroundControlRow, PointSource, SurveyedPoint, measurements_of_images, parse_ground_control_points,
    parse_image_measurements,
};
use std::collections::BTreeSet;

/// What became of a point without figures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Absence {
    /// It is not used: by its table, or by hand.
    Off,
    /// A place of an orthophoto that contradicted the others.
    Rejected,
    /// No image measurement names it.
    NotMeasured,
    /// Fewer than two of the image measurements of a control point fit without its coordinates: it takes no part, and nothing tests them.
    Untested,
    /// Fewer than two of the image measurements of a check point fit.
    NotDetermined,
    /// No control points place the block.
    NotPlaced,
}

impl Absence {
    /// In one word, or two.
    pub fn state(self) -> &'static str {
        match self {
            Self::Off => "off",
            Self::Rejected => "rejected",
            Self::NotMeasured => "not measured",
            Self::Untested => "untested",
            Self::NotDetermined => "not determined",
            Self::NotPlaced => "not placed",
        }
    }
}

/// A point that was given, and of which the block has no place beside the one that was surveyed.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct AbsentPoint {
    pub name: String,
    /// Absent where it is not used.
    pub role: Option<ControlRole>,
    /// As it was given.
    pub position: [f64; 3],
    pub absence: Absence,
}

/// How many points were given and are not switched off: as edits count them.
pub(super) fn given_control(run: &BlockRun) -> usize {
    let rows = run.input.control.as_ref().map(|texts| parse_ground_control_points(&texts.points).unwrap_or_default());
    rows.unwrap_or_default().iter().filter(|row| row.role.is_some()).count()
}

/// The points that were given and are not among those that a block has figures of, in the order in which they were given. Without any model there are none.
pub(super) fn absent_points(run: &BlockRun, surveyed: &[SurveyedPoint]) -> Vec<AbsentPoint> {
    let Some(model) = written(run) else { return Vec::new() };
    // A run reads the tables before it starts.
    let texts = run.input.control.as_ref();
    let mut rows = texts.map(|texts| parse_ground_control_points(&texts.points).unwrap_or_default()).unwrap_or_default();
    let marks = texts.map(|texts| parse_image_measurements(&texts.marks).unwrap_or_default()).unwrap_or_default();
    let images: Vec<String> = run.images.iter().map(|image| image.name.clone()).collect();
    // Measurements in images that are none of the block measure nothing.
    let own = measurements_of_images(marks, &images).into_iter().filter(|mark| images.contains(&mark.image));
    let mut measured: BTreeSet<String> = own.map(|mark| mark.point).collect();
    let given = given_control(run);
    let added: Vec<GroundControlRow> = run.added_control().collect();
    let by_hand = run.edits().iter().filter_map(|edit| match edit {
        BlockEdit::Measure { point: PointSource::GroundControl(point), .. } => Some(*point),
        _ => None,
    });
    measured.extend(by_hand.filter_map(|point| Some(added.get(point.checked_sub(given)?)?.name.clone())));
    rows.extend(added);
    let has_figures: BTreeSet<&str> = surveyed.iter().map(|point| point.name.as_str()).collect();
    let is_placed = model.in_system && (model.adjusted.datum.uses_control() || run.has_known_zero());
    // Edits count the points that the table does not switch off.
    let mut number = 0;
    let mut absent = Vec::new();
    for row in rows {
        let given = row.role.is_some();
        let role = row.role.and_then(|role| edited_use(run, number, role));
        number += usize::from(given);
        if has_figures.contains(row.name.as_str()) {
            continue;
        }
        let absence = match role {
            None if !given && is_place_of_orthophoto(&row.name) => Absence::Rejected,
            None => Absence::Off,
            Some(_) if !measured.contains(&row.name) => Absence::NotMeasured,
            Some(_) if !is_placed => Absence::NotPlaced,
            Some(ControlRole::Control) => Absence::Untested,
            Some(ControlRole::Check) => Absence::NotDetermined,
        };
        absent.push(AbsentPoint { name: row.name, role, position: row.position, absence });
    }
    absent
}

/// What a point is for after the edits of its block.
fn edited_use(run: &BlockRun, point: usize, given: ControlRole) -> Option<ControlRole> {
    let source = PointSource::GroundControl(point);
    let (mut role, mut is_used) = (given, true);
    for edit in run.edits() {
        match edit {
            BlockEdit::SetUse { point: of, role: chosen } if *of == point => (role, is_used) = (chosen.unwrap_or(role), chosen.is_some()),
            BlockEdit::RejectPoints { points } if points.contains(&source) => is_used = false,
            BlockEdit::RestorePoints { points } if points.contains(&source) => is_used = true,
            _ => {}
        }
    }
    is_used.then_some(role)
}
