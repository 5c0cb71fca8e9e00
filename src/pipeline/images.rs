//! The first stage: every image is decoded once, and its features are kept.

use super::features::Features;
use super::job::{Done, FileNeeded, News, ReadImage, StageName, Work};
use super::likeness::coarse_of;
use super::records::{BUILD, Kind, key_of};
use super::stage::{Request, Stage};
use super::state::{Positions, State};
use super::task::{FeatureTask, Task};
use super::{RunImage, SkippedImage};
use crate::{Error, Failure};

/// What is known of an image once it was read.
pub(super) struct Read {
    pub image: RunImage,
    pub positions: Positions,
    /// Empty where the likeness of images is not asked for.
    pub coarse: Vec<u8>,
}

enum Found {
    Nothing,
    /// Digest of the file and key of its features.
    Named {
        content: String,
        key: String,
    },
    Read(Box<Read>),
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

    /// The images in the order of their names, and those that were skipped.
    pub fn ended(self) -> (Vec<Read>, Vec<SkippedImage>) {
        let (mut read, mut skipped) = (Vec::new(), Vec::new());
        for found in self.found {
            match found {
                Found::Read(image) => read.push(*image),
                Found::Skipped(image) => skipped.push(image),
                Found::Nothing | Found::Named { .. } => {}
            }
        }
        (read, skipped)
    }
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
        let (head, count) = (features.head, features.count as u32);
        let (width_px, height_px) = (head.width_px, head.height_px);
        let news = ReadImage { index: item, name: name.clone(), width_px, height_px, features: count, exif: head.exif.clone() };
        let image =
            RunImage { name: name.clone(), key, content, width_px, height_px, features: Some(count), masked, exif: head.exif, camera: 0 };
        self.found[item] = Found::Read(Box::new(Read { image, positions, coarse }));
        Ok(Some(Done::of(name, Some(News::Image(news)))))
    }

    fn fail(&mut self, item: usize, failure: Failure, state: &mut State) -> Result<Done, Error> {
        let reason = failure.of_one()?;
        let name = state.input.images[item].clone();
        let skipped = SkippedImage { name: name.clone(), reason };
        self.found[item] = Found::Skipped(skipped.clone());
        Ok(Done::of(name, Some(News::Skipped(skipped))))
    }
}
