//! What a finished block is worth, in one sentence with the figures that decided.

use super::warning::{OverviewWarning, overview_warnings};
use crate::message::messages;
use crate::{BlockRun, Failure, PairOutcome, UnorientedReason};
use serde::Serialize;

/// A block of which less is oriented than this share of its images is weak.
const LEAST_SHARE: f64 = 0.8;

messages! {
    /// What a finished block is worth.
    #[derive(Debug, Clone, PartialEq, Serialize)]
    #[serde(tag = "kind", rename_all = "snake_case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum BlockVerdict as "block_verdict" {
        /// Nothing speaks against the orientation. `oriented` of `images`; `sigma0_px`: absent where an older project file does not say.
        Oriented { oriented: usize, images: usize, points: usize, sigma0_px: Option<f64> },
        /// There is an orientation, which may be wrong or too poor to be used, for this reason.
        Weak { oriented: usize, images: usize, points: usize, overview_warning: OverviewWarning },
        /// `connected`: pairs of images; `failure`: what ended the orientation, where something did.
        NotOriented { connected: usize, failure: Option<Failure> },
    }
}

impl BlockVerdict {
    /// The verdict on a finished block: on the model that is written.
    pub fn of(run: &BlockRun) -> Self {
        let (images, points) = (run.images.len(), run.model.points.len());
        let oriented = run.model.images.iter().filter(|image| image.pose.is_some()).count();
        if oriented == 0 {
            let connected = run.connections.iter().filter(|pair| matches!(pair.outcome, PairOutcome::Connected { .. })).count();
            return Self::NotOriented { connected, failure: run.reconstruction.as_ref().err().cloned() };
        }
        // Images that the user took out are none that could not be oriented.
        let unoriented = run.reconstruction.iter().flat_map(|assembly| &assembly.unoriented);
        let taken_out = unoriented.filter(|image| image.reason == UnorientedReason::RejectedByHand).count();
        let few =
            ((oriented as f64) < LEAST_SHARE * (images - taken_out) as f64).then_some(OverviewWarning::FewOriented { oriented, images });
        // What follows from a wrong camera is explained by it.
        let doubted = run.remarks.iter().find(|remark| remark.is_doubt_of_camera());
        let doubted = doubted.map(|remark| OverviewWarning::DoubtfulCamera { remark: remark.clone() });
        let weakness = doubted.or_else(|| overview_warnings(run).into_iter().find(OverviewWarning::is_weakness)).or(few);
        match weakness {
            Some(overview_warning) => Self::Weak { oriented, images, points, overview_warning },
            None => {
                let model = run.reconstruction.as_ref().ok().and_then(|assembly| assembly.models.first());
                Self::Oriented { oriented, images, points, sigma0_px: model.and_then(|model| model.adjusted.sigma0_px) }
            }
        }
    }
}
