//! What the reconstruction of a block gives.

use super::frame::Frame;
use super::mistake::{Axis, Doubted, Mistake};
use super::warning::{BlockWarning, UnorientedReason};
use crate::adjustment::{AdjustmentResult, LeftOut};
use crate::model::{ControlRole, GeographicOrigin};
use serde::{Deserialize, Serialize};

/// The models of a block, the one with most images first, and the images that are in none.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Reconstruction {
    pub models: Vec<ReconstructedModel>,
    pub unoriented: Vec<UnorientedImage>,
    /// Where (0, 0, 0) of the models that lie in the system of geographic positions is.
    pub origin: Option<GeographicOrigin>,
}

/// A model: images that are oriented to each other, adjusted.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ReconstructedModel {
    /// The image of the block that each image of the adjusted one is, ascending.
    pub images: Vec<usize>,
    /// The camera of the block that each camera of the adjusted one is, ascending.
    pub cameras: Vec<usize>,
    /// Cameras of the block whose focal length was not known.
    pub guessed_focal: Vec<usize>,
    /// What each point of the adjusted block is.
    pub points: Vec<PointSource>,
    /// What each ray of the adjusted block is.
    pub rays: Vec<ObservationSource>,
    /// Rays of its images that do not fit, left out before the bundle adjustment; their points are those of the adjusted block.
    pub rejected: Vec<RejectedObservation>,
    pub adjusted: AdjustmentResult,
    /// Tie points by which it was adjusted, too, and which are not given: with those of the adjusted block they repeat the adjustment.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub supporting: Vec<SupportingPoint>,
    /// The surveyed points, where it lies in their system.
    #[serde(default)]
    pub surveyed: Vec<SurveyedPoint>,
    /// Whether it lies in the system of the observed positions; otherwise its place, turn and scale mean nothing.
    pub in_system: bool,
    pub warnings: Vec<BlockWarning>,
}

/// A tie point that took part in the adjustment and is not given.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct SupportingPoint {
    /// Index of the tie point.
    pub point: u32,
    /// Adjusted.
    pub position: [f64; 3],
    pub rays: Vec<SupportingRay>,
}

/// An observation of such a point.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct SupportingRay {
    /// Index of the image in the adjusted block.
    pub image: usize,
    /// Column and row in px, in the precision of features.
    pub x_px: f32,
    pub y_px: f32,
    /// Whether the adjustment rejected it; older projects do not say, and hold few that it did.
    #[serde(default, skip_serializing_if = "is_false")]
    pub rejected: bool,
}

/// A surveyed point beside its adjusted place.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct SurveyedPoint {
    pub name: String,
    pub role: ControlRole,
    /// Image measurements that took part.
    pub rays: usize,
    /// Surveyed, in the system of the model.
    pub position: [f64; 3],
    /// Adjusted minus surveyed in m.
    pub difference_m: [f64; 3],
    /// Standard errors of the difference: of a check point those of both places together, of a control point those of a residual; absent without
    /// statistics, and for coordinates that nothing checks.
    pub standard_errors_m: [Option<f64>; 3],
    /// Of a control point: the same where it takes no part, which tells what it is worth as a check point would; absent where the other
    /// observations do not determine it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub left_out: Option<LeftOut>,
    /// Of a control point: the error of each coordinate in m that its test finds with a probability of 0.80; absent where nothing checks it.
    #[serde(default)]
    pub detectable_m: [Option<f64>; 3],
    /// Of a control point whose coordinates contradict the other observations.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub refused: Option<RefusedControl>,
}

impl SurveyedPoint {
    /// By how much the other observations differ from it: a check point takes no part, a control point that does is left out.
    pub(crate) fn without(&self) -> Option<LeftOut> {
        let [x, y, z] = self.standard_errors_m;
        let own = || Some(LeftOut { difference: self.difference_m, standard_errors: [x?, y?, z?] });
        if self.role == ControlRole::Check { own() } else { self.left_out }
    }

    /// The slip of writing that explains by how much the other observations differ from it, with the standard errors of that and the limit of a test;
    /// none of coordinates on the earth, which were written in a system that is not known here.
    pub(super) fn mistake(&self, frame: &Frame, [difference, errors]: [[f64; 3]; 2], limit: f64) -> Option<Mistake> {
        let likely = [0, 1, 2].map(|k| self.position[k] + difference[k]);
        let doubted = Doubted { given: self.position, likely, height_unit_m: 1.0, within: errors.map(|error| limit * error) };
        if frame.origin.is_none() { doubted.mistake() } else { None }
    }

    /// What became of it, in one word, or two.
    pub(crate) fn state(&self) -> &'static str {
        match (self.role, self.refused) {
            (ControlRole::Check, _) => "check",
            (ControlRole::Control, None) => "used",
            (ControlRole::Control, Some(RefusedControl { is_used: true, .. })) => "doubtful",
            (ControlRole::Control, Some(_)) => "rejected",
        }
    }
}

/// What became of a control point that a test refuses.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct RefusedControl {
    /// The coordinate whose test is largest; absent where nothing tests them, or they are right within chance and the block is not placed with the point.
    pub axis: Option<Axis>,
    /// Whether it takes part all the same, since too little is left without it to tell whether it is wrong.
    pub is_used: bool,
}

/// What a point of an adjusted block is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum PointSource {
    /// Index of a tie point.
    TiePoint(u32),
    /// Index of a ground control point.
    GroundControl(usize),
    /// Measured by hand: how many such points were added before.
    Manual(u32),
}

/// What a ray of an adjusted block is.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ObservationSource {
    /// Index of the feature in its image; absent for a ray to a surveyed point.
    pub feature: Option<u32>,
    /// Probability, 0..1, that it belongs to its point, as the matches have it.
    pub confidence: f32,
    /// Whether it was measured by hand.
    #[serde(default, skip_serializing_if = "is_false")]
    pub by_hand: bool,
}

fn is_false(flag: &bool) -> bool {
    !flag
}

/// A ray that does not fit to its point.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct RejectedObservation {
    /// Index of the image in the adjusted block.
    pub image: usize,
    /// Index of the point in the adjusted block.
    pub point: usize,
    /// Column and row in px.
    pub x_px: f64,
    pub y_px: f64,
    /// Length of its residual before the bundle adjustment in px; absent where the point lies behind the image.
    pub residual_px: Option<f64>,
    /// Whether it was rejected by hand.
    #[serde(default, skip_serializing_if = "is_false")]
    pub by_hand: bool,
    /// Whether it had been measured by hand.
    #[serde(default, skip_serializing_if = "is_false")]
    pub measured: bool,
}

/// An image that is in no model.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct UnorientedImage {
    /// Index of the image.
    pub image: usize,
    pub reason: UnorientedReason,
}
