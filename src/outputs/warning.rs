//! What is weak about a finished block at a glance.

use crate::message::messages;
use crate::{BlockRun, BlockWarning, Failure, NotLinked, OnOrthophoto};
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
        /// It was given an orthophoto, and is not in its system.
        NotOnOrthophoto { not_linked: NotLinked },
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
            Self::FewOriented { .. } | Self::NotOnOrthophoto { .. } | Self::NoneOriented | Self::Failed { .. } => true,
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
                own.chain(others.iter().map(|model| OverviewWarning::Apart { images: model.images.len() })).collect()
            }
            // A project of version 1 has oriented images, and nothing of their adjustment.
            None if run.model.images.iter().any(|image| image.pose.is_some()) => Vec::new(),
            None => vec![OverviewWarning::NoneOriented],
        },
    };
    without.into_iter().chain(found).collect()
}
