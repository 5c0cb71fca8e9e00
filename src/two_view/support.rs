//! Whether the matches need a geometry rather than a simpler one.

use super::scale::{LEAST_REDUNDANCY, Noise};

/// Standard errors within which an observation agrees with a homography: 1 in 3000 good ones lies beyond.
const ON_PLANE: f64 = 4.0;

/// Samples that tell whether nearly all of the points of a pose lie in a plane, or move as if the camera had turned.
pub(super) const NEARLY_ALL_SAMPLES: usize = 25;
/// A map of a plane, or a relative orientation, takes the place of a fundamental matrix where it agrees with two of three of its matches.
pub(super) const NEARLY_ALL: [usize; 2] = [2, 3];

/// What deviates from a simpler geometry before the general one is taken: distortion that is left, a plane that is not quite plane and a
/// focal length that is not quite right make residuals of their own.
#[derive(Debug, Clone, Copy)]
pub(super) struct Tolerance {
    /// Distance as a share of the mean distance of the points from their centre.
    pub distance: f64,
    /// Share of the observations beyond it.
    pub share: f64,
}

/// Of cameras that are known.
pub(super) const CALIBRATED: Tolerance = Tolerance { distance: 0.01, share: 0.1 };
/// Of cameras of which nothing is known: their distortion neither.
pub(super) const UNCALIBRATED: Tolerance = Tolerance { distance: 0.02, share: 0.06 };

impl Tolerance {
    /// Distance beyond which an observation deviates; `extent`: mean distance of the points from their centre.
    pub fn off(&self, noise: &Noise, extent: f64) -> f64 {
        (ON_PLANE * noise.sigma).max(self.distance * extent)
    }

    /// Whether `off` of the observations that agree with a general geometry, which deviate from a simpler one, tell that the simpler one does
    /// not serve: they are more than wrong matches along epipolar lines.
    pub fn is_exceeded(&self, noise: &Noise, off: usize) -> bool {
        let least = (self.share * noise.good).max(LEAST_REDUNDANCY as f64);
        off as f64 - noise.others > 3.0 * noise.others.sqrt() + least
    }
}
