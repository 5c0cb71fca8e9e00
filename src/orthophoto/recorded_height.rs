//! Whether an image lies as high as its GNSS position says: heights of the ground that are off as a whole take the image with them, as a wrong focal length
//! that is held does, and nothing else shows it.

use super::adjusting::PlaceErrors;
use super::heights::Heights;
use super::options::PlacingOptions;
use super::recorded_position::RecordedPosition;
use super::reference::Orthophoto;
use crate::reconstruction::SHARED;

/// A difference of more than so many of its standard errors is no usual one.
const USUAL: f64 = 3.0;
/// Standard error of a height that states none, in m: receivers of cameras and barometers are right to some tens of metres, and what it counts from may differ from
/// the ellipsoid by a hundred.
const ROUGH_M: f64 = 50.0;

/// The height of a GNSS position.
pub(super) struct RecordedHeight {
    height_m: f64,
    /// Its standard error, and what the heights of the ground may be off by together.
    error_m: f64,
}

/// How far an image lies above its GNSS position, and how far is usual at most.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct HeightApart {
    pub height_m: f64,
    pub usual_m: f64,
}

impl RecordedHeight {
    /// Absent where the position has none; where no heights of the ground are given, so that they count from the ground; and where their file says that
    /// they count from elsewhere than a precise position, and nothing says by how much. Where nobody says anything they are compared.
    pub fn of(position: &RecordedPosition, reference: &Orthophoto, options: &PlacingOptions, unit_m: f64) -> Option<Self> {
        let given_m = position.position.height_m?;
        let heights = &reference.heights;
        if *heights == Heights::Level(0.0) {
            return None;
        }
        let stated = heights.vertical().map(|vertical| vertical.is_ellipsoidal);
        let zero_m = match (position.in_crs, stated) {
            // Both count from the same zero, as far as anything says it.
            (true, None | Some(false)) | (false, Some(true)) => 0.0,
            _ if position.height_error_m.is_none() => options.heights_geoid_m.unwrap_or(0.0),
            (true, Some(true)) => return None,
            (false, Some(false)) => options.heights_geoid_m?,
            (false, None) => options.heights_geoid_m.unwrap_or(0.0),
        };
        Some(Self { height_m: given_m - zero_m, error_m: error_m(position, reference, options, unit_m) })
    }

    /// Of an image at this height with this standard error, in the unit of the orthophoto. Absent where both are within their standard errors.
    pub fn apart(&self, height: f64, own_error: f64, unit_m: f64) -> Option<HeightApart> {
        HeightApart::of(unit_m * height - self.height_m, self.error_m, unit_m * own_error)
    }
}

/// Standard error of the height of a position, and what the heights of the ground may be off by together.
pub(super) fn error_m(position: &RecordedPosition, reference: &Orthophoto, options: &PlacingOptions, unit_m: f64) -> f64 {
    let of_one = PlaceErrors::new(options, reference.georeference.gsd(), matches!(reference.heights, Heights::Model(_))).height;
    libm::hypot(position.height_error_m.unwrap_or(ROUGH_M), SHARED * unit_m * of_one)
}

impl HeightApart {
    /// Absent where the difference is within the standard errors of both.
    pub fn of(height_m: f64, error_m: f64, own_m: f64) -> Option<Self> {
        let usual_m = USUAL * libm::hypot(error_m, own_m);
        (height_m.abs() > usual_m).then_some(Self { height_m, usual_m })
    }
}
