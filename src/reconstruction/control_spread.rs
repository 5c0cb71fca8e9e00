//! How the control points that take part are spread over a block: whether they check each other, what share of its ground they span, and whether
//! they lie almost on a line.

use super::level::uncertainty_deg;
use super::result::{ReconstructedModel, SurveyedPoint};
use super::warning::BlockWarning;
use crate::ControlRole;
use crate::adjustment::{ObservationVerdict, relative_width};

/// So many control points alone hardly check each other.
const FEW: usize = 3;
/// GNSS positions that are stated as precise as this in plan hold a block as control points do.
const PRECISE_GNSS_M: f64 = 0.1;
/// Control points lie almost on a line where they are spread across it by less than this share of what they are along it.
const NARROW: f64 = 0.1;
/// Control points that span less of the ground of a block than this leave most of it to extrapolation.
const LEAST_SPAN: f64 = 0.25;

/// What of it deserves a warning.
pub(super) fn of_spread(model: &ReconstructedModel) -> Vec<BlockWarning> {
    let adjusted = &model.adjusted;
    if !model.in_system || !adjusted.datum.uses_control() {
        return Vec::new();
    }
    let taking = adjusted.block.control.iter().zip(&adjusted.control).filter(|(_, statistics)| statistics.is_some());
    let places: Vec<[f64; 3]> = taking.map(|(control, _)| adjusted.block.points[control.point]).collect();
    let points = places.len();
    let gnss = adjusted.images.iter().filter(|image| image.gnss.is_some_and(|gnss| gnss.accepted)).count();
    let is_few = points > 0 && points <= FEW && gnss < FEW;
    let few = is_few.then(|| BlockWarning::FewControl { points, positions: gnss, detectable_m: detectable(model) });
    few.into_iter().chain(if held_by_gnss(model) { None } else { narrow(model, &places).or_else(|| small(model, &places)) }).collect()
}

/// The error of a coordinate that its test finds, of that where it is largest, as the table of surveyed points has it; absent where one is not checked at all.
fn detectable(model: &ReconstructedModel) -> Option<f64> {
    let takes_part = |point: &&SurveyedPoint| point.role == ControlRole::Control && point.refused.is_none_or(|refused| refused.is_used);
    let mut all = model.surveyed.iter().filter(takes_part).flat_map(|point| point.detectable_m);
    all.try_fold(0.0, |most: f64, detectable| Some(most.max(detectable?)))
}

/// Whether most of the images have positions that are as precise as control points.
fn held_by_gnss(model: &ReconstructedModel) -> bool {
    let images = model.adjusted.block.images.iter().zip(&model.adjusted.images);
    let precise = images.filter(|(image, statistics)| {
        let sigma = image.gnss.filter(|_| statistics.gnss.is_some_and(|gnss| gnss.accepted)).map(|gnss| gnss.sigma);
        sigma.is_some_and(|[x, y, _]| [x, y].into_iter().all(|sigma| sigma.is_some_and(|sigma| sigma <= PRECISE_GNSS_M)))
    });
    2 * precise.count() > model.images.len()
}

fn narrow(model: &ReconstructedModel, places: &[[f64; 3]]) -> Option<BlockWarning> {
    let width = if places.len() < FEW { return None } else { relative_width(places) };
    let error_deg = uncertainty_deg(&model.adjusted);
    (width < NARROW).then_some(BlockWarning::ControlOnLine { points: places.len(), width_percent: 100.0 * width, error_deg })
}

/// By the area in plan: that of a wall is none, and says nothing.
fn small(model: &ReconstructedModel, places: &[[f64; 3]]) -> Option<BlockWarning> {
    let adjusted = &model.adjusted;
    let mut seen = vec![false; adjusted.block.points.len()];
    let accepted = adjusted.block.rays.iter().zip(&adjusted.rays).filter(|(_, ray)| ray.verdict == ObservationVerdict::Accepted);
    accepted.for_each(|(ray, _)| seen[ray.point] = true);
    let plan = |[x, y, _]: [f64; 3]| [x, y];
    let ground = hull_area(adjusted.block.points.iter().zip(seen).filter(|(_, seen)| *seen).map(|(place, _)| plan(*place)).collect());
    let share = hull_area(places.iter().map(|place| plan(*place)).collect()) / ground;
    let is_small = places.len() >= FEW && share < LEAST_SPAN;
    is_small.then_some(BlockWarning::ControlSpan { points: places.len(), span_percent: 100.0 * share })
}

/// Area of the convex hull of places; 0 for fewer than three.
///
/// # Source
/// Andrew 1979, Another efficient algorithm for convex hulls in two dimensions.
fn hull_area(mut places: Vec<[f64; 2]>) -> f64 {
    places.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let turn = |a: [f64; 2], b: [f64; 2], c: [f64; 2]| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    let chain = |places: &mut dyn Iterator<Item = [f64; 2]>| {
        let mut chain: Vec<[f64; 2]> = Vec::new();
        for place in places {
            while let [.., a, b] = chain[..]
                && turn(a, b, place) <= 0.0
            {
                chain.pop();
            }
            chain.push(place);
        }
        chain.pop();
        chain
    };
    let (lower, upper) = (chain(&mut places.iter().copied()), chain(&mut places.iter().rev().copied()));
    let around = [lower, upper].concat();
    let twice: f64 = (0..around.len()).map(|k| (around[k], around[(k + 1) % around.len()])).map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum();
    0.5 * twice.abs()
}

#[cfg(test)]
mod tests {
    use super::hull_area;

    #[test]
    fn the_area_of_a_hull_is_that_of_its_corners() {
        let square = vec![[1.0, 1.0], [3.0, 1.0], [2.0, 2.0], [3.0, 3.0], [1.0, 3.0], [2.0, 1.0]];
        assert_eq!(hull_area(square), 4.0);
        assert_eq!(hull_area(vec![[0.0, 0.0], [4.0, 0.0], [0.0, 2.0]]), 4.0);
        for none in [vec![], vec![[1.0, 2.0]], vec![[1.0, 2.0], [3.0, 4.0]], vec![[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]]] {
            assert_eq!(hull_area(none), 0.0);
        }
    }
}
