//! The rules that look at several matches at once, and what is left after them.

use super::parallax::refuse_by_parallax;
use super::{Match, MatchCounts, MatchOptions, MatchSet, OffsetField, Rule, Verdict};
use crate::InterestPoint;
use std::collections::HashMap;

/// Applies the rules that compare matches with each other to the best candidate of each left point.
pub(super) fn judge(left: &[InterestPoint], mut verdicts: Vec<Verdict>, offset: &OffsetField, options: &MatchOptions) -> MatchSet {
    refuse_many_to_one(&mut verdicts);
    refuse_by_parallax(left, offset, &mut verdicts, options);
    set_of(left, verdicts)
}

/// The matches and counts of verdicts.
pub(super) fn set_of(left: &[InterestPoint], verdicts: Vec<Verdict>) -> MatchSet {
    let matches = (verdicts.iter().enumerate()).filter_map(|(k, v)| {
        let left_px = [left[k].x, left[k].y];
        v.matched().map(|right_px| Match { left: k, right: v.best, left_px, right_px, measure: v.measure, fit: v.fit })
    });
    MatchSet { matches: matches.collect(), counts: count(&verdicts), verdicts }
}

/// Of the left points that won the same right point, or the same pixel, only the best keeps it; of equal ones the first.
pub(super) fn refuse_many_to_one(verdicts: &mut [Verdict]) {
    let mut keepers: HashMap<(i64, i64), usize> = HashMap::new();
    for left in 0..verdicts.len() {
        let Some([x, y]) = verdicts[left].matched() else { continue };
        // A right point is told by its index: two of them may lie in one pixel.
        let target = verdicts[left].best.map_or((x.floor() as i64, y.floor() as i64), |index| (index as i64, i64::MIN));
        let loser = match keepers.get(&target) {
            Some(first) if verdicts[*first].measure <= verdicts[left].measure => Some(left),
            _ => keepers.insert(target, left),
        };
        if let Some(loser) = loser {
            verdicts[loser].rule = Rule::ManyToOne;
        }
    }
}

fn count(verdicts: &[Verdict]) -> MatchCounts {
    let of = |rule| verdicts.iter().filter(|v| v.rule == rule).count();
    MatchCounts {
        matches: of(Rule::Matched),
        no_descriptor: of(Rule::NoDescriptor),
        no_candidate: of(Rule::NoCandidate),
        threshold: of(Rule::Threshold),
        ambiguous: of(Rule::Ambiguous),
        many_to_one: of(Rule::ManyToOne),
        parallax: of(Rule::Parallax),
        border: of(Rule::Border),
        left_right: of(Rule::LeftRight),
        not_converged: of(Rule::NotConverged),
        imprecise: of(Rule::Imprecise),
        frame: of(Rule::Frame),
    }
}
