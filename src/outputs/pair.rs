//! A pair that was matched and oriented, with all that was given for it: the smallest project.

use crate::catalogue::read_options;
use crate::error::refuse;
use crate::{Error, ExifCamera, FiveParameters, Input, MatchScore, PairInput, PairResult, PairSettings, Refusal, Rule};
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
        Self { images, input, settings, result, truth }.in_order()
    }

    /// Brings it into the one form in which it is kept, or refuses parts that do not fit together.
    pub(super) fn in_order(mut self) -> Result<Self, Error> {
        self.check()?;
        let PairResult { matching, geometry, .. } = &mut self.result;
        if let Some(Ok(geometry)) = geometry {
            geometry.inliers.clear();
        }
        // What least squares matching found is part of the matches; points that it rejected have none.
        matching.verdicts.iter_mut().for_each(|verdict| verdict.fit = None);
        for found in &matching.matches {
            matching.verdicts[found.left].fit = found.fit;
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
        counted(Input::MatchedOfPair, matching.verdicts.iter().filter(|v| v.rule == Rule::Matched).count(), matches)?;
        for set in [left, right].into_iter().filter(|set| !set.frames.is_empty()) {
            counted(Input::FramesOfPair, set.frames.len(), set.points.len())?;
        }
        let beyond = |left: usize, right: Option<usize>| left >= points || right.is_some_and(|right| right >= others);
        let indices = matching.matches.iter().map(|found| (found.left, found.right));
        let best = matching.verdicts.iter().map(|verdict| (0, verdict.best));
        if let Some((left, right)) = indices.chain(best).find(|(left, right)| beyond(*left, *right)) {
            return refuse(Refusal::PairMatch { left, right, points, others });
        }
        offset.as_ref().map_or(Ok(()), |offset| offset.check())?;
        if let Ok(oriented) = orientation {
            counted(Input::ObservationsOfPair, oriented.points.len(), matches)?;
            counted(Input::ResidualsOfPair, oriented.residuals_mm.len(), matches)?;
            if let Some(&index) = oriented.rejected.iter().find(|index| **index >= matches) {
                return refuse(Refusal::PairRejected { index, matches });
            }
        }
        self.truth.as_ref().map_or(Ok(()), |truth| counted(Input::ScoresOfPair, truth.score.rightness.len(), matches))
    }
}
