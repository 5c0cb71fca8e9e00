//! Simulated blocks of 30 images with GNSS positions, control points and check points, of which one group or another has larger or smaller errors
//! than stated.

use super::normal::Normal;
use tiepoint::{Block, BlockFlight, BlockPreset, ControlPoint, Datum, Error, ObservationGroup, PositionPrior, simulate_network};

/// Stated standard errors: of an image measurement in px, of GNSS positions and of control points in m.
pub const MARK_PX: f64 = 1.0;
pub const GNSS_M: [f64; 3] = [0.1, 0.1, 0.15];
pub const CONTROL_M: [f64; 3] = [0.02, 0.02, 0.03];

pub const GROUPS: [ObservationGroup; 5] = [
    ObservationGroup::Marks,
    ObservationGroup::GnssPlan,
    ObservationGroup::GnssHeight,
    ObservationGroup::ControlPlan,
    ObservationGroup::ControlHeight,
];

/// Check points of each block.
const CHECKS: usize = 8;

/// What is wrong with the stated standard errors of a block.
#[derive(Debug, Clone, Copy)]
pub struct Case {
    /// Of each of [`GROUPS`], true by stated standard error.
    pub factors: [f64; 5],
    pub control: usize,
    pub datum: Datum,
}

/// A block beside its truth, with its check points.
pub struct Simulated {
    pub block: Block,
    pub truth: Block,
    pub checks: Vec<usize>,
}

impl Simulated {
    pub fn new(case: &Case, seed: u32) -> Result<Self, Error> {
        let flight = BlockFlight { seed, control_points: case.control + CHECKS, ..BlockPreset::Network.flight() };
        let simulated = simulate_network(&flight)?;
        let (mut block, truth) = (simulated.observed, simulated.truth);
        let mut normal = Normal(u64::from(seed) << 32);
        let [marks, across, up, control_across, control_up] = case.factors;
        let surveyed: Vec<usize> = block.control.iter().map(|control| control.point).collect();
        for ray in block.rays.iter_mut().filter(|ray| surveyed.contains(&ray.point)) {
            let image = &truth.images[ray.image];
            let camera = &truth.cameras[image.camera];
            let [u, v, w] = image.pose.to_photo(&truth.points[ray.point]);
            let [cx, cy] = camera.principal_point_px;
            ray.x_px = cx - camera.focal_px * u / w + marks * MARK_PX * normal.next();
            ray.y_px = cy + camera.focal_px * v / w + marks * MARK_PX * normal.next();
            ray.sigma_px = Some(MARK_PX);
        }
        block.control.clear();
        // Every so many-th is a control point.
        let is_control = |k: usize| (k * case.control) % surveyed.len() < case.control;
        for point in surveyed.iter().enumerate().filter(|(k, _)| is_control(*k)).map(|(_, point)| *point) {
            let factor = [control_across, control_across, control_up];
            let position = [0, 1, 2].map(|k| truth.points[point][k] + factor[k] * CONTROL_M[k] * normal.next());
            block.control.push(ControlPoint { point, position, sigma: CONTROL_M });
        }
        let factor = [across, across, up];
        for (image, exact) in block.images.iter_mut().zip(&truth.images) {
            let position = [0, 1, 2].map(|k| exact.pose.position[k] + factor[k] * GNSS_M[k] * normal.next());
            image.gnss = Some(PositionPrior { position, sigma: GNSS_M.map(Some) });
        }
        let checks = surveyed.iter().enumerate().filter(|(k, _)| !is_control(*k)).map(|(_, point)| *point).collect();
        Ok(Self { block, truth, checks })
    }
}
