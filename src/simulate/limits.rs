//! How much ground is built.

use crate::catalogue::refuse;
use crate::{Allowed, Error};

/// The longest side of ground that is built, in m.
const LONGEST_GROUND_M: f64 = 5000.0;

/// Refuses ground that is too long to be built, by the flying height that shows so much: of a block, or of a pair.
pub(super) fn check_length(field: &'static str, block: bool, flying_height_m: f64, longest_m: f64) -> Result<(), Error> {
    if longest_m > LONGEST_GROUND_M {
        let most_m = flying_height_m * LONGEST_GROUND_M / longest_m;
        return Err(refuse(field, flying_height_m, Allowed::HeightOverGround { most_m, longest_m: LONGEST_GROUND_M, block }));
    }
    Ok(())
}
