//! A row of the table of control points as a point of the block.

use crate::crs::CoordinateSystem;
use crate::{ControlRole, Error, GeoreferencingOptions, GroundControlPoint, GroundControlRow, ObservedPosition, Refusal};

/// In its coordinate system, where there is one, a point is one of the earth; its standard errors hold along the axes of either.
pub(super) fn control_point(
    point: &GroundControlRow,
    role: ControlRole,
    placing: &GeoreferencingOptions,
    system: Option<&CoordinateSystem>,
) -> Result<GroundControlPoint, Error> {
    let [across, up] = point.standard_errors.unwrap_or([placing.surveyed_across_m, placing.surveyed_up_m]);
    let sigma = [across, across, up];
    let position = match system {
        None => ObservedPosition::Local { position: point.position, sigma },
        Some(system) => {
            let [longitude_deg, latitude_deg, height_m] = on_earth(point, system)?;
            ObservedPosition::Geographic { longitude_deg, latitude_deg, height_m: Some(height_m), sigma_m: sigma }
        }
    };
    Ok(GroundControlPoint { name: point.name.clone(), position, role, sigma_px: point.sigma_px, measurements: Vec::new() })
}

fn on_earth(point: &GroundControlRow, system: &CoordinateSystem) -> Result<[f64; 3], Error> {
    let ([x, y, _], degrees) = (point.position, system.definition().is_geographic());
    let (name, crs) = (point.name.clone(), system.definition().name());
    system.geographic(point.position).ok_or_else(|| Refusal::ControlPlace { point: name, x, y, crs, degrees }.into_error())
}
