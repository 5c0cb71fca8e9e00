//! What a narrow view leaves open: whether half the focal length fits as well.

use super::adjusted::Adjusted;
use super::adjustment::{NEARLY_SETTLED, adjust};
use super::coplanarity::Ray;
use super::result::Warning;

/// From this condition on, as of a narrow field of view, what matches share does not imitate a focal length: on no right pair.
pub(super) const NARROW: f64 = 1e4;

/// With half the focal length σ₀ was 0.99 to 1.05 times as large where the given one was 2.5 times too long, and 1.6 times and more where it was right, on
/// photographs of narrow view; errors that matches share do less. Over level ground it is 1 for right ones as well, as for parts of the scans of metric
/// cameras, which the caller spares.
const EXCLUDED: f64 = 1.2;

/// The warning that half the focal length fits nearly as well as the given one: views of a long focal length hardly tell it over level ground, and no
/// interval holds an error of it.
///
/// `weights`: those of the accepted observations in the normal equations.
pub(super) fn warning(adjusted: &Adjusted, (rays, weights): (&[Ray], &[f64]), condition: f64) -> Option<Warning> {
    if !(condition > NARROW) || rays.len() <= 5 {
        return None;
    }
    // Coordinates in units of half the focal length, and so is their σ.
    let doubled: Vec<Ray> = rays.iter().map(|ray| ray.map(|v| 2.0 * v)).collect();
    let half = adjust(&doubled, weights, adjusted.pose, NEARLY_SETTLED, |_| Ok(())).ok()?;
    let ratio = 0.5 * half.sigma / (adjusted.sigma * adjusted.variance_left.sqrt());
    (ratio < EXCLUDED).then_some(Warning::UncheckedFocal { ratio, least: EXCLUDED })
}
