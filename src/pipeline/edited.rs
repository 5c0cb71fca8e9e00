//! A finished block with edits by hand: the block as it was found, and a new adjustment by what the edits leave.

use super::ground::own_control;
use super::mistakes::explain_control;
use super::points::reconstruction_options;
use super::state::{describe, known_images};
use super::{BlockRun, EditedRun, OnOrthophoto, Remark};
use crate::editing::{BlockEdit, FoundBlock, edited_model};
use crate::error::refuse;
use crate::{Error, ReconstructionOptions, Refusal};

impl BlockRun {
    /// The edits that were applied to the block as it was found.
    pub fn edits(&self) -> &[BlockEdit] {
        self.edited.as_ref().map_or(&[], |edited| &edited.edits)
    }

    /// The block as it was found, without any edits.
    #[must_use]
    pub fn found(&self) -> Self {
        let Some(found) = &self.edited else { return self.clone() };
        let mut remarks = self.remarks.clone();
        remarks.retain(|remark| *remark != Remark::UnsupportedEdits);
        Self { reconstruction: Ok(found.reconstruction.clone()), model: found.model.clone(), edited: None, remarks, ..self.clone() }
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
        let is_unsupported = model.lacks_support();
        let input = found.input.clone().checked(found.geoid.as_ref())?;
        let (description, _) = describe(&input, &found.images, &found.cameras)?;
        // Places of an orthophoto were judged when the block was linked to it.
        let is_linked = matches!(found.orthophoto, Some(OnOrthophoto::Linked { .. }));
        let tested_control = is_linked.then(|| own_control(&description));
        let options = ReconstructionOptions { tested_control, ..reconstruction_options(&input.settings) };
        let alone = known_images(&input, &found.images, true);
        let block = FoundBlock { model, description: &description, alone: &alone, connections: &found.connections };
        let (mut model, gone) = edited_model(&block, edits, &options)?;
        let confidence = found.confidences();
        let before = found.reconstruction.clone().unwrap_or_default();
        explain_control(&mut model, before.origin, &input, options.adjustment.limit());
        let mut assembly = before.clone();
        assembly.models[0] = model;
        assembly.unoriented.extend(gone);
        assembly.unoriented.sort_by_key(|unoriented| unoriented.image);
        let written = assembly.block_model_with(0, &description, |point| confidence.get(&point).copied().unwrap_or(1.0))?;
        let edited = EditedRun { edits: edits.to_vec(), reconstruction: before, model: found.model.clone() };
        let mut remarks = found.remarks.clone();
        remarks.extend(is_unsupported.then_some(Remark::UnsupportedEdits));
        Ok(Self { reconstruction: Ok(assembly), model: written, edited: Some(Box::new(edited)), remarks, ..found })
    }
}
