//! What else would do, where a pair is not oriented.

use super::difference::PhotoDifference;
use super::no_orientation::NoOrientation;
use super::settings::PairSettings;
use super::verdict::PairVerdict;
use crate::message::messages;
use crate::{Error, OffsetField, Strategy, Warning};
use serde::{Deserialize, Serialize};

/// What the strategies that compare windows as they stand take, and the estimate of the offset before them. On simulated pairs all four had as many right
/// matches at turns up to 10° (0.77 to 1.00 of them, upright 0.90 to 0.99) and at scales up to 1.15, and next to none right at 13° and at 1.2 or 0.8.
const MOST_TURN_DEG: f64 = 10.0;
const MOST_SCALE: f64 = 1.15;

messages! {
    /// What would do where the strategy of a pair did not: it compares windows of grey values as they stand in both photos.
    #[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum PairHint as "pair_hint" {
        /// Photos may be turned, of another scale or of another offset.
        OtherStrategy,
        /// The camera is missing, which the strategy that follows geometry finds by the matches.
        UnknownCamera,
        /// The right photo is turned in its plane, as κ is, by more than the strategy takes.
        Turned { turn_deg: f64, most_deg: f64, scale: f64 },
        /// The right photo is of another scale, so many times as large, than the strategy takes.
        Scaled { scale: f64, most: f64, turn_deg: f64 },
        /// Both.
        TurnedAndScaled { turn_deg: f64, most_deg: f64, scale: f64, most: f64 },
        /// What both show lies elsewhere than it was looked for: right minus left position in the middle of it, the one that was expected there, and
        /// how far about that matches were looked for.
        Displaced { dx_px: f64, dy_px: f64, expected_dx_px: f64, expected_dy_px: f64, most_px: f64, turn_deg: f64, scale: f64 },
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
        let lacks_camera = matches!(verdict, PairVerdict::NotOriented { no_orientation: NoOrientation::NoCamera { .. } });
        let compares_windows = settings.resolved().matching.strategy != Strategy::Gradient;
        (compares_windows && !is_helpless).then_some(if lacks_camera { Self::UnknownCamera } else { Self::OtherStrategy })
    }

    /// The hint with the figures of what these photos ask of the strategy that it does not take; itself where they ask for nothing. `expected`:
    /// where matches were looked for.
    #[must_use]
    pub fn with(self, difference: &PhotoDifference, expected: Option<&OffsetField>, settings: &PairSettings) -> Self {
        let PhotoDifference { turn_deg, scale, offset_px: [dx_px, dy_px], middle_px: [x_px, y_px] } = *difference;
        let (most_deg, most) = (MOST_TURN_DEG, MOST_SCALE);
        let is_turned = turn_deg.abs() > most_deg;
        let is_scaled = scale > most || scale < 1.0 / most;
        match (is_turned, is_scaled) {
            (true, true) => return Self::TurnedAndScaled { turn_deg, most_deg, scale, most },
            (true, false) => return Self::Turned { turn_deg, most_deg, scale },
            (false, true) => return Self::Scaled { scale, most, turn_deg },
            (false, false) => (),
        }
        let Some([expected_dx_px, expected_dy_px]) = expected.map(|expected| expected.at(x_px, y_px)) else { return self };
        let most_px = 0.5 * settings.matching.search as f64;
        let is_near = (dx_px - expected_dx_px).abs() <= most_px && (dy_px - expected_dy_px).abs() <= most_px;
        if is_near { self } else { Self::Displaced { dx_px, dy_px, expected_dx_px, expected_dy_px, most_px, turn_deg, scale } }
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

    fn with(strategy: Strategy) -> PairSettings {
        let mut settings = PairSettings::default();
        settings.matching.strategy = strategy;
        settings
    }

    #[test]
    fn only_what_another_strategy_may_mend_is_hinted_at() {
        let not_oriented = |no_orientation| PairVerdict::NotOriented { no_orientation };
        let weak = PairVerdict::Weak { points: 40, warning: Warning::Mirrored };
        let oriented = PairVerdict::Oriented {
            points: 400,
            sigma0_px: Some(0.2),
            sigma0_um: None,
            kappa_deg: 1.0,
            half_width_deg: 0.1,
            axes_deg: None,
            worst: KnownWorst::Kappa,
            worst_half_width_deg: 0.1,
        };
        let moments = with(Strategy::Moments);
        let few = NoOrientation::TooFewMatches { matches: 0, needed: 5 };
        let no_camera = NoOrientation::NoCamera { side: Side::Left };
        let with_camera = [weak.clone(), not_oriented(NoOrientation::PureRotation), not_oriented(few)];
        let hinted = with_camera.map(|verdict| (verdict, PairHint::OtherStrategy));
        for (verdict, hint) in hinted.into_iter().chain([(not_oriented(no_camera), PairHint::UnknownCamera)]) {
            assert_eq!(PairHint::of(&verdict, &moments), Some(hint), "{verdict:?}");
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

    #[test]
    fn the_hint_says_which_of_turn_scale_and_offset_is_beyond_the_strategy() {
        let moments = with(Strategy::Moments);
        let difference = |turn_deg, scale, dx_px| PhotoDifference { turn_deg, scale, offset_px: [dx_px, 3.0], middle_px: [200.0, 300.0] };
        let expected = OffsetField::constant(-100.0, 0.0);
        let hint = |difference: PhotoDifference| PairHint::OtherStrategy.with(&difference, Some(&expected), &moments);
        assert_eq!(hint(difference(2.0, 1.02, -105.0)), PairHint::OtherStrategy);
        assert!(matches!(hint(difference(-90.0, 1.02, 400.0)), PairHint::Turned { turn_deg: -90.0, .. }));
        for scale in [0.5, 2.0] {
            assert!(matches!(hint(difference(2.0, scale, 400.0)), PairHint::Scaled { scale: told, .. } if told == scale));
        }
        assert!(matches!(hint(difference(180.0, 0.5, -100.0)), PairHint::TurnedAndScaled { .. }));
        let displaced = PairHint::Displaced {
            dx_px: 400.0,
            dy_px: 3.0,
            expected_dx_px: -100.0,
            expected_dy_px: 0.0,
            most_px: 12.5,
            turn_deg: 2.0,
            scale: 1.02,
        };
        assert_eq!(hint(difference(2.0, 1.02, 400.0)), displaced);
        for hint in [PairHint::OtherStrategy, PairHint::UnknownCamera] {
            assert_eq!(hint.with(&difference(2.0, 1.02, 400.0), None, &moments), hint);
        }
    }
}
