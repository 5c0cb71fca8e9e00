//! Edits of a block on an orthophoto, carried to the same block once it is placed anew: those of places hold where the places lie again.

use super::BlockRun;
use super::places::{BlockPlaces, PlaceAgain};
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
    /// Of so many it does not: nothing lies there now, the image does not show it, or what was measured by hand is of another spot.
    pub lost: usize,
}

impl BlockRun {
    /// The edits of the same block as it was placed before, for the block as it is placed now: images, pairs, tie points and given points are the same ones, surveyed points that edits add are numbered behind those of this
    /// block, and a place of the orthophoto is the one that lies where it lay ([`BlockPlaces::again`]). What was measured by hand holds of the same spot alone. They are not applied.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for a block of other images, tie points or given points; as [`places`](Self::places).
    pub fn carried_edits(&self, before: &BlockPlaces, edits: &[BlockEdit]) -> Result<CarriedEdits, Error> {
        let now = self.places()?;
        if !now.is_of_block(before) {
            return refuse(Refusal::EditsOfOtherBlock);
        }
        let again = now.again(before).into_iter().map(|one| (one.before, one)).collect();
        let mut carrier = Carrier { before, now: &now, again, measured: BTreeSet::new(), held: 0, lost: 0 };
        let edits = edits.iter().filter_map(|edit| carrier.carried(edit)).collect();
        Ok(CarriedEdits { edits, held: carrier.held, lost: carrier.lost })
    }
}

struct Carrier<'a> {
    before: &'a BlockPlaces,
    now: &'a BlockPlaces,
    /// By their numbers before.
    again: BTreeMap<usize, PlaceAgain>,
    /// Observations of places that edits add: of which number before, and in which image.
    measured: BTreeSet<(usize, usize)>,
    held: usize,
    lost: usize,
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
            | BlockEdit::AddPoint { .. }
            | BlockEdit::AddControl { .. } => Some(edit.clone()),
        }
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
            return Some(PointSource::GroundControl(self.now.surveyed() + added));
        }
        match self.again.get(&number).filter(|again| holds(again, &self.measured)) {
            Some(again) => {
                self.held += 1;
                Some(PointSource::GroundControl(again.now))
            }
            None => {
                self.lost += 1;
                None
            }
        }
    }
}
