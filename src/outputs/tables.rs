//! The tables of a finished block: images, tie points, observations, pairs.

use super::images::ImageRow;
use super::pairs::PairRow;
use super::refined::refined_observations;
use crate::formats::{images_table, rays_table};
use crate::text::{Row, table};
use crate::{BlockRun, PairOutcome, RefinedObservation, SurveyedPoint};

const OF_IMAGES: [&str; 8] =
    ["model", "features", "rays", "places", "exif_orientation", "recorded_longitude_deg", "recorded_latitude_deg", "recorded_height_m"];
const OF_RAYS: [&str; 3] = ["refinement", "standard_error_px", "correlation"];
const CONTROL: [&str; 12] = ["name", "use", "rays", "x", "y", "z", "dx", "dy", "dz", "sigma_dx", "sigma_dy", "sigma_dz"];
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

/// `images.csv`; models count from 1, as texts number them.
pub(super) fn images(run: &BlockRun, rows: &[ImageRow]) -> String {
    images_table(&run.model, &OF_IMAGES, |index, row| {
        let image = &rows[index];
        let row = row.known(image.model.map(|model| model + 1)).known(image.features).number(image.observations).number(image.positions);
        let row = row.known(image.exif_orientation);
        let position = image.gnss.as_ref();
        row.known(position.map(|p| p.longitude_deg)).known(position.map(|p| p.latitude_deg)).known(position.and_then(|p| p.height_m))
    })
}

/// `rays.csv`.
pub(super) fn rays(run: &BlockRun) -> String {
    let Some(refinement) = &run.refinement else { return rays_table(&run.model, &[], |_, _, row| row) };
    let refined = refined_observations(&run.model, refinement);
    rays_table(&run.model, &OF_RAYS, |point, index, row| match refined[point][index] {
        Some(RefinedObservation { outcome, standard_error_px, correlation, .. }) => {
            let [error, correlation] = [standard_error_px, correlation].map(|value| value.map(f64::from));
            row.number(word(outcome)).known(error).known(correlation)
        }
        None => row.number("").number("").number(""),
    })
}

/// `pairs.csv`.
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
        row.number(pair.common_points).number(pair.chosen_points).text(&pair.reason)
    });
    table(&PAIRS, rows)
}

/// `surveyed.csv`: surveyed points beside their adjusted places.
pub(super) fn control(points: &[SurveyedPoint]) -> String {
    let rows = points.iter().map(|point| {
        let row = Row::default().text(&point.name).number(word(&point.role)).number(point.rays);
        let row = point.position.iter().chain(&point.difference_m).fold(row, |row, value| row.number(value));
        point.standard_errors_m.iter().fold(row, |row, error| row.known(*error))
    });
    table(&CONTROL, rows)
}

/// The name of a variant, as JSON has it.
pub(super) fn word(variant: &impl serde::Serialize) -> String {
    match serde_json::to_value(variant) {
        Ok(serde_json::Value::String(name)) => name,
        _ => String::new(),
    }
}
