//! What the user chooses of the assembly of a block.

use crate::Error;
use crate::adjustment::{BundleOptions, Datum};
use crate::parameters::check;
use crate::tracks::SelectOptions;
use serde::{Deserialize, Serialize};

/// Options of [`assemble_block`](crate::assemble_block).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct AssemblyOptions {
    /// What says where the block lies, in place of that of `bundle`; absent: the observed positions that suffice for it, else none.
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
    /// By default as [`BundleOptions`] is, but that camera parameters are fixed beyond 20 px.
    pub bundle: BundleOptions,
}

/// A focal length that is fixed at a value from growth would hide its error: it is estimated where the block says anything of it.
const CALIBRATION_LIMIT_PX: f64 = 20.0;

impl Default for AssemblyOptions {
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
            bundle: BundleOptions { calibration_limit_px: CALIBRATION_LIMIT_PX, ..BundleOptions::default() },
        }
    }
}

impl AssemblyOptions {
    /// Refuses values outside their ranges.
    pub(super) fn check(&self) -> Result<(), Error> {
        check("assembly.growing_rays", self.growing_rays as f64)?;
        check("assembly.least_rays", self.least_rays as f64)?;
        check("assembly.least_angle_deg", self.least_angle_deg)?;
        check("assembly.largest_residual_px", self.largest_residual_px)?;
        check("assembly.mark_sigma_px", self.mark_sigma_px)?;
        check("assembly.most_models", self.most_models as f64)?;
        self.selection.as_ref().map_or(Ok(()), SelectOptions::check)?;
        self.bundle.check()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ASSEMBLY_PARAMETERS;

    #[test]
    fn every_option_is_described_once() {
        let values = serde_json::to_value(AssemblyOptions::default()).unwrap();
        let own = values.as_object().unwrap().keys().filter(|field| !["selection", "bundle"].contains(&field.as_str()));
        let mut fields: Vec<String> = own.map(|field| format!("assembly.{field}")).collect();
        fields.sort_unstable();
        let mut described: Vec<String> = ASSEMBLY_PARAMETERS.iter().map(|p| p.key.to_string()).collect();
        described.sort_unstable();
        assert_eq!(described, fields);
        AssemblyOptions::default().check().unwrap();
    }
}
