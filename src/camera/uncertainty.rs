//! What is not known of a camera that nobody calibrated.

use crate::Error;
use crate::catalogue::refuse;
use serde::{Deserialize, Serialize};

/// Standard deviations of the constants of a camera before its images are measured. They enter the adjustment of a pair as prior
/// information: what the pair determines is estimated, what it does not determine is counted in the total standard errors.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct CameraUncertainty {
    /// Of the focal length, as a share of it.
    pub focal: f64,
    /// Of each coordinate of the principal point, in focal lengths.
    pub principal_point: f64,
    /// Of the first term of the radial distortion, in units of the focal length: the share by which it moves a point at 45°.
    pub k1: f64,
}

impl CameraUncertainty {
    /// Refuses what is no standard deviation of a camera.
    pub(super) fn check(&self) -> Result<(), Error> {
        for (name, value) in [
            ("camera.uncertainty.focal", self.focal),
            ("camera.uncertainty.principal_point", self.principal_point),
            ("camera.uncertainty.k1", self.k1),
        ] {
            if !(0.0..=1.0).contains(&value) {
                return Err(refuse(name, value, "0 to 1"));
            }
        }
        Ok(())
    }

    /// Of a camera whose focal length stands in EXIF: rounded, of the lens at infinity, on a sensor whose size is rounded too.
    pub const EXIF: Self = Self { focal: 0.05, principal_point: 0.01, k1: 0.05 };
    /// Of a camera of which nothing is known: [`ASSUMED_FOCAL`](Self::ASSUMED_FOCAL) fits lenses from wide angles to short telephotos.
    pub const ASSUMED: Self = Self { focal: 0.4, principal_point: 0.01, k1: 0.05 };
    /// The focal length of a camera of which nothing is known, in units of the longer side of its image: 31 mm on 35 mm film, as
    /// telephones, drones and normal lenses have from 24 to 50.
    pub const ASSUMED_FOCAL: f64 = 0.85;
}
