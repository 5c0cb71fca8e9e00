//! Control points that are lost by their image measurements, and that were given and place nothing.

use super::frame::Frame;
use super::result::{PointSource, ReconstructedModel};
use super::warning::{BlockWarning, ControlApart};
use crate::ObservationVerdict;
use crate::math::{dot3, median, minus, nearest_to_rays};
use crate::model::{BlockDescription, ControlRole, GroundControlPoint};
use std::collections::BTreeMap;

/// Of the measured control points, by which share more are lost than single slips explain.
const FEW: f64 = 0.2;
/// Rays that miss a common place by less than this many px meet there.
const MEETING_PX: f64 = 5.0;

/// Control points of which two images of a model or more have measurements.
struct Measured<'a> {
    /// Each with its index and whether it is in the model.
    points: Vec<(usize, &'a GroundControlPoint, bool)>,
}

impl<'a> Measured<'a> {
    /// `own`: of the points so many, the first, were given; places of an orthophoto behind them are judged otherwise.
    fn of(model: &ReconstructedModel, description: &'a BlockDescription, own: usize) -> Self {
        let control = description.control.iter().take(own).enumerate().filter(|(_, point)| point.role == ControlRole::Control);
        let is_measured = |point: &GroundControlPoint| {
            point.measurements.iter().filter(|seen| model.images.binary_search(&seen.image).is_ok()).count() >= 2
        };
        let mut accepted = BTreeMap::new();
        for (ray, statistics) in model.adjusted.block.rays.iter().zip(&model.adjusted.rays) {
            if statistics.verdict == ObservationVerdict::Accepted {
                *accepted.entry(model.points[ray.point]).or_insert(0) += 1;
            }
        }
        // One of which a single image measurement is left is lost, too: that fits nearly anything.
        let is_taken = |index: usize| accepted.get(&PointSource::GroundControl(index)).is_some_and(|rays| *rays >= 2);
        Self { points: control.filter(|(_, point)| is_measured(point)).map(|(index, point)| (index, point, is_taken(index))).collect() }
    }
}

/// Where more control points are lost than a few, since their image measurements do not meet, or do so elsewhere.
pub(super) fn of_lost(model: &ReconstructedModel, description: &BlockDescription, frame: &Frame, own: usize) -> Option<BlockWarning> {
    let measured = Measured::of(model, description, own).points;
    let lost: Vec<(usize, &GroundControlPoint)> =
        measured.iter().filter(|(.., is_taken)| !is_taken).map(|(index, point, _)| (*index, *point)).collect();
    // One alone may be a slip, unless it is all that there is, or half of that.
    if lost.is_empty() || (lost.len() == 1 && measured.len() > 2) || lost.len() as f64 <= FEW * measured.len() as f64 {
        return None;
    }
    let meeting = |row: Row| lost.iter().filter_map(move |(index, point)| Some((*index, meeting(model, description, point, row)?)));
    let is_most = |number: usize| 2 * number > lost.len();
    let as_given: Vec<(usize, [f64; 3])> = meeting(Row::FromTop).collect();
    let apart = (model.in_system && is_most(as_given.len())).then(|| apart_from(frame, &as_given)).flatten();
    let from_bottom = apart.is_none() && is_most(meeting(Row::FromBottom).count());
    Some(BlockWarning::ControlLost { lost: lost.len(), points: measured.len(), from_bottom, control_apart: apart })
}

/// Points that lie elsewhere in plan by less than so much of what they do in height differ in height.
const ALIKE_IN_PLAN: f64 = 0.2;

/// How far points that are seen lie from their coordinates.
fn apart_from(frame: &Frame, seen: &[(usize, [f64; 3])]) -> Option<ControlApart> {
    let off: Vec<[f64; 3]> = seen.iter().map(|(index, place)| minus(place, &frame.control[*index].0)).collect();
    let of = |length: &dyn Fn(&[f64; 3]) -> f64| median(&mut off.iter().map(length).collect::<Vec<_>>());
    let (across_m, up_m) = (of(&|[x, y, _]| libm::hypot(*x, *y))?, of(&|[_, _, z]| *z)?);
    Some(if across_m < ALIKE_IN_PLAN * up_m.abs() { ControlApart::Heights { up_m } } else { ControlApart::Places { across_m, up_m } })
}

/// Where control points were given, and nothing places the model. `told`: what else is said of that.
pub(super) fn of_unplaced(
    model: &ReconstructedModel,
    description: &BlockDescription,
    own: usize,
    told: &[BlockWarning],
) -> Option<BlockWarning> {
    let given = description.control.iter().take(own).filter(|point| point.role == ControlRole::Control).count();
    let is_told = told.iter().any(|warning| match warning {
        BlockWarning::Free { cause, .. } => cause.is_some(),
        BlockWarning::ControlShape { .. } | BlockWarning::ControlUnadjusted { .. } | BlockWarning::Degrees => true,
        _ => false,
    });
    if model.in_system || given == 0 || is_told {
        return None;
    }
    let measured = Measured::of(model, description, own).points;
    let taken = measured.iter().filter(|(.., is_taken)| *is_taken).count();
    Some(BlockWarning::ControlWithoutPlace { given, measured: measured.len(), taken })
}

/// Where the rows of an image begin.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Row {
    FromTop,
    FromBottom,
}

/// Where the image measurements of a point meet, with rows counted so; absent where they do not.
fn meeting(model: &ReconstructedModel, description: &BlockDescription, point: &GroundControlPoint, row: Row) -> Option<[f64; 3]> {
    let block = &model.adjusted.block;
    let rays = point.measurements.iter().filter_map(|seen| {
        let image = &block.images[model.images.binary_search(&seen.image).ok()?];
        let camera = &block.cameras[image.camera];
        let height_px = f64::from(description.cameras[description.images[seen.image].camera].height_px);
        let at = [seen.x_px, if row == Row::FromTop { seen.y_px } else { height_px - seen.y_px }];
        Some((image.pose, camera, at, image.pose.ray(camera.direction(at).ok()?)))
    });
    let rays: Vec<_> = rays.collect();
    let place = nearest_to_rays(rays.iter().map(|(pose, _, _, along)| (pose.position, *along)))?;
    let meet = rays.iter().all(|(pose, camera, at, _)| {
        let [u, v, w] = pose.to_photo(&place);
        let [x, y] = camera.project(-u / w, v / w);
        let off = minus(&[x, y, 0.0], &[at[0], at[1], 0.0]);
        w < 0.0 && dot3(&off, &off) < MEETING_PX * MEETING_PX
    });
    meet.then_some(place)
}
