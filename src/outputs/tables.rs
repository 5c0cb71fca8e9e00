//! The tables of a finished block: images, tie points, observations, pairs.

use super::given_points::AbsentPoint;
use super::images::ImageRow;
use super::in_system::InSystem;
use super::pairs::PairRow;
use super::refined::refined_observations;
use crate::formats::{images_table, points_table, rays_table};
use crate::text::{Row, table};
use crate::{BlockRun, ControlRole, ObservationVerdict, PairOutcome, RefinedObservation, SurveyedPoint};
use std::collections::BTreeSet;

const OF_IMAGES: [&str; 14] = [
    "model",
    "features",
    "rays",
    "places",
    "exif_orientation",
    "recorded_longitude_deg",
    "recorded_latitude_deg",
    "recorded_height_m",
    "sigma_x",
    "sigma_y",
    "sigma_z",
    "sigma_omega_deg",
    "sigma_phi_deg",
    "sigma_kappa_deg",
];
const OF_POINTS: [&str; 3] = ["sigma_x", "sigma_y", "sigma_z"];
const OF_RAYS: [&str; 3] = ["refinement", "standard_error_px", "correlation"];
const EDITED: [&str; 1] = ["by_hand"];
const CONTROL: [&str; 23] = [
    "name",
    "use",
    "rays",
    "x",
    "y",
    "z",
    "dx",
    "dy",
    "dz",
    "sigma_dx",
    "sigma_dy",
    "sigma_dz",
    "left_out_dx",
    "left_out_dy",
    "left_out_dz",
    "sigma_left_out_dx",
    "sigma_left_out_dy",
    "sigma_left_out_dz",
    "detectable_dx",
    "detectable_dy",
    "detectable_dz",
    "point",
    "state",
];
const PAIRS: [&str; 13] = [
    "first",
    "second",
    "first_name",
    "second_name",
    "rule",
    "outcome",
    "matches",
    "geometry",
    "degenerate",
    "sigma_px",
    "common_points",
    "chosen_points",
    "reason",
];
/// Of an edited block.
const EDITED_PAIRS: [&str; 1] = ["rejected_by_hand"];

/// `images.csv`; models count from 1, as texts number them.
pub(super) fn images(shown: &InSystem<'_>, rows: &[ImageRow]) -> String {
    let errors = shown.image_errors();
    images_table(&shown.model(), &OF_IMAGES, |index, row| {
        let image = &rows[index];
        let row = row.known(image.model.map(|model| model + 1)).known(image.features).number(image.observations).number(image.positions);
        let row = row.known(image.exif_orientation);
        let position = image.gnss.as_ref();
        let row =
            row.known(position.map(|p| p.longitude_deg)).known(position.map(|p| p.latitude_deg)).known(position.and_then(|p| p.height_m));
        row.numbers(errors[index].position.map(|position| position.errors)).numbers(errors[index].angles_deg)
    })
}

/// `points.csv`.
pub(super) fn points(shown: &InSystem<'_>) -> String {
    let errors = shown.point_errors();
    points_table(&shown.model(), &OF_POINTS, |index, row| row.numbers(errors[index]))
}

/// `rays.csv`; of an edited block it says what was measured by hand.
pub(super) fn rays(run: &BlockRun) -> String {
    let refined = run.refinement.as_ref().map(|refinement| refined_observations(&run.model, refinement));
    let by_hand = run.edited.as_ref().map(|_| measured_by_hand(run));
    let columns: Vec<&str> =
        [refined.as_ref().map(|_| &OF_RAYS[..]), by_hand.as_ref().map(|_| &EDITED[..])].into_iter().flatten().flatten().copied().collect();
    rays_table(&run.model, &columns, |point, index, row| {
        let row = match refined.as_ref().map(|refined| refined[point][index]) {
            None => row,
            Some(None) => row.number("").number("").number(""),
            Some(Some(RefinedObservation { outcome, standard_error_px, correlation, .. })) => {
                let [error, correlation] = [standard_error_px, correlation].map(|value| value.map(f64::from));
                row.number(word(outcome)).known(error).known(correlation)
            }
        };
        match &by_hand {
            None => row,
            Some(by_hand) => row.number(u8::from(by_hand[point][index])),
        }
    })
}

/// Of each point of the model that is written and each of its observations, whether it was measured by hand.
fn measured_by_hand(run: &BlockRun) -> Vec<Vec<bool>> {
    let Some(model) = run.reconstruction.as_ref().ok().and_then(|assembly| assembly.models.first()) else { return Vec::new() };
    let mut of_points = vec![Vec::new(); model.points.len()];
    let rays = model.adjusted.block.rays.iter().zip(&model.adjusted.rays).zip(&model.rays);
    let accepted = rays.filter(|((_, statistics), _)| statistics.verdict == ObservationVerdict::Accepted);
    accepted.for_each(|((ray, _), source)| of_points[ray.point].push(source.by_hand));
    of_points.into_iter().zip(&model.adjusted.points).filter(|(_, known)| known.is_some()).map(|(rays, _)| rays).collect()
}

/// `pairs.csv`; of an edited block it says which pairs were rejected by hand.
pub(super) fn pairs(run: &BlockRun, rows: &[PairRow]) -> String {
    let name = |image: u32| run.images.get(image as usize).map_or("", |image| &image.name);
    let rows = rows.iter().map(|pair| {
        let [a, b] = pair.images;
        let row = Row::default().number(a).number(b).text(name(a)).text(name(b)).number(word(&pair.rule));
        let (kind, matches) = match &pair.outcome {
            PairOutcome::Waiting => ("waiting", None),
            PairOutcome::Connected { matches } => ("connected", Some(matches)),
            PairOutcome::TooFewMatches { matches, .. } => ("too_few_matches", Some(matches)),
            PairOutcome::NotOriented { .. } => ("not_oriented", None),
            PairOutcome::Failed { .. } => ("failed", None),
        };
        let geometry = pair.geometry.as_ref();
        let row = row.number(kind).known(matches).known(geometry.map(|found| found.model.kind()));
        let row = row.known(geometry.and_then(|found| found.degenerate.as_ref()).map(word)).known(geometry.map(|found| found.sigma_px));
        let row = row.number(pair.common_points).number(pair.chosen_points).text(&pair.reason);
        if run.edited.is_some() { row.number(u8::from(pair.rejected_by_hand)) } else { row }
    });
    let of_edits = run.edited.iter().flat_map(|_| EDITED_PAIRS);
    table(&PAIRS.into_iter().chain(of_edits).collect::<Vec<_>>(), rows)
}

/// `surveyed.csv`: surveyed points beside their adjusted places, and those that the block has no place of.
///
/// `numbers`: those that the points have in `points.csv`. `by_hand`: names of those that were added by hand; absent of a block that was not edited.
pub(super) fn control(points: &[SurveyedPoint], numbers: &[u32], absent: &[AbsentPoint], by_hand: Option<&BTreeSet<String>>) -> String {
    let marked = |row: Row, name: &String| match by_hand {
        Some(by_hand) => row.number(u8::from(by_hand.contains(name))),
        None => row,
    };
    let rows = points.iter().enumerate().map(|(index, point)| {
        let row = Row::default().text(&point.name).number(word(&point.role)).number(point.rays);
        let row = point.position.iter().chain(&point.difference_m).fold(row, |row, value| row.number(value));
        let row = point.standard_errors_m.iter().fold(row, |row, error| row.known(*error));
        let left_out = [point.left_out.map(|left| left.difference), point.left_out.map(|left| left.standard_errors)];
        let row = left_out.iter().fold(row, |row, values| (0..3).fold(row, |row, k| row.known(values.map(|values| values[k]))));
        let row = point.detectable_m.iter().fold(row, |row, error| row.known(*error));
        let row = row.known(numbers.get(index)).number(point.state());
        marked(row, &point.name)
    });
    let without_figures = absent.iter().map(|point| {
        let row = Row::default().text(&point.name).number(use_of(point.role)).number(0).numbers(Some(point.position));
        // From dx to the last but one column.
        marked((6..CONTROL.len() - 1).fold(row, |row, _| row.number("")).number(point.absence.state()), &point.name)
    });
    let of_edits = by_hand.iter().flat_map(|_| EDITED);
    table(&CONTROL.into_iter().chain(of_edits).collect::<Vec<_>>(), rows.chain(without_figures))
}

/// What a point is for, as its table says it.
pub(super) fn use_of(role: Option<ControlRole>) -> String {
    role.map_or_else(|| "off".into(), |role| word(&role))
}

/// The name of a variant, as JSON has it.
pub(super) fn word(variant: &impl serde::Serialize) -> String {
    match serde_json::to_value(variant) {
        Ok(serde_json::Value::String(name)) => name,
        _ => String::new(),
    }
}
