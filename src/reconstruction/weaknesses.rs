//! What is weak about a model, in words.

use super::frame::Frame;
use super::result::PointSource;
use super::result::{ReconstructedModel, UnorientedReason};
use super::units::of_units;
use crate::adjustment::ObservationVerdict;
use crate::model::BlockDescription;
use crate::text::counted;

/// An image with fewer accepted rays is weak.
const FEW_RAYS: usize = 20;
/// A model is weak where this share of its points has two rays only.
const MANY_TWO_RAYS: f64 = 0.8;
/// A model is weak where this share of its rays was rejected.
const MANY_REJECTED: f64 = 0.2;
/// A model is weak where the angles of no image are surer than this.
const UNCERTAIN_TURN_DEG: f64 = 2.0;
/// An angle that is not surer than this is not known.
const UNKNOWN_TURN_DEG: f64 = 45.0;
/// Views that are this far off the vertical are no vertical photographs.
const OBLIQUE_DEG: f64 = 10.0;
/// Images are named one by one up to so many.
const NAMED: usize = 5;

pub(super) fn weaknesses(
    model: &ReconstructedModel,
    description: &BlockDescription,
    frame: &Frame,
    complaint: Option<String>,
) -> Vec<String> {
    let mut found = Vec::new();
    found.extend(of_datum(model, complaint));
    found.extend(of_positions(model, description, frame));
    found.extend(of_units(model, description, frame));
    found.extend(of_marks(model, description));
    found.extend(of_cameras(model, description));
    found.extend(of_images(model, description));
    found.extend(of_rays(model));
    found
}

fn of_datum(model: &ReconstructedModel, complaint: Option<String>) -> Option<String> {
    if model.in_system {
        return of_turn(model);
    }
    let free = "The place, the turn and the scale of the model are arbitrary: no observed positions determine them";
    Some(complaint.map_or(format!("{free}."), |reason| format!("{free} ({reason}).")))
}

/// Positions along a line leave the turn about it to their own errors. Errors that the positions of a strip have in common, as those of
/// heights, turn the block further than standard errors say: what shows of it is the tilt of views that were meant to be vertical.
fn of_turn(model: &ReconstructedModel) -> Option<String> {
    let largest = |angles: [f64; 3]| angles.into_iter().fold(0.0, f64::max);
    let least = model.adjusted.images.iter().filter_map(|image| image.angle_errors_deg.map(largest)).min_by(f64::total_cmp)?;
    let datum = model.adjusted.datum;
    let observed = match (datum.uses_gnss(), datum.uses_control()) {
        (true, true) => "recorded positions and surveyed points",
        (false, true) => "surveyed points",
        _ => "recorded positions",
    };
    let told = match least {
        least if least > UNKNOWN_TURN_DEG => format!("The {observed} do not determine how the whole block is turned about their line"),
        least => {
            format!("The {observed} hardly determine how the whole block is turned: its angles are uncertain by ± {least:.0}° or more")
        }
    };
    let tilt = mean_tilt_deg(model);
    let views = if tilt > OBLIQUE_DEG { format!("; the views are {tilt:.0}° off the vertical on average") } else { String::new() };
    (least > UNCERTAIN_TURN_DEG).then(|| format!("{told}{views}."))
}

/// The angle between the mean direction of view and the vertical.
fn mean_tilt_deg(model: &ReconstructedModel) -> f64 {
    let images = &model.adjusted.block.images;
    let [x, y, z] = [0, 1, 2].map(|k| images.iter().map(|image| image.pose.rotation[2][k]).sum::<f64>());
    libm::atan2((x * x + y * y).sqrt(), z).to_degrees()
}

/// Recorded positions that took no part, and heights that were not recorded.
fn of_positions(model: &ReconstructedModel, description: &BlockDescription, frame: &Frame) -> Vec<String> {
    let mut found = Vec::new();
    if frame.is_levelled && model.adjusted.datum.uses_gnss() {
        found.push(
            "The recorded positions have no heights: the flight is taken as level, heights count from it, and the block may be tilted."
                .into(),
        );
    }
    let refused = model.images.iter().zip(&model.adjusted.images).filter_map(|(image, statistics)| {
        let prior = statistics.gnss.filter(|prior| !prior.accepted)?;
        let [x, y, z] = prior.residual;
        Some((*image, (x * x + y * y + z * z).sqrt()))
    });
    let refused: Vec<(usize, f64)> = refused.collect();
    let named = refused.iter().take(NAMED).map(|(image, distance)| format!("{} ({distance:.1} m)", description.images[*image].name));
    if !refused.is_empty() {
        let named = named.collect::<Vec<_>>().join(", ");
        let more = if refused.len() > NAMED { " and others" } else { "" };
        found.push(match refused.len() {
            1 => format!("1 recorded position does not fit and was left out, with how far it lies off: {named}."),
            n => format!("{n} recorded positions do not fit and were left out, with how far they lie off: {named}{more}."),
        });
    }
    found
}

/// Surveyed points whose marks do not fit, each by its name.
fn of_marks(model: &ReconstructedModel, description: &BlockDescription) -> Vec<String> {
    let place = |control: usize| model.points.iter().position(|point| *point == PointSource::GroundControl(control));
    let name = |image: usize| description.images[model.images[image]].name.clone();
    let mut found = Vec::new();
    for (index, control) in description.control.iter().enumerate() {
        let marks = control.measurements.iter().filter(|ray| model.images.binary_search(&ray.image).is_ok()).count();
        if marks == 0 {
            continue;
        }
        let Some(point) = place(index) else {
            found.push(match marks {
                1 => format!("The surveyed point {} was left out: it has one mark in oriented images.", control.name),
                _ => format!("The surveyed point {} was left out: its {marks} marks in oriented images do not meet.", control.name),
            });
            continue;
        };
        let of_rays = model.adjusted.block.rays.iter().zip(&model.adjusted.rays);
        let after = of_rays.filter(|(ray, statistics)| ray.point == point && statistics.verdict != ObservationVerdict::Accepted);
        let mut images: Vec<usize> = after.map(|(ray, _)| ray.image).collect();
        images.extend(model.rejected.iter().filter(|ray| ray.point == point).map(|ray| ray.image));
        images.sort_unstable();
        if !images.is_empty() {
            let names = images.iter().map(|image| name(*image)).collect::<Vec<_>>().join(", ");
            let (n, verb) = (images.len(), if images.len() == 1 { "does" } else { "do" });
            found.push(format!("{n} of the {} of the surveyed point {} {verb} not fit: {names}.", counted(marks, "mark"), control.name));
        }
    }
    found
}

fn of_cameras(model: &ReconstructedModel, description: &BlockDescription) -> Vec<String> {
    let mut found = Vec::new();
    for (camera, statistics) in model.cameras.iter().zip(&model.adjusted.cameras) {
        let named = description.camera_named(*camera);
        if model.guessed_focal.contains(camera) {
            let estimated = statistics.standard_errors[0];
            found.push(match estimated {
                Some(error) => format!("The focal length of {named} was not known; it is estimated to ± {error:.1} px."),
                None => {
                    format!("The focal length of {named} was not known, and the block does not determine it: heights are wrong in scale.")
                }
            });
        }
        for fixed in &statistics.fixed {
            found.push(format!("The block does not determine {} of {named}; it was left as it was.", fixed.parameter.name()));
        }
    }
    found
}

fn of_images(model: &ReconstructedModel, description: &BlockDescription) -> Option<String> {
    let weak: Vec<&str> = (model.images.iter().zip(&model.adjusted.images))
        .filter(|(_, statistics)| statistics.rays < FEW_RAYS)
        .map(|(image, _)| description.images[*image].name.as_str())
        .collect();
    let named = weak.iter().take(NAMED).copied().collect::<Vec<_>>().join(", ");
    let more = if weak.len() > NAMED { " and others" } else { "" };
    let verb = if weak.len() == 1 { "has" } else { "have" };
    (!weak.is_empty()).then(|| format!("{} {verb} fewer than {FEW_RAYS} rays: {named}{more}.", counted(weak.len(), "image")))
}

fn of_rays(model: &ReconstructedModel) -> Vec<String> {
    let mut found = Vec::new();
    let points: usize = model.adjusted.rmse_by_rays.iter().map(|group| group.points).sum();
    let two: usize = model.adjusted.rmse_by_rays.iter().filter(|group| group.rays == 2).map(|group| group.points).sum();
    if two as f64 > MANY_TWO_RAYS * points as f64 {
        let all = counted(points, "point");
        found.push(format!("{two} of {all} of the adjustment have two rays only: their errors along the base do not show."));
    }
    let lost = model.adjusted.rays.iter().filter(|ray| ray.verdict != ObservationVerdict::Accepted).count() + model.rejected.len();
    let all = model.adjusted.rays.len() + model.rejected.len();
    if lost as f64 > MANY_REJECTED * all as f64 {
        found.push(format!("{lost} of {all} rays do not fit."));
    }
    found
}

impl UnorientedReason {
    /// The reason as a sentence about an image.
    pub(super) fn in_words(self, name: &str) -> String {
        match self {
            Self::NoPoints => format!("{name} has no multi-ray points."),
            Self::TooFewPoints { points, needed } => {
                format!("{name} sees {}; at least {needed} are needed.", counted(points, "intersected point"))
            }
            Self::NoAgreement { agreeing, points, needed } => {
                let rays = counted(points, "ray");
                format!(
                    "Of the {rays} of {name} to intersected points {agreeing} agree on one orientation; at least {needed} must, and a fifth."
                )
            }
            Self::Narrow { agreeing } => format!("The {agreeing} rays of {name} that agree lie on a line or in one spot of the image."),
            Self::NoPartner => format!("{name} has too few points in common with any image, or none from another place."),
            Self::Lost { rays } => format!("{name} was oriented and kept only {}.", counted(rays, "ray")),
            Self::Undetermined { rays } => {
                format!("{name} was oriented with {}; the bundle adjustment rejected too many of them.", counted(rays, "ray"))
            }
        }
    }
}
