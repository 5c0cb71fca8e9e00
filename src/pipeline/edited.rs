//! A finished block with edits by hand: the block as it was found, and a new adjustment by what the edits leave.

use super::added_control::added_control;
use super::focal_change::tell_after_edits;
use super::linked_places::linked_places;
use super::mistakes::{explain_control, tell_elsewhere};
use super::place_names::{is_place_of_orthophoto, own_control};
use super::points::reconstruction_options;
use super::state::{describe, describe_with, known_images};
use super::stated_errors::tell_stated_errors;
use super::{BlockRun, EditedRun, OnOrthophoto};
use crate::editing::{BlockEdit, FoundBlock, edited_model};
use crate::error::refuse;
use crate::reconstruction::PLACING;
use crate::{
    BlockWarning, Error, GroundControlRow, Input, ObservationVerdict, PointSource, ReconstructedModel, ReconstructionOptions, Refusal,
    Remark,
};
use std::collections::BTreeSet;
use std::mem::discriminant;

impl BlockRun {
    /// The edits that were applied to the block as it was found.
    pub fn edits(&self) -> &[BlockEdit] {
        self.edited.as_ref().map_or(&[], |edited| &edited.edits)
    }

    /// How many edits each step has: those of a step are undone together.
    pub fn edit_steps(&self) -> Vec<usize> {
        match &self.edited {
            Some(edited) if edited.steps.is_empty() => vec![1; edited.edits.len()],
            Some(edited) => edited.steps.clone(),
            None => Vec::new(),
        }
    }

    /// The same block, whose edits were made in steps of so many.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for steps of no edits, and for those that have more or fewer together than the block.
    pub fn in_steps(mut self, steps: &[usize]) -> Result<Self, Error> {
        check_steps(self.edits(), steps)?;
        if let Some(edited) = &mut self.edited {
            edited.steps = if steps.iter().all(|edits| *edits == 1) { Vec::new() } else { steps.to_vec() };
        }
        Ok(self)
    }

    /// The block as it was found with the edits of another one, in its steps.
    ///
    /// # Errors
    /// As [`with_edits`](Self::with_edits).
    pub(super) fn with_edits_of(&self, other: &Self) -> Result<Self, Error> {
        self.with_edits(other.edits())?.in_steps(&other.edit_steps())
    }

    /// The block as it was found, without any edits.
    #[must_use]
    pub fn found(&self) -> Self {
        let Some(found) = &self.edited else { return self.clone() };
        let mut remarks = self.remarks.clone();
        remarks.retain(|remark| *remark != Remark::UnsupportedEdits && !found.remarks.contains(remark));
        let orthophoto = match (&found.orthophoto, &self.orthophoto) {
            (None, Some(OnOrthophoto::ByHand { .. })) => None,
            (None, other) => other.clone(),
            (before, _) => before.clone(),
        };
        Self {
            reconstruction: Ok(found.reconstruction.clone()),
            model: found.model.clone(),
            edited: None,
            remarks,
            orthophoto,
            ..self.clone()
        }
    }

    /// The block as it was found with these edits, whatever edits it has: its largest model is adjusted anew by the observations that they
    /// leave. The same edits give the same block; none give the block as it was found.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for a block that is not oriented, an edit of what does not exist, a place outside its image, and a new point
    /// whose rays do not meet; the errors of [`adjust_block`](crate::adjust_block) for a block that falls apart.
    pub fn with_edits(&self, edits: &[BlockEdit]) -> Result<Self, Error> {
        let found = self.found();
        let Some(model) = found.reconstruction.as_ref().ok().and_then(|assembly| assembly.models.first()) else {
            return if edits.is_empty() { Ok(found) } else { refuse(Refusal::BlockNotOriented) };
        };
        if edits.is_empty() {
            return Ok(found);
        }
        found.check_added(edits)?;
        let is_unsupported = model.lacks_support();
        let input = found.input.clone().checked(found.geoid.as_ref())?;
        let (as_found, _) = describe(&input, &found.images, &found.cameras)?;
        let further: Vec<GroundControlRow> = added_control(edits).collect();
        let (description, _) = describe_with(&input, &further, &found.images, &found.cameras)?;
        // Places of an orthophoto were judged when the block was linked to it.
        let linked = match &found.orthophoto {
            Some(OnOrthophoto::Linked { epsg, .. }) => Some(*epsg),
            Some(OnOrthophoto::ByHand { .. } | OnOrthophoto::NotLinked { .. }) | None => None,
        };
        let tested_control = linked.map(|_| own_control(&as_found));
        let options =
            ReconstructionOptions { tested_control, found_points: found.found_points(), ..reconstruction_options(&input.settings) };
        let alone = known_images(&input, &found.images, |_| true);
        let in_crs = input.settings.placing.crs.is_some();
        let block = FoundBlock {
            model,
            as_found: &as_found,
            description: &description,
            // Positions on the earth alone place a block elsewhere than in the system of coordinates that are not on it.
            is_in_their_system: model.in_system && (in_crs || model.adjusted.datum.uses_control()),
            alone: &alone,
            connections: &found.connections,
        };
        let edited = edited_model(&block, edits, &options)?;
        let confidence = found.confidences();
        let before = found.reconstruction.clone().unwrap_or_default();
        let mut assembly = before.clone();
        if let Some(origin) = edited.brought_to {
            assembly.origin = origin;
            // Other models lie in the system that the block had.
            for other in &mut assembly.models[1..] {
                (other.in_system, other.surveyed) = (false, Vec::new());
            }
        }
        let mut model = edited.model;
        if !model.adjusted.datum.uses_control() && !found.has_known_zero() {
            // Their heights count from elsewhere than those of the block.
            model.surveyed.clear();
        }
        explain_control(&mut model, assembly.origin, &input, options.adjustment.limit());
        tell_elsewhere(&mut model, &as_found, &found.unknown_images, &found.images, &input);
        tell_stated_errors(&mut model, &description, &found.images, &input);
        tell_after_edits(&mut model, &before.models[0], &description);
        if linked.is_some() {
            // Edits bring no block to where its positions are, and heights of the ground to where they belong.
            let stays = |told: &&BlockWarning| told.is_of_orthophoto();
            model.warnings.extend(before.models[0].warnings.iter().filter(stays).cloned());
        }
        let placed = match linked {
            Some(epsg) => Some(linked_places(&model, &description, &input, epsg)),
            None => placed_by_hand(&model, edits, as_found.control.len(), in_crs),
        };
        assembly.models[0] = model;
        assembly.unoriented.extend(edited.unoriented);
        assembly.unoriented.sort_by_key(|unoriented| unoriented.image);
        let written =
            assembly.block_model_with(0, &description, found.found_points(), |point| confidence.get(&point).copied().unwrap_or(1.0))?;
        let said = remarks_of_places(edits, &found.remarks);
        let mut remarks = [found.remarks.as_slice(), said.as_slice()].concat();
        let orthophoto = placed.or_else(|| found.orthophoto.clone());
        let record = EditedRun {
            edits: edits.to_vec(),
            steps: Vec::new(),
            reconstruction: before,
            model: found.model.clone(),
            orthophoto: found.orthophoto.clone().filter(|before| orthophoto.as_ref() != Some(before)),
            remarks: said,
        };
        remarks.extend(is_unsupported.then_some(Remark::UnsupportedEdits));
        Ok(Self { reconstruction: Ok(assembly), model: written, edited: Some(Box::new(record)), remarks, orthophoto, ..found })
    }
}

/// Refuses steps that do not have all edits, each one or more.
pub(crate) fn check_steps(edits: &[BlockEdit], steps: &[usize]) -> Result<(), Error> {
    let all = steps.iter().fold(0, |sum: usize, edits| sum.saturating_add(*edits));
    if all != edits.len() {
        return refuse(Refusal::Count { input: Input::EditsOfSteps, got: all, wanted: edits.len() });
    }
    if steps.contains(&0) { refuse(Refusal::StepWithoutEdits) } else { Ok(()) }
}

/// What is to be said of the places of an orthophoto that edits add, of each kind once: not what was said of the orthophoto before.
fn remarks_of_places(edits: &[BlockEdit], before: &[Remark]) -> Vec<Remark> {
    let of_edit = |edit: &BlockEdit| match edit {
        BlockEdit::AddControl { remarks, .. } => remarks.clone(),
        _ => Vec::new(),
    };
    let mut said: Vec<Remark> = Vec::new();
    for remark in edits.iter().flat_map(of_edit).filter(Remark::is_of_orthophoto) {
        if !before.iter().chain(&said).any(|other| discriminant(other) == discriminant(&remark)) {
            said.push(remark);
        }
    }
    said
}

/// What places of an orthophoto that were measured by hand made of a block that was not linked to it; `None` where they are too few to place it.
/// `given`: how many surveyed points it was found with.
fn placed_by_hand(model: &ReconstructedModel, edits: &[BlockEdit], given: usize, in_crs: bool) -> Option<OnOrthophoto> {
    let names: Vec<String> = added_control(edits).map(|row| row.name).collect();
    let is_place = |source: &PointSource| match source {
        PointSource::GroundControl(control) => {
            control.checked_sub(given).and_then(|added| names.get(added)).is_some_and(|name| is_place_of_orthophoto(name))
        }
        PointSource::TiePoint(_) | PointSource::Manual(_) => false,
    };
    let block = &model.adjusted.block;
    let places: BTreeSet<usize> =
        block.control.iter().map(|control| control.point).filter(|point| is_place(&model.points[*point])).collect();
    if !model.in_system || places.len() < PLACING {
        return None;
    }
    let rays = block.rays.iter().zip(&model.adjusted.rays);
    let seeing = rays.filter(|(ray, statistics)| statistics.verdict == ObservationVerdict::Accepted && places.contains(&ray.point));
    let linked = seeing.map(|(ray, _)| ray.image).collect::<BTreeSet<usize>>().len();
    let epsg = edits.iter().find_map(|edit| match edit {
        BlockEdit::AddControl { epsg, .. } => *epsg,
        _ => None,
    });
    Some(OnOrthophoto::ByHand { linked, images: model.images.len(), points: places.len(), in_crs, epsg })
}
