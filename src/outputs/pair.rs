//! A pair that was matched and oriented, with all that was given for it: the smallest project.

use crate::catalogue::read_options;
use crate::error::refuse;
use crate::{Error, ExifCamera, FiveParameters, Input, MatchScore, MatchSet, PairEdit, PairInput, PairResult, PairSettings, Refusal, Rule};
use serde::{Deserialize, Serialize};

/// A pair from its photos to its orientation: all that is written and shown of it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PairRun {
    /// The left and the right one.
    pub images: [PairPhoto; 2],
    #[serde(deserialize_with = "read_options")]
    pub input: PairInput,
    #[serde(deserialize_with = "read_options")]
    pub settings: PairSettings,
    /// Of its geometry the inliers are left out, since all matches agree with it.
    pub result: PairResult,
    /// Of a simulated pair.
    pub truth: Option<PairTruth>,
    /// Absent where nothing was changed by hand, and in files of former versions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub edited: Option<PairEdits>,
}

/// Edits of the matches of a pair, and the matches that were found: the result of the pair has the edited ones.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PairEdits {
    /// In their order.
    pub edits: Vec<PairEdit>,
    /// Of the left points before those that were measured by hand, which come last.
    pub found: MatchSet,
}

/// A photo of a pair.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct PairPhoto {
    /// File name.
    pub name: String,
    /// SHA-256 of the file in hexadecimal digits; absent for a photo that was simulated.
    pub content: Option<String>,
    pub width_px: usize,
    pub height_px: usize,
    /// Of its file.
    pub format: String,
    pub bits_per_sample: u8,
    /// File name of its mask.
    pub mask: Option<String>,
    /// The camera that its EXIF data name.
    pub camera: Option<ExifCamera>,
}

/// What is known of a simulated pair.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PairTruth {
    /// by and bz at the scale of `base_mm`.
    pub orientation: FiveParameters,
    pub base_mm: f64,
    /// Of the matches, one by one.
    pub score: MatchScore,
}

impl PairRun {
    /// Puts together what belongs to a pair.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for parts that do not fit together.
    pub fn new(
        images: [PairPhoto; 2],
        (input, settings): (PairInput, PairSettings),
        result: PairResult,
        truth: Option<PairTruth>,
    ) -> Result<Self, Error> {
        Self { images, input, settings, result, truth, edited: None }.in_order()
    }

    /// The pair with what was changed by hand.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for edits and matches that are not of this pair.
    pub fn edited(self, edited: PairEdits) -> Result<Self, Error> {
        Self { edited: Some(edited), ..self }.in_order()
    }

    /// Brings it into the one form in which it is kept, or refuses parts that do not fit together.
    pub(super) fn in_order(mut self) -> Result<Self, Error> {
        self.check()?;
        self.edited = self.edited.filter(|edited| !edited.edits.is_empty());
        let PairResult { matching, geometry, .. } = &mut self.result;
        if let Some(Ok(geometry)) = geometry {
            geometry.inliers.clear();
        }
        for matching in [Some(matching), self.edited.as_mut().map(|edited| &mut edited.found)].into_iter().flatten() {
            // What least squares matching found is part of the matches; points that it rejected have none.
            matching.verdicts.iter_mut().for_each(|verdict| verdict.fit = None);
            for found in &matching.matches {
                matching.verdicts[found.left].fit = found.fit;
            }
        }
        Ok(self)
    }

    fn check(&self) -> Result<(), Error> {
        let PairResult { left, right, offset, matching, orientation, .. } = &self.result;
        let (points, others, matches) = (left.points.len(), right.points.len(), matching.matches.len());
        let counted = |input, got: usize, wanted: usize| match got == wanted {
            true => Ok(()),
            false => refuse(Refusal::Count { input, got, wanted }),
        };
        counted(Input::VerdictsOfPair, matching.verdicts.len(), points)?;
        check_matches(matching, others)?;
        for set in [left, right].into_iter().filter(|set| !set.frames.is_empty()) {
            counted(Input::FramesOfPair, set.frames.len(), set.points.len())?;
        }
        offset.as_ref().map_or(Ok(()), |offset| offset.check())?;
        if let Ok(oriented) = orientation {
            counted(Input::ObservationsOfPair, oriented.points.len(), matches)?;
            counted(Input::ResidualsOfPair, oriented.residuals_mm.len(), matches)?;
            if let Some(&index) = oriented.rejected.iter().find(|index| **index >= matches) {
                return refuse(Refusal::PairRejected { index, matches });
            }
        }
        if let Some(truth) = &self.truth {
            counted(Input::ScoresOfPair, truth.score.rightness.len(), matches)?;
        }
        self.edited.as_ref().map_or(Ok(()), |edited| edited.check(points, others))
    }
}

impl PairEdits {
    /// `points` and `others`: so many points has the pair on the left, with those measured by hand, and on the right.
    fn check(&self, points: usize, others: usize) -> Result<(), Error> {
        let found = self.found.verdicts.len();
        if found > points {
            return refuse(Refusal::PairFound { found, points });
        }
        check_matches(&self.found, others)?;
        match self.edits.iter().flat_map(PairEdit::places).flatten().find(|coordinate| !coordinate.is_finite()) {
            Some(got) => refuse(Refusal::PairPlace { got }),
            None => Ok(()),
        }
    }
}

/// Refuses matches whose points are not there; the right image has `others`, the left one as many as there are verdicts.
fn check_matches(matching: &MatchSet, others: usize) -> Result<(), Error> {
    let (points, matches) = (matching.verdicts.len(), matching.matches.len());
    let matched = matching.verdicts.iter().filter(|verdict| verdict.rule == Rule::Matched).count();
    if matched != matches {
        return refuse(Refusal::Count { input: Input::MatchedOfPair, got: matched, wanted: matches });
    }
    let beyond = |left: usize, right: Option<usize>| left >= points || right.is_some_and(|right| right >= others);
    let indices = matching.matches.iter().map(|found| (found.left, found.right));
    let best = matching.verdicts.iter().filter_map(|verdict| verdict.best).map(|right| (0, Some(right)));
    match indices.chain(best).find(|(left, right)| beyond(*left, *right)) {
        Some((left, right)) => refuse(Refusal::PairMatch { left, right, points, others }),
        None => Ok(()),
    }
}
