//! What the stages of a run have in common.

use super::job::{Done, FileNeeded, StageName, Work};
use super::state::State;
use crate::{Error, Failure};

/// A job of a stage before it has a number of its own.
pub(super) struct Request {
    pub item: usize,
    pub files: Vec<FileNeeded>,
}

impl Request {
    /// The next of so many items that need no file.
    pub fn following(next: &mut usize, items: usize) -> Option<Self> {
        let item = *next;
        (item < items).then(|| {
            *next += 1;
            Self { item, files: Vec::new() }
        })
    }
}

/// A stage of a run: its items are done in any order, several at the same time.
pub(super) trait Stage {
    fn name(&self) -> StageName;

    /// How many items the user counts.
    fn total(&self) -> usize;

    /// An item that can be done now; absent where there is none, or none before another is done.
    fn next(&mut self, state: &State) -> Option<Request>;

    /// What is to be done for an item whose files have these digests.
    fn prepare(&mut self, item: usize, digests: &[String], state: &State) -> Result<Work, Error>;

    /// Takes what came of an item; absent where it does not read as such.
    fn accept(&mut self, item: usize, bytes: Vec<u8>, state: &mut State) -> Result<Option<Done>, Error>;

    /// Goes on without an item where that is to blame alone; otherwise the run ends.
    fn fail(&mut self, item: usize, failure: Failure, state: &mut State) -> Result<Done, Error>;
}
