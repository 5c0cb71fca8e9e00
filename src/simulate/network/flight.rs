//! What the user chooses of a simulated block.

use crate::Error;
use crate::parameters::{NETWORK_PARAMETERS, ParameterKind, check_by, refuse};
use serde::{Deserialize, Serialize};

/// How the images of a simulated block look down.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum NetworkKind {
    /// One camera that looks straight down, neighbouring strips flown in opposite directions.
    Nadir,
    /// Five cameras at each station: one of the given focal length down, four of 65/85 of it at 45° to the four sides.
    Oblique,
    /// The strips once, and once more across them at 1.3 times the height.
    TwoHeights,
}

/// A block to be simulated; [`NETWORK_PARAMETERS`] tells units and ranges. Lengths are in m, the ground's mean height is 0.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct NetworkFlight {
    pub kind: NetworkKind,
    pub strips: usize,
    /// Of a strip.
    pub stations: usize,
    /// Above the mean ground.
    pub flying_height_m: f64,
    /// Range of the heights of the relief, up to half the flying height.
    pub relief_m: f64,
    pub width_px: usize,
    pub height_px: usize,
    pub focal_px: f64,
    /// Overlap along the strip, as a share.
    pub end_lap: f64,
    /// Overlap between strips, as a share.
    pub side_lap: f64,
    /// Distortion of all cameras.
    pub radial: [f64; 3],
    pub tangential: [f64; 2],
    /// Ground points for the area of one image.
    pub points_per_image: f64,
    /// Standard deviation of an image coordinate.
    pub noise_px: f64,
    /// Share of the rays that are gross errors, up to `gross_px` in each coordinate.
    pub gross_share: f64,
    pub gross_px: f64,
    /// Standard deviation of a GNSS coordinate; 0: no GNSS.
    pub gnss_sigma_m: f64,
    /// Control points, spread over the block, with `control_sigma_m`.
    pub control_points: usize,
    pub control_sigma_m: f64,
    /// Standard deviation of the errors of the approximate positions of images and points; angles err by as much at the
    /// distance of the ground. Up to a fifth of the flying height.
    pub approximate_m: f64,
    pub seed: u32,
}

impl Default for NetworkFlight {
    fn default() -> Self {
        Self {
            kind: NetworkKind::Nadir,
            strips: 5,
            stations: 6,
            flying_height_m: 100.0,
            relief_m: 15.0,
            width_px: 4000,
            height_px: 3000,
            focal_px: 3600.0,
            end_lap: 0.7,
            side_lap: 0.5,
            radial: [0.0; 3],
            tangential: [0.0; 2],
            points_per_image: 60.0,
            noise_px: 0.4,
            gross_share: 0.0,
            gross_px: 60.0,
            gnss_sigma_m: 0.0,
            control_points: 0,
            control_sigma_m: 0.02,
            approximate_m: 0.5,
            seed: 1,
        }
    }
}

impl NetworkFlight {
    /// Refuses values outside their ranges.
    pub(super) fn check(&self) -> Result<(), Error> {
        let values = serde_json::to_value(self).unwrap_or_default();
        for parameter in NETWORK_PARAMETERS.iter().filter(|p| !matches!(p.kind, ParameterKind::Choice { .. })) {
            let field = parameter.key.trim_start_matches("network.");
            // A number that is none has no JSON form.
            check_by(parameter, values[field].as_f64().unwrap_or(f64::NAN))?;
        }
        for (field, value, most) in [("network.relief_m", self.relief_m, 0.5), ("network.approximate_m", self.approximate_m, 0.2)] {
            let most = most * self.flying_height_m;
            if !(value <= most) {
                return Err(refuse(field, value, format!("0 to {most}")));
            }
        }
        let lens = self.radial.iter().chain(&self.tangential);
        match lens.clone().find(|k| !(k.abs() <= 1.0)) {
            Some(wrong) => Err(refuse("network.radial, network.tangential", wrong, "numbers from -1 to 1")),
            None => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_number_is_described_once() {
        let values = serde_json::to_value(NetworkFlight::default()).unwrap();
        let mut described: Vec<&str> = NETWORK_PARAMETERS.iter().map(|p| p.key.trim_start_matches("network.")).collect();
        described.extend(["radial", "tangential"]);
        described.sort_unstable();
        let mut fields: Vec<&str> = values.as_object().unwrap().keys().map(String::as_str).collect();
        fields.sort_unstable();
        assert_eq!(described, fields);
    }
}
