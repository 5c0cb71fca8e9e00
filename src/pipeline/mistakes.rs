//! What explains wrong control points of a block in a coordinate reference system: the numbers that were written are those of the system, not those
//! of the adjustment, which is Cartesian.

use super::input::Checked;
use super::place_names::own_control;
use super::recorded_positions::of_table;
use super::result::RunImage;
use super::system::{in_other_zone, system_of};
use crate::reconstruction::Doubted;
use crate::{BlockDescription, BlockWarning, ControlRole, GeographicOrigin, Mistake, ReconstructedModel, geographic_from_local};

/// Says that what was given is of elsewhere: GNSS positions of a table beside those that the files of the images record, and points that no image of the block
/// shows. `unknown`: the images that the table of measurements names in their place.
pub(super) fn tell_elsewhere(
    model: &mut ReconstructedModel,
    description: &BlockDescription,
    unknown: &[String],
    images: &[RunImage],
    input: &Checked,
) {
    if let Some(warning) = of_table(images, &input.settings.placing).filter(|_| input.use_gnss) {
        // It explains what else is weak.
        model.warnings.insert(0, warning);
    }
    let given = &description.control[..own_control(description)];
    if given.is_empty() || given.iter().any(|point| !point.measurements.is_empty()) {
        return;
    }
    let check = given.iter().all(|point| point.role == ControlRole::Check);
    model.warnings.push(BlockWarning::ControlElsewhere { points: given.len(), images: unknown.to_vec(), check });
}

/// Names the coordinate of the system in warnings of wrong control and check points, and what explains it. `limit`: of a test.
pub(super) fn explain_control(model: &mut ReconstructedModel, origin: Option<GeographicOrigin>, input: &Checked, limit: f64) {
    let placing = &input.settings.placing;
    let (Some(origin), Some(control)) = (origin, &input.control) else { return };
    let Ok(Some(system)) = system_of(placing, &input.zero, &control.plane(), &[]) else { return };
    // Degrees are no lengths.
    let Some(unit_m) = system.definition().unit_m() else { return };
    let units = [unit_m, unit_m, system.definition().height_unit_m()];
    let origin = [origin.longitude_deg, origin.latitude_deg, origin.height_m];
    let ReconstructedModel { warnings, surveyed, .. } = model;
    for warning in warnings {
        let (point, axis, difference_m, error_m, detectable_m, mistake) = match warning {
            BlockWarning::ControlRefused { point, axis, difference_m, error_m, detectable_m, mistake, .. } => {
                (point, axis, difference_m, error_m, detectable_m.as_mut(), mistake)
            }
            BlockWarning::CheckRefused { point, axis, difference_m, error_m, mistake } => {
                (point, axis, difference_m, error_m, None, mistake)
            }
            _ => continue,
        };
        let Some(surveyed) = surveyed.iter_mut().find(|surveyed| surveyed.name == *point) else { continue };
        let (Some(left), Some(given)) = (surveyed.without(), control.coordinates(point)) else { continue };
        let place = [0, 1, 2].map(|k| surveyed.position[k] + left.difference[k]);
        let Some(likely) = system.coordinates(geographic_from_local(place, origin)) else { continue };
        let across = left.standard_errors[0].max(left.standard_errors[1]);
        let errors = [across, across, left.standard_errors[2]];
        let apart = system.difference_m(likely, given);
        let within = [0, 1, 2].map(|k| limit * errors[k] / units[k]);
        let doubted = Doubted { given, likely, height_unit_m: units[2], within };
        let zone = in_other_zone(&system, given, |place| doubted.explains(place));
        if !matches!(mistake, Some(Mistake::Name { .. })) {
            *mistake = zone.map(|zone| Mistake::Zone { zone }).or_else(|| doubted.mistake());
        }
        *axis = doubted.axis();
        *difference_m = apart[axis.index()];
        if let Some(detectable) = detectable_m {
            *detectable = *detectable / *error_m * errors[axis.index()];
        }
        *error_m = errors[axis.index()];
        if let Some(refused) = &mut surveyed.refused {
            refused.axis = Some(*axis);
        }
    }
}
