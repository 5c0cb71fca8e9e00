//! What is given of the scan of a photo on film.

use crate::{CameraMm, PartlyGiven, PhotoInput};
use serde::{Deserialize, Serialize};

/// What is known of the scan of a photo on film.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct FilmInput {
    /// The calibrated camera: its focal length, and where they are known principal point and distortion, in the system of the calibrated marks.
    pub camera: Option<CameraMm>,
    /// The fiducial marks that were measured in the scan.
    pub scan: PhotoInput,
    /// All marks of the film as they are calibrated, x and y in mm, those that no one measured included: they say where the photograph ends. Empty: those
    /// that were measured.
    #[serde(default)]
    pub marks_mm: Vec<[f64; 2]>,
}

impl PartlyGiven for FilmInput {}

impl FilmInput {
    /// The marks of the film.
    pub(crate) fn film_marks(&self) -> Vec<[f64; 2]> {
        let measured = self.scan.fiducials.iter().map(|mark| [mark.x_mm, mark.y_mm]);
        self.marks_mm.iter().copied().chain(measured).collect()
    }
}
