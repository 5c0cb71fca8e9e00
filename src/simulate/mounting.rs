//! How the cameras of a block are mounted: one that looks down, or with it four that look to the sides.

use crate::rotation_from_angles;
use nalgebra::Matrix3;
use std::f64::consts::FRAC_PI_4;

/// Principal distance in mm of a camera that looks down, and of a tilted one.
pub(super) const NADIR_MM: f64 = 85.0;
const OBLIQUE_MM: f64 = 65.0;

/// A camera in its carrier, whose x goes to the right, y forwards and z up.
#[derive(Debug, Clone, Copy)]
pub(super) struct Mounting {
    /// From the carrier to the photo.
    pub rotation: Matrix3<f64>,
    /// Principal distance.
    pub focal_mm: f64,
}

/// The camera that looks down.
pub(super) fn nadir() -> Mounting {
    Mounting { rotation: Matrix3::identity(), focal_mm: NADIR_MM }
}

/// The camera that looks down and four that are tilted by 45°: two about x, two about y, either way.
pub(super) fn five() -> [Mounting; 5] {
    let tilted = |omega: f64, phi: f64| Mounting { rotation: rotation_from_angles(omega, phi, 0.0), focal_mm: OBLIQUE_MM };
    [nadir(), tilted(FRAC_PI_4, 0.0), tilted(-FRAC_PI_4, 0.0), tilted(0.0, FRAC_PI_4), tilted(0.0, -FRAC_PI_4)]
}
