//! Errors of neighbouring points depend on each other: what that does to the result.

use super::adjusted::Adjusted;
use super::condition::Condition;
use super::coplanarity::{Ray, Unknowns};
use super::normals::Matrix5;
use super::precision::derivatives;
use std::collections::BTreeMap;

/// Fewer groups than this tell too little of a covariance.
const LEAST_GROUPS: usize = 30;
/// Grids, shifted against each other by a half of a cell along one axis, the other, and both.
const SHIFTS: [[f64; 2]; 4] = [[0.0, 0.0], [0.5, 0.0], [0.0, 0.5], [0.5, 0.5]];

/// Covariance of ω φ κ (radians), by bz (mm) as the residuals show it, in units of σ = 1 focal length: points that are near each other in the left
/// photo are taken together, so that errors which they share count as often as they occur. `None` where the points lie in few cells.
///
/// Two points count together by a weight that falls with their distance along both axes to none at `side`, in focal lengths: the kernel of Bartlett. It is
/// how often they fall into one cell of that side, wherever its grid begins; the mean over a few shifted grids takes the place of all pairs of
/// points, and is a covariance whatever the points.
///
/// `rays`, `conditions`, `weights` and `factors` are those of the accepted observations.
///
/// # Source
/// Liang & Zeger 1986, Longitudinal data analysis using generalized linear models (the sandwich over groups); Conley 1999, GMM estimation
/// with cross sectional dependence (Bartlett's kernel by distance).
pub(super) fn covariance_of(
    adjusted: &Adjusted,
    (rays, conditions): (&[Ray], &[Condition]),
    weights: &[f64],
    factors: &[f64],
    side: f64,
    base_mm: f64,
) -> Option<Matrix5> {
    let of_all = rays.iter().zip(conditions).zip(weights).zip(factors);
    let scores: Vec<([f64; 2], Unknowns)> = of_all
        .filter_map(|(((ray, condition), weight), factor)| {
            let Condition { distance, line: Some(line), .. } = condition else { return None };
            Some(([ray[0] / side, ray[1] / side], line.by_unknowns * (weight * factor * distance)))
        })
        .collect();
    let grids: Option<Vec<Matrix5>> = SHIFTS.iter().map(|shift| of_grid(&scores, *shift)).collect();
    let meat = grids?.into_iter().sum::<Matrix5>() / SHIFTS.len() as f64;
    let to_parameters = derivatives(&adjusted.pose, base_mm) * adjusted.sensitivity;
    let covariance = to_parameters * meat * to_parameters.transpose();
    Some((covariance + covariance.transpose()) * 0.5)
}

/// The sum over the cells of a grid of the squares of what its points add up to; places are in cells.
fn of_grid(scores: &[([f64; 2], Unknowns)], shift: [f64; 2]) -> Option<Matrix5> {
    let mut cells: BTreeMap<[i64; 2], Unknowns> = BTreeMap::new();
    for (at, score) in scores {
        let cell = [0, 1].map(|axis| libm::floor(at[axis] + shift[axis]) as i64);
        *cells.entry(cell).or_insert_with(Unknowns::zeros) += score;
    }
    let groups = cells.len() as f64;
    (cells.len() >= LEAST_GROUPS)
        .then(|| cells.values().fold(Matrix5::zeros(), |sum, s| sum + s * s.transpose()) * (groups / (groups - 5.0)))
}

/// The covariance of independent errors, raised to what the groups show along those combinations of the unknowns where they show more.
///
/// It is no less than either of both as a matrix, so that no function of the unknowns, as the ellipse of the base or the place of a point, gets
/// a smaller standard error than by one of them; taken unknown by unknown, that would not hold. Groups are few and their covariance is
/// itself uncertain: where it is the smaller one, it does not tell that errors cancel.
///
/// # Source
/// The generalised eigenvectors of the pair of covariances, which do not depend on the units of the unknowns.
pub(super) fn no_less(independent: &Matrix5, by_groups: &Matrix5) -> Matrix5 {
    let whitening = independent.cholesky().map(|factor| factor.l()).and_then(|l| Some((l, l.try_inverse()?)));
    // Without independent errors in some direction their sum is no less than either.
    let Some((l, inverse)) = whitening else { return independent + by_groups };
    let relative = inverse * by_groups * inverse.transpose();
    let eigen = ((relative + relative.transpose()) * 0.5).symmetric_eigen();
    let excess = Matrix5::from_diagonal(&eigen.eigenvalues.map(|share| (share - 1.0).max(0.0).sqrt()));
    let raised = l * eigen.eigenvectors * excess;
    independent + raised * raised.transpose()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_covariance_that_is_no_less_than_two_exceeds_neither_more_than_it_must() {
        // Angles in radians and lengths in mm: cofactors of very different size.
        let scale = Matrix5::from_diagonal(&Unknowns::from_column_slice(&[1e-4, 2e-4, 1e-4, 0.05, 0.02]));
        let mixed = |seed: f64| Matrix5::from_fn(|i, j| libm::sin(seed + (3 * i + 7 * j) as f64) + if i == j { 2.0 } else { 0.0 });
        for seed in 0..20 {
            let covariance = |seed: f64| scale * mixed(seed) * mixed(seed).transpose() * scale;
            let (independent, groups) = (covariance(f64::from(seed)), covariance(f64::from(seed) + 0.5));
            let upper = no_less(&independent, &groups);
            let inverse = independent.cholesky().unwrap().l().try_inverse().unwrap();
            let least = |less: &Matrix5| {
                let difference = inverse * (upper - less) * inverse.transpose();
                ((difference + difference.transpose()) * 0.5).symmetric_eigenvalues().min()
            };
            assert!(least(&independent) > -1e-9 && least(&groups) > -1e-9, "{seed}: {} {}", least(&independent), least(&groups));
            assert!((0..5).all(|k| upper[(k, k)] >= independent[(k, k)]), "{seed}");
            // It touches both, where these differ either way.
            assert!(least(&independent).abs().max(least(&groups).abs()) < 1e-6, "{seed}: {} {}", least(&independent), least(&groups));
        }
    }

    #[test]
    fn points_count_together_by_how_near_they_are() {
        let one = |k: usize| Unknowns::from_fn(|row, _| if row == k { 1.0 } else { 0.0 });
        // Two of each place, so far apart along an axis; single ones elsewhere make the groups many.
        let together = |far: f64, axis: usize| {
            let mut sum = 0.0;
            for k in 0..200 {
                let mut at = [0.37 * f64::from(k), 0.61 * f64::from(k)];
                let first = (at, one(0));
                at[axis] += far;
                let others = (0..40).map(|n| ([1e3 + 3.0 * f64::from(n), 0.0], one(4)));
                let all: Vec<_> = [first, (at, one(1))].into_iter().chain(others).collect();
                let grids: Matrix5 = SHIFTS.iter().map(|shift| of_grid(&all, *shift).unwrap()).sum();
                sum += grids[(0, 1)] / grids[(0, 0)].max(grids[(1, 1)]);
            }
            sum / 200.0
        };
        for (far, wanted) in [(0.0, 1.0), (0.25, 0.75), (0.5, 0.5), (0.75, 0.25), (1.0, 0.0), (1.4, 0.0)] {
            assert!((together(far, 0) - wanted).abs() < 0.03 && (together(far, 1) - wanted).abs() < 0.03, "{far}: {}", together(far, 0));
        }
        let few: Vec<_> = (0..20).map(|k| ([f64::from(k), 0.0], one(0))).collect();
        assert!(of_grid(&few, [0.0, 0.0]).is_none());
    }

    #[test]
    fn groups_that_show_less_change_nothing() {
        let independent = Matrix5::from_fn(|i, j| if i == j { 2.0 } else { 0.5 });
        assert_eq!(no_less(&independent, &(independent * 0.9)), independent);
        let twice = no_less(&independent, &(independent * 2.0));
        assert!((twice - independent * 2.0).abs().max() < 1e-12, "{twice}");
        assert_eq!(no_less(&Matrix5::zeros(), &independent), independent);
    }
}
