//! Which images are alike: how many coarse features each two have in common.

use super::features::Features;
use super::job::{Done, StageName, Work};
use super::records::{BUILD, Kind, column, key_of, read_record, rows_of, write_record};
use super::stage::{Request, Stage};
use super::state::State;
use super::task::{LikenessTask, Task};
use crate::error::refuse;
use crate::{DESCRIPTOR_BYTES, Error, Failure, NearestOptions, Refusal, nearest_matches};

/// How many features of the largest scales say whether images are alike.
const COARSE: usize = 256;

/// The descriptors of an image's features of the largest scales.
pub(super) fn coarse_of(features: &Features<'_>) -> Vec<u8> {
    let shapes = features.shapes();
    let mut order: Vec<usize> = (0..features.count).collect();
    order.sort_by(|a, b| shapes[*b][0].total_cmp(&shapes[*a][0]).then(a.cmp(b)));
    order.iter().take(COARSE).flat_map(|feature| features.descriptors[*feature]).collect()
}

pub(super) fn execute(task: &LikenessTask, descriptors: &[u8]) -> Result<Vec<u8>, Error> {
    let mut rest = descriptors;
    let mut parts = Vec::with_capacity(task.counts.len());
    for count in &task.counts {
        let Some((part, behind)) = rest.split_at_checked(count * DESCRIPTOR_BYTES) else {
            return refuse(Refusal::CoarseDescriptors { bytes: descriptors.len(), each: DESCRIPTOR_BYTES });
        };
        parts.push(part);
        rest = behind;
    }
    let Some((own, others)) = parts.split_first() else { return Ok(write_record(&task.key, &(), 0, &[])) };
    let options = NearestOptions::default();
    let counts = others.iter().map(|other| nearest_matches(own, other, &options).map(|found| found.len() as u32));
    let counts: Vec<u32> = counts.collect::<Result<_, _>>()?;
    Ok(write_record(&task.key, &(), counts.len(), &[&column(counts.iter().copied(), u32::to_le_bytes)]))
}

/// Compares each image with all behind it.
pub(super) struct Likeness {
    next: usize,
    keys: Vec<String>,
    /// Of each image the number of common features with each behind it.
    counts: Vec<Vec<u32>>,
}

impl Likeness {
    pub fn new(state: &State) -> Self {
        let rows = state.images.len().saturating_sub(1);
        Self { next: 0, keys: vec![String::new(); rows], counts: vec![Vec::new(); rows] }
    }

    /// For each image those it has features in common with, and how many.
    pub fn lists(&self, images: usize) -> Vec<Vec<(u32, f32)>> {
        let mut lists = vec![Vec::new(); images];
        for (a, counts) in self.counts.iter().enumerate() {
            for (b, count) in (a + 1..).zip(counts) {
                lists[a].push((b as u32, *count as f32));
                lists[b].push((a as u32, *count as f32));
            }
        }
        lists
    }
}

impl Stage for Likeness {
    fn name(&self) -> StageName {
        StageName::Likeness
    }

    fn total(&self) -> usize {
        self.counts.len()
    }

    fn next(&mut self, _: &State) -> Option<Request> {
        Request::following(&mut self.next, self.counts.len())
    }

    fn prepare(&mut self, item: usize, _: &[String], state: &State) -> Result<Work, Error> {
        let images: Vec<&str> = state.images[item..].iter().map(|image| image.key.as_str()).collect();
        let key = key_of(Kind::Likeness, BUILD, &(COARSE, images));
        self.keys[item] = key.clone();
        let parts = &state.coarse[item..];
        let counts = parts.iter().map(|part| part.len() / DESCRIPTOR_BYTES).collect();
        let task = Task::Likeness(LikenessTask { key: key.clone(), counts });
        Ok(Work { key: Some(key), task: Some(task), records: Vec::new(), input: Some(parts.concat()) })
    }

    fn accept(&mut self, item: usize, bytes: Vec<u8>, state: &mut State) -> Result<Option<Done>, Error> {
        let Some(record) = read_record::<()>(&self.keys[item], &bytes, |(), rows| 4 * rows) else { return Ok(None) };
        self.counts[item] = rows_of::<1, u32>(record.body, u32::from_le_bytes).into_iter().flatten().collect();
        Ok(Some(Done::of(state.images[item].name.clone(), None)))
    }

    /// Not known to be like any other behind it: its pairs are left to those.
    fn fail(&mut self, item: usize, failure: Failure, state: &mut State) -> Result<Done, Error> {
        failure.of_one()?;
        Ok(Done::of(state.images[item].name.clone(), None))
    }
}
