//! Whether all GNSS positions lie apart from the block that ground control places, as heights above the ellipsoid do beside those above the sea: no single
//! one of them shows it.

use super::control_course::ControlTests;
use super::control_kind::ControlKind;
use super::material::Known;
use super::mistake::Axis;
use super::result::ReconstructedModel;
use super::warning::BlockWarning;
use crate::ControlRole;
use crate::math::median;

/// GNSS positions, at least, of which it is told that they have something in common.
const LEAST_POSITIONS: usize = 4;
/// Images that have followed an offset by more of their standard errors are not where these say: less than half of their intervals of 95 % hold.
const MOST_FOLLOWED: f64 = 2.0;

/// The axis along which they are off the most, in standard errors, where that is beyond a limit.
pub(super) fn of_common_positions(model: &ReconstructedModel, known: &Known<'_>, tests: &ControlTests) -> Option<BlockWarning> {
    let (frame, limit) = (known.frame, known.options.adjustment.limit());
    let datum = model.adjusted.datum;
    let taking = model.adjusted.images.iter().filter(|image| image.gnss.is_some_and(|gnss| gnss.accepted)).count();
    if !datum.uses_gnss() || !datum.uses_control() || model.adjusted.systematic.is_some() || taking < LEAST_POSITIONS {
        return None;
    }
    let (block, accepted) = model.with_support();
    let offset = model.adjusted.common_offset(&block, &accepted).ok()?;
    let control = !tests.refused.is_empty() || tests.contradicting.is_some();
    let taking_part = model.surveyed.iter().filter(|point| point.role == ControlRole::Control);
    let held_by = ControlKind::of(taking_part.map(|point| point.name.as_str()), |name| known.is_place(name));
    let of_axis = |axis: Axis| {
        let offset = offset[axis.index()]?;
        let focal = axis == Axis::Z && model.adjusted.block.cameras.iter().any(|camera| camera.free.focal);
        let times = offset.value.abs() / offset.error;
        let error_m = image_error_m(model, axis);
        let images_m = Some(offset.followed).filter(|followed| error_m.is_some_and(|error| followed.abs() > MOST_FOLLOWED * error));
        Some((times, BlockWarning::PositionsApart { axis, difference_m: offset.value, times, images_m, focal, control, held_by }))
    };
    // What a height that was not recorded differs by tells nothing.
    let observed = Axis::ALL.into_iter().filter(|axis| !(frame.is_levelled && *axis == Axis::Z));
    let apart = observed.filter_map(of_axis).filter(|(times, _)| *times > limit);
    apart.max_by(|(a, _), (b, _)| a.total_cmp(b)).map(|(_, warning)| warning)
}

/// The standard error of a coordinate of an image that has a position, in the median.
fn image_error_m(model: &ReconstructedModel, axis: Axis) -> Option<f64> {
    let observed = model.adjusted.images.iter().filter(|image| image.gnss.is_some_and(|gnss| gnss.accepted));
    median(&mut observed.filter_map(|image| Some(image.position_errors?[axis.index()])).collect::<Vec<f64>>())
}
