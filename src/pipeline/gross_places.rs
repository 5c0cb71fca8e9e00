//! Which places of an orthophoto are gross errors beside the places around them.
//!
//! Standard errors that stand for what neighbours share hide what is wrong with a single place, and a block that hardly follows its places bends away
//! from all of one region. Both are alike for neighbours: what a residual differs from theirs by is its own.

use super::place_factors::PlaceResidual;
use crate::math::{median, scatter};

/// A test beyond this is that of a gross error.
pub(super) const GROSS: f64 = 3.29;
/// A wrong place pulls at its neighbours: only those with this share of the largest test are rejected at a time.
const NEAR_WORST: f64 = 0.7;
/// Places beside which one is judged: more than half of them are right, whatever is wrong with one in ten.
const NEIGHBOURS: usize = 8;

/// Of tests, each with what it is of, those of gross errors.
pub(super) fn beyond(tests: Vec<(usize, f64)>) -> Vec<usize> {
    let worst = tests.iter().map(|(_, size)| *size).fold(0.0, f64::max);
    let limit = GROSS.max(NEAR_WORST * worst);
    tests.into_iter().filter(|(_, size)| *size > limit).map(|(of, _)| of).collect()
}

/// The largest of what each place's residuals differ by from those around it, in its own stated standard errors, or in more where these differences
/// scatter more. Places of no finite residual are no neighbours, and differ by nothing.
pub(super) fn beside_neighbours(places: &[PlaceResidual]) -> Vec<f64> {
    let is_known = |place: &PlaceResidual| place.residual.iter().chain(&place.sigma).chain(&place.at).all(|value| value.is_finite());
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
            // In m: what neighbours share is the same for all, however precise each is.
            let metres = |of: &PlaceResidual| of.residual[axis] * of.sigma[axis];
            let mut around: Vec<f64> = others.iter().map(|(_, other)| metres(&places[*other])).collect();
            median(&mut around).map_or(0.0, |middle| (metres(place) - middle) / place.sigma[axis])
        });
    }
    let scatter_along = |axes: std::ops::Range<usize>| {
        let mut sizes: Vec<f64> = known.iter().flat_map(|index| differences[*index][axes.clone()].iter().map(|d| d.abs())).collect();
        scatter(&mut sizes).map_or(1.0, |found| found.max(1.0))
    };
    let [plan, height] = [scatter_along(0..2), scatter_along(2..3)];
    differences.iter().map(|[x, y, z]| (x.abs().max(y.abs()) / plan).max(z.abs() / height)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Random;

    /// A grid of places 10 m apart with errors of one standard error, every third of which is half as precise, on a surface that bends by `bend_m` at the
    /// middle of its borders; every n-th is off by 16 standard errors.
    fn places(side: usize, bend_m: f64, wrong: Option<usize>, seed: u32) -> Vec<PlaceResidual> {
        let mut random = Random::new(seed);
        let mut error = || (0..12).map(|_| random.below(1 << 20) as f64 / f64::from(1 << 20) - 0.5).sum::<f64>();
        let place = |k: usize| {
            let [x, y] = [k % side, k / side].map(|v| v as f64);
            let [u, v] = [x, y].map(|v| 2.0 * v / (side - 1) as f64 - 1.0);
            let gross = if wrong.is_some_and(|n| k % n == n / 2) { 16.0 } else { 0.0 };
            let sigma = if k.is_multiple_of(3) { 0.4 } else { 0.2 };
            let residual = [error(), error(), error() + bend_m * (u * u + v * v) / sigma + gross];
            PlaceResidual { at: [10.0 * x, 10.0 * y], residual, sigma: [sigma; 3], redundancy: [1.0; 3] }
        };
        (0..side * side).map(place).collect()
    }

    fn found(places: &[PlaceResidual]) -> Vec<usize> {
        beyond(beside_neighbours(places).into_iter().enumerate().collect())
    }

    #[test]
    fn one_wrong_place_in_ten_is_found() {
        for seed in 1..20 {
            let wrong: Vec<usize> = (0..196).filter(|k| k % 10 == 5).collect();
            // Those far below the largest are left to the next adjustment.
            let found = found(&places(14, 0.0, Some(10), seed));
            assert!(found.iter().all(|k| wrong.contains(k)) && found.len() >= 15, "{seed}: {found:?}");
        }
    }

    #[test]
    fn what_neighbours_share_is_no_gross_error() {
        // A block that bends away by 2 m at its corners, ten standard errors of most places. Of 588 residuals 0.6 are beyond the limit by chance.
        let count: usize = (1..20).map(|seed| found(&places(14, 1.0, None, seed)).len()).sum();
        assert!(count <= 60, "{count}");
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
