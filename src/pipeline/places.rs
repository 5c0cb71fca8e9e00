//! The places of an orthophoto that a block has, and which of them is which once the block is placed anew: their names are others then.

use super::BlockRun;
use super::OnOrthophoto;
use super::place_names::is_place_of_orthophoto;
use crate::{Error, PointSource, ReconstructedModel, parse_ground_control_points};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A place is the former one again within half the side of a square of the ground, in images that show both: a square is a tenth of the longer side of an image.
const HALF_SQUARE: f64 = 1.0 / 20.0;
/// What was measured by hand is of that spot alone: places are one up to so many px, half the standard error of such a measurement.
const ONE_SPOT_PX: f64 = 0.5;

/// The surveyed points of a block as far as edits of places of an orthophoto name them.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct BlockPlaces {
    /// The names of the images, by their indices.
    pub images: Vec<String>,
    /// How many tie points were joined, and their observations; absent where an older project file does not say.
    pub tie_points: Option<[usize; 2]>,
    /// How many surveyed points were given: the first ones.
    pub given: usize,
    /// The system of their coordinates: that which was chosen for the block, else `EPSG:` and the code of the orthophoto; absent where none is known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub system: Option<String>,
    /// Those that were found on the orthophoto, behind them; one that is not in the block is seen nowhere.
    pub places: Vec<SeenPlace>,
}

/// A place of an orthophoto in the images that show it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct SeenPlace {
    pub seen: Vec<SeenIn>,
}

/// Where an image shows a place.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct SeenIn {
    /// Index of the image.
    pub image: usize,
    /// Column and row in px.
    pub at_px: [f64; 2],
    /// The longer side of the image in px.
    pub side_px: u32,
}

/// A place that lies where one lay when the block was placed before.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct PlaceAgain {
    /// Its number among the surveyed points before, and now.
    pub before: usize,
    pub now: usize,
    /// Whether it is the same spot, so that what was measured of it by hand holds.
    pub is_same_spot: bool,
    /// Indices of the images that it was found in, ascending.
    pub images: Vec<usize>,
}

impl BlockRun {
    /// The surveyed points that it was found with: edits change nothing of them.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for a project file whose tables of control points are damaged.
    pub fn places(&self) -> Result<BlockPlaces, Error> {
        let rows = self.input.control.as_ref().map(|texts| parse_ground_control_points(&texts.points)).transpose()?.unwrap_or_default();
        // Those that are off have no number.
        let (places, given): (Vec<_>, Vec<_>) =
            rows.into_iter().filter(|row| row.role.is_some()).partition(|row| is_place_of_orthophoto(&row.name));
        let mut known: Vec<SeenPlace> = vec![SeenPlace { seen: Vec::new() }; places.len()];
        let found = self.edited.as_ref().map(|edited| &edited.reconstruction).or(self.reconstruction.as_ref().ok());
        for point in found.and_then(|found| found.models.first()).map(ReconstructedModel::observed_points).into_iter().flatten() {
            let PointSource::GroundControl(number) = point.source else { continue };
            if let Some(place) = number.checked_sub(given.len()).and_then(|place| known.get_mut(place)) {
                let seen = point.rays.iter().filter_map(|ray| Some((ray, self.images.get(ray.image)?)));
                place.seen = seen
                    .map(|(ray, image)| SeenIn { image: ray.image, at_px: ray.at_px, side_px: image.width_px.max(image.height_px) })
                    .collect();
            }
        }
        Ok(BlockPlaces {
            images: self.images.iter().map(|image| image.name.clone()).collect(),
            tie_points: self.points.as_ref().map(|points| [points.count, points.rays]),
            given: given.len(),
            system: self.system_of_places(),
            places: known,
        })
    }
}

/// The system with an EPSG code.
pub(super) fn epsg_system(code: u16) -> String {
    format!("EPSG:{code}")
}

impl BlockRun {
    fn system_of_places(&self) -> Option<String> {
        let code = |outcome: &OnOrthophoto| match outcome {
            OnOrthophoto::Linked { epsg, .. } | OnOrthophoto::ByHand { epsg, .. } => *epsg,
            OnOrthophoto::NotLinked { .. } => None,
        };
        let found = self.edited.as_ref().and_then(|edited| edited.orthophoto.as_ref());
        let code = self.orthophoto.iter().chain(found).find_map(code);
        self.input.settings.placing.crs.clone().or(code.map(epsg_system))
    }
}

impl BlockPlaces {
    /// How many surveyed points the block was found with.
    pub(super) fn surveyed(&self) -> usize {
        self.given + self.places.len()
    }

    /// Whether images, tie points and given points are those of the other block, so that edits number them alike.
    pub(super) fn is_of_block(&self, other: &Self) -> bool {
        let joined_alike = self.tie_points.zip(other.tie_points).is_none_or(|(own, other)| own == other);
        self.images == other.images && joined_alike && self.given == other.given
    }

    /// Of each place that a block had before and that has one where it lay, which that is: the nearest to it within half a square, to which it is the nearest one, in images of the same names that show both. They are in the order in which they were
    /// numbered before. Neither systems nor names of the orthophotos matter.
    #[must_use]
    pub fn again(&self, before: &Self) -> Vec<PlaceAgain> {
        let former = before.seen_in(&self.images);
        let (onto, back) = (nearest(&former, &self.places), nearest(&self.places, &former));
        let mutual = onto.iter().enumerate().filter_map(|(former, found)| {
            let (now, apart_px) = (*found)?;
            (back[now]?.0 == former).then_some((former, now, apart_px))
        });
        let again = mutual.map(|(former, now, apart_px)| {
            let mut images: Vec<usize> = self.places[now].seen.iter().map(|seen| seen.image).collect();
            images.sort_unstable();
            PlaceAgain { before: before.given + former, now: self.given + now, is_same_spot: apart_px <= ONE_SPOT_PX, images }
        });
        again.collect()
    }

    /// Its places in the images that another block has, by their indices there; one that none of them shows is seen nowhere.
    fn seen_in(&self, images: &[String]) -> Vec<SeenPlace> {
        let indices: BTreeMap<&String, usize> = images.iter().enumerate().map(|(index, name)| (name, index)).collect();
        let there = |seen: &SeenIn| Some(SeenIn { image: *indices.get(self.images.get(seen.image)?)?, ..*seen });
        self.places.iter().map(|place| SeenPlace { seen: place.seen.iter().filter_map(there).collect() }).collect()
    }
}

/// Of each place the nearest one of the others within half a square, and how far it is in px.
fn nearest(of: &[SeenPlace], among: &[SeenPlace]) -> Vec<Option<(usize, f64)>> {
    let mut in_image: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for (index, place) in among.iter().enumerate() {
        place.seen.iter().for_each(|seen| in_image.entry(seen.image).or_default().push(index));
    }
    let one = |place: &SeenPlace| {
        let mut best: Option<(f64, usize, f64)> = None;
        for index in place.seen.iter().flat_map(|seen| in_image.get(&seen.image).into_iter().flatten()) {
            let Some((share, apart_px)) = apart(place, &among[*index]).filter(|(share, _)| *share <= HALF_SQUARE) else { continue };
            if best.is_none_or(|(least, known, _)| share < least || (share == least && *index < known)) {
                best = Some((share, *index, apart_px));
            }
        }
        best.map(|(_, index, apart_px)| (index, apart_px))
    };
    of.iter().map(one).collect()
}

/// How far two places are from each other in the mean of the images that show both, as a share of their longer side and in px; `None` where none does.
fn apart(a: &SeenPlace, b: &SeenPlace) -> Option<(f64, f64)> {
    let both = a.seen.iter().filter_map(|one| Some((one, b.seen.iter().find(|other| other.image == one.image)?)));
    let (mut share, mut px, mut count) = (0.0, 0.0, 0.0);
    for (one, other) in both {
        let distance = libm::hypot(one.at_px[0] - other.at_px[0], one.at_px[1] - other.at_px[1]);
        (share, px, count) = (share + distance / f64::from(one.side_px), px + distance, count + 1.0);
    }
    (count > 0.0).then(|| (share / count, px / count))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Places in images of 1000 px.
    fn places(given: usize, places: &[&[(usize, f64)]]) -> BlockPlaces {
        let seen = |(image, x): &(usize, f64)| SeenIn { image: *image, at_px: [*x, 7.0], side_px: 1000 };
        let places = places.iter().map(|place| SeenPlace { seen: place.iter().map(seen).collect() }).collect();
        BlockPlaces { images: vec!["a".into(), "b".into(), "c".into()], tie_points: None, given, system: None, places }
    }

    #[test]
    fn a_place_is_the_one_that_lies_where_it_lay_whatever_it_is_called() {
        let before = places(1, &[&[(0, 100.0), (1, 300.0)], &[(1, 500.0), (2, 800.0)], &[(0, 900.0), (1, 950.0)]]);
        // The first is 0.4 px off, the second 40 px, the third 51 px: beyond half a square.
        let now = places(2, &[&[(2, 760.0), (0, 20.0)], &[(0, 849.0), (1, 899.0)], &[(1, 300.4), (0, 100.4)]]);
        let again = |before, now, is_same_spot, images: &[usize]| PlaceAgain { before, now, is_same_spot, images: images.to_vec() };
        assert_eq!(now.again(&before), [again(1, 4, true, &[0, 1]), again(2, 2, false, &[0, 2])]);
        assert!(now.again(&places(1, &[])).is_empty() && places(1, &[]).again(&before).is_empty());
    }

    #[test]
    fn a_place_is_not_two_former_ones_and_no_neighbour_takes_the_edits_of_another() {
        // Two places lay about the one that is there now: the nearer one it is.
        let before = places(0, &[&[(0, 100.0), (1, 100.0)], &[(0, 140.0), (1, 140.0)]]);
        let now = places(0, &[&[(0, 130.0), (1, 130.0)]]);
        assert_eq!(now.again(&before).iter().map(|one| (one.before, one.now)).collect::<Vec<_>>(), [(1, 0)]);
        // In a block without the first image, the others of which are other ones by their indices.
        let others = BlockPlaces { images: vec!["c".into(), "b".into()], ..places(0, &[&[(1, 110.0)]]) };
        assert_eq!(others.again(&before).iter().map(|one| (one.before, one.images.clone())).collect::<Vec<_>>(), [(0, vec![1])]);
        // Without an image in common nothing says that they are one.
        assert!(places(0, &[&[(2, 100.0)]]).again(&before).is_empty());
    }
}
