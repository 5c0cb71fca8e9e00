//! Control points that do not place a block since their distances from each other are not those in the block.

use super::result::{PointSource, ReconstructedModel};
use super::warning::BlockWarning;
use crate::math::{dot3, minus};
use crate::model::BlockDescription;

/// Distances that differ by a larger share than this are told.
const LEAST_DIFFERENCE: f64 = 0.01;

/// Two control points, by their places among those that are compared, and how large their coordinates make the block.
#[derive(Clone, Copy)]
struct Distance {
    of: [usize; 2],
    scale: f64,
}

/// What of it deserves a warning, in a block that nothing places.
pub(super) fn of_shape(model: &ReconstructedModel, description: &BlockDescription) -> Option<BlockWarning> {
    if model.in_system {
        return None;
    }
    let adjusted = &model.adjusted;
    let given = adjusted.block.control.iter().filter_map(|control| {
        let PointSource::GroundControl(index) = model.points[control.point] else { return None };
        adjusted.points[control.point].as_ref().map(|_| (index, control.position, adjusted.block.points[control.point]))
    });
    let (names, places): (Vec<String>, Vec<[[f64; 3]; 2]>) =
        given.map(|(index, position, place)| (description.control[index].name.clone(), [position, place])).unzip();
    let all = distances(&places);
    let [shortest, longest] = extremes(&all)?;
    let ratio = longest.scale / shortest.scale;
    let fits = |all: &[Distance]| extremes(all).is_some_and(|[a, b]| b.scale / a.scale < 1.0 + LEAST_DIFFERENCE);
    let without = |point: usize| all.iter().filter(|distance| !distance.of.contains(&point)).copied().collect::<Vec<_>>();
    // Of three points two are left, whose distance fits by itself.
    let mut odd = (0..places.len()).filter(|point| places.len() > 3 && fits(&without(*point)));
    let point = odd.next().filter(|_| odd.next().is_none()).map(|point| names[point].clone());
    let pair = |distance: Distance| distance.of.map(|point| names[point].as_str()).join(" – ");
    let (longest, shortest) = (pair(longest), pair(shortest));
    (places.len() >= 3 && ratio >= 1.0 + LEAST_DIFFERENCE).then_some(BlockWarning::ControlShape { names, ratio, longest, shortest, point })
}

/// Surveyed by adjusted distances of all pairs of points.
fn distances(places: &[[[f64; 3]; 2]]) -> Vec<Distance> {
    let length = |a: &[f64; 3], b: &[f64; 3]| {
        let d = minus(a, b);
        dot3(&d, &d).sqrt()
    };
    let pairs = (0..places.len()).flat_map(|b| (0..b).map(move |a| [a, b]));
    let of = |of: [usize; 2]| {
        let [a, b] = of.map(|point| &places[point]);
        Distance { of, scale: length(&a[0], &b[0]) / length(&a[1], &b[1]) }
    };
    pairs.map(of).filter(|distance| distance.scale.is_finite() && distance.scale > 0.0).collect()
}

/// Those that make the block smallest and largest.
fn extremes(all: &[Distance]) -> Option<[Distance; 2]> {
    let by = |a: &&Distance, b: &&Distance| a.scale.total_cmp(&b.scale);
    Some([*all.iter().min_by(by)?, *all.iter().max_by(by)?])
}

#[cfg(test)]
mod tests {
    use super::{distances, extremes};

    #[test]
    fn distances_make_a_block_as_large_as_they_are_in_it() {
        let place = |[x, y]: [f64; 2], error: f64| [[2.0 * x + error, 2.0 * y, 0.0], [x, y, 0.0]];
        let all = distances(&[place([0.0, 0.0], 0.0), place([3.0, 0.0], 1.0), place([0.0, 4.0], 0.0)]);
        let [shortest, longest] = extremes(&all).unwrap();
        assert_eq!((all.len(), shortest.of, longest.of), (3, [0, 2], [0, 1]));
        assert!((shortest.scale - 2.0).abs() < 1e-12 && (longest.scale - 7.0 / 3.0).abs() < 1e-12);
    }
}
