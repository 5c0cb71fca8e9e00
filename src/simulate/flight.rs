//! What is flown, over what, with which camera: the parameters of a simulated pair.

use crate::Error;
use crate::orientation::FiveParameters;
use crate::parameters::{FLIGHT_PARAMETERS, check_by, refuse};
use serde::{Deserialize, Serialize};

/// Parameters of a simulated pair; [`FLIGHT_PARAMETERS`] tells their units and ranges. The default is the paper's geometry over a town.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Flight {
    pub focal_mm: f64,
    pub principal_x_mm: f64,
    pub principal_y_mm: f64,
    pub distortion: f64,
    pub pixel_mm: f64,
    pub flying_height_m: f64,
    pub base_mm: f64,
    pub width_px: usize,
    pub height_px: usize,
    pub omega_deg: f64,
    pub phi_deg: f64,
    pub kappa_deg: f64,
    pub by_mm: f64,
    pub bz_mm: f64,
    pub left_omega_deg: f64,
    pub left_phi_deg: f64,
    pub left_kappa_deg: f64,
    pub relief_m: f64,
    pub buildings: usize,
    pub lowest_building_m: f64,
    pub highest_building_m: f64,
    pub trees: usize,
    pub river_m: f64,
    pub driven_m: f64,
    pub psf_px: f64,
    pub right_blur_px: f64,
    pub noise_grey: f64,
    pub grain_grey: f64,
    pub grain_px: f64,
    pub gain: f64,
    pub offset_grey: f64,
    pub haze: f64,
    pub fiducial_noise_px: f64,
    pub seed: u32,
}

impl Default for Flight {
    fn default() -> Self {
        Self {
            focal_mm: 153.38,
            principal_x_mm: 0.004,
            principal_y_mm: -0.007,
            distortion: 0.0,
            pixel_mm: 0.254,
            flying_height_m: 830.0,
            base_mm: 92.0,
            width_px: 450,
            height_px: 700,
            omega_deg: 0.3,
            phi_deg: -0.2,
            kappa_deg: 0.15,
            by_mm: 1.2,
            bz_mm: -0.4,
            left_omega_deg: 0.2,
            left_phi_deg: -0.15,
            left_kappa_deg: 0.4,
            relief_m: 8.0,
            buildings: 1300,
            lowest_building_m: 3.5,
            highest_building_m: 15.0,
            trees: 1400,
            river_m: 0.0,
            driven_m: 0.0,
            psf_px: 0.45,
            right_blur_px: 0.0,
            noise_grey: 1.5,
            grain_grey: 0.0,
            grain_px: 1.0,
            gain: 1.03,
            offset_grey: 2.0,
            haze: 0.0,
            fiducial_noise_px: 0.12,
            seed: super::SAMPLE_SEED,
        }
    }
}

/// Flights that are ready made.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Preset {
    /// The built-in sample: the paper's geometry, small angles.
    Sample,
    /// The angles of the paper's Table 3, higher relief and buildings, more noise.
    Paper,
    /// Turned, high relief and buildings, strong noise, blur.
    Hard,
    /// The paper's angles with film grain, haze, a river and moving cars.
    Lively,
}

impl Preset {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Sample, Self::Paper, Self::Hard, Self::Lively];

    /// The flight.
    pub fn flight(self) -> Flight {
        let sample = Flight::default();
        match self {
            Self::Sample => sample,
            Self::Paper => Flight {
                omega_deg: 0.9137,
                phi_deg: 0.0187,
                kappa_deg: 0.3708,
                by_mm: -2.2811,
                bz_mm: 0.0605,
                relief_m: 10.0,
                highest_building_m: 18.0,
                noise_grey: 3.0,
                gain: 0.92,
                seed: 2,
                ..sample
            },
            Self::Hard => Flight {
                omega_deg: -0.6,
                phi_deg: 0.4,
                kappa_deg: 2.2,
                by_mm: -1.5,
                bz_mm: 0.8,
                relief_m: 20.0,
                highest_building_m: 28.0,
                noise_grey: 6.0,
                right_blur_px: 0.4,
                gain: 0.78,
                seed: 3,
                ..sample
            },
            Self::Lively => {
                Flight { river_m: 30.0, driven_m: 12.0, noise_grey: 2.0, grain_grey: 3.0, haze: 0.15, seed: 4, ..Self::Paper.flight() }
            }
        }
    }
}

/// Side of the photo's square frame in mm: the aerial film format.
pub(super) const FRAME_MM: f64 = 230.0;

/// The lens's point spread and a blur may together be this wide, in px: more is not gathered.
const WIDEST_PSF_PX: f64 = 1.0;

impl Flight {
    /// The right photo's dependent relative orientation.
    pub fn orientation(&self) -> FiveParameters {
        let Self { omega_deg, phi_deg, kappa_deg, by_mm, bz_mm, .. } = *self;
        FiveParameters { omega_deg, phi_deg, kappa_deg, by_mm, bz_mm }
    }

    /// Metres on the ground for a millimetre in the photo.
    pub(super) fn scale_m_per_mm(&self) -> f64 {
        self.flying_height_m / self.focal_mm
    }

    /// Standard deviation of the right image's point spread in px.
    pub(super) fn right_psf_px(&self) -> f64 {
        (self.psf_px * self.psf_px + self.right_blur_px * self.right_blur_px).sqrt()
    }

    /// Refuses values outside their ranges, and flights that cannot be flown.
    pub(super) fn check(&self) -> Result<(), Error> {
        let values = serde_json::to_value(self).unwrap_or_default();
        for parameter in FLIGHT_PARAMETERS {
            let field = parameter.key.trim_start_matches("flight.");
            // A number that is none has no JSON form.
            check_by(parameter, values[field].as_f64().unwrap_or(f64::NAN))?;
        }
        let tenth = 0.1 * self.flying_height_m;
        within("flight.relief_m", self.relief_m, 0.0, tenth)?;
        within("flight.lowest_building_m", self.lowest_building_m, 2.0, tenth)?;
        within("flight.highest_building_m", self.highest_building_m, self.lowest_building_m, tenth)?;
        let blur = (WIDEST_PSF_PX * WIDEST_PSF_PX - self.psf_px * self.psf_px).max(0.0).sqrt();
        within("flight.right_blur_px", self.right_blur_px, 0.0, blur)?;
        self.check_patch()
    }

    /// The patches must fit into the overlap, and the ground they show must be of a size that can be built.
    fn check_patch(&self) -> Result<(), Error> {
        let fits = |side_mm: f64| (side_mm / self.pixel_mm).floor().clamp(0.0, 4000.0);
        within("flight.width_px", self.width_px as f64, 16.0, fits(FRAME_MM - self.base_mm))?;
        within("flight.height_px", self.height_px as f64, 16.0, fits(FRAME_MM))?;
        let longest_m = self.width_px.max(self.height_px) as f64 * self.pixel_mm * self.scale_m_per_mm();
        if longest_m > LONGEST_GROUND_M {
            let allowed = format!(
                "up to {:.0} m, so that the patch shows at most {LONGEST_GROUND_M} m of ground",
                self.flying_height_m * LONGEST_GROUND_M / longest_m
            );
            return Err(refuse("flight.flying_height_m", self.flying_height_m, allowed));
        }
        Ok(())
    }
}

/// The longest side of ground that is built, in m.
const LONGEST_GROUND_M: f64 = 5000.0;

/// Refuses a value outside `low..=high`.
fn within(field: &'static str, value: f64, low: f64, high: f64) -> Result<(), Error> {
    if value >= low && value <= high { Ok(()) } else { Err(refuse(field, value, format!("{low} to {high}"))) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_field_is_described_once_and_the_presets_can_be_flown() {
        let values = serde_json::to_value(Flight::default()).unwrap();
        let mut described: Vec<&str> = FLIGHT_PARAMETERS.iter().map(|p| p.key.trim_start_matches("flight.")).collect();
        described.sort_unstable();
        let mut fields: Vec<&str> = values.as_object().unwrap().keys().map(String::as_str).collect();
        fields.sort_unstable();
        assert_eq!(described, fields);
        for preset in Preset::ALL {
            preset.flight().check().unwrap();
        }
    }
}
