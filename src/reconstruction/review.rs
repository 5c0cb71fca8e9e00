//! What of a model deserves a warning.

use super::check_refused::of_wrong_checks;
use super::common_shift::of_check_points;
use super::control_course::{ControlTests, Refused};
use super::control_lost::{of_lost, of_unplaced};
use super::control_shape::of_shape;
use super::control_spread::of_spread;
use super::exchanged_names::name_exchanged;
use super::frame::Frame;
use super::level::{LEVEL_DEG, UNCERTAIN_TURN_DEG, uncertainty_deg};
use super::material::Known;
use super::net::LEAST_LIMIT_PX;
use super::placing::Placing;
use super::positions_apart::of_common_positions;
use super::result::{PointSource, ReconstructedModel};
use super::units::of_units;
use super::warning::{BlockWarning, Observed, RejectedPosition, UNKNOWN_TURN_DEG};
use crate::adjustment::{Datum, ObservationStatistics, ObservationVerdict, SystematicError, SystematicVerdict};
use crate::math::median;
use crate::model::{BlockDescription, ControlRole};
use crate::pair::LARGEST_SIGMA0_PX;

/// An image with fewer accepted rays is weak.
const FEW_RAYS: usize = 20;
/// A model is weak where this share of its points has two rays only.
const MANY_TWO_RAYS: f64 = 0.8;
/// A model is weak where this share of its rays are gross errors.
const MANY_GROSS: f64 = 0.2;

/// Views that are this far off the vertical are no vertical photographs.
const OBLIQUE_DEG: f64 = 10.0;

/// Most views of a flight that are farther off the vertical look up at ground that is mirrored.
const LOOKING_UP_DEG: f64 = 150.0;

/// `placing`: how the model came to lie where it does.
pub(super) fn warnings(model: &ReconstructedModel, known: &Known<'_>, placing: Placing, tests: &ControlTests) -> Vec<BlockWarning> {
    let Known { description, frame, .. } = *known;
    let mut found = Vec::new();
    // Of control points in degrees nothing else says what is wrong.
    let (degrees, scale): (Vec<_>, Vec<_>) =
        of_units(model, description, frame).into_iter().partition(|warning| matches!(warning, BlockWarning::Degrees));
    found.extend(degrees);
    found.extend(match placing {
        Placing::Observed => of_rotation(model).or_else(|| of_view(model)),
        Placing::Levelled { recorded, error_deg } => {
            // What may be off by any angle is not determined.
            let error_deg = error_deg.filter(|error| *error < UNKNOWN_TURN_DEG);
            Some(BlockWarning::Levelled { recorded, error_deg, level_deg: LEVEL_DEG })
        }
        Placing::Free { cause: None } => Some(BlockWarning::Free { cause: None, without_heights: without_heights(model) }),
        Placing::Free { cause } => Some(BlockWarning::Free { cause, without_heights: 0 }),
    });
    let own_control = known.options.tested_control.unwrap_or(usize::MAX);
    found.extend(of_lost(model, description, frame, own_control));
    found.extend(of_sigma(model));
    found.extend(of_weights(model));
    found.extend(of_positions(model, description, frame));
    found.extend(of_common_positions(model, known, tests));
    found.extend(of_position_errors(model));
    found.extend(scale);
    found.extend(of_control(model, known, tests));
    found.extend(of_wrong_checks(model, known));
    found.extend(of_check_points(model, known));
    found.extend(of_shape(model, description));
    found.extend(of_unplaced(model, description, own_control, &found));
    found.extend(of_spread(model));
    found.extend(of_measurements(model, description));
    found.extend(of_cameras(model, description));
    found.extend(of_images(model, description));
    found.extend(of_observations(model));
    name_exchanged(&mut found, &model.surveyed, known.options.adjustment.limit());
    found
}

/// GNSS positions whose heights do not count from where those of control points do.
fn without_heights(model: &ReconstructedModel) -> usize {
    model.adjusted.block.images.iter().filter(|image| image.gnss.is_some_and(|gnss| gnss.sigma[2].is_none())).count()
}

fn of_sigma(model: &ReconstructedModel) -> Option<BlockWarning> {
    let sigma0_px = model.adjusted.sigma0_px.filter(|sigma0_px| *sigma0_px > LARGEST_SIGMA0_PX)?;
    Some(BlockWarning::Imprecise { sigma0_px, most_px: LARGEST_SIGMA0_PX })
}

fn of_weights(model: &ReconstructedModel) -> Option<BlockWarning> {
    let weighting = model.adjusted.weighting.filter(|weighting| !weighting.converged)?;
    Some(BlockWarning::WeightsNotConverged { rounds: weighting.rounds })
}

/// Points or positions of which two axes are exchanged are those of a mirrored ground, which fits as well from below where it is flat.
fn of_view(model: &ReconstructedModel) -> Option<BlockWarning> {
    // Each by itself: the mean of views all around is any direction.
    let tilt_deg = |rotation: &[[f64; 3]; 3]| libm::acos(rotation[2][2].clamp(-1.0, 1.0)).to_degrees();
    let mut tilts: Vec<f64> = model.adjusted.block.images.iter().map(|image| tilt_deg(&image.pose.rotation)).collect();
    let tilt_deg = median(&mut tilts)?;
    (tilt_deg > LOOKING_UP_DEG).then(|| BlockWarning::LookingUp { observed: observed_by(model), tilt_deg })
}

/// What was observed of where the model lies.
fn observed_by(model: &ReconstructedModel) -> Observed {
    let datum = model.adjusted.datum;
    match (datum.uses_gnss(), datum.uses_control()) {
        (true, true) => Observed::Both,
        (false, true) => Observed::Points,
        _ => Observed::Positions,
    }
}

/// Positions along a line leave the turn about it to their own errors. Errors that the positions of a strip have in common, as those of
/// heights, turn the block further than standard errors say: what shows of it is the tilt of views that were meant to be vertical.
fn of_rotation(model: &ReconstructedModel) -> Option<BlockWarning> {
    let error_deg = uncertainty_deg(&model.adjusted)?;
    let observed = observed_by(model);
    let tilt_deg = Some(mean_tilt_deg(model)).filter(|tilt| *tilt > OBLIQUE_DEG);
    match error_deg {
        error if error > UNKNOWN_TURN_DEG => Some(BlockWarning::UnknownRotation { observed, tilt_deg }),
        error if error > UNCERTAIN_TURN_DEG => Some(BlockWarning::UncertainRotation { observed, error_deg, tilt_deg }),
        _ => None,
    }
}

/// The angle between the mean direction of view and the vertical.
fn mean_tilt_deg(model: &ReconstructedModel) -> f64 {
    let images = &model.adjusted.block.images;
    let [x, y, z] = [0, 1, 2].map(|k| images.iter().map(|image| image.pose.rotation[2][k]).sum::<f64>());
    libm::atan2((x * x + y * y).sqrt(), z).to_degrees()
}

/// GNSS positions that took no part, and heights that they do not have.
fn of_positions(model: &ReconstructedModel, description: &BlockDescription, frame: &Frame) -> Vec<BlockWarning> {
    let is_left_out = |index: usize| model.adjusted.systematic.as_ref().is_some_and(|systematic| systematic.left_out.contains(&index));
    let own = model.images.iter().zip(&model.adjusted.images).enumerate().filter(|(index, _)| !is_left_out(*index));
    let images = own.filter_map(|(_, (image, statistics))| {
        let [x, y, z] = statistics.gnss.filter(|prior| !prior.accepted)?.residual;
        Some(RejectedPosition { name: description.images[*image].name.clone(), distance_m: (x * x + y * y + z * z).sqrt() })
    });
    let images: Vec<RejectedPosition> = images.collect();
    let level = (frame.is_levelled && model.adjusted.datum == Datum::Gnss).then_some(BlockWarning::NoHeights);
    level.into_iter().chain((!images.is_empty()).then_some(BlockWarning::PositionsRejected { images })).collect()
}

/// Systematic errors of GNSS positions that the block does not determine, or only beside each other.
fn of_position_errors(model: &ReconstructedModel) -> Vec<BlockWarning> {
    let Some(systematic) = &model.adjusted.systematic else { return Vec::new() };
    let number = |verdict| systematic.errors.iter().filter(|error| error.verdict == verdict).count();
    let errors = number(SystematicVerdict::Undetermined);
    let is_of_strip = |error| matches!(error, SystematicError::StripOffset { .. } | SystematicError::StripDrift { .. });
    let is_kept = systematic.errors.iter().any(|error| error.verdict == SystematicVerdict::Kept && is_of_strip(error.error));
    let undetermined = (errors > 0).then_some(BlockWarning::PositionErrorsUndetermined { errors });
    let motions = systematic.constraints;
    let relative = (is_kept && motions > 0).then_some(BlockWarning::PositionErrorsRelative { motions });
    undetermined.into_iter().chain(relative).collect()
}

/// GCPs whose coordinates contradict the other observations, each by its name.
fn of_control(model: &ReconstructedModel, known: &Known<'_>, tests: &ControlTests) -> Vec<BlockWarning> {
    let of_point = |refused: &Refused| {
        let PointSource::GroundControl(control) = model.points[refused.point] else { return None };
        let point = known.description.control[control].name.clone();
        let measurements = || model.adjusted.block.rays.iter().filter(|ray| ray.point == refused.point).count();
        let Some(test) = &refused.test else {
            return Some(BlockWarning::ControlUntested { point, measurements: measurements() });
        };
        if refused.is_within {
            return Some(BlockWarning::ControlUnplaced { point, measurements: measurements() });
        }
        let axis = test.axis();
        let k = axis.index();
        let surveyed = model.surveyed.iter().find(|surveyed| surveyed.name == point);
        let limit = known.options.adjustment.limit();
        let mistake = surveyed.and_then(|surveyed| {
            let left = surveyed.left_out.map_or([test.difference, test.errors], |left| [left.difference, left.standard_errors]);
            surveyed.mistake(known.frame, left, limit)
        });
        Some(BlockWarning::ControlRefused {
            point,
            axis,
            difference_m: test.difference[k],
            error_m: test.errors[k],
            detectable_m: test.detectable[k],
            used: refused.is_used,
            certain: refused.is_certain,
            mistake,
        })
    };
    let contradicting =
        tests.contradicting.map(|of| BlockWarning::ControlContradicts { refused: of.refused, points: of.of, w: Some(of.w) });
    let stopped = tests.stopped.map(|[left_out, points]| BlockWarning::ControlTestsStopped { left_out, points });
    let name = |point: &usize| match model.points[*point] {
        PointSource::GroundControl(control) => Some(known.description.control[control].name.clone()),
        PointSource::TiePoint(_) | PointSource::Manual(_) => None,
    };
    let names: Vec<String> = tests.unadjusted.iter().filter_map(name).collect();
    let unadjusted = (!names.is_empty()).then_some(BlockWarning::ControlUnadjusted { names });
    tests
        .refused
        .iter()
        .filter(|refused| refused.is_named)
        .filter_map(of_point)
        .chain(contradicting)
        .chain(stopped)
        .chain(unadjusted)
        .collect()
}

/// GCPs whose image measurements do not fit, each by its name.
fn of_measurements(model: &ReconstructedModel, description: &BlockDescription) -> Vec<BlockWarning> {
    let place = |control: usize| model.points.iter().position(|point| *point == PointSource::GroundControl(control));
    let name = |image: usize| description.images[model.images[image]].name.clone();
    let mut found = Vec::new();
    for (index, control) in description.control.iter().enumerate() {
        let measurements = control.measurements.iter().filter(|ray| model.images.binary_search(&ray.image).is_ok()).count();
        if measurements == 0 {
            continue;
        }
        let check = control.role == ControlRole::Check;
        let Some(place) = place(index) else {
            found.push(BlockWarning::PointRejected { point: control.name.clone(), measurements, check });
            continue;
        };
        let of_rays = model.adjusted.block.rays.iter().zip(&model.adjusted.rays);
        let after = of_rays.filter(|(ray, statistics)| ray.point == place && statistics.verdict != ObservationVerdict::Accepted);
        let mut images: Vec<usize> = after.map(|(ray, _)| ray.image).collect();
        images.extend(model.rejected.iter().filter(|ray| ray.point == place && !ray.by_hand).map(|ray| ray.image));
        images.sort_unstable();
        if !images.is_empty() {
            let images = images.into_iter().map(name).collect();
            found.push(BlockWarning::MeasurementsRejected { point: control.name.clone(), measurements, images, check });
        }
    }
    found
}

/// A focal length is determined by the block where its standard error is below this share of what was known before.
const DETERMINED: f64 = 0.5;

fn of_cameras(model: &ReconstructedModel, description: &BlockDescription) -> Vec<BlockWarning> {
    let mut found = Vec::new();
    for (index, statistics) in model.cameras.iter().zip(&model.adjusted.cameras) {
        let camera = description.named_camera(*index);
        if model.guessed_focal.contains(index) {
            let given = &description.cameras[*index];
            let most_px = DETERMINED * given.known_within().focal * given.approximate().focal_px;
            found.push(match statistics.standard_errors[0].filter(|error_px| *error_px < most_px) {
                Some(error_px) => BlockWarning::FocalEstimated { camera: camera.clone(), error_px },
                None => BlockWarning::FocalUndetermined { camera: camera.clone() },
            });
        }
        let fixed = |camera_parameter| BlockWarning::ParameterFixed { camera: camera.clone(), camera_parameter };
        found.extend(statistics.fixed.iter().map(|is| fixed(is.parameter)));
    }
    found
}

fn of_images(model: &ReconstructedModel, description: &BlockDescription) -> Option<BlockWarning> {
    let weak = model.images.iter().zip(&model.adjusted.images).filter(|(_, statistics)| statistics.rays < FEW_RAYS);
    let images: Vec<String> = weak.map(|(image, _)| description.images[*image].name.clone()).collect();
    (!images.is_empty()).then_some(BlockWarning::FewObservations { images, least: FEW_RAYS })
}

fn of_observations(model: &ReconstructedModel) -> Vec<BlockWarning> {
    let points: usize = model.adjusted.rmse_by_rays.iter().map(|group| group.points).sum();
    let two: usize = model.adjusted.rmse_by_rays.iter().filter(|group| group.rays == 2).map(|group| group.points).sum();
    // What the user rejected says nothing of the others.
    let misfits = || model.rejected.iter().filter(|ray| !ray.by_hand);
    let before = misfits().filter(|ray| is_gross(ray.residual_px)).count();
    // Nor does a ray that is alone at its point, as it leaves many where an image is rejected.
    let rays = &model.adjusted.block.rays;
    let mut of_point = vec![0_usize; model.adjusted.block.points.len()];
    rays.iter().for_each(|ray| of_point[ray.point] += 1);
    let judged = || rays.iter().zip(&model.adjusted.rays).filter(|(ray, _)| of_point[ray.point] > 1);
    let rejected = before + judged().filter(|(_, statistics)| is_gross_error(statistics)).count();
    let observations = judged().count() + misfits().count();
    let weak = (two as f64 > MANY_TWO_RAYS * points as f64).then_some(BlockWarning::TwoRays { two, points });
    let wrong = (rejected as f64 > MANY_GROSS * observations as f64).then_some(BlockWarning::ManyRejected { rejected, observations });
    weak.into_iter().chain(wrong).collect()
}

fn is_gross_error(ray: &ObservationStatistics) -> bool {
    let [x, y] = ray.residual_px;
    match ray.verdict {
        ObservationVerdict::Accepted => false,
        ObservationVerdict::Behind => true,
        ObservationVerdict::GrossError | ObservationVerdict::LostPoint => is_gross(Some((x * x + y * y).sqrt())),
    }
}

/// Whether a rejected ray is wrong: one whose residual the growth of any block would accept belongs to its point. Rays that are refined are so precise
/// that small differences between what two images show of a point exceed the limit of their test. Of eight simulated blocks with σ₀ from 0.03 to
/// 0.06 px, whose points are all right by the truth, the tests rejected 5 to 11 % of the rays, half of them by residuals below 0.35 px; above 1 px were
/// 0.3 % of the rays. Of a block of photographs, 0.12 px, 13 % were rejected and 7 % above 1 px.
fn is_gross(residual_px: Option<f64>) -> bool {
    residual_px.is_none_or(|length| length > LEAST_LIMIT_PX)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ray(verdict: ObservationVerdict, residual_px: [f64; 2]) -> ObservationStatistics {
        let none = [None; 2];
        ObservationStatistics { verdict, residual_px, redundancy: None, w: None, detectable_px: none, influence: none, moves_point: none }
    }

    #[test]
    fn a_ray_that_is_rejected_by_less_than_a_pixel_is_no_gross_error() {
        for verdict in [ObservationVerdict::GrossError, ObservationVerdict::LostPoint] {
            assert!(!is_gross_error(&ray(verdict, [0.7, 0.7])));
            assert!(is_gross_error(&ray(verdict, [0.7, -0.8])));
        }
        assert!(!is_gross_error(&ray(ObservationVerdict::Accepted, [3.0, 0.0])));
        assert!(is_gross_error(&ray(ObservationVerdict::Behind, [0.0, 0.0])));
        // Behind the image there is no residual.
        assert!(is_gross(None) && !is_gross(Some(1.0)) && is_gross(Some(1.1)));
    }
}
