//! Heights of the ground that count from elsewhere than those of a block.

use crate::crs::{Definition, HeightReference, HeightZero, Vertical};

/// What is to be said of heights that count from elsewhere.
pub(super) struct OtherZero {
    /// From what they count, as their file says.
    pub name: String,
    pub from_ellipsoid: bool,
    /// By so much they are too high in m, below 0 too low, where that is known.
    pub above_m: Option<f64>,
}

/// Where the heights of a coordinate reference system count from, of a block whose heights count from `zero` where the system does not say.
pub(super) fn zero_of(crs: &Definition, zero: HeightZero) -> HeightZero {
    if crs.heights() == HeightReference::Ellipsoid { HeightZero::Level(0.0) } else { zero }
}

/// Whether heights of the ground count from elsewhere than those of a block, which are taken as they are. `place`: its longitude and latitude, where that is
/// known. `None` where they count alike, and where nobody knows.
pub(super) fn other_zero(
    Vertical { name, is_ellipsoidal, .. }: Vertical,
    zero: &HeightZero,
    place: impl FnOnce() -> Option<[f64; 2]>,
) -> Option<OtherZero> {
    let above_m = match zero {
        HeightZero::Unknown => return None,
        HeightZero::Level(zero_m) if (*zero_m == 0.0) == is_ellipsoidal => return None,
        HeightZero::Geoid(_) if !is_ellipsoidal => return None,
        // Above the ellipsoid, where those of the block are above a geoid.
        zero if is_ellipsoidal => place().and_then(|place| zero.above_m(place)),
        _ => None,
    };
    Some(OtherZero { name, from_ellipsoid: is_ellipsoidal, above_m })
}
