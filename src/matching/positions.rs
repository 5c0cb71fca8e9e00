//! Positions of points as they are given.

use crate::error::refuse;
use crate::{Error, Input, InterestPoint, Refusal};

/// Refuses positions that are no numbers, or far from any image.
pub(super) fn check_positions(input: Input, points: &[InterestPoint]) -> Result<(), Error> {
    // A position beyond this is no pixel, and an index must not allocate for it.
    let far = |v: f64| !(-1e6..=1e6).contains(&v);
    if let Some(point) = points.iter().find(|p| far(p.x) || far(p.y)) {
        return refuse(Refusal::FarPosition { input, x: point.x, y: point.y });
    }
    Ok(())
}
