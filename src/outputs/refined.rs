//! What became of the observations of a model in the refinement.

use crate::{BlockModel, ImageObservation, ObjectPoint, RefinedObservation, RefinementTable};
use std::collections::BTreeMap;

/// For each point of the model and each of its observations the refined one; absent for those of ground control points, which are given.
///
/// A point of the model is the refined point that it has most observations in common with: an image may show two features at one place.
pub(super) fn refined_observations<'a>(model: &BlockModel, table: &'a RefinementTable) -> Vec<Vec<Option<&'a RefinedObservation>>> {
    let places = by_place(table);
    let at = |ray: &ImageObservation| places.get(&(ray.image, [ray.x_px, ray.y_px].map(f64::to_bits))).map_or(&[][..], |all| &all[..]);
    let of_point = |point: &ObjectPoint| {
        let mut common: BTreeMap<usize, usize> = BTreeMap::new();
        point.rays.iter().flat_map(at).for_each(|(refined, _)| *common.entry(*refined).or_default() += 1);
        // Of equally many, the first.
        let most = common.into_iter().max_by_key(|(refined, count)| (*count, std::cmp::Reverse(*refined)));
        let own =
            |ray| most.and_then(|(most, _)| at(ray).iter().find(|(refined, _)| *refined == most).map(|(_, observation)| *observation));
        point.rays.iter().map(own).collect()
    };
    model.points.iter().map(of_point).collect()
}

/// A position of an image, by the bits of its coordinates.
type Place = (usize, [u64; 2]);

/// The refined observations at each place, each with its point.
fn by_place(table: &RefinementTable) -> BTreeMap<Place, Vec<(usize, &RefinedObservation)>> {
    let mut places: BTreeMap<Place, Vec<_>> = BTreeMap::new();
    for (point, ends) in table.starts.windows(2).enumerate() {
        for observation in table.observations.get(ends[0] as usize..ends[1] as usize).unwrap_or_default() {
            let place = observation.position_px.map(|v| f64::from(v).to_bits());
            places.entry((observation.image as usize, place)).or_default().push((point, observation));
        }
    }
    places
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::RefinementOutcome::{self, LowCorrelation, Reference, Refined};

    #[test]
    fn two_features_at_one_place_of_an_image_keep_the_outcomes_of_their_own_points() {
        let observed =
            |image, x, y, outcome| RefinedObservation { image, position_px: [x, y], outcome, standard_error_px: None, correlation: None };
        let table = RefinementTable {
            starts: vec![0, 2, 4],
            observations: vec![
                observed(0, 1.0, 2.0, Reference),
                observed(1, 30.0, 40.0, Refined),
                observed(0, 5.0, 6.0, Reference),
                observed(1, 30.0, 40.0, LowCorrelation),
            ],
        };
        let point = |rays: &[(usize, f64, f64)]| ObjectPoint {
            number: None,
            position: None,
            colour: [0; 3],
            rmse_px: None,
            confidence: 1.0,
            by_hand: 0,
            name: None,
            rays: rays
                .iter()
                .map(|(image, x_px, y_px)| ImageObservation { image: *image, x_px: *x_px, y_px: *y_px, confidence: 1.0 })
                .collect(),
        };
        let points = vec![point(&[(0, 5.0, 6.0), (1, 30.0, 40.0)]), point(&[(0, 1.0, 2.0), (1, 30.0, 40.0)]), point(&[(1, 3.0, 4.0)])];
        let model = BlockModel { points, ..BlockModel::default() };
        let found: Vec<Option<RefinementOutcome>> =
            refined_observations(&model, &table).into_iter().flatten().map(|found| found.map(|found| found.outcome)).collect();
        assert_eq!(found, [Some(Reference), Some(LowCorrelation), Some(Reference), Some(Refined), None]);
    }
}
