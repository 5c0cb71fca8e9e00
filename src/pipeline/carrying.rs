//! Edits of a block carried to another one, that was found or placed anew: what they name must be there, by the names of images and surveyed points, and by
//! where places of an orthophoto lie.

use super::place_names::is_found_place;
use super::places::{PlaceAgain, epsg_system};
use crate::editing::ascending;
use crate::{BlockEdit, HandMeasurement, PointImage, PointSource};
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};

/// What edits of a block name by numbers.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct EditNames {
    /// The names of the images, by their indices.
    pub images: Vec<String>,
    /// Surveyed points by their numbers, with their names.
    pub surveyed: Vec<(usize, String)>,
    /// The pairs that matches connect.
    pub connected: Vec<[usize; 2]>,
    /// How many surveyed points the block was found with, the first ones: those that edits add are numbered behind them.
    pub found: usize,
    /// The system of their coordinates; absent where none is known.
    #[serde(default)]
    pub system: Option<String>,
}

/// Steps of edits of a block, and the block that they are carried to.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Carrying {
    /// What was done at once.
    pub steps: Vec<Vec<BlockEdit>>,
    /// So many of them, the first, are in force; the others were undone.
    pub done: usize,
    pub before: EditNames,
    pub after: EditNames,
    /// Whether both have the same tie points.
    pub same_tie_points: bool,
    /// Which places of the orthophoto lie where they lay, by numbers of both.
    pub again: Vec<PlaceAgain>,
}

/// What is left of steps in another block.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct CarriedSteps {
    pub steps: Vec<Vec<BlockEdit>>,
    /// Of none of the former steps, of the first, of the first two and so on so many are left.
    pub left: Vec<usize>,
    /// So many edits that were in force do not hold there.
    pub lost: usize,
    /// What edits in force do to so many places of the orthophoto, or to observations of them, holds.
    pub places_held: usize,
    /// Of so many something does not.
    pub places_lost: usize,
    /// Of the edits that are lost so many are for these.
    pub lost_for_places: usize,
    /// Former steps, by their indices, that were undone and cannot be done again there.
    pub aside: Vec<usize>,
}

/// The edits that hold in another block: those of images and their pairs, of surveyed points, and of points that were measured by hand; those of tie points
/// where these are the same, and those of places of an orthophoto that lie where they lay. What was measured of one by hand holds of the same spot alone,
/// coordinates that edits add hold in the same system. Steps stay steps; one that was undone stays where all of its edits do.
#[must_use]
pub fn carried_steps(carrying: &Carrying) -> CarriedSteps {
    let Carrying { steps, done, .. } = carrying;
    let mut carrier = Carrier::new(carrying);
    let mut carried = CarriedSteps { left: vec![0], ..CarriedSteps::default() };
    for (index, step) in steps.iter().enumerate() {
        let is_undone = index >= *done;
        let own = carrier.step(step, is_undone);
        if !is_undone {
            carried.lost += step.len() - own.len();
            (carried.places_held, carried.places_lost) = (carrier.held.len(), carrier.lost.len());
            carried.lost_for_places = carrier.lost_for_places;
        }
        match own.is_empty() {
            false => carried.steps.push(own),
            true if is_undone => carried.aside.push(index),
            true => {}
        }
        carried.left.push(carried.steps.len());
    }
    carried
}

struct Carrier<'a> {
    before: &'a EditNames,
    after: &'a EditNames,
    same_tie_points: bool,
    /// By their numbers before.
    again: BTreeMap<usize, &'a PlaceAgain>,
    /// Indices of the images there, and numbers of surveyed points there, by their names.
    images: BTreeMap<&'a str, usize>,
    surveyed: BTreeMap<&'a str, usize>,
    /// Names of surveyed points before.
    names: BTreeMap<usize, &'a str>,
    connected: BTreeSet<[usize; 2]>,
    /// Of the points that edits add, of the tie points and of the surveyed ones, their numbers there; absent for those that do not hold.
    manual: Vec<Option<u32>>,
    added: Vec<Option<usize>>,
    /// Observations of places that edits add: of which number before, and in which image there.
    measured: BTreeSet<(usize, usize)>,
    /// Numbers of places before.
    held: BTreeSet<usize>,
    lost: BTreeSet<usize>,
    lost_for_places: usize,
    /// Whether something of the edit at hand is lost for a place.
    is_place_lost: bool,
}

impl<'a> Carrier<'a> {
    fn new(Carrying { before, after, same_tie_points, again, .. }: &'a Carrying) -> Self {
        Self {
            before,
            after,
            same_tie_points: *same_tie_points,
            again: again.iter().map(|one| (one.before, one)).collect(),
            images: after.images.iter().enumerate().map(|(index, name)| (name.as_str(), index)).collect(),
            surveyed: after.surveyed.iter().map(|(number, name)| (name.as_str(), *number)).collect(),
            names: before.surveyed.iter().map(|(number, name)| (*number, name.as_str())).collect(),
            connected: after.connected.iter().map(|pair| ascending(*pair)).collect(),
            manual: Vec::new(),
            added: Vec::new(),
            measured: BTreeSet::new(),
            held: BTreeSet::new(),
            lost: BTreeSet::new(),
            lost_for_places: 0,
            is_place_lost: false,
        }
    }

    /// `is_whole`: nothing of it where an edit is lost.
    fn step(&mut self, step: &[BlockEdit], is_whole: bool) -> Vec<BlockEdit> {
        let (manual, added) = (self.manual.len(), self.added.len());
        let mut own = Vec::new();
        for edit in step {
            self.is_place_lost = false;
            let carried = self.edit(edit);
            self.lost_for_places += usize::from(carried.is_none() && self.is_place_lost);
            own.extend(carried);
        }
        if !is_whole || own.len() == step.len() {
            return own;
        }
        // Later steps find none of its points.
        self.manual[manual..].fill(None);
        self.added[added..].fill(None);
        Vec::new()
    }

    fn edit(&mut self, edit: &BlockEdit) -> Option<BlockEdit> {
        match edit {
            BlockEdit::RejectImages { images } => self.images(images).map(|images| BlockEdit::RejectImages { images }),
            BlockEdit::RestoreImages { images } => self.images(images).map(|images| BlockEdit::RestoreImages { images }),
            BlockEdit::RejectPairs { pairs } => self.pairs(pairs).map(|pairs| BlockEdit::RejectPairs { pairs }),
            BlockEdit::RestorePairs { pairs } => self.pairs(pairs).map(|pairs| BlockEdit::RestorePairs { pairs }),
            BlockEdit::RejectPoints { points } => self.points(points).map(|points| BlockEdit::RejectPoints { points }),
            BlockEdit::RestorePoints { points } => self.points(points).map(|points| BlockEdit::RestorePoints { points }),
            BlockEdit::RejectObservations { observations } => {
                self.observations(observations).map(|observations| BlockEdit::RejectObservations { observations })
            }
            BlockEdit::RestoreObservations { observations } => {
                self.observations(observations).map(|observations| BlockEdit::RestoreObservations { observations })
            }
            BlockEdit::Measure { point: former, image, x_px, y_px, by } => {
                let (point, image) = (self.point(*former, |again, _| again.is_same_spot), self.image(*image)?);
                if let PointSource::GroundControl(number) = former {
                    self.measured.extend(point.map(|_| (*number, image)));
                }
                Some(BlockEdit::Measure { point: point?, image, x_px: *x_px, y_px: *y_px, by: *by })
            }
            BlockEdit::SetUse { point, role } => match self.point(PointSource::GroundControl(*point), |_, _| true)? {
                PointSource::GroundControl(point) => Some(BlockEdit::SetUse { point, role: *role }),
                PointSource::TiePoint(_) | PointSource::Manual(_) => None,
            },
            BlockEdit::AddPoint { observations } => self.add_point(observations),
            BlockEdit::AddControl { epsg, .. } => self.add_control(*epsg).then(|| edit.clone()),
        }
    }

    fn add_point(&mut self, observations: &[HandMeasurement]) -> Option<BlockEdit> {
        let seen = observations.iter().filter_map(|seen| Some(HandMeasurement { image: self.image(seen.image)?, ..*seen }));
        let observations: Vec<HandMeasurement> = seen.collect();
        let holds = observations.len() >= 2;
        self.manual.push(holds.then(|| self.manual.iter().flatten().count() as u32));
        holds.then_some(BlockEdit::AddPoint { observations })
    }

    /// Whether coordinates hold that an edit adds: those of the system that the block has there, as far as both are known.
    fn add_control(&mut self, epsg: Option<u16>) -> bool {
        let own = self.before.system.clone().or(epsg.map(epsg_system));
        let holds = own.as_ref().zip(self.after.system.as_ref()).is_none_or(|(own, there)| own == there);
        let number = self.before.found + self.added.len();
        self.added.push(holds.then(|| self.after.found + self.added.iter().flatten().count()));
        if !holds {
            self.lose(number);
        }
        holds
    }

    fn image(&self, image: usize) -> Option<usize> {
        self.images.get(self.before.images.get(image)?.as_str()).copied()
    }

    fn images(&self, images: &[usize]) -> Option<Vec<usize>> {
        some(images.iter().filter_map(|image| self.image(*image)))
    }

    fn pairs(&self, pairs: &[[usize; 2]]) -> Option<Vec<[usize; 2]>> {
        let there = pairs.iter().filter_map(|[a, b]| Some([self.image(*a)?, self.image(*b)?]));
        some(there.filter(|pair| self.connected.contains(&ascending(*pair))))
    }

    fn points(&mut self, points: &[PointSource]) -> Option<Vec<PointSource>> {
        some(points.iter().filter_map(|point| self.point(*point, |_, _| true)))
    }

    fn observations(&mut self, observations: &[PointImage]) -> Option<Vec<PointImage>> {
        some(observations.iter().filter_map(|PointImage { point, image }| {
            let image = self.image(*image);
            let is_seen = |again: &PlaceAgain, measured: &BTreeSet<(usize, usize)>| {
                image.is_some_and(|image| again.images.contains(&image) || measured.contains(&(again.before, image)))
            };
            let point = self.point(*point, is_seen)?;
            Some(PointImage { point, image: image? })
        }))
    }

    /// What a point is there; `holds`: whether what is done to a place that lies there again holds.
    fn point(&mut self, point: PointSource, holds: impl FnOnce(&PlaceAgain, &BTreeSet<(usize, usize)>) -> bool) -> Option<PointSource> {
        let number = match point {
            PointSource::TiePoint(_) => return self.same_tie_points.then_some(point),
            PointSource::Manual(number) => return self.manual.get(number as usize).copied().flatten().map(PointSource::Manual),
            PointSource::GroundControl(number) => number,
        };
        if let Some(added) = number.checked_sub(self.before.found) {
            return self.added.get(added).copied().flatten().map(PointSource::GroundControl);
        }
        let name = *self.names.get(&number)?;
        if !is_found_place(name) {
            return self.surveyed.get(name).copied().map(PointSource::GroundControl);
        }
        let again = self.again.get(&number).filter(|again| holds(again, &self.measured)).map(|again| again.now);
        match again {
            Some(_) => drop(self.held.insert(number)),
            None => self.lose(number),
        }
        again.map(PointSource::GroundControl)
    }

    fn lose(&mut self, place: usize) {
        self.lost.insert(place);
        self.is_place_lost = true;
    }
}

/// Them, where there are any.
fn some<T>(found: impl Iterator<Item = T>) -> Option<Vec<T>> {
    let found: Vec<T> = found.collect();
    (!found.is_empty()).then_some(found)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::MeasuredBy;

    fn names(images: &[&str], surveyed: &[&str], connected: &[[usize; 2]]) -> EditNames {
        EditNames {
            images: images.iter().map(ToString::to_string).collect(),
            surveyed: surveyed.iter().enumerate().map(|(number, name)| (number, name.to_string())).collect(),
            connected: connected.to_vec(),
            found: surveyed.len(),
            system: None,
        }
    }

    fn seen(image: usize) -> HandMeasurement {
        HandMeasurement { image, x_px: 1.0, y_px: 2.0, by: MeasuredBy::Hand }
    }

    fn reject(point: PointSource) -> BlockEdit {
        BlockEdit::RejectPoints { points: vec![point] }
    }

    #[test]
    fn edits_follow_the_names_of_what_they_are_about() {
        let (before, after) = (names(&["a", "b", "c"], &["north", "south"], &[[0, 1]]), names(&["c", "b"], &["new", "south"], &[[0, 1]]));
        let edits = [
            BlockEdit::RejectImages { images: vec![0, 2] },
            BlockEdit::RejectPairs { pairs: vec![[0, 1], [2, 1]] },
            // The first one loses an image, and is numbered no more.
            BlockEdit::AddPoint { observations: vec![seen(0), seen(1)] },
            BlockEdit::AddPoint { observations: vec![seen(1), seen(2)] },
            reject(PointSource::Manual(0)),
            reject(PointSource::Manual(1)),
            reject(PointSource::TiePoint(5)),
            BlockEdit::SetUse { point: 1, role: None },
            BlockEdit::SetUse { point: 0, role: None },
        ];
        let steps: Vec<Vec<BlockEdit>> = edits.iter().map(|edit| vec![edit.clone()]).collect();
        let carrying = Carrying { done: steps.len(), steps, before, after, ..Carrying::default() };
        let carried = carried_steps(&carrying);
        let wanted = [
            BlockEdit::RejectImages { images: vec![0] },
            BlockEdit::RejectPairs { pairs: vec![[0, 1]] },
            BlockEdit::AddPoint { observations: vec![seen(1), seen(0)] },
            reject(PointSource::Manual(0)),
            BlockEdit::SetUse { point: 1, role: None },
        ];
        assert_eq!(carried.steps.concat(), wanted);
        assert_eq!((carried.lost, carried.left), (4, vec![0, 1, 2, 2, 3, 3, 4, 4, 5, 5]));
        assert!(carried_steps(&Carrying { same_tie_points: true, ..carrying }).steps.concat().contains(&reject(PointSource::TiePoint(5))));
    }

    #[test]
    fn a_step_that_was_undone_stays_whole_or_not_at_all() {
        let block = names(&["a", "b"], &["orthophoto_1", "orthophoto_2"], &[]);
        let place = |number| reject(PointSource::GroundControl(number));
        let steps = vec![vec![place(1), place(0)], vec![place(0)], vec![place(0), place(1)]];
        // The second place lies where the first one lay.
        let again = vec![PlaceAgain { before: 0, now: 1, is_same_spot: true, images: vec![0] }];
        let carried = carried_steps(&Carrying { steps, done: 1, before: block.clone(), after: block, again, same_tie_points: true });
        assert_eq!((carried.steps, carried.left, carried.aside), (vec![vec![place(1)], vec![place(1)]], vec![0, 1, 2, 2], vec![2]));
        assert_eq!((carried.lost, carried.places_held, carried.places_lost, carried.lost_for_places), (1, 1, 1, 1));
    }
}
