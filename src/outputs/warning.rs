//! What is weak about a finished block at a glance.

use crate::camera::apart_from_known;
use crate::message::messages;
use crate::pair::least_matches;
use crate::{BlockRun, BlockWarning, Connection, Failure, NotLinked, OnOrthophoto, PairOutcome, ReconstructedModel, Remark};
use serde::Serialize;

messages! {
    /// What is weak about a block at a glance.
    #[derive(Debug, Clone, PartialEq, Serialize)]
    #[serde(tag = "kind", rename_all = "snake_case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum OverviewWarning as "overview_warning" {
        /// Of the model that is written.
        Model { block_warning: BlockWarning },
        /// Less of the block is oriented than it would need.
        FewOriented { oriented: usize, images: usize },
        /// Images in a model of their own.
        Apart { images: usize },
        NoneOriented,
        /// Two images alone are oriented, by few matches of their points: as many agree on the geometry of a repeated pattern, and no third image checks it.
        FewMatches { matches: usize, least: usize },
        /// Images are oriented, and no tie point is left that shows how.
        NoPoints,
        /// Of a camera whose focal length came out otherwise, with the orthophoto and its heights, than what was known of it: so many standard deviations of
        /// that apart.
        FocalApart { label: String, estimated_px: f64, prior_px: f64, apart: f64 },
        /// It was given an orthophoto, and is not in its system.
        NotOnOrthophoto { not_linked: NotLinked },
        /// A camera is hardly the right one, as a remark on the input says.
        DoubtfulCamera { remark: Remark },
        /// The orientation failed.
        Failed { failure: Failure },
    }
}

impl OverviewWarning {
    /// Whether it speaks against the orientation as a whole.
    pub(super) fn is_weakness(&self) -> bool {
        match self {
            Self::Model { block_warning } => block_warning.is_weakness(),
            Self::Apart { .. } => false,
            Self::FewOriented { .. }
            | Self::NotOnOrthophoto { .. }
            | Self::FewMatches { .. }
            | Self::NoPoints
            | Self::FocalApart { .. }
            | Self::DoubtfulCamera { .. }
            | Self::NoneOriented
            | Self::Failed { .. } => true,
        }
    }
}

/// Of the model that is written, and of what is not in it.
pub(super) fn overview_warnings(run: &BlockRun) -> Vec<OverviewWarning> {
    let without = match &run.orthophoto {
        Some(OnOrthophoto::NotLinked { not_linked }) if *not_linked != NotLinked::NotOriented => Some(not_linked.clone()),
        _ => None,
    };
    let without = without.map(|not_linked| OverviewWarning::NotOnOrthophoto { not_linked });
    let found: Vec<OverviewWarning> = match &run.reconstruction {
        Err(failure) => vec![OverviewWarning::Failed { failure: failure.clone() }],
        Ok(assembly) => match assembly.models.split_first() {
            Some((first, others)) => {
                let own = first.warnings.iter().cloned().map(|block_warning| OverviewWarning::Model { block_warning });
                own.chain(few_matches(run, first))
                    .chain(others.iter().map(|model| OverviewWarning::Apart { images: model.images.len() }))
                    .collect()
            }
            // A project of version 1 has oriented images, and nothing of their adjustment.
            None if run.model.images.iter().any(|image| image.pose.is_some()) => Vec::new(),
            None => vec![OverviewWarning::NoneOriented],
        },
    };
    let is_bare = run.model.points.is_empty() && run.model.images.iter().any(|image| image.pose.is_some());
    let bare = is_bare.then_some(OverviewWarning::NoPoints);
    without.into_iter().chain(bare).chain(found).chain(focals_apart(run)).collect()
}

/// Two images are judged as a pair is.
fn few_matches(run: &BlockRun, model: &ReconstructedModel) -> Option<OverviewWarning> {
    let &[one, other] = model.images.as_slice() else { return None };
    let joins = |pair: &&Connection| pair.images.map(|image| image as usize) == [one.min(other), one.max(other)];
    let PairOutcome::Connected { matches } = run.connections.iter().find(joins)?.outcome else { return None };
    let points = [run.images.get(one)?.features?, run.images.get(other)?.features?];
    let (matches, least) = (matches as usize, least_matches(points.map(|number| number as usize)));
    (matches < least).then_some(OverviewWarning::FewMatches { matches, least })
}

/// Cameras of a block on an orthophoto that contradict what was known of them: as single images placed on it do, for wrong heights, or another unit of them.
fn focals_apart(run: &BlockRun) -> Vec<OverviewWarning> {
    if !matches!(run.orthophoto, Some(OnOrthophoto::Linked { .. } | OnOrthophoto::ByHand { .. })) {
        return Vec::new();
    }
    let both = run.cameras.iter().zip(&run.model.cameras);
    let apart = both.filter_map(|(initial, camera)| {
        let (prior_px, within) = (initial.focal_px?, initial.to_be_calibrated().known_within());
        let apart = apart_from_known(camera.focal_px - prior_px, within.focal * prior_px, prior_px).filter(|_| !within.is_guess())?;
        Some(OverviewWarning::FocalApart { label: initial.label.clone(), estimated_px: camera.focal_px, prior_px, apart })
    });
    apart.collect()
}
