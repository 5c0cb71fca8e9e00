//! How exact what places a block is, where it does not say so itself.

use crate::Error;
use crate::parameters::check;
use serde::{Deserialize, Serialize};

/// Standard errors in m of recorded positions and surveyed points that state none.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct GeoreferencingOptions {
    /// Of east and of north of a recorded position.
    pub receiver_across_m: f64,
    /// Of its height.
    pub receiver_up_m: f64,
    /// Of x and of y of a surveyed point.
    pub surveyed_across_m: f64,
    /// Of its height.
    pub surveyed_up_m: f64,
}

impl Default for GeoreferencingOptions {
    fn default() -> Self {
        Self { receiver_across_m: 3.0, receiver_up_m: 6.0, surveyed_across_m: 0.02, surveyed_up_m: 0.03 }
    }
}

impl GeoreferencingOptions {
    /// Refuses values outside their ranges.
    pub(super) fn check(&self) -> Result<(), Error> {
        check("placing.receiver_across_m", self.receiver_across_m)?;
        check("placing.receiver_up_m", self.receiver_up_m)?;
        check("placing.surveyed_across_m", self.surveyed_across_m)?;
        check("placing.surveyed_up_m", self.surveyed_up_m)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_option_of_placing_is_described_and_checked() {
        let fields = serde_json::to_value(GeoreferencingOptions::default()).unwrap();
        for field in fields.as_object().unwrap().keys() {
            assert!(crate::BLOCK_PARAMETERS.iter().any(|p| p.key == format!("placing.{field}")), "{field}");
        }
        GeoreferencingOptions::default().check().unwrap();
        for wrong in [0.0, -1.0, f64::NAN] {
            let options = GeoreferencingOptions { receiver_up_m: wrong, ..GeoreferencingOptions::default() };
            assert!(matches!(options.check(), Err(Error::InvalidOption { field: "placing.receiver_up_m", .. })), "{wrong}");
        }
    }
}
