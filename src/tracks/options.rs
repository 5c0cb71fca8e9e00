//! What the user chooses of a block: how points are joined, and how many are kept.

use crate::Error;
use crate::parameters::check;
use serde::{Deserialize, Serialize};

/// What is done with matches that would give a point two rays in one image.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Conflicts {
    /// The least probable matches between the two rays are cut: one point becomes two or more.
    Resolve,
    /// The point is left out whole.
    Drop,
}

/// How matches are joined to multi-ray points.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct BlockOptions {
    pub conflicts: Conflicts,
    /// Expected share of points with a ray that does not belong to them, 0..0.5: matches join until it is reached.
    pub impure: f64,
    /// Points with fewer rays are left out, 2 or more.
    pub min_rays: usize,
    /// Share of right matches that is expected where no third image tells, above 0 and below 1.
    pub expected_right: f64,
}

impl Default for BlockOptions {
    fn default() -> Self {
        Self { conflicts: Conflicts::Resolve, impure: 0.002, min_rays: 2, expected_right: 0.998 }
    }
}

impl BlockOptions {
    /// Refuses values outside their ranges.
    pub(super) fn check(&self) -> Result<(), Error> {
        check("block.impure", self.impure)?;
        check("block.min_rays", self.min_rays as f64)?;
        check("block.expected_right", self.expected_right)
    }
}

/// How many points are kept, and where.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct SelectOptions {
    /// Rays an image should have.
    pub per_image: usize,
    /// Points that a pair of images keeps in common, or as many as it has.
    pub per_connection: usize,
}

impl Default for SelectOptions {
    fn default() -> Self {
        Self { per_image: 40, per_connection: 3 }
    }
}

impl SelectOptions {
    /// Refuses values outside their ranges.
    pub(crate) fn check(&self) -> Result<(), Error> {
        check("selection.per_image", self.per_image as f64)?;
        check("selection.per_connection", self.per_connection as f64)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{BLOCK_PARAMETERS, GeoreferencingOptions, RefinementOptions};

    #[test]
    fn every_option_is_described_once() {
        let keys = |group: &str, options: serde_json::Value| {
            options.as_object().unwrap().keys().map(|field| format!("{group}.{field}")).collect::<Vec<_>>()
        };
        let mut fields = keys("block", serde_json::to_value(BlockOptions::default()).unwrap());
        fields.extend(keys("selection", serde_json::to_value(SelectOptions::default()).unwrap()));
        fields.extend(keys("placing", serde_json::to_value(GeoreferencingOptions::default()).unwrap()));
        fields.extend(keys("refinement", serde_json::to_value(RefinementOptions::default()).unwrap()));
        fields.sort_unstable();
        let mut described: Vec<String> =
            BLOCK_PARAMETERS.iter().filter(|p| !p.key.starts_with("pairs.")).map(|p| p.key.to_string()).collect();
        described.sort_unstable();
        assert_eq!(described, fields);
        BlockOptions::default().check().unwrap();
        SelectOptions::default().check().unwrap();
    }
}
