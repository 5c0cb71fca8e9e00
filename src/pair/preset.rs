//! Ready-made settings of a pair.

use super::settings::PairSettings;
use crate::{Operator, Refinement, Strategy};
use serde::{Deserialize, Serialize};

/// Ready-made settings for tasks that the defaults serve less well.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum PairPreset {
    /// Twice as many points: about twice as many matches in twice the time.
    ManyPoints,
    /// Larger windows for least squares matching: more matches where photographs have little in common, as on long bases and at other scales.
    LittleInCommon,
    /// The paper's method with its values; gross errors are rejected all the same.
    #[serde(rename = "zahran-2007")]
    Zahran2007,
}

impl PairPreset {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::ManyPoints, Self::LittleInCommon, Self::Zahran2007];

    /// The settings.
    pub fn settings(self) -> PairSettings {
        let mut settings = PairSettings::default();
        match self {
            Self::ManyPoints => settings.multiscale.number *= 2,
            Self::LittleInCommon => settings.matching.template = 21,
            Self::Zahran2007 => {
                settings.matching.strategy = Strategy::Moments;
                settings.matching.refine = Some(Refinement::None);
                settings.matching.ambiguity = Some(Strategy::Moments.default_ambiguity());
                settings.points.operator = Some(Operator::Ground2);
                settings.points.threshold = Some(Operator::Ground2.default_threshold());
                settings.points.roundness = Some(Operator::Ground2.default_roundness());
            }
        }
        settings
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_preset_changes_settings_that_act() {
        for preset in PairPreset::ALL {
            let settings = preset.settings();
            assert_ne!(settings.resolved(), PairSettings::default().resolved(), "{preset:?}");
        }
    }

    #[test]
    fn the_papers_values_depend_on_no_default() {
        let settings = PairPreset::Zahran2007.settings();
        assert_eq!(PairSettings { points: settings.points.resolved(Operator::Ground2), ..settings.clone() }, settings.resolved());
        let (points, window, matching) = (&settings.points, &settings.window, &settings.matching);
        assert_eq!((points.threshold, points.roundness, points.suppression_window), (Some(40.0), Some(0.32), 3));
        assert_eq!((window.side, matching.search, matching.max_measure, matching.ambiguity), (11, 25, 3.0, Some(0.9)));
    }
}
