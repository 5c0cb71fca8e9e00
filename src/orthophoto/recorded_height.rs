//! Whether an image lies as high as its GNSS position says: heights of the ground that are off as a whole take the image with them, and nothing else shows it.

use super::adjusting::PlaceErrors;
use super::heights::Heights;
use super::options::PlacingOptions;
use super::outcome::Placement;
use super::recorded_position::RecordedPosition;
use super::reference::Orthophoto;
use crate::reconstruction::SHARED;

/// A difference of more than so many of its standard errors is no usual one.
const USUAL: f64 = 3.0;

/// The height of a precise GNSS position.
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
    /// Absent where the position states no standard error; where no heights of the ground are given, so that they count from the ground; and where
    /// their file says that they count from elsewhere than the position, and nothing says by how much. Where nobody says anything they are compared.
    pub fn of(position: &RecordedPosition, reference: &Orthophoto, options: &PlacingOptions, unit_m: f64) -> Option<Self> {
        let (given_m, own_m) = (position.position.height_m?, position.height_error_m?);
        let heights = &reference.heights;
        if *heights == Heights::Level(0.0) {
            return None;
        }
        let stated = heights.vertical().map(|vertical| vertical.is_ellipsoidal);
        let zero_m = match (position.in_crs, stated) {
            // Both count from the same zero, as far as anything says it.
            (true, None | Some(false)) | (false, Some(true)) => 0.0,
            (true, Some(true)) => return None,
            (false, Some(false)) => options.heights_geoid_m?,
            (false, None) => options.heights_geoid_m.unwrap_or(0.0),
        };
        let height_m = given_m - zero_m;
        let of_one = PlaceErrors::new(options, reference.georeference.gsd(), matches!(heights, Heights::Model(_))).height;
        Some(Self { height_m, error_m: libm::hypot(own_m, SHARED * unit_m * of_one) })
    }

    /// Absent where both are within their standard errors.
    pub fn apart(&self, placement: &Placement, unit_m: f64) -> Option<HeightApart> {
        let own_m = unit_m * placement.position_errors_m?[2];
        let height_m = unit_m * placement.pose.position[2] - self.height_m;
        let usual_m = USUAL * libm::hypot(self.error_m, own_m);
        (height_m.abs() > usual_m).then_some(HeightApart { height_m, usual_m })
    }
}
