//! How much ground is built.

use crate::Error;
use crate::catalogue::refuse;

/// The longest side of ground that is built, in m.
const LONGEST_GROUND_M: f64 = 5000.0;

/// Refuses ground that is too long to be built, by the flying height that shows so much; `what` shows it.
pub(super) fn check_length(field: &'static str, what: &str, flying_height_m: f64, longest_m: f64) -> Result<(), Error> {
    if longest_m > LONGEST_GROUND_M {
        let most = flying_height_m * LONGEST_GROUND_M / longest_m;
        let allowed = format!("up to {most:.0} m, so that the {what} shows at most {LONGEST_GROUND_M} m of ground");
        return Err(refuse(field, flying_height_m, allowed));
    }
    Ok(())
}
