//! Which places of an orthophoto are gross errors beside the places around them.
//!
//! Standard errors that stand for what neighbours share hide what is wrong with a single place, and a block that hardly follows its places bends away
//! from all of one region. Both are alike for neighbours: what a residual differs from theirs by is its own.

use super::place_factors::PlaceResidual;
use crate::math::{NORMAL_MEDIAN, median};

/// Places beside which one is judged: more than half of them are right, whatever is wrong with one in ten.
const NEIGHBOURS: usize = 8;

/// The largest of what each place's residuals differ by from those around it, by how these differences scatter, or by what is stated of one where
/// that is more. Places of no finite residual are no neighbours, and differ by nothing.
pub(super) fn beside_neighbours(places: &[PlaceResidual]) -> Vec<f64> {
    let is_known = |place: &PlaceResidual| place.residual.iter().chain(&place.at).all(|value| value.is_finite());
    let known: Vec<usize> = (0..places.len()).filter(|index| is_known(&places[*index])).collect();
    let mut differences = vec![[0.0; 3]; places.len()];
    for &index in &known {
        let place = &places[index];
        let mut others: Vec<(f64, usize)> = known
            .iter()
            .filter(|other| **other != index)
            .map(|other| (libm::hypot(places[*other].at[0] - place.at[0], places[*other].at[1] - place.at[1]), *other))
            .collect();
        if others.len() > NEIGHBOURS {
            others.select_nth_unstable_by(NEIGHBOURS, |a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
            others.truncate(NEIGHBOURS);
        }
        differences[index] = [0, 1, 2].map(|axis| {
            let mut around: Vec<f64> = others.iter().map(|(_, other)| places[*other].residual[axis]).collect();
            median(&mut around).map_or(0.0, |middle| place.residual[axis] - middle)
        });
    }
    let scatter = |axes: std::ops::Range<usize>| {
        let mut sizes: Vec<f64> = known.iter().flat_map(|index| differences[*index][axes.clone()].iter().map(|d| d.abs())).collect();
        median(&mut sizes).map_or(1.0, |middle| (middle / NORMAL_MEDIAN).max(1.0))
    };
    let [plan, height] = [scatter(0..2), scatter(2..3)];
    differences.iter().map(|[x, y, z]| (x.abs().max(y.abs()) / plan).max(z.abs() / height)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Random;

    /// A grid of places 10 m apart with errors of one standard error, on a surface that bends by some of them, of which each so many-th is off by 16.
    fn places(side: usize, bend: f64, wrong: Option<usize>, seed: u32) -> Vec<PlaceResidual> {
        let mut random = Random::new(seed);
        let mut error = || (0..12).map(|_| random.below(1 << 20) as f64 / f64::from(1 << 20) - 0.5).sum::<f64>();
        let place = |k: usize| {
            let [x, y] = [k % side, k / side].map(|v| v as f64);
            let [u, v] = [x, y].map(|v| 2.0 * v / (side - 1) as f64 - 1.0);
            let gross = if wrong.is_some_and(|each| k % each == each / 2) { 16.0 } else { 0.0 };
            let residual = [error(), error(), error() + bend * (u * u + v * v) + gross];
            PlaceResidual { at: [10.0 * x, 10.0 * y], residual, redundancy: [1.0; 3] }
        };
        (0..side * side).map(place).collect()
    }

    fn beyond(places: &[PlaceResidual]) -> Vec<usize> {
        beside_neighbours(places).into_iter().enumerate().filter(|(_, size)| *size > 4.5).map(|(index, _)| index).collect()
    }

    #[test]
    fn one_wrong_place_in_ten_is_found() {
        for seed in 1..20 {
            let found = beyond(&places(14, 0.0, Some(10), seed));
            let wrong: Vec<usize> = (0..196).filter(|k| k % 10 == 5).collect();
            assert!(wrong.iter().all(|k| found.contains(k)) && found.len() <= wrong.len() + 1, "{found:?}");
        }
    }

    #[test]
    fn what_neighbours_share_is_no_gross_error() {
        // A block that bends away by ten standard errors at its corners.
        let found: usize = (1..20).map(|seed| beyond(&places(14, 5.0, None, seed)).len()).sum();
        assert!(found <= 4, "{found}");
    }

    #[test]
    fn few_places_and_no_numbers_find_nothing() {
        assert!(beside_neighbours(&[]).is_empty());
        assert_eq!(beside_neighbours(&places(2, 0.0, None, 1)[..1]), [0.0]);
        let mut unknown = places(4, 0.0, None, 1);
        unknown[5].residual[2] = f64::NAN;
        let sizes = beside_neighbours(&unknown);
        assert!(sizes[5] == 0.0 && sizes.iter().all(|size| size.is_finite()));
    }
}
