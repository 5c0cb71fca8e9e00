//! What a finished model says of surveyed points: of those that place it, and of check points, whose coordinates took no part.

use super::frame::Frame;
use super::result::{PointSource, ReconstructedModel, SurveyedPoint};
use crate::adjustment::ObservationVerdict;
use crate::model::BlockDescription;

/// The surveyed points of a model that lies in their system, in the order of its points.
pub(super) fn surveyed_points(model: &ReconstructedModel, description: &BlockDescription, frame: &Frame) -> Vec<SurveyedPoint> {
    if !model.in_system || !model.adjusted.datum.uses_control() {
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
        Some(SurveyedPoint {
            name: known.name.clone(),
            role: known.role,
            rays: rays[place],
            position,
            difference_m: [0, 1, 2].map(|k| adjusted.block.points[place][k] - position[k]),
            standard_errors_m,
            left_out: control.and_then(|control| adjusted.control[control]?.left_out),
        })
    };
    model.points.iter().enumerate().filter_map(of_point).collect()
}
