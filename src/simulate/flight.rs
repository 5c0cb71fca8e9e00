//! What is flown, over what, with which camera: the parameters of a simulated pair.

use super::limits::check_length;
use super::random::SAMPLE_SEED;
use crate::catalogue::{options, refuse};
use crate::orientation::FiveParameters;
use crate::{Allowed, Error};
use serde::{Deserialize, Serialize};

options! {
    /// Parameters of a simulated pair. The default is the paper's geometry over a synthetic town.
    pub struct Flight in "flight" {
        section "Flight";

        /// Everything random follows from it: the same seed gives the same pair.
        seed: u32 = SAMPLE_SEED, "Seed", 0..=4294967295.0;

        /// The height of the left photo above the mean ground: a larger one makes the scale smaller.
        flying_height_m: f64 = 830.0, "Flying height", in "m", 50..=5000;

        /// The base component b at photo scale, of a frame of 230 mm: a longer base leaves less overlap.
        base_mm: f64 = 92.0, "Photo base", in "mm", 0..=200;

        /// The rotation of the right photo about x against the left one.
        omega_deg: f64 = 0.3, "ω", in "°", -10..=10;

        /// The rotation of the right photo about y against the left one.
        phi_deg: f64 = -0.2, "φ", in "°", -10..=10;

        /// The rotation of the right photo about z against the left one.
        kappa_deg: f64 = 0.15, "κ", in "°", -10..=10;

        /// The base component across the flight, at photo scale.
        by_mm: f64 = 1.2, "by", in "mm", -20..=20;

        /// The base component upwards, at photo scale.
        bz_mm: f64 = -0.4, "bz", in "mm", -20..=20;

        /// The tilt of the left photo about x against the ground.
        left_omega_deg: f64 = 0.2, "Left ω", in "°", -10..=10;

        /// The tilt of the left photo about y against the ground.
        left_phi_deg: f64 = -0.15, "Left φ", in "°", -10..=10;

        /// The rotation of the left photo against the flight line.
        left_kappa_deg: f64 = 0.4, "Left κ", in "°", -10..=10;

        section "Camera and scan";

        /// The principal distance of the camera: a longer one makes the scale larger.
        focal_mm: f64 = 153.38, "Principal distance", in "mm", 10..=1000;

        /// The principal point in the system of the fiducial marks.
        principal_x_mm: f64 = 0.004, "Principal point x", in "mm", -1..=1;

        /// The principal point in the system of the fiducial marks.
        principal_y_mm: f64 = -0.007, "Principal point y", in "mm", -1..=1;

        /// Corrected coordinates are measured ones times 1 + k₁ r²: 0.0000001 moves a corner of the frame by some 0.3 mm.
        distortion: f64 = 0.0, "Radial distortion k₁", in "mm⁻²", -0.000001..=0.000001;

        /// The side of a pixel of the scan: larger pixels show less detail.
        pixel_mm: f64 = 0.254, "Pixel", in "mm", 0.005..=1;

        /// The columns of the patches that are cut from the scans; the overlap limits them.
        width_px: usize = 450, "Columns", in "px", 16..=4000;

        /// The rows of the patches that are cut from the scans; the frame limits them.
        height_px: usize = 700, "Rows", in "px", 16..=4000;

        /// The standard deviation of a measured fiducial coordinate.
        fiducial_noise_px: f64 = 0.12, "Fiducial noise", in "px", 0..=10;

        section "Ground";

        /// The range of the terrain's heights, up to a tenth of the flying height.
        relief_m: f64 = 8.0, "Relief", in "m", 0..=500;

        /// The number of buildings; fewer stand where there are fewer lots.
        buildings: usize = 1300, "Buildings", 0..=50000;

        /// The height of the lowest eaves above ground.
        lowest_building_m: f64 = 3.5, "Lowest building", in "m", 2..=500;

        /// The height of the highest eaves above ground, up to a tenth of the flying height.
        highest_building_m: f64 = 15.0, "Highest building", in "m", 2..=500;

        /// The number of trees; a few less stand, since none grows in a house, a street or the river.
        trees: usize = 1400, "Trees", 0..=50000;

        /// The width of a river through the town, whose surface looks different in each exposure; 0: none.
        river_m: f64 = 0.0, "River", in "m", 0..=200;

        /// The distance that cars in the lanes drive between the exposures; 0: they stand.
        driven_m: f64 = 0.0, "Drive of cars", in "m", 0..=100;

        section "Picture";

        /// The standard deviation of the lens's point spread, to which the pixel's own square adds: a larger one blurs more.
        psf_px: f64 = 0.45, "Point spread", in "px", 0..=1;

        /// The standard deviation of a blur of the right image in addition to the point spread.
        right_blur_px: f64 = 0.0, "Blur of the right image", in "px", 0..=1;

        /// The standard deviation of independent noise in both images.
        noise_grey: f64 = 1.5, "Noise", in "grey values", 0..=50;

        /// The standard deviation of noise that neighbouring pixels share.
        grain_grey: f64 = 0.0, "Film grain", in "grey values", 0..=50;

        /// The standard deviation of the grain's spread: larger grains share their noise over more pixels.
        grain_px: f64 = 1.0, "Grain size", in "px", 0.3..=5;

        /// The grey values of the right image are those of the scene times the gain, plus the offset.
        gain: f64 = 1.03, "Gain", 0.1..=10;

        /// The grey values of the right image are those of the scene times the gain, plus the offset.
        offset_grey: f64 = 2.0, "Offset", in "grey values", -200..=200;

        /// The share of the light that is haze of a uniform grey of 190 in both images: more leaves less contrast.
        haze: f64 = 0.0, "Haze", 0..=0.9;
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

    /// Rejects values outside their ranges, and flights that cannot be flown.
    pub(super) fn check(&self) -> Result<(), Error> {
        self.check_ranges()?;
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
        check_length("flight.flying_height_m", false, self.flying_height_m, longest_m)
    }
}

/// Refuses a value outside `low..=high`.
fn within(field: &'static str, value: f64, low: f64, high: f64) -> Result<(), Error> {
    if value >= low && value <= high { Ok(()) } else { Err(refuse(field, value, Allowed::Real { min: low, max: high })) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_presets_can_be_flown() {
        for preset in Preset::ALL {
            preset.flight().check().unwrap();
        }
    }
}
