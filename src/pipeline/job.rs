//! What passes between a run and its host.

use super::task::Task;
use super::{GivenPosition, InitialCamera};
use crate::{Connection, ExifImage, TwoView};
use serde::{Deserialize, Serialize};

/// The parts of a run, in their order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum StageName {
    Images,
    Geoid,
    Likeness,
    Pairs,
    Points,
    Windows,
    Refinement,
    Orientation,
}

/// A job that can be done now. The host reads its files, asks [`Run::prepare`](super::Run::prepare) what is to be done with them, and hands back the bytes that come of it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Job {
    pub id: u32,
    pub files: Vec<FileNeeded>,
}

/// A file by its place among the names that the run was given.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(tag = "kind", content = "index", rename_all = "snake_case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum FileNeeded {
    Image(usize),
    Mask(usize),
    /// There is one at most.
    Geoid(usize),
}

/// What is to be done for a job.
#[derive(Debug, Clone, PartialEq)]
pub struct Work {
    /// Of the record that comes of it: a kept one is as good, and a new one is kept. Absent where nothing is kept.
    pub key: Option<String>,
    /// For a worker: [`execute`](super::execute). Absent where the run takes the bytes of the only record, or nothing, and computes itself.
    pub task: Option<Task>,
    /// Keys of kept records whose bytes it takes, after those of the files.
    pub records: Vec<String>,
    /// Bytes that it takes after those of the records.
    pub input: Option<Vec<u8>>,
}

/// How far a stage is.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Step {
    pub stage: StageName,
    pub done: usize,
    pub total: usize,
    /// What was done last: the name of an image, or of both of a pair; empty where there is none.
    pub name: String,
    /// How many of those done are from an earlier run.
    pub found: usize,
}

/// What a run finds on its way.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum News {
    Step(Step),
    Image(ReadImage),
    /// The reason in words.
    Skipped {
        name: String,
        reason: String,
    },
    /// Its images count without those that were skipped.
    Pair {
        connection: Connection,
        geometry: Option<TwoView>,
    },
}

/// An image that was read.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ReadImage {
    /// Its place among the names that the run was given.
    pub index: usize,
    pub name: String,
    pub width_px: u32,
    pub height_px: u32,
    pub features: u32,
    pub exif: ExifImage,
    /// The GNSS position that a table gives it, in place of that of the file.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub given: Option<GivenPosition>,
    /// As far as this image says.
    pub camera: InitialCamera,
}

/// What a stage says of a job that is done or has failed.
pub(super) struct Done {
    pub name: String,
    pub news: Option<News>,
    /// Whether the user counts it.
    pub is_counted: bool,
}

impl Done {
    pub(super) fn of(name: String, news: Option<News>) -> Self {
        Self { name, news, is_counted: true }
    }
}
