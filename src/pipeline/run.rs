//! The run of a block as a state machine: it hands out jobs and takes their bytes.

use super::geoid::GeoidStage;
use super::images::Images;
use super::input::RunInput;
use super::job::{Job, News, Step, Work};
use super::likeness::Likeness;
use super::pairs::Pairs;
use super::points::{Own, OwnStage};
use super::records::is_whole;
use super::refinement::Refinement;
use super::stage::Stage;
use super::state::State;
use super::windows::WindowStage;
use super::{BlockRun, SkippedImage};
use crate::error::refuse;
use crate::{Error, Failure, Interruption, PairRule, RefinementMethod, Refusal, SelectOptions, choose_pairs, select_points};
use std::collections::BTreeMap;

/// The run of a block. It reads no file, starts no thread and knows no clock: the host does its jobs, any number at the same time and in
/// any order, and the result is the same.
///
/// For each [`Job`] of [`next`](Self::next) the host reads the files and asks [`prepare`](Self::prepare) for the [`Work`]. Has the work a
/// key, and the host a record of that key, it hands that to [`found`](Self::found). Otherwise it calls [`execute`](super::execute) with the
/// task, or, without a task, takes the only record, or no bytes at all; keeps what came of it under the key, where there is one; and hands
/// it to [`complete`](Self::complete). What could not be done it says to [`failed`](Self::failed).
pub struct Run {
    state: State,
    phase: Phase,
    /// Items of the jobs that were handed out, by their ids.
    underway: BTreeMap<u32, usize>,
    next_id: u32,
    done: usize,
    found: usize,
    news: Vec<News>,
}

/// The stages, in their order.
enum Phase {
    Images(Images),
    Geoid(GeoidStage),
    Likeness(Likeness),
    Pairs(Pairs),
    Own(Own, OwnStage),
    Windows(WindowStage),
    Refinement(Box<Refinement>),
    Over,
}

impl Phase {
    fn own(own: Own) -> Self {
        Self::Own(own, OwnStage::new(own))
    }

    fn stage(&mut self) -> Option<&mut dyn Stage> {
        Some(match self {
            Self::Images(stage) => stage,
            Self::Geoid(stage) => stage,
            Self::Likeness(stage) => stage,
            Self::Pairs(stage) => stage,
            Self::Own(_, stage) => stage,
            Self::Windows(stage) => stage,
            Self::Refinement(stage) => stage.as_mut(),
            Self::Over => return None,
        })
    }
}

impl Run {
    /// A run of which nothing is done.
    ///
    /// # Errors
    /// Whatever can be refused before the images are read: [`Error::InvalidOption`] for the settings, [`Error::InvalidJson`] for the file
    /// of cameras, [`Error::InvalidInput`] for names, masks, cameras, ground control points and image measurements.
    pub fn new(input: RunInput) -> Result<Self, Error> {
        if input.images.is_empty() {
            return refuse(Refusal::FewImages { read: 0, given: 0, first: None, failure: None });
        }
        let state = State::new(RunInput { refuse_stray_masks: false, ..input.clone() }, input.checked(None)?);
        let phase = Phase::Images(Images::new(&state));
        let mut run = Self { state, phase, underway: BTreeMap::new(), next_id: 0, done: 0, found: 0, news: Vec::new() };
        run.step(String::new());
        Ok(run)
    }

    /// Jobs that can be done now, at most so many; none while others have to be done first. Once all stages are done, and no job is under
    /// way, there are no more.
    ///
    /// # Errors
    /// What ends the run between two stages, as too few images that could be read.
    pub fn next(&mut self, most: usize) -> Result<Vec<Job>, Error> {
        let mut jobs = Vec::new();
        while jobs.len() < most {
            let Some(stage) = self.phase.stage() else { break };
            match stage.next(&self.state) {
                Some(request) => {
                    self.underway.insert(self.next_id, request.item);
                    jobs.push(Job { id: self.next_id, files: request.files });
                    self.next_id += 1;
                }
                None if self.underway.is_empty() => self.advance()?,
                None => break,
            }
        }
        Ok(jobs)
    }

    /// What is to be done for a job. `digests`: of its files, SHA-256 in hexadecimal digits.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for a job that is not under way; [`Error::Interrupted`] for a file that was changed.
    pub fn prepare(&mut self, id: u32, digests: &[String]) -> Result<Work, Error> {
        let item = self.item(id)?;
        self.phase.stage().ok_or_else(|| unknown(id))?.prepare(item, digests, &self.state)
    }

    /// Takes a record that an earlier run has kept under the key of the work. It is not taken where it does not read well: then the job is
    /// still to be done.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for a job that is not under way.
    pub fn found(&mut self, id: u32, record: Vec<u8>) -> Result<bool, Error> {
        if is_whole(&record) { self.accept(id, record, true) } else { self.item(id).map(|_| false) }
    }

    /// Takes the bytes that came of a job.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for a job that is not under way; [`Error::UnreadableFile`] for a record that was changed while the run went
    /// on; the errors of joining points and of choosing among them.
    pub fn complete(&mut self, id: u32, bytes: Vec<u8>) -> Result<(), Error> {
        match self.accept(id, bytes, false)? {
            true => Ok(()),
            false => Err(Error::Interrupted { interruption: Interruption::UnreadableWork }),
        }
    }

    fn accept(&mut self, id: u32, bytes: Vec<u8>, is_found: bool) -> Result<bool, Error> {
        let item = self.item(id)?;
        let Some(done) = self.phase.stage().ok_or_else(|| unknown(id))?.accept(item, bytes, &mut self.state)? else { return Ok(false) };
        self.ended(id, done, is_found);
        Ok(true)
    }

    /// Takes what a host says of a job that it could not do. The fault of an image or a pair leaves it out, with the reason.
    ///
    /// # Errors
    /// [`Error::Interrupted`] where no image and no pair is to blame: the run is over.
    pub fn failed(&mut self, id: u32, failure: Failure) -> Result<(), Error> {
        let item = self.item(id)?;
        let done = self.phase.stage().ok_or_else(|| unknown(id))?.fail(item, failure, &mut self.state)?;
        self.ended(id, done, false);
        Ok(())
    }

    /// What was found since the last call, and how far the stages are.
    pub fn news(&mut self) -> Vec<News> {
        std::mem::take(&mut self.news)
    }

    /// What the run has found.
    ///
    /// # Errors
    /// [`Error::Interrupted`] before all jobs are done.
    pub fn finish(self) -> Result<BlockRun, Error> {
        let is_over = matches!(self.phase, Phase::Over);
        let found = if is_over { self.state.ended() } else { None };
        found.ok_or(Error::Interrupted { interruption: Interruption::Unfinished })
    }

    fn item(&self, id: u32) -> Result<usize, Error> {
        self.underway.get(&id).copied().ok_or_else(|| unknown(id))
    }

    fn ended(&mut self, id: u32, done: super::job::Done, is_found: bool) {
        self.underway.remove(&id);
        self.news.extend(done.news);
        if done.is_counted {
            self.done += 1;
            self.found += usize::from(is_found);
            self.step(done.name);
        }
    }

    fn step(&mut self, name: String) {
        let Some(stage) = self.phase.stage() else { return };
        let step = Step { stage: stage.name(), done: self.done, total: stage.total(), name, found: self.found };
        self.news.push(News::Step(step));
    }

    /// Goes from a stage that is done to the next one.
    fn advance(&mut self) -> Result<(), Error> {
        let state = &mut self.state;
        self.phase = match std::mem::replace(&mut self.phase, Phase::Over) {
            Phase::Images(stage) => {
                let (read, mut skipped, copies) = stage.ended();
                let told = |image: &SkippedImage| News::Skipped { name: image.name.clone(), reason: image.reason.to_string() };
                self.news.extend(copies.iter().map(told));
                skipped.extend(copies);
                state.take_images(read, skipped)?;
                // A block without a place has no results in the system that would count from it.
                let is_wanted = state.input.geoid.is_some() && state.places().iter().any(|places| !places.is_empty());
                if is_wanted { Phase::Geoid(GeoidStage::default()) } else { described(state)? }
            }
            Phase::Geoid(_) => described(state)?,
            Phase::Likeness(stage) => chosen_pairs(state, &stage.lists(state.images.len()))?,
            Phase::Pairs(stage) => {
                state.pairs = stage.matched;
                Phase::own(Own::Points)
            }
            Phase::Own(Own::Points, _) if state.input.settings.refinement.method == RefinementMethod::None => Phase::own(Own::Orientation),
            Phase::Own(Own::Points, _) => {
                choose_refined(state)?;
                Phase::Windows(WindowStage::new(state))
            }
            Phase::Windows(_) => Phase::Refinement(Box::new(Refinement::new(state))),
            Phase::Refinement(stage) => {
                stage.ended(state);
                state.chosen = select_points(&state.points, &state.features(), &state.input.settings.selection)?.points;
                Phase::own(Own::Orientation)
            }
            Phase::Own(Own::Orientation, _) | Phase::Over => Phase::Over,
        };
        (self.done, self.found) = (0, 0);
        self.step(String::new());
        Ok(())
    }
}

fn unknown(id: u32) -> Error {
    Refusal::UnknownJob { job: id }.into_error()
}

/// What is known of the block, then its pairs.
fn described(state: &mut State) -> Result<Phase, Error> {
    state.describe()?;
    let rule = state.input.settings.pairs.rule_of(&state.local_positions());
    if rule == PairRule::Alike { Ok(Phase::Likeness(Likeness::new(state))) } else { chosen_pairs(state, &[]) }
}

fn chosen_pairs(state: &mut State, similar: &[Vec<(u32, f32)>]) -> Result<Phase, Error> {
    state.coarse = Vec::new();
    let chosen = choose_pairs(&state.local_positions(), similar, &state.input.settings.pairs)?;
    Ok(Phase::Pairs(Pairs::new(chosen)))
}

/// Observations that are oriented together are of one kind: the block goes on with the points that are refined alone, of which the final
/// ones are chosen.
fn choose_refined(state: &mut State) -> Result<(), Error> {
    let settings = &state.input.settings;
    let per_image = settings.selection.per_image.max(settings.refinement.per_image);
    let options = SelectOptions { per_image, ..settings.selection.clone() };
    let chosen = select_points(&state.points, &state.features(), &options)?.points;
    state.points = state.points.some(&chosen)?;
    state.windows = vec![String::new(); state.images.len()];
    Ok(())
}
