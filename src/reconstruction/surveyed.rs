//! What a finished model says of surveyed points: of those that place it, and of check points, whose coordinates took no part.

use super::control_course::ControlTests;
use super::material::Known;
use super::result::{PointSource, ReconstructedModel, RefusedControl, SurveyedPoint};
use crate::adjustment::{LeftOut, ObservationVerdict};
use crate::{GroundControlPoint, ObservedPosition};

/// The surveyed points of a model that lies in their system, in the order of its points: by control points, or by GNSS positions of the same system whose
/// heights are known.
pub(super) fn surveyed_points(model: &ReconstructedModel, known: &Known<'_>, tests: &ControlTests) -> Vec<SurveyedPoint> {
    let Known { description, frame, .. } = known;
    let datum = model.adjusted.datum;
    let is_in_frame = |point: &GroundControlPoint| matches!(point.position, ObservedPosition::Geographic { .. }) == frame.origin.is_some();
    let is_by_gnss = || datum.uses_gnss() && !frame.is_levelled && description.control.iter().all(is_in_frame);
    if !model.in_system || !(datum.uses_control() || is_by_gnss()) {
        return Vec::new();
    }
    let adjusted = &model.adjusted;
    // Check points were surveyed as control points were.
    let factors = adjusted.factors_of_control();
    let mut rays = vec![0; model.points.len()];
    let of_rays = adjusted.block.rays.iter().zip(&adjusted.rays);
    of_rays.filter(|(_, ray)| ray.verdict == ObservationVerdict::Accepted).for_each(|(ray, _)| rays[ray.point] += 1);
    let of_point = |(place, source): (usize, &PointSource)| {
        let PointSource::GroundControl(index) = source else { return None };
        let (known, (position, sigma)) = (&description.control[*index], frame.control[*index]);
        let sigma = [0, 1, 2].map(|k| sigma[k] * factors[k]);
        let point = adjusted.points[place]?;
        let control = adjusted.block.control.iter().position(|control| control.point == place);
        let standard_errors_m = [0, 1, 2].map(|k| match control {
            None => point.errors.map(|errors| (errors[k] * errors[k] + sigma[k] * sigma[k]).sqrt()),
            Some(control) => {
                let redundancy = adjusted.control[control]?.redundancy?[k];
                (redundancy > 0.0).then(|| sigma[k] * redundancy.sqrt())
            }
        });
        let difference_m = [0, 1, 2].map(|k| adjusted.block.points[place][k] - position[k]);
        let refused = tests.refused.iter().find(|refused| refused.point == place);
        // One that takes no part is where the others have it.
        let without = || {
            let [x, y, z] = standard_errors_m;
            refused.map(|_| Some(LeftOut { difference: difference_m, standard_errors: [x?, y?, z?] }))?
        };
        let statistics = control.and_then(|control| adjusted.control[control].as_ref());
        Some(SurveyedPoint {
            name: known.name.clone(),
            role: known.role,
            rays: rays[place],
            position,
            difference_m,
            standard_errors_m,
            left_out: if control.is_some() { statistics.and_then(|statistics| statistics.left_out) } else { without() },
            // Tests of control points hold what the observations of an image share; those of a block that is not tested so do not.
            detectable_m: tests
                .detectable
                .get(&place)
                .copied()
                .unwrap_or_else(|| statistics.filter(|_| refused.is_none()).map_or([None; 3], |statistics| statistics.detectable)),
            refused: refused.map(|refused| RefusedControl {
                axis: refused.test.filter(|_| !refused.is_within).map(|test| test.axis()),
                is_used: refused.is_used,
            }),
        })
    };
    model.points.iter().enumerate().filter_map(of_point).collect()
}
