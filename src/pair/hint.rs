//! What else would do, where a pair is not oriented.

use super::no_orientation::NoOrientation;
use super::settings::PairSettings;
use super::verdict::PairVerdict;
use crate::message::messages;
use crate::{Error, Strategy, Warning};
use serde::{Deserialize, Serialize};

messages! {
    /// What would do where the strategy of a pair did not.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum PairHint as "pair_hint" {
        /// Windows of grey values were compared, as they stand in both photos: photos may be turned, of another scale or of another offset.
        OtherStrategy,
    }
}

impl PairHint {
    /// The hint for a verdict on a pair of these settings; `None` where the pair is oriented, or nothing else is known to do better.
    pub fn of(verdict: &PairVerdict, settings: &PairSettings) -> Option<Self> {
        let is_helpless = match verdict {
            PairVerdict::Oriented { .. } => true,
            // What was known before is known by any strategy.
            PairVerdict::Weak { warning, .. } => *warning == Warning::SimilarityAlone || warning.is_of_part(),
            PairVerdict::NotOriented { no_orientation } => is_by_any_strategy(no_orientation),
        };
        let compares_windows = settings.resolved().matching.strategy != Strategy::Gradient;
        (compares_windows && !is_helpless).then_some(Self::OtherStrategy)
    }
}

/// Whether what is missing is missing by any strategy.
fn is_by_any_strategy(no_orientation: &NoOrientation) -> bool {
    matches!(
        no_orientation,
        NoOrientation::NoFocalLength
            | NoOrientation::NoPixelSize { .. }
            | NoOrientation::Altered { .. }
            | NoOrientation::ContradictedFocal { .. }
            | NoOrientation::FarPrincipalPoint { .. }
            | NoOrientation::Panorama { .. }
            | NoOrientation::OnePhoto
            | NoOrientation::PartsOfOneImage
            | NoOrientation::Refused { error: Error::InvalidOption { .. } }
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{KnownWorst, Side};

    #[test]
    fn only_what_another_strategy_may_mend_is_hinted_at() {
        let with = |strategy: Strategy| {
            let mut settings = PairSettings::default();
            settings.matching.strategy = strategy;
            settings
        };
        let not_oriented = |no_orientation| PairVerdict::NotOriented { no_orientation };
        let weak = PairVerdict::Weak { points: 40, warning: Warning::Mirrored };
        let oriented = PairVerdict::Oriented {
            points: 400,
            sigma0_px: 0.2,
            kappa_deg: 1.0,
            half_width_deg: 0.1,
            worst: KnownWorst::Kappa,
            worst_half_width_deg: 0.1,
        };
        let moments = with(Strategy::Moments);
        for verdict in [weak.clone(), not_oriented(NoOrientation::PureRotation), not_oriented(NoOrientation::NoCamera { side: Side::Left })]
        {
            assert_eq!(PairHint::of(&verdict, &moments), Some(PairHint::OtherStrategy), "{verdict:?}");
            assert_eq!(PairHint::of(&verdict, &with(Strategy::Auto)), None, "{verdict:?}");
            assert_eq!(PairHint::of(&verdict, &with(Strategy::Gradient)), None, "{verdict:?}");
        }
        assert_eq!(PairHint::of(&oriented, &moments), None);
        let error = crate::catalogue::refuse("orientation.base_mm", 0.0, crate::Allowed::AboveUpTo { above: 0.0, max: 1e6 });
        let of_an_option = NoOrientation::Refused { error };
        for helpless in [NoOrientation::NoFocalLength, NoOrientation::OnePhoto, NoOrientation::PartsOfOneImage, of_an_option] {
            assert_eq!(PairHint::of(&not_oriented(helpless), &moments), None);
        }
        let other_pixels = Warning::OtherPixels { side: Side::Left, pixel_um: 2.0, expected_um: 4.0 };
        for warning in [Warning::SimilarityAlone, other_pixels] {
            assert_eq!(PairHint::of(&PairVerdict::Weak { points: 400, warning }, &moments), None);
        }
    }
}
