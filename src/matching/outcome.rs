//! What becomes of points when two images are matched: the verdict on each, and the matches that stand.

use crate::message::messages;
use serde::{Deserialize, Serialize};

messages! {
    /// The rule that decided on a left point.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(rename_all = "snake_case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum Rule as "verdict" {
        /// Matched: no rule rejects it.
        Matched,
        /// Its window leaves the image or is constant: it has no descriptor.
        NoDescriptor,
        /// No right point with a descriptor lies in its search window, or that window leaves the right image.
        NoCandidate,
        /// The best measure is not below the largest one allowed, or the correlation not above the least one.
        Threshold,
        /// The second best candidate is too nearly as good as the best.
        Ambiguous,
        /// Another left point matches the same right point better.
        ManyToOne,
        /// Its y-parallax deviates from that of the nearest matches, or from its epipolar line; or it fits no geometry of the two views.
        Parallax,
        /// The best correlation lies on the border of the search window: the true one may lie beyond it.
        Border,
        /// The right window correlates better with another place in the left image, or the right descriptor is nearer to another left one.
        LeftRight,
        /// Least squares matching does not converge, or leaves the place from where it started; or it does not confirm a match, and confirmed ones around it lead
        /// elsewhere.
        NotConverged,
        /// The standard error of the right position exceeds the largest one allowed.
        Imprecise,
        /// It lies at the same place of both frames, as the film's border and its marks do.
        Frame,
    }
}

impl Rule {
    /// All rules; the place of a rule here is its code.
    pub const ALL: [Self; 12] = [
        Self::Matched,
        Self::NoDescriptor,
        Self::NoCandidate,
        Self::Threshold,
        Self::Ambiguous,
        Self::ManyToOne,
        Self::Parallax,
        Self::Border,
        Self::LeftRight,
        Self::NotConverged,
        Self::Imprecise,
        Self::Frame,
    ];
}

/// What became of a left point, and why.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Verdict {
    pub rule: Rule,
    /// Index of the best right point; absent where there was no candidate, or where the place found is no interest point.
    pub best: Option<usize>,
    /// The best place in the right image in px; absent where there was none.
    pub position: Option<[f64; 2]>,
    /// The best measure: a dissimilarity of moments, 1 minus the correlation coefficient, or a distance of gradient descriptors. Infinite where there was no candidate.
    #[serde(with = "crate::json::infinite")]
    pub measure: f64,
    /// The second best measure; infinite where there was no second candidate.
    #[serde(with = "crate::json::infinite")]
    pub second: f64,
    /// What least squares matching found; absent where none took place. A file holds it once, in the [`Match`].
    #[serde(skip)]
    pub fit: Option<Fit>,
}

impl Verdict {
    /// The verdict on a point before anything is known of it.
    pub(crate) fn none(rule: Rule) -> Self {
        Self { rule, best: None, position: None, measure: f64::INFINITY, second: f64::INFINITY, fit: None }
    }

    /// The right position of a verdict that stands.
    pub(super) fn matched(&self) -> Option<[f64; 2]> {
        self.position.filter(|_| self.rule == Rule::Matched)
    }
}

/// The precision of a least squares match.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Fit {
    /// Correlation coefficient of the two windows after the fit, -1..1.
    pub correlation: f64,
    /// Covariance `[xx, xy, yy]` of the right position in px².
    pub covariance: [f64; 3],
    pub iterations: usize,
}

impl Fit {
    /// The standard error in the worst direction, in px.
    pub fn standard_error_px(&self) -> f64 {
        let [xx, xy, yy] = self.covariance;
        (0.5 * (xx + yy) + (0.25 * (xx - yy) * (xx - yy) + xy * xy).sqrt()).sqrt()
    }
}

/// A pair of places that passed all rules.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Match {
    /// Index of the left point.
    pub left: usize,
    /// Index of the right point; absent where the place found is no interest point.
    pub right: Option<usize>,
    pub left_px: [f64; 2],
    pub right_px: [f64; 2],
    pub measure: f64,
    pub fit: Option<Fit>,
}

/// How many left points each rule refused.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct MatchCounts {
    pub matches: usize,
    pub no_descriptor: usize,
    pub no_candidate: usize,
    pub threshold: usize,
    pub ambiguous: usize,
    pub many_to_one: usize,
    pub parallax: usize,
    pub border: usize,
    pub left_right: usize,
    pub not_converged: usize,
    pub imprecise: usize,
    pub frame: usize,
}

/// The outcome of matching two sets of points.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MatchSet {
    /// In the order of the left points.
    pub matches: Vec<Match>,
    /// One for each left point.
    pub verdicts: Vec<Verdict>,
    pub counts: MatchCounts,
}
