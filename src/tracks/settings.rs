//! What the user chooses of a whole block: its features, its pairs, its matches, its points.

use super::{
    BlockOptions, ChosenPair, GeoreferencingOptions, PairRule, RefinementMethod, RefinementOptions, SelectOptions, alike_pairs, all_pairs,
    merge_pairs, near_pairs, sequence_pairs,
};
use crate::catalogue::options;
use crate::{Error, FeatureOptions, GradientOptions, Group, MultiscaleOptions, NearestOptions, Parameter, PartlyGiven, TwoViewOptions};
use serde::{Deserialize, Serialize};

options! {
    /// Which pairs of a block are tried, and what connects them.
    pub struct PairChoice in "pairs" {
        section "Pairs";

        /// Which pairs are tried: all; images near each other by their positions; images that follow each other by name; images that look
        /// alike.
        rule: Option<PairRule> = None, "Pairs",
            absent "all of up to 30 images; of more the near ones where every image has a position, the similar ones otherwise",
            named "pairs";

        /// The number of nearest images with which each image is tried: more connect more and take longer.
        near: usize = 16, "Near images", 1..=1000, acts "pairs.rule is near, absent";

        /// The number of following images with which each image is tried: more connect more and take longer.
        sequence: u32 = 4, "Following images", 1..=1000, acts "pairs.rule is sequence, near, absent";

        /// The number of most similar images with which each image is tried: more connect more and take longer.
        alike: usize = 12, "Similar images", 1..=1000, acts "pairs.rule is alike, absent";

        /// The minimum number of matches of one geometry that connect a pair: more leave fewer, more certain connections.
        least_matches: u32 = 16, "Minimum matches", 8..=10000;
    }
}

/// All pairs of up to so many images are tried where no rule is given.
const FEW_IMAGES: usize = 30;

impl PairChoice {
    /// Whether the rule that holds for so many images may be that of likeness, whatever is found in them.
    pub(crate) fn may_ask_for_likeness(&self, images: usize) -> bool {
        self.rule.map_or(images > FEW_IMAGES, |rule| rule == PairRule::Alike)
    }

    /// The rule that holds for images of which these have a position.
    pub fn rule_of(&self, positions: &[Option<[f64; 3]>]) -> PairRule {
        let whole = positions.iter().all(Option::is_some);
        self.rule.unwrap_or(match positions.len() {
            0..=FEW_IMAGES => PairRule::All,
            _ if whole => PairRule::Near,
            _ => PairRule::Alike,
        })
    }
}

/// The pairs that are tried by the rule of [`PairChoice::rule_of`], each once. Near images are those with a position, in m as
/// [`near_pairs`] takes them; an image without one is tried with those before and after it.
///
/// `similar`: for each image the images found similar to it, as [`alike_pairs`] takes them; of use only for the rule `alike`.
///
/// # Errors
/// [`Error::InvalidOption`]; those of [`near_pairs`] and [`alike_pairs`].
pub fn choose_pairs(positions: &[Option<[f64; 3]>], similar: &[Vec<(u32, f32)>], choice: &PairChoice) -> Result<Vec<ChosenPair>, Error> {
    choice.check_ranges()?;
    let images = positions.len() as u32;
    match choice.rule_of(positions) {
        PairRule::All => Ok(all_pairs(images)),
        PairRule::Sequence => Ok(sequence_pairs(images, choice.sequence)),
        PairRule::Alike => alike_pairs(similar, choice.alike),
        PairRule::Near => {
            let near = near_pairs(positions, choice.near)?;
            let lost = |pair: &ChosenPair| pair.images.iter().any(|image| positions[*image as usize].is_none());
            let following = sequence_pairs(images, choice.sequence).into_iter().filter(lost).collect();
            Ok(merge_pairs(&[near, following]))
        }
    }
}

/// What observations of an image share, in their standard errors: fitted on rendered blocks. Refined ones have half of the standard error there, and share a larger
/// part of it: walls and slopes stay in the windows.
const SHARED_BY_FEATURES: f64 = 0.25;
const SHARED_BY_REFINED: f64 = 0.3;

/// Options of a block from its images to its tie points.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct BlockSettings {
    pub features: FeatureOptions,
    pub pairs: PairChoice,
    pub nearest: NearestOptions,
    /// Its cameras are those of the block.
    pub geometry: TwoViewOptions,
    pub placing: GeoreferencingOptions,
    pub block: BlockOptions,
    pub selection: SelectOptions,
    pub refinement: RefinementOptions,
}

impl Default for BlockSettings {
    fn default() -> Self {
        // The few points that are kept of an image are found among these; a pair of images is matched in the square of their number.
        let multiscale = MultiscaleOptions { number: 4000, ..MultiscaleOptions::default() };
        Self {
            features: FeatureOptions { multiscale, ..FeatureOptions::default() },
            pairs: PairChoice::default(),
            nearest: NearestOptions::default(),
            geometry: TwoViewOptions::default(),
            placing: GeoreferencingOptions::default(),
            block: BlockOptions::default(),
            selection: SelectOptions::default(),
            refinement: RefinementOptions::default(),
        }
    }
}

impl PartlyGiven for BlockSettings {
    const GROUPS: &'static [Group] = &[
        Group { path: "pairs", parameters: PairChoice::PARAMETERS },
        Group { path: "features.multiscale", parameters: MultiscaleOptions::PARAMETERS },
        Group { path: "features.gradient", parameters: GradientOptions::PARAMETERS },
        Group { path: "nearest", parameters: NearestOptions::PARAMETERS },
        Group { path: "geometry", parameters: TwoViewOptions::PARAMETERS },
        Group { path: "block", parameters: BlockOptions::PARAMETERS },
        Group { path: "selection", parameters: SelectOptions::PARAMETERS },
        Group { path: "refinement", parameters: RefinementOptions::PARAMETERS },
        Group { path: "placing", parameters: GeoreferencingOptions::PARAMETERS },
    ];
}

impl BlockSettings {
    /// The standard deviation of errors that the observations of an image share, in standard errors of an observation.
    #[must_use]
    pub fn shared_errors(&self) -> f64 {
        let usual = if self.refinement.method == RefinementMethod::None { SHARED_BY_FEATURES } else { SHARED_BY_REFINED };
        self.placing.shared_errors.unwrap_or(usual)
    }

    /// All parameters, in the order of the pipeline.
    pub fn parameters() -> impl Iterator<Item = &'static Parameter> {
        Self::GROUPS.iter().flat_map(|group| group.parameters)
    }

    /// Rejects values outside their ranges, and a coordinate system that cannot be read.
    ///
    /// # Errors
    /// [`Error::InvalidOption`]; [`Error::InvalidInput`] for the coordinate system.
    pub fn check(&self) -> Result<(), Error> {
        self.features.multiscale.check_ranges()?;
        self.features.gradient.check_ranges()?;
        self.nearest.check_ranges()?;
        self.geometry.check()?;
        self.pairs.check_ranges()?;
        self.placing.check()?;
        self.block.check_ranges()?;
        self.selection.check_ranges()?;
        self.refinement.check_ranges()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rule_follows_from_the_images_unless_it_is_given() {
        let choice = PairChoice::default();
        assert_eq!(choice.rule_of(&[None; 30]), PairRule::All);
        assert_eq!(choice.rule_of(&[None; 31]), PairRule::Alike);
        let mut known = vec![Some([0.0; 3]); 31];
        assert_eq!(choice.rule_of(&known), PairRule::Near);
        known[7] = None;
        assert_eq!(choice.rule_of(&known), PairRule::Alike);
        assert_eq!(PairChoice { rule: Some(PairRule::Near), ..choice }.rule_of(&known), PairRule::Near);
    }

    #[test]
    fn what_observations_share_follows_from_their_refinement_unless_it_is_given() {
        let mut settings = BlockSettings::default();
        assert_eq!(settings.shared_errors(), SHARED_BY_REFINED);
        settings.refinement.method = RefinementMethod::None;
        assert_eq!(settings.shared_errors(), SHARED_BY_FEATURES);
        settings.placing.shared_errors = Some(0.0);
        assert_eq!(settings.shared_errors(), 0.0);
    }

    #[test]
    fn an_image_without_position_is_tried_with_its_neighbours_in_sequence() {
        let positions: Vec<Option<[f64; 3]>> = (0..6).map(|i| (i != 3).then(|| [f64::from(i * i), 0.0, 0.0])).collect();
        let choice = PairChoice { rule: Some(PairRule::Near), near: 1, sequence: 1, ..PairChoice::default() };
        let pairs = choose_pairs(&positions, &[], &choice).unwrap();
        let list: Vec<([u32; 2], PairRule)> = pairs.iter().map(|pair| (pair.images, pair.rule)).collect();
        let (near, following) = (PairRule::Near, PairRule::Sequence);
        assert_eq!(list, [([0, 1], near), ([1, 2], near), ([2, 3], following), ([3, 4], following), ([4, 5], near)]);
    }

    #[test]
    fn settings_outside_their_ranges_are_rejected() {
        BlockSettings::default().check().unwrap();
        let wrong = BlockSettings { pairs: PairChoice { least_matches: 0, ..PairChoice::default() }, ..BlockSettings::default() };
        assert!(matches!(wrong.check(), Err(Error::InvalidOption { field: "pairs.least_matches", .. })));
    }
}
