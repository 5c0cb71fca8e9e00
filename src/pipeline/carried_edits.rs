//! Edits of a block on an orthophoto, carried to the same block once it is placed anew: those of places hold where the places lie again.

use super::BlockRun;
use super::carrying::{Carrying, EditNames, carried_steps};
use super::place_names::PLACE_NAME;
use super::places::BlockPlaces;
use crate::error::refuse;
use crate::{BlockEdit, Connection, Error, PairOutcome, Refusal};
use serde::Serialize;

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
        Ok(carried(before, &now, &self.connections, edits))
    }
}

fn carried(before: &BlockPlaces, now: &BlockPlaces, connections: &[Connection], edits: &[BlockEdit]) -> CarriedEdits {
    let matched = connections.iter().filter(|pair| matches!(pair.outcome, PairOutcome::Connected { .. }));
    let connected: Vec<[usize; 2]> = matched.map(|pair| pair.images.map(|image| image as usize)).collect();
    let names = |of: &BlockPlaces| EditNames {
        images: of.images.clone(),
        // Given points are the same ones, and places are what lies where they lay, whatever they are called.
        surveyed: (0..of.surveyed())
            .map(|number| (number, format!("{}{number}", if number < of.given { "" } else { PLACE_NAME })))
            .collect(),
        connected: connected.clone(),
        found: of.surveyed(),
        system: of.system.clone(),
    };
    let steps: Vec<Vec<BlockEdit>> = edits.iter().map(|edit| vec![edit.clone()]).collect();
    let (done, again) = (steps.len(), now.again(before));
    let carried = carried_steps(&Carrying { steps, done, before: names(before), after: names(now), same_tie_points: true, again });
    CarriedEdits { edits: carried.steps.concat(), held: carried.places_held, lost: carried.places_lost }
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
        let of_places = carried(&block(None, 2), &now, &[], &edits);
        assert_eq!(of_places, CarriedEdits { edits: vec![add("new", Some(25_833)), set_use(4)], held: 0, lost: 1 });
        assert_eq!(carried(&block(Some("EPSG:25832"), 2), &now, &[], &edits), CarriedEdits { edits: Vec::new(), held: 0, lost: 2 });
        let alike = [vec![add("old", Some(25_832)), add("new", Some(25_833))], vec![set_use(4), set_use(5)]].concat();
        for (own, now) in [(Some("EPSG:25833"), now), (None, block(None, 4))] {
            assert_eq!(carried(&block(own, 2), &now, &[], &edits), CarriedEdits { edits: alike.clone(), held: 0, lost: 0 });
        }
    }
}
