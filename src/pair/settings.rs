//! The options of all stages of a pair.

use crate::{
    GradientOptions, Group, MatchOptions, MultiscaleOptions, Operator, OrientationOptions, Parameter, PartlyGiven, PointOptions, Strategy,
    TwoViewOptions, WindowOptions,
};
use serde::{Deserialize, Serialize};

/// The options of all stages.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct PairSettings {
    pub points: PointOptions,
    /// Of the operator of that name.
    pub multiscale: MultiscaleOptions,
    pub window: WindowOptions,
    /// Of the strategy of that name.
    pub gradient: GradientOptions,
    pub matching: MatchOptions,
    /// The geometry of the two views, by which the strategy gradient verifies its matches. Cameras that the pair knows take the place of
    /// those named here.
    pub geometry: TwoViewOptions,
    pub orientation: OrientationOptions,
}

impl PartlyGiven for PairSettings {
    const GROUPS: &'static [Group] = &[
        Group { path: "points", parameters: PointOptions::PARAMETERS },
        Group { path: "multiscale", parameters: MultiscaleOptions::PARAMETERS },
        Group { path: "window", parameters: WindowOptions::PARAMETERS },
        Group { path: "gradient", parameters: GradientOptions::PARAMETERS },
        Group { path: "matching", parameters: MatchOptions::PARAMETERS },
        Group { path: "geometry", parameters: TwoViewOptions::PARAMETERS },
        Group { path: "orientation", parameters: OrientationOptions::PARAMETERS },
    ];
}

impl PairSettings {
    /// All parameters, in the order of the pipeline.
    pub fn parameters() -> impl Iterator<Item = &'static Parameter> {
        Self::GROUPS.iter().flat_map(|group| group.parameters)
    }

    /// The settings with every option that follows from the others: the strategy that is to be chosen and its refinement, the operator of the
    /// strategy, its roundness and window, the ambiguity ratio. What follows from the images stays absent. Everything that takes settings
    /// resolves them so.
    pub fn resolved(&self) -> Self {
        let strategy = self.matching.strategy.resolved();
        let points = self.points.resolved(if strategy == Strategy::Gradient { Operator::Multiscale } else { Operator::Ground2 });
        let (refine, ambiguity) = (Some(self.matching.refine()), Some(self.matching.ambiguity()));
        let matching = MatchOptions { strategy, refine, ambiguity, ..self.matching.clone() };
        Self { points, matching, ..self.clone() }
    }
}
