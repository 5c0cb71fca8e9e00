//! The standard error of a ray by the median of its tests, which gross errors hardly raise.

use super::reliability::Judged;
use super::result::ObservationVerdict;
use crate::math::{self, normal_median_within, weighted_median};

/// Where three of ten rays are grossly wrong, half of all lie within this many standard errors: the normal distribution holds 5/7 there.
const MEDIAN_OF_GOOD: f64 = 1.0676;

/// σ in px from the median of the accepted rays, so that gross errors do not hide behind the σ that they raise; and no less than the rays of
/// the start allow, lest a block that fits badly as a whole loses ray after ray until what is left fits. `limit` is that of a standardised
/// residual of accepted rays.
///
/// Coordinates count by their redundancy: along the base of two rays the point follows both, and residuals there say nothing of σ.
pub(super) fn sigma_by_median(rays: &[Option<[Judged; 2]>], verdicts: &[ObservationVerdict], rays_at_start: usize, limit: f64) -> f64 {
    let sizes = |judged: &[Judged; 2]| judged.map(|j| (j.standardised.abs(), j.redundancy));
    let accepted = rays.iter().zip(verdicts).filter(|(_, verdict)| **verdict == ObservationVerdict::Accepted);
    let mut of_accepted: Vec<(f64, f64)> = accepted.filter_map(|(judged, _)| judged.as_ref()).flat_map(sizes).collect();
    let mut of_all: Vec<(f64, f64)> = rays.iter().flatten().flat_map(sizes).collect();
    // A ray whose point is lost with it can no longer be judged: it counts as the worst, by as much as another.
    let (judged, worst) = (of_all.len(), of_all.iter().map(|(size, _)| *size).fold(0.0, f64::max));
    let lost = rays_at_start.saturating_sub(judged / 2);
    let share = of_all.iter().map(|(_, redundancy)| redundancy).sum::<f64>() / judged.max(1) as f64;
    of_all.resize(judged + 2 * lost, (worst, share));
    let least = weighted_median(&mut of_all).unwrap_or(0.0) / MEDIAN_OF_GOOD;
    (weighted_median(&mut of_accepted).unwrap_or(0.0) / normal_median_within(limit)).max(least)
}

/// The share of a variance that rejections leave of one that is estimated from residuals.
pub(super) fn variance_left(verdicts: &[ObservationVerdict], redundancy: usize, alpha0: f64) -> f64 {
    let number = |verdict| verdicts.iter().filter(|given| **given == verdict).count();
    // The four coordinates of a point with two rays are one test: no more residuals are apart from each other than there is redundancy. Of a
    // rejected observation one coordinate was beyond the limit: the other was cut by nothing.
    let kept = (2 * number(ObservationVerdict::Accepted)).min(redundancy);
    let rejected = number(ObservationVerdict::GrossError);
    math::variance_left(kept, redundancy, rejected, alpha0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn judged(standardised: f64, redundancy: f64) -> Option<[Judged; 2]> {
        Some([Judged { redundancy: 1e-8, standardised: 1e-4, moves: 0.0 }, Judged { redundancy, standardised, moves: 0.0 }])
    }

    #[test]
    fn coordinates_without_redundancy_say_nothing() {
        let rays: Vec<_> = (1..100).map(|k| judged(f64::from(k) / 50.0, 0.5)).collect();
        let sigma = sigma_by_median(&rays, &[ObservationVerdict::Accepted; 99], 99, 3.29);
        assert!((sigma * normal_median_within(3.29) - 1.0).abs() < 0.03, "{sigma}");
    }

    #[test]
    fn lost_rays_hold_the_scale_up() {
        let rays: Vec<_> = (1..100).map(|k| judged(f64::from(k) / 50.0, 0.5)).collect();
        let of = |at_start| sigma_by_median(&rays, &[ObservationVerdict::Accepted; 99], at_start, 3.29);
        assert!(of(180) > 1.1 * of(99) && (of(1000) - 1.98 / MEDIAN_OF_GOOD).abs() < 1e-9, "{} {}", of(180), of(1000));
        assert_eq!(sigma_by_median(&[], &[], 0, 3.29), 0.0);
    }
}
