//! Every chosen pair is matched once, and its verified matches are kept.

use super::cameras::{PairCamera, pair_cameras};
use super::features::Features;
use super::job::{Done, News, StageName, Work};
use super::records::{BUILD, Kind, column, key_of, read_record, rows_of, write_record};
use super::stage::{Request, Stage};
use super::state::{Matched, State};
use super::task::{PairTask, Task};
use crate::{
    ChosenPair, Connection, DescriptorMatch, Error, Failure, FeatureMatch, FeatureMatchOptions, Located, PairOutcome, TwoView,
    TwoViewOptions, match_features,
};
use serde::{Deserialize, Serialize};

/// Bytes of a match: both features and its strength.
const MATCH: usize = 12;

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct PairHead {
    outcome: PairOutcome,
    geometry: Option<TwoView>,
    has_frame: bool,
}

/// Features by positions freed of what is known of the camera's distortion, with their numbers; without those where it folds the image.
struct Usable {
    numbers: Vec<u32>,
    positions: Vec<[f64; 2]>,
    descriptors: Vec<u8>,
}

impl Usable {
    fn new(features: &Features<'_>, camera: &PairCamera) -> Self {
        let mut usable =
            Self { numbers: Vec::new(), positions: Vec::new(), descriptors: Vec::with_capacity(features.descriptors.as_flattened().len()) };
        for (number, measured) in features.positions().into_iter().enumerate() {
            let measured = measured.map(f64::from);
            let Some(position) = camera.lens.as_ref().map_or(Some(measured), |lens| lens.undistorted_px(measured).ok()) else { continue };
            usable.numbers.push(number as u32);
            usable.positions.push(position);
            usable.descriptors.extend_from_slice(&features.descriptors[number]);
        }
        usable
    }

    fn located(&self) -> Located<'_> {
        Located { positions: &self.positions, descriptors: &self.descriptors }
    }
}

pub(super) fn execute(task: &PairTask, records: [&[u8]; 2]) -> Result<Vec<u8>, Error> {
    let features = [Features::kept(&task.features[0], records[0])?, Features::kept(&task.features[1], records[1])?];
    let [left, right] = [0, 1].map(|side| Usable::new(&features[side], &task.cameras[side]));
    let [of_left, of_right] = [0, 1].map(|side| Some(task.cameras[side].pinhole));
    let options = FeatureMatchOptions {
        nearest: task.nearest.clone(),
        sizes: Some([0, 1].map(|side| [features[side].head.width_px as usize, features[side].head.height_px as usize])),
        geometry: TwoViewOptions { left: of_left, right: of_right, ..task.geometry.clone() },
    };
    let found = match_features(left.located(), right.located(), &options)?;
    let matches = found.matches.len() as u32;
    let (outcome, geometry) = match found.geometry {
        Err(no_geometry) => (PairOutcome::NotOriented { no_geometry }, None),
        // All matches agree with it.
        Ok(geometry) => {
            let geometry = Some(TwoView { inliers: Vec::new(), ..geometry });
            let is_connected = matches >= task.least_matches;
            let too_few = PairOutcome::TooFewMatches { matches, needed: task.least_matches };
            (if is_connected { PairOutcome::Connected { matches } } else { too_few }, geometry)
        }
    };
    // Where nothing is connected, no match is kept.
    let is_connected = matches!(outcome, PairOutcome::Connected { .. });
    let kept: &[DescriptorMatch] = if is_connected { &found.matches } else { &[] };
    let features = column(kept.iter().flat_map(|m| [left.numbers[m.left], right.numbers[m.right]]), u32::to_le_bytes);
    let strengths = column(kept.iter().map(|m| -f64::from(m.square).sqrt() as f32), f32::to_le_bytes);
    Ok(write_record(&task.key, &PairHead { outcome, geometry, has_frame: found.has_frame }, kept.len(), &[&features, &strengths]))
}

pub(super) struct Pairs {
    next: usize,
    keys: Vec<String>,
    pub matched: Vec<Matched>,
}

impl Pairs {
    pub fn new(chosen: Vec<ChosenPair>) -> Self {
        let waiting = |pair: ChosenPair| Connection { images: pair.images, rule: pair.rule, outcome: PairOutcome::Waiting };
        let matched =
            chosen.into_iter().map(|pair| Matched { connection: waiting(pair), geometry: None, matches: Vec::new(), has_frame: false });
        let matched: Vec<Matched> = matched.collect();
        Self { next: 0, keys: vec![String::new(); matched.len()], matched }
    }

    fn done(&mut self, item: usize, outcome: PairOutcome, geometry: Option<TwoView>, matches: Vec<FeatureMatch>, state: &State) -> Done {
        let pair = &mut self.matched[item];
        pair.connection.outcome = outcome;
        pair.geometry = geometry;
        pair.matches = matches;
        let names = pair.connection.images.map(|image| state.images[image as usize].name.as_str());
        let news = News::Pair { connection: pair.connection.clone(), geometry: pair.geometry.clone() };
        Done::of(names.join(" – "), Some(news))
    }
}

impl Stage for Pairs {
    fn name(&self) -> StageName {
        StageName::Pairs
    }

    fn total(&self) -> usize {
        self.matched.len()
    }

    fn next(&mut self, _: &State) -> Option<Request> {
        Request::following(&mut self.next, self.matched.len())
    }

    fn prepare(&mut self, item: usize, _: &[String], state: &State) -> Result<Work, Error> {
        let images = self.matched[item].connection.images.map(|image| &state.images[image as usize]);
        let features = images.map(|image| image.key.clone());
        let cameras = pair_cameras(images.map(|image| &state.cameras[image.camera]));
        let settings = &state.input.settings;
        let (nearest, geometry, least_matches) = (settings.nearest.clone(), settings.geometry.clone(), settings.pairs.least_matches);
        let key = key_of(Kind::Pair, BUILD, &(&features, &cameras, &nearest, &geometry, least_matches));
        self.keys[item] = key.clone();
        let task = PairTask { key: key.clone(), features: features.clone(), cameras, nearest, geometry, least_matches };
        Ok(Work { key: Some(key), task: Some(Task::Pair(Box::new(task))), records: features.into(), input: None })
    }

    fn accept(&mut self, item: usize, bytes: Vec<u8>, state: &mut State) -> Result<Option<Done>, Error> {
        let Some(record) = read_record::<PairHead>(&self.keys[item], &bytes, |_, rows| MATCH * rows) else { return Ok(None) };
        let (features, strengths) = record.body.split_at(8 * record.rows);
        let strengths = rows_of::<1, f32>(strengths, f32::from_le_bytes);
        let matches = rows_of(features, u32::from_le_bytes).into_iter().zip(strengths);
        let matches = matches.map(|(features, [strength])| FeatureMatch { features, strength }).collect();
        let PairHead { outcome, geometry, has_frame } = record.head;
        self.matched[item].has_frame = has_frame;
        Ok(Some(self.done(item, outcome, geometry, matches, state)))
    }

    fn fail(&mut self, item: usize, failure: Failure, state: &mut State) -> Result<Done, Error> {
        let outcome = PairOutcome::Failed { failure: failure.of_one()? };
        Ok(self.done(item, outcome, None, Vec::new(), state))
    }
}
