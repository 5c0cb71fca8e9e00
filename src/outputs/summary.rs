//! The figures of a finished block, as `summary.json` holds them and the command prints them.

use super::coverage::coverage;
use super::in_system::{InSystem, ResultSystem};
use super::orientation_summary::{OrientationSummary, orientation};
use super::pairs::PairRow;
use super::verdict::BlockVerdict;
use super::with_text::WithText;
use crate::{
    BlockRun, BlockScore, BlockSettings, ExportFormat, Failure, InitialCamera, JoinCounts, OnOrthophoto, PairOutcome, RefinementMethod,
    RefinementOutcome, RefinementTable, Remark, SkippedImage,
};
use serde::Serialize;
use std::collections::BTreeMap;

/// The figures of a finished block.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Summary {
    pub verdict: WithText<BlockVerdict>,
    pub images: ImageCounts,
    /// What of the input was not taken as it was given, or is hardly right.
    pub remarks: Vec<WithText<Remark>>,
    pub cameras: Vec<CameraSummary>,
    pub pairs: PairCounts,
    /// The names of the images that are connected with each other, the largest group first.
    pub groups: Vec<Vec<String>>,
    /// Absent where an older project file does not say.
    pub points: Option<TiePointCounts>,
    pub selection: SelectionCounts,
    /// Absent where observations are not refined.
    pub refinement: Option<RefinementCounts>,
    pub orientation: OrientationSummary,
    /// The coordinate reference system of images.csv, points.csv and surveyed.csv; absent where it is that of the adjustment.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub crs: Option<ResultSystem>,
    /// What came of the orthophoto that the block was given; absent where it was given none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub orthophoto: Option<WithText<OnOrthophoto>>,
    /// Changes by hand.
    pub edits: usize,
    pub exports: Vec<ExportOutcome>,
    pub settings: BlockSettings,
    /// How near a simulated block is to its truth.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub score: Option<BlockScore>,
}

/// Images that were read and those that were not.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ImageCounts {
    pub read: usize,
    pub left_out: Vec<NamedReason>,
    pub masked: usize,
    /// Masks that belong to no image.
    pub stray_masks: Vec<String>,
    /// Images that image measurements name and that are not in the block.
    pub stray_marks: Vec<String>,
    /// Absent where an older project file does not say.
    pub features: Option<u64>,
}

/// An image by its name, and why it is not in the block.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct NamedReason {
    pub name: String,
    pub reason: WithText<Failure>,
}

impl NamedReason {
    pub(super) fn of(image: &SkippedImage) -> Self {
        Self { name: image.name.clone(), reason: WithText::of(image.reason.clone()) }
    }
}

/// A camera before its calibration.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct CameraSummary {
    #[serde(flatten)]
    pub camera: InitialCamera,
    pub images: usize,
}

/// Pairs by their outcomes.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct PairCounts {
    pub tried: usize,
    pub connected: usize,
    pub too_few_matches: usize,
    pub not_oriented: usize,
    pub failed: usize,
    /// Verified matches of all connected pairs.
    pub matches: u64,
}

/// Tie points before some are chosen.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct TiePointCounts {
    pub found: usize,
    pub rays: usize,
    /// How many points have so many rays.
    pub with_rays: BTreeMap<usize, u32>,
    pub joining: JoinCounts,
}

/// The model that is written.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct SelectionCounts {
    pub points: usize,
    pub rays: usize,
    /// Of the oriented images, or of all where none is.
    pub least_rays_of_an_image: usize,
    pub least_places_of_an_image: usize,
}

/// What became of the observations that were refined.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct RefinementCounts {
    pub method: RefinementMethod,
    pub points: usize,
    pub rays: usize,
    pub references: usize,
    pub refined: usize,
    /// Those that keep their positions, by the reason.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "Record<Exclude<RefinementOutcome, \"reference\" | \"refined\">, number>"))]
    pub kept: BTreeMap<RefinementOutcome, usize>,
}

/// A format that was asked for.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ExportOutcome {
    pub format: ExportFormat,
    /// Why the block cannot be written so; absent where it was.
    pub refused: Option<String>,
}

pub(super) fn summary(
    run: &BlockRun,
    pairs: &[PairRow],
    groups: &[Vec<u32>],
    exports: &[ExportOutcome],
    score: Option<BlockScore>,
) -> Summary {
    let name = |image: usize| run.images.get(image).map_or(String::new(), |image| image.name.clone());
    let shown = InSystem::of(run);
    Summary {
        verdict: WithText::of(BlockVerdict::of(run)),
        images: image_counts(run),
        remarks: shown.remarks().into_iter().map(WithText::of).collect(),
        cameras: cameras(run),
        pairs: pair_counts(pairs),
        groups: groups.iter().map(|group| group.iter().map(|image| name(*image as usize)).collect()).collect(),
        points: run.points.as_ref().map(|points| TiePointCounts {
            found: points.count,
            rays: points.rays,
            with_rays: (0..).zip(points.histogram.iter().copied()).filter(|(_, points)| *points > 0).collect(),
            joining: points.join,
        }),
        selection: selection(run),
        refinement: run.refinement.as_ref().map(|refinement| refinement_counts(refinement, run.input.settings.refinement.method)),
        orientation: orientation(run, &shown, name),
        crs: shown.system(),
        orthophoto: run.orthophoto.clone().map(WithText::of),
        edits: run.edits().len(),
        exports: exports.to_vec(),
        settings: run.input.settings.clone(),
        score,
    }
}

fn image_counts(run: &BlockRun) -> ImageCounts {
    ImageCounts {
        read: run.images.len(),
        left_out: run.skipped.iter().map(NamedReason::of).collect(),
        masked: run.images.iter().filter(|image| image.masked).count(),
        stray_masks: run.unused_masks.clone(),
        stray_marks: run.unknown_images.clone(),
        features: run.images.iter().map(|image| image.features.map(u64::from)).sum(),
    }
}

fn cameras(run: &BlockRun) -> Vec<CameraSummary> {
    let images = |index: usize| run.images.iter().filter(|image| image.camera == index).count();
    run.cameras.iter().enumerate().map(|(index, camera)| CameraSummary { camera: camera.clone(), images: images(index) }).collect()
}

fn pair_counts(pairs: &[PairRow]) -> PairCounts {
    let mut counts = PairCounts { tried: pairs.len(), ..PairCounts::default() };
    for pair in pairs {
        match pair.outcome {
            PairOutcome::Waiting => {}
            PairOutcome::Connected { matches } => {
                counts.connected += 1;
                counts.matches += u64::from(matches);
            }
            PairOutcome::TooFewMatches { .. } => counts.too_few_matches += 1,
            PairOutcome::NotOriented { .. } => counts.not_oriented += 1,
            PairOutcome::Failed { .. } => counts.failed += 1,
        }
    }
    counts
}

fn selection(run: &BlockRun) -> SelectionCounts {
    let covered = coverage(&run.model);
    let is_oriented = run.model.images.iter().any(|image| image.pose.is_some());
    // Images that are not oriented have no observations in a model that has others.
    let counted =
        || run.model.images.iter().zip(&covered).filter(|(image, _)| image.pose.is_some() || !is_oriented).map(|(_, covered)| covered);
    SelectionCounts {
        points: run.model.points.len(),
        rays: covered.iter().map(|image| image.observations).sum(),
        least_rays_of_an_image: counted().map(|image| image.observations).min().unwrap_or(0),
        least_places_of_an_image: counted().map(|image| image.positions).min().unwrap_or(0),
    }
}

/// How many observations had each outcome; 0 where none had.
pub(super) fn outcome_counts(refinement: &RefinementTable) -> BTreeMap<RefinementOutcome, usize> {
    let mut counts: BTreeMap<RefinementOutcome, usize> = RefinementOutcome::ALL.iter().map(|outcome| (*outcome, 0)).collect();
    refinement.observations.iter().for_each(|observation| *counts.entry(observation.outcome).or_default() += 1);
    counts
}

fn refinement_counts(refinement: &RefinementTable, method: RefinementMethod) -> RefinementCounts {
    let mut kept = outcome_counts(refinement);
    let mut taken = |outcome| kept.remove(&outcome).unwrap_or(0);
    let (references, refined) = (taken(RefinementOutcome::Reference), taken(RefinementOutcome::Refined));
    RefinementCounts {
        method,
        points: refinement.starts.len().saturating_sub(1),
        rays: refinement.observations.len(),
        references,
        refined,
        kept,
    }
}
