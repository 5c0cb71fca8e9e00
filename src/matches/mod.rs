//! From described points to matches: expected offset, search window, dissimilarity, rules of consistency.

mod correlation;
mod index;
mod neighbours;
mod offset;
mod options;
mod parallax;
mod search;

pub use offset::{OffsetField, estimate_offset, estimate_offset_of_reduced};
pub use options::{Denominator, MatchOptions};
pub use search::{Candidate, Described, candidates_of, match_points};

use serde::{Deserialize, Serialize};

/// The rule that decided on a left point.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Rule {
    /// Matched: no rule refused it.
    Matched,
    /// Its window leaves the image or is constant: it has no descriptor.
    NoDescriptor,
    /// No right point with a descriptor lies in its search window.
    NoCandidate,
    /// The best measure is not below the largest one allowed.
    Threshold,
    /// The second best candidate is too nearly as good as the best.
    Ambiguous,
    /// Another left point matches the same right point better.
    ManyToOne,
    /// Its y-parallax deviates from that of the nearest matches.
    Parallax,
}

/// What became of a left point, and why.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Verdict {
    pub rule: Rule,
    /// Index of the best right point; absent where there was no candidate.
    pub best: Option<usize>,
    /// The best measure; infinite where there was no candidate.
    pub measure: f64,
    /// The second best measure; infinite where there was no second candidate.
    pub second: f64,
}

/// A pair of points that passed all rules.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Match {
    /// Index of the left point.
    pub left: usize,
    /// Index of the right point.
    pub right: usize,
    pub measure: f64,
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
}

/// The outcome of matching two sets of points.
#[derive(Debug, Clone, PartialEq)]
pub struct MatchSet {
    /// In the order of the left points.
    pub matches: Vec<Match>,
    /// One for each left point.
    pub verdicts: Vec<Verdict>,
    pub counts: MatchCounts,
}
