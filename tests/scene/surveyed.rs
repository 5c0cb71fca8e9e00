//! Control and check points of a simulated block, surveyed and measured in its images with errors of known size.

use super::normal::Normal;
use tiepoint::{ControlRole, GroundControlPoint, ImageObservation, ObservedPosition, SimulatedBlock};

/// Standard errors of a surveyed point across and up in m, and of an image measurement in px.
pub const SURVEYED_M: [f64; 3] = [0.02, 0.02, 0.03];
pub const MARK_PX: f64 = 0.5;
/// Images that show each of them.
const LEAST_IMAGES: usize = 3;

/// So many control points and check points, spread over the block.
pub fn surveyed(block: &SimulatedBlock, control: usize, checks: usize, normal: &mut Normal) -> Vec<GroundControlPoint> {
    let seen = |place: &[f64; 3]| -> Vec<(usize, [f64; 2])> {
        let at = |exposure: &tiepoint::Exposure| exposure.project(*place, block.width_px, block.height_px);
        block.exposures.iter().enumerate().filter_map(|(image, exposure)| Some((image, at(exposure)?))).collect()
    };
    let shown: Vec<([f64; 3], Vec<_>)> =
        block.ground.iter().map(|place| (*place, seen(place))).filter(|(_, seen)| seen.len() >= LEAST_IMAGES).collect();
    let wanted = control + checks;
    let of_point = |k: usize| {
        let (place, images) = &shown[k * shown.len() / wanted];
        // Every so many-th is a control point.
        let role = if (k * control) % wanted < control { ControlRole::Control } else { ControlRole::Check };
        let mut measured = |(image, at): &(usize, [f64; 2])| {
            let [x_px, y_px] = at.map(|value| value + MARK_PX * normal.next());
            let inside = x_px >= 0.0 && y_px >= 0.0 && x_px <= f64::from(block.width_px) && y_px <= f64::from(block.height_px);
            inside.then_some(ImageObservation { image: *image, x_px, y_px, confidence: 1.0 })
        };
        let measurements = images.iter().filter_map(&mut measured).collect();
        let position = [0, 1, 2].map(|i| place[i] + SURVEYED_M[i] * normal.next());
        GroundControlPoint {
            name: format!("s{k}"),
            position: ObservedPosition::Local { position, sigma: SURVEYED_M },
            role,
            sigma_px: None,
            measurements,
        }
    };
    (0..wanted).map(of_point).collect()
}
