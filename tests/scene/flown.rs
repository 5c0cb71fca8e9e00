//! Blocks with control and check points, with GNSS positions or without, and what is said of their control points.

use super::normal::Normal;
use super::scene::{Scene, scene, selected};
use super::surveyed::{MARK_PX, surveyed};
use tiepoint::{
    Axis, BlockFlight, BlockWarning, ControlRole, GroundControlPoint, Mistake, ObservedPosition, ReconstructedModel, ReconstructionOptions,
};

/// Of GNSS positions in m: of a phase-smoothed receiver, and of one that has corrections (RTK).
pub const GNSS_SIGMA_M: f64 = 0.3;
pub const RTK_SIGMA_M: f64 = 0.02;

/// A block with so many control points, and with GNSS positions or without.
pub fn flown(control: usize, has_gnss: bool, seed: u32) -> Scene {
    flown_by(control, has_gnss.then_some(GNSS_SIGMA_M), seed)
}

/// A block with so many control points, and with GNSS positions of this standard error.
pub fn flown_by(control: usize, sigma_m: Option<f64>, seed: u32) -> Scene {
    let mut scene = scene(&BlockFlight { strips: 3, exposures: 5, features: 800, seed, ..BlockFlight::default() }, 1.0);
    let mut normal = Normal(u64::from(seed) << 32);
    for (image, exposure) in scene.description.images.iter_mut().zip(&scene.block.exposures) {
        let observed = |sigma_m: f64| ObservedPosition::Local {
            position: exposure.centre.map(|value| value + sigma_m * normal.next()),
            sigma: [sigma_m; 3],
        };
        image.position = sigma_m.map(observed);
    }
    scene.description.control = surveyed(&scene.block, control, 4, &mut normal);
    for point in &mut scene.description.control {
        // As a table has them: to a millimetre.
        place(point).iter_mut().for_each(|value| *value = (*value * 1000.0).round() / 1000.0);
    }
    scene
}

pub fn place(point: &mut GroundControlPoint) -> &mut [f64; 3] {
    let ObservedPosition::Local { position, .. } = &mut point.position else { unreachable!("{}", point.name) };
    position
}

/// The control points by their indices in the description.
pub fn control(scene: &Scene) -> Vec<usize> {
    (0..scene.description.control.len()).filter(|k| scene.description.control[*k].role == ControlRole::Control).collect()
}

pub fn adjusted(scene: &Scene) -> ReconstructedModel {
    let options = ReconstructionOptions { mark_sigma_px: MARK_PX, ..selected() };
    let model = scene.reconstruct(&options).models.swap_remove(0);
    println!("{:?}", model.warnings);
    model
}

/// What is said of wrong coordinates: the point, the coordinate, whether it stays used, and what explains it.
pub fn refused(model: &ReconstructedModel) -> Vec<(&str, Axis, bool, Option<&Mistake>)> {
    let of = |warning| match warning {
        &BlockWarning::ControlRefused { ref point, axis, used, ref mistake, .. } => Some((point.as_str(), axis, used, mistake.as_ref())),
        _ => None,
    };
    model.warnings.iter().filter_map(of).collect()
}
