//! Windows around the observations of many points are cut out of each image, which is decoded once more for them.

use super::features::Features;
use super::job::{Done, FileNeeded, StageName, Work};
use super::records::{BUILD, Kind, column, key_of, read_record, rows_of, write_record};
use super::stage::{Request, Stage};
use super::state::State;
use super::task::{Task, WindowTask};
use crate::error::refuse;
use crate::{DecodeLimits, Error, Failure, Interruption, Refusal, WindowCentre, decode, observation_windows};
use serde::{Deserialize, Serialize};

#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
struct WindowHead {
    /// Side of each window in px.
    side: usize,
    observations: usize,
}

/// Bytes of an observation's shape, and of the place of a window.
const SHAPE: usize = 16;
const PLACE: usize = 16;

/// The windows of an image.
pub(super) struct Windows {
    pub side: usize,
    /// x, y and scale in px and direction in rad of each observation.
    pub shapes: Vec<[f32; 4]>,
    /// As [`ObservationWindows`](crate::ObservationWindows) has them.
    places: Vec<[u32; 4]>,
    record: Vec<u8>,
    /// Where in the record the grey values begin.
    grey: usize,
}

impl Windows {
    pub fn read(key: &str, record: Vec<u8>) -> Option<Self> {
        let body_bytes = |head: &WindowHead, rows: usize| SHAPE * head.observations + rows * (PLACE + head.side * head.side);
        let read = read_record::<WindowHead>(key, &record, body_bytes)?;
        let (shapes, rest) = read.body.split_at(SHAPE * read.head.observations);
        let (places, grey) = rest.split_at(PLACE * read.rows);
        let (shapes, places) = (rows_of(shapes, f32::from_le_bytes), rows_of(places, u32::from_le_bytes));
        let grey = record.len() - grey.len();
        Some(Self { side: read.head.side, shapes, places, grey, record })
    }

    /// The windows of an observation: their places, and their grey values in one piece.
    pub fn of(&self, observation: usize) -> (&[[u32; 4]], &[u8]) {
        let bound = |limit: usize| self.places.partition_point(|place| (place[0] as usize) < limit);
        let (from, to) = (bound(observation), bound(observation + 1));
        let area = self.side * self.side;
        (&self.places[from..to], &self.record[self.grey..][from * area..to * area])
    }
}

pub(super) fn execute(task: &WindowTask, image: &[u8], record: &[u8]) -> Result<Vec<u8>, Error> {
    let features = Features::kept(&task.features, record)?;
    let (positions, shapes) = (features.positions(), features.shapes());
    let mut rays = Vec::with_capacity(task.chosen.len());
    for chosen in &task.chosen {
        let Some(([x, y], [scale, direction, _])) = positions.get(*chosen as usize).copied().zip(shapes.get(*chosen as usize).copied())
        else {
            return refuse(Refusal::ChosenFeature { feature: *chosen, features: features.count });
        };
        rays.push([x, y, scale, direction]);
    }
    let place = |[x, y, scale, _]: &[f32; 4]| WindowCentre { position: [f64::from(*x), f64::from(*y)], scale_px: f64::from(*scale) };
    let places: Vec<WindowCentre> = rays.iter().map(place).collect();
    let cut = observation_windows(decode(image, &DecodeLimits::default())?.grey.view(), &places, &task.options)?;
    let head = WindowHead { side: cut.side, observations: rays.len() };
    let shapes = column(rays.into_iter().flatten(), f32::to_le_bytes);
    let places = column(cut.places.iter().flatten().copied(), u32::to_le_bytes);
    Ok(write_record(&task.key, &head, cut.places.len(), &[&shapes, &places, &cut.grey]))
}

/// Keeps the windows of each image that has observations.
pub(super) struct WindowStage {
    next: usize,
    /// The images, and of each the features that observations are of.
    images: Vec<(usize, Vec<u32>)>,
}

impl WindowStage {
    pub fn new(state: &State) -> Self {
        let mut own: Vec<Vec<u32>> = vec![Vec::new(); state.images.len()];
        for ray in state.points.iter().flatten() {
            own[ray.image as usize].push(ray.feature);
        }
        Self { next: 0, images: own.into_iter().enumerate().filter(|(_, features)| !features.is_empty()).collect() }
    }
}

impl Stage for WindowStage {
    fn name(&self) -> StageName {
        StageName::Windows
    }

    fn total(&self) -> usize {
        self.images.len()
    }

    fn next(&mut self, state: &State) -> Option<Request> {
        let mut request = Request::following(&mut self.next, self.images.len())?;
        let name = &state.images[self.images[request.item].0].name;
        request.files.extend(state.input.images.iter().position(|given| given == name).map(FileNeeded::Image));
        Some(request)
    }

    fn prepare(&mut self, item: usize, digests: &[String], state: &State) -> Result<Work, Error> {
        let (index, chosen) = &self.images[item];
        let image = &state.images[*index];
        if digests != std::slice::from_ref(&image.content) {
            return Err(Error::Interrupted { interruption: Interruption::ImageChanged { name: image.name.clone() } });
        }
        let options = state.input.settings.refinement.clone();
        let key = key_of(Kind::Windows, BUILD, &(&image.key, chosen, options.window));
        let task = WindowTask { key: key.clone(), features: image.key.clone(), chosen: chosen.clone(), options };
        Ok(Work { key: Some(key), task: Some(Task::Windows(task)), records: vec![image.key.clone()], input: None })
    }

    fn accept(&mut self, item: usize, bytes: Vec<u8>, state: &mut State) -> Result<Option<Done>, Error> {
        let (index, chosen) = &self.images[item];
        let key = key_of(Kind::Windows, BUILD, &(&state.images[*index].key, chosen, state.input.settings.refinement.window));
        if Windows::read(&key, bytes).is_none() {
            return Ok(None);
        }
        state.windows[*index] = key;
        Ok(Some(Done::of(state.images[*index].name.clone(), None)))
    }

    fn fail(&mut self, item: usize, failure: Failure, state: &mut State) -> Result<Done, Error> {
        let name = state.images[self.images[item].0].name.clone();
        Err(Error::Interrupted { interruption: Interruption::Refinement { name, failure } })
    }
}
