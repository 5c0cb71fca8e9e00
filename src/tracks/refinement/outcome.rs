//! What became of a ray that was to be refined, and why.

use crate::matching::Refusal;
use serde::{Deserialize, Serialize};

/// What became of a ray.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum RefinementOutcome {
    /// The other rays of its point were matched to it; it keeps its place.
    Reference,
    /// Moved to where its window fits that of the reference.
    Refined,
    /// The matching did not settle: it keeps its place, as with all that follow.
    NotConverged,
    /// Its window, or that of the reference, leaves the image.
    LeftImage,
    /// The best place lies further away than allowed.
    MovedTooFar,
    /// The windows correlate too little, as on different ground.
    LowCorrelation,
    /// The window of the reference has too little texture to determine a place.
    NoTexture,
    /// Matched back, its window does not lead to the reference.
    Inconsistent,
}

impl RefinementOutcome {
    /// All outcomes; the place of one here is its code.
    pub const ALL: [Self; 8] = [
        Self::Reference,
        Self::Refined,
        Self::NotConverged,
        Self::LeftImage,
        Self::MovedTooFar,
        Self::LowCorrelation,
        Self::NoTexture,
        Self::Inconsistent,
    ];
}

impl From<Refusal> for RefinementOutcome {
    fn from(refusal: Refusal) -> Self {
        match refusal {
            Refusal::NotConverged => Self::NotConverged,
            Refusal::LeftImage => Self::LeftImage,
            Refusal::MovedTooFar => Self::MovedTooFar,
            Refusal::LowCorrelation => Self::LowCorrelation,
            Refusal::Degenerate => Self::NoTexture,
        }
    }
}

/// A ray after the refinement.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ObservationRefinement {
    pub outcome: RefinementOutcome,
    /// Where the ray is now, in px: moved only where it was refined.
    pub position: [f64; 2],
    /// Standard error of the place relative to the reference, in px in the worst direction; where it was refined.
    pub standard_error_px: Option<f64>,
    /// Of the matched windows, -1..1; where it was refined.
    pub correlation: Option<f64>,
}

/// The rays of a point after the refinement.
#[derive(Debug, Clone, PartialEq)]
pub struct RefinedPoint {
    /// Index of the ray to which the others were matched.
    pub reference: usize,
    /// In the order in which they were given.
    pub rays: Vec<ObservationRefinement>,
}
