//! One way of matching the pair, and what came of it.

use super::input::{ReportEdits, ReportTruth};
use super::step::ReportStep;
use super::unknowns::{PRINTED_DIGITS, five};
use crate::html::digits_of_error;
use crate::pair::sigma0_of_all_mm;
use crate::{
    DenseTruth, Error, InterestPoint, MatchScore, NoOrientation, Operator, PairImage, PairInput, PairResult, PairSettings, Refinement,
    Strategy, judged, match_pair, orient_matches, score_matches,
};

/// A run of the pair.
#[derive(Debug, Clone)]
pub struct Study {
    pub step: ReportStep,
    pub settings: PairSettings,
    pub result: PairResult,
    /// Where the truth is known.
    pub score: Option<MatchScore>,
    /// Estimated minus true, likewise; `by` and `bz` at the scale of the estimated base.
    pub errors: Option<[f64; 5]>,
}

/// The settings of each study: those of the user first, then each strategy on the same points, with all else as the user has it.
pub fn plan(settings: &PairSettings) -> Vec<(ReportStep, PairSettings)> {
    // An operator that follows from the strategy would give each strategy its own points: where none is chosen, the paper's holds.
    let on_same_points = PairSettings { points: settings.points.resolved(Operator::Ground2), ..settings.clone() };
    let by = |strategy: Strategy| {
        let mut settings = on_same_points.clone();
        settings.matching.strategy = strategy;
        settings.matching.refine = Some(Refinement::None);
        settings
    };
    let strategies = [
        (ReportStep::Moments, Strategy::Moments),
        (ReportStep::Invariants, Strategy::Invariants),
        (ReportStep::Correlation, Strategy::Correlation),
        (ReportStep::LeastSquares, Strategy::LeastSquares),
        (ReportStep::Gradients, Strategy::Gradient),
    ];
    let others = strategies.map(|(step, strategy)| (step, by(strategy)));
    std::iter::once((ReportStep::ThisRun, settings.clone())).chain(others).collect()
}

/// Matches, orients and scores the pair; where there are edits, its edited matches.
pub fn study(
    step: ReportStep,
    settings: &PairSettings,
    images: [PairImage<'_>; 2],
    input: &PairInput,
    (truth, edits): (Option<&ReportTruth>, Option<&ReportEdits>),
) -> Result<Study, Error> {
    let [left, right] = images;
    let found = match_pair(left, right, input, settings)?;
    let result = match edits {
        Some(edits) => with_edits(found, edits, settings)?,
        None => found,
    };
    let score = truth.map(|truth| {
        let matches: Vec<[f64; 4]> =
            result.matching.matches.iter().map(|m| [m.left_px[0], m.left_px[1], m.right_px[0], m.right_px[1]]).collect();
        let points: Vec<[f64; 2]> = result.left.points.iter().map(|p| [p.x, p.y]).collect();
        let truth = DenseTruth {
            right_position: &truth.right_position,
            left_width: left.grey.width(),
            left_height: left.grey.height(),
            right_width: right.grey.width(),
            right_height: right.grey.height(),
        };
        score_matches(&matches, &points, &truth)
    });
    let errors = truth.zip(result.orientation.as_ref().ok()).map(|(truth, orientation)| {
        let (found, known) = (five(&orientation.parameters), five(&truth.orientation_at(orientation.base_mm)));
        std::array::from_fn(|k| found[k] - known[k])
    });
    Ok(Study { step, settings: settings.clone(), result, score: score.transpose()?, errors })
}

/// The pair with its edited matches, and the orientation of these. Why images have none whatever their matches are stays as it is.
fn with_edits(found: PairResult, edits: &ReportEdits, settings: &PairSettings) -> Result<PairResult, Error> {
    let mut result = found;
    result.left.points.extend(edits.added_px.iter().map(|[x, y]| InterestPoint { x: *x, y: *y, value: 0.0 }));
    result.matching.matches.clone_from(&edits.matches);
    result.matching.counts.matches = edits.matches.len();
    let interior = match (&result.orientation, &result.interior) {
        (Ok(_) | Err(NoOrientation::Refused { .. } | NoOrientation::TooFewMatches { .. }), Some(interior)) => interior,
        _ => return Ok(result),
    };
    let points = [result.left.points.len(), result.right.points.len()];
    if let Some(few) = NoOrientation::of_few(edits.matches.len()) {
        return Ok(PairResult { orientation: Err(few), ..result });
    }
    let orientation = match orient_matches(&edits.matches, interior, &settings.resolved().orientation) {
        Err(error) if error.is_usage() => return Err(error),
        Ok(oriented) => Ok(judged(oriented, &edits.matches, interior, Some(points))),
        Err(error) => Err(NoOrientation::Refused { error }),
    };
    Ok(PairResult { orientation, ..result })
}

impl Study {
    /// σ₀ in px of the left image.
    pub fn sigma0_px(&self) -> Option<f64> {
        let pixel = self.result.interior.as_ref()?.left.pixel_mm();
        self.result.orientation.as_ref().ok()?.sigma0_mm.map(|sigma| sigma / pixel)
    }

    /// σ₀ in px of the left image of all matches, without rejection of gross errors and robust weights. `None` where cameras were estimated
    /// together with the orientation: as given they would be taken for errors of the matches.
    pub fn sigma0_of_all_px(&self) -> Option<f64> {
        let interior = self.result.interior.as_ref()?;
        let found = self.result.orientation.as_ref().ok().filter(|found| found.cameras.is_none())?;
        let sigma0_mm = sigma0_of_all_mm(&self.result.matching.matches, interior, found.turn_deg, &self.settings.orientation)?;
        Some(sigma0_mm / interior.left.pixel_mm())
    }

    /// Digits after the point of an unknown, of its errors and of its interval: those of its standard error.
    pub fn digits(&self, unknown: usize) -> usize {
        let errors = self.result.orientation.as_ref().ok().and_then(|o| o.standard_errors);
        digits_of_error(errors.map(|errors| five(&errors)[unknown]), PRINTED_DIGITS)
    }

    /// Matches that the adjustment used; `None` where there was none.
    pub fn used(&self) -> Option<usize> {
        let rejected = self.result.orientation.as_ref().ok()?.rejected.len();
        Some(self.result.matching.matches.len() - rejected)
    }

    /// The standard errors that a result of the paper's σ₀ and number of matches would have in this geometry: the cofactors depend on where
    /// the points lie, the standard errors on σ₀ and, by its root, on how many there are.
    pub fn standard_errors_at(&self, sigma0_mm: f64, matches: usize) -> Option<[f64; 5]> {
        let orientation = self.result.orientation.as_ref().ok()?;
        let scale = sigma0_mm * (self.used()? as f64 / matches as f64).sqrt();
        Some(std::array::from_fn(|k| {
            let error = scale * orientation.cofactors[k][k].max(0.0).sqrt();
            if k < 3 { error.to_degrees() } else { error }
        }))
    }
}
