//! What georeferences a block: GNSS positions of images, ground control points.

use super::ImageObservation;
use crate::catalogue::check_values;
use crate::{Error, Input, Location};
use serde::{Deserialize, Serialize};

/// A position that was observed. All of a block are of the same kind; or those of its images are of one and those of three ground control
/// points or more of the other, which alone georeference the block: then distances between the images are compared with those of the GNSS
/// positions, and it is reported where the ground control points have another unit.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(tag = "system", rename_all = "snake_case", deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum ObservedPosition {
    /// In a Cartesian system, z up.
    Local {
        /// x, y, z in m.
        position: [f64; 3],
        /// Standard error of each coordinate in m, above 0.
        sigma: [f64; 3],
    },
    /// On WGS 84.
    Geographic {
        longitude_deg: f64,
        latitude_deg: f64,
        /// Above the ellipsoid, or above any level that is the same for all positions of the block; absent: not known. Ground control points
        /// have one.
        #[serde(default)]
        height_m: Option<f64>,
        /// Standard errors to the east, to the north and up in m, above 0.
        sigma_m: [f64; 3],
    },
}

impl ObservedPosition {
    /// Refuses values out of range; `place` says whose position it is.
    pub(super) fn check(&self, place: impl Fn() -> Location) -> Result<(), Error> {
        match self {
            Self::Local { position, sigma } => {
                check_values(Input::Position, position, -1e8..=1e8, &place)?;
                check_values(Input::PositionSigma, sigma, 1e-9..=1e9, &place)
            }
            Self::Geographic { longitude_deg, latitude_deg, height_m, sigma_m } => {
                check_values(Input::Longitude, &[*longitude_deg], -180.0..=180.0, &place)?;
                check_values(Input::Latitude, &[*latitude_deg], -90.0..=90.0, &place)?;
                height_m.map_or(Ok(()), |height| check_values(Input::Height, &[height], -1e5..=1e6, &place))?;
                check_values(Input::PositionSigma, sigma_m, 1e-9..=1e9, &place)
            }
        }
    }
}

/// What the coordinates of a surveyed point are for.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum ControlRole {
    /// They place the block.
    #[default]
    Control,
    /// They take no part: what the block says of them is compared with them. Image measurements of the point do, as those of a tie point.
    Check,
}

/// A point with known object coordinates, with the images in which it was measured.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct GroundControlPoint {
    pub name: String,
    pub position: ObservedPosition,
    #[serde(default)]
    pub role: ControlRole,
    /// Standard error of a coordinate of its image measurements in px, above 0; absent: that of the options.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sigma_px: Option<f64>,
    /// Inside their images, one in each.
    pub measurements: Vec<ImageObservation>,
}

impl GroundControlPoint {
    /// Refuses coordinates and standard errors out of range.
    pub(crate) fn check_values(&self) -> Result<(), Error> {
        let own = || Location::Control { name: self.name.clone() };
        self.position.check(own)?;
        check_values(Input::MarkSigma, self.sigma_px.as_slice(), 0.01..=100.0, own)
    }
}
