//! What is not known of a camera.

use super::origin::CameraOrigin;
use crate::catalogue::{check_values, refuse};
use crate::{Allowed, Error, Input, Location};
use serde::{Deserialize, Serialize};
use std::ops::RangeInclusive;

/// Of standard deviations, as shares.
const LIMITS: RangeInclusive<f64> = 0.0..=1.0;

/// Standard deviations of the constants of a camera before its images are measured. They enter the adjustment of a pair or block as prior
/// information: what the images determine is estimated, what they do not determine is counted in the total standard errors. From 0 to 1; in blocks
/// what is below 1e-9 counts as 0.
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

/// A constant of a camera contradicts what was known of it where it is more than so many of its standard deviations off, which chance brings in one of
/// twenty, and so large a share of the focal length: what is known to a tenth of that is not worth a doubt.
const MOST_APART: f64 = 2.0;
const LEAST_APART: f64 = 0.02;

/// How many of the standard deviations `sigma_px` of what was known a constant is apart that came out `off_px` from it; absent where it contradicts nothing.
pub(crate) fn apart_from_known(off_px: f64, sigma_px: f64, focal_px: f64) -> Option<f64> {
    let off_px = off_px.abs();
    (off_px > MOST_APART * sigma_px && off_px > LEAST_APART * focal_px).then(|| off_px / sigma_px)
}

impl CameraUncertainty {
    /// Whether nobody knew the focal length: then it contradicts nothing.
    pub(crate) fn is_guess(&self) -> bool {
        self.focal >= Self::ASSUMED.focal
    }

    /// Refuses what is no standard deviation of the camera of a pair.
    pub(crate) fn check(&self) -> Result<(), Error> {
        for (name, value) in [
            ("camera.uncertainty.focal", self.focal),
            ("camera.uncertainty.principal_point", self.principal_point),
            ("camera.uncertainty.k1", self.k1),
        ] {
            if !LIMITS.contains(&value) {
                return Err(refuse(name, value, Allowed::Real { min: *LIMITS.start(), max: *LIMITS.end() }));
            }
        }
        Ok(())
    }

    /// The same of a camera of a block, which `location` names.
    pub(crate) fn check_of_block(&self, location: impl Fn() -> Location) -> Result<(), Error> {
        check_values(Input::CameraSigma, &[self.focal, self.principal_point, self.k1], LIMITS, location)
    }

    /// Below 1e-9 a constant is known without error: nothing that is measured on images is that small, and its weight would leave the other observations
    /// no digits in the normal equations.
    pub(crate) fn without_traces(self) -> Self {
        const LEAST: f64 = 1e-9;
        let known = |sigma: f64| if sigma < LEAST { 0.0 } else { sigma };
        Self { focal: known(self.focal), principal_point: known(self.principal_point), k1: known(self.k1) }
    }

    /// Standard deviation of each term of the decentring of its lens (p1 and p2 of Brown), in units of the focal length: the share by which it moves
    /// a point at 45°. Lenses of drones that state their terms have up to 0.001; the better k1 is known, the better is this. Of lenses of which
    /// EXIF alone tells something three blocks found (0.0030, 0.0061), (-0.0024, 0.0009) and (-0.0018, 0.0003), 0.003 in the quadratic mean.
    pub fn decentring(&self) -> f64 {
        const STATED: f64 = 0.001;
        const MOST: f64 = 0.003;
        let by_k1 = MOST / Self::EXIF.k1 * self.k1;
        (self.k1 / 3.0).min(STATED).max(by_k1).min(MOST)
    }

    /// The same of a camera that states its terms, if they are not 0: of which a tenth is left unknown.
    pub(crate) fn decentring_beside(&self, stated: [f64; 2]) -> f64 {
        const STATED: f64 = 0.1;
        if stated == [0.0; 2] { self.decentring() } else { STATED * self.decentring() }
    }

    /// Of a camera that a file names, by where it is known from.
    ///
    /// Designed and calibrated focal lengths of single cameras, of which users publish the XMP, differ by 0.3 % (Phantom 4 RTK, 3666.67 and
    /// 3656.48 px; Mavic 3 Enterprise, 3725.15 and 3713.29 px): 2 % leaves room for lenses that focus.
    pub fn of(origin: CameraOrigin) -> Self {
        match origin {
            CameraOrigin::XmpCalibration => Self::XMP_CALIBRATION,
            CameraOrigin::XmpDewarped => Self { focal: Self::XMP_CALIBRATION.focal, k1: Self::XMP_CALIBRATION.k1, ..Self::EXIF },
            CameraOrigin::XmpDesign => Self { focal: 0.02, ..Self::EXIF },
            CameraOrigin::ExifFocalPlane | CameraOrigin::Exif35Mm | CameraOrigin::SensorTable => Self::EXIF,
            // In mm: marks or a given pixel side turn it into angles.
            CameraOrigin::FocalLengthAlone => Self::EXIF,
            CameraOrigin::Panorama => Self::ASSUMED,
        }
    }

    /// The same where the image may be a part of a photo: that adds `focal` to the logarithm of the focal length, a standard deviation, and leaves the
    /// principal point anywhere up to `reach` from the middle, in focal lengths, uniformly distributed.
    pub(crate) fn of_part(self, focal: f64, reach: f64) -> Self {
        let with = |own: f64, other: f64| libm::hypot(own, other).min(*LIMITS.end());
        // What a cut is suspected of where none is seen is not counted beside one that is.
        let uncut = self.principal_point.min(Self::EXIF.principal_point);
        Self { focal: with(self.focal, focal), principal_point: with(uncut, reach / 3.0_f64.sqrt()), ..self }
    }

    /// Of a camera that is known without error.
    pub const NONE: Self = Self { focal: 0.0, principal_point: 0.0, k1: 0.0 };
    /// Of a camera that is given for digital photos without what is not known of it. A calibration holds for its day, distance and temperature,
    /// and has standard errors of its own. Of twelve photographs by a compact camera, with the constants that another program's adjustment gave it,
    /// orientations of three pairs do not close by several times what matches explain, and with these by about as much as they say (part `loops` of
    /// the bench).
    pub const GIVEN: Self = Self { focal: 0.003, principal_point: 0.002, k1: 0.003 };
    /// Of a camera whose calibration stands in XMP. That of a Phantom 4 RTK has 3659.8 px in x and 3653.2 px in y, of square pixels, which shows
    /// 0.2 % of its errors; 1 % allows for another distance, temperature and shock since. Between the calibration of a Parrot Sequoia and its EXIF are
    /// 1.4 % (RGB) and 0.6 % (green).
    pub const XMP_CALIBRATION: Self = Self { focal: 0.01, principal_point: 0.003, k1: 0.01 };
    /// Of a camera whose focal length stands in EXIF: rounded, of the lens at infinity, on a sensor whose size is rounded too.
    pub const EXIF: Self = Self { focal: 0.05, principal_point: 0.01, k1: 0.05 };
    /// Of a camera of which nothing is known: [`ASSUMED_FOCAL`](Self::ASSUMED_FOCAL) fits lenses from wide angles to short telephotos. Whether the image
    /// was cut to its shape is not known either: with a principal point within 1 %, pairs of frames of 3:2 whose upper parts were cut off, down to 16:9, were
    /// called oriented with errors of 1° to 4°, outside their regions of 99.9 %; with 2 % these hold them.
    pub const ASSUMED: Self = Self { focal: 0.4, principal_point: 0.02, k1: 0.05 };
    /// The focal length of a camera of which nothing is known, in units of the longer side of its image: 31 mm on 35 mm film, as
    /// telephones, drones and normal lenses have from 24 to 50.
    pub const ASSUMED_FOCAL: f64 = 0.85;
}
