//! The matches of all pairs are joined to tie points, few of them are chosen, and the block is oriented: the run computes this itself.

use super::JoinedPoints;
use super::job::{Done, StageName, Work};
use super::mistakes::{explain_control, tell_elsewhere};
use super::stage::{Request, Stage};
use super::state::State;
use super::stated_errors::tell_stated_errors;
use crate::{
    AdjustmentOptions, BlockMatches, BlockModel, BlockSettings, Error, Failure, Reconstruction, ReconstructionOptions, TiePoints,
    reconstruct_block, select_points, shared_points, tie_points,
};

/// Which of the computations a stage is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Own {
    Points,
    Orientation,
}

/// A computation of the run itself, in one piece.
pub(super) struct OwnStage {
    own: Own,
    next: usize,
}

impl OwnStage {
    pub fn new(own: Own) -> Self {
        Self { own, next: 0 }
    }
}

impl Stage for OwnStage {
    fn name(&self) -> StageName {
        match self.own {
            Own::Points => StageName::Points,
            Own::Orientation => StageName::Orientation,
        }
    }

    fn total(&self) -> usize {
        1
    }

    fn next(&mut self, _: &State) -> Option<Request> {
        Request::following(&mut self.next, 1)
    }

    fn prepare(&mut self, _: usize, _: &[String], _: &State) -> Result<Work, Error> {
        Ok(Work { key: None, task: None, records: Vec::new(), input: None })
    }

    fn accept(&mut self, _: usize, _: Vec<u8>, state: &mut State) -> Result<Option<Done>, Error> {
        match self.own {
            Own::Points => join(state)?,
            Own::Orientation => orient(state)?,
        }
        Ok(Some(Done::of(String::new(), None)))
    }

    fn fail(&mut self, _: usize, failure: Failure, _: &mut State) -> Result<Done, Error> {
        Err(failure.of_all())
    }
}

fn join(state: &mut State) -> Result<(), Error> {
    let counts: Vec<u32> = state.positions.iter().map(|positions| positions.len() as u32).collect();
    let mut matches = BlockMatches::new(&counts)?;
    for pair in state.pairs.iter_mut().filter(|pair| !pair.matches.is_empty()) {
        matches.add_pair(pair.connection.images, &std::mem::take(&mut pair.matches))?;
    }
    let (points, join) = tie_points(&matches, &state.features(), &state.input.settings.block)?;
    let shared = shared_points(&points, state.images.len());
    state.joined = Some(JoinedPoints { join, count: points.len(), rays: points.ray_count(), histogram: histogram(&points), shared });
    state.chosen = select_points(&points, &state.features(), &state.input.settings.selection)?.points;
    state.points = points;
    Ok(())
}

/// How many points have 0, 1, 2, … rays.
fn histogram(points: &TiePoints) -> Vec<u32> {
    let mut counts: Vec<u32> = Vec::new();
    for rays in points.iter() {
        counts.resize(counts.len().max(rays.len() + 1), 0);
        counts[rays.len()] += 1;
    }
    counts
}

/// How a block of these settings is oriented.
pub(super) fn reconstruction_options(settings: &BlockSettings) -> ReconstructionOptions {
    let options = ReconstructionOptions::default();
    let adjustment = AdjustmentOptions {
        shared_errors: settings.shared_errors(),
        variance_components: settings.placing.variance_components,
        gnss_errors: settings.placing.gnss_errors,
        gnss_lever_arm: settings.placing.gnss_lever_arm,
        ..options.adjustment
    };
    ReconstructionOptions {
        selection: Some(settings.selection.clone()),
        mark_sigma_px: settings.placing.mark_sigma_px,
        adjustment,
        ..options
    }
}

/// A block whose images cannot be oriented keeps its points all the same.
fn orient(state: &mut State) -> Result<(), Error> {
    let options = reconstruction_options(&state.input.settings);
    let features = state.features();
    let found = reconstruct_block(&state.description, &state.points, &features, &options).and_then(|mut reconstruction| {
        let origin = reconstruction.origin;
        for model in &mut reconstruction.models {
            explain_control(model, origin, &state.input, options.adjustment.limit());
            tell_elsewhere(model, &state.description, &state.unknown_images, &state.images, &state.input);
            tell_stated_errors(model, &state.description, &state.images, &state.input);
        }
        let found = state.joined.as_ref().map_or(0, |joined| joined.count);
        let confidence = |point: u32| f64::from(state.points.confidence(point as usize));
        let written = reconstruction.models.first().map(|_| reconstruction.block_model_with(0, &state.description, found, confidence));
        let model = written.transpose()?;
        Ok((reconstruction, model))
    });
    let (reconstruction, model): (Result<Reconstruction, Error>, Option<BlockModel>) = match found {
        Ok((reconstruction, model)) => (Ok(reconstruction), model),
        Err(error) if error.is_usage() => return Err(error),
        Err(error) => (Err(error), None),
    };
    let unoriented = || {
        let mut model = state.description.to_model();
        model.add_points(&state.points, &state.chosen, &features)?;
        model.check()?;
        Ok(model)
    };
    let model = model.map_or_else(unoriented, Ok)?;
    (state.model, state.reconstruction) = (model, Some(reconstruction));
    Ok(())
}
