//! How the photos of a pair lie to each other in their planes: by what a strategy that compares windows as they stand is helped or not.

use super::one_map::{length, similarity_of};
use super::rounds::match_in_rounds;
use super::settings::PairSettings;
use super::{DescribedImage, describe_image};
use crate::math::median;
use crate::{Error, GreyView, OffsetField, Refinement, reduce_to};
use serde::{Deserialize, Serialize};

/// Longer side of the images that are compared: all that is asked for is known from them, within a second.
const FINEST: usize = 1024;
/// Fewer matches may agree by chance.
const LEAST_MATCHES: usize = 30;

/// The similarity that takes positions of the left image to those of the right one.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct PhotoDifference {
    /// By how much the right photo is turned in its plane, as κ is.
    pub turn_deg: f64,
    /// How many px of the right image one of the left image has.
    pub scale: f64,
    /// Right minus left position in px, in the middle of what both show.
    pub offset_px: [f64; 2],
    /// That middle in the left image.
    pub middle_px: [f64; 2],
}

impl PhotoDifference {
    /// Of two images, by gradients of many scales, which find their likes however they are turned; `None` where the photos do not match.
    ///
    /// # Errors
    /// As [`match_images`](crate::match_images).
    pub fn between(left: GreyView<'_>, right: GreyView<'_>) -> Result<Option<Self>, Error> {
        let mut settings = PairSettings::default().resolved();
        settings.matching.refine = Some(Refinement::None);
        let reduced = [reduce_to(left, FINEST), reduce_to(right, FINEST)];
        let describe = |side: usize| describe_image(reduced[side].image.view(), None, &settings);
        let described: [DescribedImage; 2] = [describe(0)?, describe(1)?];
        let images = [0, 1].map(|side| described[side].match_image(reduced[side].image.view(), settings.matching.strategy));
        let nowhere = OffsetField::constant(0.0, 0.0);
        let found = match_in_rounds(images, &nowhere, None, &settings)?.set.matches;
        if found.len() < LEAST_MATCHES {
            return Ok(None);
        }
        let [of_left, of_right] = [0, 1].map(|side| f64::from(1u32 << reduced[side].halvings));
        let place = |m: &crate::Match| [of_left * m.left_px[0], of_left * m.left_px[1], of_right * m.right_px[0], of_right * m.right_px[1]];
        Ok(Self::of(&found.iter().map(place).collect::<Vec<_>>()))
    }

    /// Of matches `[x left, y left, x right, y right]`, px; `None` where they lie on a line.
    fn of(matches: &[[f64; 4]]) -> Option<Self> {
        let similarity = similarity_of(matches)?;
        let middle = |of: fn(&[f64; 4]) -> f64| median(&mut matches.iter().map(of).collect::<Vec<_>>());
        Some(Self {
            turn_deg: libm::atan2(similarity[1], similarity[0]).to_degrees(),
            scale: length(similarity),
            offset_px: [middle(|m| m[2] - m[0])?, middle(|m| m[3] - m[1])?],
            middle_px: [middle(|m| m[0])?, middle(|m| m[1])?],
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_turn_and_a_scale_are_those_of_kappa_and_of_larger_pictures() {
        // Content that moved clockwise on the screen, by a camera that was turned anticlockwise.
        let (sin, cos) = (libm::sin(0.5), libm::cos(0.5));
        let at = |k: usize| [(37 * k % 100) as f64, (61 * k % 90) as f64];
        let matches: Vec<[f64; 4]> = (0..60)
            .map(|k| {
                let [x, y] = at(k);
                [x, y, 2.0 * (cos * x - sin * y) + 300.0, 2.0 * (sin * x + cos * y) - 40.0]
            })
            .collect();
        let found = PhotoDifference::of(&matches).unwrap();
        assert!((found.turn_deg.to_radians() - 0.5).abs() < 1e-9 && (found.scale - 2.0).abs() < 1e-9, "{found:?}");
        let moved: Vec<[f64; 4]> = (0..60).map(|k| [at(k)[0], at(k)[1], at(k)[0] - 120.0, at(k)[1] + 7.0]).collect();
        assert_eq!(PhotoDifference::of(&moved).unwrap().offset_px, [-120.0, 7.0]);
    }
}
