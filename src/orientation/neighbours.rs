//! Errors of neighbouring points depend on each other: what that does to the result.

use super::adjusted::Adjusted;
use super::condition::Condition;
use super::coplanarity::{Ray, Unknowns};
use super::normals::Matrix5;
use super::precision::derivatives;
use std::collections::BTreeMap;

/// Fewer groups than this tell too little of a covariance.
const LEAST_GROUPS: usize = 30;

/// Covariance of ω φ κ (radians), by bz (mm) as the residuals show it, in units of σ = 1 focal length: points in one cell of the left photo,
/// of this side in focal lengths, are taken together, so that errors which they share count as often as they occur. `None` where the
/// points lie in few cells.
///
/// `rays`, `conditions`, `weights` and `factors` are those of the accepted observations.
///
/// # Source
/// Liang & Zeger 1986, Longitudinal data analysis using generalized linear models (the sandwich over groups); Conley 1999, GMM estimation
/// with cross sectional dependence (groups by place).
pub(super) fn covariance_of(
    adjusted: &Adjusted,
    (rays, conditions): (&[Ray], &[Condition]),
    weights: &[f64],
    factors: &[f64],
    side: f64,
    base_mm: f64,
) -> Option<Matrix5> {
    let mut cells: BTreeMap<[i64; 2], Unknowns> = BTreeMap::new();
    for (((ray, condition), weight), factor) in rays.iter().zip(conditions).zip(weights).zip(factors) {
        let Condition { distance, line: Some(line), .. } = condition else { continue };
        let cell = [ray[0], ray[1]].map(|v| libm::floor(v / side) as i64);
        *cells.entry(cell).or_insert_with(Unknowns::zeros) += line.by_unknowns * (weight * factor * distance);
    }
    if cells.len() < LEAST_GROUPS {
        return None;
    }
    let groups = cells.len() as f64;
    let meat = cells.values().fold(Matrix5::zeros(), |sum, s| sum + s * s.transpose()) * (groups / (groups - 5.0));
    let to_parameters = derivatives(&adjusted.pose, base_mm) * adjusted.sensitivity;
    let covariance = to_parameters * meat * to_parameters.transpose();
    Some((covariance + covariance.transpose()) * 0.5)
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
    fn groups_that_show_less_change_nothing() {
        let independent = Matrix5::from_fn(|i, j| if i == j { 2.0 } else { 0.5 });
        assert_eq!(no_less(&independent, &(independent * 0.9)), independent);
        let twice = no_less(&independent, &(independent * 2.0));
        assert!((twice - independent * 2.0).abs().max() < 1e-12, "{twice}");
        assert_eq!(no_less(&Matrix5::zeros(), &independent), independent);
    }
}
