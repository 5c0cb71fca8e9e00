//! What the user chooses of the reconstruction of a block.

use crate::Error;
use crate::adjustment::{AdjustmentOptions, Datum};
use crate::parameters::check;
use crate::tracks::SelectOptions;
use serde::{Deserialize, Serialize};

/// Options of [`reconstruct_block`](crate::reconstruct_block).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ReconstructionOptions {
    /// What says where the block lies, in place of that of `adjustment`; absent: the observed positions that suffice for it, else none.
    pub datum: Option<Datum>,
    /// Rays an image has while the block grows, and in its adjustment where points are chosen: more are more precise, fewer are faster.
    pub growing_rays: usize,
    /// Least number of rays that agree on the orientation of an image.
    pub least_rays: usize,
    /// Least angle in degrees between two rays of a point.
    pub least_angle_deg: f64,
    /// Largest residual of a ray in px while the block grows; it follows the residuals down from there.
    pub largest_residual_px: f64,
    /// Standard error of a coordinate of a mark, where an image shows a surveyed point, in px.
    pub mark_sigma_px: f64,
    /// The points that are given of the adjusted block; absent: all are adjusted and given.
    pub selection: Option<SelectOptions>,
    /// Models that are given at most where the block falls apart, the largest first.
    pub most_models: usize,
    /// Start of the random numbers.
    pub seed: u32,
    /// By default as [`AdjustmentOptions`] is, but that camera parameters are fixed beyond 20 px.
    pub adjustment: AdjustmentOptions,
}

/// A focal length that is fixed at a value from growth would hide its error: it is estimated where the block says anything of it.
const CALIBRATION_LIMIT_PX: f64 = 20.0;

impl Default for ReconstructionOptions {
    fn default() -> Self {
        Self {
            datum: None,
            growing_rays: 200,
            least_rays: 12,
            least_angle_deg: 1.5,
            largest_residual_px: 8.0,
            mark_sigma_px: 1.0,
            selection: None,
            most_models: 10,
            seed: 1,
            adjustment: AdjustmentOptions { calibration_limit_px: CALIBRATION_LIMIT_PX, ..AdjustmentOptions::default() },
        }
    }
}

impl ReconstructionOptions {
    /// Refuses values outside their ranges.
    pub(super) fn check(&self) -> Result<(), Error> {
        check("reconstruction.growing_rays", self.growing_rays as f64)?;
        check("reconstruction.least_rays", self.least_rays as f64)?;
        check("reconstruction.least_angle_deg", self.least_angle_deg)?;
        check("reconstruction.largest_residual_px", self.largest_residual_px)?;
        check("reconstruction.mark_sigma_px", self.mark_sigma_px)?;
        check("reconstruction.most_models", self.most_models as f64)?;
        self.selection.as_ref().map_or(Ok(()), SelectOptions::check)?;
        self.adjustment.check()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::RECONSTRUCTION_PARAMETERS;

    #[test]
    fn every_option_is_described_once() {
        let values = serde_json::to_value(ReconstructionOptions::default()).unwrap();
        let own = values.as_object().unwrap().keys().filter(|field| !["selection", "adjustment"].contains(&field.as_str()));
        let mut fields: Vec<String> = own.map(|field| format!("reconstruction.{field}")).collect();
        fields.sort_unstable();
        let mut described: Vec<String> = RECONSTRUCTION_PARAMETERS.iter().map(|p| p.key.to_string()).collect();
        described.sort_unstable();
        assert_eq!(described, fields);
        ReconstructionOptions::default().check().unwrap();
    }
}
