//! Edits of a block on an orthophoto, carried to the same block once it is placed anew: those of places hold where the places lie again.

use super::BlockRun;
use super::places::{BlockPlaces, PlaceAgain, epsg_system};
use crate::error::refuse;
use crate::{BlockEdit, Error, PointImage, PointSource, Refusal};
use serde::Serialize;
use std::collections::{BTreeMap, BTreeSet};

/// Edits that hold of a block that was placed anew.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct CarriedEdits {
    pub edits: Vec<BlockEdit>,
    /// What was done to so many places of the orthophoto, or to observations of them, holds.
    pub held: usize,
    /// Of so many something does not: nothing lies there now, the image does not show it, what was measured by hand is of another spot, or it is a place
    /// by hand whose coordinates are of another system.
    pub lost: usize,
}

impl BlockRun {
    /// The edits of the same block as it was placed before, for the block as it is placed now: images, pairs, tie points and given points are the same ones, surveyed points that edits add are numbered behind those of this
    /// block, and a place of the orthophoto is the one that lies where it lay ([`BlockPlaces::again`]). What was measured by hand holds of the same spot alone, and coordinates that edits
    /// add in the same system. They are not applied.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for a block of other images, tie points or given points; as [`places`](Self::places).
    pub fn carried_edits(&self, before: &BlockPlaces, edits: &[BlockEdit]) -> Result<CarriedEdits, Error> {
        let now = self.places()?;
        if !now.is_of_block(before) {
            return refuse(Refusal::EditsOfOtherBlock);
        }
        Ok(carried(before, &now, edits))
    }
}

fn carried(before: &BlockPlaces, now: &BlockPlaces, edits: &[BlockEdit]) -> CarriedEdits {
    let again = now.again(before).into_iter().map(|one| (one.before, one)).collect();
    let (measured, held, lost) = (BTreeSet::new(), BTreeSet::new(), BTreeSet::new());
    let mut carrier = Carrier { before, now, again, measured, added: Vec::new(), held, lost };
    let edits = edits.iter().filter_map(|edit| carrier.carried(edit)).collect();
    CarriedEdits { edits, held: carrier.held.len(), lost: carrier.lost.len() }
}

struct Carrier<'a> {
    before: &'a BlockPlaces,
    now: &'a BlockPlaces,
    /// By their numbers before.
    again: BTreeMap<usize, PlaceAgain>,
    /// Observations of places that edits add: of which number before, and in which image.
    measured: BTreeSet<(usize, usize)>,
    /// Of the surveyed points that edits add, their numbers now; absent for those that do not hold.
    added: Vec<Option<usize>>,
    /// Numbers of places before.
    held: BTreeSet<usize>,
    lost: BTreeSet<usize>,
}

impl Carrier<'_> {
    fn carried(&mut self, edit: &BlockEdit) -> Option<BlockEdit> {
        match edit {
            BlockEdit::RejectPoints { points } => self.points(points).map(|points| BlockEdit::RejectPoints { points }),
            BlockEdit::RestorePoints { points } => self.points(points).map(|points| BlockEdit::RestorePoints { points }),
            BlockEdit::RejectObservations { observations } => {
                self.observations(observations).map(|observations| BlockEdit::RejectObservations { observations })
            }
            BlockEdit::RestoreObservations { observations } => {
                self.observations(observations).map(|observations| BlockEdit::RestoreObservations { observations })
            }
            BlockEdit::Measure { point, image, x_px, y_px, by } => {
                let point = self.point(*point, |again, _| again.is_same_spot)?;
                if let BlockEdit::Measure { point: PointSource::GroundControl(number), .. } = edit {
                    self.measured.insert((*number, *image));
                }
                Some(BlockEdit::Measure { point, image: *image, x_px: *x_px, y_px: *y_px, by: *by })
            }
            BlockEdit::SetUse { point, role } => match self.point(PointSource::GroundControl(*point), |_, _| true)? {
                PointSource::GroundControl(point) => Some(BlockEdit::SetUse { point, role: *role }),
                PointSource::TiePoint(_) | PointSource::Manual(_) => None,
            },
            BlockEdit::RejectImages { .. }
            | BlockEdit::RestoreImages { .. }
            | BlockEdit::RejectPairs { .. }
            | BlockEdit::RestorePairs { .. }
            | BlockEdit::AddPoint { .. } => Some(edit.clone()),
            BlockEdit::AddControl { epsg, .. } => {
                let number = self.before.surveyed() + self.added.len();
                let holds = self.is_in_system_now(*epsg);
                self.added.push(holds.then(|| self.now.surveyed() + self.added.iter().flatten().count()));
                if !holds {
                    self.lost.insert(number);
                }
                holds.then(|| edit.clone())
            }
        }
    }

    /// Whether coordinates are of the system that the block has now, as far as both are known.
    fn is_in_system_now(&self, epsg: Option<u16>) -> bool {
        let own = self.before.system.clone().or(epsg.map(epsg_system));
        own.as_ref().zip(self.now.system.as_ref()).is_none_or(|(own, now)| own == now)
    }

    fn points(&mut self, points: &[PointSource]) -> Option<Vec<PointSource>> {
        let held: Vec<PointSource> = points.iter().filter_map(|point| self.point(*point, |_, _| true)).collect();
        (!held.is_empty()).then_some(held)
    }

    fn observations(&mut self, observations: &[PointImage]) -> Option<Vec<PointImage>> {
        let one = |PointImage { point, image }: &PointImage| {
            let is_seen = |again: &PlaceAgain, measured: &BTreeSet<(usize, usize)>| {
                again.images.binary_search(image).is_ok() || measured.contains(&(again.before, *image))
            };
            Some(PointImage { point: self.point(*point, is_seen)?, image: *image })
        };
        let held: Vec<PointImage> = observations.iter().filter_map(one).collect();
        (!held.is_empty()).then_some(held)
    }

    /// What a point is now; `holds`: whether what is done to a place that lies there again holds.
    fn point(&mut self, point: PointSource, holds: impl FnOnce(&PlaceAgain, &BTreeSet<(usize, usize)>) -> bool) -> Option<PointSource> {
        let PointSource::GroundControl(number) = point else { return Some(point) };
        if number < self.before.given {
            return Some(point);
        }
        if let Some(added) = number.checked_sub(self.before.surveyed()) {
            return self.added.get(added).copied().flatten().map(PointSource::GroundControl);
        }
        match self.again.get(&number).filter(|again| holds(again, &self.measured)) {
            Some(again) => {
                self.held.insert(number);
                Some(PointSource::GroundControl(again.now))
            }
            None => {
                self.lost.insert(number);
                None
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ControlRole;

    #[test]
    fn coordinates_of_another_system_are_lost_and_those_behind_them_move_up() {
        let block = |system: Option<&str>, given| BlockPlaces {
            images: vec!["a".into(), "b".into()],
            tie_points: None,
            given,
            system: system.map(String::from),
            places: Vec::new(),
        };
        let add = |name: &str, epsg| BlockEdit::AddControl {
            name: name.into(),
            position: [3.0e5, 5.8e6, 40.0],
            standard_errors: None,
            sigma_px: None,
            role: ControlRole::Control,
            epsg,
            remarks: Vec::new(),
        };
        let set_use = |point| BlockEdit::SetUse { point, role: None };
        let edits = [add("old", Some(25_832)), add("new", Some(25_833)), set_use(2), set_use(3)];
        let now = block(Some("EPSG:25833"), 4);
        // Where nothing is known of the block, the code of the place says what its coordinates are.
        let of_places = carried(&block(None, 2), &now, &edits);
        assert_eq!(of_places, CarriedEdits { edits: vec![add("new", Some(25_833)), set_use(4)], held: 0, lost: 1 });
        assert_eq!(carried(&block(Some("EPSG:25832"), 2), &now, &edits), CarriedEdits { edits: Vec::new(), held: 0, lost: 2 });
        let alike = [vec![add("old", Some(25_832)), add("new", Some(25_833))], vec![set_use(4), set_use(5)]].concat();
        for (own, now) in [(Some("EPSG:25833"), now), (None, block(None, 4))] {
            assert_eq!(carried(&block(own, 2), &now, &edits), CarriedEdits { edits: alike.clone(), held: 0, lost: 0 });
        }
    }
}
