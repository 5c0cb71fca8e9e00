//! The first stage: every image is decoded once, and its features are kept.

use super::features::Features;
use super::job::{Done, FileNeeded, News, ReadImage, StageName, Work};
use super::likeness::coarse_of;
use super::records::{BUILD, Kind, key_of};
use super::stage::{Request, Stage};
use super::state::{Read, State};
use super::task::{FeatureTask, Task};
use super::{RunImage, SkippedImage};
use crate::{Error, Failure, Refusal};
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

enum Found {
    Nothing,
    /// Digest of the file and key of its features.
    Named {
        content: String,
        key: String,
    },
    /// With what tells whether another image shows the same.
    Read(Box<Read>, String),
    Skipped(SkippedImage),
}

pub(super) struct Images {
    next: usize,
    found: Vec<Found>,
    keeps_coarse: bool,
}

impl Images {
    pub fn new(state: &State) -> Self {
        let count = state.input.images.len();
        let keeps_coarse = state.input.settings.pairs.may_ask_for_likeness(count);
        Self { next: 0, found: (0..count).map(|_| Found::Nothing).collect(), keeps_coarse }
    }

    /// The images in the order of their names, those that were skipped, and those that are copies of others, also where their files differ in what else they
    /// hold: their observations would count twice.
    pub fn ended(self) -> (Vec<Read>, Vec<SkippedImage>, Vec<SkippedImage>) {
        let (mut read, mut skipped, mut copies) = (Vec::new(), Vec::new(), Vec::new());
        let mut by_what_is_shown = BTreeMap::<String, String>::new();
        for found in self.found {
            match found {
                Found::Read(image, shown) => match by_what_is_shown.entry(shown) {
                    Entry::Occupied(earlier) => copies.push(copy_of(earlier.get(), &image.image.name)),
                    Entry::Vacant(new) => {
                        new.insert(image.image.name.clone());
                        read.push(*image);
                    }
                },
                Found::Skipped(image) => skipped.push(image),
                Found::Nothing | Found::Named { .. } => {}
            }
        }
        (read, skipped, copies)
    }
}

fn copy_of(earlier: &str, name: &str) -> SkippedImage {
    let refusal = Refusal::CopyOfImage { name: earlier.to_string() };
    SkippedImage { name: name.to_string(), reason: Failure::from(&refusal.into_error()) }
}

impl Stage for Images {
    fn name(&self) -> StageName {
        StageName::Images
    }

    fn total(&self) -> usize {
        self.found.len()
    }

    fn next(&mut self, state: &State) -> Option<Request> {
        let mut request = Request::following(&mut self.next, self.found.len())?;
        request.files = vec![FileNeeded::Image(request.item)];
        request.files.extend(state.input.mask_of[request.item].map(FileNeeded::Mask));
        Some(request)
    }

    /// An image belongs to its content: renamed, it is the same; changed, it is another.
    fn prepare(&mut self, item: usize, digests: &[String], state: &State) -> Result<Work, Error> {
        let options = state.input.settings.features.clone();
        let mask = state.input.mask_of[item].map(|mask| state.input.masks[mask].clone());
        let key = key_of(Kind::Features, BUILD, &(digests, &options));
        self.found[item] = Found::Named { content: digests.first().cloned().unwrap_or_default(), key: key.clone() };
        let task = Task::Features(FeatureTask { key: key.clone(), options, mask });
        Ok(Work { key: Some(key), task: Some(task), records: Vec::new(), input: None })
    }

    fn accept(&mut self, item: usize, bytes: Vec<u8>, state: &mut State) -> Result<Option<Done>, Error> {
        let Found::Named { content, key } = &self.found[item] else { return Ok(None) };
        let Some(features) = Features::read(key, &bytes) else { return Ok(None) };
        let (content, key) = (content.clone(), key.clone());
        let (name, masked) = (state.input.images[item].clone(), state.input.mask_of[item].is_some());
        let coarse = if self.keeps_coarse { coarse_of(&features) } else { Vec::new() };
        let positions = features.positions();
        let shown = features.digest().unwrap_or_else(|| content.clone());
        let (head, count) = (features.head, features.count as u32);
        let (width_px, height_px) = (head.width_px, head.height_px);
        let camera = state.input.rules.camera_of(&name, [width_px, height_px], &head.exif).1;
        let given = state.input.given[item];
        let news =
            ReadImage { camera, index: item, name: name.clone(), width_px, height_px, features: count, exif: head.exif.clone(), given };
        let image = RunImage {
            name: name.clone(),
            key,
            content,
            width_px,
            height_px,
            features: Some(count),
            masked,
            exif: head.exif,
            given,
            camera: 0,
        };
        self.found[item] = Found::Read(Box::new(Read { image, positions, coarse }), shown);
        Ok(Some(Done::of(name, Some(News::Image(news)))))
    }

    fn fail(&mut self, item: usize, failure: Failure, state: &mut State) -> Result<Done, Error> {
        let reason = failure.of_one()?;
        let name = state.input.images[item].clone();
        let news = News::Skipped { name: name.clone(), reason: reason.to_string() };
        self.found[item] = Found::Skipped(SkippedImage { name: name.clone(), reason });
        Ok(Done::of(name, Some(news)))
    }
}
