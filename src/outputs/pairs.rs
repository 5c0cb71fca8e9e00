//! What is known of each pair of a finished block.

use crate::editing::rejected_pairs;
use crate::tracks::{FeatureObservation, TiePoints, shared_points};
use crate::{BlockModel, BlockRun, ConnectionGraph, Error, PairOutcome, PairRule, TwoView};
use serde::Serialize;
use std::collections::BTreeMap;

/// A pair that was chosen.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct PairRow {
    /// In ascending order.
    pub images: [u32; 2],
    pub rule: PairRule,
    pub outcome: PairOutcome,
    /// Why the images are connected or are not, in words.
    pub reason: String,
    /// Absent where nothing relates the views.
    pub geometry: Option<TwoView>,
    /// Tie points that both images see.
    pub common_points: u32,
    /// Those of the model that is written.
    pub chosen_points: u32,
    pub rejected_by_hand: bool,
}

/// One row for each pair, and the groups of connected images, the largest first.
///
/// # Errors
/// [`Error::InvalidInput`] for pairs of images that do not exist.
pub(super) fn pair_rows(run: &BlockRun) -> Result<(Vec<PairRow>, Vec<Vec<u32>>), Error> {
    let mut graph = ConnectionGraph::new(run.images.len() as u32);
    for connection in &run.connections {
        graph.set(connection.images, connection.rule, connection.outcome.clone())?;
    }
    let chosen = chosen_points(&run.model);
    let found: Option<BTreeMap<[u32; 2], u32>> =
        run.points.as_ref().map(|points| points.shared.iter().map(|shared| (shared.images, shared.points)).collect());
    let common = found.as_ref().unwrap_or(&chosen);
    let count = |counts: &BTreeMap<[u32; 2], u32>, images| counts.get(&images).copied().unwrap_or(0);
    let rejected = rejected_pairs(run.edits());
    let rows = run.connections.iter().zip(&run.geometries).map(|(connection, geometry)| PairRow {
        images: connection.images,
        rule: connection.rule,
        outcome: connection.outcome.clone(),
        reason: connection.to_string(),
        geometry: geometry.clone(),
        common_points: count(common, connection.images),
        chosen_points: count(&chosen, connection.images),
        rejected_by_hand: rejected.contains(&connection.images.map(|image| image as usize)),
    });
    Ok((rows.collect(), graph.groups()))
}

/// The points of a model that both images of a pair see.
fn chosen_points(model: &BlockModel) -> BTreeMap<[u32; 2], u32> {
    let mut points = TiePoints::default();
    for point in &model.points {
        points.push(point.rays.iter().map(|ray| FeatureObservation { image: ray.image as u32, feature: 0, confidence: 1.0 }), 1.0);
    }
    shared_points(&points, model.images.len()).into_iter().map(|shared| (shared.images, shared.points)).collect()
}
