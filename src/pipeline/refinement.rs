//! The observations of each point are matched by least squares to a reference observation: points whose first image is the same together,
//! by windows of some images at a time.

use super::job::{Done, StageName, Work};
use super::records::kept;
use super::stage::{Request, Stage};
use super::state::State;
use super::task::{RefineTask, Task};
use super::windows::Windows;
use super::{RefinedObservation, RefinementTable};
use crate::error::refuse;
use crate::{Error, Failure, ObservationWindows, PointRefiner, Refusal, WindowCentre, WindowedObservation, json};
use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::ops::Range;

/// Windows of so many images are in memory for points that follow each other.
const IMAGES_AT_HAND: usize = 32;

pub(super) fn execute(task: &RefineTask, grey: Vec<u8>) -> Result<Vec<u8>, Error> {
    let windows = ObservationWindows::new(task.places.clone(), grey, &task.options)?;
    let windowed = task.shapes.iter().enumerate().map(|(index, shape)| {
        let [x, y, scale_px, orientation_rad] = shape.map(f64::from);
        Ok(WindowedObservation {
            place: WindowCentre { position: [x, y], scale_px },
            orientation_rad,
            windows: windows.of_ray(index as u32)?,
        })
    });
    let windowed: Vec<WindowedObservation<'_>> = windowed.collect::<Result<_, Error>>()?;
    let mut refiner = PointRefiner::new(&task.options)?;
    let mut refined: Vec<RefinedObservation> = Vec::with_capacity(windowed.len());
    for ends in task.starts.windows(2) {
        let Some(own) = windowed.get(ends[0] as usize..ends[1] as usize) else {
            return refuse(Refusal::RefinedObservations { first: ends[0], end: ends[1], windows: windowed.len() });
        };
        refined.extend(refiner.refine(own)?.rays.iter().zip(&task.images[ends[0] as usize..]).map(|(ray, image)| RefinedObservation {
            image: *image,
            position_px: ray.position.map(|v| v as f32),
            outcome: ray.outcome,
            standard_error_px: ray.standard_error_px.map(|v| v as f32),
            correlation: ray.correlation.map(|v| v as f32),
        }));
    }
    Ok(serde_json::to_vec(&refined).expect("plain data has a JSON form"))
}

/// An observation: its image, and its rank among those of the image.
#[derive(Debug, Clone, Copy)]
struct Observation {
    image: usize,
    rank: usize,
}

/// Points of a group for which windows are brought together.
struct Gathering {
    points: Range<usize>,
    /// Images whose windows are missing yet.
    missing: BTreeSet<usize>,
    shapes: Vec<[f32; 4]>,
    /// Of each observation its windows.
    windows: Vec<(Vec<[u32; 4]>, Vec<u8>)>,
}

impl Gathering {
    /// Takes what the windows of an image hold for the group.
    fn take(&mut self, image: usize, windows: &Windows, observations: &[Observation]) {
        if !self.missing.remove(&image) {
            return;
        }
        for (index, own) in observations.iter().enumerate().filter(|(_, own)| own.image == image) {
            let (places, grey) = windows.of(own.rank);
            self.shapes[index] = windows.shapes[own.rank];
            self.windows[index] = (places.iter().map(|place| [index as u32, place[1], place[2], place[3]]).collect(), grey.to_vec());
        }
    }
}

enum Item {
    /// Windows of an image.
    Load(usize),
    /// The first observation, and the task until it is handed out.
    Refine(usize, Option<(RefineTask, Vec<u8>)>),
}

pub(super) struct Refinement {
    /// The first observation of each point, and the number of all.
    starts: Vec<u32>,
    observations: Vec<Observation>,
    /// Points that follow each other and whose first image is the same.
    groups: VecDeque<Range<usize>>,
    group_count: usize,
    gathering: Option<Gathering>,
    loading: BTreeSet<usize>,
    /// What was needed last stands last.
    at_hand: VecDeque<(usize, Windows)>,
    items: Vec<Item>,
    refined: BTreeMap<usize, Vec<RefinedObservation>>,
}

impl Refinement {
    pub fn new(state: &State) -> Self {
        let mut ranks = vec![0; state.images.len()];
        let (mut starts, mut observations) = (vec![0], Vec::with_capacity(state.points.ray_count()));
        let mut groups: VecDeque<Range<usize>> = VecDeque::new();
        let mut last = None;
        for (point, rays) in state.points.iter().enumerate() {
            for ray in rays {
                let image = ray.image as usize;
                observations.push(Observation { image, rank: ranks[image] });
                ranks[image] += 1;
            }
            starts.push(observations.len() as u32);
            let first = rays.first().map(|ray| ray.image);
            match groups.back_mut().filter(|_| first == last) {
                Some(group) => group.end = point + 1,
                None => groups.push_back(point..point + 1),
            }
            last = first;
        }
        let (group_count, at_hand) = (groups.len(), VecDeque::new());
        let (gathering, loading, items, refined) = (None, BTreeSet::new(), Vec::new(), BTreeMap::new());
        Self { starts, observations, groups, group_count, gathering, loading, at_hand, items, refined }
    }

    /// Moves the observations, and gives what became of them.
    pub fn ended(self, state: &mut State) {
        let observations: Vec<RefinedObservation> = self.refined.into_values().flatten().collect();
        for (ray, refined) in state.points.iter().flatten().zip(&observations) {
            state.positions[ray.image as usize][ray.feature as usize] = refined.position_px;
        }
        state.refinement = Some(RefinementTable { starts: self.starts, observations });
    }

    fn range_of(&self, points: &Range<usize>) -> Range<usize> {
        self.starts[points.start] as usize..self.starts[points.end] as usize
    }

    /// Begins with the next group.
    fn gather(&mut self) -> Option<()> {
        let points = self.groups.pop_front()?;
        let own = &self.observations[self.range_of(&points)];
        let missing = own.iter().map(|observation| observation.image).collect();
        let mut gathering = Gathering { points, missing, shapes: vec![[0.0; 4]; own.len()], windows: vec![Default::default(); own.len()] };
        for (image, windows) in &self.at_hand {
            gathering.take(*image, windows, own);
        }
        // What was needed last stands last.
        let (needed, idle): (VecDeque<_>, VecDeque<_>) =
            std::mem::take(&mut self.at_hand).into_iter().partition(|(image, _)| own.iter().any(|one| one.image == *image));
        self.at_hand = idle.into_iter().chain(needed).collect();
        self.gathering = Some(gathering);
        Some(())
    }

    fn request(&mut self, item: Item) -> Option<Request> {
        self.items.push(item);
        Some(Request { item: self.items.len() - 1, files: Vec::new() })
    }
}

impl Stage for Refinement {
    fn name(&self) -> StageName {
        StageName::Refinement
    }

    fn total(&self) -> usize {
        self.group_count
    }

    fn next(&mut self, state: &State) -> Option<Request> {
        if self.gathering.is_none() {
            self.gather()?;
        }
        let gathering = self.gathering.as_ref()?;
        if let Some(image) = gathering.missing.iter().find(|image| !self.loading.contains(image)).copied() {
            self.loading.insert(image);
            return self.request(Item::Load(image));
        }
        if !gathering.missing.is_empty() {
            return None;
        }
        let Gathering { points, shapes, windows, .. } = self.gathering.take()?;
        let own = self.range_of(&points);
        let starts = self.starts[points.start..=points.end].iter().map(|start| start - own.start as u32).collect();
        let images = self.observations[own.clone()].iter().map(|observation| observation.image as u32).collect();
        let (places, grey): (Vec<_>, Vec<_>) = windows.into_iter().unzip();
        let options = state.input.settings.refinement.clone();
        let task = RefineTask { starts, images, shapes, places: places.concat(), options };
        self.request(Item::Refine(own.start, Some((task, grey.concat()))))
    }

    fn prepare(&mut self, item: usize, _: &[String], state: &State) -> Result<Work, Error> {
        Ok(match &mut self.items[item] {
            Item::Load(image) => Work { key: None, task: None, records: vec![state.windows[*image].clone()], input: None },
            Item::Refine(_, task) => {
                let (task, grey) = task.take().unzip();
                Work { key: None, task: task.map(Task::Refine), records: Vec::new(), input: grey }
            }
        })
    }

    fn accept(&mut self, item: usize, bytes: Vec<u8>, state: &mut State) -> Result<Option<Done>, Error> {
        let is_counted = match self.items[item] {
            Item::Load(image) => {
                let key = &state.windows[image];
                let windows = kept(key, Windows::read(key, bytes))?;
                if let Some(gathering) = &mut self.gathering {
                    let own = self.starts[gathering.points.start] as usize..self.starts[gathering.points.end] as usize;
                    gathering.take(image, &windows, &self.observations[own]);
                }
                self.loading.remove(&image);
                self.at_hand.push_back((image, windows));
                if self.at_hand.len() > IMAGES_AT_HAND {
                    self.at_hand.pop_front();
                }
                false
            }
            Item::Refine(first, _) => {
                let Some(refined) = str::from_utf8(&bytes).ok().and_then(|text| json::from_text(text).ok()) else { return Ok(None) };
                self.refined.insert(first, refined);
                true
            }
        };
        Ok(Some(Done { name: String::new(), news: None, is_counted }))
    }

    fn fail(&mut self, _: usize, failure: Failure, _: &mut State) -> Result<Done, Error> {
        Err(failure.of_all())
    }
}
