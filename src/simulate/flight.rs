//! What is flown, over what, with which camera: the parameters of a simulated pair.

use crate::Error;
use crate::orientation::FiveParameters;
use crate::parameters::refuse;

/// Parameters of a simulated pair. The default is the paper's geometry over a town.
#[derive(Debug, Clone, PartialEq)]
pub struct Flight {
    /// Focal length in mm, 10..1000.
    pub focal_mm: f64,
    /// `[x, y]` of the principal point in the system of the fiducial marks in mm, -1..1.
    pub principal_point_mm: [f64; 2],
    /// Side of a pixel of the scan in mm, 0.005..1.
    pub pixel_mm: f64,
    /// Height of the left perspective centre above the mean ground in m, 50..5000.
    pub flying_height_m: f64,
    /// Base component b at photo scale in mm, 0..200.
    pub base_mm: f64,
    /// Columns of the patches that are cut from the two scans, 16..4000; the overlap limits it.
    pub width_px: usize,
    /// Rows of the patches, 16..4000; the frame limits it.
    pub height_px: usize,
    /// The right photo's dependent relative orientation: angles within 10 degrees, by and bz within 20 mm.
    pub orientation: FiveParameters,
    /// ω φ κ of the left photo against the ground in degrees, within 10.
    pub left_tilts_deg: [f64; 3],
    /// Range of the terrain's heights in m, 0..0.1 of the flying height.
    pub relief_m: f64,
    /// Number of buildings, 0..50 000; fewer stand where there are fewer lots.
    pub buildings: usize,
    /// Lowest and highest building in m (eaves above ground), 2..0.1 of the flying height.
    pub building_heights_m: [f64; 2],
    /// Number of trees, 0..50 000; a few less stand, since none grows in a house or on a street.
    pub trees: usize,
    /// Standard deviation of the lens's point spread in px, 0..1; the pixel's own square comes on top.
    pub psf_px: f64,
    /// Standard deviation of the noise of both images in grey values, 0..50.
    pub noise_grey: f64,
    /// Grey values of the right image: scene times gain plus offset; gain 0.1..10.
    pub gain: f64,
    /// Offset of the right image in grey values, -200..200.
    pub offset_grey: f64,
    /// Standard deviation of a measured fiducial coordinate in px, 0..10.
    pub fiducial_noise_px: f64,
    /// Everything random follows from it.
    pub seed: u32,
}

impl Default for Flight {
    fn default() -> Self {
        Self {
            focal_mm: 153.38,
            principal_point_mm: [0.004, -0.007],
            pixel_mm: 0.254,
            flying_height_m: 830.0,
            base_mm: 92.0,
            width_px: 450,
            height_px: 700,
            orientation: FiveParameters { omega_deg: 0.3, phi_deg: -0.2, kappa_deg: 0.15, by_mm: 1.2, bz_mm: -0.4 },
            left_tilts_deg: [0.2, -0.15, 0.4],
            relief_m: 8.0,
            buildings: 1300,
            building_heights_m: [3.5, 15.0],
            trees: 1400,
            psf_px: 0.45,
            noise_grey: 1.5,
            gain: 1.03,
            offset_grey: 2.0,
            fiducial_noise_px: 0.12,
            seed: super::SAMPLE_SEED,
        }
    }
}

/// Side of the photo's square frame in mm: the aerial film format.
pub(super) const FRAME_MM: f64 = 230.0;

impl Flight {
    /// Metres on the ground for a millimetre in the photo.
    pub(super) fn scale_m_per_mm(&self) -> f64 {
        self.flying_height_m / self.focal_mm
    }

    /// Refuses values outside their ranges.
    pub(super) fn check(&self) -> Result<(), Error> {
        within("flight.focal_mm", self.focal_mm, 10.0, 1000.0)?;
        each("flight.principal_point_mm", &self.principal_point_mm, -1.0, 1.0)?;
        within("flight.pixel_mm", self.pixel_mm, 0.005, 1.0)?;
        within("flight.flying_height_m", self.flying_height_m, 50.0, 5000.0)?;
        within("flight.base_mm", self.base_mm, 0.0, 200.0)?;
        self.check_orientation()?;
        each("flight.left_tilts_deg", &self.left_tilts_deg, -10.0, 10.0)?;
        self.check_scene()?;
        self.check_images()?;
        self.check_patch()
    }

    pub(super) fn angles_deg(&self) -> [f64; 3] {
        [self.orientation.omega_deg, self.orientation.phi_deg, self.orientation.kappa_deg]
    }

    fn check_orientation(&self) -> Result<(), Error> {
        within("flight.orientation.omega_deg", self.orientation.omega_deg, -10.0, 10.0)?;
        within("flight.orientation.phi_deg", self.orientation.phi_deg, -10.0, 10.0)?;
        within("flight.orientation.kappa_deg", self.orientation.kappa_deg, -10.0, 10.0)?;
        within("flight.orientation.by_mm", self.orientation.by_mm, -20.0, 20.0)?;
        within("flight.orientation.bz_mm", self.orientation.bz_mm, -20.0, 20.0)
    }

    fn check_scene(&self) -> Result<(), Error> {
        within("flight.relief_m", self.relief_m, 0.0, 0.1 * self.flying_height_m)?;
        within("flight.buildings", self.buildings as f64, 0.0, 50_000.0)?;
        within("flight.trees", self.trees as f64, 0.0, 50_000.0)?;
        let [lowest, highest] = self.building_heights_m;
        within("flight.building_heights_m[0]", lowest, 2.0, 0.1 * self.flying_height_m)?;
        within("flight.building_heights_m[1]", highest, lowest, 0.1 * self.flying_height_m)
    }

    fn check_images(&self) -> Result<(), Error> {
        within("flight.psf_px", self.psf_px, 0.0, 1.0)?;
        within("flight.noise_grey", self.noise_grey, 0.0, 50.0)?;
        within("flight.gain", self.gain, 0.1, 10.0)?;
        within("flight.offset_grey", self.offset_grey, -200.0, 200.0)?;
        within("flight.fiducial_noise_px", self.fiducial_noise_px, 0.0, 10.0)
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

/// Refuses a value outside `low..=high`; a NaN is outside.
fn within(field: &'static str, value: f64, low: f64, high: f64) -> Result<(), Error> {
    if value >= low && value <= high { Ok(()) } else { Err(refuse(field, value, format!("{low} to {high}"))) }
}

fn each(field: &'static str, values: &[f64], low: f64, high: f64) -> Result<(), Error> {
    values.iter().try_for_each(|&value| within(field, value, low, high))
}
