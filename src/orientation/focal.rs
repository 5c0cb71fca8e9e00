//! Whether the residuals ask for another focal length.

use super::adjusted::Adjusted;
use super::coplanarity::{Ray, Unknowns};
use super::in_twos::linearised;
use super::normals::Normals;
use super::precision::derivatives;
use crate::math::student_limit;
use nalgebra::SVector;

/// From this condition on, as of a narrow field of view, what matches share does not imitate a focal length: on no right pair.
pub(super) const NARROW: f64 = 1e4;

/// Below this (in units of the focal length) residuals are rounding.
pub(super) const LEAST_SIGMA: f64 = 1e-11;
/// The root mean square of the y-parallaxes, in standard errors, that the residuals must owe to the focal length. Neighbouring matches and
/// those of one surface share errors, which the test takes for many independent ones: with the true focal length they imitate up to
/// 0.24 of it, on simulated flights of all kinds.
const LEAST_PARALLAX: f64 = 0.25;

/// What a change of the focal length by more explains besides is not counted: residuals that matches share, as those of correlation, ask for a multiple of
/// it where they hardly tell it. On simulated flights such a change owes it up to 0.47, the part within this up to 0.2.
const MOST_CHANGE: f64 = 0.3;

/// A focal length that the observations contradict.
#[derive(Debug, Clone, Copy)]
pub(super) struct FocalMisfit {
    /// What the residuals would add to the focal length, as a share of it.
    pub change: f64,
    /// Its test.
    pub w: f64,
}

/// Tests whether a change of the focal length of both photos lowers the residuals beyond chance, with the significance `alpha0`, and beyond
/// what matches share, and whether it moves an unknown out of its 95 % interval: only then is it given.
///
/// `weights`: those of the accepted observations in the normal equations; `half_widths`: of the intervals of ω φ κ (radians), by bz (mm).
///
/// # Source
/// Baarda 1968 (the test of an alternative hypothesis, of one more unknown), with the estimated σ.
pub(super) fn misfit(
    adjusted: &Adjusted,
    (rays, weights): (&[Ray], &[f64]),
    half_widths: &Unknowns,
    (base_mm, condition): (f64, f64),
    alpha0: f64,
) -> Option<FocalMisfit> {
    let freedom = rays.len().checked_sub(6).filter(|freedom| *freedom > 0)?;
    let pose = &adjusted.pose;
    let mut normals = Normals::<6>::new();
    let places: Vec<Ray> = rays.iter().map(|ray| pose.nearer(ray)).collect();
    linearised(pose, rays, &places, |k, line| {
        let Some(line) = line else { return };
        // A longer focal length brings all coordinates, in units of it, nearer to the axis. The adjusted ones: the observed ones would hold
        // the misclosure itself.
        let by_focal = -(0..4).map(|c| line.by_coordinates[c] * places[k][c]).sum::<f64>();
        let row = SVector::<f64, 6>::from_fn(|unknown, _| if unknown < 5 { line.by_unknowns[unknown] } else { by_focal });
        normals.add(&row, line.misclosure, weights[k]);
    });
    let solution = normals.solve().ok()?;
    let left = normals.square_sum - 6.0 * solution.size * solution.size;
    // Of coordinates without errors, rounding is left.
    if !(left > LEAST_SIGMA * LEAST_SIGMA * freedom as f64) {
        return None;
    }
    let change = solution.step[5];
    let w = change / (left / freedom as f64 * solution.cofactors[(5, 5)]).sqrt();
    let moved = derivatives(pose, base_mm) * Unknowns::from_fn(|k, _| solution.step[k]);
    let leaves = (0..5).any(|k| moved[k].abs() > half_widths[k]);
    let by_shared = if condition > NARROW { 0.0 } else { LEAST_PARALLAX * (freedom as f64).sqrt() };
    let least_w = student_limit(alpha0, freedom).max(by_shared);
    let explained = w.abs() * share_within(change.abs()).sqrt();
    // Coordinates in units of the focal length grow as it falls: one that is a third triples them.
    let change = if change < 0.0 { change / (1.0 - change) } else { change };
    (explained > least_w && leaves).then_some(FocalMisfit { change, w })
}

/// The share of what a change explains that the part of it within [`MOST_CHANGE`] does: squares fall as a parabola.
fn share_within(change: f64) -> f64 {
    let beyond = (1.0 - MOST_CHANGE / change).max(0.0);
    1.0 - beyond * beyond
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_an_impossible_change_explains_is_hardly_counted() {
        assert_eq!(share_within(0.05), 1.0);
        assert_eq!(share_within(MOST_CHANGE), 1.0);
        assert!((share_within(2.0 * MOST_CHANGE) - 0.75).abs() < 1e-12 && share_within(3.0) < 0.2);
    }
}
